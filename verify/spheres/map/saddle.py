"""The limiting map, what becomes of one collision as -eta_c goes to 0, and its saddle.

The map is one of (φ1, φ2) that depends on r and C; the saddle is enclosed by an interval Newton
step in balls.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

from verify.language.record import Record
from verify.prover import balls
from verify.spheres.flow.law import Number
from verify.spheres.map.planes import Phi

Ends = tuple[Fraction, Fraction]
BITS, ROUNDS = 192, 60
#: The radius of the square in which the saddle is shown to be.
RADIUS = Fraction(1, 10**20)


def has_limit(plane: Phi) -> bool:
    """Whether one map is the limit at every collision: the tangential speeds are the same."""
    u_c, u_s = plane.tangential
    return u_c**2 == u_s**2


def limit_map(
    plane: Phi,
    phi_1: Number,
    phi_2: Number,
    number: Callable[[Fraction], Number],
    root: Callable[[Number], Number],
) -> tuple[Number, Number]:
    """The ratios after the next collision, by the law without its terms that have η or d."""
    r, C, A = number(plane.r), number(plane.neg_cos), number(plane.tangential[0] ** 2)
    s = root(1 - 2 * A * phi_2)
    T = 2 * phi_2 / (1 + s)
    ratio = (1 + r) / 2 * s * C - phi_1 - A * T
    return r * s / ratio, (phi_1 * T + A * T * T / 2) / (ratio * ratio)


class Saddle(Record):
    """A fixed point, the only one within 10^-20; a multiplier is above 1, the other in ]-1,1[."""

    phi_1: Ends
    phi_2: Ends
    stable: Ends
    unstable: Ends


class Slopes:
    """A number that depends on (φ1, φ2), with its two derivatives."""

    def __init__(self, value: Any, d_1: Any, d_2: Any) -> None:
        self.value, self.d = value, (d_1, d_2)

    def _with(self, value: Any, f: Callable[[Any], Any]) -> Slopes:
        return Slopes(value, *map(f, self.d))

    def __add__(self, other: Any) -> Slopes:
        o = _slopes(other)
        return Slopes(self.value + o.value, *(a + b for a, b in zip(self.d, o.d, strict=True)))

    __radd__ = __add__

    def __sub__(self, other: Any) -> Any:
        return self + _slopes(other) * -1

    def __rsub__(self, other: Any) -> Any:
        return self * -1 + other

    def __mul__(self, other: Any) -> Slopes:
        o = _slopes(other)
        both = zip(self.d, o.d, strict=True)
        return Slopes(self.value * o.value, *(a * o.value + self.value * b for a, b in both))

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> Slopes:
        o = _slopes(other)
        inverse = 1 / o.value
        return self * o._with(inverse, lambda d: d * (inverse * inverse) * -1)

    def root(self) -> Slopes:
        """The root."""
        q = balls.root(self.value)
        return self._with(q, lambda d: d / (2 * q))


def _slopes(x: Any) -> Slopes:
    return x if isinstance(x, Slopes) else Slopes(balls.from_fraction(Fraction(0)) + x, 0, 0)


def _at(plane: Phi, x: Any, y: Any) -> tuple[Slopes, Slopes]:
    """The map less the identity."""
    one, none = balls.from_fraction(Fraction(1)), balls.from_fraction(Fraction(0))
    q, k = Slopes(x, one, none), Slopes(y, none, one)
    after = limit_map(plane, q, k, balls.from_fraction, lambda z: z.root())
    return after[0] - q, after[1] - k


def _newton(plane: Phi, x: Any, y: Any, wide: tuple[Any, Any]) -> tuple[Any, Any]:
    """The middle less the inverse of the slopes over a square, times the value at the middle."""
    f, g = (z.value for z in _at(plane, x, y))
    (a, b), (c, d) = (z.d for z in _at(plane, *wide))
    under = a * d - b * c
    return x - (d * f - b * g) / under, y - (a * g - c * f) / under


def saddle(plane: Phi) -> Saddle | None:
    """The saddle of the limiting map; None if it is not found, or is none."""
    if not has_limit(plane):
        return None
    scale = plane.tangential[0] ** 2 or Fraction(1)
    for start in ((10, 3), (15, 2), (10, 7), (5, 1), (20, 5)):
        first, second = Fraction(start[0], 100), Fraction(start[1], 100) / scale
        with balls.precision(BITS):
            try:
                found = _from(plane, balls.from_fraction(first), balls.from_fraction(second))
            except ArithmeticError:
                continue
        if found is not None:
            return found
    return None


def _from(plane: Phi, x: Any, y: Any) -> Saddle | None:
    for _ in range(ROUNDS):
        x, y = (balls.middle(z) for z in _newton(plane, x, y, (x, y)))
    radius = balls.from_fraction(RADIUS)
    square = tuple(balls.hull(z - radius, z + radius) for z in (x, y))
    inner = _newton(plane, x, y, (square[0], square[1]))
    if not all(balls.inside(a, b) for a, b in zip(inner, square, strict=True)):
        return None
    (a, b), (c, d) = (z.d for z in _at(plane, *inner))
    trace, product = a + d + 2, (a + 1) * (d + 1) - b * c
    spread = balls.root(trace * trace - 4 * product)
    stable, unstable = (trace - spread) / 2, (trace + spread) / 2
    if not (unstable > 1 and stable < 1 and stable > -1 and inner[0] > 0 and inner[1] > 0):
        return None
    return Saddle(*map(balls.ends, (*inner, stable, unstable)))
