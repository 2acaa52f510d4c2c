"""What people and scripts see of a map."""

from __future__ import annotations

import math
from collections.abc import Iterator
from fractions import Fraction
from typing import Any

from verify import check_map
from verify.language.errors import OwnError
from verify.prover.decimals import short
from verify.spheres.map.log import (
    COLLAPSES,
    DISPERSES,
    UNDECIDED,
    Progress,
    place_text,
    plane_document,
)
from verify.spheres.map.planes import Phi, Plane
from verify.spheres.map.saddle import saddle
from verify.spheres.map.strip import BorderStrip

DOCUMENT = "verify-map/1"
#: The three areas: their letters in a log, their names, and what is true of every scene in them.
AREAS = {
    COLLAPSES: ("collapses", "all its scenes collapse"),
    DISPERSES: ("disperses", "in all its scenes no two spheres meet any more after some time"),
    UNDECIDED: ("undecided", "nothing was proved"),
}


def areas_of(progress: Progress) -> check_map.Areas:
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
    found = {COLLAPSES: areas.collapses, DISPERSES: areas.disperses}
    found[UNDECIDED] = 1 - areas.collapses - areas.disperses
    return {name: found[letter] for letter, (name, _) in AREAS.items()}


def map_document(progress: Progress) -> dict[str, Any]:
    """The areas as JSON; every number that is not a count is a text."""
    return {
        "format": DOCUMENT,
        "command": "map",
        "plane": plane_document(progress.plane),
        "boxes": progress.boxes,
        "areas": {name: str(share) for name, share in area_shares(progress).items()},
        "judged_by": "verify/check_map.py",
        "cites": [*check_map.GIVEN],
        "strip": strip_document(progress),
    }


def strip_document(progress: Progress) -> dict[str, str] | None:
    """The strip, where all its tiles are proved."""
    plane = progress.plane
    if not isinstance(plane, BorderStrip) or not areas_of(progress).is_strip:
        return None
    return {"delta": str(plane.delta), "from": str(plane.x[0]), "to": str(plane.x[1])}


def plane_line(plane: Plane | BorderStrip) -> str:
    """The plane in a line."""
    if isinstance(plane, BorderStrip):
        return plane_line(plane.phi)
    if not isinstance(plane, Phi):
        x, y = axis_names(plane)
        return (
            f"{x} in [{plane.x[0]}, {plane.x[1]}], {y} in [{plane.y[0]}, {plane.y[1]}]; "
            f"r = {plane.r}"
        )
    u_c, u_s = plane.tangential
    return (
        f"φ1 = eta_s/(-eta_c) in [{plane.x[0]}, {plane.x[1]}], φ2 = d/eta_c² in "
        f"[{plane.y[0]}, {plane.y[1]}]; r = {plane.r}, -cos θ = {plane.neg_cos}, "
        f"-eta_c = {plane.speed}, tangential speeds {u_c} and {u_s}"
    )


def axis_names(plane: Plane | BorderStrip) -> tuple[str, str]:
    """What the two axes are."""
    if isinstance(plane, Phi | BorderStrip):
        return "φ1 = η_s/(-η_c)", "d/η_c²"
    return place_text(plane.x_at), place_text(plane.y_at)


def tile_corners(plane: BorderStrip, key: str) -> list[tuple[float, float]]:
    """Corners of a tile in a square: φ1, and |φ2 - f| from δ on, logarithmic, up and down."""
    scale = 2 * math.log(plane.y[1] / plane.delta)
    found = []
    for x, gap in plane.corners(key):
        height = math.log(max(float(abs(gap) / plane.delta), 1.0)) / scale
        share = (x - plane.x[0]) / (plane.x[1] - plane.x[0])
        found.append((float(share), 0.5 + math.copysign(height, gap)))
    return found


def map_lines(progress: Progress) -> Iterator[str]:
    """What the checker says, and the areas, for a reader."""
    areas, plane = areas_of(progress), check_map.plane_of(plane_document(progress.plane))
    yield check_map.says(plane, areas) if areas.is_strip else check_map.hypotheses(plane)
    found = area_shares(progress)
    for name, says in AREAS.values():
        if found[name]:
            yield f"{name:<10} {percent(found[name]):>9} %  {says}"
    yield f"{progress.boxes} boxes, down to 1/{4 ** (progress.level - 1)} of the area"
    yield f"checked by verify/check_map.py: {areas.proved} boxes with a verdict;"
    yield check_map.given()


def saddle_lines(plane: Plane | BorderStrip) -> Iterator[str]:
    """What is known of the border where η goes to 0."""
    phi = plane.phi if isinstance(plane, BorderStrip) else plane
    found = saddle(phi) if isinstance(phi, Phi) else None
    if found is not None:
        phi_1, phi_2, stable, unstable = (short(ends, 16) for ends in found)
        yield f"limiting map for η → 0: a saddle at φ1 = {phi_1}, φ2 = {phi_2}"
        yield f"  with the multipliers {unstable} and {stable}"


def percent(share: Fraction) -> str:
    """A share to four decimals of a percent, cut."""
    return f"{int(share * 10**6) // 10**4}.{int(share * 10**6) % 10**4:04d}"
