"""The table of ``theorem1`` for a reader at a terminal."""

from __future__ import annotations

from collections.abc import Iterator

from verify.prover.decimals import outward, short
from verify.prover.ground import REFUTED, UNDECIDED, Decision, Ends
from verify.paper.groups import HYPOTHESES, PRINTED, REPAIRED
from verify.language.statement import Constant, Obligation
from verify.language.terms import symbol
from verify.jobs.theorem1 import Outcome
from verify.views.typeset import Typesetter
from verify.views.words import (
    entry_ends,
    least,
    letters,
    theorem_in_numbers,
    thresholds,
    verdict_text,
)

_SIGNS = {"<": "<", "<=": "≤"}
_TITLES = {
    PRINTED: "The constants as printed",
    REPAIRED: "The repaired constants",
}


def lines(outcome: Outcome) -> Iterator[str]:
    """The report, line by line."""
    typesetter = letters(outcome)
    yield f"Theorem 1 ({outcome.statement.theorem})"
    for name in outcome.statement.parameters:
        value = typesetter.term(outcome.prover.definitions[name])
        yield f"  {typesetter.term(symbol(name))} = {value}"
    yield ""
    yield from _summary(outcome)
    yield ""
    yield "Hypotheses"
    for row, decision in outcome.rows[HYPOTHESES]:
        yield from _row(row, decision, typesetter)
    yield ""
    yield "Constants"
    for constant in outcome.statement.constants:
        if "." not in constant.name:
            yield from _constant(outcome, constant, typesetter)
    for group in outcome.groups:
        if group in outcome.rows:
            yield from _set(outcome, group, typesetter)
    yield from _assumptions(outcome)
    yield ""
    yield from _verdict(outcome)


def _set(outcome: Outcome, group: str, typesetter: Typesetter) -> Iterator[str]:
    yield ""
    yield f"{_TITLES[group]}: {outcome.set_verdict(group)}"
    for constant in outcome.statement.constants:
        if constant.name.startswith(f"{group}."):
            yield from _constant(outcome, constant, typesetter)
    if group == REPAIRED:
        yield ""
        yield f"  {theorem_in_numbers(outcome)}"
    yield ""
    for row, decision in outcome.rows[group]:
        yield from _row(row, decision, typesetter)
    counts: dict[str, int] = {}
    for _, decision in outcome.rows[group]:
        counts[decision.verdict] = counts.get(decision.verdict, 0) + 1
    yield ""
    yield "  " + ", ".join(f"{count} {verdict}" for verdict, count in counts.items())
    if group == REPAIRED:
        yield ""
        yield "What was changed: label | paper | needed | why"
        for change in outcome.statement.changes:
            yield f"  {change.label} | {change.paper} | {change.needed} | {change.why}"


def _constant(outcome: Outcome, constant: Constant, typesetter: Typesetter) -> Iterator[str]:
    ends = outcome.prover.enclose(symbol(constant.name))
    if ends is None:
        yield f"  {constant.letter:<6} does not exist"
        return
    bound = "at most " if constant.direction == "down" else "at least "
    text = typesetter.term(constant.term)
    yield f"  {constant.letter:<6} {short(ends):<14} {bound if constant.chosen else '= '}{text}"
    if constant.term.op == "min":
        minimum = least(outcome, constant)
        for index, entry in enumerate(entry_ends(outcome, constant)):
            mark = "<- the minimum" if index == minimum else ""
            yield f"           entry {index + 1}: {_short(entry)} {mark}".rstrip()


def _row(row: Obligation, decision: Decision, typesetter: Typesetter) -> Iterator[str]:
    role = "" if row.role == "needed" or row.group == PRINTED else " (as printed)"
    name = row.name.partition(".")[2]
    yield f"  {decision.verdict:<9} {row.says}{role}   [{name}, {row.label}]"
    yield f"            {typesetter.claim(row.claim)}"
    numbers = f"{_short(decision.lhs)} {_SIGNS[row.claim.relation]} {_short(decision.rhs)}"
    yield f"            {numbers}   margin {_margin(decision)}"
    if decision.verdict == REFUTED and row.corrected_by:
        yield f"            corrected by {row.corrected_by}"


def _short(ends: Ends | None) -> str:
    return "undefined" if ends is None else short(ends)


def _margin(decision: Decision) -> str:
    """A lower bound of rhs - lhs; 0 where the two sides are proved equal or one is a bound."""
    if decision.lhs is None or decision.rhs is None or decision.verdict == UNDECIDED:
        return "unknown"
    if decision.method == "rewrite":
        return "0 (structural)"
    return outward((decision.rhs[0] - decision.lhs[1],) * 2, 3)[0]


def _assumptions(outcome: Outcome) -> Iterator[str]:
    yield ""
    yield f"Taken on trust, and not proved by this program ({len(outcome.assumptions)}):"
    for assumption in outcome.assumptions:
        yield f"  {assumption.label}: {assumption.sentence}"


def _summary(outcome: Outcome) -> Iterator[str]:
    """The verdicts, and the names of what is refuted, for the first screen."""
    yield from _verdict(outcome)
    for group in outcome.groups:
        refuted = [
            row.name.partition(".")[2]
            for row, decision in outcome.rows.get(group, [])
            if decision.verdict == REFUTED
        ]
        if refuted:
            yield f"Refuted, {group}: {', '.join(refuted)}"


def _verdict(outcome: Outcome) -> Iterator[str]:
    for row, decision in outcome.rows[HYPOTHESES]:
        if row.role == "needed" and decision.verdict == REFUTED:
            equal = decision.lhs is not None and decision.lhs == decision.rhs
            why = "both sides are equal" if equal else thresholds(outcome)
            yield f"Hypothesis {row.label} does not hold: {row.says} ({why})"
    if outcome.spent:
        yield f"Precision budget spent: {outcome.spent}"
    for group in outcome.groups:
        if group in outcome.rows:
            yield f"{_TITLES[group]}: {outcome.set_verdict(group)}"
    yield f"Verdict: {verdict_text(outcome)}"
