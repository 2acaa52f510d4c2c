"""A map as a picture: its areas, and beside boxes how the undecided one shrinks with the work."""

from __future__ import annotations

import math
import struct
import zlib
from collections import Counter
from collections.abc import Iterator, Sequence
from fractions import Fraction

from verify.prover.decimals import exact_number
from verify.views.map import (
    Progress,
    Strip,
    area_shares,
    areas_shown,
    is_interval,
    is_strip,
    percent,
    plane_line,
    tile_corners,
)
from verify.views.plots.drawing import standalone, svg
from verify.views.plots.map_figure import cell, law_panel, work
from verify.views.plots.shapes import Areas, Dots, Panel, Point, Scale, Shape, Tiles, axis_of

#: The colours of the areas, on light and on dark paper: they differ in grey, too.
COLOURS = {"c": "#f7bb70", "d": "#2e6bb6", "u": "#111111", "f": "#7499c8"}
#: The size of the panel, whose inner side is a square.
WIDTH, HEIGHT = 480, 530
UNIT: list[Point] = [(0, 0), (1, 0), (1, 1), (0, 1)]
#: A picture of dots has 2^FINEST of them on a side.
FINEST = 10


def svg_map(
    progress: Progress, names: Sequence[str], heading: Sequence[str], *, boxes: bool = False
) -> str:
    """The areas with their shares, in dots; or as boxes, with the undecided share against them.

    ``names`` are those of the axes, with their units; the lines of the heading stand above.
    """
    law = [(count, share) for count, share in work(progress) if share]
    if boxes and is_strip(progress.document):
        delta = exact_number(progress.plane.delta)
        heading = [*heading, f"vertical: logarithmic; in the middle all from -{delta} to {delta}"]
    panels = [_areas(progress, names, boxes=boxes)]
    panels += [law_panel(law)] if boxes and len(law) > 1 else []
    return standalone(svg("map", panels, plane_line(progress.document), heading))


def _areas(progress: Progress, names: Sequence[str], *, boxes: bool) -> Panel:
    found, shown = area_shares(progress), areas_shown(progress)

    def drawn() -> Iterator[Shape]:
        if boxes:
            yield Tiles([UNIT], COLOURS["u"], COLOURS["u"])
            for letter in (one for one in shown if one != "u"):
                keys = (key for key, one, _ in progress.decided() if one == letter)
                tiles = [_corners(progress, key) for key in keys]
                yield Tiles(tiles, COLOURS[letter], COLOURS["u"])
        else:
            yield Dots(png_map(progress))
        for letter, (name, _) in shown.items():
            yield Areas([], COLOURS[letter], name=f"{name} {percent(found[name])} %")

    x, y = _scales(progress, names, boxes=boxes)
    # Beside long marks there is no room for the label of the vertical axis: it stands above.
    return Panel(y.label, x, y._replace(label=""), drawn, "", WIDTH, HEIGHT)


def _scales(progress: Progress, names: Sequence[str], *, boxes: bool) -> tuple[Scale, Scale]:
    """The axes, on which shares of the sides are marked with what they stand for."""
    (x_0, x_1), (y_0, y_1) = progress.plane.x, progress.plane.y or (Fraction(0), Fraction(1))
    x_name, across = axis_of(names[0], x_0, x_1)
    y_name, up = ("", []) if is_interval(progress.document) else axis_of(names[1], y_0, y_1)
    if boxes and is_strip(progress.document):
        up = [(0.0, exact_number(-y_1, 6)), (1.0, exact_number(y_1, 6))]
        y_name = "φ₂ - f(φ₁)"
    return Scale(x_name, 0, 1, across), Scale(y_name, 0, 1, up)


def _corners(progress: Progress, key: str) -> list[Point]:
    """A box in the unit square; tiles of a strip are drawn by their distance from the curve."""
    if is_strip(progress.document):
        return tile_corners(progress.plane, key)
    size, (column, row) = 0.5 ** len(key), cell(key)
    height, bottom = (1.0, 0.0) if is_interval(progress.document) else (size, row * size)
    return [(column * size + size * x, bottom + height * y) for x, y in UNIT]


def png_map(progress: Progress) -> bytes:
    """The areas in dots, the lower row last; a dot in which not all is decided is undecided."""
    side = 1 << FINEST
    dots = [bytearray(side) for _ in range(side)]
    if is_strip(progress.document) and not progress.due:
        _fill_strip(dots, progress.plane)
    elif not is_strip(progress.document):
        for key, letter in _whole_dots(progress):
            _fill(dots, key, "ucdf".index(letter), is_bar=is_interval(progress.document))
    rows = b"".join(b"\0" + bytes(row) for row in reversed(dots))
    colours = "ucdf" if area_shares(progress).get("finite") else "ucd"
    palette = b"".join(bytes.fromhex(COLOURS[letter][1:]) for letter in colours)
    header = struct.pack(">IIBBBBB", side, side, 8, 3, 0, 0, 0)
    data = zlib.compress(rows, 9)
    blocks = ((b"IHDR", header), (b"PLTE", palette), (b"IDAT", data), (b"IEND", b""))
    return b"\x89PNG\r\n\x1a\n" + b"".join(_block(kind, data) for kind, data in blocks)


def _whole_dots(progress: Progress) -> Iterator[tuple[str, str]]:
    """The boxes that are not smaller than a dot; and dots that smaller ones of a kind fill."""
    parts, deepest = len(progress.digits), progress.level
    filled: Counter[tuple[str, str]] = Counter()
    for key, letter, _ in progress.decided():
        if len(key) <= FINEST:
            yield key, letter
        else:
            filled[key[:FINEST], letter] += parts ** (deepest - len(key))
    yield from (dot for dot, count in filled.items() if count == parts ** (deepest - FINEST))


def _fill(dots: list[bytearray], key: str, colour: int, *, is_bar: bool) -> None:
    size = 1 << FINEST - len(key)
    column, row = (place * size for place in cell(key))
    for line in dots if is_bar else dots[row : row + size]:
        line[column : column + size] = bytes([colour]) * size


def _fill_strip(dots: list[bytearray], plane: Strip) -> None:
    """All tiles are decided: a dot has the colour of its side, by the middle of its column."""
    side, parts = len(dots), len(plane.curve)
    half = float(plane.x[1] - plane.x[0]) / parts / 2
    top, delta = float(plane.y[1]), float(plane.delta)
    columns = []
    for i in range(side):
        place = i * parts // side
        t = half * (2 * ((i + 0.5) * parts / side - place) - 1)
        c_0, c_1, c_2 = map(float, plane.curve[place])
        f = c_0 + t * (c_1 + t * c_2)
        below, above = int((f - delta) / top * side), math.ceil((f + delta) / top * side)
        columns.append(b"\1" * below + b"\0" * (above - below) + b"\2" * (side - above))
    for line, row in zip(dots, zip(*columns, strict=True), strict=True):
        line[:] = bytes(row)


def _block(kind: bytes, data: bytes) -> bytes:
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
