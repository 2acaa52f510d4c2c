"""Decide whole boxes of scenes: which collapse, which disperse, and where the border is."""

from __future__ import annotations

import json
import os
import sys
from contextlib import ExitStack, suppress
from fractions import Fraction
from io import BytesIO

from verify import check_map
from verify.cli.files import print_document, read_bytes, write_all
from verify.cli.map_boxes import (
    axes_with_units,
    map_heading,
    scene_table,
    test_tables,
    write_tables,
)
from verify.cli.options import JSON, Options, Usage, chosen, leave_out
from verify.cli.scene_sample import point_in
from verify.cli.steps import MAX_JOBS
from verify.cli.terminal import erase, is_watched, width, wrapped
from verify.cli.terminal import progress as say_progress
from verify.language.errors import OwnError
from verify.language.record import TYPE_CHECKING
from verify.spheres.map.axes import axis_in, interval_in, plane_in
from verify.spheres.map.planes import Phi, Plane
from verify.spheres.map.strip import BorderStrip
from verify.spheres.parameters import neg_cos, restitution
from verify.wire.inputs import InputError, integer, positive, rational, share, shown

if TYPE_CHECKING:
    from typing import Any, BinaryIO

    from verify.spheres.map.grow import Sample, Target
    from verify.spheres.map.log import Progress
    from verify.spheres.map.saddle import Saddle

LOG, DOCUMENT, PICTURE, DOTS, TIMES = "map.jsonl", "map.json", "map.svg", "map.png", "times.csv"
UNDECIDED_CODE = 3
#: A strip has 2^6 parts and 2^6 rows of tiles, so many of them below the curve.
STRIP_LEVEL, BANDS_BELOW = 6, 16
#: And twice as many where δ is less than this.
FINE, FINER = Fraction(1, 10**7), Fraction(1, 10**8)
MAX_BOXES, MAX_LEVEL = 10**8, 26


USAGE = Usage(
    {
        "plane": "phi: of φ1 = eta_s/(-eta_c) and φ2 = d/eta_c²; or the file of a scene",
        "--r R": "phi: restitution coefficient in (0, 1)",
        "--neg-cos C": "phi: -cos of the angle, in (0, 1] (default 1)",
        "--speed V": "phi: -eta_c (default 1/100)",
        "--tangential U_C,U_S": "phi: tangential speeds (default 1,1)",
        "--x A..B": "φ1 (default 0..1/2); for a scene NAME=A..B: r, a parameter",
        "--y A..B": "φ2 (default 0..1/4), or another one: velocities[2][1]=-1..1",
        "--at POINT": "the other parameters of the scene file: NAME=A,NAME=B",
        "--strip DELTA": "phi: decide all but |φ2 - f(φ1)| < DELTA for a curve f",
        "--undecided P%": "stop at this share (default 1%)",
        "--boxes N": "stop after so many boxes (default 10^6)",
        "--level N": f"halve sides at most so often (default {MAX_LEVEL})",
        "--jobs N": "processes (default 1)",
        "--dask ADDRESS": "decide on a Dask cluster: tcp://HOST:PORT",
        "--out DIR": "write the log, or go on with it; areas and pictures",
        "--csv FILE": "a table with a line for each box: verdict, and its sides",
        "--middles": "scene files: decide the middle of each box, for table, pictures",
        "--show-boxes": "draw each box in the picture, and the undecided share against them",
        **JSON,
    },
    {"boxes": "1000000", "jobs": "1"},
    example="phi --r 0.03",
)


def read_plane(options: Options) -> Plane:
    """The plane: phi, or the file of a scene.

    Raises:
        InputError: if a number is not usable.
    """
    if options.plane.endswith(".toml"):
        return _read_scenes(options)
    if options.plane != "phi":
        raise InputError(f"plane: {shown(options.plane)} is no plane; write phi or a file .toml")
    if options.at is not None:
        raise InputError("--at: is for the file of a scene; leave it out")
    if options.r is None:
        raise InputError("--r: is missing; write a number like 0.03")
    r, c = restitution(options.r), neg_cos(chosen(options.neg_cos, "1"))
    speed = positive("--speed", chosen(options.speed, "1/100"))
    words = chosen(options.tangential, "1,1").split(",")
    if len(words) != 2:
        raise InputError(f"--tangential: {shown(options.tangential)} is no pair; write 1,1")
    u_c, u_s = (rational("--tangential", word) for word in words)
    width = "0..1/2" if options.strip is None else "1/100..9/25"
    x = interval_in("--x", chosen(options.x, width))
    y = interval_in("--y", chosen(options.y, "0..1/4"))
    if min(x[0], y[0]) < 0:
        raise InputError("--x, --y: φ1 and φ2 are not negative; write intervals from 0 on")
    return Phi(r, c, speed, (u_c, u_s), x, y)


def _read_scenes(options: Options) -> Plane:
    of_phi = ("r", "neg_cos", "speed", "tangential")
    leave_out(options, of_phi, "leave it out with the file of a scene")
    if options.x is None:
        raise InputError("--x: is missing; name what varies: --x r=0.01..0.08")
    written = {"--x": options.x} | ({} if options.y is None else {"--y": options.y})
    axes = [axis_in(option, text) for option, text in written.items()]
    fixed = {} if options.at is None else point_in("--at", options.at)
    plane = plane_in(options.plane, read_bytes("plane", options.plane), axes, fixed)
    if plane.r == 1:
        raise InputError(
            "plane: a map is about r < 1; of elastic scenes verify scene decides those of a --grid"
        )
    return plane


def run(options: Options) -> int:
    """Grow the map, write what is asked for, print the areas, return the exit code."""
    plane, delta = read_plane(options), _delta(options)
    least = share("--undecided", chosen(options.undecided, "1%")) if delta is None else Fraction(0)
    test_tables(options, plane)
    boxes = integer("--boxes", options.boxes, 1, MAX_BOXES)
    level = integer("--level", chosen(options.level, str(MAX_LEVEL)), 1, MAX_LEVEL)
    jobs = integer("--jobs", options.jobs, 1, MAX_JOBS)
    from verify.spheres.map.grow import Target  # numpy is loaded only where it is used
    from verify.spheres.map.log import LogMismatchError, Progress, plane_document
    from verify.views.map import area_shares, areas_of, map_lines, saddle_lines

    try:
        check_map.plane_of(plane_document(plane))
    except check_map.LogError as error:
        raise InputError(
            f"plane: the checker of maps cannot read it ({error}); write shorter terms, with "
            f"numbers of at most {check_map.MAX_DIGITS} digits"
        ) from error
    progress = Progress(plane if delta is None else _strip(plane, delta))
    try:
        _grow(options, progress, Target(least, boxes, level), jobs)
    except LogMismatchError as error:
        raise InputError(
            f"--out: {shown(os.path.join(options.out, LOG))} is no log of this map ({error}); "
            "name another folder"
        ) from error
    write_tables(options, progress, jobs)
    if options.json:
        print_document(_document(progress))
    else:
        lines = (*map_lines(progress, *_said(progress)), *saddle_lines(_saddle(progress.plane)))
        erase()
        columns = width() if sys.stdout.isatty() else sys.maxsize
        sys.stdout.write("".join(f"{line}\n" for line in wrapped(lines, columns)))
    left, areas = area_shares(progress)["undecided"], areas_of(progress)
    done = left <= least if delta is None else areas.is_strip
    return 0 if done else UNDECIDED_CODE


def _document(progress: Progress) -> dict[str, Any]:
    """The map with the theorems that the checker has taken for granted."""
    from verify.views.map import areas_of, map_document

    plane = check_map.plane_of(progress.document)
    return map_document(progress, check_map.cites(plane, areas_of(progress)))


def _said(progress: Progress) -> tuple[str, str]:
    """What the checker says of a map that it has accepted, and what it is given."""
    from verify.views.map import areas_of

    areas, plane = areas_of(progress), check_map.plane_of(progress.document)
    given = check_map.given(plane, areas)
    said = check_map.says(plane, areas) if areas.is_strip else check_map.hypotheses(plane)
    return said, given


def _saddle(plane: Plane | BorderStrip) -> Saddle | None:
    from verify.spheres.map.saddle import saddle  # loaded only where it is used

    phi = plane.phi if isinstance(plane, BorderStrip) else plane
    return saddle(phi) if isinstance(phi, Phi) else None


#: The φ1 that is proposed for a strip is a multiple of this.
PARTS = Fraction(1, 1000)


def _delta(options: Options) -> Fraction | None:
    if options.strip is None:
        return None
    delta = rational("--strip", options.strip)
    if options.plane != "phi" or options.undecided is not None:
        raise InputError("--strip: is for the plane phi, without --undecided")
    if not Fraction(1, 10**12) <= delta < Fraction(1, 100):
        raise InputError(f"--strip: {shown(options.strip)} is not usable; write 1e-6 or so")
    return delta


def _strip(plane: Plane, delta: Fraction) -> BorderStrip:
    from verify.spheres.map.curve import strip_along

    if not isinstance(plane, Phi) or plane.y[0] != 0:
        raise InputError("--strip: φ2 has to begin at 0")
    level = STRIP_LEVEL + (delta < FINE) + (delta < FINER)
    strip = strip_along(plane, delta, level, BANDS_BELOW << level - STRIP_LEVEL)
    width = (plane.x[1] - plane.x[0]) / len(strip.curve)
    for part, (c_0, c_1, c_2) in enumerate(strip.curve):
        spread = abs(c_1) * width / 2 + abs(c_2) * width**2 / 4 + delta
        if not spread < c_0 < plane.y[1] - spread:
            end = (plane.x[0] + width * (part - 1)) // PARTS * PARTS
            is_some = plane.x[0] < end
            there = f"--x {plane.x[0]}..{float(end)}" if is_some else "another --x"
            raise InputError(
                "--strip: no border so far from the axis in the whole interval of φ1; write "
                f"{there} or a smaller DELTA"
            )
    return strip


def _grow(options: Options, progress: Progress, target: Target, jobs: int) -> None:
    """Afterwards the target is reached, the log is checked, and the files are written."""
    from verify.spheres.map.grow import grow, open_log, write_line
    from verify.spheres.map.workers import workers

    with ExitStack() as stack:
        file: BinaryIO = BytesIO(progress.header)
        file.seek(0, os.SEEK_END)
        times: list[Sample] = []
        if options.out is not None:
            is_new = not os.path.isdir(options.out)
            try:
                os.makedirs(options.out, exist_ok=True)
                file = stack.enter_context(open_log(os.path.join(options.out, LOG), progress))
            except OSError as error:
                with suppress(OSError):  # somebody else has put something into it
                    if is_new:
                        os.rmdir(options.out)
                raise _unwritable(options, error) from error
            times = _read_times(options.out, progress)
        resumed = progress.boxes
        staff = stack.enter_context(workers(jobs, options.dask))
        spent = times[-1].seconds if times else 0.0

        def write(line: bytes) -> None:
            try:
                write_line(file, line)
            except OSError as error:
                raise _unwritable(options, error) from error

        for sample in grow(progress, target, staff, write):
            times.append(sample._replace(seconds=round(spent + sample.seconds, 3)))
            _watch(sample)
        file.seek(0)
        _judge(progress, file, os.path.join(options.out, LOG) if resumed else None)
        if options.out is not None:
            _write(options, progress, times)


def _unwritable(options: Options, error: OSError) -> InputError:
    why = f"{shown(options.out)} cannot be written ({error.strerror or error})"
    return InputError(f"--out: {why}; name a folder that can")


def _judge(progress: Progress, file: BinaryIO, resumed: str | None) -> None:
    """Afterwards all that is told of a log is what the checker has found in it.

    Raises:
        InputError: if it refuses a log of which a part was there before.
        OwnError: if it refuses one that was made here.
    """
    try:
        _, progress.areas = check_map.check_log(iter(file), most=None)
    except (check_map.RefusedError, check_map.LogError) as error:
        if resumed is None:
            raise OwnError(f"our own checker does not accept a box ({error})") from error
        raise InputError(
            f"--out: {shown(resumed)} is refused by verify/check_map.py ({error}); "
            "name another folder"
        ) from error


def _watch(sample: Sample) -> None:
    if is_watched():
        share = float(100 * sample.undecided)
        say_progress(f"{sample.boxes} boxes, {share:.4f} % undecided …")


def _read_times(folder: str, progress: Progress) -> list[Sample]:
    """The CPU seconds of earlier runs; none if they are not known for all boxes."""
    from verify.spheres.map.grow import Sample

    try:
        with open(os.path.join(folder, TIMES), encoding="utf-8") as file:
            rows = [line.split(",") for line in file.read().splitlines()[1:]]
        found = [Sample(int(b), Fraction(u), float(s)) for b, u, s in rows]
    except (OSError, ValueError, ZeroDivisionError):
        return []
    return found if found and found[-1].boxes == progress.boxes else []


def _write(options: Options, progress: Progress, times: list[Sample]) -> None:
    from verify.views.plots.map_picture import png_map, svg_map

    table = scene_table(options)
    names, lines = axes_with_units(progress, table), map_heading(options, progress, table)
    rows = "".join(f"{s.boxes},{s.undecided},{s.seconds:.3f}\n" for s in times)
    document = json.dumps(_document(progress), ensure_ascii=False, indent=1)
    files = {
        DOCUMENT: f"{document}\n".encode(),
        PICTURE: svg_map(progress, names, lines, boxes=options.show_boxes).encode(),
        DOTS: png_map(progress),
        TIMES: f"boxes,undecided,seconds\n{rows}".encode(),
    }
    write_all("--out", options.out, files)
