"""Decide what becomes of given particles: collapses, disperses, finite, or undecided."""

from __future__ import annotations

import os
import sys
from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from verify.cli.files import SCENES, example, print_document, read_bytes, test_folder, write_file
from verify.cli.options import CERTIFICATE, COLOR, JSON, Options, Usage
from verify.cli.steps import MAX_JOBS
from verify.cli.terminal import FIXED, show
from verify.spheres.scene.afterwards import afterwards, collisions_until
from verify.spheres.scene.decide import MAX_DIGITS, Budget, Fate, decide_scene
from verify.spheres.scene.scene import Scene
from verify.spheres.scene.scene_files import read_scene
from verify.spheres.scene.verdict import shown_ends, steps, told
from verify.views.scene import (
    afterwards_lines,
    collision_table,
    cutoff_document,
    cutoff_line,
    exit_code,
    given_line,
    judge_of,
    scene_document,
)
from verify.wire.inputs import InputError, integer, positive, shown

#: So many digits of the collapse time show how the end comes near.
PLOT_DIGITS = 12

USAGE = Usage(
    {
        "scene": f"a scene file, a folder of them, or an example: {', '.join(SCENES)}",
        "--digits N": "of three particles: digits of time, final angle and velocities",
        "--cutoff T": "of three: after how many collisions less time than T is left to a collapse",
        "--until T": "follow the particles, three or more, to this time",
        "--collisions N": "how many are followed (default 1000)",
        "--precision BITS": "bits to begin with (default 128)",
        "--max-precision BITS": "last bits (default 4096)",
        "--jobs N": "for a folder: processes at a time (default 1)",
        "-v, --verbose": "a table of the collisions, and what comes after a collapse",
        **JSON,
        **COLOR,
        "--at POINT": "of a family of scenes this one, or those with these: NAME=A,NAME=B",
        "--grid AXES": "of a family of scenes decide evenly spaced ones: NAME=A..B:N,…",
        "--sample N": "of a family of scenes decide so many random ones",
        "--seed S": "of the random numbers (default 1)",
        "--confidence P%": "of the shares in a sample (default 95%)",
        **CERTIFICATE,
        "--csv FILE": "a table with a line for each scene, or for each collision of many particles",
        "--trajectory FILE": "of three: a table of centres and velocities after each collision",
        "--plot FILE": "draw three, or a sample: .svg; three also as .html with an animation",
    },
    {
        "collisions": "1000",
        "precision": "128",
        "max_precision": "4096",
        "jobs": "1",
        "seed": "1",
        "confidence": "95%",
    },
    example="bead",
)


def budget(options: Options) -> Budget:
    """How far scenes are followed."""
    digits = None if options.digits is None else integer("--digits", options.digits, 1, MAX_DIGITS)
    bits = integer("--precision", options.precision, 8, 1 << 16)
    last = integer("--max-precision", options.max_precision, 8, 1 << 16)
    if last < bits:
        raise InputError(f"--max-precision: {last} is below --precision {bits}; write {bits}")
    return Budget(integer("--collisions", options.collisions, 0, 10**7), digits, bits, last)


def run(options: Options) -> int:
    """Print the verdict, write what is asked for, return the exit code."""
    options.scene = example(options.scene)
    limits, jobs = budget(options), integer("--jobs", options.jobs, 1, MAX_JOBS)
    cutoff = None if options.cutoff is None else positive("--cutoff", options.cutoff)
    if cutoff and (os.path.isdir(options.scene) or options.sample or options.grid):
        raise InputError("--cutoff: it is for one scene; leave it out")
    if options.until and (os.path.isdir(options.scene) or options.sample or options.grid):
        raise InputError("--until: it is for one scene; leave it out")
    if os.path.isdir(options.scene):
        from verify.cli.scene_folder import run_folder  # loaded only where it is used

        return run_folder(options, limits, jobs)
    if options.sample is not None or options.grid is not None:
        from verify.cli import scene_sample  # loaded only where it is used

        run_points = scene_sample.run_grid if options.sample is None else scene_sample.run_sample
        return run_points(options, limits, jobs)
    if jobs > 1:
        raise InputError("--jobs: leave it out with one scene")
    table = _table_of_many(options)
    if table is not None:
        from verify.cli.scene_many import run_many  # loaded only where it is used

        until = None if options.until is None else positive("--until", options.until)
        return run_many(options, table, limits, until)
    test_folder("--out", options.out, "statement.json", "certificate.json")
    plot = _plot_kind(options.plot)
    scene, values = _scene(options)
    found = decide_scene(scene, limits)
    judge = judge_of(_has_certificate(options.out, found))
    if plot is not None:
        write_file("--plot", options.plot, _drawing(plot, found, limits))
    _write_tables(options, found, judge, values)
    count = None if cutoff is None else collisions_until(found, cutoff, limits)
    if options.json:
        print_document(
            scene_document(told(found), afterwards(found, limits), judge)
            | ({} if cutoff is None else {"cutoff": cutoff_document(cutoff, count)})
        )
    else:
        more = [] if cutoff is None else [cutoff_line(found.verdict, options.cutoff, count)]
        show([*_text(found, judge, limits, options), *more], options)
    return exit_code(told(found))


def _table_of_many(options: Options) -> dict[str, Any] | None:
    """What is in a file of more particles, walls, gravity or a box; None for a scene of three."""
    if options.at is not None:
        return None
    from verify.spheres.many.particles_file import ENDINGS  # loaded only where they are used
    from verify.spheres.many.system_file import is_many, table_in

    if options.scene.endswith(ENDINGS):
        raise InputError(
            f"scene: {shown(options.scene)} is a table of particles, without r; write a scene file "
            f"with the lines r = 0.03 and particles = {shown(options.scene)}"
        )
    table = table_in(options.scene, read_bytes("scene", options.scene))
    return table if is_many(table) or options.until is not None else None


def _scene(options: Options) -> tuple[Scene, Mapping[str, Fraction]]:
    """The scene, and the parameters that it has in its family."""
    if options.at is None:
        return read_scene(options.scene, read_bytes("scene", options.scene)), {}
    from verify.cli.scene_sample import scene_at  # loaded only where it is used

    return scene_at(options)


def _plot_kind(path: str | None) -> str | None:
    if path is None:
        return None
    kind = os.path.splitext(path)[1]
    if kind not in (".svg", ".html"):
        raise InputError(f"--plot: {shown(path)} ends in neither .svg nor .html; write one of them")
    return kind


def _drawing(kind: str, found: Fate, limits: Budget) -> str:
    """The drawing (.svg) or the animation (.html).

    Raises:
        InputError: if numbers are too large or small for a drawing.
    """
    from verify.cli.drawable import drawable  # loaded only here
    from verify.views.plots.scene_drawing import scene_page, scene_svg

    with drawable():
        if kind == ".html":
            return scene_page(told(found), steps(found))
        more = found
        if found.collapse is not None:
            digits = max(PLOT_DIGITS, limits.digits or 0)
            more = decide_scene(found.flow.scene, limits._replace(digits=digits))
        if more.collapse is None:
            more = found
        return scene_svg(told(more)._replace(lines=told(found).lines), list(steps(more)))


def _has_certificate(out: str | None, found: Fate) -> bool:
    """Write the certificate that is asked for; a line on stderr where there can be none."""
    if out is None:
        return False
    from verify.cli.scene_certificate import write_scene  # loaded only where it is used

    missing = write_scene("--out", out, found)
    if missing:
        print(f"verify: --out: {missing}; no certificate was written", file=sys.stderr)
    return not missing


def _write_tables(
    options: Options, found: Fate, judge: str, values: Mapping[str, Fraction]
) -> None:
    """The tables that are asked for."""
    if options.csv is None and options.trajectory is None:
        return
    from verify.spheres.scene.trajectory import trajectory  # loaded only where it is used
    from verify.views import scene_table as table

    if options.csv is not None:
        heads = (*table.parameter_heads(values), *table.COLUMNS)
        row = table.cells(os.path.basename(options.scene), told(found), judge)
        rows = [heads, (*table.parameter_cells(values), *row)]
        write_file("--csv", options.csv, table.csv_text(rows))
    if options.trajectory is not None:
        instants = table.trajectory_rows(trajectory(found), found.flow.scene.dimension)
        write_file("--trajectory", options.trajectory, table.csv_text(instants))


def _text(found: Fate, judge: str, limits: Budget, options: Options) -> list[str]:
    known = told(found)
    lines = [*known.lines, *filter(None, [known.degrees, given_line(known, judge)])]
    if not options.verbose or not found.flow.collisions:
        return lines
    unit = known.scene.labels.time_unit
    table = [*collision_table(steps(found), known.bits, unit), ""]
    after = afterwards(found, limits)
    more = [] if after is None else [*afterwards_lines(after, shown_ends), ""]
    return [*(row.replace(" ", FIXED) for row in table), *more, *lines]  # a row stays a line
