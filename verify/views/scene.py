"""What people and scripts see of a scene."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any

from verify.prover import balls
from verify.prover.decimals import outward, short
from verify.spheres.flow.collapse import start_of
from verify.spheres.flow.follow import Move, name_of
from verify.spheres.scene.decide import COLLAPSES, DISPERSES, FINITE, Fate
from verify.spheres.scene.verdict import central, pairs_of, reason, theorems, time_ends

FORMAT = "verify-scene/1"
#: Exit codes: a verdict is there, or not.
CODES = {COLLAPSES: 0, DISPERSES: 0, FINITE: 0}
UNDECIDED_CODE = 3
#: In a table, for a quotient by a number that may be 0, and for what no reader could compare.
UNKNOWN = "?"
#: Of the columns of that table.
WIDTHS = (7, 5, 14, 14, 14, 14, 12)


def exit_code(found: Fate) -> int:
    """0 with a verdict, 3 without."""
    return CODES.get(found.verdict, UNDECIDED_CODE)


def given_line(found: Fate, judge: str) -> str:
    """What a verdict rests on, and who gives it; empty without a verdict."""
    given = " and ".join(f"certificates/{name}" for name in theorems(found))
    return f"given {given}; judged by {judge}" if given else ""


def scene_document(found: Fate, judge: str) -> dict[str, Any]:
    """The verdict as JSON; every number is a text."""
    time, end = time_ends(found), found.collapse
    return {
        "format": FORMAT,
        "command": "scene",
        "verdict": found.verdict,
        "judged_by": judge if theorems(found) else None,
        "cites": theorems(found),
        "reason": reason(found),
        "central": central(found),
        "collisions": found.collisions,
        "pairs": pairs_of(found),
        "time": None if time is None else outward(time),
        "neg_cos_theta": None if end is None else outward(end.angle),
    }


def collision_table(found: Fate) -> Iterator[str]:
    """The collisions, one line each: pair, time, and the state just after."""
    heads = ("n", "pair", "time", "η", "ζ", "q", "-cos θ")
    yield _in_columns(heads)
    with balls.precision(found.flow.bits):
        for n, move in enumerate(found.flow.collisions, 1):
            cells = (str(n), name_of(move.before.frame), *_cells(move))
            yield _in_columns(cells)


def _in_columns(cells: Iterable[str]) -> str:
    """A line of the table; 80 columns are enough for all."""
    return "".join(f"{x:<{w}}" for x, w in zip(cells, WIDTHS, strict=True)).rstrip()


def _cells(move: Move) -> Iterator[str]:
    """Time, η_c, ζ, q = η_s/|η_c| and -cos θ just after a collision."""
    start = start_of(move.after.state)
    zeta = start.d * (2 + start.d) * start.A / ((1 + start.d) * start.y) ** 2
    for value in (move.after.time, -start.y, zeta, start.eta_s / start.y, start.C):
        ball = balls.as_ball(value)
        yield short(balls.ends(ball), 5) if balls.is_within_reach(ball) else UNKNOWN
