"""What screens of statements about all values share: their rows, in brief or whole."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from verify.language.simplify import simplified, simplified_claim
from verify.language.statement import (
    NEEDED,
    PRINTED,
    PROVED,
    REFUTED,
    UNDECIDED,
    Always,
    Applies,
    Obligation,
)
from verify.language.terms import Claim, Term
from verify.language.typeset import Typesetter
from verify.prover.decimals import exact_number, outward, people
from verify.prover.outcome import Decision, Ends, Outcome
from verify.publication import OTHERWISE, REMARK, REPAIRED, SEVERITIES, Publication
from verify.views import words
from verify.views.words import letters

#: Where the rest is.
MORE = "All rows: -v; some: --rows NAME; one with its proof: verify explain NAME."


def screen(
    title: str, outcome: Outcome, paper: Publication, answer: Iterable[str] = ()
) -> Iterator[str]:
    """What fits on a screen: the verdict in a word, the answer to what was asked, then the rows.

    The whole verdict comes after it.
    """
    yield f"{title}: {words.headline(outcome)}"
    yield ""
    asked = [*answer]
    yield from [*asked, ""] if asked else ()
    yield from brief(outcome, paper)
    if outcome.spent:
        yield f"Work budget spent: {outcome.spent}"
    yield MORE


_TITLES = {
    REFUTED: "Refuted",
    OTHERWISE: "Proved, but not by the printed argument",
    REMARK: "Remarks: false, but not what the text says",
    UNDECIDED: "Undecided",
}


def heading(group: str) -> str:
    """The name of a group as a heading."""
    return group[:1].upper() + group[1:]


def brief(outcome: Outcome, paper: Publication) -> Iterator[str]:
    """The rows by group, each refuted or undecided one in a line, and what is taken on trust."""
    parts = (f"{heading(group)} {_share(outcome, group)}" for group in words.groups(outcome))
    yield f"Rows proved, of those needed: {', '.join(parts)}."
    for verdict, title in _TITLES.items():
        found = [(row, d) for row, d in outcome.rows if words.fair(outcome, row, d) == verdict]
        if found:
            yield ""
            what = (
                "row, formula" if verdict == UNDECIDED else "row, name of its correction, formula"
            )
            yield f"{title}, {len(found)} ({what}):"
        for severity in ("", *SEVERITIES):
            here = [row for row, d in found if severity_of(row, d) == severity]
            if severity and here and verdict == REFUTED:
                yield f"  {severity}:"
            yield from (_one_line(row, paper) for row in here)
    yield ""
    yield from trusted_names(outcome, paper)


def _share(outcome: Outcome, group: str) -> str:
    found = [d.verdict for row, d in outcome.of_group(group) if row.role == NEEDED]
    return f"{found.count('proved')}/{len(found)}"


def severity_of(row: Obligation, decision: Decision) -> str:
    """How bad it is that a row is refuted; nothing if it is not."""
    return (row.severity or "") if decision.verdict == REFUTED else ""


def _one_line(row: Obligation, paper: Publication) -> str:
    correction = row.corrected_by or ""
    return f"    {words.short_name(row):<24} {correction:<26} {paper.number(row.label)}".rstrip()


def trusted_names(outcome: Outcome, paper: Publication) -> Iterator[str]:
    """Which sentences a verdict rests on, and which of them Coq has proved."""
    if outcome.assumptions:
        yield f"{words.believed(outcome, paper)} Their text: -v."
    if outcome.printed_assumptions:
        names = ", ".join(assumption.name for assumption in outcome.printed_assumptions)
        yield f"Only for printed rows: {names}."


def all_rows(outcome: Outcome, paper: Publication) -> Iterator[str]:
    """Every row, with its exact claim and what proves or refutes it."""
    typesetter = words.letters(outcome)
    for group in words.groups(outcome):
        yield heading(group)
        for row, decision in outcome.of_group(group):
            yield from row_lines(outcome, row, decision, typesetter, paper)
        yield ""


def rows_called(outcome: Outcome, name: str, paper: Publication) -> list[str]:
    """The rows of this name, label or printed number; their claims simplified."""
    typesetter = plain_letters(outcome)
    found = [p for p in outcome.rows if words.is_called(p[0], name, paper)]
    lines = (row_lines(outcome, row, decision, typesetter, paper) for row, decision in found)
    return [line for part in lines for line in part]


#: What stands before the words of a row whose claim is false, though nothing is held against it.
SAID = {REMARK: "false: ", OTHERWISE: "– "}


def row_lines(
    outcome: Outcome,
    row: Obligation,
    decision: Decision,
    typesetter: Typesetter,
    paper: Publication,
) -> Iterator[str]:
    """A row: its words, its claim, by what it is decided, and where it is false."""
    of_set = row.group in (PRINTED, REPAIRED)  # the heading says so
    role = " (as printed)" if row.role == PRINTED and not of_set else ""
    verdict = words.fair(outcome, row, decision)
    says = f"{SAID.get(verdict, '')}{row.says}"
    yield f"  {verdict:<9} {says}{role}   [{row.name}, {paper.cited(row.label)}]"
    uses = f"; with {', '.join(row.uses)}" if row.uses else ""
    by = f"by {decision.method or 'no rule that was found'}{uses}"
    claim, sides = typesetter.claim(row.claim), words.sides_of(row, decision)
    if sides is not None and isinstance(row.claim, Claim):
        yield f"            {claim}"
        yield f"            {words.sides_told(row, decision)}   {_margin(decision, sides) or by}"
    else:
        yield f"            {claim}   {by}"
    values = words.witness_of(row, decision)
    if values:
        yield f"            false at {words.values_told(values, typesetter)}"
    if decision.verdict == REFUTED:
        better = words.INSTEAD_WORDS.get(verdict, "corrected by")
        severity = paper.severity(row) if verdict == REFUTED else ""
        parts = (severity, row.corrected_by and f"{better} {row.corrected_by}")
        yield f"            {'; '.join(part for part in parts if part)}".rstrip()


def _margin(decision: Decision, sides: tuple[Ends, Ends]) -> str:
    """A lower bound of rhs - lhs, or of lhs - rhs if refuted, where enclosures show one."""
    (low, high), (other_low, other_high) = sides
    gap = other_low - high if decision.verdict == PROVED else low - other_high
    if gap <= 0 or decision.method != "interval":
        return ""
    sign = "" if decision.verdict == PROVED else "-"
    return f"margin {sign}{people(outward((gap, gap), 3)[0])}"


# --- terms that are easy to read -----------------------------------------------------------------

#: Fractions with a smaller denominator stay fractions.
LONG = 100


class PlainTypesetter(Typesetter):
    """Writes terms that have the same values as those that it is given, and are easier to read."""

    def claim(self, claim: Claim | Applies | Always) -> str:
        """The claim, its sides simplified."""
        return super().claim(simplified_claim(claim) if isinstance(claim, Claim) else claim)

    def term(self, term: Term) -> str:
        """The term, simplified."""
        return super().term(simplified(term))

    def _write(self, term: Term) -> str:
        if term.op == "rational" and term.value.denominator >= LONG:
            return exact_number(term.value)
        return super()._write(term)


def plain_letters(outcome: Outcome) -> PlainTypesetter:
    """A typesetter in the letters of an outcome, for what is shown and not checked."""
    return PlainTypesetter(letters(outcome).letters)
