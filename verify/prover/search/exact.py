"""Intervals between rational numbers, rounded outward to the precision that a proof names.

Leaves that floats leave open are decided by them. They have the ends that `verify/check.py`
computes, or for exp, log and atan ends a little further out, so that what they show the checker
accepts, also where two sides meet: a test compares the two on many terms.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from functools import cached_property, partial

from verify.language.fold import fold
from verify.language.terms import Term
from verify.prover.balls import floor_root, value_around

Range = tuple[Fraction, Fraction]

#: More bits, in which the series of a cosine is added up.
GUARD_BITS = 32
#: The checker encloses no exponentials of larger numbers.
MAX_EXPONENT = 1 << 16
#: Nor does it read numbers of so many bits.
MAX_SHIFT = 1 << 19


class ExactRanges:
    """Intervals around terms, for ends of variables; ``definitions`` has the other names."""

    def __init__(self, names: Sequence[str], definitions: Mapping[str, Term], bits: int) -> None:
        self._names, self._definitions, self._bits = tuple(names), definitions, bits
        operations: dict[str, Callable[..., Range]] = {
            "rational": lambda value: (value, value),
            "add": lambda x, y: (x[0] + y[0], x[1] + y[1]),
            "sub": lambda x, y: (x[0] - y[1], x[1] - y[0]),
            "neg": lambda x: (-x[1], -x[0]),
            "mul": _product,
            "div": _quotient,
            "pow": self._power,
            "sqrt": self._root,
            "min": lambda *xs: (min(x[0] for x in xs), min(x[1] for x in xs)),
            "max": lambda *xs: (max(x[0] for x in xs), max(x[1] for x in xs)),
            "cos": lambda x: self._cos_pi(self._outward(_quotient(x, self._pi))),
            "cos_pi": self._cos_pi,
            "sin": lambda x: self._cos_pi(self._outward(self._turned(x))),
            "pi": lambda: self._pi,
            "root": self._root,
            **{op: partial(self._rising, op) for op in ("exp", "log", "atan")},
        }
        self._algebra = {name: self._rounded(function) for name, function in operations.items()}

    def of(self, ends: Sequence[Range], *terms: Term) -> list[Range] | None:
        """The intervals of terms; None where one may have no value."""
        given = dict(zip(self._names, ends, strict=True))
        known: dict[Term, Range] = {}

        def named(name: str) -> Range:
            if name in given:
                return given[name]
            return fold(self._definitions[name], algebra, known)

        algebra = {**self._algebra, "symbol": named}
        try:
            return [fold(term, algebra, known) for term in terms]
        except ZeroDivisionError:
            return None

    # --- rounding -------------------------------------------------------------------------------

    def _rounded(self, function: Callable[..., Range]) -> Callable[..., Range]:
        return lambda *operands: self._outward(function(*operands))

    def product(self, x: Range, y: Range) -> Range:
        """The interval of a product."""
        return self._outward(_product(x, y))

    def _outward(self, x: Range) -> Range:
        return self.below(x[0]), -self.below(-x[1])

    def below(self, end: Fraction) -> Fraction:
        """The number, or one with fewer bits that is a little smaller."""
        n, d = end.numerator, end.denominator
        if n.bit_length() + d.bit_length() <= 2 * self._bits:
            return end
        shift = self._bits - n.bit_length() + d.bit_length()
        if abs(shift) > MAX_SHIFT:
            raise ZeroDivisionError("a number is too long for the checker")
        if shift < 0:
            return Fraction(n // (d << -shift) << -shift)
        return Fraction((n << shift) // d, 1 << shift)

    # --- operations that need the precision -----------------------------------------------------

    def _power(self, x: Range, exponent: int) -> Range:
        """Odd powers rise; an even power is that of the absolute value, and rises with it."""
        low, high = x
        if exponent % 2 == 0 and low < 0:
            low, high = max(Fraction(0), -high), max(-low, high)
        return self._powers(low, exponent)[0], self._powers(high, exponent)[1]

    def _powers(self, end: Fraction, exponent: int) -> Range:
        if exponent == 1:
            return end, end
        half = self._outward(self._powers(end, exponent // 2))
        square = _product(half, half)
        return _product(square, (end, end)) if exponent % 2 else square

    def _root(self, x: Range, index: int = 2) -> Range:
        if x[0] < 0:
            raise ZeroDivisionError("the root of an interval that reaches below 0")
        ends = []
        for n, d in map(Fraction.as_integer_ratio, x):
            power = n * d ** (index - 1) << index * self._bits
            root = floor_root(power, index)
            ends.append((root, root + (root**index < power), d << self._bits))
        (low, _, below), (_, high, above) = ends
        return Fraction(low, below), Fraction(high, above)

    def _rising(self, op: str, x: Range) -> Range:
        """exp, log or atan at both ends, with a margin for the series that the checker adds up."""
        (low, _), (_, high) = (self._risen(op, end) for end in x)
        return low, high

    def _risen(self, op: str, end: Fraction) -> Range:
        if end == (1 if op == "log" else 0):
            return (Fraction(op == "exp"),) * 2
        if (op == "log" and end <= 0) or (op == "exp" and abs(end) > MAX_EXPONENT):
            raise ZeroDivisionError(f"{op} of {end}")
        return value_around(op, end, self._bits)

    def _turned(self, x: Range) -> Range:
        low, high = _quotient(x, self._pi)
        return Fraction(1, 2) - high, Fraction(1, 2) - low

    def _cos_pi(self, x: Range) -> Range:
        """The extremes are at the ends, and at integers."""
        first = -(-x[0] // 1)
        values = [self._cosine(end) for end in x]
        values += [(Fraction((-1) ** (k % 2)),) * 2 for k in (first, first + 1) if k <= x[1]]
        return min(low for low, _ in values), max(high for _, high in values)

    def _cosine(self, x: Fraction) -> Range:
        """cos(pi x) by its series around 0, after a shift by an even number into [-1, 1]."""
        angle = x - (x + 1) // 2 * 2
        if angle.denominator <= 2:
            return 1 - 2 * abs(angle), 1 - 2 * abs(angle)
        unit = 1 << self._bits + GUARD_BITS
        low, high = self._power(_product((angle, angle), self._pi), 2)
        square = low * unit // 1, -(-high * unit // 1)
        t = unit, unit
        for k in range(self._bits // 2 + 11, 0, -1):
            ends = [a * b for a in square for b in t]
            divisor = 2 * k * (2 * k - 1) * unit
            t = unit + -max(ends) // divisor, unit - min(ends) // divisor
        rest = unit >> self._bits
        least, most = Fraction(t[0] - rest, unit), Fraction(t[1] + rest, unit)
        return max(least, Fraction(-1)), min(most, Fraction(1))

    @cached_property
    def _pi(self) -> Range:
        """Machin: pi = 16 arctan(1/5) - 4 arctan(1/239), each an alternating series."""
        unit, total, error = 1 << self._bits + GUARD_BITS, 0, 0
        for factor, n in ((16, 5), (-4, 239)):
            power, k = unit // n, 0
            while power:
                total += factor * (-1) ** k * (power // (2 * k + 1))
                power, k = power // (n * n), k + 1
            error += abs(factor) * (k + 1)
        return Fraction(total - error, unit), Fraction(total + error, unit)


def _product(x: Range, y: Range) -> Range:
    if x[0] >= 0 and y[0] >= 0:
        return x[0] * y[0], x[1] * y[1]
    ends = [a * b for a in x for b in y]
    return min(ends), max(ends)


def _quotient(x: Range, y: Range) -> Range:
    if y[0] <= 0 <= y[1]:
        raise ZeroDivisionError("a division by an interval that contains 0")
    return _product(x, (1 / y[1], 1 / y[0]))
