"""What people and scripts see of a scene."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from fractions import Fraction
from typing import Any

from verify.prover import balls
from verify.prover.decimals import decimal_text, outward, people, round_decimal, short
from verify.prover.ground import FLINT
from verify.prover.outcome import CHECKER

FORMAT = "verify-scene/2"
#: The exit code without a verdict.
UNDECIDED, UNDECIDED_CODE = "undecided", 3
#: The verdicts that say how many collisions there are.
COLLAPSES, DISPERSES, FINITE = "collapses", "disperses", "finite"

#: What the spheres tell of a scene, and of a collision: records of theirs, whose entries are read.
Told = Any
Step = Any
Afterwards = Any
Ends = tuple[Fraction, Fraction]
#: What happens after a collapse, by its name, with the pair and the time after the collapse.
THEN = {
    "together": "they stay together",
    "apart": "they part at once, and no two collide again",
    "meet": "the middle one parts from both at once, and {0} meet {1} after the collapse",
    "unknown": "it is not decided whether two collide again",
}
#: In a table, for a quotient by a number that may be 0, and for what no reader could compare.
UNKNOWN = "?"
#: An enclosure with a smaller relative width may stand next to a short decimal.
LESS = Fraction(1, 10**14)


def exit_code(told: Told) -> int:
    """0 with a verdict, 3 without one, also where it is known exactly why there is none."""
    return 0 if told.verdict != UNDECIDED else UNDECIDED_CODE


def judge_of(is_checked: bool) -> str:
    """Who gives a verdict: the checker, if its certificate is written."""
    return CHECKER if is_checked else FLINT


def given_line(told: Told, judge: str) -> str:
    """What a verdict rests on, and who gives it; empty without a verdict."""
    if told.verdict == UNDECIDED:
        return ""
    named = [f"certificates/{name}" for name in told.theorems]
    return f"given {' and '.join(named)}; judged by {judge}"


def scene_document(told: Told, after: Afterwards, judge: str) -> dict[str, Any]:
    """The verdict as JSON; every number is a text."""
    return {
        "format": FORMAT,
        "command": "scene",
        "verdict": told.verdict,
        "judged_by": None if told.verdict == UNDECIDED else judge,
        "cites": told.theorems,
        "reason": told.reason,
        "says": told.says,
        "central": told.central,
        "collisions": told.collisions,
        "pairs": told.pairs,
        "time": None if told.time is None else outward(told.time),
        "neg_cos_theta": None if told.angle is None else outward(told.angle),
        "event_time": None if told.event is None else outward(told.event),
        "energy_lost": outward(told.energy),
        "after_collapse": None if after is None else _afterwards_document(after),
        **{name: text for name, text in told.scene.labels._asdict().items() if text},
        "impacts": [
            {"pair": one.pair, "time": outward(one.time), "normal_speed": outward(one.speed)}
            for one in told.impacts
        ],
    }


def _afterwards_document(after: Afterwards) -> dict[str, Any]:
    return {
        "velocities": [[outward(ends) for ends in row] for row in after.velocities],
        "energy_lost": outward(after.energy),
        "then": after.then,
        "pair": after.pair or None,
        "wait": None if after.wait is None else outward(after.wait),
    }


def afterwards_lines(after: Afterwards, shown: Callable[[Ends], list[str]]) -> Iterator[str]:
    """The velocities to which those of the balls tend in a collapse, and what happens then."""

    def text(ends: Ends) -> str:
        low, high = shown(ends)
        return low if low == high else f"[{low}, {high}]"

    yield "at the collapse the velocities tend to"
    for ball, row in enumerate(after.velocities):
        yield f"  {ball}: {', '.join(map(text, row))}"
    yield f"energy lost in all: {text(after.energy)}"
    wait = "" if after.wait is None else text(after.wait)
    then = THEN[after.then].format(after.pair, wait)
    yield f"then, if the balls move on with these velocities: {then}"


def cutoff_line(verdict: str, cutoff: str, count: tuple[int, int] | None) -> str:
    """After how many collisions less time than the cutoff is left."""
    if verdict != COLLAPSES:
        return "--cutoff: no collapse is proved"
    if count is None:
        return (
            f"{cutoff} before the collapse is not reached; write a larger --cutoff or --collisions"
        )
    least, most = count
    number = str(least) if least == most else f"{least} to {most}"
    words = "1 collision" if count == (1, 1) else f"{number} collisions"
    return f"after {words} less time than {cutoff} is left"


def cutoff_document(cutoff: Fraction, count: tuple[int, int] | None) -> dict[str, Any]:
    """The same as JSON."""
    return {"time": str(cutoff), "collisions": None if count is None else list(count)}


def collision_table(steps: Iterable[Step], bits: int, unit: str) -> Iterator[str]:
    """The collisions, a line each: pair, time, time since the last one, and the state just after.

    ``unit`` is that of times, and empty if it has no name.
    """
    time, before = f"time ({unit})" if unit else "time", 0
    heads = ("n", "pair", time, "since", "speed", "η", "ζ", "q", "-cos θ")
    found = []
    with balls.precision(bits):
        for n, step in enumerate(steps, 1):
            found.append((str(n), step.pair, *_cells(step, before)))
            before = step.time
    rows = [heads, *found]
    widths = [1 + max(map(len, column)) for column in zip(*rows, strict=True)]
    for row in rows:
        yield "".join(f"{cell:<{width}}" for cell, width in zip(row, widths, strict=True)).rstrip()


def _cells(step: Step, before: Any) -> Iterator[str]:
    """Times, normal speed, and η_c, ζ, q = η_s/|η_c| and -cos θ just after a collision."""
    start = step.after
    zeta = start.d * (2 + start.d) * start.A / ((1 + start.d) * start.y) ** 2
    state = (-start.y, zeta, start.eta_s / start.y, start.C)
    for value in (step.time, step.time - before, step.speed, *state):
        ball = balls.as_ball(value)
        yield _cell(balls.ends(ball)) if balls.is_within_reach(ball) else UNKNOWN


def _cell(ends: tuple[Fraction, Fraction]) -> str:
    """The digits that are certain; next to a short decimal that decimal, after a sign ≈."""
    low, high = ends
    if high - low >= abs(low) * LESS:
        return short(ends, 4)
    mantissa, exponent = round_decimal((low + high) / 2, 12, up=True)
    near = mantissa * Fraction(10) ** exponent
    is_next_to_one = low < high and low <= near <= high
    return f"≈{people(decimal_text(mantissa, exponent))}" if is_next_to_one else short(ends, 4)
