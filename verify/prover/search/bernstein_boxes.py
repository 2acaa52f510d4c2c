"""Polynomials in a few variables on a box, by Bernstein coefficients on parts of it.

On a box with sides [a_i, b_i] a polynomial p of degree n_i in x_i is

    p(x) = sum_k B_k prod_i binomial(n_i, k_i) ((x_i - a_i)/(b_i - a_i))^k_i
                                               ((b_i - x_i)/(b_i - a_i))^(n_i - k_i).

It is >= 0 if no B_k is negative. The corners of B are values of p: a negative one ends the search.
A part is cut where a zero of p is known, else in the middle.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import pairwise
from math import comb, prod

from flint import fmpq, fmpq_mpoly

from verify.language.record import TYPE_CHECKING, Record
from verify.language.terms import symbol
from verify.prover.clearing import Clearing
from verify.prover.proof import Proof, Value
from verify.prover.rules import Cuts, Sum
from verify.prover.search.numbers import fmpq_of, fraction_of

if TYPE_CHECKING:
    from verify.prover.search.strategy import Strategy

#: More coefficients, or parts, or nested cuts, are not tried.
MAX_SIZE = 400
MAX_PARTS = 300
MAX_DEPTH = 40
#: What leaves may cost the checker, in its units.
MAX_UNITS = 4_500_000

Coefficients = list[fmpq]


class Part(Record):
    """A box with the facts that bound it, and the coefficients in the order of the last index."""

    ends: tuple[tuple[Fraction, Fraction], ...]
    facts: tuple[tuple[str, str], ...]
    strict: tuple[tuple[bool, bool], ...]
    coefficients: Coefficients
    depth: int


def by_bernstein(strategy: Strategy, zeros: Sequence[Mapping[str, Fraction]]) -> Proof | None:
    """A proof for a polynomial, or a quotient, in variables between numbers.

    ``zeros`` are points where p may be 0.
    """
    goal = strategy.goal
    replaced = {symbol(name): term for name, term in goal.definitions.items()}
    clearing = Clearing((goal.claim.lhs, goal.claim.rhs), replaced)
    bounds = [goal.variables.get(atom.name) for atom in clearing.atoms if atom.op == "symbol"]
    known = [b for b in bounds if b is not None and b.ends is not None and b.ends[0] < b.ends[1]]
    if not known or len(known) < len(clearing.atoms):
        return None
    p = clearing.difference(goal.claim.rhs, goal.claim.lhs)
    degrees = [int(d) for d in p.degrees()]
    if not 0 < prod(d + 1 for d in degrees) <= MAX_SIZE:  # 0 has degree -1 in each variable
        return None
    names = [atom.name for atom in clearing.atoms]
    points = [[zero[name] for name in names] for zero in zeros]
    search = _Search(strategy, names, degrees, points)
    ends = tuple(b.ends for b in known if b.ends is not None)
    facts = tuple((b.low_fact, b.high_fact) for b in known)
    strict = tuple((b.low_relation == "<", b.high_relation == "<") for b in known)
    if any("=" in (b.low_relation, b.high_relation) for b in known):
        return None
    return search.cover(Part(ends, facts, strict, _coefficients(p, degrees, ends), 0))


class _Search:
    """A tree of cuts."""

    def __init__(
        self,
        strategy: Strategy,
        names: Sequence[str],
        degrees: Sequence[int],
        zeros: Sequence[Sequence[Fraction]],
    ) -> None:
        self.names, self.degrees, self.zeros = names, degrees, zeros
        self.budget, self.using = strategy.budget, strategy.using
        self.strict = strategy.goal.claim.relation == "<"
        self.parts, size = 0, prod(d + 1 for d in degrees)
        self.cost = 2 * size * sum(degrees)
        self.most = min(MAX_PARTS, MAX_UNITS // (20 * size * sum(d + 1 for d in degrees)))

    def cover(self, part: Part) -> Proof | None:
        """A proof on a part."""
        proof = self._leaf(part)
        if proof is not None:
            return proof
        self.parts += 1
        if self.parts > self.most or part.depth >= MAX_DEPTH or self._is_negative(part):
            return None
        index, cut, halves = self._best(part)
        branches = []
        for half in halves:
            branch = self.cover(half)
            if branch is None:
                return None
            branches.append(branch)
        return Cuts(symbol(self.names[index]), (cut,), tuple(branches))

    def _is_negative(self, part: Part) -> bool:
        """Whether p is negative at a corner."""
        return any(value < 0 for value in self._corners(part.coefficients))

    def _corners(self, coefficients: Coefficients) -> Iterator[fmpq]:
        places = [0]
        for degree in self.degrees:
            places = [place * (degree + 1) + k for place in places for k in (0, degree)]
        return (coefficients[place] for place in places)

    def _best(self, part: Part) -> tuple[int, Fraction, tuple[Part, Part]]:
        """The cut after which the negative coefficients are smallest."""
        found = []
        for index, degree in enumerate(self.degrees):
            if degree:
                low, high = part.ends[index]
                cut = self._cut(part, index)
                self.budget.spend(self.cost)
                halves = self._halves(part, index, cut)
                least = [min(half.coefficients) for half in halves]
                score = sum((value for value in least if value < 0), fmpq(0))
                found.append(((score, high - low), (index, cut, halves)))
        return max(found, key=lambda pair: pair[0])[1]

    def _cut(self, part: Part, index: int) -> Fraction:
        """The coordinate of a zero in the part, or its middle."""
        low, high = part.ends[index]
        for zero in self.zeros:
            inside = all(a <= x <= b for x, (a, b) in zip(zero, part.ends, strict=True))
            if inside and low < zero[index] < high:
                return zero[index]
        return (low + high) / 2

    def _halves(self, part: Part, index: int, cut: Fraction) -> tuple[Part, Part]:
        """The parts below and above a cut (de Casteljau)."""
        low, high = part.ends[index]
        share = fmpq_of((cut - low) / (high - low))
        stride = prod(d + 1 for d in self.degrees[index + 1 :])
        count = self.degrees[index] + 1
        below, above = [*part.coefficients], [*part.coefficients]
        for start in range(0, len(below), stride * count):
            for offset in range(start, start + stride):
                places = range(offset, offset + stride * count, stride)
                row = [part.coefficients[place] for place in places]
                for step, place in enumerate(places):
                    below[place], above[places[count - 1 - step]] = row[0], row[-1]
                    row = [a + share * (b - a) for a, b in pairwise(row)]
        fact = f"@{part.depth + 1}"
        return (
            self._half(part, index, (low, cut), (part.facts[index][0], fact), below),
            self._half(part, index, (cut, high), (fact, part.facts[index][1]), above),
        )

    @staticmethod
    def _half(
        part: Part,
        index: int,
        ends: tuple[Fraction, Fraction],
        facts: tuple[str, str],
        coefficients: Coefficients,
    ) -> Part:
        strict = tuple(
            known and fact == old
            for known, fact, old in zip(part.strict[index], facts, part.facts[index], strict=True)
        )
        return Part(
            (*part.ends[:index], ends, *part.ends[index + 1 :]),
            (*part.facts[:index], facts, *part.facts[index + 1 :]),
            (*part.strict[:index], (strict[0], strict[1]), *part.strict[index + 1 :]),
            coefficients,
            part.depth + 1,
        )

    # --- leaves ---------------------------------------------------------------------------------

    def _leaf(self, part: Part) -> Sum | None:
        """The sum, if no coefficient is negative."""
        least = min(part.coefficients)
        if least < 0 or (self.strict and least == 0 and not self._is_strict(part)):
            return None
        widths = prod((b - a) ** d for (a, b), d in zip(part.ends, self.degrees, strict=True))
        goal: Value = "goal" if widths == 1 else ("mul", str(widths), "goal")
        addends: list[Value] = [goal]
        rest = part.coefficients
        if self.strict and least > 0:
            rest = [value - least for value in rest]
            addends.append(str(fraction_of(least) * widths))
        value = self._value(part, rest, 0, Fraction(1))
        return Sum((*addends, *((value,) if value is not None else ())), self.using)

    def _is_strict(self, part: Part) -> bool:
        """Whether a positive coefficient has only factors that are positive."""
        for place, value in enumerate(part.coefficients):
            if value > 0:
                good, left = True, place
                for degree, strict in zip(self.degrees[::-1], part.strict[::-1], strict=True):
                    left, k = divmod(left, degree + 1)
                    good = good and (strict[0] or k == 0) and (strict[1] or k == degree)
                if good:
                    return True
        return False

    def _value(
        self, part: Part, coefficients: Coefficients, index: int, factor: Fraction
    ) -> Value | None:
        """The sum over the indices from this one on; None for 0."""
        if index == len(self.degrees):
            number = fraction_of(coefficients[0]) * factor
            return str(number) if number else None
        degree = self.degrees[index]
        size, values = len(coefficients) // (degree + 1), []
        for k in range(degree + 1):
            inner = coefficients[k * size : (k + 1) * size]
            value = self._value(part, inner, index + 1, factor * comb(degree, k))
            if value is not None:
                low, high = part.facts[index]
                powers = [_power(low, k), _power(high, degree - k)]
                factors = [value, *(power for power in powers if power)]
                values.append(factors[0] if len(factors) == 1 else ("mul", *factors))
        if not values:
            return None
        return values[0] if len(values) == 1 else ("add", *values)


def _power(fact: str, exponent: int) -> Value:
    return fact if exponent == 1 else ("pow", fact, exponent) if exponent else ""


def _coefficients(
    p: fmpq_mpoly, degrees: Sequence[int], ends: Sequence[tuple[Fraction, Fraction]]
) -> Coefficients:
    """The Bernstein coefficients of p on a box."""
    size = prod(d + 1 for d in degrees)
    table = [fmpq(0)] * size
    for exponents, value in p.to_dict().items():
        place = 0
        for e, degree in zip(exponents, degrees, strict=True):
            place = place * (degree + 1) + int(e)
        table[place] = value
    stride = size
    for degree, (low, high) in zip(degrees, ends, strict=True):
        stride //= degree + 1
        rows = [_row(e, degree, low, high) for e in range(degree + 1)]
        for start in range(0, size, stride * (degree + 1)):
            for offset in range(start, start + stride):
                places = range(offset, offset + stride * (degree + 1), stride)
                old = [table[place] for place in places]
                for k, place in enumerate(places):
                    table[place] = sum(
                        (c * row[k] for c, row in zip(old, rows, strict=True)), fmpq(0)
                    )
    return table


def _row(exponent: int, degree: int, low: Fraction, high: Fraction) -> Coefficients:
    """The coefficients of x^exponent on [low, high]: mixed products of the ends (blossoms)."""
    return [
        fmpq_of(
            sum(
                (
                    comb(k, j) * comb(degree - k, exponent - j) * high**j * low ** (exponent - j)
                    for j in range(max(0, exponent - degree + k), min(k, exponent) + 1)
                ),
                Fraction(0),
            )
            / comb(degree, exponent)
        )
        for k in range(degree + 1)
    ]
