"""Boxes of a map are proved a second time: in balls, or by the checker in whole numbers."""

from __future__ import annotations

import random
from itertools import groupby

from verify import check_map
from verify.language.record import Record
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


def rechecked(progress: Progress, most: int) -> Rechecked:
    """What was proved again, of so many boxes chosen at random.

    Raises:
        RefusedError: if neither balls nor the checker prove a box.
    """
    boxes = [(key, letter, tuple(numbers)) for key, letter, numbers in progress.decided()]
    # Which boxes are proved a second time is no secret.
    chosen = random.Random(len(boxes)).sample(boxes, min(most, len(boxes)))  # noqa: S311
    left: list[Box] = []
    for _, level in groupby(sorted(chosen, key=lambda box: len(box[0])), lambda box: len(box[0])):
        same = [*level]
        for i in range(0, len(same), TOGETHER):
            left += _not_in_balls(progress, same[i : i + TOGETHER])
    plane = check_map.plane_of(plane_document(progress.plane))
    law = check_map.law_in(plane)
    begin = check_map.beginning(law, plane)
    for key, letter, numbers in left:
        check_map.prove_box(law, begin, key, letter, check_map.sixes([*numbers], letter))
    return Rechecked(len(boxes), len(chosen) - len(left), len(left))


def _not_in_balls(progress: Progress, boxes: list[Box]) -> list[Box]:
    level = [
        (key, letter, [numbers[i : i + 6] for i in range(0, len(numbers), 6)])
        for key, letter, numbers in boxes
    ]
    found = zip(boxes, reproved(progress.plane, level), strict=True)
    return [box for box, again in found if not again]
