"""The whole table of ``theorem1 -v``, for a reader at a terminal."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping

from verify.language.statement import PRINTED, REFUTED, Constant
from verify.language.terms import symbol
from verify.language.typeset import Typesetter
from verify.prover.outcome import Outcome
from verify.publication import HYPOTHESES, REPAIRED, Publication
from verify.views import words
from verify.views.enclosures import minimum_of
from verify.views.point import TITLES, in_numbers, parameters_told, printed_lines, verdict_lines
from verify.views.row_lists import row_lines


def report_lines(
    outcome: Outcome, paper: Publication, as_printed: Mapping[str, str] | None = None
) -> Iterator[str]:
    """The report, line by line; the last line is the result with everything it is about.

    ``as_printed`` has the verdicts on the theorem with its sign, and its set, as printed.
    """
    typesetter = words.letters(outcome)
    sets = [group for group in words.groups(outcome) if group != HYPOTHESES]
    yield f"Theorem 1 ({outcome.statement.theorem}) at {parameters_told(outcome)}"
    yield f"{paper.authors}: {paper.title}, as it stands in {paper.text_read}"
    yield ""
    yield from printed_lines(as_printed or {}, paper)
    yield from _first_screen(outcome, paper, sets)
    yield ""
    yield "Hypotheses"
    for row, decision in outcome.of_group(HYPOTHESES):
        yield from row_lines(outcome, row, decision, typesetter, paper)
    common = words.constants_of(outcome, "")
    if common:
        yield from ("", "Constants")
    for constant in common:
        yield from _constant(outcome, constant, typesetter)
    for group in sets:
        yield from _set(outcome, group, typesetter, paper)
    yield ""
    yield from words.taken_on_trust(outcome, paper)
    yield ""
    yield from verdict_lines(outcome, paper, sets)


def _set(outcome: Outcome, group: str, typesetter: Typesetter, paper: Publication) -> Iterator[str]:
    rows = outcome.of_group(group)
    yield ""
    yield f"{TITLES.get(group, group)}: {words.group_verdict(outcome, group)}"
    for constant in words.constants_of(outcome, group):
        yield from _constant(outcome, constant, typesetter)
    numbers = in_numbers(outcome) if group == REPAIRED else None
    if numbers is not None:
        yield from ("", f"  {numbers}")
    yield ""
    for row, decision in rows:
        yield from row_lines(outcome, row, decision, typesetter, paper)
    verdicts = Counter(words.fair(outcome, row, decision) for row, decision in rows)
    yield ""
    yield "  " + ", ".join(
        f"{count} {words.COUNTED[verdict]}" for verdict, count in verdicts.items()
    )
    if group == PRINTED:
        refuted = {row.name for row, found in rows if found.verdict == REFUTED}
        yield from _causes(refuted, paper.notes().causes)
    if group == REPAIRED:
        yield from _changes(paper)


def _causes(refuted: set[str], causes: Iterable[tuple[Iterable[str], str]]) -> Iterator[str]:
    """Why rows are refuted, once for all that have one cause."""
    yield from ("", "What is wrong, once for each cause")
    for rows, text in causes:
        shown = [name for name in rows if name in refuted]
        if shown:
            yield f"  {', '.join(shown)}: {text}"


def _changes(paper: Publication) -> Iterator[str]:
    yield ""
    yield "What was changed: label | paper | needed | why"
    for change in paper.notes().changes:
        yield f"  {paper.cited(change.label)} | {change.paper} | {change.needed} | {change.why}"
    yield from ("", "Remarks on the text, where no inequality decides")
    for label, text in paper.notes().remarks:
        yield f"  {paper.cited(label)}: {text}"


def _constant(outcome: Outcome, constant: Constant, typesetter: Typesetter) -> Iterator[str]:
    value = words.ends_told(words.ends_of(outcome, constant.name))
    letter = typesetter.term(symbol(constant.name))
    if constant.term.op == "rational":  # chosen; the rows have its bounds
        yield f"  {letter:<6} {value}"
        return
    yield f"  {letter:<6} {value:<14} = {typesetter.term(constant.term)}"
    if constant.term.op == "min":
        minimum = minimum_of(outcome, constant)
        for number, entry in enumerate(minimum.entries, 1):
            mark = "<- the minimum" if number == minimum.least else ""
            yield f"           entry {number}: {words.ends_told(entry)} {mark}".rstrip()


def _first_screen(outcome: Outcome, paper: Publication, sets: list[str]) -> Iterator[str]:
    """The verdicts, and the names of what is refuted."""
    yield from verdict_lines(outcome, paper, sets)
    refuted: dict[str, list[str]] = {}
    for row, decision in outcome.rows:
        found = words.fair(outcome, row, decision)
        if found == REFUTED and (row.role == PRINTED or row.group in sets):
            kind = f"{row.group}, {paper.severity(row)}" if row.severity else row.group
            refuted.setdefault(kind, []).append(words.short_name(row))
    for kind, names in refuted.items():
        yield f"Refuted, {kind}: {', '.join(names)}"
