"""Polynomials with factors: each factor has a sign, or occurs an even number of times."""

from __future__ import annotations

from flint import fmpq_mpoly

from verify.prover.balls import fraction_of
from verify.prover.clearing import expanded
from verify.prover.proof import Proof, Value, power_of, product_of
from verify.prover.rules import Sum
from verify.prover.search.question import Question

#: Longer polynomials are not factored.
MAX_TERMS = 200


def by_factors(question: Question) -> Proof | None:
    """A product of the factors' signs; each sign is a lemma."""
    clearing, relation = question.clearing, question.goal.claim.relation
    claim = question.goal.claim
    p = clearing.reduce(clearing.difference(claim.rhs, claim.lhs))
    if p.is_zero() or len(p) > MAX_TERMS or any(a.op == "sqrt" for a in clearing.atoms):
        return None
    content, factors = p.factor()
    if sum(int(exponent) for _, exponent in factors) < 2:
        return None
    sign, values = 1 if content > 0 else -1, list[Value]()
    for factor, exponent in sorted(factors, key=lambda pair: len(pair[0])):
        found = _value(question, relation, factor, int(exponent))
        if found is None:
            return None
        values.append(found[0])
        sign *= found[1]
    if sign < 0:
        return None
    return Sum(("goal", product_of(str(abs(fraction_of(content))), *values)), question.using)


def _value(
    question: Question, relation: str, factor: fmpq_mpoly, exponent: int
) -> tuple[Value, int] | None:
    """The value of a power of a factor, or of its opposite, and which of them it is."""
    if exponent % 2 == 0 and relation == "<=":
        square: Value = ("square", expanded(factor, question.clearing.atoms))
        return power_of(square, exponent // 2), 1
    for sign in (1, -1):
        part = factor if sign > 0 else -factor
        value = question.lemma(relation, part, expanded(part, question.clearing.atoms))
        if value is not None:
            return power_of(value, exponent), sign**exponent
    return None
