"""The maps of a report: logs that their checker accepts, read back."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Mapping
from hashlib import sha256
from typing import Any

from verify import check_map
from verify.jobs.report_files import CertificateError, read_file
from verify.language.record import Record
from verify.paper.map.planes import Phi, Plane, Through
from verify.paper.map.strip import BorderStrip
from verify.paper.scene.scene import Scene
from verify.wire.map_log import Chunk, Progress

LOG = ".jsonl"


class CertifiedMap(Record):
    """One accepted log, read back; ``said`` is what its checker says it proves."""

    name: str
    progress: Progress
    digest: str
    said: str


class ReadStrip(Record):
    """A log that encloses a border, read but not checked: that takes longer than all maps."""

    name: str
    plane: BorderStrip
    tiles: int
    digest: str


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


def read_strip(directory: str, name: str) -> ReadStrip:
    """Read a log that encloses a border, and every tile of which has a verdict in it.

    Raises:
        CertificateError: if it is no such log.
    """
    path = os.path.join(directory, name)
    content = read_file(path)
    try:
        header, *lines = map(json.loads, content.splitlines())
        plane = _plane_of(check_map.plane_of(header["plane"]))
        tiles = sum(len(line["verdicts"]) - line["verdicts"].count("u") for line in lines)
        undecided = _appended(plane, lines).due
    except (check_map.LogError, ValueError, KeyError, TypeError, AttributeError) as error:
        raise CertificateError(f"{path}: it is no log of a strip ({error!r:.60})", 4) from error
    if undecided or not isinstance(plane, BorderStrip):
        raise CertificateError(f"{path}: not all of the strip is decided", 1)
    return ReadStrip(name, plane, tiles, sha256(content).hexdigest())


def read_map(directory: str, name: str) -> CertifiedMap:
    """Read a log, and check it.

    Raises:
        CertificateError: if it is not accepted.
    """
    path = os.path.join(directory, name)
    content = read_file(path)
    lines = content.splitlines(keepends=True)
    try:
        plane, areas = check_map.check_log(iter(lines))
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
    scene = Scene(found.r, found.positions, found.velocities)
    return Through(scene, *found[3:])
