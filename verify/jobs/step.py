"""The job `step`: one step of the recursion, for every state and all numbers with the rows."""

from __future__ import annotations

from functools import cache

from verify.language.statement import PROVED, Context, Obligation, Statement
from verify.language.terms import Claim
from verify.paper.step import argument
from verify.paper.step.argument import Chapter, Defined, Line, Opened, Reason
from verify.paper.step.theorem import Step, step
from verify.prover.outcome import Decision, Outcome
from verify.prover.proof import Premise, Proof
from verify.prover.rules import (
    Define,
    Entry,
    Induction,
    Instance,
    Interval,
    Least,
    Root,
    Sum,
)
from verify.prover.session import Session

#: Enough for the exact values of the rational numbers at the point of the parameters.
POINT_BITS = 512
NUMBER_BITS = 64


@cache
def decide() -> Outcome:
    """The step, each line with the proof that its reason describes."""
    return prove(step())


def prove(theorem: Step) -> Outcome:
    """An argument as the steps of a certificate; whether they prove it the checker decides."""
    writing = Writing(theorem.statement)
    for chapter in theorem.chapters:
        writing.chapter(chapter)
    return Outcome(theorem.statement, writing.decisions, tuple(writing.session.steps), {})


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
        self.decisions: dict[str, Decision] = {}

    def chapter(self, chapter: Chapter) -> None:
        """Take the items of a chapter, in order."""
        for item in chapter.items:
            if isinstance(item, Line):
                self.line(item, chapter.context)
            elif isinstance(item, Opened):
                self.opened(item.context, item.premises)
            elif isinstance(item, Defined):
                self.session.constant(self.constants[item.name], Define(), chapter.context)

    def opened(self, context: Context, premises: tuple[str, ...] | None) -> None:
        """Open a context at its point."""
        numeric: list[Premise] = [Interval(POINT_BITS) for _ in context.givens]
        self.session.open(context, numeric if premises is None else premises)

    def line(self, line: Line, context: str | None) -> None:
        """Write down a row, or a lemma."""
        proof = proof_of(line.reason)
        row: Obligation | None = self.rows.get(line.name)
        if row is not None:
            self.decide(row, proof)
        elif isinstance(line.claim, Claim):
            self.session.lemma(line.claim, proof, context, line.name)

    def decide(self, row: Obligation, proof: Proof) -> None:
        """Write down the proof of a row."""
        self.decisions[row.name] = Decision(PROVED, proof)
        self.session.prove_row(row, proof)


def proof_of(reason: Reason) -> Proof:
    """The proof by the rule of the same name."""
    match reason:
        case argument.Sum():
            return Sum(*reason)
        case argument.Least():
            branches = tuple(map(proof_of, reason.branches))
            return Least("rhs", branches, reason.equation)
        case argument.Entry():
            return Entry("lhs", reason.equation)
        case argument.At():
            return Instance(reason.fact, reason.values, reason.givens)
        case argument.Root():
            return Root()
        case argument.Number():
            return Interval(NUMBER_BITS)
        case argument.Repeated():
            return Induction(reason.start, reason.next)
        case argument.Searched():
            raise TypeError("this proof has to be found")
