"""Boxes of states followed from collision to collision, many at once.

Where a box leaves open whether two spheres meet or miss each other, both is followed: the box is
split into branches, and what all of them say is true of all its states. A state in which they just
graze is in both, so it gets the verdict that it has under either convention.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import reduce
from operator import or_
from typing import Any

import numpy as np

from verify.language.record import Record
from verify.spheres.flow.law import Flight, Pair, State, collided, flight, inner, outer, recentred
from verify.spheres.map.intervals import Array, Intervals, down
from verify.spheres.map.trees import chosen_of

#: One number of many boxes of states: `Intervals`, `Models`, or `BallModels`.
Boxes = Any
#: States, and the places of the boxes that they come from.
Places = tuple[Array, State]


class Look(Record):
    """Whether a pair meets in free flight, left alone: shown for never, for always."""

    never: Array
    always: Array


class Step(Record):
    """What comes next for each box: the states after a collision, with the boxes they come from.

    `ends` says that some states of the box may have no further collision, `unclear` that it is
    not known which collision is the next one.
    """

    states: list[Places]
    ends: Array
    unclear: Array


def look(lam: Boxes, A: Boxes, eps: Boxes) -> Look:
    """A pair that closes in at x·W = -lam v from |x|² = 1 + eps v², where A = |W|²."""
    reach = lam.above(0.0) ** 2 - A * eps
    return Look((lam.high <= 0) | (reach.high < 0), (lam.low > 0) & (reach.low > 0))


def some_of(r: Boxes, chosen: Array) -> Boxes:
    """The r of some boxes, or the one that all have."""
    return r if np.ndim(r.low) == 0 or len(r.low) == 1 else r[chosen]


def take(state: State, chosen: Array) -> State:
    """Some of the states."""
    if chosen.dtype == bool and chosen.all():
        return state
    return State(*(x if isinstance(x, int) else x[chosen] for x in state))


def is_empty(state: State) -> Array:
    """Whether no state is left: bounds that contradict each other."""
    return reduce(or_, (x.low > x.high for x in state if not isinstance(x, int)))


def together(parts: Sequence[State]) -> State:
    """All states in one; they have the spectator in contact."""
    columns = zip(*parts, strict=True)
    return State(*(0 if isinstance(c[0], int) else type(c[0]).joined(c) for c in columns))


def meeting_part(state: State) -> tuple[State, Flight]:
    """What is known of those states from which o and c meet, and their flight.

    Where they meet, lam² >= A eps and the root is in [0, 1].
    """
    least = down(np.sqrt(down(state.A.low * state.eps.low)))
    met = state._replace(lam=state.lam.above(least))
    return met, flight(met, lambda x: x.root_of_share())


def apart(pair: Pair, time: Boxes) -> Array:
    """Whether a pair is shown to be apart until that time: Bernstein's coefficients."""
    g, p, m = pair
    step = p * time
    last = g + time * (2 * p + m * time)
    return (g.low >= 0) & ((g + step).low >= 0) & (last.low > 0)


def seen_from_s(state: State) -> State:
    """The same moment with s as the central sphere."""
    other = recentred(state)
    return other._replace(v=other.lam.like(1))


def _own(state: State) -> tuple[Look, Boxes, Flight, Array, Array]:
    """Whether o and c meet, left alone, and how.

    There are the lam of the states that do, their flight, whether bounds alone tell that it is the
    first one, and whether little is known of the state.
    """
    own = look(state.lam, state.A, state.eps)
    met, way = meeting_part(state)
    little = _sticks(state) | ~(state.lam.low <= state.lam.high)
    return own, met.lam, way, own.always & _is_first(state, way), little


def _far(state: State, y: Boxes, T: Boxes) -> tuple[Look, Array]:
    """Whether s and c meet, left alone; and whether that is not before o and c do so."""
    pair = outer(state)
    seen = look(-pair.p, pair.m, pair.g)
    return seen, seen.never | apart(pair, y * T)


def _near(state: State, never: Array) -> tuple[State, Flight, Array]:
    """States from which s and c meet, seen from s, and how; whether o and c do not meet before."""
    met, way = meeting_part(seen_from_s(state))
    return met, way, never | apart(inner(state)[0], way.y * way.T)


def _after(r: Boxes, met: State, way: Flight) -> tuple[State, Array]:
    """The states after o and c have met, where there are some."""
    after = collided(r, met, way)
    return after, ~is_empty(after)


def _next(r: Boxes, met: State, way: Flight, chosen: Array, places: Array) -> list[Places]:
    """The states after o and c have met at chosen places, if there are some, and where they are."""
    if len(chosen) == 0:
        return []
    after, some = _after(*chosen_of((r, met, way), chosen))
    return [(places[chosen[some]], take(after, some))]


def advance(r: Boxes, state: State) -> Step:
    """The next collision of each box, in each of its branches.

    The spectator s, which is in contact with o, does not approach: rho >= 0, B >= 0.
    """
    own, lam, way, first, little = _own(state)
    # Of the others more has to be known; `far` is the pair s, c.
    rest = np.flatnonzero(~first)
    far = Look(np.zeros_like(first), np.zeros_like(first))
    if len(rest):
        seen, first[rest] = _far(*chosen_of((state, way.y, way.T), rest))
        far.never[rest], far.always[rest] = seen
    meets, known = ~own.never & first, first.copy()
    other = np.flatnonzero(~far.never & ~(first & own.always))
    states: list[Places] = []
    if len(other):
        # In the order of `other`: how s and c meet, and whether they are the first to do so.
        near, near_way, far_first = _near(*chosen_of((state, own.never), other))
        known[other] |= far_first
        meets[other] |= ~own.never[other] & far_first & ~far.always[other]
        goes = np.flatnonzero(far_first | first[other])
        states = _next(some_of(r, other), near, near_way, goes, other)
    met = state._replace(lam=lam)
    states = _next(r, met, way, np.flatnonzero(meets), np.arange(len(first))) + states
    ends = ~own.always & ~far.always
    known |= own.never & far.never
    return Step(states, ends, ~known | little)


def _is_first(state: State, way: Flight) -> Array:
    """Whether bounds alone tell of models that o and c are the first to meet, if they do."""
    if isinstance(state.lam, Intervals):
        return np.zeros_like(state.lam.low, bool)
    pair = outer(State(*(x if isinstance(x, int) else x.hull for x in state)))
    time = way.y.hull * way.T.hull
    return look(-pair.p, pair.m, pair.g).never | apart(pair, time)


def _sticks(state: State) -> Array:
    """Whether the spectator may stay in contact: a row of the flow says that it does not."""
    return ~((state.rho.low > 0) | (state.B.low > 0))


def _first_of_three(
    views: Sequence[State], pairs: Sequence[Pair]
) -> tuple[tuple[tuple[Array, Boxes, Flight], ...], Array, Array]:
    """Which pairs may meet first, with lam and flight of the states where they do.

    Besides, as in a step, whether some states end, and what is unclear.
    """
    looks = [look(-pair.p, pair.m, pair.g) for pair in pairs]
    met = [meeting_part(view) for view in views]
    times = [way.y * way.T for _, way in met]
    later = [
        [looks[j].never | apart(pairs[j], time) if i != j else looks[j].never for j in range(3)]
        for i, time in enumerate(times)
    ]
    unclear = np.zeros_like(looks[0].never)
    for i, j in ((0, 1), (0, 2), (1, 2)):
        unclear |= ~(later[i][j] | later[j][i] | looks[i].never)
    found = []
    for i, (view, way) in enumerate(met):
        may = ~looks[i].never
        for j in range(3):
            if i != j:
                may &= ~(later[j][i] & ~later[i][j] & looks[j].always)
        found.append((may, view.lam, way))
    ends = ~(looks[0].always | looks[1].always | looks[2].always)
    apart_now = [pair.g.low > 0 for pair in pairs]
    for pair, is_apart in zip(pairs, apart_now, strict=True):
        unclear |= ~(is_apart | ((pair.g.low >= 0) & (pair.m.low > 0)))
    for i, j in ((0, 1), (0, 2), (1, 2)):
        unclear |= ~(apart_now[i] | apart_now[j])
    return tuple(found), ends, unclear


def begin(r: Boxes, views: Sequence[State], pairs: Sequence[Pair]) -> Step:
    """The first collision of scenes: their three pairs, each with the view of its own.

    Of two pairs that may both meet one has to be shown to be apart until the other has met. Then
    a pair may be the first one unless another one, which always meets, comes before. One pair may
    be in contact if it does not stay so.
    """
    found, ends, unclear = _first_of_three(tuple(views), tuple(pairs))
    states: list[Places] = []
    for view, (may, lam, way) in zip(views, found, strict=True):
        met = view._replace(lam=lam)
        states += _next(r, met, way, np.flatnonzero(may), np.arange(len(ends)))
    return Step(states, ends, unclear)
