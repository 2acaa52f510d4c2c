"""The theorems that hold for all values: the classification, the others in short, row by row."""

from __future__ import annotations

from collections.abc import Iterator

from verify.language.statement import NEEDED, PRINTED, PROVED, REFUTED, UNDECIDED, Publication
from verify.views.classification import SETTING, THEOREMS
from verify.views.material import CertifiedOutcome, Material
from verify.views.page.blocks import (
    Block,
    Cell,
    Heading,
    Items,
    Link,
    Paragraph,
    RefutedSteps,
    Table,
    Text,
    Verdict,
)
from verify.views.page.defects import card
from verify.views.page.first import title_of
from verify.views.page.writer import Writer, plain_rows, with_verdict
from verify.views.words import counts, given_by, headline

#: Where the scenes are: a folder of folders.
SCENES = "scenes/"


def others(material: Material) -> list[CertifiedOutcome]:
    """What is proved besides the theorem at points, and the scenes."""
    return [
        folder
        for folder in material.folders
        if folder.outcome.statement.theorem != material.paper.theorem
        and not folder.name.startswith(SCENES)
    ]


def classification(material: Material) -> Iterator[Block]:
    """The four theorems on collapses, in words, if they are proved."""
    for folder in material.about("classification"):
        outcome = folder.outcome
        if headline(outcome) == PROVED:
            given = given_by(outcome, material.paper)
            yield Heading("collapses", "Classification: which collapses there are")
            yield Paragraph([
                Verdict(PROVED), Text(f" {counts(outcome, NEEDED)}; given {given} ("),
                Link(f"#{folder.name}", "row by row"), Text(f"). {SETTING}"),
            ])  # fmt: skip
            yield Items([[Text(theorem)] for theorem in THEOREMS])


def in_short(material: Material) -> Iterator[Block]:
    """The other theorems, a row each."""
    found = others(material)
    if not found:
        return
    yield Heading("others", "What else is proved")
    rows: list[list[Cell]] = []
    for folder in found:
        outcome = folder.outcome
        claims = (counts(outcome, NEEDED), counts(outcome, PRINTED))
        rows.append([
            [Link(f"#{folder.name}", title_of(outcome))],
            [Verdict(headline(outcome))],
            [Text("; ".join(part for part in claims if part))],
            [Text(given_by(outcome, material.paper))],
        ])  # fmt: skip
    yield Table("Theorems for all values", ("Theorem", "Verdict", "Claims", "Given"), rows)


def row_by_row(material: Material) -> Iterator[Block]:
    """The rows of the other theorems, the refuted ones as cards."""
    found = others(material)
    if found:
        yield Heading("rows", "Appendix: the other theorems, row by row")
    for folder in found:
        yield from _rows(folder, material.paper)


def _rows(folder: CertifiedOutcome, paper: Publication) -> Iterator[Block]:
    outcome = folder.outcome
    yield Heading(folder.name, title_of(outcome), 3)
    writer = Writer(outcome, paper)
    refuted = with_verdict(outcome.rows, REFUTED)
    rest = [(row, found) for row, found in outcome.rows if found.verdict != REFUTED]
    if refuted:
        yield Paragraph([Text(
            f"{len(refuted)} printed claims are refuted; each has a point at which it is false "
            "in the certificate, and the claim that takes its place:"
        )])  # fmt: skip
        yield RefutedSteps([card(writer, *pair) for pair in refuted])
    undecided = with_verdict(rest, UNDECIDED)
    more = f", and {len(undecided)} are undecided" if undecided else ""
    yield Paragraph([Text(
        f"{len(with_verdict(rest, PROVED))} claims are proved, each by a rule of the checker{more}."
    )])  # fmt: skip
    yield plain_rows(writer, f"The {len(rest)} claims, one by one", rest)
