"""How the end of a scene comes near: three numbers against the number of the collision."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from fractions import Fraction

from verify.language.record import Record
from verify.prover import balls
from verify.prover.decimals import exact_number
from verify.views.plots.shapes import Curve, Panel, Scale, Shape, Trace, Words, ten
from verify.views.scene import Step, Told

#: The size of a panel of a scene's drawing, so that the scales of one without a legend are equal.
SIDE, HIGH = 460, 466
#: Beside the first and the last collision, as a share of their number.
ROOM = 0.02
#: The bounds of more points than this are not drawn.
MARKS = 60
DIAMETER = "diameter"
SPEED, GAP, REST = range(3)


class Point(Record):
    """A value at a collision, as log10 of its bounds."""

    n: int
    low: float
    high: float


def length_unit(told: Told) -> str:
    """One unit of length, in words."""
    if told.scene.is_in_diameters:
        return DIAMETER
    return told.scene.labels.length_unit or "unit of length"


def several(unit: str) -> str:
    """More than one of it."""
    return unit.replace(DIAMETER, "diameters").replace("unit of", "units of")


def counted(length: float, unit: str) -> str:
    """A length with its unit, in the singular or the plural."""
    number = exact_number(Fraction(str(length)))
    return f"{number} {unit if number == '1' else several(unit)}"


def _names(told: Told) -> tuple[str, str, str]:
    """The three series, with the units of the file."""
    time, length = told.scene.labels.time_unit, several(length_unit(told))
    gap = length if told.scene.is_in_diameters else "contact distances"
    return (
        f"normal speed, {length} per {time or 'unit of time'}",
        f"gap of the next pair, {gap}",
        f"time to the collapse, between its bounds{f', {time}' * bool(time)}",
    )


def approach(told: Told, steps: Iterable[Step]) -> Panel:
    """Normal speed, gap and time to the collapse, each with its bounds, on a logarithmic axis.

    Where they fall by the same factor from one collision to the next, they lie on a line.
    """
    series = approach_series(told, steps)
    points = [point for one in series for point in one]
    last = max((point.n for point in points), default=0)
    low = math.floor(min((point.low for point in points), default=0))
    high = max(math.ceil(max((point.high for point in points), default=0)), low + 1)
    step, beat = _step(high - low, 8), _step(last, 8)
    ends = -(-low // step) * step, high + 1
    x = Scale(
        "number of the collision",
        1 - last * ROOM,
        last + last * ROOM,
        [(n, str(n)) for n in range(beat, last + 1, beat)],
    )
    y = Scale("", low, high, [(power, ten(power)) for power in range(*ends, step)])
    names = _names(told)

    def drawn() -> Iterator[Shape]:
        if last < 2:
            yield Words((0.5, 0.5), "fewer than two collisions", "middle")
            return
        for k, (name, one) in enumerate(zip(names, series, strict=True)):
            colour = f"series-{k + 1}"
            if one:
                yield Curve([(p.n, (p.low + p.high) / 2) for p in one], colour, k, name)
            for p in one if len(one) <= MARKS else ():
                yield Trace([(p.n, p.low), (p.n, p.high)], colour)

    return Panel("from collision to collision", x, y, drawn, "", SIDE, HIGH, axes=last > 1)


def approach_series(told: Told, steps: Iterable[Step]) -> tuple[list[Point], ...]:
    """The points of the three series; what is 0, or not known to be positive, has none."""
    found: tuple[list[Point], ...] = ([], [], [])
    with balls.precision(told.bits):
        for n, step in enumerate(steps, 1):
            after = balls.as_ball(step.time)
            values = [(step.speed, step.speed), (step.after.d, step.after.d)]
            if told.time is not None:
                ends = (balls.from_fraction(end) for end in told.time)
                values.append(tuple(end - after for end in ends))  # type: ignore[arg-type]
            is_next = told.time is not None or bool(step.after.y > 0)
            for k, (low, high) in enumerate(values):
                least, most = (balls.ends(balls.as_ball(x)) for x in (low, high))
                if least[0] > 0 and (k != GAP or is_next):
                    found[k].append(Point(n, _log(least[0]), _log(most[1])))
    return found


def _log(value: object) -> float:
    """log10 of a positive rational, also of one that no float can be."""
    top, divisor = value.as_integer_ratio()  # type: ignore[attr-defined]
    return math.log10(top) - math.log10(divisor)


def _step(length: int, most: int) -> int:
    """1, 2, 5, 10, …: so many steps of it, at most, make up the length."""
    step = 1
    while length > most * step:
        step = step * 5 // 2 if str(step)[0] == "2" else step * 2
    return step
