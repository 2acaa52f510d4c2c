"""Claims with cosines: as identities, by factors, on parts of an interval, or everywhere."""

from __future__ import annotations

from collections.abc import Iterator

from verify.prover.proof import Proof
from verify.prover.search.angles import Linear
from verify.prover.search.cosine_bounds import CosineBounds
from verify.prover.search.cosine_parts import LENGTHS, Parts
from verify.prover.search.levels import by_levels
from verify.prover.search.question import Question


def by_cosines(question: Question) -> Proof | None:
    """A proof of a claim that is linear in cosines, after products of them are replaced."""
    linear = Linear(question.goal, question.session, question.using)
    if not linear.is_plain:
        return None
    proof = linear.identity(question.goal.claim.relation)
    if proof is not None or question.goal.claim.relation == "=":
        return proof
    return next(filter(None, _proofs(CosineBounds(question, linear))), None)


def _proofs(bounds: CosineBounds) -> Iterator[Proof | None]:
    """By factors, on parts of an interval, or on the whole domain; -1 and 1 come first."""
    yield by_levels(bounds)
    yield bounds.whole(1)
    if len(bounds.goal.variables) == 1 and bounds.goal.box:
        yield Parts(bounds).proof()
    for length in LENGTHS[:2]:
        yield bounds.whole(length)
