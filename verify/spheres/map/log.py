"""The log of a map: a line for the plane, then one for each chunk of boxes; only ever appended to.

Each line ends with the digest of itself and of all before it. The boxes of a level are those that
the boxes of the level before have left undecided, each cut into four (of an interval: into two
parts), in the order of their keys:
so the log is the same whoever decides its chunks, and in whatever order.
"""

from __future__ import annotations

import json
import re
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from hashlib import sha256
from itertools import product
from typing import Any

from verify.check_map import Areas
from verify.language.record import Record
from verify.spheres.map.planes import FamilyPlane, Phi, Place, Plane, Term, digits_of
from verify.spheres.map.strip import BorderStrip

FORMAT = "verify-map-log/1"
#: What decides boxes: another number where a verdict, or its numbers, may be another one. The
#: second one is for scenes that are free at the start.
CODE, FREE_CODE = 2, 7
#: The level of the first boxes; the number of boxes of a chunk, a multiple of four.
FIRST_LEVEL, CHUNK = 4, 2048
#: No box is smaller than those of this level.
FINEST = 40
COLLAPSES, DISPERSES, FINITE, UNDECIDED = "c", "d", "f", "u"
#: In a log only: disperses, by the theorem of this name.
OUTSIDE = "o"


class LogMismatchError(ValueError):
    """The log is not one that this program would have written for the plane."""


class Chunk(Record):
    """What was found for some boxes: a letter each, and flat numbers for those that collapse."""

    keys: Sequence[str]
    letters: str
    numbers: Sequence[Sequence[int]]


def plane_document(plane: Plane | BorderStrip) -> dict[str, Any]:
    """The plane as JSON."""
    if isinstance(plane, FamilyPlane):
        return _family_document(plane)
    x, y = ([str(x) for x in ends] for ends in (plane.x, plane.y))
    if isinstance(plane, BorderStrip):
        return plane_document(plane.phi) | {
            "name": "strip",
            "delta": str(plane.delta),
            "curve": [[str(c) for c in part] for part in plane.curve],
            "below": [str(u) for u in plane.below],
            "above": [str(u) for u in plane.above],
        }
    if isinstance(plane, Phi):
        return {
            "name": "phi",
            "r": str(plane.r),
            "neg_cos": str(plane.neg_cos),
            "speed": str(plane.speed),
            "tangential": [str(x) for x in plane.tangential],
            "x": x,
            "y": y,
        }
    scene = plane.scene
    return {
        "name": "scene",
        "r": str(scene.r),
        "positions": [[str(x) for x in row] for row in scene.positions],
        "velocities": [[str(x) for x in row] for row in scene.velocities],
        "x_at": place_text(plane.x_at),
        "y_at": place_text(plane.y_at),
        "x": x,
        "y": y,
    }


def _family_document(plane: FamilyPlane) -> dict[str, Any]:
    sides = [plane.x] if plane.y is None else [plane.x, plane.y]
    ends = ([str(end) for end in side] for side in sides)
    return {
        "name": "family",
        "r": _term_document(plane.r),
        "positions": [[_term_document(term) for term in row] for row in plane.coordinates.x],
        "velocities": [[_term_document(term) for term in row] for row in plane.coordinates.v],
        "axes": [*plane.axes],
        **dict(zip("xy", ends, strict=False)),
    }


def _term_document(term: Term) -> Any:
    if not isinstance(term, tuple):
        return str(term)
    name, one, two = term
    return [name, _term_document(one), _term_document(two)]


def place_text(place: Place) -> str:
    """The place of a number of a scene, like velocities[2][0]."""
    kind, particle, coordinate = place
    return f"{kind}[{particle}][{coordinate}]"


class Progress:
    """How far a map has come: its boxes so far, the areas, and which boxes are next."""

    def __init__(self, plane: Plane | BorderStrip) -> None:
        first = plane.level if isinstance(plane, BorderStrip) else FIRST_LEVEL
        self.document = plane_document(plane)
        header = {
            "format": FORMAT,
            "plane": self.document,
            "first_level": first,
            "code": CODE if isinstance(plane, Phi | BorderStrip) else FREE_CODE,
        }
        self.plane, self.digits = plane, digits_of(plane)
        self.header, self.chain = _line("", header)
        self.level, self.boxes, self.at = first, 0, 0
        self.due: list[str] = list(all_keys(first, self.digits))
        self.children: list[str] = []
        self._parts = {COLLAPSES: 0, DISPERSES: 0, FINITE: 0}
        self._shares = dict.fromkeys(self._parts, Fraction(0))
        self.found: list[Chunk] = []
        #: What the checker has found in the log; nothing else is told of it.
        self.areas: Areas | None = None

    def chunks(self) -> Iterator[list[str] | None]:
        """The boxes that are next, in chunks; None where it depends on those before which they are.

        Boxes of the next level are known as soon as so many of this one are undecided.
        """
        level, given = self.level, self.at
        while self.due:
            if level < self.level:
                level, given = self.level, self.at
            whole = level == self.level
            boxes = self.due if whole else self.children
            if given < len(boxes) and (whole or len(boxes) - given >= CHUNK):
                yield boxes[given : given + CHUNK]
                given += CHUNK
            elif whole and given >= len(boxes):
                level, given = level + 1, 0
            else:
                yield None

    def append(self, chunk: Chunk) -> bytes:
        """The line of the next chunk."""
        content = {
            "level": self.level,
            "keys": " ".join(chunk.keys),
            "verdicts": chunk.letters,
            "numbers": chunk.numbers,
        }
        line, self.chain = _line(self.chain, content)
        chunk = chunk._replace(letters=chunk.letters.replace(OUTSIDE, DISPERSES))
        self.found.append(chunk)
        self.boxes += len(chunk.keys)
        self.at += len(chunk.keys)
        for key, letter in zip(chunk.keys, chunk.letters, strict=True):
            if letter == UNDECIDED:
                self.children += [key + digit for digit in self.digits]
        self._count(chunk)
        if self.at == len(self.due):
            self.level, self.due, self.children, self.at = self.level + 1, self.children, [], 0
        return line

    def decided(self) -> Iterator[tuple[str, str, Sequence[int]]]:
        """The boxes with a verdict: the key, the letter, and the numbers of a collapse."""
        for chunk in self.found:
            numbers = iter(chunk.numbers)
            for key, letter in zip(chunk.keys, chunk.letters, strict=True):
                if letter != UNDECIDED:
                    yield key, letter, next(numbers) if letter == COLLAPSES else ()

    def leaves(self) -> Iterator[tuple[str, str]]:
        """Boxes that fill the plane, and their letters: of a part without verdict the largest."""
        for key, letter, _ in self.decided():
            yield key, letter
        rest = self.due[self.at :]
        families = Counter(key[:-1] for key in (*rest, *self.children))
        whole = {key for key, count in families.items() if count == len(self.digits)}
        for key in (*whole, *(key for key in rest if key[:-1] not in whole)):
            yield key, UNDECIDED

    def _count(self, chunk: Chunk) -> None:
        if isinstance(self.plane, BorderStrip):
            for letter in self._shares:
                pairs = zip(chunk.keys, chunk.letters, strict=True)
                self._shares[letter] += self.plane.share(*(key for key, x in pairs if x == letter))
            return
        size = len(self.digits) ** (FINEST - self.level)
        for letter in self._parts:
            self._parts[letter] += chunk.letters.count(letter) * size

    def share(self, letter: str) -> Fraction:
        """The share of the area with a verdict."""
        return self._shares[letter] + Fraction(self._parts[letter], len(self.digits) ** FINEST)

    @property
    def undecided(self) -> Fraction:
        """The share of the area without one, by the log."""
        return 1 - sum(map(self.share, self._parts), Fraction(0))

    def resume(self, lines: Iterator[bytes]) -> int:
        """Take over what a log has; the number of its bytes that are whole lines.

        Raises:
            LogMismatchError: if the log is not the beginning of this map.
        """
        size = 0
        for line in lines:
            if not line.endswith(b"\n"):
                break
            if size == 0:
                if line != self.header:
                    raise LogMismatchError("its first line is that of another map")
            elif self.append(self._chunk(line)) != line:
                raise LogMismatchError("a line is not what follows from those before it")
            size += len(line)
        return size

    def _chunk(self, line: bytes) -> Chunk:
        try:
            found = json.loads(line)
            keys, letters, numbers = found["keys"].split(" "), found["verdicts"], found["numbers"]
            good = re.fullmatch("[cdfou]*", letters) is not None and len(letters) == len(keys)
            good = good and len(numbers) == letters.count(COLLAPSES)
        except (ValueError, KeyError, TypeError, AttributeError, RecursionError) as error:
            raise LogMismatchError("a line is no chunk of boxes") from error
        if not good or keys != self.due[self.at : self.at + len(keys)]:
            raise LogMismatchError("a line has not the boxes that are next")
        return Chunk(keys, letters, numbers)


def all_keys(level: int, digits: str = "0123") -> Iterator[str]:
    """The keys of all boxes of a level, in their order."""
    return map("".join, product(digits, repeat=level))


def _line(chain: str, content: Mapping[str, Any]) -> tuple[bytes, str]:
    """A line, and the digest of it and of all before it."""
    body = json.dumps(content, separators=(",", ":")).encode()[:-1]
    chain = sha256(chain.encode() + body).hexdigest()
    return body + f',"sha256":"{chain}"}}\n'.encode(), chain
