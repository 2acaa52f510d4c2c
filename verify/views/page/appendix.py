"""The end of the page: measurements, what is taken on trust, digests."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from verify import __version__
from verify.jobs.report import Material
from verify.language.statement import Assumption
from verify.views.page.blocks import (
    Block,
    Cell,
    Code,
    Heading,
    Items,
    Paragraph,
    Raw,
    Strong,
    Table,
    Text,
)
from verify.views.page.writer import label_cell

#: A table with more rows than this is folded.
UNFOLDED = 16


def measurements(material: Material, drawn: Sequence[Block]) -> Iterator[Block]:
    """The committed measurements; what is drawn of them stands with the first."""
    titles = {
        "bench": ("speed", "Appendix: speed", "verify bench"),
        "stress": ("stability", "Appendix: numerical stability on hard cases", "verify stress"),
    }
    for name, tables in material.measurements.items():
        anchor, title, command = titles[name]
        yield Heading(anchor, title)
        yield Paragraph([Text("As measured and committed; made anew by "), Code(command),
                         Text(".")])  # fmt: skip
        if name == "bench":
            yield from drawn
        for table in tables.values():
            rows = [[[Raw(str(value))] for value in row] for row in table["rows"]]
            yield Table(table["title"], table["columns"], rows, len(rows) > UNFOLDED)


def assumptions(material: Material) -> Iterator[Block]:
    """The assumptions of each theorem."""
    yield Heading("trust", "Taken on trust")
    yield Paragraph([Text(
        "What is used and not proved by the program, here or in a statement that is cited. The "
        "checker prints the names with each verdict."
    )])  # fmt: skip
    seen: set[str] = set()
    for folder in material.folders:
        statement = folder.outcome.statement
        if statement.theorem not in seen:
            seen.add(statement.theorem)
            yield Paragraph([Strong("For "), Code(statement.theorem), Text(":")])
            yield Items([_assumption(a) for a in folder.outcome.assumptions])
            if folder.outcome.printed_assumptions:
                yield Paragraph([Text("and for its printed rows only:")])
                yield Items([_assumption(a) for a in folder.outcome.printed_assumptions])


def _assumption(assumption: Assumption) -> Cell:
    return [*label_cell(assumption.label), Text(f" ({assumption.kind}): {assumption.sentence}")]


def digests(material: Material) -> Iterator[Block]:
    """Which files are behind the page."""
    yield Heading("versions", "Appendix: versions and digests")
    yield Paragraph([Text(f"verify-collapse {__version__}. SHA-256 of the files behind this page; "
                          "a certificate carries the digest of its statement.")])  # fmt: skip
    rows: list[list[Cell]] = [
        [[Code(f"{folder.name}/{file}")], [Code(digest)]]
        for folder in material.folders
        for file, digest in folder.digests.items()
    ]
    rows += [[[Code(file)], [Code(digest)]] for file, digest in material.digests.items()]
    yield Table("Files", ("File", "SHA-256"), rows, folded=True)
