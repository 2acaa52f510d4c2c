"""Taylor models with balls for coefficients: a second opinion on boxes, by the same steps.

As in `verify.prover.map_models` a number is within e of a quadratic polynomial of two parameters in
[-1, 1], and lies between bounds. But all of these are balls, so that nothing is to be known about
rounding: what is said of real coefficients is true of those in the balls.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Any

import numpy as np

from verify.paper.flow.law import State
from verify.paper.map.planes import Plane
from verify.paper.map.strip import BorderStrip
from verify.prover import balls
from verify.prover.map_boxes import BoxNumbers, verdicts_of
from verify.prover.map_closing import NUMBERS, conditions
from verify.prover.map_intervals import Array, Intervals, down, up
from verify.prover.program import Machine

BITS = 96
#: What a number in units of 2^-30 is worth.
UNIT = Fraction(1, 2**30)


class BallModels:
    """Arrays of polynomials, of errors e >= 0, and of bounds, all of them balls.

    `empty` says that there is no number at all: then low > high, which are doubles.
    """

    __slots__ = ("c", "e", "empty", "high", "low", "within")

    def __init__(self, c: Array, e: Array, within: Array, *of: BallModels) -> None:
        """The bounds are cut with the range of the polynomial; `of`: what the numbers come from."""
        self.c, self.e = c, e
        self.within = _each(Span.cut, within, c[0], np.abs(c[1:]).sum(0) + e)
        self.empty = _each(lambda x: x.low > x.high, self.within).astype(bool)
        for x in of:
            self.empty = self.empty | x.empty
        low, high = (_each(end, self.within).astype(float) for end in (_below, _above))
        self.low, self.high = np.where(self.empty, 1.0, low), np.where(self.empty, -1.0, high)

    def __add__(self, other: Any) -> Any:
        if isinstance(other, BallModels):
            within = self.within + other.within
            return BallModels(self.c + other.c, self.e + other.e, within, self, other)
        return self if other == 0 else self + self.like(other)

    __radd__ = __add__

    def __neg__(self) -> BallModels:
        return BallModels(-self.c, self.e, -self.within, self)

    def __sub__(self, other: Any) -> Any:
        return self + -other

    def __rsub__(self, other: Any) -> Any:
        return -self + other

    def __mul__(self, other: Any) -> Any:
        if not isinstance(other, BallModels):
            return self * self.like(other) if other else 0
        c, e = _product(self.c, self.e, other.c, other.e)
        return BallModels(c, e, self.within * other.within, self, other)

    __rmul__ = __mul__

    def __pow__(self, exponent: int) -> Any:
        """The squares: other powers are not asked for."""
        if exponent != 2:
            raise ValueError("expected a square")
        c, e = _product(self.c, self.e, self.c, self.e)
        return BallModels(c, e, _each(Span.square, self.within), self)

    def __truediv__(self, other: Any) -> Any:
        """The quotients, where the divisor is positive."""
        if not isinstance(other, BallModels):
            return self / self.like(other)
        bounds = self.within * _each(Span.inverse, other.within)
        return _rescued(*_product(self.c, self.e, *_inverse(other)), bounds, self, other)

    def __rtruediv__(self, other: int) -> Any:
        return self.like(other) / self

    def __getitem__(self, chosen: Array) -> BallModels:
        found: BallModels = object.__new__(BallModels)
        for name in self.__slots__:
            setattr(found, name, getattr(self, name)[..., chosen])
        return found

    def like(self, whole: int) -> BallModels:
        """A small whole number."""
        one = Ball(whole)
        return flat(_each(lambda _: Span(one, one), self.within))

    def root(self) -> BallModels:
        """The roots; without a value where a number may be negative."""
        return _rescued(*_root(self), _each(Span.root, self.within), self)

    def root_of_share(self) -> BallModels:
        """The roots of those numbers that are in [0, 1]."""
        return _rescued(*_root(self), _each(Span.root_of_share, self.within), self)

    def above(self, least: Array) -> BallModels:
        """The same numbers where they are no less than that, which NaN does not say."""
        floor = np.broadcast_to(np.nan_to_num(least, nan=-np.inf), self.low.shape)
        return BallModels(self.c, self.e, _each(Span.above, self.within, floor), self)

    @staticmethod
    def joined(parts: Sequence[BallModels]) -> BallModels:
        """One array after the other."""
        found: BallModels = object.__new__(BallModels)
        for name in BallModels.__slots__:
            arrays = [getattr(part, name) for part in parts]
            setattr(found, name, np.concatenate(arrays, axis=arrays[0].ndim - 1))
        return found


# --- spans ---------------------------------------------------------------------------------------

_ZERO = balls.from_fraction(Fraction(0))
_ONE = balls.from_fraction(Fraction(1))
_NOTHING = 1 / _ZERO
Ball = type(_ZERO)


class Span:
    """All numbers between two exact balls: balls themselves are too wide where they are coarse."""

    __slots__ = ("high", "low")

    def __init__(self, low: Any, high: Any) -> None:
        self.low, self.high = low.lower(), high.upper()

    def __add__(self, other: Span) -> Span:
        return Span(self.low + other.low, self.high + other.high)

    def __neg__(self) -> Span:
        return Span(-self.high, -self.low)

    def __mul__(self, other: Span) -> Span:
        a, b, c, d = self.low, self.high, other.low, other.high
        if a >= 0 and c >= 0:
            return Span(a * c, b * d)
        ac, ad, bc, bd = a * c, a * d, b * c, b * d
        return Span(ac.min(ad).min(bc).min(bd), ac.max(ad).max(bc).max(bd))

    def square(self) -> Span:
        """The squares."""
        a, b = abs(self.low), abs(self.high)
        return Span(_ZERO if self.low <= 0 <= self.high else (a * a).min(b * b), (a * a).max(b * b))

    def inverse(self) -> Span:
        """The inverses of positive numbers."""
        return Span(1 / self.high, 1 / self.low) if self.low > 0 else Span(_NOTHING, _NOTHING)

    def root(self) -> Span:
        """The roots; nothing is known if a number may be negative."""
        return Span(self.low.sqrt(), self.high.sqrt())

    def root_of_share(self) -> Span:
        """The roots of what is in [0, 1]."""
        high = self.high.min(_ONE).max(_ZERO)
        return Span(self.low.max(_ZERO).sqrt(), high.sqrt())

    def above(self, least: float) -> Span:
        """What is no less than that."""
        low = self.low.max(Ball(least)) if least > -np.inf else self.low
        return Span(low.min(self.high), self.high)

    def cut(self, middle: Any, radius: Any) -> Span:
        """What is within the radius of the middle, which says nothing if it is not finite."""
        low, high = (middle - radius).lower(), (middle + radius).upper()
        if not (low.is_finite() and high.is_finite()):
            return self
        if not (self.low.is_finite() and self.high.is_finite()):
            return Span(low, high)
        return Span(self.low.max(low), self.high.min(high))

    def ball(self) -> Any:
        """A ball around it."""
        return balls.hull(self.low, self.high)


def _objects(values: Sequence[Any]) -> Array:
    found = np.empty(len(values), object)
    found[:] = values
    return found


def _each(function: Callable[..., Any], *arrays: Array) -> Array:
    return _objects([function(*x) for x in zip(*arrays, strict=True)])


def _below(x: Span) -> float:
    """A double that is no more than the lower end."""
    near = float(x.low)
    return near if Ball(near) <= x.low else float(down(near))


def _above(x: Span) -> float:
    near = float(x.high)
    return near if x.high <= Ball(near) else float(up(near))


# --- polynomials ---------------------------------------------------------------------------------


def _product(a: Array, e: Array, b: Array, f: Array) -> tuple[Array, Array]:
    c = a[0] * b
    c[1:] += b[0] * a[1:]
    c[3] += a[1] * b[1]
    c[4] += a[1] * b[2] + a[2] * b[1]
    c[5] += a[2] * b[2]
    (a0, a1, a2), (b0, b1, b2) = (
        (np.abs(p[0]), np.abs(p[1:3]).sum(0), np.abs(p[3:]).sum(0)) for p in (a, b)
    )
    error = a1 * b2 + a2 * b1 + a2 * b2 + (a0 + a1 + a2) * f + (b0 + b1 + b2) * e + e * f
    return c, error


def _inverse(x: BallModels) -> tuple[Array, Array]:
    """1/(c0 + t) = 1/c0 - t/c0² + t²/c0³ - t³/(c0³ (c0 + t)), where |t| <= radius < c0."""
    radius = np.abs(x.c[1:]).sum(0) + x.e
    i, least = 1 / x.c[0], _each(lambda m: m if m > 0 else _NOTHING, x.c[0] - radius)
    return _series(x, (i, -i * i, i * i * i), radius * radius * radius * i * i * i / least)


def _root(x: BallModels) -> tuple[Array, Array]:
    """√(c0 + t) = q + t/(2q) - t²/(8q³) + R, q = √c0, |R| <= |t|³/(16 (c0 - radius)^(5/2))."""
    radius = np.abs(x.c[1:]).sum(0) + x.e
    q, least = (_each(lambda m: m if m > 0 else _NOTHING, y) for y in (x.c[0], x.c[0] - radius))
    q, least_root = (_each(lambda m: m.sqrt(), y) for y in (q, least))
    rest = radius * radius * radius / (16 * least * least * least_root)
    return _series(x, (q, 1 / (2 * q), -1 / (8 * q * q * q)), rest)


def _series(x: BallModels, f: tuple[Array, Array, Array], rest: Array) -> tuple[Array, Array]:
    """f0 + f1 t + f2 t² for t = x - c0, with an error `rest`."""
    t = x.c.copy()
    t[0] = _each(lambda _: _ZERO, t[0])
    c, e = _product(t, x.e, t, x.e)
    c = c * f[2] + t * f[1]
    c[0] = c[0] + f[0]
    return c, e * np.abs(f[2]) + x.e * np.abs(f[1]) + rest


def _rescued(c: Array, e: Array, within: Array, *of: BallModels) -> BallModels:
    """Where there is no polynomial there may still be bounds."""
    fine = np.array([x.is_finite() for x in e], bool)
    rough = flat(within)
    return BallModels(np.where(fine, c, rough.c), np.where(fine, e, rough.e), within, *of)


def flat(within: Array) -> BallModels:
    """Numbers of which only bounds are known."""
    none = _each(lambda _: _ZERO, within)
    middle = _each(lambda x: ((x.low + x.high) / 2).mid(), within)
    e = _each(lambda x, m: (x.high - m).max(m - x.low), within, middle)
    return BallModels(np.array([middle, *[none] * 5], object), e, within)


# --- boxes ---------------------------------------------------------------------------------------


def between(x: Intervals) -> Array:
    """Spans of intervals."""
    pairs = zip(np.atleast_1d(x.low), np.atleast_1d(x.high), strict=True)
    return _objects([Span(Ball(float(a)), Ball(float(b))) for a, b in pairs])


def parameter(place: int, x: Intervals) -> BallModels:
    """The parameters x or y, the places 0 and 1, stretched so that they run over intervals."""
    within = between(x)
    found = flat(within)
    c = found.c.copy()
    c[1 + place] = found.e
    return BallModels(c, c[5], within)


def exact_models(value: Fraction) -> BallModels:
    """A rational number."""
    ball = balls.from_fraction(value)
    return flat(_objects([Span(ball, ball)]))


def spread(x: BallModels, size: int) -> BallModels:
    """The same number for each box."""
    one = np.zeros(size, int) if len(x.e) == 1 else np.arange(size)
    return x[one]


# --- what is proved ------------------------------------------------------------------------------


def closes(
    r: Fraction, state: State, owners: Array, numbers: Sequence[Sequence[tuple[int, ...]]]
) -> tuple[Array, Array]:
    """The branches that collapse by one of the numbers given for their box; nothing is searched."""
    reach = (1 + state.eps * state.v**2).root()
    inverse = reach / state.lam
    columns = (
        state.lam * state.v / reach,
        state.rho * inverse,
        state.eps / (1 + reach) * inverse**2,
        state.C / reach,
        state.A,
        state.B,
    )
    good = (state.lam.low > 0) & (state.rho.low > 0)
    places, found = [], []
    for place, owner in enumerate(owners.tolist()):
        box = [x.within[place].ball() for x in columns]
        for six in numbers[owner] if good[place] else ():
            if _applies(r, box, six):
                places.append(place)
                found.append(six)
                break
    return np.array(places, int), np.array(found, float).reshape(-1, len(NUMBERS)).T


def _applies(r: Fraction, box: Sequence[Any], six: tuple[int, ...]) -> bool:
    """Whether the sharper theorem applies, with these numbers."""
    eta, ratio, slope, C, A, B = box
    exact = [balls.from_fraction(n * UNIT) for n in six]
    m, _, X, _, k, V = exact
    square, room = A.upper().max(B.upper()).max(_ZERO), 1 - 2 * k * V**2
    if not (room > 0 and m - X <= ratio and ratio <= m + X and slope <= k and ratio > 0):
        return False
    top = eta.upper().max(_ZERO)
    speed = square.sqrt().upper().max(top)
    others = (balls.from_fraction(r), 2 * k / (1 + room.sqrt()), speed, top, C)
    program, claims = conditions()
    run = Machine(program, balls.BallArithmetic()).run((*exact, *others))
    for claim in claims:
        low, high = run[claim.lhs], run[claim.rhs]
        if low is None or high is None:
            return False
        if not (low < high if claim.relation == "<" else low <= high):
            return False
    return True


BALLS = BoxNumbers(parameter, lambda x: flat(between(x)), exact_models, spread)


def reproved(
    plane: Plane | BorderStrip, level: Sequence[tuple[str, str, Sequence[tuple[int, ...]]]]
) -> list[bool]:
    """Whether the verdicts on boxes of one level, with their numbers, are shown in balls too."""
    keys, letters, numbers = zip(*level, strict=True)
    r = plane.r

    def closing(state: State, owners: Array) -> tuple[Array, Array]:
        return closes(r, state, owners, numbers)

    with balls.precision(BITS):
        found = verdicts_of(BALLS, plane, keys, closing)
    return [a == b for a, b in zip(found.letters, letters, strict=True)]
