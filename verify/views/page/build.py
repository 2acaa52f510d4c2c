"""The files of the report."""

from __future__ import annotations

from verify.views.material import Material
from verify.views.page.constants import latex
from verify.views.page.content import TITLE, content, subtitle
from verify.views.page.html import html
from verify.views.page.text import markdown
from verify.views.plots import Pictures, collapses, figures, maps
from verify.views.plots.collapse import animation, film
from verify.views.plots.drawing import standalone, svg
from verify.views.plots.figure import Figure
from verify.views.plots.shapes import Panel


def alternative_text(figure: Figure, panel: Panel) -> str:
    """What a panel shows, for who does not see it."""
    return " ".join(part for part in (f"{figure.title}: {panel.title}.", panel.told) if part)


def readme_picture(figure: Figure) -> str:
    """All panels of a figure in one drawing."""
    return svg(
        "picture", figure.panels, " ".join(alternative_text(figure, p) for p in figure.panels)
    )


def files(material: Material, *, draw: bool) -> dict[str, bytes]:
    """Every file of the report; without drawings the page has none, and there is no picture."""
    precision = material.measurements.get("bench", {}).get("precision")
    plots = figures(material.plotted, precision)
    pictures = Pictures(plots, collapses(material.stories), maps(material.maps, material.strips))
    drawn: dict[str, list[str]] = {}
    made: dict[str, bytes] = {}
    if draw:
        for figure in pictures.all:
            drawn[figure.name] = [
                svg(f"{figure.name}-{index}", [panel], alternative_text(figure, panel))
                for index, panel in enumerate(figure.panels)
            ]
        for name, story in material.stories.items():
            drawn[name].insert(0, animation(film(story), name))
        made["picture.svg"] = standalone(readme_picture(plots[0])).encode()
    blocks = content(material, pictures, drawn)
    return {
        "index.html": html(TITLE, subtitle(material.paper), blocks).encode(),
        "index.md": markdown(TITLE, blocks).encode(),
        "constants.tex": latex(material.main).encode(),
        **made,
    }
