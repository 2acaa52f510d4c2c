"""Cosines of multiples of one angle, as polynomials in its cosine (Chebyshev's).

With b = C(u), where C is `cos` or `cos_pi`, and c_k = C(k u), the rule *angles* says
2 c_(k-1) b = c_k + c_(k-2), so that c_k = T_k(b).
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from functools import reduce
from math import gcd

from verify.language.terms import Claim, Term, as_term, equal
from verify.prover.balls import fraction_of
from verify.prover.clearing import Clearing, atoms_of
from verify.prover.cosines import Relations, chebyshev
from verify.prover.multiple import outside_atoms
from verify.prover.proof import Proof
from verify.prover.rules import Sum
from verify.prover.search.question import Question
from verify.prover.session import ZERO

#: Higher multiples are not used.
MAX_MULTIPLE = 24
COSINES = ("cos", "cos_pi")


def by_multiple_angles(question: Question) -> Proof | None:
    """The claim with each cosine replaced by a polynomial in one of them."""
    claim = question.goal.claim
    equations: dict[Term, str] = {}
    chosen: dict[Term, Term] = {}
    for op in COSINES:
        for base, multiples in _families(question, op):
            family = Multiples(question, op, base)
            for k, atom in multiples:
                if atom != family.cosine:
                    equations[atom] = family.equation(k, atom)
                    chosen[atom] = chebyshev(family.cosine, k)
    if not chosen:
        return None
    sides = [outside_atoms(side, chosen) for side in (claim.lhs, claim.rhs)]
    if sides == [claim.lhs, claim.rhs]:
        return None
    fact = question.fact(Claim(claim.relation, *sides))
    return question.from_fact(claim, fact, (*question.using, *equations.values()))


def _families(question: Question, op: str) -> Iterator[tuple[Term, list[tuple[int, Term]]]]:
    """Angles u, and the cosines of their multiples in the claim, of which there are others."""
    goal = question.goal
    atoms = atoms_of((goal.claim.lhs, goal.claim.rhs, *goal.definitions.values()), {})
    left = [a for a in atoms if a.op == op and a.children[0].op != "rational"]
    while left:
        first, family = left[0], [(Fraction(1), left[0])]
        for other in left[1:]:
            ratio = _ratio(first.children[0], other.children[0])
            if ratio is not None and ratio > 0:
                family.append((ratio, other))
        left = [atom for atom in left if all(atom != other for _, other in family)]
        least = min(ratio for ratio, _ in family)
        common = reduce(_common, (ratio for ratio, _ in family))
        base = next(atom for ratio, atom in family if ratio == least).children[0]
        if common != least:
            base = as_term(common) * first.children[0]
        multiples = [(int(ratio / common), atom) for ratio, atom in family]
        if max(k for k, _ in multiples) <= MAX_MULTIPLE and len(multiples) > 1:
            yield base, multiples


def _common(a: Fraction, b: Fraction) -> Fraction:
    """The largest number of which both are multiples."""
    return Fraction(gcd(a.numerator * b.denominator, b.numerator * a.denominator)) / (
        a.denominator * b.denominator
    )


def _ratio(a: Term, b: Term) -> Fraction | None:
    """The number q with b = q a, if there is one: for the checker, names in angles are atoms."""
    clearing = Clearing((a, b), {})
    (n, d), (m, e) = clearing.clear(a), clearing.clear(b)
    left, right = clearing.times(n, e), clearing.times(m, d)
    if not left.to_dict() or not right.to_dict():
        return None
    ratio = right.leading_coefficient() / left.leading_coefficient()
    return fraction_of(ratio) if right == ratio * left else None


class Multiples:
    """The cosines of the multiples of one angle."""

    def __init__(self, question: Question, op: str, base: Term) -> None:
        self.op, self.base, self.cosine = op, base, Term(op, base)
        self.context, self.session = question.goal.context, question.session
        self.relations = Relations(self.session, self.context)

    def at(self, k: int) -> Term:
        """The cosine of k u."""
        return Term(self.op, ZERO if k == 0 else self.base if k == 1 else as_term(k) * self.base)

    def equation(self, k: int, cosine: Term) -> str:
        """The name of the fact C(k u) = T_k(b), where k u may be written in another way."""
        if k == 0:
            return self.relations.exact(cosine, 1)
        if k == 1:
            return self.relations.written(cosine, self.cosine, same=True)
        product = self.relations.product(self.at(k - 1), self.cosine, cosine, self.at(k - 2))
        using = [self.equation(i, self.at(i)) for i in (k - 2, k - 1) if i != 1]
        proof = Sum((), tuple(using), ((product, as_term(-1)),))
        return self.session.ensure(equal(cosine, chebyshev(self.cosine, k)), proof, self.context)
