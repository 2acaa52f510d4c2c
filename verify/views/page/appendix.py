"""The end of the page: measurements and digests."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from verify import __version__
from verify.views.material import Material
from verify.views.page.blocks import (
    Block,
    Cell,
    Code,
    Heading,
    Paragraph,
    Raw,
    Table,
    Text,
)

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
    more = material.logs | material.digests
    rows += [[[Code(file)], [Code(digest)]] for file, digest in more.items()]
    yield Table("Files", ("File", "SHA-256"), rows, folded=True)
