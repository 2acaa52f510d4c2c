"""Bernstein coefficients of polynomials on boxes, and sums of products of facts made of them.

On a box with sides [a_i, b_i] a polynomial p of degree n_i in x_i is

    p(x) = sum_k B_k prod_i binomial(n_i, k_i) ((x_i - a_i)/(b_i - a_i))^k_i
                                               ((b_i - x_i)/(b_i - a_i))^(n_i - k_i),

so that it is >= 0 if no B_k is negative. The corners of B are values of p. The same numbers belong
to a higher degree too, where fewer may be negative.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import accumulate, pairwise
from math import comb, prod

from flint import fmpq, fmpq_mpoly, fmpq_poly

from verify.language.record import Record
from verify.prover.balls import fmpq_of, fraction_of
from verify.prover.goal import Bounds
from verify.prover.proof import Value, power_of, product_of, sum_of

Ends = tuple[Fraction, Fraction]


class Side(Record):
    """The ends of a variable, the facts that say so, and whether they are strict."""

    ends: Ends
    facts: tuple[str, str]
    strict: tuple[bool, bool]

    @classmethod
    def of(cls, bounds: Bounds | None) -> Side | None:
        """The side of a variable between two numbers."""
        if bounds is None or bounds.interval is None:
            return None
        strict = bounds.low_relation == "<", bounds.high_relation == "<"
        return cls(bounds.interval, (bounds.low_fact, bounds.high_fact), strict)

    def cut(self, at: Fraction, fact: str) -> tuple[Side, Side]:
        """The sides below and above a number, which a hypothesis says."""
        (low, high), (below, above), (first, last) = self
        return (
            Side((low, at), (below, fact), (first, False)),
            Side((at, high), (fact, above), (False, last)),
        )


#: Of a variable of which nothing depends.
ANY = Side((Fraction(0), Fraction(1)), ("", ""), (False, False))


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
        for index, (low, high) in enumerate(ends):
            for places in tensor._lines(index):
                values = _coefficients([table[place] for place in places], low, high)
                for place, value in zip(places, values, strict=True):
                    table[place] = value
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

    def raised(self, index: int) -> Tensor:
        """The tensor of the same polynomial for a degree that is larger by 1 in one variable."""
        degrees = tuple(d + (i == index) for i, d in enumerate(self.degrees))
        tensor = Tensor(degrees, [fmpq(0)] * prod(d + 1 for d in degrees))
        n = degrees[index]
        for old, new in zip(self._lines(index), tensor._lines(index), strict=True):
            row = [fmpq(0), *(self.coefficients[place] for place in old), fmpq(0)]
            for k, place in enumerate(new):
                tensor.coefficients[place] = (k * row[k] + (n - k) * row[k + 1]) / n
        return tensor

    def scaled(self, number: Fraction) -> Tensor:
        """The tensor of the polynomial times a number."""
        return Tensor(self.degrees, [value * fmpq_of(number) for value in self.coefficients])

    # --- proofs ---------------------------------------------------------------------------------

    def addends(self, sides: Sequence[Side], *, strict: bool) -> list[Value] | None:
        """Values >= 0, one > 0 if that is asked for, that add up to p times a number.

        The number is `scale`. None if a coefficient is negative, or nothing is seen to be > 0.
        """
        least, rest = min(self.coefficients), self.coefficients
        if least < 0:
            return None
        number: list[Value] = []
        if strict and not self._is_strict(sides):
            if not least:
                return None
            rest = [value - least for value in rest]
            number = [str(fraction_of(least) * self.scale(sides))]
        value = self._value(rest, sides, 0, Fraction(1))
        if value is None:
            return number
        return [*number, *(value[1:] if value[0] == "add" else (value,))]

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
                pairs = zip(sides[index].facts, (k, degree - k), strict=True)
                values.append(product_of(value, *(power_of(fact, e) for fact, e in pairs if e)))
        return sum_of(*values) if values else None


def _coefficients(polynomial: Sequence[fmpq], low: Fraction, high: Fraction) -> list[fmpq]:
    """Those of a polynomial in one variable on an interval.

    On [0, 1] they are b_j = sum_k c_k binomial(j, k) / binomial(n, k) for sum_k c_k t^k, so that
    c_k / binomial(n, k) is the k-th difference of the b_j at 0.
    """
    n = len(polynomial) - 1
    moved = fmpq_poly([*polynomial])(fmpq_poly([fmpq_of(low), fmpq_of(high - low)]))
    found = [moved[n]]
    for k in range(n - 1, -1, -1):
        found = [*accumulate(found, initial=moved[k] / comb(n, k))]
    return found
