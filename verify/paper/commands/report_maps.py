"""The maps of a report, logs that their checker accepts; and collapses, followed closely."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Iterator, Mapping
from hashlib import sha256
from typing import Any

from verify import check_map
from verify.paper.commands.report_files import CertificateError, read_file
from verify.prover import balls
from verify.spheres.flow.collapse import find_collapse
from verify.spheres.map.log import Chunk, Progress
from verify.spheres.map.planes import FamilyPlane, Phi, Plane, Through
from verify.spheres.map.strip import BorderStrip
from verify.spheres.scene.decide import Budget, Fate, decide_scene
from verify.spheres.scene.scene import Coordinates, Scene
from verify.spheres.scene.verdict import shown_ends, steps, told
from verify.views.findings import CertifiedMap, CertifiedStrip, Instant, Story

LOG = ".jsonl"
#: So many digits of the collapse time are followed.
DIGITS = 6


def log_names(directory: str) -> list[str]:
    """The logs in the folders of a directory, and in the folders of these."""
    found = []
    for folder in sorted(os.listdir(directory)):
        for inner in ("", "strip"):
            path = os.path.join(directory, folder, inner)
            if os.path.isdir(path):
                found += [os.path.join(folder, inner, n) for n in sorted(os.listdir(path))]
    return [name for name in found if name.endswith(LOG)]


def is_strip(directory: str, name: str) -> bool:
    """Whether a log says that it encloses a border."""
    first = read_file(os.path.join(directory, name)).partition(b"\n")[0]
    return b'"plane":{"name":"strip"' in first


def read_strip(directory: str, name: str) -> CertifiedStrip:
    """Read a log that encloses a border, and check it and that every tile has a verdict.

    Raises:
        CertificateError: if it is no such log, or is not accepted.
    """
    found = read_map(directory, name, most=None)  # it takes longer than a map
    plane, areas = found.progress.plane, found.progress.areas
    if areas is None or not areas.is_strip or not isinstance(plane, BorderStrip):
        raise CertificateError(f"{os.path.join(directory, name)}: not all of it is decided", 1)
    return CertifiedStrip(name, plane, areas.proved, found.digest)


def read_map(directory: str, name: str, most: int | None = check_map.MAX_WORK) -> CertifiedMap:
    """Read a log, and check it with so much work.

    Raises:
        CertificateError: if it is not accepted.
    """
    path = os.path.join(directory, name)
    content = read_file(path)
    lines = content.splitlines(keepends=True)
    try:
        plane, areas = check_map.check_log(iter(lines), most)
    except check_map.RefusedError as error:
        raise CertificateError(f"{path}: its checker does not accept it ({error})", 1) from error
    except check_map.LogError as error:
        raise CertificateError(f"{path}: {error}", 4) from error
    progress = _appended(_plane_of(plane), map(json.loads, lines[1:]))
    progress.areas = areas
    return CertifiedMap(name, progress, sha256(content).hexdigest(), check_map.says(plane, areas))


def _appended(plane: Plane | BorderStrip, lines: Iterable[Mapping[str, Any]]) -> Progress:
    """What the lines of a log say."""
    progress = Progress(plane)
    for line in lines:
        progress.append(Chunk(line["keys"].split(" "), line["verdicts"], line["numbers"]))
    return progress


def _plane_of(found: check_map.Plane) -> Plane | BorderStrip:
    """The plane that the checker has read, for the program."""
    if isinstance(found, check_map.Strip):
        return BorderStrip(Phi(*found.phi), *found[1:])
    if isinstance(found, check_map.Phi):
        return Phi(*found)
    if isinstance(found, check_map.Family):
        coordinates = Coordinates(found.positions, found.velocities)
        return FamilyPlane(found.r, coordinates, found.axes, found.x, found.y)
    scene = Scene(found.r, found.positions, found.velocities)
    return Through(scene, *found[3:])


# --- collapses -----------------------------------------------------------------------------------


def story(scene: Scene) -> Story | None:
    """What there is to show of a scene of equal spheres; None if it is not proved to collapse."""
    found = decide_scene(scene, Budget(digits=DIGITS)) if scene.bodies is None else None
    if found is None or found.collapse is None:
        return None
    return Story(told(found), tuple(steps(found)), tuple(_instants(found)))


def _instants(found: Fate) -> Iterator[Instant]:
    """Each certain collision, with what the sharper theorem says just after it."""
    with balls.precision(found.flow.bits):
        for number, move in enumerate(found.flow.collisions, 1):
            time = balls.ends(balls.as_ball(move.after.time))
            end = find_collapse(found.flow.scene.r, move.after.state, move.after.time)
            if end is None:
                yield Instant(number, time, None)
            else:
                low, high = (balls.ends(balls.as_ball(x)) for x in end.time)
                yield Instant(number, time, (low[0], high[1]), shown_ends((low[0], high[1])))
