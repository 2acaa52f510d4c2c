"""What the report says, in the order in which a referee asks."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from verify.language.statement import Publication
from verify.views.material import Material
from verify.views.page import first, numbers, shown, theorems
from verify.views.page.appendix import digests, measurements
from verify.views.page.blocks import Block, Heading, Paragraph, Text
from verify.views.page.defects import changes, printed_proof
from verify.views.page.trust import trust
from verify.views.page.writer import Writer
from verify.views.plots import Pictures

TITLE = "Three particles collapse: what is proved"


def subtitle(paper: Publication) -> str:
    """Which paper the page is about."""
    return (
        f"{paper.authors}, {paper.title} (its companion is {paper.companion}): Theorem 1 and the "
        "spectrum of its linear model, every inequality decided in rigorous arithmetic."
    )


def content(
    material: Material, pictures: Pictures, drawn: Mapping[str, Sequence[str]]
) -> list[Block]:
    """The blocks of the page; ``drawn`` has the panels of each figure that was drawn."""
    main, paper = material.main, material.paper
    writer = Writer(main, paper)
    region, *plots = shown.drawings(pictures.plots, drawn)
    return [
        *first.result(material, theorems.others(material)),
        *first.command(),
        region,
        *first.numbers(main),
        *shown.proof(material, draw=bool(drawn)),
        *shown.letters(material, draw=bool(drawn)),
        *printed_proof(writer),
        *changes(paper),
        *shown.scenes(material, shown.drawings(pictures.collapses, drawn)),
        *shown.maps(material, shown.drawings(pictures.maps, drawn)),
        *theorems.classification(material),
        *theorems.in_short(material),
        *numbers.constants(writer),
        *numbers.points(material),
        Heading("plots", "Plots"),
        Paragraph([Text(
            "Nothing here is a sample: each band and each box encloses the values at every point "
            "of its interval or cell (ball arithmetic with the mean value theorem), and what "
            "enclosures do not decide is drawn as undecided."
        )]),
        *plots[:3],
        *trust(material),
        *theorems.row_by_row(material),
        *measurements(material, plots[3:]),
        *digests(material),
    ]  # fmt: skip
