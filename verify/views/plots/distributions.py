"""A sample of a family as histograms: numbers of collisions, times of collapses, final angles."""

from __future__ import annotations

import math
from bisect import bisect_right
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import pairwise
from typing import Any

from verify.language.record import Record
from verify.prover.decimals import decimal_text, exact_number, people, round_decimal, short
from verify.views.plots.drawing import LEFT, LEGEND, LETTER, RIGHT, standalone, svg
from verify.views.plots.map_colours import WIDE
from verify.views.plots.shapes import (
    MANY,
    Areas,
    Panel,
    Scale,
    Shape,
    Words,
    axis_of,
    logarithmic_steps,
    round_step,
)
from verify.views.scene import COLLAPSES, DISPERSES, UNDECIDED
from verify.views.scene_table import drawn_lines, share_lines

#: Lines of a table of scenes, with the names of its columns.
Rows = Sequence[Mapping[str, str]]
#: The smallest width of a panel, and its height without a legend; the size of an empty one.
WIDTH, HEIGHT, EMPTY = 420, 350, (600, 140)
#: So many whole numbers have a bar each; fewer bars than the second number do not fill a panel.
SINGLE, FEW = 12, 5
COLOURS = {COLLAPSES: "refuted-area", DISPERSES: "proved-area"}


class Group(Record):
    """Some numbers with one colour; without a name it is not in the legend."""

    values: Sequence[Fraction]
    colour: str
    name: str = ""


def sample_svg(document: Mapping[str, Any], rows: Rows, digits: int | None) -> str:
    """The file; ``document`` is the sample as JSON, and the rows are its scenes.

    ``digits`` are those of times and angles that were asked for.
    """
    collapses = [row for row in rows if row["verdict"] == COLLAPSES]
    times, angles = [_times(row) for row in collapses], [_angles(row) for row in collapses]
    unit = rows[0]["time_unit"]
    until = "it is certain" if digits is None else f"its time has {digits} digits"
    panels = [_collisions(rows, until)]
    if collapses:
        named = f"collapse time{f' ({unit})' * bool(unit)}"
        panels.append(_measured("number of scenes, by collapse time", named, times))
        panels.append(
            _measured("number of scenes, by final angle", "final angle θ (degrees)", angles)
        )
    heading = [rows[0]["title"], *_heading(document, rows)]
    if collapses:
        more = "; with --digits they are narrower" if digits is None else ""
        heading.append(_widths(times, angles, unit) + more)
    described = f"Histograms: {', '.join(panel.title for panel in panels)}"
    return standalone(svg("sample", panels, described, [line for line in heading if line]))


# --- what is told above --------------------------------------------------------------------------


def _heading(document: Mapping[str, Any], rows: Rows) -> Iterator[str]:
    first, *drawn = drawn_lines(document)
    yield f"{first} {', '.join(line.strip() for line in drawn)}"
    count, total = sum(row["verdict"] == COLLAPSES for row in rows), len(rows)
    yield f"collapses: {count} of {total}, {100 * count / total:.3f} %"
    said, counted, share, _ = (line.strip() for line in share_lines(document))
    yield f"{share}, {said} {counted.rstrip(':')}"
    undecided = sum(row["verdict"] == UNDECIDED for row in rows)
    uncounted = sum(not row["collisions_total"] for row in rows) - undecided
    missing = [f"{undecided} undecided"] * bool(undecided)
    missing += [f"{uncounted} with finitely many collisions, not counted"] * bool(uncounted)
    yield f"not drawn: {', '.join(missing)}" if missing else "all are drawn: none is undecided"


def _widths(times: Sequence[Any], angles: Sequence[Any], unit: str) -> str:
    """How wide the enclosures are whose middles are drawn."""
    time, angle = (
        people(decimal_text(*round_decimal(max(high - low for low, high in ends), 2, up=True)))
        for ends in (times, angles)
    )
    most = f"{time} {unit}".rstrip()
    return f"times and angles are the middles of enclosures, at most {most} and {angle}° wide"


def _times(row: Mapping[str, str]) -> tuple[Fraction, Fraction]:
    return Fraction(row["time_low"]), Fraction(row["time_high"])


def _angles(row: Mapping[str, str]) -> tuple[Fraction, Fraction]:
    """Between what the final angle lies, in degrees; sharp where it is close to 180."""
    ends = (min(Fraction(row[f"neg_cos_{end}"]), Fraction(1)) for end in ("low", "high"))
    less = [math.degrees(math.atan2(math.sqrt(1 - end**2), end)) for end in ends]
    return 180 - Fraction(less[0]), 180 - Fraction(less[1])


# --- the panels ----------------------------------------------------------------------------------


def _collisions(rows: Rows, until: str) -> Panel:
    """The number of scenes by their number of collisions; each bar names its numbers."""
    title = "number of scenes, by number of collisions"
    groups = [
        Group(
            [Fraction(row["collisions_certain"]) for row in rows if row["verdict"] == verdict],
            COLOURS[verdict],
            name,
        )
        for verdict, name in (
            (COLLAPSES, f"collapses: collisions until {until}"),
            (DISPERSES, "disperses: all its collisions"),
        )
    ]
    groups = [group for group in groups if group.values]
    values = [value for group in groups for value in group.values]
    height = HEIGHT + LEGEND * len(groups)
    if not values:
        none, side = Words((0.5, 0.5), "no scene to draw", "middle"), Scale("", 0, 1, ())
        return Panel(title, side, side, lambda: [none], "", *EMPTY, axes=False)
    ends = edges(min(values), max(values) + 1, is_whole=True)
    texts = [str(a) if b - a == 1 else f"{a}–{b - 1}" for a, b in pairwise(ends)]
    ticks = [(k + 0.5, text) for k, text in enumerate(texts)]
    return _bars(title, "number of collisions", ends, ticks, groups, height)


def _measured(title: str, name: str, enclosures: Sequence[tuple[Fraction, Fraction]]) -> Panel:
    """The middles of enclosures: what is marked are the edges of the bars."""
    values = [(low + high) / 2 for low, high in enclosures]
    ends = edges(min(values), max(values))
    count = len(ends) - 1
    if values.count(values[0]) == len(values):
        ticks = [(0.5, short((values[0], values[0]), 4))]
    elif all(b - a == ends[1] - ends[0] for a, b in pairwise(ends)):
        name, marks = axis_of(name, ends[0], ends[-1], count)
        ticks = [(share * count, text) for share, text in marks]
        ticks = ticks[:: 2 if count > FEW else 1]
    else:
        ticks = [(k, exact_number(end, MANY)) for k, end in enumerate(ends)]
    groups = [Group(values, COLOURS[COLLAPSES])]
    return _bars(title, name, ends, ticks, groups, HEIGHT)


def edges(low: Fraction, high: Fraction, *, is_whole: bool = False) -> list[Fraction]:
    """Round numbers with all values between them: evenly spaced, or 1, 2, 5, 10, … if these vary.

    A single value is both edges.
    """
    least = max(low, Fraction(1)) if is_whole else low
    if high > WIDE * least > 0:
        found = logarithmic_steps(least, high)
        first = max(k for k, at in enumerate(found) if at <= least)
        last = min(k for k, at in enumerate(found) if at >= high)
        return [Fraction(0)] * (low < least) + found[first : last + 1]
    return [low, high] if low == high else _even(low, high, is_whole=is_whole)


def _even(low: Fraction, high: Fraction, *, is_whole: bool) -> list[Fraction]:
    is_single = is_whole and high - low <= SINGLE
    step = Fraction(1) if is_single else round_step(low, high, FEW)
    return [k * step for k in range(math.floor(low / step), math.ceil(high / step) + 1)]


def counts_between(values: Sequence[Fraction], ends: Sequence[Fraction]) -> list[int]:
    """How many values are from one edge up to the next one; the last edge is included."""
    found = [0] * (len(ends) - 1)
    for value in values:
        found[min(bisect_right(ends, value), len(found)) - 1] += 1
    return found


def _bars(
    title: str,
    name: str,
    ends: Sequence[Fraction],
    ticks: Sequence[tuple[float, str]],
    groups: Sequence[Group],
    height: int,
) -> Panel:
    """A panel in which the bars of a group are one apart, with room for the words at each."""
    counts = [counts_between(group.values, ends) for group in groups]
    most, many = max(map(max, counts)), len(ends) - 1
    apart = ticks[1][0] - ticks[0][0] if len(ticks) > 1 else FEW
    longest = max(len(text) for _, text in ticks)
    letters = max(len(groups) * (len(str(most)) + 1), (longest + 2) / apart)
    room = max(1, FEW - many) / 2
    x = Scale(name, -room, many + room, ticks)
    marks = [(float(at), str(at)) for at in _even(Fraction(0), Fraction(most), is_whole=True)]
    # Beside long marks there is no room for the label of the vertical axis: it is in the title.
    y = Scale("", 0, 1.1 * most, marks)

    def drawn() -> Iterator[Shape]:
        wide = 0.9 / len(groups)
        for number, (group, found) in enumerate(zip(groups, counts, strict=True)):
            lefts = [k + 0.05 + wide * number for k in range(many)]
            bars = [(at, at + wide, 0.0, float(n)) for at, n in zip(lefts, found, strict=True) if n]
            yield Areas(bars, group.colour, name=group.name)
            for left, right, _, top in bars:
                yield Words(((left + right) / 2, top + most / 22), f"{top:.0f}", "middle")

    inner = LETTER * max((many + 2 * room) * letters, len(name))
    return Panel(title, x, y, drawn, "", max(WIDTH, LEFT + RIGHT + math.ceil(inner)), height)
