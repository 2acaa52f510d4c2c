"""The drawing of a scene, as a file."""

from __future__ import annotations

from verify.cli.files import write_file
from verify.spheres.scene.decide import Fate
from verify.spheres.scene.verdict import steps, told
from verify.wire.inputs import InputError


def write_plot(option: str, path: str, kind: str, found: Fate) -> None:
    """Write the drawing (.svg) or the animation (.html).

    Raises:
        InputError: if the file cannot be written, or numbers are too large or small for a drawing.
    """
    try:
        text = _drawn(kind, found)
    except (OverflowError, ZeroDivisionError) as error:
        raise InputError(
            f"{option}: numbers of this scene are too large or too small to draw; leave it out"
        ) from error
    write_file(option, path, text)


def _drawn(kind: str, found: Fate) -> str:
    from verify.views.plots.scene_drawing import scene_page, scene_svg  # loaded only here

    if kind == ".svg":
        return scene_svg(told(found), list(steps(found)))
    return scene_page(told(found), steps(found))
