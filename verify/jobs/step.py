"""The job `step`: one step of the recursion, for every state and all numbers with the rows."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache

from verify.language.statement import PROVED, Cite, Context, Obligation, Statement
from verify.language.terms import Claim, sqrt
from verify.paper.groups import PRINTED, REPAIRED
from verify.paper.preliminaries import alpha_0, discriminant, phi_minus
from verify.paper.step import argument, numbers
from verify.paper.step.argument import Chapter, Defined, Line, Opened, Reason
from verify.paper.step.theorem import NAME, Step, collapse, step
from verify.prover.outcome import Decision, Outcome
from verify.prover.proof import LemmaStep, ObligationStep, Premise, Proof, Value
from verify.prover.rules import (
    Applying,
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
from verify.wire.write import write

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


# --- statements that cite the step ---------------------------------------------------------------


def applying(between: Mapping[str, str]) -> Applying:
    """The proof that the step applies, from rows, definitions, and the facts that are neither."""
    known = numbers.rows() | numbers.DEFINED | dict(between)
    return Applying(tuple(known[given.name] for given in numbers.context().givens))


def with_step(outcome: Outcome) -> Outcome:
    """A point run, with the row that the step applies to its repaired constants.

    The sentences about every state that its repaired rows use are not assumed any more. Without
    the repaired set, or where a row that the step needs is not proved, the outcome stays as it is.
    """
    proved = {name for name, found in outcome.decisions.items() if found.verdict == PROVED}
    lemmas, between = _between()
    if not proved >= {*numbers.rows().values(), _row("fixed-points-exist")}:
        return outcome
    proof, row = applying(between), collapse(REPAIRED)
    rows = [
        old if old.group == PRINTED else old._replace(uses=())
        for old in outcome.statement.obligations
    ]
    used = {name for old in rows for name in old.uses}
    cite = Cite(NAME, NAME, write(decide())["statement.json"])
    statement = outcome.statement._replace(
        obligations=(*rows, row),
        assumptions=tuple(a for a in outcome.statement.assumptions if a.name in used),
        cites=(*outcome.statement.cites, cite),
    )
    return outcome._replace(
        statement=statement,
        decisions={**outcome.decisions, row.name: Decision(PROVED, proof)},
        steps=(*outcome.steps, *lemmas, ObligationStep(row.name, proof)),
    )


def _row(name: str) -> str:
    return f"{REPAIRED}.{name}"


def _between() -> tuple[list[LemmaStep], dict[str, str]]:
    """What the step needs besides rows and definitions, at a point."""
    root, gap = sqrt(discriminant), ("add", _row("zeta-denominator"), _row("delta_2-positive"))
    proofs: list[tuple[str, Claim, Proof]] = [
        ("radicand", 0 < discriminant, Sum(("goal", _row("fixed-points-exist")))),
        ("root", 0 < root, Root()),
        ("divisor", 0 < alpha_0 + root, Sum(("goal", _row("alpha-positive"), f"{NAME}.root"))),
    ]
    sums: dict[str, tuple[Value, ...]] = {
        "V_1-positive": (_row("V_1-above-V_0"), _row("V_0-positive")),
        "decay-positive": (_row("C_eta-below-one"),),
        "decay-speed-positive": (("mul", _row("V_0-positive"), _row("C_eta-below-one")),),
        "gap-square-positive": (("pow", gap, 2),),
    }
    for name, claim in numbers.BETWEEN.items():
        found = Sum(("goal", *sums[name])) if name in sums else Sum(using=(phi_minus.name,))
        proofs.append((name, claim, found))
    lemmas = [LemmaStep(f"{NAME}.{name}", None, claim, proof) for name, claim, proof in proofs]
    return lemmas, {name: f"{NAME}.{name}" for name in numbers.BETWEEN}
