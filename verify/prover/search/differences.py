"""Polynomials without negative coefficients in the distances from bounds and between variables.

With linear facts f_1 >= 0, f_2 >= 0, … that determine the variables, such as x - a, b - y and
z - x, a polynomial in the variables is one in the f_i. If none of its coefficients is negative it
is a sum of products of facts. Where the order of variables is not known the two orders are two
cases.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import combinations, islice
from math import comb

from flint import fmpq_mpoly

from verify.prover.balls import fraction_of
from verify.prover.proof import Proof, Value, every, power_of, product_of
from verify.prover.rules import Cuts, Sum
from verify.prover.search.question import Question
from verify.prover.search.system import Fact, System

#: So many choices of facts are tried for each case.
MAX_CHOICES = 64
#: Claims with more variables are not split by their order.
MAX_ORDERED = 4
MAX_TERMS = 400
#: Bits of a polynomial in other variables, at most.
MAX_SIZE = 10**8

Chosen = dict[int, Fact]


def by_differences(question: Question) -> Proof | None:
    """A sum of products of linear facts."""
    return Differences(question).sum(())


def by_orders_of_variables(question: Question) -> Proof | None:
    """The same in each order of the variables."""
    found = Differences(question)
    return found.cases((), found.pairs()) if 1 < len(found.used) <= MAX_ORDERED else None


class Differences:
    """The polynomial of a claim, and the linear facts about its atoms."""

    def __init__(self, question: Question) -> None:
        self.system = System(question)
        self.p = -self.system.goal.polynomial
        self.strict = not self.system.goal.strict
        self.facts = [f for f in self.system.facts if int(f.polynomial.total_degree()) == 1]
        self.used = _variables(self.p)

    def pairs(self) -> list[tuple[int, int]]:
        """The pairs of variables in the polynomial."""
        names = [i for i in self.used if self.system.atoms[i].op == "symbol"]
        return [*combinations(names, 2)]

    def cases(self, hypotheses: tuple[Fact, ...], pairs: Sequence[tuple[int, int]]) -> Proof | None:
        """A proof in which the order of the variables is split as far as it has to be."""
        proof: Proof | None = self.sum(hypotheses)
        if proof is not None or not pairs:
            return proof
        (i, j), *others = pairs
        gens = self.system.context.gens()
        x, y = self.system.atoms[i], self.system.atoms[j]
        name = f"@{len(hypotheses) + 1}"
        differences = (gens[j] - gens[i], gens[i] - gens[j])
        branches = every(
            self.cases((*hypotheses, Fact(d, name, False)), others) for d in differences
        )
        return None if branches is None else Cuts(x - y, (Fraction(0),), branches)

    def sum(self, hypotheses: tuple[Fact, ...]) -> Sum | None:
        """A sum of products of facts and hypotheses."""
        facts = [*hypotheses, *self.facts]
        zero = self.system.context.constant(0)
        for chosen in islice(_choices(facts, self.used, {}), MAX_CHOICES):
            inverse: list[fmpq_mpoly] = [zero] * len(self.system.atoms)
            gens = self.system.context.gens()
            for index, fact in chosen.items():
                slope = fact.polynomial.derivative(index).leading_coefficient()
                rest = fact.polynomial - slope * gens[index]
                inverse[index] = (gens[index] - rest.compose(*inverse)) / slope
            size = _size(self.p, inverse)
            if size > MAX_SIZE:
                continue
            self.system.question.budget.spend(50 * len(self.p) + size // 100)
            found = self.p.compose(*inverse)
            addends = self._addends(found, chosen)
            if addends is not None:
                return Sum(("goal", *addends), self.system.using)
        return None

    def _addends(self, polynomial: fmpq_mpoly, chosen: Chosen) -> list[Value] | None:
        """The products, if no coefficient is negative, and one is positive where that is asked."""
        if len(polynomial) > MAX_TERMS or any(c < 0 for c in polynomial.coeffs()):
            return None
        addends, strict = [], not self.strict
        for exponents, value in polynomial.to_dict().items():
            powers = [(chosen[i], int(e)) for i, e in enumerate(exponents) if e]
            factors = (power_of(self.system.named(fact.value), e) for fact, e in powers)
            addends.append(product_of(str(fraction_of(value)), *factors))
            strict = strict or all(fact.strict for fact, _ in powers)
        return addends if strict else None


def _size(polynomial: fmpq_mpoly, values: Sequence[fmpq_mpoly]) -> int:
    """About the bits that a polynomial has with these values in place of its variables."""
    degree = max(0, int(polynomial.total_degree()))
    bits = max((c.height_bits() for value in values for c in value.coeffs()), default=0)
    own = max((c.height_bits() for c in polynomial.coeffs()), default=0)
    longest = max(1, *map(len, values))
    terms = comb(degree + longest - 1, degree)
    return (own + degree * bits) * len(polynomial) * terms


def _choices(facts: Sequence[Fact], wanted: Sequence[int], chosen: Chosen) -> Iterator[Chosen]:
    """A fact for each variable, over variables that have one before."""
    if all(i in chosen for i in wanted):
        yield chosen
        return
    for fact in facts:
        new = [i for i in _variables(fact.polynomial) if i not in chosen]
        if len(new) == 1 and new[0] in wanted:
            yield from _choices(facts, wanted, {**chosen, new[0]: fact})


def _variables(polynomial: fmpq_mpoly) -> list[int]:
    return [i for i, degree in enumerate(polynomial.degrees()) if degree > 0]
