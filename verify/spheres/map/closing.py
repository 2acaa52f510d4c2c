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
from verify.spheres.map.branches import some_of, take
from verify.spheres.map.intervals import (
    Array,
    Intervals,
    IntervalsArithmetic,
    exactly,
    square_root,
    up,
)
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

    def some(self, chosen: Array) -> Approach:
        """Some of the boxes."""
        return Approach(*(x[chosen] for x in self))


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
    places = np.flatnonzero((state.lam.low > 0) & (state.rho.low > 0) & (state.C.low > 0))
    box = as_approach(take(state, places))
    worth = (box.ratio.high < 1) & (box.slope.high * box.speed * box.speed < 0.25)
    places, box = places[worth], box.some(worth)
    here = some_of(r, places)
    numbers = search(_ends(here, len(places)), box)
    found = np.flatnonzero(~np.isnan(numbers[0]))
    places, numbers = places[found], numbers[:, found]
    shown = closes(some_of(here, found), box.some(found), numbers)
    return places[shown], numbers[:, shown]


def _ends(r: Intervals, size: int) -> Ends:
    """About between what r lies: one number, if it is the same everywhere."""
    if np.ndim(r.high) == 0:
        return float(r.high), float(r.high)
    return np.broadcast_to(r.low, size), np.broadcast_to(r.high, size)


def collapsing_on_a_line(r: Intervals, state: State, owners: Array) -> tuple[Array, Array]:
    """The boxes of spheres on a line that are shown to collapse; they need no numbers.

    The number Q of the theorem is the ratio of the two speeds, or just above the smaller root of
    Q((1+r)/2 - Q) = r.
    """
    here = some_of(r, owners)
    half = (1 + here) / 2
    root = square_root(half * half - 4 * here).low
    least = up(up(half.high - root) / 2) * (1 + 2.0**-20)
    Q = exactly(np.maximum(as_approach(state).ratio.high, least))
    shown = (state.lam.low > 0) & (state.rho.low > 0) & (state.C.low > 0) & (state.eps.low > 0)
    shown &= (2 * Q).high < half.low
    shown &= here.high <= (Q * (exactly(half.low) - Q)).low
    places = np.flatnonzero(shown)
    return places, np.zeros((0, len(places)))


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


class Guess:
    """Bounds in floats, with the larger speed as the unit; `fine` where they make sense."""

    def __init__(self, r: Ends, box: Approach) -> None:
        self.r, self.h = r, ((1 + r[0]) / 2, (1 + r[1]) / 2)
        self.C, self.eta = (box.C.low, box.C.high), box.eta / box.speed
        self.q = (box.ratio.low, box.ratio.high)
        self.k = box.slope.high * box.speed * box.speed * SLACK
        alpha = self.h[1] * (self.C[0] + self.C[1]) / 2
        p = (alpha + np.sqrt(alpha * alpha - 4 * r[1])) / 2
        self.y, self.V, self.fine = (p, p), p, p * p * p > r[1] * r[1]
        self.ratio = (np.minimum(self.q[0], r[0] / p), np.maximum(self.q[1], r[1] / p))

    def improve(self) -> None:
        """One round: each bound from the others."""
        e, (h_0, h), low, high = self.eta, self.h, *self.y
        G = 1 + self.k * e * e
        self.V = (1 + h * G * e / (1 - high)) * SLACK
        root = np.sqrt(1 - 2 * self.k * self.V * self.V)
        T, V = 2 * self.k / (1 + root) * SLACK, self.V
        turn = 2 * T * V * e / (1 - high) + (self.k + T * T * V * V) * e * e / (1 - high * high)
        turn = turn + T * V * self.k * e * e * e / (1 - high * high * high)
        self.ratio = (
            np.minimum(self.q[0], self.r[0] * root / high / SLACK),
            np.maximum(self.q[1], self.r[1] * G / low * SLACK),
        )
        small, large = self.ratio
        top = h * G * (self.C[1] + turn) - np.maximum(small, 0) / G
        bottom = h_0 * root * (self.C[0] - turn) - large - T * V * V
        # With a little impatience: bounds that grow are taken to grow further.
        self.y = (np.minimum(low, bottom / SLACK), np.maximum(high, top * SLACK))
        slope = (large * T + V * V * T * T / 2) / (self.y[0] * self.y[0]) * SLACK
        self.k = np.maximum(self.k, slope)
        self.fine &= (self.y[1] < 1) & (self.y[0] > 0) & (root > 0) & (self.k < 1)

    def size(self) -> Array:
        """What does not grow any more once the bounds are found."""
        return self.y[1] - self.y[0] + self.k


def search(r: Ends, box: Approach) -> Array:
    """Numbers in units that probably satisfy what the theorem asks for; or NaN."""
    found = np.full((len(NUMBERS), len(box.eta)), np.nan)
    places, before = np.arange(len(box.eta)), np.full(len(box.eta), -1.0)
    guess = Guess(r, box)
    for _ in range(ROUNDS):
        if len(places) == 0:
            break
        guess.improve()
        size = guess.size()
        ends = guess.fine & (size - before <= GAIN * size)
        if ends.any():
            found[:, places[ends]] = _rounded(_some(guess, ends), box.speed[places[ends]])
        goes = guess.fine & ~ends
        before = size
        if not goes.all():
            places, before, guess = places[goes], size[goes], _some(guess, goes)
    return found


def _some(guess: Guess, chosen: Array) -> Guess:
    part: Guess = object.__new__(Guess)
    for name, value in vars(guess).items():
        if isinstance(value, tuple):
            setattr(part, name, tuple(_some_of(x, chosen) for x in value))
        else:
            setattr(part, name, value[chosen])
    return part


def _some_of(x: float | Array, chosen: Array) -> float | Array:
    return x if isinstance(x, float) else x[chosen]


def _rounded(guess: Guess, speed: Array) -> Array:
    """Whole numbers of units, each on the side where it is weaker."""
    (low, high), (small, large) = guess.y, guess.ratio
    m, p = np.rint((small + large) / 2 / UNIT), np.rint((low + high) / 2 / UNIT)
    X = np.ceil(np.maximum(large - m * UNIT, m * UNIT - small) / UNIT * SLACK) + 1
    Y = np.ceil(np.maximum(high - p * UNIT, p * UNIT - low) / UNIT * SLACK) + 1
    k = np.ceil(guess.k / (speed * speed) / UNIT) + 1
    V = np.ceil(guess.V * speed / UNIT) + 1
    return np.array([np.maximum(m, X), p, X, Y, k, V])
