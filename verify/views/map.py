"""What people and scripts see of a map."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import pairwise
from typing import Any

from verify.language.errors import OwnError
from verify.prover.decimals import exact_number, outward, short
from verify.prover.outcome import Ends
from verify.views.scene_table import DIGITS as TABLE_DIGITS
from verify.views.scene_table import Cells

DOCUMENT = "verify-map/1"

#: What the spheres know of a map: its boxes, and what the checker of maps has found in its log; and
#: what they know of a plane, or a strip of it. These are records of theirs, whose entries are read.
Progress = Any
Strip = Any
#: A plane as the log of a map has it.
Plane = Mapping[str, Any]

COLLAPSES, DISPERSES, FINITE, UNDECIDED = "c", "d", "f", "u"
#: The three areas: their letters in a log, their names, and what is true of every scene in them.
AREAS = {
    COLLAPSES: ("collapses", "all its scenes collapse"),
    DISPERSES: ("disperses", "in all its scenes no two spheres meet any more after some time"),
    UNDECIDED: ("undecided", "nothing was proved"),
}
#: One more, shown where there is such a verdict.
FINITELY = {FINITE: ("finite", "in all its scenes only finitely many collisions are possible")}


def areas_of(progress: Progress) -> Any:
    """What the checker has found.

    Raises:
        OwnError: if it was not asked.
    """
    if progress.areas is None:
        raise OwnError("the log of a map was not checked")
    return progress.areas


def area_shares(progress: Progress) -> dict[str, Fraction]:
    """The share of each area by the checker; they add up to 1."""
    areas = areas_of(progress)
    found = {COLLAPSES: areas.collapses, DISPERSES: areas.disperses, FINITE: areas.finite}
    found[UNDECIDED] = areas.undecided
    return {name: found[letter] for letter, (name, _) in areas_shown(progress).items()}


def areas_shown(progress: Progress) -> dict[str, tuple[str, str]]:
    """The areas: their letters, names, and what is true in them."""
    return AREAS | FINITELY if areas_of(progress).finite else AREAS


def map_document(progress: Progress, cites: Iterable[str]) -> dict[str, Any]:
    """The areas as JSON; every number that is not a count is a text.

    ``cites`` are the theorems that the checker takes for granted.
    """
    return {
        "format": DOCUMENT,
        "command": "map",
        "plane": progress.document,
        "boxes": progress.boxes,
        "areas": {name: str(share) for name, share in area_shares(progress).items()},
        "judged_by": "verify/check_map.py",
        "cites": [*cites],
        "strip": strip_document(progress),
        **interval_document(progress),
    }


def interval_document(progress: Progress) -> dict[str, Any]:
    """Of an interval of scenes: the parts with a verdict, and between what the borders lie."""
    if not is_interval(progress.document):
        return {}
    runs, names = areas_of(progress).runs, AREAS | FINITELY
    parts = [
        {"from": str(run.low), "to": str(run.high), "verdict": names[run.letter][0]} for run in runs
    ]
    return {"intervals": parts, "borders": [[*map(str, ends)] for ends in borders(progress)]}


def borders(progress: Progress) -> list[Ends]:
    """Between what the values lie where a parameter goes from collapses to finitely many."""
    return [
        (one.high, two.low)
        for one, two in pairwise(areas_of(progress).runs)
        if (one.letter == COLLAPSES) != (two.letter == COLLAPSES)
    ]


def is_interval(plane: Plane) -> bool:
    """Whether the plane is an interval: it has one parameter."""
    return "y" not in plane


def strip_document(progress: Progress) -> dict[str, str] | None:
    """The strip, where all its tiles are proved."""
    plane = progress.document
    if not is_strip(plane) or not areas_of(progress).is_strip:
        return None
    return {"delta": plane["delta"], "from": plane["x"][0], "to": plane["x"][1]}


def is_strip(plane: Plane) -> bool:
    """Whether a plane is a strip along a border."""
    return bool(plane["name"] == "strip")


def plane_line(plane: Plane) -> str:
    """The plane in a line."""
    return "; ".join(part for part in plane_parts(plane, {}) if part)


def plane_parts(plane: Plane, at: Mapping[str, Fraction]) -> tuple[str, str]:
    """What varies in a plane, and what does not; there parameters have values."""
    if plane["name"] not in ("scene", "family"):
        (x_0, x_1), (y_0, y_1), (u_c, u_s) = plane["x"], plane["y"], plane["tangential"]
        r, c, speed = (exact_number(Fraction(plane[key])) for key in ("r", "neg_cos", "speed"))
        return (
            f"φ₁ = η_s/(-η_c) in [{x_0}, {x_1}], φ₂ = d/η_c² in [{y_0}, {y_1}]",
            f"r = {r}, -cos θ = {c}, -η_c = {speed}, tangential speeds {u_c} and {u_s}",
        )
    sides = [(axis, plane[key]) for axis, key in zip(axis_names(plane), "xy", strict=True) if axis]
    axes, r = {key: axis for (axis, _), key in zip(sides, "xy", strict=False)}, plane["r"]
    found = {name: exact_number(value) for name, value in at.items()}
    if isinstance(r, str) and axes.get(r) != "r":
        found = {"r": axes[r] if r in axes else exact_number(Fraction(r))} | found
    return (
        ", ".join(f"{axis} in [{low}, {high}]" for axis, (low, high) in sides),
        ", ".join(f"{name} = {value}" for name, value in found.items()),
    )


def axis_names(plane: Plane) -> tuple[str, str]:
    """What the axes are."""
    if plane["name"] == "family":
        return plane["axes"][0], (*plane["axes"], "")[1]
    if plane["name"] == "scene":
        return plane["x_at"], plane["y_at"]
    return "φ1 = η_s/(-η_c)", "d/η_c²"


def tile_corners(plane: Strip, key: str) -> list[tuple[float, float]]:
    """Corners of a tile in a square: φ1, and |φ2 - f| from δ on, logarithmic, up and down."""
    scale = 2 * math.log(plane.y[1] / plane.delta)
    found = []
    for x, gap in plane.corners(key):
        height = math.log(max(float(abs(gap) / plane.delta), 1.0)) / scale
        share = (x - plane.x[0]) / (plane.x[1] - plane.x[0])
        found.append((float(share), 0.5 + math.copysign(height, gap)))
    return found


def map_lines(progress: Progress, said: str, given: str) -> Iterator[str]:
    """What the checker says, and is given, and the areas, for a reader."""
    areas = areas_of(progress)
    yield said
    found = area_shares(progress)
    for name, says in areas_shown(progress).values():
        if found[name]:
            yield f"{name:<10} {percent(found[name]):>9} %  {says}"
    if is_interval(progress.document):
        yield from interval_lines(progress)
    parts, whole = len(progress.digits) ** (progress.level - 1), "area"
    if is_interval(progress.document):
        whole = "interval"
    yield f"{progress.boxes} boxes, down to 1/{parts} of the {whole}"
    yield f"checked by verify/check_map.py: {areas.proved} boxes with a verdict;"
    yield given


def interval_lines(progress: Progress) -> Iterator[str]:
    """The parts of an interval of scenes, and where its borders lie, for a reader."""
    name, names = progress.document["axes"][0], AREAS | FINITELY
    for run in areas_of(progress).runs:
        yield f"  {name} in {_between((run.low, run.high))}: {names[run.letter][0]}"
    found = borders(progress)
    for ends in found:
        yield f"a critical {name} lies in {_between(ends)}"
    if len(found) == 0:
        yield f"no critical {name} was found in this interval"


def _between(ends: Ends) -> str:
    low, high = map(exact_number, ends)
    return f"[{low}, {high}]"


def saddle_lines(found: tuple[Ends, Ends, Ends, Ends] | None) -> Iterator[str]:
    """What is known of the border where η goes to 0: a saddle, and its two multipliers."""
    if found is not None:
        phi_1, phi_2, stable, unstable = (short(ends, 16) for ends in found)
        yield f"limiting map for η → 0: a saddle at φ1 = {phi_1}, φ2 = {phi_2}"
        yield f"  with the multipliers {unstable} and {stable}"


def percent(share: Fraction) -> str:
    """A share to four decimals of a percent, cut."""
    return f"{int(share * 10**6) // 10**4}.{int(share * 10**6) % 10**4:04d}"


# --- the boxes, as a table with commas ------------------------------------------------------------

#: A box, and what is known of the scene in its middle: records of `verify.spheres.map.middles`.
Box = Any
Middle = Any
#: What is told of the scene in the middle of a box.
OF_MIDDLE = ("middle_verdict", "middle_reason", "central", "collisions", "time_low", "time_high")
#: Ends of boxes have so many digits as decimals, and else are fractions.
MANY = 60


def table_rows(
    axes: Sequence[str], boxes: Iterable[Box], middles: Iterable[Middle] | None
) -> Iterator[Cells]:
    """A head, and a line for each box; with the scene in its middle, if there is one."""
    names = [f"{axis}_{end}" for axis in axes if axis for end in ("low", "high")]
    yield ("verdict", *names, *(OF_MIDDLE if middles is not None else ()))
    known = None if middles is None else iter(middles)
    for box in boxes:
        yield (*_of_box(box), *(() if known is None else _of_middle(next(known))))


def _of_box(box: Box) -> Iterator[str]:
    yield (AREAS | FINITELY)[box.letter][0]
    for side in (box.x, box.y):
        if side is not None:
            yield from (exact_number(end, MANY) for end in side)


def _of_middle(middle: Middle) -> Cells:
    time: Sequence[str] = ("", "")
    if middle.time is not None:
        time = outward(middle.time, TABLE_DIGITS)
    central = "" if middle.central is None else str(middle.central)
    return (middle.verdict, middle.reason, central, str(middle.collisions), *time)


def middle_time(middle: Middle) -> Fraction | None:
    """About when the scene collapses."""
    return None if middle.time is None else (middle.time[0] + middle.time[1]) / 2
