"""The separatrix u = f(q) of the limit map, enclosed by orbits that are rounded to one side.

The map, its letters and the theorem about it stand in `verify/coq/Separatrix.v`, which Coq proves.
This module relies on these parts of it:

* Order: what lies below a state whose collisions never end has collisions that never end; so an
  orbit rounded up that never ends shows u <= f(q), and one rounded down that ends u >= f(q).
* f is positive before phi_plus, 0 from there on, and at most a/(a + rho). It exists if and only if
  s + s^2 < a, where s^3 = r; otherwise no orbit goes on for ever.
* There is one cycle of two collisions, and it lies on the curve.

An orbit never ends once two collisions, rounded up, lead to a state that is below the one before
them: the map keeps the order, so the same two states bound all that follow. And it ends if two
collisions, rounded down, lead to another state that is above the one before them: below a state
whose collisions never end u tends to 0, while here it does not fall. Next to the curve, and at
parameters next to the threshold, that is seen long before u is small, or the collisions end.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import TypeVar

from verify.language.record import Record
from verify.prover import balls
from verify.prover.balls import Ball

#: Who decides on which side of the curve a point lies, and whether there is one.
ORBITS = "balls along monotone orbits"
RATIONALS = "exact rational arithmetic"
#: Who decides where the fixed points are.
SIGNS = "sign changes in exact rational arithmetic"

Point = tuple[Ball, Ball]
Real = TypeVar("Real", Ball, Fraction)
Ends = tuple[Fraction, Fraction]

#: Bits beyond those of the digits asked for, and how often they are doubled.
GUARD_BITS, DOUBLINGS = 48, 8
#: Of two: f is not looked for below its inverse.
LARGEST_POWER = 1 << 13


#: Three of this.
EQUAL = (Fraction(1),) * 3


class Parameters(Record):
    """r in (0, 1), -cos of the angle in (0, 1], the ratio of the squared speeds > 0; which balls.

    All exact. The first ball is the one in the middle, the second has just collided with it, and
    the third one is the next. The ratio is |W|² of the second over that of the third.
    """

    r: Fraction
    neg_cos: Fraction
    ratio: Fraction
    masses: tuple[Fraction, ...] = EQUAL
    radii: tuple[Fraction, ...] = EQUAL

    @property
    def is_unlike(self) -> bool:
        """Whether the balls differ in mass or radius."""
        return any(len(set(values)) > 1 for values in (self.masses, self.radii))

    @property
    def square_a(self) -> Fraction:
        """The square of a = (1+r) (-cos θ) √(m₁m₂/((m₀+m₁)(m₀+m₂))); (1+r)/2 for equal masses."""
        m0, m1, m2 = self.masses
        shares = m1 * m2 / ((m0 + m1) * (m0 + m2))
        return ((1 + self.r) * self.neg_cos) ** 2 * shares

    @property
    def square_rho(self) -> Fraction:
        """The square of rho = ratio (R₀+R₂)/(R₀+R₁) √(m₁(m₀+m₂)/(m₂(m₀+m₁)))."""
        middle, last, after = self.radii
        sizes = (middle + after) / (middle + last)
        return (self.ratio * sizes) ** 2 * self.scale

    @property
    def scale(self) -> Fraction:
        """The square of what a ratio of normal speeds is multiplied by to be q."""
        m0, m1, m2 = self.masses
        return m1 * (m0 + m2) / (m2 * (m0 + m1))


class CurveAt(Record):
    """low <= f(q) <= high; ``reached`` says whether that is as narrow as was asked for."""

    q: Fraction
    low: Fraction
    high: Fraction
    reached: bool
    judge: str


class Allowance:
    """How many collisions may still be followed."""

    def __init__(self, steps: int) -> None:
        self.left = steps


# --- whether there is a separatrix ----------------------------------------------------------------


def has_separatrix(parameters: Parameters) -> bool | None:
    """Whether s + s^2 < a, where s^3 = r: the hypothesis of Theorem 1.

    For a > 0 that is r (1 + r) < a (a^2 - 3 r): there is equality at a = s + s^2, the right side
    grows with a from √r on, and up to 2√r it is at most 2 r √r < r (1 + r).
    """
    r, square = parameters.r, parameters.square_a
    return square > 3 * r and (r * (1 + r)) ** 2 < square * (square - 3 * r) ** 2


def beyond(parameters: Parameters, q: Fraction) -> bool:
    """Whether q is at least phi_plus, the larger root of x^2 - a x + r."""
    r, square = parameters.r, parameters.square_a
    return q > 0 and 4 * q * q > square and (q * q + r) ** 2 >= square * q * q


def fixed_points(parameters: Parameters, bits: int) -> tuple[Ends, ...]:
    """Enclosures of phi_minus and phi_plus, where there is a separatrix; exact where rational.

    Nothing if x^2 - a x + r is not seen to change its sign in them, before and after a/2.
    """
    minus, plus = found = _near_roots(parameters, bits)
    apart = 4 * minus[1] ** 2 < parameters.square_a < 4 * plus[0] ** 2
    return found if apart and all(changes_sign(parameters, ends) for ends in found) else ()


def changes_sign(parameters: Parameters, ends: Ends) -> bool:
    """Whether x^2 - a x + r has opposite signs at two positive ends, or is 0 at one of them."""
    r, square = parameters.r, parameters.square_a
    low, high = ((x * x + r) ** 2 - square * x * x for x in ends)
    return low * high <= 0


def _near_roots(parameters: Parameters, bits: int) -> tuple[Ends, Ends]:
    """Numbers around the roots of x^2 - a x + r."""
    r, square = parameters.r, parameters.square_a
    with balls.precision(2 * bits):  # at which the ends of balls are rounded
        a, apart = (balls.any_root(balls.fmpq_of(x)) for x in (square, square - 4 * r))
        plus = (a + apart) / 2
        if balls.is_rational(plus):
            exact = balls.fraction_of(plus)
            return (r / exact, r / exact), (exact, exact)
        return balls.ends(balls.from_fraction(r) / plus), balls.ends(plus)


def root(square: Fraction) -> Ball:
    """The square root of a positive number, at the current precision."""
    return balls.as_ball(balls.any_root(balls.fmpq_of(square)))


def root_ends(square: Fraction, bits: int) -> Ends:
    """Numbers around the square root of a positive one; the same, if it is rational."""
    with balls.precision(bits):
        found = balls.any_root(balls.fmpq_of(square))
        if balls.is_rational(found):
            return (balls.fraction_of(found),) * 2
        return balls.ends(found)


# --- orbits ---------------------------------------------------------------------------------------


class Orbits:
    """Orbits of the map at some precision, each rounded up, or each rounded down."""

    def __init__(self, parameters: Parameters, bits: int, budget: Allowance) -> None:
        self.bits, self.budget = bits, budget
        square = parameters.square_rho
        with balls.precision(bits):
            self.r = balls.from_fraction(parameters.r)
            self.a = root(parameters.square_a)
            self.ratios = root(square), root(1 / square)

    def side(self, q: Fraction, u: Fraction) -> int:
        """-1 only if u <= f(q), 1 only if u >= f(q); 0 if neither is known."""
        with balls.precision(self.bits):
            start = balls.from_fraction(q), balls.from_fraction(u)
            if self._followed((start[0].upper(), start[1].upper()), up=True) < 0:
                return -1
            return max(0, self._followed((start[0].lower(), start[1].lower()), up=False))

    def image(self, ratio: Ball, state: Point) -> tuple[int, Point]:
        """1 and the next state if there is one for certain, -1 if there is none, 0 if unknown."""
        q, u = state
        rest, product = 1 - u, ratio * u
        p = self.a * rest - q - product
        top, square = product * (2 * q + product), p * p
        if p <= 0 or top >= square:
            return -1, state
        if not (p > 0 and top < square):
            return 0, state
        h = top / square
        after = self.r * rest / p, h / (1 + (1 - h).sqrt())
        return (1 if after[0].is_finite() and after[1].is_finite() else 0), after

    def _followed(self, state: Point, *, up: bool) -> int:
        """-1 if the orbit, rounded to one side, never ends, 1 if it ends; 0 if neither is seen.

        An orbit that is rounded up is above the true one, and one that is rounded down below it.
        One that moves the wrong way in two collisions goes on like this for ever, and shows
        nothing.
        """
        earlier, former, parity = None, None, 0
        while self.budget.left > 0:
            way = direction(earlier, state) if earlier is not None else 0
            if way:
                return way if up == (way < 0) else 0
            self.budget.left -= 1
            known, (q, u) = self.image(self.ratios[parity], state)
            if known <= 0:
                return -known
            earlier, former, parity = former, state, 1 - parity
            state = (q.upper(), u.upper()) if up else (q.lower(), u.lower())
        return 0


def direction(before: tuple[Real, Real], after: tuple[Real, Real]) -> int:
    """-1 if q and u fall or stay; 1 if they rise or stay, from 0 <= q and 0 < u; else 0."""
    if after[0] <= before[0] and after[1] <= before[1]:
        return -1
    rises = before[0] <= after[0] and before[1] <= after[1]
    return int(rises and before[0] >= 0 and before[1] > 0)


# --- the curve ------------------------------------------------------------------------------------


class Curve:
    """The separatrix at given parameters, where there is one."""

    def __init__(self, parameters: Parameters, budget: Allowance) -> None:
        self.parameters, self.budget = parameters, budget
        self._orbits: dict[int, Orbits] = {}

    def strip(self, q: Fraction, digits: int) -> CurveAt:
        """An enclosure of f(q), to so many digits if the budget suffices."""
        if beyond(self.parameters, q):
            return CurveAt(q, Fraction(0), Fraction(0), True, RATIONALS)
        low, high, power = Fraction(0), self._highest(), 1
        bits = digits * 3322 // 1000 + GUARD_BITS
        while not low or (high - low) * 10**digits > low:
            for cut in _cuts(low, high, power):
                side = self._side(q, cut, bits)
                if side:
                    break
            else:
                return CurveAt(q, low, high, False, ORBITS)
            low, high = (cut, high) if side < 0 else (low, cut)
            power *= 2
        return CurveAt(q, low, high, True, ORBITS)

    def _side(self, q: Fraction, u: Fraction, bits: int) -> int:
        """The side of a point, at a precision that is doubled a few times."""
        for _ in range(DOUBLINGS):
            side = self.orbits(bits).side(q, u)
            if side or self.budget.left <= 0:
                return side
            bits *= 2
        return 0

    def orbits(self, bits: int) -> Orbits:
        """Orbits at a precision."""
        if bits not in self._orbits:
            self._orbits[bits] = Orbits(self.parameters, bits, self.budget)
        return self._orbits[bits]

    def _highest(self) -> Fraction:
        """A short number that is at least a/(a + rho)."""
        size = 1 << 64
        with balls.precision(GUARD_BITS + size.bit_length()):
            square = self.parameters.square_rho / self.parameters.square_a
            _, quotient = balls.ends(1 / (1 + root(square)))
        return Fraction(-(-quotient.numerator * size // quotient.denominator), size)


def _cuts(low: Fraction, high: Fraction, power: int) -> Iterator[Fraction]:
    """Where to cut next, and where if that is too near to the curve to tell.

    While nothing is known from below, far down, but there is an end; then halfway, in powers of two
    while they differ.
    """
    if not low and power > LARGEST_POWER:
        return
    if not low:
        yield from (high / 2**power, high / 2**power * Fraction(3, 4))
    elif high > 4 * low:
        quotient = high / low
        half = (quotient.numerator.bit_length() - quotient.denominator.bit_length()) // 2
        yield from (low * 2**half, low * 2**half * Fraction(5, 4))
    else:
        yield from ((low + high) / 2, (5 * low + 3 * high) / 8)
