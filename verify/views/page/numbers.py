"""The constants, and the same theorem at other points."""

from __future__ import annotations

from collections.abc import Iterator

from verify.language.statement import PRINTED, PROVED, REFUTED, REPAIRED, Constant
from verify.language.terms import symbol
from verify.views.material import Material
from verify.views.page.blocks import (
    Block,
    Cell,
    Heading,
    Link,
    Math,
    Paragraph,
    Source,
    Table,
    Text,
    Verdict,
)
from verify.views.page.constants import latex
from verify.views.page.writer import (
    Writer,
    cell,
    label_cell,
    number_of,
    rows_as_printed,
    with_verdict,
)
from verify.views.point import place
from verify.views.words import constants_of, ends_of, headline


def constants(writer: Writer) -> Iterator[Block]:
    """The constants of both sets, with definitions and bounds."""
    outcome = writer.outcome
    yield Heading("constants", f"Constants at {place(outcome)}")
    yield Paragraph([Text(
        "Certified enclosures; touch a number for both ends (elsewhere they are its tooltip). The "
        "repaired constants are chosen: short decimals on the safe side of their bounds, so they "
        "are exact."
    )])  # fmt: skip
    bounds = writer.paper.notes().bounds
    groups = {
        "": "The first constants",
        PRINTED: "The set as printed",
        REPAIRED: "The repaired set",
    }
    for group, title in groups.items():
        rows = []
        for constant in constants_of(outcome, group):
            sign, bound = bounds[constant.name]
            rows.append(_constant(writer, constant, writer.term(bound.term, sign)))
        yield Table(title, ("Constant", "Value", "Definition or bound", "Label"), rows)
    yield Source("The constants as a LaTeX table (also in constants.tex)", latex(outcome))


def _constant(writer: Writer, constant: Constant, definition: Math) -> list[Cell]:
    letter = writer.term(symbol(constant.name))
    number = number_of(ends_of(writer.outcome, constant.name), unfolds=True)
    return [[letter], cell(number), [definition], label_cell(constant.label, writer.paper)]


def points(material: Material) -> Iterator[Block]:
    """A row for each point that has a certificate."""
    yield Heading("points", "The same at other points")
    rows: list[list[Cell]] = []
    for folder in material.about(material.paper.theorem):
        outcome = folder.outcome
        printed = rows_as_printed(outcome)
        rows.append([
            [Link(f"{folder.name}/report.md", place(outcome))],
            [Verdict(headline(outcome))],
            [Text(f"{len(with_verdict(outcome.of_group(REPAIRED), PROVED))} proved")],
            [Text(f"{len(with_verdict(printed, REFUTED))} of {len(printed)}")],
            *(cell(number_of(ends_of(outcome, f"{REPAIRED}.{name}")))
              for name in ("delta_x", "eta_bar", "zeta_bar", "T_star")),
        ])  # fmt: skip
    yield Table(
        "Certificates of Theorem 1",
        ("Point", "Verdict", "Repaired rows", "Printed steps refuted", "δ_x", "η̄", "ζ̄", "T*"),
        rows,
    )
