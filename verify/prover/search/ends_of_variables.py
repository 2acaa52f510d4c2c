"""Polynomials on a box by what they are at the ends of a variable.

For a polynomial p and a < x < b, with p(a) and p(b) polynomials in the other variables:

    rising      p = p(a) + (x - a) q           where q >= 0
    falling     p = p(b) + (b - x) q           where q >= 0
    concave     (b - a) p = (b - x) p(a) + (x - a) p(b) + (b - a) (x - a) (b - x) c

where -c is the coefficient of x^2, and c >= 0; with c = 0 these are the polynomials of degree 1.
What is needed of p(a), p(b), q and c is shown as lemmas, in the same way.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from flint import fmpq_mpoly

from verify.language.terms import Claim, Term
from verify.prover.clearing import coefficients, expanded
from verify.prover.goal import Bounds
from verify.prover.proof import Proof, Value
from verify.prover.rules import Sum
from verify.prover.search.question import Question
from verify.prover.search.tree import Tree
from verify.prover.session import ZERO

#: A sign that takes more leaves is not looked for here.
SIGN_LEAVES = 40


def by_ends(question: Question) -> Proof | None:
    """A proof for a polynomial in more than two variables between numbers."""
    if len(question.goal.variables) <= 2 or question.goal.box is None:
        return None
    polynomials = Polynomials(question)
    return polynomials.by_ends() if polynomials.is_plain else None


class Polynomials:
    """A claim between polynomials in variables that lie in a box: 0 < p or 0 <= p."""

    def __init__(self, question: Question) -> None:
        self.question, self.goal = question, question.goal
        claim = self.goal.claim
        self.clearing = question.clearing
        self.p = self.clearing.difference(claim.rhs, claim.lhs)
        self.atoms = self.clearing.atoms

    @property
    def is_plain(self) -> bool:
        """Whether all atoms are variables."""
        return all(atom.op == "symbol" for atom in self.atoms)

    def number(self, value: Fraction) -> fmpq_mpoly:
        """A number as a polynomial."""
        return self.clearing.constant(value)

    def term(self, p: fmpq_mpoly) -> Term:
        """A polynomial as a term."""
        return expanded(p, self.atoms)

    def lemma(self, relation: str, p: fmpq_mpoly) -> Value | None:
        """The value of a fact 0 < p or 0 <= p, which is proved now; None if that fails."""
        return self.question.lemma(relation, p, self.term(p))

    def not_negative(self, p: fmpq_mpoly) -> bool:
        """Whether a short tree shows that a polynomial is >= 0."""
        if p.is_constant():
            return p.is_zero() or p.leading_coefficient() >= 0
        variables = {
            atom.name: self.goal.variables[atom.name]
            for atom, degree in zip(self.atoms, p.degrees(), strict=True)
            if degree
        }
        if not all(bounds.ends for bounds in variables.values()):
            return False
        claim = Claim("<=", ZERO, self.term(p))
        return Tree(claim, variables, {}, self.question.budget).prove(SIGN_LEAVES) is not None

    def by_ends(self) -> Proof | None:
        """By the ends of the first variable for which that is possible."""
        for index in self._order():
            bounds = self.goal.variables[self.atoms[index].name]
            for technique in (self._monotone, self._concave):
                proof = technique(index, bounds)
                if proof is not None:
                    return proof
                if self._applies:
                    return None
        return None

    def _order(self) -> Iterator[int]:
        """The variables between two bounds, those of low degree first."""
        found = []
        for index, (atom, degree) in enumerate(zip(self.atoms, self.p.degrees(), strict=True)):
            bounds = self.goal.variables.get(atom.name)
            if degree and bounds is not None and bounds.interval is not None:
                found.append((int(degree), index))
        return (index for _, index in sorted(found))

    def at(self, index: int, value: Fraction) -> fmpq_mpoly:
        """P with a number for a variable."""
        gens = list(self.clearing.context.gens())
        gens[index] = self.number(value)
        return self.p.compose(*gens)

    def _monotone(self, index: int, bounds: Bounds) -> Proof | None:
        self._applies = False
        x = self.clearing.context.gens()[index]
        low, high = bounds.ends or (Fraction(0), Fraction(0))
        for end, sign, fact in ((low, 1, bounds.low_fact), (high, -1, bounds.high_fact)):
            at_end = self.at(index, end)
            quotient, rest = divmod(self.p - at_end, x - self.number(end))
            if not rest.is_zero():
                continue
            quotient *= sign
            if self.not_negative(quotient):
                self._applies = True
                first = self.lemma(self.goal.claim.relation, at_end)
                second = None if first is None else self.lemma("<=", quotient)
                if first is None or second is None:
                    return None
                return self._sum(first, ("mul", fact, second))
        return None

    def _concave(self, index: int, bounds: Bounds) -> Proof | None:
        degree = int(self.p.degrees()[index])
        if degree > 2:
            return None
        low, high = bounds.ends or (Fraction(0), Fraction(0))
        parts = coefficients(self.p, index)
        bend = -parts[2] if degree == 2 else self.number(Fraction(0))
        if not self.not_negative(bend):
            return None
        self._applies = True
        relation = self.goal.claim.relation
        ends = [self.lemma(relation, self.at(index, end)) for end in (low, high)]
        if None in ends:
            return None
        facts = bounds.low_fact, bounds.high_fact
        values: list[Value] = [("mul", facts[1], ends[0]), ("mul", facts[0], ends[1])]
        if not bend.is_zero():
            curved = self.lemma("<=", bend)
            if curved is None:
                return None
            values.append(("mul", str(high - low), *facts, curved))
        return self._sum(*values, scale=high - low)

    def _sum(self, *values: Value, scale: Fraction = Fraction(1)) -> Proof:
        goal: Value = "goal" if scale == 1 else ("mul", str(scale), "goal")
        return Sum((goal, *values), self.question.using)
