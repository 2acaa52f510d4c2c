"""An argument as the steps of a certificate: each line with the proof that its reason describes."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from verify.language import argument
from verify.language.argument import Argument, Chapter, Defined, Line, Opened, Reason
from verify.language.statement import PROVED, REFUTED, Context, Obligation, Statement
from verify.language.terms import Claim, Term
from verify.prover import rules
from verify.prover.outcome import Decision, Outcome
from verify.prover.proof import Premise, Proof
from verify.prover.session import Session

#: Enough for the exact values of the rational numbers at the point of the parameters.
POINT_BITS = 512
NUMBER_BITS = 64


def write_down(written: Argument) -> Outcome:
    """An argument as the steps of a certificate; whether they prove it the checker decides."""
    writing = Writing(written.statement)
    for chapter in written.chapters:
        writing.chapter(chapter)
    return Outcome(written.statement, writing.decisions, tuple(writing.session.steps), {})


class Writing:
    """The steps so far, and the decisions on obligations."""

    def __init__(self, statement: Statement) -> None:
        self.session = Session()
        self.rows = {row.name: row for row in statement.obligations}
        self.constants = {
            constant.name: constant
            for context in statement.contexts
            for constant in context.constants
        }
        self.givens = {c.name: [g.claim for g in c.givens] for c in statement.contexts}
        self.decisions: dict[str, Decision] = {}

    def chapter(self, chapter: Chapter) -> None:
        """Take the items of a chapter, in order."""
        for item in chapter.items:
            if isinstance(item, Line):
                self.line(item, chapter.context)
            elif isinstance(item, Opened):
                self.opened(item.context, item.premises)
            elif isinstance(item, Defined):
                self.session.constant(self.constants[item.name], rules.Define(), chapter.context)

    def opened(self, context: Context, premises: tuple[str, ...] | None) -> None:
        """Open a context at its point."""
        numeric: list[Premise] = [rules.Interval(POINT_BITS) for _ in context.givens]
        self.session.open(context, numeric if premises is None else premises)

    def line(self, line: Line, context: str | None) -> None:
        """Write down a row, or a lemma."""
        row: Obligation | None = self.rows.get(line.name)
        if row is not None and isinstance(line.reason, argument.ByWitness):
            self.refuted(row, line.reason.at)
            return
        proof = proof_of(line.reason)
        if row is not None:
            self.decide(row, proof)
        elif isinstance(line.claim, Claim):
            self.session.lemma(line.claim, proof, context, line.name)

    def decide(self, row: Obligation, proof: Proof) -> None:
        """Write down the proof of a row."""
        self.decisions[row.name] = Decision(PROVED, proof)
        self.session.prove_row(row, proof)

    def refuted(self, row: Obligation, at: Mapping[str, Term]) -> None:
        """Write down that a row is false at a point."""
        premises = tuple(map(premise, self.givens[row.context or ""]))
        proof = rules.Witness(at, premises, rules.Interval(NUMBER_BITS))
        self.session.prove_row(row, proof, holds=False)
        self.decisions[row.name] = Decision(REFUTED, proof)


def premise(claim: Claim) -> Premise:
    """Why a given holds at a point: equations identically, between rational numbers."""
    return rules.Sum() if claim.relation == "=" else rules.Interval(POINT_BITS)


#: The rules that take just what a reason has.
_SAME: dict[Any, Any] = {
    argument.BySum: rules.Sum,
    argument.ByInstance: rules.Instance,
    argument.ByApplying: rules.Applying,
    argument.ByRoot: rules.Root,
    argument.ByInduction: rules.Induction,
}


def proof_of(reason: Reason) -> Proof:
    """The proof by the rule of the same name."""
    match reason:
        case argument.ByLeast():
            branches = tuple(map(proof_of, reason.branches))
            return rules.Least(reason.side, branches, reason.equation)
        case argument.ByEntry():
            return rules.Entry(reason.side, reason.equation)
        case argument.ByInterval():
            return rules.Interval(NUMBER_BITS)
        case argument.ToBeFound() | argument.ByWitness():
            raise TypeError("this proof has to be found")
    found: Proof = _SAME[type(reason)](*reason)
    return found
