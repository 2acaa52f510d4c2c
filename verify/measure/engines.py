"""The same programs in four arithmetics: Arb, the checker's own, mpmath's `iv`, plain doubles.

Each engine is an arithmetic of `verify.prover.program` together with the exact ends of its numbers.
The double engine has no error bound: its two ends are the same number, and that is the point.
"""

from __future__ import annotations

import math
import operator
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from fractions import Fraction
from typing import Any

from verify import check
from verify.prover import balls
from verify.prover.outcome import Ends
from verify.prover.program import Machine, Program, UndefinedError

#: Before the index, in the name of the operation of a root.
ROOT = "root "


class ArbEngine(balls.BallArithmetic):
    """Ball arithmetic of FLINT."""

    name = "Arb"

    def ends(self, value: Any) -> Ends:
        """The ends of a ball."""
        return balls.ends(value)

    def at(self, bits: int) -> Any:
        """Set the precision of flint inside a ``with``."""
        return balls.precision(bits)


class CheckerEngine:
    """The interval arithmetic of `verify/check.py`, on fractions with bounded numerators."""

    name = "checker"

    def __init__(self) -> None:
        self._enclosing = _enclosing(53)

    def rational(self, value: Fraction) -> check.Interval:
        """An interval around an exact rational."""
        return self._enclosing.outward(check.Interval(value, value))

    def operation(self, name: str) -> Callable[..., check.Interval]:
        """The checker's operation of this name."""
        enclosing = self._enclosing
        function: Callable[..., check.Interval] = check.Enclosing.root
        index = [int(name.removeprefix(ROOT))] if name.startswith(ROOT) else []
        if not index:
            function = check.OPERATIONS[name]

        def apply(*operands: check.Interval) -> check.Interval:
            try:
                return enclosing.outward(function(enclosing, *operands, *index))
            except check.Refused as error:
                raise UndefinedError(str(error)) from error

        return apply

    def ends(self, value: check.Interval) -> Ends:
        """The ends of the interval."""
        return value.low, value.high

    @contextmanager
    def at(self, bits: int) -> Iterator[None]:
        """Work with so many bits inside a ``with``; the counting of work begins anew."""
        saved, self._enclosing = self._enclosing, _enclosing(bits)
        try:
            yield
        finally:
            self._enclosing = saved


def _enclosing(bits: int) -> check.Enclosing:
    """The checker's arithmetic at a number of bits, in an empty kernel."""
    return check.Enclosing(check.Kernel(), bits, None)


class MpmathEngine:
    """mpmath's interval context: good for + - * / and square roots, and used for nothing else."""

    name = "mpmath iv"

    def __init__(self) -> None:
        from mpmath import iv  # loaded only where it is used

        self._iv = iv

    def rational(self, value: Fraction) -> Any:
        """An interval around an exact rational."""
        return self._iv.mpf(value.numerator) / self._iv.mpf(value.denominator)

    def operation(self, name: str) -> Callable[..., Any]:
        """The interval operation of this name."""
        table: dict[str, Callable[..., Any]] = {
            "add": operator.add,
            "sub": operator.sub,
            "mul": operator.mul,
            "div": self._divide,
            "neg": operator.neg,
            "sqrt": self._sqrt,
            "min": lambda a, b: self._iv.mpf([min(a.a, b.a), min(a.b, b.b)]),
            "max": lambda a, b: self._iv.mpf([max(a.a, b.a), max(a.b, b.b)]),
        }
        return table[name]

    def _divide(self, a: Any, b: Any) -> Any:
        if not (b.a > 0 or b.b < 0):
            raise UndefinedError("division by an interval that contains 0")
        return a / b

    def _sqrt(self, a: Any) -> Any:
        if not a.a >= 0:
            raise UndefinedError("square root of an interval below 0")
        return self._iv.sqrt(a)

    def ends(self, value: Any) -> Ends:
        """The ends of an interval."""
        low, high = (_exact(end) for end in value._mpi_)
        return low, high

    @contextmanager
    def at(self, bits: int) -> Iterator[None]:
        """Set the precision of the interval context inside a ``with``."""
        saved, self._iv.prec = self._iv.prec, bits
        try:
            yield
        finally:
            self._iv.prec = saved


def _exact(end: tuple[int, int, int, int]) -> Fraction:
    sign, mantissa, exponent, _ = end
    return Fraction(-int(mantissa) if sign else int(mantissa)) * Fraction(2) ** exponent


class DoubleEngine:
    """What an ordinary script computes: IEEE doubles, rounded to nearest, no enclosure."""

    name = "double"

    def rational(self, value: Fraction) -> float:
        """The nearest double."""
        return float(value)

    def operation(self, name: str) -> Callable[..., float]:
        """The operation of this name on doubles."""
        table: dict[str, Callable[..., float]] = {
            "add": operator.add,
            "sub": operator.sub,
            "mul": operator.mul,
            "div": _float_division,
            "neg": operator.neg,
            "sqrt": _float_sqrt,
            "min": min,
            "max": max,
            "cos_pi": lambda x: math.cos(math.pi * x),
            **{op: getattr(math, op) for op in ("cos", "sin", "exp", "log", "atan")},
        }
        if name.startswith(ROOT):
            return lambda x: math.pow(x, 1 / int(name.removeprefix(ROOT)))
        return table[name]

    def ends(self, value: float) -> Ends:
        """The double itself, twice."""
        if not math.isfinite(value):
            raise UndefinedError("not a finite double")
        return Fraction(value), Fraction(value)

    @contextmanager
    def at(self, _bits: int) -> Iterator[None]:
        """Doubles have 53 bits whatever is asked."""
        yield


def _float_division(a: float, b: float) -> float:
    if b == 0:
        raise UndefinedError("division by zero")
    return a / b


def _float_sqrt(a: float) -> float:
    if a < 0:
        raise UndefinedError("square root of a negative number")
    return math.sqrt(a)


def load(program: Program, engine: Any) -> Machine:
    """The program bound to an engine, which must be at its working precision."""
    machine = Machine(program, engine)
    machine.load()
    return machine
