"""One number is at most another where enclosures do not tell, as pi/4 and arctan 1: by equality."""

from __future__ import annotations

from verify.language.terms import as_term, equal
from verify.prover.proof import Proof
from verify.prover.rules import Sum
from verify.prover.search.question import Question

#: Equations are not looked for by orders meanwhile, nor these by equations.
CIRCLE = {"equality", "both orders"}


def by_equality(question: Question) -> Proof | None:
    """The equation, as a lemma."""
    (relation, lhs, rhs), known = question.goal.claim.key, question.known
    if relation != "<=":
        return None
    before, known.refused = known.refused, known.refused | CIRCLE
    try:
        name = question.fact(equal(lhs, rhs))
    finally:
        known.refused = before
    return None if name is None else Sum(("goal",), (), ((name, as_term(-1)),))
