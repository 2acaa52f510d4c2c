"""Many Taylor models at once: quadratic polynomials of two parameters, with intervals beside them.

A number is known to be c0 + c1 x + c2 y + c3 x² + c4 xy + c5 y² with an error of at most e, for all
parameters |x|, |y| <= 1, and to lie between two bounds; each operation is done with both, and the
bounds are cut with the range of the polynomial. Numbers of a box that depend on its parameters in
the same way keep doing so.

Rounding: each coefficient is a sum of at most six products, so it is off by less than 8 u times the
sum of their absolute values, with u = 2^-53; the error terms themselves, sums of products of
numbers >= 0 in less than 30 operations, are too small by a factor of 1 - 32 u at most. `TINY` is
more than all that underflow can take away.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from verify.spheres.map.intervals import Array, Intervals, down, exactly, square_root, up

U = 2.0**-53
WIDER, TINY = 1 + 64 * U, 2.0**-900


class Models:
    """Polynomials with errors, and bounds."""

    __slots__ = ("bounds", "c", "e")

    def __init__(self, c: Array, e: Array, bounds: Intervals) -> None:
        """The bounds are cut with the range of the polynomial; NaN there says nothing."""
        self.c, self.e = c, e
        radius = (np.add.reduce(np.abs(c[1:])) + e) * WIDER
        low, high = down(c[0] - radius), up(c[0] + radius)
        self.bounds = Intervals(np.fmax(bounds.low, low), np.fmin(bounds.high, high))

    @property
    def hull(self) -> Intervals:
        """The bounds."""
        return self.bounds

    @property
    def low(self) -> Array:
        """Lower bounds."""
        return self.bounds.low

    @property
    def high(self) -> Array:
        """Upper bounds."""
        return self.bounds.high

    def __add__(self, other: Any) -> Models:
        if isinstance(other, Models):
            c = self.c + other.c
            e = (self.e + other.e + np.add.reduce(np.abs(c)) * (2 * U)) * WIDER + TINY
            return Models(c, e, self.bounds + other.bounds)
        if isinstance(other, int) and other == 0:
            return self
        return self + constant_model(other, self)

    __radd__ = __add__

    def __neg__(self) -> Models:
        return Models(-self.c, self.e, -self.bounds)

    def __sub__(self, other: Any) -> Any:
        return self + -other

    def __rsub__(self, other: Any) -> Any:
        return -self + other

    def __mul__(self, other: Any) -> Any:
        if isinstance(other, Models):
            c, e = _product(self, other)
            return Models(c, e, self.bounds * other.bounds)
        if isinstance(other, int) and other in (0, 1):
            return self if other else 0
        return self * constant_model(other, self)

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> Models:
        """The quotients; NaN where the divisor may be 0."""
        if not isinstance(other, Models):
            other = constant_model(other, self)
        c, e = _product(self, _inverse(other))
        return _rescued(c, e, self.bounds / other.bounds)

    def like(self, whole: int) -> Models:
        """A small whole number."""
        return constant_model(whole, self)

    def __rtruediv__(self, other: int) -> Any:
        return 0 if other == 0 else constant_model(other, self) / self

    def __pow__(self, exponent: int) -> Models:
        """The squares."""
        c, e = _product(self, self)
        return Models(c, e, self.bounds**exponent)

    def __getitem__(self, chosen: Array) -> Models:
        return _known(self.c[:, chosen], self.e[chosen], self.bounds[chosen])

    def root(self) -> Models:
        """The roots; NaN where a number may be negative."""
        return _rescued(*_root(self), square_root(self.bounds))

    def root_of_share(self) -> Models:
        """The roots of those numbers that are in [0, 1]."""
        return _rescued(*_root(self), self.bounds.root_of_share())

    def above(self, least: Array) -> Models:
        """The same numbers where they are no less than that."""
        return Models(self.c, self.e, self.bounds.above(least))

    @staticmethod
    def joined(parts: Sequence[Models]) -> Models:
        """One array after the other."""
        return _known(
            np.concatenate([part.c for part in parts], axis=1),
            np.concatenate([part.e for part in parts]),
            Intervals.joined([part.bounds for part in parts]),
        )


def _known(c: Array, e: Array, bounds: Intervals) -> Models:
    """Models of which the bounds have been cut before."""
    found = object.__new__(Models)
    found.c, found.e, found.bounds = c, e, bounds
    return found


def _rescued(c: Array, e: Array, bounds: Intervals) -> Models:
    """Models, where those with an infinite error are replaced by their bounds."""
    flat, rough = from_bounds(bounds), ~(e < np.inf)
    return Models(np.where(rough, flat.c, c), np.where(rough, flat.e, e), bounds)


def _product(x: Models, y: Models) -> tuple[Array, Array]:
    a, b = x.c, y.c
    c = a[0] * b
    c[1:] += b[0] * a[1:]
    c[3] += a[1] * b[1]
    c[4] += a[1] * b[2] + a[2] * b[1]
    c[5] += a[2] * b[2]
    a1, a2, all_a = _sizes(a)
    b1, b2, all_b = _sizes(b) if a is not b else (a1, a2, all_a)
    e = a1 * b2 + a2 * b1 + a2 * b2 + all_a * y.e + all_b * x.e + x.e * y.e
    return c, (e + all_a * all_b * (8 * U)) * WIDER + TINY


def _sizes(c: Array) -> tuple[Array, Array, Array]:
    """How large a polynomial is: its terms of degree one, and of degree two, and all of them."""
    sizes = np.abs(c)
    first, second = sizes[1] + sizes[2], np.add.reduce(sizes[3:])
    return first, second, sizes[0] + first + second


def _inverse(x: Models) -> Models:
    """1/(c0 + t) = 1/c0 - t/c0² + t²/c0³ - t³/(c0³ (c0 + t)), where |t| <= radius < |c0|."""
    c0, radius = x.c[0], _radius(x)
    least = (np.abs(c0) - radius) * (1 - 4 * U)
    i = 1 / c0
    rest = radius * radius * radius * np.abs(i * i * i) / least
    c, e = _series(x, (i, -i * i, i * i * i), radius, rest)
    return Models(c, np.where(least > 0, e, np.nan), _anything(e))


def _root(x: Models) -> tuple[Array, Array]:
    """√(c0 + t) = q + t/(2q) - t²/(8q³) + R, q = √c0, |R| <= |t|³/(16 (c0 - radius)^(5/2))."""
    c0, radius = x.c[0], _radius(x)
    least = (c0 - radius) * (1 - 4 * U)
    fine = least > 0
    c0, safe = np.where(fine, c0, 1.0), np.where(fine, least, 1.0)
    q = np.sqrt(c0)
    rest = radius * radius * radius / (16 * safe * safe * np.sqrt(safe))
    c, e = _series(x, (q, 0.5 / q, -0.125 / (q * c0)), radius, rest)
    return c, np.where(fine, e, np.nan)


def _series(
    x: Models, f: tuple[Array, Array, Array], radius: Array, rest: Array
) -> tuple[Array, Array]:
    """f0 + f1 t + f2 t² for t = x - c0, with an error `rest`; each f is off by 8 u at most."""
    t = x.c.copy()
    t[0] = 0.0
    x_t = _known(t, x.e, x.bounds)
    c, e = _product(x_t, x_t)
    c, e = c * f[2], e * np.abs(f[2])
    linear = t * f[1]
    c = c + linear
    c[0] += f[0]
    size = np.abs(f[0]) + np.abs(f[1]) * radius + np.abs(f[2]) * radius * radius
    e = e + x.e * np.abs(f[1]) + rest * (1 + 64 * U) + size * (32 * U)
    return c, e * WIDER + TINY


def _radius(x: Models) -> Array:
    return (np.add.reduce(np.abs(x.c[1:])) + x.e) * WIDER


def _anything(like: Array) -> Intervals:
    return Intervals(np.full_like(like, -np.inf), np.full_like(like, np.inf))


def from_bounds(x: Intervals) -> Models:
    """Numbers that do not depend on the parameters, or not in a known way."""
    middle, zero = x.low / 2 + x.high / 2, np.zeros_like(x.low)
    e = up(np.maximum(up(x.high - middle), up(middle - x.low)))
    return Models(np.stack([middle, zero, zero, zero, zero, zero]), e, x)


def constant_model(value: Any, like: Models) -> Models:
    """A whole number, or one interval, for each model."""
    x = value if isinstance(value, Intervals) else exactly(np.float64(value))
    return from_bounds(Intervals(np.full_like(like.e, x.low), np.full_like(like.e, x.high)))


def one_model(x: Intervals) -> Models:
    """One interval, to be used with any number of models."""
    return from_bounds(Intervals(np.reshape(x.low, 1), np.reshape(x.high, 1)))


def parameter(place: int, x: Intervals) -> Models:
    """The parameters x or y, the places 0 and 1, stretched so that they run over these intervals.

    Neighbours overlap: their ends were rounded outward, and so is the radius.
    """
    c = np.zeros((6, len(x.low)))
    c[0] = x.low / 2 + x.high / 2
    c[1 + place] = up(np.maximum(up(x.high - c[0]), up(c[0] - x.low)))
    return Models(c, np.zeros(len(x.low)), x)
