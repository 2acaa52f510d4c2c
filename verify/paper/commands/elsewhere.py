"""The job `elsewhere`: what the paper prints outside the proof of Theorem 1 and the spectrum."""

from __future__ import annotations

from functools import cache

from verify.language.statement import REFUTED, Context
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
        premises = _premises(contexts[str(row.context)])
        proof = Witness(found.at, premises, Interval(NUMBER_BITS))
        writing.session.prove_row(row, proof, holds=False)
        writing.decisions[row.name] = Decision(REFUTED, proof)
    steps = tuple(writing.session.steps)
    return judged(Outcome(argument.statement, writing.decisions, steps, {}))


def _premises(context: Context) -> tuple[Premise, ...]:
    """Equations hold identically, between rational numbers; enclosures show the rest."""
    return tuple(
        Sum() if given.claim.relation == "=" else Interval(POINT_BITS) for given in context.givens
    )
