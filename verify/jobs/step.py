"""The job `step`: one step of the recursion, for every state and all numbers with the rows."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache

from verify.jobs.arguments import write_down
from verify.language.statement import PROVED, Cite
from verify.language.terms import Claim, sqrt
from verify.paper.groups import PRINTED, REPAIRED
from verify.paper.preliminaries import alpha_0, discriminant, phi_minus
from verify.paper.step import numbers
from verify.paper.step.theorem import NAME, collapse, step
from verify.prover.outcome import Decision, Outcome
from verify.prover.proof import LemmaStep, ObligationStep, Proof, Value
from verify.prover.rules import Applying, Root, Sum
from verify.wire.write import write


@cache
def decide_step() -> Outcome:
    """The step, each line with the proof that its reason describes."""
    return write_down(step())


# --- statements that cite the step ---------------------------------------------------------------


def applying(between: Mapping[str, str]) -> Applying:
    """The proof that the step applies, from rows, definitions, and the facts that are neither."""
    known = numbers.row_names() | numbers.DEFINED | dict(between)
    return Applying(tuple(known[given.name] for given in numbers.context().givens))


def with_step(outcome: Outcome) -> Outcome:
    """A point run, with the row that the step applies to its repaired constants.

    The sentences about every state that its repaired rows use are not assumed any more. Without
    the repaired set, or where a row that the step needs is not proved, the outcome stays as it is.
    """
    proved = {name for name, found in outcome.decisions.items() if found.verdict == PROVED}
    lemmas, between = _between()
    if not proved >= {*numbers.row_names().values(), _row("fixed-points-exist")}:
        return outcome
    proof, row = applying(between), collapse(REPAIRED)
    rows = [
        old if old.group == PRINTED else old._replace(uses=())
        for old in outcome.statement.obligations
    ]
    used = {name for old in rows for name in old.uses}
    cite = Cite(NAME, NAME, write(decide_step())["statement.json"])
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
