"""The printed proof: what is refuted, in three classes, each with its smallest correction."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from verify.language.statement import (
    BREAKS,
    HARMLESS,
    HYPOTHESES,
    NEEDED,
    PROVED,
    REFUTED,
    REPAIRED,
    SLIP,
    UNDECIDED,
    Obligation,
    Publication,
)
from verify.language.terms import Claim, symbol
from verify.prover.decimals import outward, short
from verify.prover.outcome import Decision
from verify.views.page.blocks import (
    Block,
    Cell,
    Code,
    Heading,
    Inline,
    Math,
    Number,
    Paragraph,
    RefutedStep,
    RefutedSteps,
    Table,
    Text,
    Verdict,
)
from verify.views.page.writer import (
    SIGNS,
    Writer,
    label_cell,
    of_role,
    rows_as_printed,
    rows_table,
    sides_shown,
    with_verdict,
)
from verify.views.point import place
from verify.views.words import in_letters, sides_of, witness_shown

#: The classes, the worst first: anchor and title.
CLASSES = {
    BREAKS: ("breaking", "Steps that break the argument"),
    HARMLESS: ("harmless", "False, but harmless there"),
    SLIP: ("slips", "Slips of wording"),
}


def printed_proof(writer: Writer) -> Iterator[Block]:
    """The refuted steps by class, and all rows of both sets."""
    printed = rows_as_printed(writer.outcome)
    refuted, holding = with_verdict(printed, REFUTED), with_verdict(printed, PROVED)
    undecided = with_verdict(printed, UNDECIDED)
    yield Heading("printed", f"The printed proof: {len(refuted)} steps refuted")
    yield Paragraph([Text(
        f"At {place(writer.outcome)}. Each step is judged at the worst state that the printed set "
        "allows. A refuted one comes with certified enclosures of both sides (the digits shown are "
        "those on which both ends agree), or with exact values at which it is false; with what is "
        "wrong; and with the row that takes its place."
    )])  # fmt: skip
    for severity, (anchor, title) in CLASSES.items():
        part = [(row, found) for row, found in refuted if row.severity == severity]
        if part:
            yield Heading(anchor, f"{title} ({len(part)})", 3)
            yield RefutedSteps(_once([card(writer, *pair) for pair in part]))
    rest = [(row, found) for row, found in refuted if row.severity not in CLASSES]
    if rest:
        yield RefutedSteps([card(writer, *pair) for pair in rest])
    repaired = writer.outcome.of_group(REPAIRED)
    yield rows_table(
        writer, f"The {len(repaired)} rows of the repaired proof", repaired, "repaired"
    )
    yield rows_table(writer, f"The {len(holding)} printed steps that hold", holding)
    if undecided:
        yield rows_table(writer, f"The {len(undecided)} undecided printed steps", undecided)
    needed = of_role(writer.outcome.of_group(HYPOTHESES), NEEDED)
    yield rows_table(writer, f"The {len(needed)} hypotheses", needed)


def _once(steps: Sequence[RefutedStep]) -> list[RefutedStep]:
    """The steps, with what is wrong said where it is met first."""
    first: dict[str, str] = {}
    found = []
    for one in steps:
        before = first.setdefault(one.cause, one.name)
        again = one.cause and before != one.name
        found.append(one._replace(cause=f"The same as in `{before}`.") if again else one)
    return found


def card(writer: Writer, row: Obligation, found: Decision) -> RefutedStep:
    """A refuted row, what is wrong with it, and what takes its place."""
    claim = writer.claim(row.claim)
    lhs, rhs = sides_shown(row, found)
    cause = next((text for rows, text in writer.causes if row.name in rows), "")
    return RefutedStep(
        row.name,
        label_cell(row.label, writer.paper),
        in_letters(row.says),
        claim if isinstance(claim, Math) else Math("", "(long: see the statement file)"),
        lhs,
        rhs,
        _margin(writer, row, found),
        cause,
        _repair(writer, row),
    )


def _margin(writer: Writer, row: Obligation, found: Decision) -> Cell:
    """An enclosure of right - left, from the certified ends of both; or where the claim fails."""
    sides = sides_of(row, found)
    if sides is None:
        values = witness_shown(writer.outcome, row, found)
        where = ", ".join(
            f"{writer.plain(symbol(n))} = {writer.plain(t)}" for n, t in values.items()
        )
        return [Text(f"false at {where}" if where else "")]
    lhs, rhs = sides
    margin = (rhs[0] - lhs[1], rhs[1] - lhs[0])
    low, high = outward(margin, 20)
    return [Number(short(margin, 4), (low, high))]


def _repair(writer: Writer, row: Obligation) -> Cell:
    other = writer.rows.get(row.corrected_by or "")
    if other is None and row.corrected_by:
        return [
            Text("Corrected by "),
            Code(row.corrected_by),
            Text(", a row of another statement."),
        ]
    if other is None:
        return [Text("No repair is needed: nothing rests on it.")]
    needed, found = other
    parts: list[Inline] = [
        Verdict(found.verdict), Text(" "), Code(needed.name), Text(f": {needed.says}")
    ]  # fmt: skip
    claim = writer.claim(needed.claim)
    if claim is not None:
        parts += [Text(": "), claim]
    lhs, rhs = sides_shown(needed, found)
    if lhs is not None and rhs is not None and isinstance(needed.claim, Claim):
        parts += [Text(" that is, "), lhs, Text(f" {SIGNS[needed.claim.relation]} "), rhs]
    return parts


def changes(paper: Publication) -> Iterator[Block]:
    """What the repaired set changes."""
    yield Heading("changes", "What is changed")
    yield Table(
        "Paper, needed, why",
        ("Label", "Paper", "Needed", "Why"),
        [
            (label_cell(c.label, paper), [Text(c.paper)], [Text(c.needed)], [Text(c.why)])
            for c in paper.notes().changes
        ],
    )
