"""A certified map: its areas, its border closer by, and how the undecided area shrinks."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from typing import Any

from verify.prover.decimals import exact_number
from verify.views.findings import CertifiedMap, CertifiedStrip
from verify.views.map import (
    AREAS,
    COLLAPSES,
    DISPERSES,
    UNDECIDED,
    Progress,
    Strip,
    area_shares,
    axis_names,
    is_strip,
    percent,
    plane_line,
)
from verify.views.plots import shapes

#: The colour of each area; the border is what is left between the two decided ones.
COLOURS = {COLLAPSES: "refuted-area", DISPERSES: "proved-area", UNDECIDED: "ink"}
#: The side of what is shown closer by, as a share of the side of the map.
CLOSER = Fraction(1, 16)

Cell = tuple[Fraction, Fraction, Fraction, Fraction]
#: Boxes that were looked at, and the share of the area that was undecided then.
Law = Sequence[tuple[int, Fraction]]


def figure(found: CertifiedMap, strip: CertifiedStrip | None, name: str) -> shapes.Figure:
    """The figure of a map of boxes, with the strip that encloses its border."""
    progress = found.progress
    shares = {key: percent(share) for key, share in area_shares(progress).items()}
    law, finest = work(progress), len(progress.found[-1].keys[0])
    caption = (
        f"{plane_line(progress.document)}. Of the area {shares['collapses']} % collapses, "
        f"{shares['disperses']} % disperses, {shares['undecided']} % is undecided; the border lies "
        f"in what is undecided. {progress.boxes} boxes were looked at, the smallest with sides of "
        f"1/{2**finest} of the map; each verdict holds at every point of its box, and the checker "
        f"of maps has proved it anew. Last: the undecided share against the work, counted in boxes "
        f"(seconds differ from run to run): the border is a curve, so that four times as many "
        f"boxes leave about a quarter."
    )
    if strip is not None:
        caption += _about(strip)
    line = [] if strip is None else [shapes.Trace(list(border(strip.plane)), "paper")]
    panels = [_whole(progress, shares), _closer(progress, line), law_panel(law)]
    return shapes.Figure(name, "Which scenes collapse", caption, panels)


def is_border_of(strip: Strip, plane: Any) -> bool:
    """Whether a strip lies in the plane of a map."""
    return bool(strip.phi._replace(x=plane.x, y=plane.y) == plane)


def border(strip: Strip) -> Iterator[shapes.Point]:
    """The curve of a strip: its values in the middle of each part."""
    low, high = strip.x
    for number, (value, *_) in enumerate(strip.curve):
        middle = low + (high - low) * Fraction(2 * number + 1, 2 * len(strip.curve))
        yield float(middle), float(value)


def _about(strip: CertifiedStrip) -> str:
    low, high = strip.plane.x
    delta = exact_number(strip.plane.delta)
    return (
        f" The line in the second panel is the curve f of the log {strip.name}: for φ₁ in "
        f"[{low}, {high}] all states with φ₂ ≤ f - {delta} collapse and all with φ₂ ≥ f + {delta} "
        f"disperse, in {strip.tiles} tiles, each of which the checker of maps has proved anew."
    )


def work(progress: Progress) -> Law:
    """How many boxes had been looked at after each level, and what was undecided then.

    It depends on the log alone, and not on how often a run was interrupted.
    """
    boxes, decided, found = 0, Fraction(0), {}
    for chunk in progress.found:
        boxes += len(chunk.keys)
        decided += _decided(progress, chunk)
        found[len(chunk.keys[0])] = boxes, 1 - decided
    return list(found.values())


def _decided(progress: Progress, chunk: Any) -> Fraction:
    """The share of the area that a chunk decides; in a strip boxes of one level differ."""
    if not is_strip(progress.document):
        count = len(chunk.letters) - chunk.letters.count(UNDECIDED)
        return Fraction(count, len(progress.digits) ** len(chunk.keys[0]))
    pairs = zip(chunk.keys, chunk.letters, strict=True)
    shares = (progress.plane.share(key) for key, letter in pairs if letter != UNDECIDED)
    return sum(shares, Fraction(0))


def squares(progress: Progress, letter: str) -> Iterator[Cell]:
    """The boxes with a verdict, as left, right, low and high shares of the sides of the map."""
    for key, found, _ in progress.decided():
        if found == letter:
            size, (column, row) = Fraction(1, 1 << len(key)), cell(key)
            yield column * size, (column + 1) * size, row * size, (row + 1) * size


def cell(key: str) -> tuple[int, int]:
    """The column and the row of a box, among those of its size."""
    column, row = ("".join(str(int(digit) >> bit & 1) for digit in key) for bit in (0, 1))
    return int(column, 2), int(row, 2)


def window(progress: Progress) -> Cell:
    """A square around a piece of the border, in the middle of the map."""
    below = [c for c in squares(progress, COLLAPSES) if c[0] <= Fraction(1, 4) < c[1]]
    height = max((cell[3] for cell in below), default=Fraction(1, 2))
    left, low = (place // CLOSER * CLOSER for place in (Fraction(1, 4), height))
    return left, left + CLOSER, low, low + CLOSER


def _scales(progress: Progress, shown: Cell) -> tuple[shapes.Scale, shapes.Scale]:
    ends = progress.plane.x, progress.plane.y
    made = []
    for name, (low, high), at in zip(names(progress), ends, (shown[:2], shown[2:]), strict=True):
        first, last = (low + (high - low) * share for share in at)
        made.append(shapes.Scale(name, float(first), float(last), shapes.round_marks(first, last)))
    return made[0], made[1]


def names(progress: Progress) -> tuple[str, str]:
    """What the axes are, in short."""
    if progress.document["name"] == "phi":
        return "φ₁", "φ₂"
    return axis_names(progress.document)


def _areas(progress: Progress, shown: Cell, named: dict[str, str]) -> Iterator[shapes.Shape]:
    """The border's colour everywhere, and the decided boxes on top of it."""
    (x_0, x_1), (y_0, y_1) = progress.plane.x, progress.plane.y
    corners = {UNDECIDED: [shown]}
    for letter in (COLLAPSES, DISPERSES):
        inside = (_cut(cell, shown) for cell in squares(progress, letter))
        corners[letter] = [cell for cell in inside if cell[0] < cell[1] and cell[2] < cell[3]]
    for letter, boxes in corners.items():
        placed = [
            (x_0 + (x_1 - x_0) * a, x_0 + (x_1 - x_0) * b, y_0 + (y_1 - y_0) * c,
             y_0 + (y_1 - y_0) * d)
            for a, b, c, d in boxes
        ]  # fmt: skip
        yield shapes.Areas(shapes.merged(placed), COLOURS[letter], name=named[AREAS[letter][0]])


def _cut(cell: Cell, shown: Cell) -> Cell:
    a, b, c, d = cell
    return max(a, shown[0]), min(b, shown[1]), max(c, shown[2]), min(d, shown[3])


def _whole(progress: Progress, shares: dict[str, str]) -> shapes.Panel:
    x, y = _scales(progress, (Fraction(0), Fraction(1), Fraction(0), Fraction(1)))
    piece = window(progress)
    (x_0, x_1), (y_0, y_1) = progress.plane.x, progress.plane.y

    def drawn() -> Iterable[shapes.Shape]:
        everything = (Fraction(0), Fraction(1), Fraction(0), Fraction(1))
        yield from _areas(progress, everything, {n: f"{n} {s} %" for n, s in shares.items()})
        yield shapes.Frame((
            float(x_0 + (x_1 - x_0) * piece[0]), float(x_0 + (x_1 - x_0) * piece[1]),
            float(y_0 + (y_1 - y_0) * piece[2]), float(y_0 + (y_1 - y_0) * piece[3]),
        ))  # fmt: skip
        yield shapes.Words(
            (x.low + 0.6 * (x.high - x.low), y.low + 0.6 * (y.high - y.low)), "disperses"
        )
        yield shapes.Words(
            (x.low + 0.03 * (x.high - x.low), y.low + 0.1 * (y.high - y.low)), "collapses"
        )

    told = (
        f"The hatched area at the lower left collapses ({shares['collapses']} %), the plain one "
        f"above and to the right of it disperses ({shares['disperses']} %); the dark line between "
        f"them, {shares['undecided']} % of the area, is undecided and falls from the left side to "
        "the bottom. A small square on it is shown in the next panel."
    )
    return shapes.Panel("The whole map", x, y, drawn, told, height=372)


def _closer(progress: Progress, line: Sequence[shapes.Shape]) -> shapes.Panel:
    piece = window(progress)
    x, y = _scales(progress, piece)
    named = {name: name for name, _ in AREAS.values()}
    named["undecided"] = "undecided: the border"
    told = (
        f"A square of 1/{CLOSER.denominator} of each side: a dark band of boxes, falling to the "
        "right, between what disperses above and what collapses below."
    )
    title = f"The border, {CLOSER.denominator} times closer"
    return shapes.Panel(
        title, x, y, lambda: [*_areas(progress, piece, named), *line], told, height=372
    )


def law_panel(law: Law) -> shapes.Panel:
    """The undecided share against the boxes that were looked at; both axes are logarithmic."""
    points = [(float(boxes), 100 * float(share)) for boxes, share in law]
    boxes, share = points[-1]
    ends = min(2, math.floor(math.log10(points[0][0]))), max(5, math.ceil(math.log10(boxes)))
    low, high = (10.0**end for end in ends)
    x = shapes.Scale("boxes looked at", low, high, shapes.powers(*ends), logarithmic=True)
    least = min(math.floor(math.log10(share)), 1)
    marks = shapes.powers(least, 2)
    y = shapes.Scale("undecided, in % of the area", 10.0**least, 100, marks, logarithmic=True)

    def drawn() -> Iterable[shapes.Shape]:
        yield shapes.Straight((boxes / 30, share * 30), (boxes * 4, share / 4), "faint")
        yield shapes.Curve(points, "series-1", 0, "this map, level by level")
        yield shapes.Words((0.7 * boxes, share), "slope −1", "end")

    told = (
        f"The undecided share falls from {points[0][1]:.2g} % after {law[0][0]} boxes to "
        f"{share:.2g} % after {law[-1][0]}, along a line of slope -1 on logarithmic axes."
    )
    return shapes.Panel("Undecided area against work", x, y, drawn, told, height=372)
