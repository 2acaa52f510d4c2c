"""Bernstein coefficients of a polynomial in several variables on a box.

On a box with sides [a_i, b_i] a polynomial p of degree n_i in x_i is

    p(x) = sum_k B_k prod_i binomial(n_i, k_i) ((x_i - a_i)/(b_i - a_i))^k_i
                                               ((b_i - x_i)/(b_i - a_i))^(n_i - k_i),

so that it is >= 0 if no B_k is negative. The corners of B are values of p.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import pairwise
from math import comb, prod

from flint import fmpq, fmpq_mpoly

from verify.language.record import Record
from verify.prover.proof import Value
from verify.prover.search.numbers import fmpq_of, fraction_of

Ends = tuple[Fraction, Fraction]


class Side(Record):
    """The ends of a variable, the facts that say so, and whether they are strict."""

    ends: Ends
    facts: tuple[str, str]
    strict: tuple[bool, bool]

    def cut(self, at: Fraction, fact: str) -> tuple[Side, Side]:
        """The sides below and above a number, which a hypothesis says."""
        (low, high), (below, above), (first, last) = self
        return (
            Side((low, at), (below, fact), (first, False)),
            Side((at, high), (fact, above), (False, last)),
        )


class Tensor(Record):
    """The degrees in all variables, and the coefficients in the order of the last index."""

    degrees: tuple[int, ...]
    coefficients: list[fmpq]

    @classmethod
    def of(cls, p: fmpq_mpoly, ends: Sequence[Ends]) -> Tensor:
        """The coefficients of p on a box."""
        degrees = tuple(max(int(d), 0) for d in p.degrees())
        table = [fmpq(0)] * prod(d + 1 for d in degrees)
        for exponents, value in p.to_dict().items():
            place = 0
            for e, degree in zip(exponents, degrees, strict=True):
                place = place * (degree + 1) + int(e)
            table[place] = value
        tensor = cls(degrees, table)
        for index, (degree, (low, high)) in enumerate(zip(degrees, ends, strict=True)):
            rows = [_row(e, degree, low, high) for e in range(degree + 1)]
            for places in tensor._lines(index):
                old = [table[place] for place in places]
                for k, place in enumerate(places):
                    terms = (c * row[k] for c, row in zip(old, rows, strict=True))
                    table[place] = sum(terms, fmpq(0))
        return tensor

    def _lines(self, index: int) -> Iterator[range]:
        """The places that differ in one index only."""
        stride = prod(d + 1 for d in self.degrees[index + 1 :])
        count = self.degrees[index] + 1
        for start in range(0, len(self.coefficients), stride * count):
            for offset in range(start, start + stride):
                yield range(offset, offset + stride * count, stride)

    def corners(self) -> Iterator[fmpq]:
        """The values of p at the corners of the box."""
        places = [0]
        for degree in self.degrees:
            places = [place * (degree + 1) + k for place in places for k in (0, degree)]
        return (self.coefficients[place] for place in places)

    def halves(self, index: int, share: Fraction) -> tuple[Tensor, Tensor]:
        """The tensors below and above a cut of one side (de Casteljau)."""
        if not self.degrees[index]:
            return self, self
        below, above = [*self.coefficients], [*self.coefficients]
        part = fmpq_of(share)
        for places in self._lines(index):
            row = [self.coefficients[place] for place in places]
            for step, place in enumerate(places):
                below[place], above[places[-1 - step]] = row[0], row[-1]
                row = [a + part * (b - a) for a, b in pairwise(row)]
        return Tensor(self.degrees, below), Tensor(self.degrees, above)

    # --- proofs ---------------------------------------------------------------------------------

    def addends(self, sides: Sequence[Side], *, strict: bool) -> list[Value] | None:
        """Values >= 0, one > 0 if that is asked for, that add up to p times a number.

        The number is `scale`. None if a coefficient is negative, or nothing is seen to be > 0.
        """
        least = min(self.coefficients)
        if least < 0 or (strict and least == 0 and not self._is_strict(sides)):
            return None
        addends: list[Value] = []
        rest = self.coefficients
        if strict and least > 0:
            rest = [value - least for value in rest]
            addends.append(str(fraction_of(least) * self.scale(sides)))
        value = self._value(rest, sides, 0, Fraction(1))
        return addends if value is None else [*addends, value]

    def units(self) -> int:
        """About the work of the checker for such a sum."""
        bits = 2 * max(value.height_bits() for value in self.coefficients)
        each = 2 + (bits >> 8) + (bits * bits >> 20)
        return 500 + 10 * each * len(self.coefficients) * sum(d + 1 for d in self.degrees if d)

    def scale(self, sides: Sequence[Side]) -> Fraction:
        """The product of the widths of the sides, as often as their degrees say."""
        widths = (side.ends[1] - side.ends[0] for side in sides)
        return prod((w**d for w, d in zip(widths, self.degrees, strict=True)), start=Fraction(1))

    def _is_strict(self, sides: Sequence[Side]) -> bool:
        """Whether a positive coefficient has only factors that are positive."""
        for place, value in enumerate(self.coefficients):
            if value > 0:
                good, left = True, place
                for degree, side in zip(self.degrees[::-1], sides[::-1], strict=True):
                    left, k = divmod(left, degree + 1)
                    good &= (side.strict[0] or k == 0) and (side.strict[1] or k == degree)
                if good:
                    return True
        return False

    def _value(
        self, coefficients: list[fmpq], sides: Sequence[Side], index: int, factor: Fraction
    ) -> Value | None:
        """The sum over the indices from this one on; None for 0."""
        if index == len(self.degrees):
            number = fraction_of(coefficients[0]) * factor
            return str(number) if number else None
        degree = self.degrees[index]
        size, values = len(coefficients) // (degree + 1), list[Value]()
        for k in range(degree + 1):
            inner = coefficients[k * size : (k + 1) * size]
            value = self._value(inner, sides, index + 1, factor * comb(degree, k))
            if value is not None:
                low, high = sides[index].facts
                powers = [p for p in (_power(low, k), _power(high, degree - k)) if p]
                values.append(("mul", value, *powers) if powers else value)
        return None if not values else values[0] if len(values) == 1 else ("add", *values)


def _power(fact: str, exponent: int) -> Value:
    return fact if exponent == 1 else ("pow", fact, exponent) if exponent else ""


def _row(exponent: int, degree: int, low: Fraction, high: Fraction) -> list[fmpq]:
    """The coefficients of x^exponent on [low, high]: mixed products of the ends (blossoms)."""
    found = []
    for k in range(degree + 1):
        products = (
            comb(k, j) * comb(degree - k, exponent - j) * high**j * low ** (exponent - j)
            for j in range(max(0, exponent - degree + k), min(k, exponent) + 1)
        )
        found.append(fmpq_of(sum(products, Fraction(0)) / comb(degree, exponent)))
    return found
