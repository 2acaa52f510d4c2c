"""The job `map`: boxes of a plane of scenes, refined where they are undecided."""

from __future__ import annotations

import json
import re
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import ExitStack, suppress
from errno import EACCES, EAGAIN
from fractions import Fraction
from functools import partial
from os import SEEK_END, stat, unlink
from os import path as paths
from stat import S_ISCHR
from typing import BinaryIO

from verify import check_map
from verify.language.record import Record
from verify.spheres.map.boxes import FINITE, UNDECIDED, Verdicts, verdicts
from verify.spheres.map.log import (
    CHUNK,
    OUTSIDE,
    Chunk,
    LogMismatchError,
    Progress,
    plane_document,
)
from verify.spheres.map.planes import Phi, Plane
from verify.spheres.map.strip import BorderStrip
from verify.spheres.map.workers import Workers

#: So many chunks are decided at once at most.
MOST_CHUNKS = 8


class Target(Record):
    """When a map ends: at this undecided share, or this many boxes, or below this level."""

    undecided: Fraction
    boxes: int
    level: int


class Sample(Record):
    """What was known after so many CPU seconds."""

    boxes: int
    undecided: Fraction
    seconds: float


def decide_chunks(
    plane: Plane | BorderStrip, chunks: Sequence[list[str]]
) -> list[tuple[Chunk, float]]:
    """The verdicts on the boxes of chunks of one level, and the CPU seconds that each took."""
    before = time.process_time()
    keys = [key for chunk in chunks for key in chunk]
    found = _confirmed(plane, keys, verdicts(plane, keys))
    decided, at = [], 0
    for chunk in chunks:
        end = at + len(chunk)
        letters = found.letters[at:end]
        sixes = zip(letters, found.numbers[at:end], strict=True)
        numbers = [[x for six in parts for x in six] for letter, parts in sixes if letter == "c"]
        decided.append(Chunk(chunk, letters, numbers))
        at = end
    share = (time.process_time() - before) / len(keys)
    return [(chunk, share * len(chunk.keys)) for chunk in decided]


def batches(progress: Progress, ahead: int) -> Iterator[list[list[str]] | None]:
    """The chunks that are next, several of one level at once; None as in `Progress.chunks`.

    Where a goal is reached, what is decided ahead is lost: that is an eighth of a map at most.
    """
    batch: list[list[str]] = []
    for chunk in progress.chunks():
        if batch and (chunk is None or len(chunk[0]) != len(batch[0][0])):
            yield batch
            batch = []
        elif chunk is None:
            yield None
        if chunk is not None:
            batch.append(chunk)
        if len(batch) > min(progress.boxes // (8 * CHUNK * ahead), MOST_CHUNKS - 1):
            yield batch
            batch = []
    if batch:
        yield batch


#: The checker is asked with so much work whether spheres part: for about 24 collisions.
PARTS_WORK = 1000


def _confirmed(plane: Plane | BorderStrip, keys: list[str], found: Verdicts) -> Verdicts:
    """The verdicts, but for late boxes, or all of an extreme plane, those that are confirmed.

    Of undecided boxes of free scenes the checker itself is asked whether all spheres part.
    """
    late = {*(range(len(keys)) if is_extreme(plane) else found.late)}
    is_free = not isinstance(plane, Phi | BorderStrip)
    choices = {
        i: (OUTSIDE,) if letter == UNDECIDED else (letter, FINITE)
        for i, letter in enumerate(found.letters)
        if (is_free if letter == UNDECIDED else i in late)
    }
    if not choices:
        return found
    checked = check_map.plane_of(plane_document(plane))
    law = check_map.law_in(checked)
    begin = check_map.beginning(law, checked)
    rules = check_map.rules_of(checked)
    letters = list(found.letters)

    def is_proved(i: int, letter: str) -> bool:
        flat = [number for six in found.numbers[i] for number in six]
        try:
            numbers = check_map.sixes(flat, letter, 0 if rules.is_line else 6)
            work = check_map.Work(PARTS_WORK if letter == OUTSIDE else None)
            check_map.prove_box(law, begin, keys[i], letter, numbers, work, rules)
        except check_map.RefusedError:
            return False
        return True

    for i, tried in choices.items():
        letters[i] = next((letter for letter in tried if is_proved(i, letter)), UNDECIDED)
    return found._replace(letters="".join(letters))


#: Between this and its inverse doubles tell no more of a number than the checker's numbers do.
SMALL = Fraction(1, 1 << 32)


def is_extreme(plane: Plane | BorderStrip) -> bool:
    """Whether a plane has a number of which the checker may know less than doubles tell.

    Doubles have as many digits of each number; the checker counts in units of 2^-96.
    """
    phi = plane.phi if isinstance(plane, BorderStrip) else plane
    words = re.findall(r'"(-?[0-9]+(?:/[0-9]+)?)"', json.dumps(plane_document(phi)))
    sizes = (abs(Fraction(word)) for word in words)
    return any(size and not SMALL <= size <= 1 / SMALL for size in sizes)


def is_reached(goal: Target, progress: Progress) -> bool:
    """Whether a map has ended."""
    return (
        progress.undecided <= goal.undecided
        or progress.boxes >= goal.boxes
        or progress.level > goal.level
        or not progress.due
    )


def grow(
    progress: Progress, goal: Target, workers: Workers, keep: Callable[[bytes], object]
) -> Iterator[Sample]:
    """Decide boxes until the goal is reached; each line of the log is kept before it counts."""
    seconds = 0.0
    if is_reached(goal, progress):
        return
    work = partial(decide_chunks, progress.plane)
    for decided in workers.in_order(work, batches(progress, workers.ahead)):
        for chunk, spent in decided:
            keep(progress.append(chunk))
            seconds += spent
            yield Sample(progress.boxes, progress.undecided, seconds)
            if is_reached(goal, progress):
                return


def open_log(path: str, progress: Progress) -> BinaryIO:
    """A log to append to: what it has already is taken over, and a line cut short is dropped.

    As long as it is open, no other process can open it here.

    Raises:
        LogMismatchError: if it is not the beginning of this map.
        BlockingIOError: if another process has opened it here.
    """
    if paths.exists(path) and S_ISCHR(stat(path).st_mode):
        raise LogMismatchError("it is a device")
    with ExitStack() as stack:
        file = stack.enter_context(open(path, "a+b"))
        _lock(file)
        file.seek(0)
        size = progress.resume(iter(file))
        file.truncate(size)
        if size == 0:
            try:
                write_line(file, progress.header)
            except OSError:
                with suppress(OSError):  # there is no log that has nothing in it
                    unlink(path)
                raise
        stack.pop_all()  # it stays open
    return file


def _lock(file: BinaryIO) -> None:
    """Afterwards the file is this process's until it ends; the workers do not inherit it."""
    import fcntl  # loaded only where it is used

    try:
        fcntl.lockf(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError as error:
        if error.errno in (EACCES, EAGAIN):  # otherwise the file system has no locks
            raise BlockingIOError(EAGAIN, "another process is writing it") from error


def write_line(file: BinaryIO, line: bytes) -> None:
    """Afterwards the line is in the file, or none of it is.

    Raises:
        OSError: if it cannot be written.
    """
    raw = getattr(file, "raw", file)  # what a buffer keeps would be written again at the end
    size = raw.seek(0, SEEK_END)
    try:
        while line:
            line = line[raw.write(line) :]
    except OSError:
        with suppress(OSError):  # then the next run drops what is there of it
            raw.truncate(size)
        raise
