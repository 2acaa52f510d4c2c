"""What ``theorem1`` prints at a point, if nobody asks for more: what fits on a screen."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping

from verify.language.statement import PRINTED, PROVED, REFUTED, Obligation
from verify.prover.outcome import Outcome
from verify.publication import (
    BREAKS,
    HARMLESS,
    HYPOTHESES,
    OTHERWISE,
    REMARK,
    REPAIRED,
    SLIP,
    Publication,
)
from verify.views import words
from verify.views.point import (
    failed_hypotheses,
    final_angle,
    in_numbers,
    known_there,
    parameters_told,
)

TITLES = {PRINTED: "The printed argument for it", REPAIRED: "The theorem with repaired constants"}


def screen(
    outcome: Outcome, paper: Publication, as_printed: Mapping[str, str] | None = None
) -> Iterator[str]:
    """What fits on a screen: whether the theorem is true, whether its set is right, what fails.

    ``as_printed`` has the verdicts on the theorem with its sign, and its set, as printed. The last
    line is the result with everything it is about.
    """
    yield f"Theorem 1 ({outcome.statement.theorem}) at {parameters_told(outcome)}"
    yield ""
    yield from printed_lines(as_printed or {}, paper)
    sets = [group for group in words.groups(outcome) if group != HYPOTHESES]
    yield from _hypotheses(outcome, paper)
    for group in sets:
        yield _set_line(outcome, group)
        if group == PRINTED:
            yield from _argument(outcome, paper)
    numbers = in_numbers(outcome) if REPAIRED in sets else None
    if numbers is not None:
        yield numbers
    yield ""
    yield "All rows: -v; some: --rows NAME; for programs: --json; a certificate: --out DIR."
    yield ""
    if outcome.verdict == PROVED and outcome.assumptions:
        yield words.believed(outcome, paper)
    yield _verdict(outcome, paper, sets)


def printed_lines(verdicts: Mapping[str, str], paper: Publication) -> Iterator[str]:
    """Whether the theorem is true as it is printed, and by which misprint not; and its set."""
    if "sign" in verdicts:
        what = ", ".join(["Theorem 1 as printed", *paper.fatal.values()])
        is_in_coq = f"{paper.theorem}, the sign as printed" in paper.whole_in_coq
        told = f"{verdicts['sign']}{' (Coq)' * is_in_coq}, certificates/printed-sign"
        yield f"{what}: {told}"
    if "set" in verdicts:
        yield (
            f"Its set as printed, with > for <: {verdicts['set']} (certificates/printed-set), with "
            "d₀ > 0 and η_s > 0; for an interior it needs room for the angle (Θ/6)"
        )


def counted(count: int, severity: str) -> str:
    """So many rows of a severity: 6 slips of wording, 2 false, but harmless here, 10 remarks."""
    if severity == OTHERWISE:
        return f"{count} true, but badly derived"
    several = severity.replace("slip", "slips").replace("remark", "remarks")
    return f"{count} {severity if count == 1 else several}"


def _argument(outcome: Outcome, paper: Publication) -> Iterator[str]:
    """How bad it is with the printed argument: what breaks it, why, and what else is false."""
    yield from _breaking(outcome, paper)
    kinds = Counter(
        row.severity
        for row, found in outcome.rows
        if row.severity and words.fair(outcome, row, found) in (REFUTED, OTHERWISE, REMARK)
    )
    rest = [counted(kinds[kind], kind) for kind in (HARMLESS, SLIP) if kinds[kind]]
    fatal = [row.name for row, found in outcome.rows if words.fair(outcome, row, found) == REFUTED]
    if any(name in paper.fatal for name in fatal):
        rest[-1] += ", one fatal"
    if rest:
        yield f"  Also refuted: {', '.join(rest)}."
    others = [counted(kinds[kind], kind) for kind in (OTHERWISE, REMARK) if kinds[kind]]
    if others:
        yield f"  Not held against the paper: {', '.join(others)}."
    angle = final_angle(outcome)
    if angle:
        yield f"  {angle}"


def _breaking(outcome: Outcome, paper: Publication) -> Iterator[str]:
    """The refuted steps that break the printed argument, a line each with both numbers."""
    rows = [
        p for p in outcome.rows if words.fair(outcome, *p) == REFUTED and p[0].severity == BREAKS
    ]
    if rows:
        yield "  Refuted steps that break it (left and right side, formula):"
    for row, decision in rows:
        numbers = words.sides_told(row, decision, 3)
        if numbers:
            yield f"    {words.short_name(row):<18} {numbers:<26} {paper.number(row.label)}"
    yield from causes([row for row, _ in rows], paper)


def causes(rows: Iterable[Obligation], paper: Publication) -> Iterator[str]:
    """Why these rows are false: the first sentence on each cause."""
    names = {row.name: words.short_name(row) for row in rows}
    for own, text in paper.notes().causes:
        first, *others = [names[name] for name in own if name in names] or [""]
        if first:
            more = f" and {len(others)} more" if others else ""
            yield f"  Why {first}{more}: {text.partition('. ')[0].removesuffix('.')}."


def verdict_lines(outcome: Outcome, paper: Publication, sets: list[str]) -> Iterator[str]:
    """What fails or is left open, and the verdicts; the last line is the whole result."""
    yield from _hypotheses(outcome, paper)
    yield from (_set_line(outcome, group) for group in sets)
    if outcome.verdict == PROVED and outcome.assumptions:
        yield words.believed(outcome, paper)
    yield _verdict(outcome, paper, sets)


def _hypotheses(outcome: Outcome, paper: Publication) -> Iterator[str]:
    """The hypotheses that fail, and what is known there; and whether the precision sufficed."""
    for row, why in failed_hypotheses(outcome):
        where = paper.number(row.label)
        yield f"Hypothesis {where}, {row.label}, does not hold: {row.says} ({why})"
    known = known_there(outcome)
    if known:
        yield known
    if outcome.spent:
        yield f"Precision budget spent: {outcome.spent}"


def _set_line(outcome: Outcome, group: str) -> str:
    return f"{TITLES.get(group, group)}: {words.group_verdict(outcome, group)}"


def _verdict(outcome: Outcome, paper: Publication, sets: list[str]) -> str:
    which = f", {' and '.join(sets)} constants," if sets else ""
    title = f"Theorem 1{which} at {parameters_told(outcome)}"
    return f"Verdict: {words.summary(outcome, paper, title)}"
