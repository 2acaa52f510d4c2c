"""How the end of a scene comes near: three numbers against the number of the collision."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from html import escape

from verify.language.record import Record
from verify.prover import balls
from verify.views.scene import Step, Told

SIZE, LEFT, RIGHT, TOP, BOTTOM = 420, 52, 12, 64, 46
#: More points than this are drawn without a mark for each.
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


def _names(told: Told) -> tuple[str, str, str]:
    """The three series, with the units of the file."""
    time, length = told.scene.labels.time_unit, several(length_unit(told))
    gap = length if told.scene.is_in_diameters else "contact distances"
    return (
        f"normal speed, {length} per {time or 'unit of time'}",
        f"gap of the next pair, {gap}",
        f"time to the collapse, between its bounds{f', {time}' * bool(time)}",
    )


def approach(told: Told, steps: Iterable[Step]) -> Iterator[str]:
    """Normal speed, gap and time to the collapse, each with its bounds, on a logarithmic axis.

    Where they fall by the same factor from one collision to the next, they lie on a line.
    """
    series = approach_series(told, steps)
    points = [point for one in series for point in one]
    last = max((point.n for point in points), default=0)
    if last < 2:
        yield svg_text(SIZE / 2, SIZE / 2, "fewer than two collisions", "middle")
        return
    axes = _Axes(last, min(p.low for p in points), max(p.high for p in points))
    yield from axes.drawn()
    for k, (name, one) in enumerate(zip(_names(told), series, strict=True)):
        if one:
            y = 14 + 17 * k
            yield f'<path class="c{k}" stroke-width="3" d="M{LEFT} {y - 4}h22"/>'
            yield svg_text(LEFT + 30, y, name)
            yield from _series(k, one, axes)


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


def _series(k: int, points: Sequence[Point], axes: _Axes) -> Iterator[str]:
    places = [(axes.x(p.n), axes.y((p.low + p.high) / 2)) for p in points]
    line = " ".join(f"{x:.2f},{y:.2f}" for x, y in places)
    yield f'<polyline class="c{k}" points="{line}"/>'
    if len(points) > MARKS:
        return
    for point, (x, y) in zip(points, places, strict=True):
        low, high = axes.y(point.low), axes.y(point.high)
        if low - high > 1:
            yield f'<path class="c{k}" d="M{x - 3:.2f} {low:.2f}h6M{x - 3:.2f} {high:.2f}h6"/>'
            yield f'<path class="c{k}" d="M{x:.2f} {low:.2f}V{high:.2f}"/>'
        yield f'<circle class="c{k}" cx="{x:.2f}" cy="{y:.2f}" r="3"/>'


class _Axes:
    """Collisions 1 to the last one, and whole powers of ten."""

    def __init__(self, last: int, low: float, high: float) -> None:
        self._last, self._low, self._high = last, math.floor(low), math.ceil(high)
        if self._low == self._high:
            self._high += 1

    def x(self, n: float) -> float:
        """The place of a collision."""
        return LEFT + 8 + (SIZE - LEFT - RIGHT - 16) * (n - 1) / (self._last - 1)

    def y(self, log: float) -> float:
        """The height of a power of ten."""
        share = (log - self._low) / (self._high - self._low)
        return SIZE - BOTTOM - (SIZE - TOP - BOTTOM) * share

    def drawn(self) -> Iterator[str]:
        """Lines, ticks and words."""
        bottom, right = SIZE - BOTTOM, SIZE - RIGHT
        yield f'<path class="axis" d="M{LEFT} {TOP}V{bottom}H{right}"/>'
        for n in range(1, self._last + 1, _step(self._last - 1, 8)):
            yield f'<path class="axis" d="M{self.x(n):.2f} {bottom}v5"/>'
            yield svg_text(self.x(n), bottom + 20, str(n), "middle")
        step = _step(self._high - self._low, 8)
        for power in range(-(-self._low // step) * step, self._high + 1, step):
            yield f'<path class="axis" d="M{LEFT} {self.y(power):.2f}h-5"/>'
            yield svg_text(LEFT - 8, self.y(power) + 4, ten(power), "end")
        yield svg_text((LEFT + right) / 2, SIZE - 8, "number of the collision", "middle")


def _step(length: int, most: int) -> int:
    """1, 2, 5, 10, …: so many steps of it, at most, make up the length."""
    step = 1
    while length > most * step:
        step = step * 5 // 2 if str(step)[0] == "2" else step * 2
    return step


def ten(exponent: int) -> str:
    """A power of ten as people write it."""
    digits = str(exponent).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))
    return f"10{digits}"


def svg_text(x: float, y: float, text: str, anchor: str = "start") -> str:
    """A text at a place."""
    where = f'x="{x:.2f}" y="{y:.2f}" text-anchor="{anchor}"'
    return f'<text class="ink" {where}>{escape(text)}</text>'
