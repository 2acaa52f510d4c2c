"""The files of the report."""

from __future__ import annotations

from collections.abc import Callable

from verify.jobs.covers import DEPTH
from verify.jobs.report import folder_names, read_material
from verify.paper.parameters import THEOREM
from verify.views.page.constants import latex
from verify.views.page.content import SUBTITLE, TITLE, content
from verify.views.page.html import html
from verify.views.page.text import markdown
from verify.views.plots import NUMBER, figures
from verify.views.plots.drawing import standalone, svg
from verify.views.plots.figure import Figure
from verify.views.plots.shapes import Panel


def number_of_steps(directory: str, *, draw: bool) -> int:
    """How often `files` tells its progress."""
    return len(folder_names(directory)) + 1 + (NUMBER if draw else 0)


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
    shown = figures(material.measurements.get("bench", {}).get("precision"), depth)
    drawings: dict[str, list[str]] = {}
    made: dict[str, bytes] = {}
    if draw:
        for figure in shown:
            progress(f"drawing {figure.name}")
            drawings[figure.name] = [
                svg(f"{figure.name}-{index}", [panel], alternative_text(figure, panel))
                for index, panel in enumerate(figure.panels)
            ]
        made["picture.svg"] = standalone(readme_picture(shown[0])).encode()
    blocks = content(material, drawings, shown)
    main = material.about(THEOREM)[0].outcome
    return {
        "index.html": html(TITLE, SUBTITLE, blocks).encode(),
        "index.md": markdown(TITLE, blocks).encode(),
        "constants.tex": latex(main).encode(),
        **made,
    }
