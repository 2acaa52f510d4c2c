"""The files of the report."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from verify.paper.commands.covers import DEPTH
from verify.paper.commands.everywhere import decide_everywhere
from verify.paper.commands.report import Material, folder_names, read_material
from verify.paper.commands.report_maps import log_names
from verify.paper.commands.scene_statements import read_back
from verify.paper.parameters import THEOREM
from verify.views.page.constants import latex
from verify.views.page.content import EVERYWHERE, SUBTITLE, TITLE, content
from verify.views.page.html import html
from verify.views.page.text import markdown
from verify.views.page.theorems import SCENES
from verify.views.plots import Pictures, collapses, figures, maps
from verify.views.plots.collapse import Story, animation, story
from verify.views.plots.drawing import standalone, svg
from verify.views.plots.figure import Figure
from verify.views.plots.shapes import Panel


def number_of_steps(directory: str, *, draw: bool) -> int:
    """How often `files` tells its progress."""
    return len(folder_names(directory)) + len(log_names(directory)) + (2 if draw else 1)


def alternative_text(figure: Figure, panel: Panel) -> str:
    """What a panel shows, for who does not see it."""
    return " ".join(part for part in (f"{figure.title}: {panel.title}.", panel.told) if part)


def readme_picture(figure: Figure) -> str:
    """All panels of a figure in one drawing."""
    return svg(
        "picture", figure.panels, " ".join(alternative_text(figure, p) for p in figure.panels)
    )


def files(
    directory: str, draw: bool, progress: Callable[[str], None], depth: int = DEPTH
) -> dict[str, bytes]:
    """Every file of the report; without drawings the page has none, and there is no picture.

    Args:
        directory: where the certificates are.
        draw: whether to draw.
        progress: is told what is being done.
        depth: how many times a side of the plane of parameters is halved.

    Raises:
        CertificateError: for files that cannot be used, or a certificate that is not accepted.
    """
    material = read_material(directory, progress)
    progress("enclosing what the plots show")
    found = [folder.outcome for folder in material.about(EVERYWHERE)]
    everywhere = found[0] if found else decide_everywhere()
    stories = dict(_stories(material))
    precision = material.measurements.get("bench", {}).get("precision")
    plots = figures(everywhere, precision, depth)
    pictures = Pictures(plots, collapses(stories), maps(material.maps, material.strips))
    drawn: dict[str, list[str]] = {}
    made: dict[str, bytes] = {}
    if draw:
        progress("drawing")
        for figure in pictures.all:
            drawn[figure.name] = [
                svg(f"{figure.name}-{index}", [panel], alternative_text(figure, panel))
                for index, panel in enumerate(figure.panels)
            ]
        for name, story in stories.items():
            drawn[name].insert(0, animation(story, name))
        made["picture.svg"] = standalone(readme_picture(plots[0])).encode()
    blocks = content(material, everywhere, pictures, drawn)
    main = material.about(THEOREM)[0].outcome
    return {
        "index.html": html(TITLE, SUBTITLE, blocks).encode(),
        "index.md": markdown(TITLE, blocks).encode(),
        "constants.tex": latex(main).encode(),
        **made,
    }


def _stories(material: Material) -> Iterator[tuple[str, Story]]:
    """The committed scenes that collapse."""
    for folder in material.folders:
        if folder.name.startswith(SCENES):
            scene = read_back(folder.outcome.statement.parameters)
            shown = None if scene is None else story(scene)
            if shown is not None:
                yield folder.name.removeprefix(SCENES), shown
