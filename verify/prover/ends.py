"""Intervals by their two ends, each a ball: sharper on a box than one ball around all of it."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

from verify.prover import balls
from verify.prover.balls import Ball
from verify.prover.program import UndefinedError

BallEnds = tuple[Ball, Ball]


def ends_between(low: Fraction, high: Fraction) -> BallEnds:
    """The interval between two numbers, at the current precision."""
    return balls.from_fraction(low), balls.from_fraction(high)


class EndsArithmetic:
    """The arithmetic of `verify.prover.program` on intervals."""

    def rational(self, value: Fraction) -> Any:
        """The interval around an exact rational."""
        ball = balls.from_fraction(value)
        return ball, ball

    def operation(self, name: str) -> Callable[..., BallEnds]:
        """The operation of this name."""
        return _OPERATIONS.get(name) or _by_ball(name)


def _add(x: BallEnds, y: BallEnds) -> BallEnds:
    return x[0] + y[0], x[1] + y[1]


def _sub(x: BallEnds, y: BallEnds) -> BallEnds:
    return x[0] - y[1], x[1] - y[0]


def _neg(x: BallEnds) -> BallEnds:
    return -x[1], -x[0]


def _mul(x: BallEnds, y: BallEnds) -> BallEnds:
    (a, b), (c, d) = x, y
    if a >= 0 and c >= 0:
        return a * c, b * d
    if x is y:
        return _square(x)
    ends = a * c, a * d, b * c, b * d
    least = most = ends[0]
    for end in ends[1:]:
        least, most = least.min(end), most.max(end)
    return least, most


def _square(x: BallEnds) -> BallEnds:
    a, b = x[0] * x[0], x[1] * x[1]
    if x[1] <= 0:
        return b, a
    return balls.from_fraction(Fraction(0)), a.max(b)


def _div(x: BallEnds, y: BallEnds) -> BallEnds:
    if not (y[0] > 0 or y[1] < 0):
        raise UndefinedError("a division by an interval that contains 0")
    return _mul(x, (1 / y[1], 1 / y[0]))


def _sqrt(x: BallEnds) -> BallEnds:
    if not x[0] >= 0:
        raise UndefinedError("the square root of an interval that reaches below 0")
    return x[0].sqrt(), x[1].sqrt()


def _min(x: BallEnds, y: BallEnds) -> BallEnds:
    return x[0].min(y[0]), x[1].min(y[1])


def _max(x: BallEnds, y: BallEnds) -> BallEnds:
    return x[0].max(y[0]), x[1].max(y[1])


def _by_ball(name: str) -> Callable[..., BallEnds]:
    """An operation on one interval, by the ball around it."""
    function = balls.BallArithmetic().operation(name)

    def enclosed(x: BallEnds) -> BallEnds:
        low, high = balls.ends(function(balls.hull(*x)))
        return ends_between(low, high)

    return enclosed


_OPERATIONS: dict[str, Callable[..., BallEnds]] = {
    "add": _add,
    "sub": _sub,
    "neg": _neg,
    "mul": _mul,
    "div": _div,
    "sqrt": _sqrt,
    "min": _min,
    "max": _max,
}
