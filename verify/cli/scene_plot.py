"""The drawing of a scene, as a file."""

from __future__ import annotations

import os

from verify.cli.files import write_all
from verify.prover.scene import Fate


def write_plot(option: str, path: str, kind: str, found: Fate) -> None:
    """Write the drawing (.svg) or the animation (.html)."""
    if kind == ".svg":
        from verify.views.plots.scene_drawing import scene_svg  # loaded only where it is used

        text = scene_svg(found)
    else:
        from verify.views.plots.scene_animation import scene_page

        text = scene_page(found)
    folder, name = os.path.split(path)
    write_all(option, folder or os.curdir, {name: text.encode()})
