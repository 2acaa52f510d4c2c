"""Terms compiled into a straight-line program, run in any arithmetic.

Balls, the second opinion of the tests and exact rationals run the same program; only the table of
operations differs.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from fractions import Fraction
from functools import partial
from math import isqrt
from operator import add, mul, neg, sub

from verify.language.fold import fold
from verify.language.record import Any, Protocol
from verify.language.terms import FUNCTIONS, Term, atan


class UndefinedError(ArithmeticError):
    """An operation has no value in this arithmetic (or no finite enclosure at this precision)."""


class Arithmetic(Protocol):
    """An arithmetic: how to read an exact rational, and one function per operation."""

    def rational(self, value: Fraction) -> Any:
        """The number for an exact rational."""

    def operation(self, name: str) -> Callable[..., Any]:
        """The function of one or two numbers for an operation of `verify.language.terms`."""


_OPERATIONS = ("add", "sub", "mul", "div", "neg", *FUNCTIONS)


class Program:
    """A straight-line program with one slot for each distinct subterm; it may grow."""

    def __init__(self, inputs: Iterable[str]) -> None:
        self.slots: dict[str, int] = {name: slot for slot, name in enumerate(inputs)}
        self.size = len(self.slots)
        self.leaves: list[tuple[int, Fraction]] = []
        self.code: list[tuple[int, str, int, int]] = []
        self.cosines: list[int] = []
        self._slots: dict[Term, int] = {}
        self._numbering: dict[tuple[str, int, int], int] = {}
        self._algebra: dict[str, Callable[..., int]] = {
            "rational": self._rational,
            "symbol": self.slots.__getitem__,
            "pi": self._pi,
            "pow": self._power,
            "root": self._root,
            **{op: partial(self._least, op) for op in ("min", "max")},
            **{op: partial(self._instruction, op) for op in _OPERATIONS},
        }

    def define(self, name: str, term: Term) -> None:
        """Give a name to the value of a term over inputs and earlier names."""
        self.slots[name] = self.add(term)

    def add(self, term: Term) -> int:
        """Compile a term unless that was done before, and return its slot.

        Raises:
            KeyError: for a name that is neither an input nor defined.
        """
        return fold(term, self._algebra, self._slots)

    def known(self, term: Term) -> int | None:
        """The slot of a term that was compiled before."""
        return self._slots.get(term)

    def _rational(self, value: Fraction) -> int:
        slot = self._new_slot()
        self.leaves.append((slot, value))
        return slot

    def _root(self, slot: int, index: int) -> int:
        return self._instruction(f"root {index}", slot)

    def _pi(self) -> int:
        """Four times the angle whose tangent is 1."""
        return self.add(4 * atan(1))

    def _power(self, base: int, exponent: int) -> int:
        slot = base
        for _ in range(exponent - 1):
            slot = self._instruction("mul", slot, base)
        return slot

    def _least(self, op: str, slot: int, *others: int) -> int:
        for other in others:
            slot = self._instruction(op, slot, other)
        return slot

    def _instruction(self, op: str, left: int, right: int = -1) -> int:
        key = (op, left, right)
        slot = self._numbering.get(key)
        if slot is None:
            slot = self._numbering[key] = self._new_slot()
            self.code.append((slot, op, left, right))
            if op in ("cos", "sin"):
                self.cosines.append(left)
        return slot

    def _new_slot(self) -> int:
        self.size += 1
        return self.size - 1


class Machine:
    """A program bound to an arithmetic; `run` it on as many inputs as needed.

    The rationals of the program are read once. Where the arithmetic has a precision, machine and
    runs must be used at the same one.
    """

    def __init__(self, program: Program, arithmetic: Arithmetic) -> None:
        self.program = program
        self.arithmetic = arithmetic
        self.template: list[Any] = []
        self.code: list[tuple[int, Callable[..., Any], int, int]] = []
        self._leaves = 0

    def load(self) -> None:
        """Bind what the program has gained since the last call."""
        program = self.program
        self.template += [None] * (program.size - len(self.template))
        for slot, value in program.leaves[self._leaves :]:
            self.template[slot] = self.arithmetic.rational(value)
        self._leaves = len(program.leaves)
        for slot, op, left, right in program.code[len(self.code) :]:
            self.code.append((slot, self.arithmetic.operation(op), left, right))

    def run(self, inputs: Iterable[Any]) -> Run:
        """The values of the program for these inputs, in the program's order of inputs."""
        self.load()
        return Run(self, list(inputs))


class Run:
    """The values of all slots for one choice of inputs; None where a value is undefined."""

    def __init__(self, machine: Machine, inputs: list[Any]) -> None:
        self._machine = machine
        self.values = inputs + machine.template[len(inputs) :]
        self._done = 0
        self._execute()

    def _execute(self) -> None:
        values = self.values
        code = self._machine.code
        for slot, function, left, right in code[self._done :] if self._done else code:
            a = values[left]
            if a is None:
                continue
            try:
                if right < 0:
                    values[slot] = function(a)
                elif (b := values[right]) is not None:
                    values[slot] = function(a, b)
            except UndefinedError:
                pass
        self._done = len(code)

    def __getitem__(self, term: Term) -> Any:
        """The value of a term, or None where it is undefined."""
        slot = self._machine.program.add(term)
        if slot >= len(self.values):
            self._machine.load()
            self.values += self._machine.template[len(self.values) :]
            self._execute()
        return self.values[slot]


class ExactArithmetic:
    """Rational numbers; a square root exists where it is rational, a cosine never.

    A number whose numerator and denominator together have more than ``max_bits`` has no value.
    """

    def __init__(self, max_bits: int = 2**19) -> None:
        self._max_bits = max_bits

    def rational(self, value: Fraction) -> Fraction | None:
        """The number itself."""
        return value if self._is_short(value) else None

    def operation(self, name: str) -> Callable[..., Fraction | None]:
        """The exact operation of this name."""
        function = _EXACT.get(name, _irrational)

        def short(*operands: Fraction) -> Fraction | None:
            value = function(*operands)
            return value if self._is_short(value) else None

        return short

    def _is_short(self, value: Fraction) -> bool:
        return value.numerator.bit_length() + value.denominator.bit_length() <= self._max_bits


def _divide(a: Fraction, b: Fraction) -> Fraction:
    if b == 0:
        raise UndefinedError("division by zero")
    return a / b


def _root(a: Fraction) -> Fraction:
    if a < 0:
        raise UndefinedError("the square root of a negative number")
    root = Fraction(isqrt(a.numerator), isqrt(a.denominator))
    if root * root != a:
        raise UndefinedError("an irrational square root")
    return root


def _irrational(*_operands: Fraction) -> Fraction:
    raise UndefinedError("an operation that leaves the rational numbers")


_EXACT: dict[str, Callable[..., Fraction]] = {
    "add": add,
    "sub": sub,
    "mul": mul,
    "neg": neg,
    "div": _divide,
    "sqrt": _root,
    "min": min,
    "max": max,
}
