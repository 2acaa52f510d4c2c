"""The drawing of a scene, as a file."""

from __future__ import annotations

from verify.cli.files import write_file
from verify.spheres.scene.decide import Budget, Fate, decide_scene
from verify.spheres.scene.verdict import steps, told
from verify.wire.inputs import InputError

#: So many digits of the collapse time show how the end comes near.
DIGITS = 12


def write_plot(option: str, path: str, kind: str, found: Fate, limits: Budget) -> None:
    """Write the drawing (.svg) or the animation (.html).

    Raises:
        InputError: if the file cannot be written, or numbers are too large or small for a drawing.
    """
    try:
        text = _drawn(kind, found, limits)
    except (OverflowError, ZeroDivisionError) as error:
        raise InputError(
            f"{option}: numbers of this scene are too large or too small to draw; leave it out"
        ) from error
    write_file(option, path, text)


def _drawn(kind: str, found: Fate, limits: Budget) -> str:
    from verify.views.plots.scene_drawing import scene_page, scene_svg  # loaded only here

    if kind == ".html":
        return scene_page(told(found), steps(found))
    more = found
    if found.collapse is not None:
        digits = max(DIGITS, limits.digits or 0)
        more = decide_scene(found.flow.scene, limits._replace(digits=digits))
    if more.collapse is None:
        more = found
    return scene_svg(told(more)._replace(lines=told(found).lines), list(steps(more)))
