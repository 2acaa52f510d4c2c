"""Sums of squares where equations hold: polynomials are compared after multiples are taken off.

This is a sum of squares in the ring of polynomials modulo the ideal of the equations, such as those
on a circle. What the sum differs by in the whole ring is a sum of multiples of the equations.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import combinations

from flint import fmpq_mpoly

from verify.language.terms import Claim
from verify.prover.proof import Proof
from verify.prover.rules import Sum
from verify.prover.search.bases import Gradings, all_monomials
from verify.prover.search.domain import Domain, Factor, multiplied
from verify.prover.search.faces import Block
from verify.prover.search.ideal import Ideal
from verify.prover.search.positive import Attempt, is_small, written
from verify.prover.search.question import MAX_FACTS, Question
from verify.prover.search.squares import Summand, decompose


class Variety(Domain):
    """The domain of a claim on which equations hold."""

    def __init__(self, question: Question, facts: Mapping[str, Claim]) -> None:
        self.ideal: Ideal | None = None
        equations = question.equations
        super().__init__(question.goal, {**facts, **equations}, None, question.is_negative)
        self.facts = {name: f for name, f in self.facts.items() if name not in equations}
        found = {name: self._difference(claim) for name, claim in equations.items()}
        self.equations = {name: p for name, p in found.items() if not p.is_zero()}
        self.whole = self.p
        self.ideal = Ideal(self.equations, question.budget)
        self.p = self.reduced(self.p)

    def _difference(self, claim: Claim) -> fmpq_mpoly:
        return self.reduced(self.scaled(self.clearing.difference(claim.lhs, claim.rhs)))

    def reduced(self, polynomial: fmpq_mpoly) -> fmpq_mpoly:
        """A polynomial without squares of roots, and without what the equations replace."""
        found = super().reduced(polynomial)
        return found if self.ideal is None else self.ideal.normal_form(found)[0]

    def basis(self, degree: int) -> tuple[fmpq_mpoly, ...]:
        """The monomials of at most this degree that no equation replaces."""
        every = all_monomials(self, degree, range(len(self.atoms)))
        leading = [tuple(map(int, m.monoms()[0])) for m in every]
        ideal = self.ideal
        return tuple(
            m
            for m, exponents in zip(every, leading, strict=True)
            if ideal is None or not ideal.has_multiple(exponents)
        )


def squares_on_equations(question: Question) -> Proof | None:
    """A sum of squares times facts, with multiples of equations."""
    if not question.equations:
        return None
    facts = dict([*question.facts.items()][:MAX_FACTS])
    domain = Variety(question, facts)
    if not domain.is_plain or domain.p.is_zero() or not domain.equations:
        return None
    for attempt in _attempts(domain):
        polynomials = [factor.polynomial for factor in attempt.factors]
        every = [*polynomials, *domain.equations.values()]
        gradings = Gradings(domain.p, every, domain.squares)
        blocks = [part for block in attempt.blocks for part in gradings.split(block)]
        if is_small(blocks):
            terms = decompose(domain.p, domain, polynomials, blocks, question.budget)
            proof = None if terms is None else _proof(question, domain, attempt, terms)
            if proof is not None:
                return proof
    return None


def _attempts(domain: Variety) -> Iterator[Attempt]:
    """Facts, then products of two, with squares of higher and higher degree."""
    one = Factor(domain.number(1), "1", True, ())
    facts = [*domain.facts.values()]
    pairs = [multiplied(a, b) for a, b in combinations(facts, 2)]
    goal = Factor(-domain.whole, domain.goal, not domain.strict, (domain.whole,))
    again = [goal, *(multiplied(goal, f) for f in (*facts, goal))]
    top = max(2, int(domain.p.total_degree()))
    top += top % 2
    for higher in (top, top + 2):
        for factors in ([one, *facts], [one, *facts, *pairs], [one, *facts, *again]):
            halves = [(higher - int(f.polynomial.total_degree())) // 2 for f in factors]
            blocks = [Block(i, domain.basis(h)) for i, h in enumerate(halves) if h >= 0]
            yield Attempt(factors, blocks)


def _proof(
    question: Question, domain: Variety, attempt: Attempt, terms: list[Summand]
) -> Proof | None:
    """The sum with what it differs by in the whole ring."""
    found = written(domain, attempt, terms, None)
    if found is None or domain.ideal is None:
        return None
    difference = -domain.whole
    for weight, index, square in terms:
        factor = attempt.factors[index].polynomial
        difference += domain.number(weight) * factor * square * square
    rest, taken = domain.ideal.normal_form(Domain.reduced(domain, difference))
    if not rest.is_zero():
        return None
    equations = tuple((name, domain.term(-cofactor)) for name, cofactor in taken.items())
    return Sum(found.addends, question.using, equations)
