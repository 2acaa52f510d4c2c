"""Enclosures over a whole cell of parameters: balls, sharpened by the mean value theorem.

A value of the program is a function f of the parameters on a cell. It is kept as a ball around f
at the cell's centre, a ball around f on the cell, and balls around the partial derivatives on the
cell. By the mean value theorem f on the cell lies in

    f(centre) + sum of (derivative ball) * (parameter - centre),

whose width shrinks with the square of the cell's, while that of plain balls shrinks linearly and
grows with each repeated occurrence of a parameter. Both enclosures hold, so their intersection
does. A min or max is not differentiable where two entries meet; it is Lipschitz, and the theorem
holds with the hull of the entries' derivatives in place of the derivative.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import partial
from operator import add, sub

from verify.language.record import Record
from verify.prover import balls
from verify.prover.balls import Ball
from verify.prover.program import UndefinedError

#: Bits that are plenty for covers: their boxes are far wider than 2^-64.
BITS = 64

Side = tuple[Fraction, Fraction]
Slopes = tuple[Ball, ...]


class Slope(Record):
    """A function on a cell; ``slopes`` is None where no derivative is known."""

    centre: Ball
    range: Ball
    slopes: Slopes | None


class SlopeArithmetic:
    """The arithmetic of `verify.prover.program` on functions of the parameters of one cell.

    ``inputs`` are the parameters themselves.
    """

    def __init__(self, cell: Sequence[Side]) -> None:
        self._operations: dict[str, Callable[..., Slope]] = {
            "add": partial(self._linear, add),
            "sub": partial(self._linear, sub),
            "mul": self._mul,
            "div": self._div,
            "neg": self._neg,
            "sqrt": self._sqrt,
            "min": self._min,
            "max": self._max,
        }
        zero, one = (balls.from_fraction(Fraction(n)) for n in (0, 1))
        self._flat = (zero,) * len(cell)
        self._offsets = []
        self.inputs = []
        for index, (low, high) in enumerate(cell):
            centre = balls.from_fraction((low + high) / 2)
            side = balls.hull(balls.from_fraction(low), balls.from_fraction(high))
            slopes = tuple(one if i == index else zero for i in range(len(cell)))
            self.inputs.append(Slope(centre, side, slopes))
            self._offsets.append(side - centre)

    def rational(self, value: Fraction) -> Slope:
        """The constant function."""
        ball = balls.from_fraction(value)
        return Slope(ball, ball, self._flat)

    def operation(self, name: str) -> Callable[..., Slope]:
        """The operation of this name; a cosine has none, as no cover needs it."""
        if name not in self._operations:
            raise UndefinedError(f"no slopes for {name}")
        return self._operations[name]

    def _sharpened(self, centre: Ball, plain: Ball, slopes: Slopes | None) -> Slope:
        if slopes is None:
            return Slope(centre, plain, None)
        total = centre
        for slope, offset in zip(slopes, self._offsets, strict=True):
            total = total + slope * offset
        return Slope(centre, plain.intersection(total), slopes)

    def _linear(self, operation: Callable[[Ball, Ball], Ball], a: Slope, b: Slope) -> Slope:
        if a.slopes is None or b.slopes is None:
            slopes = None
        elif b.slopes is self._flat:
            slopes = a.slopes
        else:
            slopes = tuple(map(operation, a.slopes, b.slopes))
        centre, whole = operation(a.centre, b.centre), operation(a.range, b.range)
        return self._sharpened(centre, whole, slopes)

    def _neg(self, a: Slope) -> Slope:
        slopes = None if a.slopes is None else tuple([-x for x in a.slopes])
        return Slope(-a.centre, -a.range, slopes)

    def _mul(self, a: Slope, b: Slope) -> Slope:
        f, g = a.range, b.range
        if a.slopes is None or b.slopes is None:
            slopes = None
        elif a.slopes is self._flat:
            slopes = tuple([f * y for y in b.slopes])
        elif b.slopes is self._flat:
            slopes = tuple([x * g for x in a.slopes])
        else:
            slopes = tuple([x * g + f * y for x, y in zip(a.slopes, b.slopes, strict=True)])
        return self._sharpened(a.centre * b.centre, _product(f, g), slopes)

    def _div(self, a: Slope, b: Slope) -> Slope:
        g = b.range
        quotient = _finite(_quotient(a.range, g))
        if a.slopes is None or b.slopes is None:
            slopes = None
        elif b.slopes is self._flat:
            slopes = tuple([x / g for x in a.slopes])
        else:
            pairs = zip(a.slopes, b.slopes, strict=True)
            slopes = tuple([(x - quotient * y) / g for x, y in pairs])
        return self._sharpened(_finite(a.centre / b.centre), quotient, slopes)

    def _sqrt(self, a: Slope) -> Slope:
        root = _finite(a.range.sqrt())
        slopes = None
        if a.slopes is not None and root > 0:
            twice = root + root
            slopes = tuple([x / twice for x in a.slopes])
        return self._sharpened(_finite(a.centre.sqrt()), root, slopes)

    def _min(self, a: Slope, b: Slope) -> Slope:
        if balls.less_equal(a.range, b.range):
            return a
        if balls.less_equal(b.range, a.range):
            return b
        slopes = None
        if a.slopes is not None and b.slopes is not None:
            pairs = zip(a.slopes, b.slopes, strict=True)
            slopes = tuple([balls.hull(x, y) for x, y in pairs])
        return self._sharpened(Ball.min(a.centre, b.centre), Ball.min(a.range, b.range), slopes)

    def _max(self, a: Slope, b: Slope) -> Slope:
        return self._neg(self._min(self._neg(a), self._neg(b)))


def _finite(ball: Ball) -> Ball:
    """The result of an operation that can leave the real numbers; all others stay finite."""
    if not ball.is_finite():
        raise UndefinedError("a value is not finite on this cell")
    return ball


def _product(a: Ball, b: Ball) -> Ball:
    """The product; that of positive numbers by its ends, as balls would make it wider."""
    if a >= 0 and b >= 0:
        return balls.hull(a.lower() * b.lower(), a.upper() * b.upper())
    return a * b


def _quotient(a: Ball, b: Ball) -> Ball:
    """The quotient, in the same way."""
    if a >= 0 and b > 0:
        return balls.hull(a.lower() / b.upper(), a.upper() / b.lower())
    return a / b
