"""What people and scripts see of a scene."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any

from verify.prover import balls
from verify.prover.decimals import outward, short

FORMAT = "verify-scene/1"
#: The exit code without a verdict.
UNDECIDED_CODE = 3

#: What the spheres tell of a scene, and of a collision: records of theirs, whose entries are read.
Told = Any
Step = Any
#: In a table, for a quotient by a number that may be 0, and for what no reader could compare.
UNKNOWN = "?"
#: Of the columns of that table.
WIDTHS = (7, 5, 14, 14, 14, 14, 12)


def exit_code(told: Told) -> int:
    """0 with a verdict, 3 without."""
    return 0 if told.theorems else UNDECIDED_CODE


def given_line(told: Told, judge: str) -> str:
    """What a verdict rests on, and who gives it; empty without a verdict."""
    given = " and ".join(f"certificates/{name}" for name in told.theorems)
    return f"given {given}; judged by {judge}" if given else ""


def scene_document(told: Told, judge: str) -> dict[str, Any]:
    """The verdict as JSON; every number is a text."""
    return {
        "format": FORMAT,
        "command": "scene",
        "verdict": told.verdict,
        "judged_by": judge if told.theorems else None,
        "cites": told.theorems,
        "reason": told.reason,
        "central": told.central,
        "collisions": told.collisions,
        "pairs": told.pairs,
        "time": None if told.time is None else outward(told.time),
        "neg_cos_theta": None if told.angle is None else outward(told.angle),
    }


def collision_table(steps: Iterable[Step], bits: int) -> Iterator[str]:
    """The collisions, a line each: pair, time, and the state just after, in balls of these bits."""
    heads = ("n", "pair", "time", "η", "ζ", "q", "-cos θ")
    yield _in_columns(heads)
    with balls.precision(bits):
        for n, step in enumerate(steps, 1):
            yield _in_columns((str(n), step.pair, *_cells(step)))


def _in_columns(cells: Iterable[str]) -> str:
    """A line of the table; 80 columns are enough for all."""
    return "".join(f"{x:<{w}}" for x, w in zip(cells, WIDTHS, strict=True)).rstrip()


def _cells(step: Step) -> Iterator[str]:
    """Time, η_c, ζ, q = η_s/|η_c| and -cos θ just after a collision."""
    start = step.after
    zeta = start.d * (2 + start.d) * start.A / ((1 + start.d) * start.y) ** 2
    for value in (step.time, -start.y, zeta, start.eta_s / start.y, start.C):
        ball = balls.as_ball(value)
        yield short(balls.ends(ball), 5) if balls.is_within_reach(ball) else UNKNOWN
