"""What a formula or a constant comes to: what is printed, what is true, and who uses it."""

from __future__ import annotations

from collections.abc import Iterator

from verify.language.statement import (
    NEEDED,
    OTHERWISE,
    PRINTED,
    PROVED,
    REFUTED,
    REMARK,
    REPAIRED,
    UNDECIDED,
    Constant,
    Obligation,
    Publication,
)
from verify.language.terms import Claim, names_of
from verify.prover.decimals import short
from verify.prover.outcome import Decision, Outcome
from verify.prover.uses import nodes
from verify.views.point import parameters_told
from verify.views.words import ends_of, fair, letters, short_name, sides_of

Row = tuple[Obligation, Decision]
SIGNS = {"<": "<", "<=": "≤", "=": "="}
#: What rows of the paper are called by the verdict on them, where it is worth a line each.
KINDS = {
    REFUTED: "printed, and false",
    OTHERWISE: "printed and true, but not by the printed argument",
    REMARK: "false, but the text does not claim it",
    UNDECIDED: "printed, and undecided",
}


def about_label(outcome: Outcome, label: str, paper: Publication) -> list[str]:
    """What stands at a label: what is false there, what is true, and who uses it."""
    rows = [pair for pair in outcome.rows if pair[0].label == label]
    if not rows:
        return []
    text = [f"{paper.cited(label)}{_place(outcome)}", f"  {_verdict(outcome, rows)}"]
    for verdict, title in KINDS.items():
        for row, found in rows:
            if row.role == PRINTED and fair(outcome, row, found) == verdict:
                text += _false(outcome, row, found, title)
    held = [row for row, d in rows if row.role == PRINTED and d.verdict == PROVED]
    true = [row for row, d in rows if row.role == NEEDED and d.verdict == PROVED]
    text += _named("printed, and proved", held) + _named("needed, and proved", true)
    return text + _named_names("used by", _users(outcome, {row.name for row, _ in rows}))


def _place(outcome: Outcome) -> str:
    return f", at {parameters_told(outcome)}" if outcome.statement.parameters else ""


def _verdict(outcome: Outcome, rows: list[Row]) -> str:
    """In a line: how many of the printed rows there are false, and whether what is needed holds."""
    printed = [fair(outcome, row, d) for row, d in rows if row.role == PRINTED]
    needed = [d.verdict for row, d in rows if row.role == NEEDED]
    parts = []
    if printed:
        parts.append(f"printed: {printed.count(REFUTED)} of {len(printed)} rows refuted")
    if needed:
        parts.append(f"needed: {needed.count(PROVED)} of {len(needed)} rows proved")
    return "; ".join(parts)


def _false(outcome: Outcome, row: Obligation, found: Decision, title: str) -> Iterator[str]:
    severity = f", {row.severity}" if fair(outcome, row, found) == REFUTED and row.severity else ""
    yield f"  {title}{severity}: {short_name(row)}: {row.says}"
    yield f"    {letters(outcome).claim(row.claim)}"
    yield from _numbers(row, found)
    better = next((p for p in outcome.rows if p[0].name == row.corrected_by), None)
    if better is not None:
        yield f"    {better[1].verdict} in its place: {better[0].name}: {better[0].says}"
        yield from _numbers(*better)


def _numbers(row: Obligation, found: Decision) -> Iterator[str]:
    sides = sides_of(row, found)
    if sides is not None and isinstance(row.claim, Claim):
        yield f"    {short(sides[0])} {SIGNS[row.claim.relation]} {short(sides[1])}"


def _named(title: str, rows: list[Obligation]) -> list[str]:
    return _named_names(title, [row.name for row in rows])


def _named_names(title: str, names: list[str]) -> list[str]:
    return [f"  {title}: {', '.join(names)}"] if names else []


def _users(outcome: Outcome, names: set[str]) -> list[str]:
    """What is proved from one of these facts."""
    return [node.name for node in nodes(outcome).values() if names & set(node.uses)]


def about_constant(outcome: Outcome, word: str, paper: Publication) -> list[str]:
    """A constant of Theorem 1 by its name or letter: as printed, repaired, and who uses it."""
    found = [c for c in outcome.statement.constants if word in (c.name, c.short_name, c.letter)]
    if not found:
        return []
    bounds = paper.notes().bounds
    text = [f"{found[0].letter}, {paper.cited(found[0].label)}{_place(outcome)}"]
    for constant in found:
        sign, bound = bounds.get(constant.name, ("=", constant))
        what = "repaired" if constant.name.startswith(f"{REPAIRED}.") else "as printed"
        text.append(f"  {what}: {_value(outcome, constant)}")
        text.append(f"    {bound.letter} {sign} {letters(outcome).term(bound.term)}")
    text += _doubts(outcome, found)
    names = {constant.name for constant in found}
    users = [short_name(row) for row, _ in outcome.rows if names & _names(row)]
    text += _named_names("used by the rows", list(dict.fromkeys(users)))
    if any(constant.name.startswith(f"{PRINTED}.") for constant in found):
        text.append(
            "  the set with the printed constants does what the theorem claims: "
            "certificates/printed-set"
        )
    return text


def _value(outcome: Outcome, constant: Constant) -> str:
    ends = ends_of(outcome, constant.name)
    return f"{constant.letter} = {'undefined' if ends is None else short(ends)}"


def _doubts(outcome: Outcome, constants: list[Constant]) -> list[str]:
    """What is false of the printed constant, as far as rows about it say; else that nothing is."""
    own = {constant.name for constant in constants if not constant.name.startswith(REPAIRED)}
    rows = [p for p in outcome.rows if fair(outcome, *p) == REFUTED and own & _names(p[0])]
    names = [f"{short_name(row)} ({row.severity})" for row, _ in rows]
    return _named_names("printed rows about it that are false", names)


def _names(row: Obligation) -> set[str]:
    claim = row.claim
    return set(names_of(claim.lhs, claim.rhs)) if isinstance(claim, Claim) else set()
