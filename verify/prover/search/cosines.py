"""Claims with cosines: as identities, by factors, on parts of an interval, or everywhere."""

from __future__ import annotations

from collections.abc import Iterator

from verify.language.terms import Claim, Term
from verify.prover.proof import Proof
from verify.prover.rules import Sum
from verify.prover.search.angles import Linear
from verify.prover.search.cosine_bounds import CosineBounds
from verify.prover.search.cosine_parts import LENGTHS, Parts
from verify.prover.search.levels import by_levels
from verify.prover.search.question import Question
from verify.prover.session import ZERO


def by_cosines(question: Question) -> Proof | None:
    """A proof of a claim that is linear in cosines, after products of them are replaced."""
    linear = Linear(question.goal, question.session, question.using)
    if not linear.is_plain:
        return None
    proof = linear.identity(question.goal.claim.relation)
    if proof is not None or question.goal.claim.relation == "=":
        return proof
    found = next(filter(None, _proofs(CosineBounds(question, linear))), None)
    return found or _by_linear_claim(question, linear)


def _by_linear_claim(question: Question, linear: Linear) -> Proof | None:
    """The claim with sums for products, if that has fewer cosines."""
    parts = {cosine: p for cosine, p in linear.parts.items() if not p.is_zero()}
    if not linear.equations or len(parts) >= len(linear.cosines):
        return None
    term: Term = ZERO
    for cosine, p in parts.items():
        part = linear.clearing.term(p)
        term = term + (part if cosine is None else part * cosine)
    fact = question.fact(Claim(question.goal.claim.relation, term, ZERO))
    if fact is None:
        return None
    return Sum(("goal", fact), tuple(linear.using), linear.cofactors(-1))


def _proofs(bounds: CosineBounds) -> Iterator[Proof | None]:
    """By factors, on parts of an interval, or on the whole domain; -1 and 1 come first."""
    yield by_levels(bounds)
    yield bounds.whole(1)
    if len(bounds.goal.variables) == 1 and bounds.goal.box:
        yield Parts(bounds).proof()
    for length in LENGTHS[:2]:
        yield bounds.whole(length)
