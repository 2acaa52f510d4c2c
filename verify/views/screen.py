"""What ``theorem1`` prints at a point, if nobody asks for more: what fits on a screen."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from verify.language.statement import (
    BREAKS,
    HYPOTHESES,
    PRINTED,
    REFUTED,
    REPAIRED,
    Publication,
)
from verify.language.terms import Claim
from verify.prover.decimals import short
from verify.prover.outcome import Outcome
from verify.views.point import failed_hypotheses, in_numbers, parameters_told
from verify.views.words import (
    group_verdict,
    groups,
    short_name,
    sides_of,
    summary,
)

SIGNS = {"<": "<", "<=": "≤", "=": "="}
TITLES = {
    PRINTED: "The constants as printed",
    REPAIRED: "The repaired constants",
}


def screen(outcome: Outcome, paper: Publication) -> Iterator[str]:
    """What fits on a screen: what is proved, given what, and which steps break the argument.

    The last line is the result with everything it is about.
    """
    yield f"Theorem 1 ({outcome.statement.theorem}) at {parameters_told(outcome)}"
    sets = [group for group in groups(outcome) if group != HYPOTHESES]
    numbers = in_numbers(outcome) if REPAIRED in sets else None
    if numbers is not None:
        yield from ("", numbers)
    yield ""
    yield from _breaking(outcome, paper)
    kinds = Counter(
        row.severity for row, found in outcome.rows if found.verdict == REFUTED and row.severity
    )
    rest = [counted(count, kind) for kind, count in kinds.items() if kind != BREAKS]
    if rest:
        yield f"Also refuted: {', '.join(rest)}."
    yield "All rows: -v; some: --rows NAME; for programs: --json; a certificate: --out DIR."
    yield ""
    yield from verdict_lines(outcome, paper, sets)


def counted(count: int, severity: str) -> str:
    """So many rows of a severity: 9 slips of wording, 11 false, but harmless here."""
    return f"{count} {severity.replace('slip', 'slips', count != 1)}"


def _breaking(outcome: Outcome, paper: Publication) -> Iterator[str]:
    """The refuted steps that break the printed argument, a line each with both numbers."""
    rows = [p for p in outcome.rows if p[1].verdict == REFUTED and p[0].severity == BREAKS]
    if rows:
        yield "Refuted steps that break the printed argument (left and right side, formula):"
    for row, decision in rows:
        sides = sides_of(row, decision)
        if sides is not None and isinstance(row.claim, Claim):
            sign = SIGNS[row.claim.relation]
            numbers = f"{short(sides[0], 3)} {sign} {short(sides[1], 3)}"
            yield f"  {short_name(row):<18} {numbers:<26} {paper.number(row.label)}"


def verdict_lines(outcome: Outcome, paper: Publication, sets: list[str]) -> Iterator[str]:
    """What fails or is left open, and the verdicts; the last line is the whole result."""
    for row, why in failed_hypotheses(outcome):
        where = paper.number(row.label)
        yield f"Hypothesis {where}, {row.label}, does not hold: {row.says} ({why})"
    if outcome.spent:
        yield f"Precision budget spent: {outcome.spent}"
    for group in sets:
        yield f"{TITLES.get(group, group)}: {group_verdict(outcome, group)}"
    which = f", {' and '.join(sets)} constants," if sets else ""
    title = f"Theorem 1{which} at {parameters_told(outcome)}"
    yield f"Verdict: {summary(outcome, paper, title)}"
