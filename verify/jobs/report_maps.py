"""The maps of a report: logs that their checker accepts, read back."""

from __future__ import annotations

import json
import os
from hashlib import sha256

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

    @property
    def is_strip(self) -> bool:
        """Whether it encloses a border, and has no boxes."""
        return isinstance(self.progress.plane, BorderStrip)


def log_names(directory: str) -> list[str]:
    """The logs in the folders of a directory."""
    folders = [n for n in sorted(os.listdir(directory)) if os.path.isdir(f"{directory}/{n}")]
    return [
        f"{folder}/{name}"
        for folder in folders
        for name in sorted(os.listdir(os.path.join(directory, folder)))
        if name.endswith(LOG)
    ]


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
    progress = Progress(_plane_of(plane))
    for line in lines[1:]:
        found = json.loads(line)
        progress.append(Chunk(found["keys"].split(" "), found["verdicts"], found["numbers"]))
    return CertifiedMap(name, progress, sha256(content).hexdigest(), check_map.says(plane, areas))


def _plane_of(found: check_map.Plane) -> Plane | BorderStrip:
    """The plane that the checker has read, for the program."""
    if isinstance(found, check_map.Strip):
        return BorderStrip(Phi(*found.phi), *found[1:])
    if isinstance(found, check_map.Phi):
        return Phi(*found)
    scene = Scene(found.r, found.positions, found.velocities)
    return Through(scene, *found[3:])
