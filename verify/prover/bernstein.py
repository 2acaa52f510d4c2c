"""Bernstein coefficients of polynomials on boxes, and sums of products of facts made of them.

On a box with sides [a_i, b_i] a polynomial p of degree n_i in x_i is

    p(x) = sum_k B_k prod_i binomial(n_i, k_i) ((x_i - a_i)/(b_i - a_i))^k_i
                                               ((b_i - x_i)/(b_i - a_i))^(n_i - k_i),

so that it is >= 0 if no B_k is negative. The corners of B are values of p. The same numbers belong
to a higher degree too, where fewer may be negative.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from functools import cache
from itertools import accumulate, combinations, pairwise
from math import comb, prod

from flint import Ordering, fmpq, fmpq_mpoly, fmpq_mpoly_ctx, fmpq_poly

from verify.language.record import Record
from verify.prover.goal import Bounds
from verify.prover.numbers import fmpq_of, fraction_of
from verify.prover.proof import Value, power_of, product_of, sum_of

#: How often the degrees of forms are raised before they are given up.
ELEVATIONS = 3

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


class Forms:
    """Polynomials in a few variables x with 0 < x < b, in products of x and b - x."""

    def __init__(self, bounds: Sequence[Fraction]) -> None:
        names = tuple(f"{letter}{i}" for i in range(len(bounds)) for letter in "xy")
        self.ring = fmpq_mpoly_ctx.get(names, Ordering.lex)
        generators = self.ring.gens()
        self.pairs = [
            (generators[2 * i], generators[2 * i + 1], fmpq(b.denominator, b.numerator))
            for i, b in enumerate(bounds)
        ]
        self._factor = cache(self._homogeneous)

    def _homogeneous(self, index: int, k: int, degree: int) -> fmpq_mpoly:
        """x^k as a form of some degree in x and b - x, which add up to b."""
        x, y, inverse = self.pairs[index]
        return x**k * ((x + y) * inverse) ** (degree - k)

    def _raised(self, degrees: Sequence[int]) -> Iterator[list[int]]:
        """Degrees to try, 0 for variables that stay as they are; few variables first."""
        some = [i for i, degree in enumerate(degrees) if degree]
        for more in range(ELEVATIONS + 1):
            for size in range(len(some) if more else 1, len(some) + 1):
                for chosen in combinations(some, size):
                    yield [d + more if i in chosen else 0 for i, d in enumerate(degrees)]

    def terms(
        self, group: Mapping[tuple[int, ...], fmpq]
    ) -> list[tuple[Fraction, tuple[tuple[int, int], ...]]] | None:
        """Coefficients >= 0 with the exponents of each x and b - x; None if some are negative."""
        if all(value > 0 for value in group.values()):
            return [
                (fraction_of(value), tuple((k, 0) for k in monomial))
                for monomial, value in group.items()
            ]
        degrees = [max(monomial[i] for monomial in group) for i in range(len(self.pairs))]
        for raised in self._raised(degrees):
            total = self.ring.constant(0)
            for monomial, value in group.items():
                part = self.ring.constant(value)
                for i, k in enumerate(monomial):
                    if raised[i]:
                        part *= self._factor(i, k, raised[i])
                    elif k:
                        part *= self.pairs[i][0] ** k
                total += part
            found = total.to_dict()
            if found and all(value > 0 for value in found.values()):
                return [
                    (
                        fraction_of(value),
                        tuple(zip(map(int, m[::2]), map(int, m[1::2]), strict=True)),
                    )
                    for m, value in found.items()
                ]
        return None
