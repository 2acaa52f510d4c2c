"""Many intervals at once: arrays of lower and of upper ends, rounded outward.

IEEE 754 rounds +, -, *, / and roots of doubles correctly, so a step to the next double in the right
direction makes each end a bound; so do overflow, where the next double is the largest one, and
underflow. What has no value is NaN, and every comparison with NaN is false: each test must be one
that is true when something is proved.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Any

import numpy as np

#: An array of doubles, or of truth values.
Array = Any


def down(values: Array) -> Array:
    """The doubles below."""
    return np.nextafter(values, -np.inf)


def up(values: Array) -> Array:
    """The doubles above."""
    return np.nextafter(values, np.inf)


class Intervals:
    """Intervals [low, high], with the operations of numbers."""

    __slots__ = ("high", "low")

    def __init__(self, low: Array, high: Array) -> None:
        self.low, self.high = low, high

    def __add__(self, other: Any) -> Intervals:
        if isinstance(other, Intervals):
            return Intervals(down(self.low + other.low), up(self.high + other.high))
        return self if other == 0 else Intervals(down(self.low + other), up(self.high + other))

    __radd__ = __add__

    def __neg__(self) -> Intervals:
        return Intervals(-self.high, -self.low)

    def __sub__(self, other: Any) -> Any:
        return self + -other

    def __rsub__(self, other: Any) -> Any:
        return -self + other

    def __mul__(self, other: Any) -> Any:
        if not isinstance(other, Intervals):
            return self._times(other)
        a, b, c, d = self.low, self.high, other.low, other.high
        return _around(a * c, a * d, b * c, b * d)

    __rmul__ = __mul__

    def _times(self, whole: int) -> Any:
        if whole in (0, 1):
            return self if whole else 0
        return _around(self.low * whole, self.high * whole)

    def __truediv__(self, other: Any) -> Intervals:
        """The quotients; NaN where the divisor may be 0."""
        if not isinstance(other, Intervals):
            return _around(self.low / other, self.high / other)
        a, b, c, d = self.low, self.high, other.low, other.high
        found = _around(a / c, a / d, b / c, b / d)
        signed = (c > 0) | (d < 0)
        return Intervals(np.where(signed, found.low, np.nan), np.where(signed, found.high, np.nan))

    def __rtruediv__(self, other: int) -> Any:
        return 0 if other == 0 else self.like(other) / self

    def __pow__(self, exponent: int) -> Any:
        """The squares: other powers are products."""
        if exponent != 2:
            return self ** (exponent - 1) * self if exponent > 1 else self
        a, b = np.abs(self.low), np.abs(self.high)
        least = np.where((self.low <= 0) & (self.high >= 0), 0.0, np.minimum(a, b))
        most = np.maximum(a, b)
        return Intervals(np.maximum(down(least * least), 0.0), up(most * most))

    @property
    def hull(self) -> Intervals:
        """The intervals themselves."""
        return self

    def like(self, whole: int) -> Intervals:
        """A small whole number."""
        return Intervals(np.full_like(self.low, whole), np.full_like(self.low, whole))

    def root(self) -> Intervals:
        """The roots; NaN where a number may be negative."""
        return square_root(self)

    def root_of_share(self) -> Intervals:
        """The roots of those numbers that are in [0, 1]."""
        low, high = np.maximum(self.low, 0.0), np.minimum(self.high, 1.0)
        return square_root(Intervals(low, high))

    def above(self, least: Array) -> Intervals:
        """The same numbers where they are no less than that, which NaN does not say."""
        return Intervals(np.fmin(np.fmax(self.low, least), self.high), self.high)

    def __getitem__(self, chosen: Array) -> Intervals:
        return Intervals(self.low[chosen], self.high[chosen])

    @staticmethod
    def joined(parts: Sequence[Intervals]) -> Intervals:
        """One array after the other."""
        ends = ([part.low for part in parts], [part.high for part in parts])
        return Intervals(*map(np.concatenate, ends))


def _around(*ends: Array) -> Intervals:
    low, high = ends[0], ends[0]
    for end in ends[1:]:
        low, high = np.minimum(low, end), np.maximum(high, end)
    return Intervals(down(low), up(high))


def square_root(x: Intervals) -> Intervals:
    """The roots; NaN where a number may be negative."""
    return Intervals(np.maximum(down(np.sqrt(x.low)), 0.0), up(np.sqrt(x.high)))


def enclosed(value: Fraction) -> Intervals:
    """One interval around a rational number."""
    near = np.float64(value.numerator / value.denominator)
    if Fraction(float(near)) == value:
        return Intervals(near, near)
    return Intervals(down(near), up(near))


def all_enclosed(tops: Sequence[int], under: int) -> Intervals:
    """Intervals around rational numbers with one positive denominator."""
    near = [top / under for top in tops]
    ratios = zip(tops, (x.as_integer_ratio() for x in near), strict=True)
    exact, values = np.array([top * b == a * under for top, (a, b) in ratios]), np.array(near)
    return Intervals(np.where(exact, values, down(values)), np.where(exact, values, up(values)))


def exactly(values: Array) -> Intervals:
    """The doubles themselves."""
    return Intervals(values, values)


class IntervalsArithmetic:
    """The arithmetic of `verify.prover.program` on arrays of intervals."""

    def rational(self, value: Fraction) -> Intervals:
        """The interval around a rational number."""
        return enclosed(value)

    def operation(self, name: str) -> Callable[..., Any]:
        """The operation of this name."""
        return _OPERATIONS[name]


_OPERATIONS: dict[str, Callable[..., Any]] = {
    "add": lambda x, y: x + y,
    "sub": lambda x, y: x - y,
    "mul": lambda x, y: x * y,
    "div": lambda x, y: x / y,
    "neg": lambda x: -x,
}
