"""What is written of the boxes of a map: a table, and pictures coloured by their middles."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from fractions import Fraction
from functools import partial
from typing import Any

from verify.cli.files import read_bytes, write_all, write_file
from verify.cli.options import Options
from verify.cli.scene_sample import point_in
from verify.cli.steps import in_order, watched
from verify.language.record import TYPE_CHECKING
from verify.spheres.map.planes import FamilyPlane, Plane, Through
from verify.spheres.scene.families import read_family
from verify.spheres.scene.scene_files import LABELS
from verify.wire.inputs import InputError

if TYPE_CHECKING:
    from verify.spheres.map.log import Progress

#: A scene takes some milliseconds.
MAX_MIDDLES = 100_000


def test_tables(options: Options, plane: Plane) -> None:
    """Afterwards what is asked for can be written of such a map.

    Raises:
        InputError: if not.
    """
    if options.csv is not None and options.strip is not None:
        raise InputError("--csv: the tiles of a strip are no rectangles; leave out one of them")
    if not options.middles:
        return
    if not isinstance(plane, Through | FamilyPlane):
        raise InputError("--middles: is for the file of a scene; leave it out")
    if options.csv is None and options.out is None:
        raise InputError("--middles: add --csv FILE for a table, or --out DIR for pictures")


def write_tables(options: Options, progress: Progress, jobs: int) -> None:
    """Write the table and the pictures that are asked for."""
    if options.csv is None and not options.middles:
        return
    from verify.spheres.map.middles import boxes, middle  # loaded only where they are used
    from verify.views.map import axis_names, table_rows
    from verify.views.scene_table import csv_text

    found = list(boxes(progress))
    known = None
    if options.middles:
        if len(found) > MAX_MIDDLES:
            raise InputError(
                f"--middles: the map has {len(found)} boxes that were not divided; ask for at most "
                f"{MAX_MIDDLES}: --boxes {MAX_MIDDLES}"
            )
        plane: Any = progress.plane  # of scenes, as was tested
        known = list(watched(in_order(partial(middle, plane), found, jobs), len(found)))
    if options.csv is not None:
        rows = table_rows(axis_names(progress.document), found, known)
        write_file("--csv", options.csv, csv_text(rows))
    if known is not None and options.out is not None:
        write_all(
            "--out", options.out, _pictures(options, progress, list(zip(found, known, strict=True)))
        )


def _pictures(options: Options, progress: Progress, pairs: Sequence[Any]) -> dict[str, bytes]:
    from verify.views.plots.map_colours import COLOURINGS, coloured

    table, plane = scene_table(options), progress.plane
    time, lines = str(table.get("time_unit", "")), map_heading(options, progress, table)
    sides = [side for side in (plane.x, plane.y) if side is not None]
    axes: list[tuple[str, Fraction, Fraction]] = [
        (name, *side) for name, side in zip(axes_with_units(progress, table), sides, strict=False)
    ]
    return {
        f"map-{one.name}.svg": coloured(one, axes, pairs, lines, time).encode()
        for one in COLOURINGS
    }


def scene_table(options: Options) -> Mapping[str, Any]:
    """The scene file of a map; nothing without one."""
    if not options.plane.endswith(".toml"):
        return {}
    return read_family(options.plane, read_bytes("plane", options.plane)).table


def map_heading(options: Options, progress: Progress, table: Mapping[str, Any]) -> list[str]:
    """What stands above a picture: the title of the file, and what is the same in all of it."""
    from verify.views.map import plane_parts

    fixed = {} if options.at is None else point_in("--at", options.at)
    lines = str(table.get("title", "")), plane_parts(progress.document, fixed)[1]
    return [line for line in lines if line]


def axes_with_units(progress: Progress, table: Mapping[str, Any]) -> list[str]:
    """What the axes are, with the units of the file."""
    from verify.views.map import axis_names

    return [with_unit(name, table) for name in axis_names(progress.document)]


def with_unit(name: str, table: Mapping[str, Any]) -> str:
    """The name of an axis, with its unit where the file has units and it is clear which one it is.

    That is a place in the scene, or a parameter that is added to places or to velocities alone.
    """
    length, time = (str(table.get(key, "")) for key in ("length_unit", "time_unit"))
    units = {"positions": length, "velocities": f"{length}/{time}" if length and time else ""}
    place = name.partition("[")[0]
    found = [
        (key, str(cell))
        for key, given in table.items()
        if key not in LABELS
        for cell in re.findall(r"[^\[\],'\"]+", str(given))
        if re.search(rf"\b{re.escape(name)}\b", cell)
    ]
    if place not in units and not any({*"*/("} & {*cell} for _, cell in found):
        places = {key for key, _ in found}
        place = places.pop() if len(places) == 1 else ""
    return f"{name} ({units[place]})" if units.get(place) else name
