"""The job `elsewhere`: what the paper prints outside the proof of Theorem 1 and the spectrum."""

from __future__ import annotations

from functools import cache

from verify.language.statement import REFUTED
from verify.language.terms import Claim
from verify.paper.elsewhere.elsewhere import elsewhere, refutations
from verify.prover.arguments import NUMBER_BITS, POINT_BITS, Writing
from verify.prover.outcome import Decision, Outcome
from verify.prover.proof import Premise
from verify.prover.rules import Interval, Sum, Witness
from verify.wire.judge import judged


@cache
def decide_elsewhere() -> Outcome:
    """Every line with the proof that its reason describes, every misprint with its point."""
    argument = elsewhere()
    writing = Writing(argument.statement)
    for chapter in argument.chapters:
        writing.chapter(chapter)
    contexts = {context.name: context for context in argument.statement.contexts}
    for found in refutations():
        row = writing.rows[found.row.name]
        givens = contexts[str(row.context)].givens
        premises = tuple(premise(given.claim, POINT_BITS) for given in givens)
        proof = Witness(found.at, premises, Interval(NUMBER_BITS))
        writing.session.prove_row(row, proof, holds=False)
        writing.decisions[row.name] = Decision(REFUTED, proof)
    steps = tuple(writing.session.steps)
    return judged(Outcome(argument.statement, writing.decisions, steps, {}))


def premise(claim: Claim, bits: int) -> Premise:
    """Why a given holds at a point: equations identically, between rational numbers."""
    return Sum() if claim.relation == "=" else Interval(bits)
