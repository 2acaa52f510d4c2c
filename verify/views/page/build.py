"""The files of the report."""

from __future__ import annotations

from collections.abc import Callable
from html import escape

from verify.jobs.covers import DEPTH
from verify.jobs.report import folder_names, read_material
from verify.paper.parameters import THEOREM
from verify.views.page.content import SUBTITLE, TITLE, content, latex
from verify.views.page.html import html
from verify.views.page.text import markdown
from verify.views.plots import NUMBER, figures
from verify.views.plots.drawing import Panel, standalone, svg

PICTURE_PANEL = (460, 400)


def number_of_steps(directory: str, *, draw: bool) -> int:
    """How often `files` tells its progress."""
    return len(folder_names(directory)) + 1 + (NUMBER if draw else 0)


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
        InputError: where nothing can draw.
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
                svg(f"{figure.name}-{index}", [panel], escape(f"{figure.title}: {panel.title}"))
                for index, panel in enumerate(figure.panels)
            ]
        width, height = PICTURE_PANEL
        panels = [Panel(p.title, p.draw, width, height) for p in shown[0].panels]
        made["picture.svg"] = standalone(svg("picture", panels, escape(shown[0].title))).encode()
    blocks = content(material, drawings, shown)
    main = material.about(THEOREM)[0].outcome
    return {
        "index.html": html(TITLE, SUBTITLE, blocks).encode(),
        "index.md": markdown(TITLE, blocks).encode(),
        "constants.tex": latex(main).encode(),
        **made,
    }
