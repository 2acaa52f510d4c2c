"""Numbers with which the sharper theorem shows that all states of a box collapse, for many boxes.

They are searched in floats, which proves nothing. Then its own inequalities are decided in
intervals, over the whole box; a collapse needs six numbers, and the others follow from them.
"""

from __future__ import annotations

from functools import cache

import numpy as np

from verify.language.record import Record
from verify.language.terms import Claim, names_of
from verify.prover.program import Machine, Program
from verify.spheres.flow.collapse import SHARPER
from verify.spheres.flow.law import State
from verify.spheres.map.branches import some_of
from verify.spheres.map.intervals import (
    Array,
    Intervals,
    IntervalsArithmetic,
    exactly,
    square_root,
    up,
)
from verify.spheres.map.trees import chosen_of, repeated
from verify.wire.packaged import packaged_files
from verify.wire.questions import read_questions

#: The numbers of a collapse, and the unit in which they are written as whole numbers.
NUMBERS = ("m", "p", "X", "Y", "k", "V")
UNIT = 2.0**-30
#: The iteration widens by so much what it finds; it ends where less than that is gained.
SLACK, GAIN = 1 + 2.0**-16, 2.0**-16
ROUNDS = 40
#: T, Theta and C_0 are chosen such that these hold: T with equality, Theta as the sum of all turns,
#: C_0 as -cos of the state itself.
CHOSEN = ("r-positive", "time-room", "angle-real")
#: What the rows speak of besides.
OTHERS = ("r", "T", "V_0", "eta_0", "C_0")


#: Two numbers, or two for each box.
Ends = tuple[float | Array, float | Array]


class Approach(Record):
    """Boxes of states just after a collision: -eta_c, the ratio eta_s/(-eta_c), d/eta_c², -cos θ.

    `eta` and `speed` are numbers: -eta_c and the larger speed are no more than these.
    """

    eta: Array
    ratio: Intervals
    slope: Intervals
    C: Intervals
    speed: Array


def as_approach(state: State) -> Approach:
    """The states in the letters of the sharper theorem."""
    reach = (1 + state.eps * state.v**2).root()
    inverse = reach / state.lam
    eta = (state.lam * state.v / reach).high
    larger = np.maximum(state.A.high, state.B.high)
    speed = np.maximum(square_root(exactly(larger)).high, eta)
    slope = state.eps / (1 + reach) * inverse**2
    return Approach(eta, (state.rho * inverse).hull, slope.hull, (state.C / reach).hull, speed)


def collapsing(r: Intervals, state: State) -> tuple[Array, Array]:
    """The boxes that are shown to collapse, and their numbers in units, a column each."""
    nothing = np.zeros(0, int), np.zeros((len(NUMBERS), 0))
    places = np.flatnonzero((state.lam.low > 0) & (state.rho.low > 0) & (state.C.low > 0))
    if len(places) == 0:
        return nothing
    box, known, guess, worth = _begun(*chosen_of((_ends(r), state), places))
    here = np.flatnonzero(worth)
    if len(here) == 0:
        return nothing
    guess, found = repeated(_improved, ROUNDS, *chosen_of((known, guess), here))
    here = here[found]
    if len(here) == 0:
        return nothing
    places = places[here]
    given = chosen_of(r, places), chosen_of(box, here), chosen_of(guess, found)
    numbers, shown = _closed(*given)
    return places[shown], numbers[:, shown]


def _ends(r: Intervals) -> Ends:
    """About between what r lies: one number, if it is the same everywhere."""
    return (r.high, r.high) if np.ndim(r.high) == 0 else (r.low, r.high)


def collapsing_on_a_line(r: Intervals, state: State, owners: Array) -> tuple[Array, Array]:
    """The boxes of spheres on a line that are shown to collapse; they need no numbers."""
    places = np.flatnonzero(_shown_on_a_line(some_of(r, owners), state))
    return places, np.zeros((0, len(places)))


def _shown_on_a_line(r: Intervals, state: State) -> Array:
    """Whether they collapse.

    The number Q of the theorem is the ratio of the two speeds, or just above the smaller root of
    Q((1+r)/2 - Q) = r.
    """
    half = (1 + r) / 2
    root = square_root(half * half - 4 * r).low
    least = up(up(half.high - root) / 2) * (1 + 2.0**-20)
    Q = exactly(np.maximum(as_approach(state).ratio.high, least))
    shown = (state.lam.low > 0) & (state.rho.low > 0) & (state.C.low > 0) & (state.eps.low > 0)
    shown &= (2 * Q).high < half.low
    return shown & (r.high <= (Q * (exactly(half.low) - Q)).low)


# --- what is proved ------------------------------------------------------------------------------


@cache
def conditions() -> tuple[Program, tuple[Claim, ...]]:
    """What the sharper theorem asks of its numbers, with Theta as the sum of all turns.

    They are read from the statement that comes with the program, in which the last part of the
    given `start-C-upper` is that sum.
    """
    (start,) = read_questions(packaged_files(SHARPER)[0], {}).contexts[:1]
    givens = {given.name: given.claim for given in start.givens}
    turns = givens["start-C-upper"].lhs.children[1]
    program = Program((*NUMBERS, *OTHERS))
    program.define("Theta", turns)
    known = {*NUMBERS, *OTHERS, "Theta"}
    claims = tuple(
        claim
        for name, claim in givens.items()
        if name not in CHOSEN and known.issuperset(names_of(claim.lhs, claim.rhs))
    )
    for claim in claims:
        program.add(claim.lhs), program.add(claim.rhs)
    return program, claims


@cache
def _machine() -> Machine:
    return Machine(conditions()[0], IntervalsArithmetic())


def closes(r: Intervals, box: Approach, numbers: Array) -> Array:
    """Whether the sharper theorem applies to all states of a box, with these numbers."""
    found = dict(zip(NUMBERS, map(exactly, numbers * UNIT), strict=True))
    m, X, k, V = (found[name] for name in ("m", "X", "k", "V"))
    T = 2 * k / (1 + square_root(1 - 2 * k * V**2))
    others = (r, T, exactly(box.speed), exactly(box.eta), box.C)
    run = _machine().run((*found.values(), *others))
    # What is asked of the state, divided by -eta_c.
    shown = (box.ratio.low > 0) & (box.ratio.high <= (m + X).low)
    shown &= ((m - X).high <= box.ratio.low) & (box.slope.high <= k.low)
    for claim in conditions()[1]:
        low, high = run[claim.lhs], run[claim.rhs]
        shown &= low.high < high.low if claim.relation == "<" else low.high <= high.low
    return shown


# --- the search ----------------------------------------------------------------------------------


class Known(Record):
    """What a search begins with: r, (1+r)/2, -cos θ, -eta_c, and the ratio just after a collision.

    The larger speed is the unit.
    """

    r: Ends
    h: Ends
    C: Ends
    eta: Array
    q: Ends


class Guess(Record):
    """Bounds in floats; `size` is what does not grow any more once they are found."""

    y: Ends
    ratio: Ends
    k: Array
    V: Array
    size: Array


def _begun(r: Ends, state: State) -> tuple[Approach, Known, Guess, Array]:
    """The first guess, and whether it is worth while to improve it."""
    box = as_approach(state)
    C, q, h = (
        (box.C.low, box.C.high),
        (box.ratio.low, box.ratio.high),
        ((1 + r[0]) / 2, (1 + r[1]) / 2),
    )
    known = Known(r, h, C, box.eta / box.speed, q)
    steep = box.slope.high * box.speed * box.speed
    alpha = h[1] * (C[0] + C[1]) / 2
    p = (alpha + np.sqrt(alpha * alpha - 4 * r[1])) / 2
    ratio = np.minimum(q[0], r[0] / p), np.maximum(q[1], r[1] / p)
    guess = Guess((p, p), ratio, steep * SLACK, p, np.full_like(p, -1.0))
    return box, known, guess, (q[1] < 1) & (steep < 0.25) & (p * p * p > r[1] * r[1])


def _improved(known: Known, guess: Guess) -> tuple[Guess, Array, Array]:
    """One round: each bound from the others; whether it is the last one, and whether to go on."""
    r, (h_0, h), C, e, q = known
    (low, high), _, k, _, before = guess
    G = 1 + k * e * e
    V = (1 + h * G * e / (1 - high)) * SLACK
    root = np.sqrt(1 - 2 * k * V * V)
    T = 2 * k / (1 + root) * SLACK
    turn = 2 * T * V * e / (1 - high) + (k + T * T * V * V) * e * e / (1 - high * high)
    turn = turn + T * V * k * e * e * e / (1 - high * high * high)
    small = np.minimum(q[0], r[0] * root / high / SLACK)
    large = np.maximum(q[1], r[1] * G / low * SLACK)
    top = h * G * (C[1] + turn) - np.maximum(small, 0) / G
    bottom = h_0 * root * (C[0] - turn) - large - T * V * V
    # With a little impatience: bounds that grow are taken to grow further.
    low, high = np.minimum(low, bottom / SLACK), np.maximum(high, top * SLACK)
    slope = (large * T + V * V * T * T / 2) / (low * low) * SLACK
    k = np.maximum(k, slope)
    fine = (high < 1) & (low > 0) & (root > 0) & (k < 1)
    size = high - low + k
    ends = fine & (size - before <= GAIN * size)
    return Guess((low, high), (small, large), k, V, size), ends, fine & ~ends


def _rounded(guess: Guess, speed: Array) -> Array:
    """Whole numbers of units, each on the side where it is weaker."""
    (low, high), (small, large) = guess.y, guess.ratio
    m, p = np.rint((small + large) / 2 / UNIT), np.rint((low + high) / 2 / UNIT)
    X = np.ceil(np.maximum(large - m * UNIT, m * UNIT - small) / UNIT * SLACK) + 1
    Y = np.ceil(np.maximum(high - p * UNIT, p * UNIT - low) / UNIT * SLACK) + 1
    k = np.ceil(guess.k / (speed * speed) / UNIT) + 1
    V = np.ceil(guess.V * speed / UNIT) + 1
    return np.stack([np.maximum(m, X), p, X, Y, k, V])


def _closed(r: Intervals, box: Approach, guess: Guess) -> tuple[Array, Array]:
    """The numbers, and whether the theorem applies with them."""
    numbers = _rounded(guess, box.speed)
    return numbers, closes(r, box, numbers)
