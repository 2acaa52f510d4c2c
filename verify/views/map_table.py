"""A map as a table with commas: a line for each box that was not divided."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from typing import Any

from verify.prover.decimals import exact_number, outward
from verify.views.map import AREAS, FINITELY
from verify.views.scene_table import DIGITS, Cells

#: A box, and what is known of the scene in its middle: records of `verify.spheres.map.middles`.
Box = Any
Middle = Any
#: What is told of the scene in the middle of a box.
OF_MIDDLE = ("middle_verdict", "middle_reason", "central", "collisions", "time_low", "time_high")
#: Ends of boxes have so many digits as decimals, and else are fractions.
MANY = 60


def table_rows(
    axes: Sequence[str], boxes: Iterable[Box], middles: Iterable[Middle] | None
) -> Iterator[Cells]:
    """A head, and a line for each box; with the scene in its middle, if there is one."""
    names = [f"{axis}_{end}" for axis in axes if axis for end in ("low", "high")]
    yield ("verdict", *names, *(OF_MIDDLE if middles is not None else ()))
    known = None if middles is None else iter(middles)
    for box in boxes:
        yield (*_of_box(box), *(() if known is None else _of_middle(next(known))))


def _of_box(box: Box) -> Iterator[str]:
    yield (AREAS | FINITELY)[box.letter][0]
    for side in (box.x, box.y):
        if side is not None:
            yield from (exact_number(end, MANY) for end in side)


def _of_middle(middle: Middle) -> Cells:
    time: Sequence[str] = ("", "")
    if middle.time is not None:
        time = outward(middle.time, DIGITS)
    central = "" if middle.central is None else str(middle.central)
    return (middle.verdict, middle.reason, central, str(middle.collisions), *time)


def middle_time(middle: Middle) -> Fraction | None:
    """About when the scene collapses."""
    return None if middle.time is None else (middle.time[0] + middle.time[1]) / 2
