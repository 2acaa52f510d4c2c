"""The job `map`: boxes of a plane of scenes, refined where they are undecided."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from fractions import Fraction
from functools import partial
from typing import BinaryIO

from verify import check_map
from verify.language.record import Record
from verify.spheres.map.boxes import UNDECIDED, Verdicts, verdicts
from verify.spheres.map.log import Chunk, Progress, plane_document
from verify.spheres.map.planes import Plane
from verify.spheres.map.strip import BorderStrip
from verify.spheres.map.workers import Workers


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


def decide_chunk(plane: Plane | BorderStrip, keys: list[str]) -> tuple[Chunk, float]:
    """The verdicts on some boxes, and the CPU seconds that they took."""
    before = time.process_time()
    found = _confirmed(plane, keys, verdicts(plane, keys))
    numbers = [
        [number for six in sixes for number in six]
        for letter, sixes in zip(found.letters, found.numbers, strict=True)
        if letter == "c"
    ]
    return Chunk(keys, found.letters, numbers), time.process_time() - before


def _confirmed(plane: Plane | BorderStrip, keys: list[str], found: Verdicts) -> Verdicts:
    """The verdicts without those of late boxes that the checker does not follow as far."""
    if not found.late:
        return found
    checked = check_map.plane_of(plane_document(plane))
    law = check_map.law_in(checked)
    begin = check_map.beginning(law, checked)
    rules = check_map.Rules(check_map.price_of(checked), check_map.on_a_line(checked))
    letters = list(found.letters)
    for i in found.late:
        flat = [number for six in found.numbers[i] for number in six]
        try:
            numbers = check_map.sixes(flat, letters[i], 0 if rules.is_line else 6)
            check_map.prove_box(law, begin, keys[i], letters[i], numbers, None, rules)
        except check_map.RefusedError:
            letters[i] = UNDECIDED
    return found._replace(letters="".join(letters))


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
    work = partial(decide_chunk, progress.plane)
    for chunk, spent in workers.in_order(work, progress.chunks()):
        keep(progress.append(chunk))
        seconds += spent
        yield Sample(progress.boxes, progress.undecided, seconds)
        if is_reached(goal, progress):
            return


def open_log(path: str, progress: Progress) -> BinaryIO:
    """A log to append to: what it has already is taken over, and a line cut short is dropped.

    Raises:
        LogMismatchError: if it is not the beginning of this map.
    """
    with ExitStack() as stack:
        file = stack.enter_context(open(path, "a+b"))
        file.seek(0)
        size = progress.resume(iter(file))
        file.truncate(size)
        if size == 0:
            write_line(file, progress.header)
        stack.pop_all()  # it stays open
    return file


def write_line(file: BinaryIO, line: bytes) -> None:
    """Afterwards the line is in the file."""
    file.write(line)
    file.flush()
