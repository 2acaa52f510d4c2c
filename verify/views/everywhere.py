"""What people see of Theorem 1 for all parameters: counts, assumptions, the theorem in words."""

from __future__ import annotations

from collections.abc import Iterator

from verify.language.statement import PROVED, REFUTED
from verify.prover.outcome import Outcome
from verify.views.words import (
    cited_as,
    counts,
    given,
    given_by,
    headline,
    letters,
    short_name,
)

FORMAT = "verify-theorem1-all/1"

THEOREM = (
    "Theorem 1, given these sentences. Let 0 < r < 1, V₀ > 0, δ_θ > 0, and let θ₀ satisfy "
    "0 < -cos θ₀ ≤ 1 and -cos θ₀ > 2r^(1/3)(1+r^(1/3))/(1+r). Then the constants of the repaired "
    "set exist and are positive, and three particles that start in the set they describe collide "
    "infinitely often, in the order 0-2, 0-1, 0-2, …, in finite time, and -cos of the angle "
    "converges to a limit within δ_θ of -cos θ₀. The set has interior points."
)


def screen(outcome: Outcome) -> Iterator[str]:
    """What is proved, given what."""
    (cite,) = outcome.statement.cites
    yield "Theorem 1 for all parameters"
    yield ""
    yield f"Rows: {counts(outcome, 'needed')}"
    yield f"The step, for every state, is {cited_as(cite)}"
    yield f"Taken on trust there: {given(cite.trusted)}"
    for assumption in cite.trusted:
        yield f"  {assumption.name} ({assumption.kind}): {assumption.sentence}"
    yield "Every row: -v; one with its proof: explain NAME; the graph: graph --out FILE.svg"
    yield ""
    if outcome.verdict == PROVED:
        yield THEOREM
        yield ""
    yield f"Verdict: {headline(outcome)}: {outcome.statement.title}; given {given_by(outcome)}"


def printed_screen(outcome: Outcome) -> Iterator[str]:
    """Which rows of the printed set fail for all parameters, and which at an example."""
    yield "The printed set, for all parameters that satisfy the corrected hypothesis"
    yield ""
    typesetter = letters(outcome)
    for row, decision in outcome.rows:
        if decision.verdict == REFUTED and not decision.witness:
            yield f"  fails for all: {short_name(row)}   [{row.label}]"
    for row, decision in outcome.rows:
        if decision.verdict == REFUTED and decision.witness:
            values = ", ".join(
                f"{name} = {typesetter.term(term)}"
                for name, term in decision.witness.items()
                if name in ("u", "p", "v", "delta_theta")
            )
            yield f"  fails at {values}: {short_name(row)}   [{row.label}]"
    yield ""
    yield f"Verdict: refuted: for all parameters, {counts(outcome, 'printed')}"


def row_lines(outcome: Outcome) -> Iterator[str]:
    """Every row, with its claim and the rule that proves it."""
    typesetter = letters(outcome)
    for row, decision in outcome.rows:
        yield f"  {decision.verdict:<9} {row.says}   [{row.name}, {row.label}]"
        yield f"            {typesetter.claim(row.claim)}   by {decision.method or 'nothing'}"
