"""What people and scripts see of a scene."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import Any

from verify.paper.flow.law import Number
from verify.paper.scene.criteria import SAYS
from verify.prover import balls
from verify.prover.decimals import outward, short
from verify.prover.flow import Move, name_of
from verify.prover.flow_collapse import start_of
from verify.prover.scene import COLLAPSES, DISPERSES, FINITE, Found

FORMAT = "verify-scene/1"
#: Exit codes: a verdict is there, or not.
CODES = {COLLAPSES: 0, DISPERSES: 0, FINITE: 0}
UNDECIDED_CODE = 3


def exit_code(found: Found) -> int:
    """0 with a verdict, 3 without."""
    return CODES.get(found.verdict, UNDECIDED_CODE)


def pairs_of(found: Found) -> list[str]:
    """The pairs that collide, in order."""
    return [name_of(move.before.frame) for move in found.flow.collisions]


def central(found: Found) -> int | None:
    """The particle that collides with the two others in turn for ever."""
    now = found.flow.now
    return now.frame[0] if found.collapse is not None and now is not None else None


def ends_of(value: Number, bits: int) -> tuple[Fraction, Fraction]:
    """Rational numbers around a ball."""
    with balls.precision(bits):
        return balls.ends(balls.as_ball(value))


def time_ends(found: Found) -> tuple[Fraction, Fraction] | None:
    """The enclosure of the time of the collapse."""
    if found.collapse is None:
        return None
    low, high = (ends_of(end, found.flow.bits) for end in found.collapse.time)
    return low[0], high[1]


def scene_document(found: Found) -> dict[str, Any]:
    """The verdict as JSON; every number is a text."""
    time, end = time_ends(found), found.collapse
    return {
        "format": FORMAT,
        "command": "scene",
        "verdict": found.verdict,
        "reason": reason(found),
        "central": central(found),
        "collisions": found.collisions,
        "pairs": pairs_of(found),
        "time": None if time is None else outward(time),
        "neg_cos_theta": None if end is None else outward(end.angle),
    }


def reason(found: Found) -> str:
    """What shows the verdict, or why there is none."""
    if found.verdict == COLLAPSES:
        return "the conditions of the sharper theorem hold after the last collision"
    if found.criterion is not None:
        return SAYS[found.criterion.name]
    return found.reason


def scene_lines(found: Found) -> Iterator[str]:
    """The verdict for a reader."""
    count = found.collisions
    after = f"after {count} collision{'' if count == 1 else 's'}"
    time, end = time_ends(found), found.collapse
    if end is not None and time is not None and found.flow.now is not None:
        o, s, c = found.flow.now.frame
        pairs = ", ".join(f"{min(o, x)}{max(o, x)}" for x in (c, s, c))
        yield (
            f"collapses: particle {o} central; from collision {count + 1} on {pairs}, … for ever;"
        )
        low, high = decimals(time)
        least, most = decimals(end.angle)
        yield f"collapse time in [{low}, {high}]; final -cos θ in [{least}, {most}]"
    elif found.verdict == FINITE:
        yield f"finite: {reason(found)};"
        yield "only finitely many collisions are possible, unless three touch at once or two graze"
    elif found.verdict == DISPERSES:
        yield (
            f"disperses: {after} no two collide again"
            if count
            else "disperses: no two ever collide"
        )
    else:
        yield f"undecided: {found.reason}; certain: {count} collision{'' if count == 1 else 's'}"


def decimals(ends: tuple[Fraction, Fraction]) -> list[str]:
    """Both ends with the digits on which they differ, rounded outward."""
    low, high = ends
    digits, width = 4, high - low
    while width and digits < 60 and abs(high) * 10 > width * 10 ** (digits - 2):
        digits += 1
    return outward(ends, digits)


def table(found: Found) -> Iterator[str]:
    """The collisions, one line each: pair, time, and the state just after."""
    heads = ("n", "pair", "time", "η", "ζ", "q", "-cos θ")
    yield "  ".join(f"{head:<12}" for head in heads).rstrip()
    with balls.precision(found.flow.bits):
        for n, move in enumerate(found.flow.collisions, 1):
            cells = (str(n), name_of(move.before.frame), *_cells(move))
            yield "  ".join(f"{cell:<12}" for cell in cells).rstrip()


def _cells(move: Move) -> Iterator[str]:
    """Time, η_c, ζ, q = η_s/|η_c| and -cos θ just after a collision."""
    start = start_of(move.after.state)
    zeta = start.d * (2 + start.d) * start.A / ((1 + start.d) * start.y) ** 2
    for value in (move.after.time, -start.y, zeta, start.eta_s / start.y, start.C):
        yield short(balls.ends(balls.as_ball(value)), 8)
