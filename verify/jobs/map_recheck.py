"""Boxes of a map are proved a second time: in balls, or by the checker in whole numbers."""

from __future__ import annotations

import random
from collections.abc import Iterator
from functools import partial
from itertools import groupby

from verify import check_map
from verify.jobs.map_workers import Workers
from verify.language.record import Record
from verify.paper.map.planes import Plane
from verify.paper.map.strip import BorderStrip
from verify.prover.map_balls import reproved
from verify.wire.map_log import Progress, plane_document

#: So many boxes are followed at once.
TOGETHER = 256
#: A box: its key, its letter, and flat numbers for one that collapses.
Box = tuple[str, str, tuple[int, ...]]


class Rechecked(Record):
    """How many boxes have a verdict; how many of them were proved again in balls, and otherwise."""

    decided: int
    balls: int
    whole_numbers: int


def rechecked(progress: Progress, most: int, workers: Workers) -> Rechecked:
    """What was proved again, of so many boxes chosen at random; the workers have the balls.

    Raises:
        RefusedError: if neither balls nor the checker prove a box.
    """
    boxes = [(key, letter, tuple(numbers)) for key, letter, numbers in progress.decided()]
    # Which boxes are proved a second time is no secret.
    chosen = random.Random(len(boxes)).sample(boxes, min(most, len(boxes)))  # noqa: S311
    work = partial(not_in_balls, progress.plane)
    left = [box for found in workers.in_order(work, _chunks(chosen)) for box in found]
    plane = check_map.plane_of(plane_document(progress.plane))
    law = check_map.law_in(plane)
    begin = check_map.beginning(law, plane)
    for key, letter, numbers in left:
        check_map.prove_box(law, begin, key, letter, check_map.sixes([*numbers], letter))
    return Rechecked(len(boxes), len(chosen) - len(left), len(left))


def _chunks(boxes: list[Box]) -> Iterator[list[Box]]:
    """The boxes, those of a size together."""
    for _, level in groupby(sorted(boxes, key=lambda box: len(box[0])), lambda box: len(box[0])):
        same = [*level]
        yield from (same[i : i + TOGETHER] for i in range(0, len(same), TOGETHER))


def not_in_balls(plane: Plane | BorderStrip, boxes: list[Box]) -> list[Box]:
    """Those of some boxes, all of one size, that balls do not prove."""
    level = [
        (key, letter, [numbers[i : i + 6] for i in range(0, len(numbers), 6)])
        for key, letter, numbers in boxes
    ]
    found = zip(boxes, reproved(plane, level), strict=True)
    return [box for box, again in found if not again]
