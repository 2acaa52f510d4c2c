"""The verdicts on boxes of a plane of scenes, many at once; each depends on its box alone."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import partial
from itertools import combinations
from typing import Any

import numpy as np

from verify.language.record import Record
from verify.spheres.flow.law import Pair, State
from verify.spheres.map.branches import Step, advance, begin, some_of, take, together
from verify.spheres.map.closing import collapsing, collapsing_on_a_line
from verify.spheres.map.intervals import Array, Intervals, all_enclosed, enclosed, exactly
from verify.spheres.map.models import Models, from_bounds, one_model, parameter
from verify.spheres.map.planes import (
    FamilyPlane,
    Phi,
    Plane,
    Scenes,
    is_on_a_line,
    start,
    value_of,
    views,
)
from verify.spheres.map.strip import BorderStrip, height
from verify.spheres.scene.criteria import comes_to_rest, inelastic

COLLAPSES, DISPERSES, FINITE, UNDECIDED = "c", "d", "f", "u"
#: How far boxes are followed, and how often one is split where spheres may graze.
MAX_COLLISIONS, MAX_BRANCHES = 60, 24
#: How far Taylor models of a family are followed: r may be near where collapses begin.
FAMILY_COLLISIONS = 400


#: Instead of the interval of a parameter that does not occur.
NOTHING = (Fraction(0), Fraction(0))


class Verdicts(Record):
    """One letter a box, and for each box the numbers of the branches that collapse.

    ``late`` are the places of boxes that the checker may not confirm: those with more collisions
    than it surely follows, or with an angular momentum that is nearly 0.
    """

    letters: str
    numbers: list[list[tuple[int, ...]]]
    late: Sequence[int] = ()


def corners(keys: Sequence[str]) -> tuple[Array, Array]:
    """The columns and rows of boxes of one level: a quadkey has one digit a level, x + 2y."""
    level = len(keys[0])
    digits = np.frombuffer("".join(keys).encode(), np.uint8).reshape(len(keys), level)
    places = 1 << np.arange(level, dtype=np.int64)[::-1]
    return (digits & 1) @ places, (digits >> 1 & 1) @ places


def side(ends: tuple[Fraction, Fraction], places: Sequence[int], level: int) -> Intervals:
    """The part of a side at each place, 2^level parts in all; neighbours overlap."""
    (p, q), (m, n) = (end.as_integer_ratio() for end in ends)
    first, step = p * n << level, m * q - p * n
    grid, at = np.unique(places, return_inverse=True)
    lows, highs = (
        all_enclosed([first + step * (i + k) for i in grid.tolist()], q * n << level)
        for k in (0, 1)
    )
    return Intervals(lows.low[at], highs.high[at])


def sides(plane: Plane, keys: Sequence[str]) -> tuple[Intervals, Intervals]:
    """The boxes of one level."""
    columns, rows = corners(keys)
    level = len(keys[0])
    return side(plane.x, columns, level), side(plane.y or NOTHING, rows, level)


class BoxNumbers(Record):
    """A kind of numbers for boxes.

    They are made of intervals that one of the two parameters runs over, or of which nothing else is
    known, and of a constant.
    """

    parameter: Callable[[int, Intervals], Any]
    flat: Callable[[Intervals], Any]
    number: Callable[[Fraction], Any]
    spread: Callable[[Any, int], Any]


def _spread(x: Intervals, size: int) -> Intervals:
    return Intervals(np.broadcast_to(x.low, size), np.broadcast_to(x.high, size))


def _spread_model(x: Models, size: int) -> Models:
    c, e = np.broadcast_to(x.c, (6, size)), np.broadcast_to(x.e, size)
    return Models(c, e, _spread(x.bounds, size))


INTERVALS = BoxNumbers(lambda _, x: x, lambda x: x, enclosed, _spread)
MODELS = BoxNumbers(parameter, from_bounds, lambda value: one_model(enclosed(value)), _spread_model)
#: Branches that are shown to collapse, of states with their boxes, and the numbers of each.
Closing = Callable[[State, Array], tuple[Array, Array]]


class _Boxes:
    """What is known of each box: whether some branch collapses, disperses, or is unclear."""

    def __init__(self, size: int) -> None:
        self.collapse, self.disperse, self.unclear = (np.zeros(size, bool) for _ in range(3))
        self.branches, self.late = np.ones(size, int), np.zeros(size, bool)
        self.numbers: list[list[tuple[int, ...]]] = [[] for _ in range(size)]

    def closed(self, boxes: Array, numbers: Array) -> None:
        """Some branches of these boxes collapse."""
        self.collapse[boxes] = True
        for box, column in zip(boxes.tolist(), numbers.T.astype(int).tolist(), strict=True):
            self.numbers[box].append(tuple(column))

    def open(self) -> Array:
        """Whether a box may still get a verdict."""
        return ~self.unclear & ~(self.collapse & self.disperse)

    def take_step(self, step: Step, owners: Array) -> tuple[Any, Array]:
        """The branches after a collision that still matter, and whose they are."""
        self.disperse[owners[step.ends]] = True
        self.unclear[owners[step.unclear]] = True
        parts, goes = [], self.open()
        for places, after in step.states:
            keep = goes[owners[places]]
            parts.append((owners[places][keep], take(after, keep)))
        if not parts:
            return (), np.zeros(0, int)
        found = np.concatenate([own for own, _ in parts])
        self.branches += np.maximum(np.bincount(found, minlength=len(self.branches)) - 1, 0)
        self.unclear |= self.branches > MAX_BRANCHES
        return together([after for _, after in parts]), found

    def verdicts(self) -> Verdicts:
        """The letters."""
        good = self.open() & (self.collapse | self.disperse)
        names = np.where(good, np.where(self.collapse, COLLAPSES, DISPERSES), UNDECIDED)
        numbers = [n if c == COLLAPSES else [] for n, c in zip(self.numbers, names, strict=True)]
        return Verdicts("".join(names.tolist()), numbers, np.flatnonzero(good & self.late).tolist())


def verdicts(plane: Plane | BorderStrip, keys: Sequence[str]) -> Verdicts:
    """What becomes of all scenes of each box: the boxes are of one level.

    Free scenes are tried in intervals first, and then with Taylor models; of what is left it is
    asked whether r alone leaves finitely many collisions.
    """
    if isinstance(plane, BorderStrip):
        return verdicts_of(MODELS, plane, keys)
    found = verdicts_of(INTERVALS, plane, keys)
    if isinstance(plane, Phi):
        return found
    scenes = plane
    found = _and_more(found, keys, lambda left: verdicts_of(MODELS, scenes, left))
    return _and_more(found, keys, lambda left: finitely_many(scenes, left))


def _and_more(
    found: Verdicts, keys: Sequence[str], more: Callable[[list[str]], Verdicts]
) -> Verdicts:
    """The verdicts, where the boxes that they leave undecided have been tried by another method."""
    left = [i for i, letter in enumerate(found.letters) if letter == UNDECIDED]
    if not left:
        return found
    others = more([keys[i] for i in left])
    letters, numbers = list(found.letters), found.numbers
    late = [*found.late, *(left[i] for i in others.late)]
    for i, letter, sixes in zip(left, others.letters, others.numbers, strict=True):
        letters[i], numbers[i] = letter, sixes
    return Verdicts("".join(letters), numbers, late)


def finitely_many(plane: Scenes, keys: Sequence[str]) -> Verdicts:
    """Whether r > 7 - 4√3, or r > 9 - 4√5 with angular momentum, where no spheres overlap."""
    with np.errstate(all="ignore"):
        x, y = sides(plane, keys)
        r = value_of(plane.r, x, y, enclosed)
        least = exactly(r.low)
        between = (r.low > 0) & (r.high < 1)
        fine = np.broadcast_to(between & (comes_to_rest(least).high < 0), len(keys)).copy()
        late = fine & ~(inelastic(least).high < 0)
        if late.any():
            fine &= ~late | turning(plane, keys)
        for pair in views(plane, x, y, enclosed)[1]:
            fine &= pair.g.low >= 0
    letters = "".join(np.where(fine, FINITE, UNDECIDED).tolist())
    return Verdicts(letters, [[] for _ in keys], np.flatnonzero(fine & late).tolist())


def turning(plane: Scenes, keys: Sequence[str]) -> Array:
    """Whether the angular momentum about the centre of mass is nowhere 0 on a box."""
    x, y = map(MODELS.parameter, (0, 1), sides(plane, keys))
    given = plane.coordinates
    places, (v_0, v_1, v_2) = (
        [[value_of(term, x, y, MODELS.number) for term in row] for row in rows]
        for rows in (given.x, given.v)
    )
    arms = [[a - b for a, b in zip(place, places[0], strict=True)] for place in places[1:]]
    pushes = [
        [a + a - b - c for a, b, c in zip(*three, strict=True)]
        for three in ((v_1, v_2, v_0), (v_2, v_1, v_0))
    ]
    found = np.zeros(len(keys), bool)
    for k, m in combinations(range(len(v_0)), 2):
        one, two = (a[k] * w[m] - a[m] * w[k] for a, w in zip(arms, pushes, strict=True))
        found |= (one + two).low > 0
        found |= (one + two).high < 0
    return found


def verdicts_of(
    kind: BoxNumbers,
    plane: Plane | BorderStrip,
    keys: Sequence[str],
    closing: Closing | None = None,
) -> Verdicts:
    """The verdicts that one kind of numbers shows."""
    with np.errstate(all="ignore"):
        phi: Plane = plane.phi if isinstance(plane, BorderStrip) else plane
        if isinstance(plane, BorderStrip):
            x, y = tiles(kind, plane, keys)
        else:
            x, y = map(kind.parameter, (0, 1), sides(plane, keys))
        if isinstance(phi, Phi):
            state = _whole(kind, start(phi, x, y, kind.number, lambda x: x.root()), len(keys))
            return follow(phi.r, kind, state, np.arange(len(keys)), closing=closing)
        scenes, pairs = views(phi, x, y, kind.number)
        scenes = [_whole(kind, view, len(keys)) for view in scenes]
        pairs = [Pair(*(kind.spread(x, len(keys)) for x in pair)) for pair in pairs]
        boxes, r = _Boxes(len(keys)), value_of(phi.r, x, y, kind.number)
        boxes.unclear |= ~((r.low > 0) & (r.high < 1))
        step, rate = begin(r, scenes, pairs), phi.r if isinstance(phi.r, Fraction) else r
        if is_on_a_line(phi):
            closing = partial(collapsing_on_a_line, rate_in(kind, rate)[1])
        far = kind is MODELS and isinstance(phi, FamilyPlane)
        most = FAMILY_COLLISIONS if far else MAX_COLLISIONS
        first = boxes.take_step(step, np.arange(len(keys)))
        return follow(rate, kind, *first, boxes, closing, most)


def rate_in(kind: BoxNumbers, r: Any) -> tuple[Any, Intervals]:
    """A rational r, or the r of each box, as a number of a kind and as an interval."""
    return (kind.number(r), enclosed(r)) if isinstance(r, Fraction) else (r, r.hull)


def tiles(kind: BoxNumbers, plane: BorderStrip, keys: Sequence[str]) -> tuple[Any, Any]:
    """φ1 and φ2 on the tiles of a strip."""
    columns, rows = corners(keys)
    below = len(keys[0]) - plane.level
    parts, share = 2**plane.level, Fraction(1, 2**below)
    half = (plane.x[1] - plane.x[0]) / parts / 2

    def ends(value: Callable[..., Fraction], *places: Array) -> Intervals:
        """Intervals around a number that depends on these places."""
        each, at = np.unique(np.stack(places), axis=1, return_inverse=True)
        found = [enclosed(value(*column)) for column in each.T.tolist()]
        low, high = (np.array([getattr(x, name) for x in found]) for name in ("low", "high"))
        return Intervals(low[at], high[at])

    def side(value: Callable[..., Fraction], *places: Array) -> Intervals:
        """Its values from one place to the next, in the last of these places."""
        *others, last = places
        return Intervals(ends(value, *places).low, ends(value, *others, last + 1).high)

    bands = plane.bands

    def lift(row: int, part: int) -> Fraction:
        low, high = bands[row]
        return low + (high - low) * part * share

    column, row = columns >> below, rows >> below
    t = kind.parameter(0, side(lambda i: half * (2 * i * share - 1), columns - (column << below)))
    u = kind.parameter(1, side(lift, row, rows - (row << below)))
    f_0, f_1, f_2 = (kind.flat(ends(lambda i, k=k: plane.curve[i][k], column)) for k in range(3))
    delta = kind.flat(ends(lambda i: plane.delta if plane.is_above(i) else -plane.delta, row))
    goal = kind.flat(ends(lambda i: plane.y[1] if plane.is_above(i) else Fraction(0), row))
    middle = kind.flat(ends(lambda i: plane.x[0] + half * (2 * i + 1), column))
    return t + middle, height(f_0 + t * (f_1 + t * f_2), u, delta, goal)


def _may_go_on(r: Intervals, state: State) -> Array:
    """Whether collisions may go on for ever at this angle: then more of them tell nothing new."""
    alpha = (1 + r.high) / 2 * state.C.high
    under = alpha**2 - 4 * r.low
    p = (alpha + np.sqrt(np.maximum(under, 0.0))) / 2
    return (under >= 0) & (p**3 >= r.low)


def _whole(kind: BoxNumbers, state: State, size: int) -> State:
    return State(*(x if isinstance(x, int) else kind.spread(x, size) for x in state))


def follow(
    r: Any,
    kind: BoxNumbers,
    state: State,
    owners: Array,
    boxes: _Boxes | None = None,
    closing: Closing | None = None,
    most: int = MAX_COLLISIONS,
) -> Verdicts:
    """The verdicts on boxes whose branches are in these states; r is a number, or that of each."""
    if boxes is None:
        boxes = _Boxes(len(owners))
        boxes.unclear |= ~((state.eps * state.v**2 + 2 * state.C).low > -1)
    number, interval = rate_in(kind, r)
    for collisions in range(most):
        if not len(owners):
            break
        if closing:
            shown, numbers = closing(state, owners)
        else:
            shown, numbers = collapsing(some_of(interval, owners), state)
        boxes.closed(owners[shown], numbers)
        rest = np.ones(len(owners), bool)
        rest[shown] = False
        if collisions >= MAX_COLLISIONS:
            boxes.late[owners] = True
            boxes.unclear[owners[rest & _may_go_on(some_of(interval, owners), state)]] = True
        rest &= boxes.open()[owners]
        state, owners = take(state, rest), owners[rest]
        if len(owners):
            state, owners = boxes.take_step(advance(some_of(number, owners), state), owners)
    boxes.unclear[owners] = True
    return boxes.verdicts()
