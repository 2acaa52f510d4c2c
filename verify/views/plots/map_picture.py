"""A map as a picture: its three areas, and how the undecided one shrinks with the work."""

from __future__ import annotations

import math
import struct
import zlib
from base64 import b64encode
from collections.abc import Iterator, Sequence
from fractions import Fraction
from html import escape

from verify.prover.decimals import exact_number
from verify.views.map import (
    Progress,
    Strip,
    area_shares,
    areas_shown,
    axis_names,
    is_interval,
    is_strip,
    percent,
    plane_line,
    tile_corners,
)
from verify.views.plots.map_figure import work

#: The colours of the areas, on light and on dark paper: they differ in grey, too.
COLOURS = {"c": "#f7bb70", "d": "#2e6bb6", "u": "#111111", "f": "#8fb3dd"}
#: The sides of the map and of the law beside it, in points.
SIDE, LAW = 400, 260
LEFT, TOP = 64, 40
#: A vertical axis has its title so far above it, beside its last mark.
TITLE = 10
#: A picture of dots has 2^FINEST of them on a side.
FINEST = 10

Law = Sequence[tuple[float, float]]


def svg_map(progress: Progress, *, boxes: bool = False) -> str:
    """The areas, in dots or as boxes, their shares, and the undecided share against the boxes."""
    width, height = LEFT + SIDE + 110 + LAW + 20, TOP + SIDE + 90
    size = f'viewBox="0 0 {width} {height}" role="img"'
    font = 'font-family="sans-serif" font-size="12" fill="#1c2128" style="background:#fff"'
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" {size} {font}>',
        f"<title>{escape(plane_line(progress.document))}</title>",
        *_areas(progress, boxes=boxes),
        *_legend(progress),
        *_law([(float(n), float(u)) for n, u in work(progress)]),
        "</svg>",
    ]
    return "\n".join(parts) + "\n"


def _areas(progress: Progress, *, boxes: bool) -> Iterator[str]:
    place = f'x="{LEFT}" y="{TOP}" width="{SIDE}" height="{SIDE}"'
    if boxes:
        yield f'<rect {place} fill="{COLOURS["u"]}"/>'
        yield f'<g transform="translate({LEFT} {TOP + SIDE}) scale({SIDE} {-SIDE})">'
        for letter in "cdf" if area_shares(progress).get("finite") else "cd":
            keys = (key for key, found, _ in progress.decided() if found == letter)
            path = "".join(_box(progress, key) for key in keys)
            style = f'stroke="{COLOURS["u"]}" stroke-width=".0004"'
            yield f'<path fill="{COLOURS[letter]}" {style} d="{path}"/>'
        yield "</g>"
    else:
        data = b64encode(png_map(progress)).decode()
        yield f'<image {place} image-rendering="pixelated" href="data:image/png;base64,{data}"/>'
    (x_0, x_1), (y_0, y_1) = progress.plane.x, progress.plane.y or (Fraction(0), Fraction(1))
    x_name, y_name = axis_names(progress.document)
    if boxes and is_strip(progress.document):
        delta, y_0 = progress.plane.delta, -y_1
        y_name = f"φ2 - f(φ1), logarithmic; in the middle all from -{delta} to {delta}"
    low = TOP + SIDE
    for quarter in range(5):
        share = Fraction(quarter, 4)
        across, up = LEFT + float(share) * SIDE, low - float(share) * SIDE
        ticks = f"M{across:g} {low}v5"
        yield _text(across, low + 18, exact_number(x_0 + share * (x_1 - x_0), 6), "middle")
        if is_interval(progress.document):
            pass
        elif quarter in (0, 4) or not (boxes and is_strip(progress.document)):
            ticks += f"M{LEFT} {up:g}h-5"
            yield _text(LEFT - 8, up + 4, exact_number(y_0 + share * (y_1 - y_0), 6), "end")
        yield f'<path d="{ticks}" stroke="#1c2128" fill="none"/>'
    yield _text(LEFT + SIDE // 2, low + 36, x_name, "middle")
    yield _text(LEFT, TOP - TITLE, y_name, "start")


def _box(progress: Progress, key: str) -> str:
    """Tiles of a strip are drawn by their distance from the curve."""
    if is_interval(progress.document):
        size = 0.5 ** len(key)
        return f"M{_short(int(key, 2) * size)} 0h{_short(size)}v1h-{_short(size)}"
    if not is_strip(progress.document):
        return _square(key)
    corners = (f"{_short(x)} {_short(y)}" for x, y in tile_corners(progress.plane, key))
    return f"M{'L'.join(corners)}z"


def _square(key: str) -> str:
    column = int("".join("01"[int(d) & 1] for d in key), 2)
    row = int("".join("01"[int(d) >> 1] for d in key), 2)
    size = 0.5 ** len(key)
    x, y, edge = _short(column * size), _short(row * size), _short(size)
    return f"M{x} {y}h{edge}v{edge}h-{edge}"


def _short(value: float) -> str:
    return f"{value:.6g}".removeprefix("0") or "0"


def _text(x: float, y: float, text: str, anchor: str) -> str:
    return f'<text x="{x:g}" y="{y:g}" text-anchor="{anchor}">{escape(text)}</text>'


def _legend(progress: Progress) -> Iterator[str]:
    found = area_shares(progress)
    for place, (letter, (name, _)) in enumerate(areas_shown(progress).items()):
        x, y = LEFT + 150 * place, TOP + SIDE + 54
        yield f'<rect x="{x}" y="{y}" width="12" height="12" fill="{COLOURS[letter]}"/>'
        yield _text(x + 17, y + 10, f"{name} {percent(found[name])} %", "start")
    yield _text(LEFT, 16, plane_line(progress.document).partition("; ")[2], "start")


def _law(law: Law) -> Iterator[str]:
    """Both axes are logarithmic; the line has the slope -1."""
    points = [(math.log10(s), math.log10(u)) for s, u in law if s > 0 and u > 0]
    if len(points) < 2:
        return
    left, low = LEFT + SIDE + 110, TOP + LAW
    x_0, x_1 = math.floor(min(x for x, _ in points)), math.ceil(max(x for x, _ in points))
    y_0, y_1 = math.floor(min(y for _, y in points)), math.ceil(max(y for _, y in points))
    scale = LAW / max(x_1 - x_0, y_1 - y_0)

    def place(x: float, y: float) -> str:
        return f"{left + (x - x_0) * scale:.1f},{low - (y - y_0) * scale:.1f}"

    yield f'<rect x="{left}" y="{TOP}" width="{LAW}" height="{LAW}" fill="none" stroke="#8a929c"/>'
    for power in range(x_0, x_1 + 1):
        yield _text(left + (power - x_0) * scale, low + 18, f"{10.0**power:g}", "middle")
    for power in range(y_0, y_1 + 1):
        height = low - (power - y_0) * scale + 4
        yield _text(left - 6, height, f"{10.0 ** (power + 2):g} %", "end")
    x, y = points[-1]
    back = min(x - x_0, y_1 - y)
    yield f'<polyline points="{place(x, y)} {place(x - back, y + back)}" stroke="#8a929c" '
    yield 'stroke-dasharray="4 3" fill="none"/>'
    dots = " ".join(place(x, y) for x, y in points)
    yield f'<polyline points="{dots}" stroke="{COLOURS["d"]}" stroke-width="1.5" fill="none"/>'
    yield _text(left + LAW // 2, low + 36, "boxes looked at", "middle")
    yield _text(left, TOP - TITLE, "undecided share; dashes: slope -1", "start")


def png_map(progress: Progress) -> bytes:
    """The areas in dots, the lower row last; a dot in which not all is decided is undecided."""
    side = 1 << FINEST
    dots = [bytearray(side) for _ in range(side)]
    if is_strip(progress.document) and not progress.due:
        _fill_strip(dots, progress.plane)
    for key, letter, _ in progress.decided():
        if len(key) <= FINEST and not is_strip(progress.document):
            _fill(dots, key, "ucdf".index(letter), is_bar=is_interval(progress.document))
    rows = b"".join(b"\0" + bytes(row) for row in reversed(dots))
    colours = "ucdf" if area_shares(progress).get("finite") else "ucd"
    palette = b"".join(bytes.fromhex(COLOURS[letter][1:]) for letter in colours)
    header = struct.pack(">IIBBBBB", side, side, 8, 3, 0, 0, 0)
    data = zlib.compress(rows, 9)
    blocks = ((b"IHDR", header), (b"PLTE", palette), (b"IDAT", data), (b"IEND", b""))
    return b"\x89PNG\r\n\x1a\n" + b"".join(_block(kind, data) for kind, data in blocks)


def _fill(dots: list[bytearray], key: str, colour: int, *, is_bar: bool) -> None:
    size = 1 << FINEST - len(key)
    column = int("".join("01"[int(d) & 1] for d in key), 2) * size
    row = int("".join("01"[int(d) >> 1] for d in key), 2) * size
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
