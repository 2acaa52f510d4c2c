"""What is shown rather than said: letters, the proof as a graph, scenes, maps."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from verify.language.statement import NEEDED
from verify.views.material import Material
from verify.views.page import blueprint
from verify.views.page.blocks import (
    Block,
    Cell,
    Code,
    Drawing,
    Heading,
    Link,
    Paragraph,
    Table,
    Text,
    Verdict,
)
from verify.views.page.first import title_of
from verify.views.page.theorems import SCENES
from verify.views.page.writer import label_cell
from verify.views.plots.figure import Figure
from verify.views.plots.letters import letters_drawing
from verify.views.point import place
from verify.views.words import counts, headline


def letters(material: Material, *, draw: bool) -> Iterator[Block]:
    """What each letter stands for."""
    yield Heading("letters", "The letters")
    caption = "Three spheres just after a collision of 0 and s; the next one is that of 0 and c."
    figure = Figure("letters", "A state just after a collision", caption, ())
    yield Drawing(figure, [letters_drawing()] if draw else [])
    rows = [
        ([Text(letter)], [Text(says)], label_cell(label, material.paper))
        for letter, says, label in material.letters
    ]
    yield Table("What each letter stands for", ("Letter", "Meaning", "Paper"), rows, folded=True)


def proof(material: Material, *, draw: bool) -> Iterator[Block]:
    """The formulas of the proof, and which rests on which."""
    everywhere, main = material.plotted.region.everywhere, material.main
    yield Heading("proof", "The proof as a graph")
    caption = (
        f"Each box is a formula of the paper, by its printed number; lines lead down from what it "
        f"rests on, as far as other lines do not say so already. A box leads to its rows. Hatched: "
        f"printed steps with this label are refuted at {place(main)}. All facts, "
        f"{len(everywhere.steps)} steps of the certificate, one by one: verify graph --out "
        "proof.svg."
    )
    figure = Figure("proof", "Theorem 1, repaired, for all parameters", caption, ())
    drawn = [blueprint.proof_drawing(everywhere, main, material.paper)] if draw else []
    yield Drawing(figure, drawn)


def scenes(material: Material, collapses: Sequence[Drawing]) -> Iterator[Block]:
    """The committed scenes, and those that collapse as animations."""
    found = [folder for folder in material.folders if folder.name.startswith(SCENES)]
    if not found:
        return
    yield Heading("scenes", "Scenes: what happens to three given particles")
    rows: list[list[Cell]] = [
        [
            [Link(f"{folder.name}/report.md", folder.name.removeprefix(SCENES))],
            [Text(title_of(folder.outcome))],
            [Verdict(headline(folder.outcome))],
            [Text(counts(folder.outcome, NEEDED))],
        ]
        for folder in found
    ]
    yield Table("Certificates of scenes", ("Scene", "What is proved", "Verdict", "Claims"), rows)
    yield from collapses


def maps(material: Material, drawn: Sequence[Drawing]) -> Iterator[Block]:
    """The committed maps, with what their checker says."""
    if not material.maps:
        return
    yield Heading("maps", "Maps: which scenes collapse, and where the border is")
    logs = ", ".join(found.name for found in material.maps)
    yield Paragraph([
        Text("A map decides whole boxes of scenes at once: in each either every scene collapses, "
             "or every one disperses (no two spheres meet any more after some time), or nothing "
             "is proved of it. The checker of maps, "), Code("verify/check_map.py"),
        Text(", has accepted what is drawn here ("), Code(logs), Text(")."),
    ])  # fmt: skip
    yield from drawn


def drawings(figures: Sequence[Figure], panels: Mapping[str, Sequence[str]]) -> list[Drawing]:
    """The figures with their panels, if they were drawn."""
    return [Drawing(figure, panels.get(figure.name, ())) for figure in figures]
