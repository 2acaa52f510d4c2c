"""What a run on a folder of scenes has done so far, for another run to go on from there.

As long as a run with ``--out`` is not through, a file beside its certificates has a line for each
scene that is done: the digests of its file and of what was written, the limits, and what was found.
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterator
from contextlib import suppress
from hashlib import sha256
from typing import Any

from verify import __version__
from verify.cli.files import write_all
from verify.language.record import Record
from verify.spheres.scene.decide import Budget

#: The name of that file. Where it lies, a run was interrupted, or is under way.
NAME = "unfinished.jsonl"

Result = dict[str, Any]


class Done(Record):
    """A scene that is done: what has to be the same for another run to keep it, and what is."""

    scene: str
    limits: list[Any]
    written: str
    result: Result


class Unfinished:
    """The scenes of a run that are done, and those that an interrupted run has left.

    Args:
        source: the folder of scenes.
        out: the folder of certificates; None if nobody asked for them.
    """

    def __init__(self, source: str, out: str | None, limits: Budget) -> None:
        self._source, self._out = source, out
        self._limits = [__version__, *limits]
        self.kept: dict[str, Result] = {}
        if out is None or not os.path.isfile(os.path.join(out, NAME)):
            return
        found = {done.result["file"]: done for done in _lines(os.path.join(out, NAME))}
        whole = [done for name, done in found.items() if self._is_whole(name, done)]
        self.kept = {done.result["file"]: done.result for done in whole}
        write_all("--out", out, {NAME: "".join(map(_line, whole)).encode()})

    def _is_whole(self, name: str, done: Done) -> bool:
        """Whether the scene, the limits and what was written are the same as then."""
        with suppress(OSError, ValueError):
            scene = _digest(os.path.join(self._source, name))
            written = self._written(name)
            return (scene, self._limits, written) == (done.scene, done.limits, done.written)
        return False

    def _written(self, name: str) -> str:
        """A digest of all that lies in the folder of a scene."""
        total, place = sha256(), os.path.join(self._out or "", os.path.splitext(name)[0])
        for folder, folders, files in os.walk(place):
            folders.sort()
            for file in sorted(files):
                path = os.path.join(folder, file)
                total.update(os.fsencode(f"{os.path.relpath(path, place)} {_digest(path)}\n"))
        return total.hexdigest()

    def add(self, result: Result) -> None:
        """Note a scene that is done, if what was found of it was written."""
        if self._out is None or "scene" not in result:
            return
        kept = {key: value for key, value in result.items() if key != "scene"}
        written = self._written(result["file"])
        done = Done(result["scene"], self._limits, written, kept)
        with suppress(OSError), open(os.path.join(self._out, NAME), "a", encoding="ascii") as file:
            file.write(_line(done))

    def end(self) -> None:
        """Afterwards there is nothing to go on with: the run is through."""
        if self._out is not None:
            with suppress(OSError):
                os.unlink(os.path.join(self._out, NAME))


def _digest(path: str) -> str:
    with open(path, "rb") as file:
        return sha256(file.read()).hexdigest()


def _line(done: Done) -> str:
    return json.dumps(done._asdict()) + "\n"


def _lines(path: str) -> Iterator[Done]:
    """The lines of the file; one that is not whole, as the last one may be, is left out."""
    with open(path, encoding="ascii", errors="replace") as file:
        for line in file:
            with suppress(ValueError, TypeError, AttributeError):
                done = Done(**json.loads(line))
                whole = {"file", "code", "lines", "document", "row"} <= done.result.keys()
                if whole and isinstance(done.result["file"], str):
                    yield done
