"""What the report says, in the order in which a referee asks."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from verify.paper.commands.report import Material
from verify.paper.parameters import THEOREM
from verify.paper.source import AUTHORS, COMPANION
from verify.paper.source import TITLE as PAPER_TITLE
from verify.prover.outcome import Outcome
from verify.views.page import first, numbers, shown, theorems
from verify.views.page.appendix import digests, measurements
from verify.views.page.blocks import Block, Heading, Paragraph, Text
from verify.views.page.defects import changes, printed_proof
from verify.views.page.trust import trust
from verify.views.page.writer import Writer
from verify.views.plots import Pictures

TITLE = "Three particles collapse: what is proved"
SUBTITLE = (
    f"{AUTHORS}, {PAPER_TITLE} (its companion is {COMPANION}): Theorem 1 and the spectrum of its "
    "linear model, every inequality decided in rigorous arithmetic."
)
EVERYWHERE = f"{THEOREM} for all parameters"


def content(
    material: Material, everywhere: Outcome, pictures: Pictures, drawn: Mapping[str, Sequence[str]]
) -> list[Block]:
    """The blocks of the page; ``drawn`` has the panels of each figure that was drawn."""
    main = material.about(THEOREM)[0].outcome
    writer = Writer(main)
    region, *plots = shown.drawings(pictures.plots, drawn)
    return [
        *first.result(material.about(EVERYWHERE), main, theorems.others(material)),
        *first.command(),
        region,
        *first.numbers(main),
        *shown.proof(everywhere, main, draw=bool(drawn)),
        *shown.letters(draw=bool(drawn)),
        *printed_proof(writer),
        *changes(),
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
