"""The readable report beside a certificate, in Markdown."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from verify.prover.decimals import short
from verify.prover.ground import REFUTED, Decision, Ends
from verify.paper.groups import HYPOTHESES, PRINTED, REPAIRED
from verify.language.statement import Constant, Obligation
from verify.language.terms import symbol
from verify.jobs.theorem1 import Outcome
from verify.views.words import least, letters, theorem_in_numbers, verdict_text

_SIGNS = {"<": "<", "<=": "≤", "=": "="}


def report(outcome: Outcome) -> str:
    """The whole report, ending with a line feed."""
    return "\n".join(_lines(outcome)) + "\n"


def _lines(outcome: Outcome) -> Iterator[str]:
    typesetter = letters(outcome)
    values = ", ".join(
        f"{typesetter.term(symbol(name))} = {typesetter.term(outcome.prover.definitions[name])}"
        for name in outcome.statement.parameters
    )
    yield f"# Theorem 1 at {values}"
    yield ""
    yield f"Verdict: **{verdict_text(outcome)}**."
    if REPAIRED in outcome.rows:
        yield ""
        yield theorem_in_numbers(outcome)
    yield ""
    yield "Check it with nothing but Python: `python3 -I verify/check.py` and this folder."
    if PRINTED in outcome.rows:
        yield from section("What the printed proof gets wrong here")
        yield from defects(outcome)
    yield from section("What was changed")
    yield from table(
        ("Label", "Paper", "Needed", "Why"),
        ((f"`{c.label}`", c.paper, c.needed, c.why) for c in outcome.statement.changes),
    )
    yield from section("Constants")
    yield from table(("Constant", "Value", "Definition or bound"), _constants(outcome))
    for group in (HYPOTHESES, *outcome.groups):
        if group in outcome.rows:
            yield from section(f"All rows: {group}")
            yield from table(
                ("Verdict", "Label", "Step", "Claim", "Left", "Right"),
                (_row(outcome, row, decision) for row, decision in outcome.rows[group]),
            )
    yield from section("Taken on trust")
    yield from (f"- `{a.label}`: {a.sentence}" for a in outcome.assumptions)


def defects(outcome: Outcome) -> Iterator[str]:
    """The refuted printed rows, in the paper's order, each with its two sides."""
    rows = [
        (row, decision)
        for group in (HYPOTHESES, PRINTED)
        for row, decision in outcome.rows[group]
        if row.role == "printed" and decision.verdict == REFUTED
    ]
    yield from table(
        ("Label", "Step as printed", "Claim that would be needed", "Left", "Right", "Corrected by"),
        (
            (
                f"`{row.label}`",
                row.says,
                letters(outcome).claim(row.claim),
                _short(decision.lhs),
                _short(decision.rhs),
                f"`{row.corrected_by}`",
            )
            for row, decision in rows
        ),
    )


def _constants(outcome: Outcome) -> Iterator[tuple[str, ...]]:
    typesetter = letters(outcome)
    for constant in outcome.statement.constants:
        ends = outcome.prover.enclose(symbol(constant.name))
        if ends is None:
            continue
        group = "" if "." not in constant.name else f" ({constant.name.partition('.')[0]})"
        relation = {True: "≤ " if constant.direction == "down" else "≥ ", False: "= "}
        text = relation[constant.chosen] + typesetter.term(constant.term)
        yield constant.letter + group, _short(ends), text + _minimum(outcome, constant)


def _minimum(outcome: Outcome, constant: Constant) -> str:
    if constant.term.op != "min":
        return ""
    index = least(outcome, constant)
    return "" if index is None else f" (entry {index + 1} is the least)"


def _row(outcome: Outcome, row: Obligation, decision: Decision) -> tuple[str, ...]:
    return (
        decision.verdict,
        f"`{row.label}`",
        row.says,
        letters(outcome).claim(row.claim),
        _short(decision.lhs),
        f"{_SIGNS[row.claim.relation]} {_short(decision.rhs)}",
    )


def _short(ends: Ends | None) -> str:
    return "undefined" if ends is None else short(ends)


def section(title: str) -> Iterator[str]:
    """A heading between empty lines."""
    yield from ("", f"## {title}", "")


def table(head: tuple[str, ...], rows: Iterable[tuple[str, ...]]) -> Iterator[str]:
    """A table; bars inside a cell are escaped."""
    yield f"| {' | '.join(head)} |"
    yield f"|{'---|' * len(head)}"
    for row in rows:
        cells = (cell.replace("|", "\\|") for cell in row)
        yield f"| {' | '.join(cells)} |"
