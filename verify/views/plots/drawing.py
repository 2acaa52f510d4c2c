"""Panels as inline SVG that follows the colours of the page: light, dark, and paper.

Verdicts differ in lightness and in hatching, not in hue alone: blue is proved, hatched orange
refuted, grey undecided.
"""

from __future__ import annotations

import re
from base64 import b64encode
from collections.abc import Iterable, Iterator, Sequence
from html import escape
from textwrap import wrap
from zlib import crc32

from verify.views.plots import shapes
from verify.views.style import SCHEMES

#: What is hatched, and with which lines.
HATCHED = {"refuted-area": "refuted-line"}

LEFT, RIGHT, TOP, BOTTOM, LEGEND = 66, 14, 34, 52, 22
SIZE, LINE = 14, 20
#: No letter of a text is wider than this, on average.
LETTER = 8
#: Where an entry of a legend has more letters, there is one entry in a line.
LONG = 30


def svg(
    name: str, panels: Sequence[shapes.Panel], description: str, heading: Sequence[str] = ()
) -> str:
    """One SVG element with the panels side by side; ``name`` keeps its ids apart from others."""
    width = sum(panel.width for panel in panels)
    heading = [line for given in heading for line in wrap(given, width // LETTER)]
    top = LINE * len(heading) + 8 * bool(heading)
    height = max(panel.height for panel in panels) + top
    patterns = "".join(pattern(f"{name}-{area}", area) for area in HATCHED)
    parts = [
        begun(width, height, description),
        f"<defs>{patterns}</defs>",
        *(_text((8, LINE * number), line) for number, line in enumerate(heading, 1)),
    ]
    across = 0
    for panel in panels:
        body = "\n".join(_panel(name, panel))
        place = f'<g transform="translate({across} {top})">\n{body}\n</g>'
        parts.append(place if across or top else body)
        across += panel.width
    return "\n".join([*parts, "</svg>"])


def begun(width: float, height: float, description: str, more: str = 'role="img"') -> str:
    """How a drawing begins that is a part of a page."""
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height:.0f}" {more} '
        f'aria-label="{escape(description)}" font-family="system-ui, sans-serif" '
        f'font-size="{SIZE}">'
    )


def standalone(drawing: str) -> str:
    """The drawing as a file of its own, with both sets of colours."""
    rules = {
        scheme: ";".join(f"--{name}:{colour}" for name, colour in colours.items())
        for scheme, colours in SCHEMES.items()
    }
    style = (
        f"<style>svg{{{rules['light']};background:var(--paper)}}"
        f"@media (prefers-color-scheme:dark){{svg{{{rules['dark']}}}}}</style>"
    )
    head, end, rest = drawing.partition(">")
    return f"{head}{end}{style}{rest}\n"


def pattern(key: str, area: str) -> str:
    """The hatching of an area."""
    return (
        f'<pattern id="{key}" width="7" height="7" patternUnits="userSpaceOnUse">'
        f'<rect width="7" height="7" fill="var(--{area})"/>'
        f'<path d="M-1 1L1 -1M0 7L7 0M6 8L8 6" stroke="var(--{HATCHED[area]})" stroke-width="1.3"/>'
        "</pattern>"
    )


class _Place:
    """Where the values of a panel lie in its drawing."""

    def __init__(self, panel: shapes.Panel, legend: Sequence[str]) -> None:
        self.panel = panel
        self.columns = 1 if max(map(len, legend), default=0) > LONG else 2
        self.left, self.right = LEFT, panel.width - RIGHT
        self.top, self.bottom = (
            TOP,
            panel.height - BOTTOM - LEGEND * -(-len(legend) // self.columns),
        )

    def x(self, value: float) -> float:
        return self.left + (self.right - self.left) * self.panel.x.share(value)

    def y(self, value: float) -> float:
        return self.bottom - (self.bottom - self.top) * self.panel.y.share(value)


def _panel(name: str, panel: shapes.Panel) -> Iterator[str]:
    drawn = list(panel.shapes())
    legend = [s for s in drawn if isinstance(s, shapes.Areas | shapes.Curve) and s.name]
    place = _Place(panel, [shape.name for shape in legend])
    clip = f"{name}-clip-{_number_of(panel.title)}"
    size = f'width="{place.right - place.left}" height="{place.bottom - place.top}"'
    yield f'<clipPath id="{clip}"><rect x="{place.left}" y="{place.top}" {size}/></clipPath>'
    yield f'<g clip-path="url(#{clip})">'
    for shape in drawn:
        if not isinstance(shape, shapes.Words):
            yield from _shape(name, shape, place)
    yield "</g>"
    if panel.axes:
        yield from _axes(place)
    yield _text((8, 20), panel.title, weight="600")
    for shape in drawn:
        if isinstance(shape, shapes.Words):
            at = place.x(shape.at[0]), place.y(shape.at[1])
            yield from _lines(at, shape)
    yield from _legend(name, legend, place)


def _number_of(text: str) -> int:
    """A number that belongs to a text, the same in every run."""
    return crc32(text.encode())


# --- shapes --------------------------------------------------------------------------------------


def _shape(name: str, shape: shapes.Shape, place: _Place) -> Iterator[str]:
    match shape:
        case shapes.Areas():
            yield _boxes(name, shape, place)
        case shapes.Curve():
            yield from _curve(shape, place)
        case shapes.Rule(at=at):
            y = place.y(at)
            yield f'<path d="M{place.left} {y:.1f}H{place.right}" stroke="var(--ink)"/>'
        case shapes.Frame(corners=(left, right, low, high)):
            x, y = place.x(left), place.y(high)
            size = f'width="{place.x(right) - x:.1f}" height="{place.y(low) - y:.1f}"'
            for colour, width in (("paper", 4), ("ink", 1.5)):
                style = f'stroke="var(--{colour})" stroke-width="{width}"'
                yield f'<rect x="{x:.1f}" y="{y:.1f}" {size} fill="none" {style}/>'
        case shapes.Trace(points=points, colour=colour):
            path = "L".join(f"{place.x(x):.1f} {place.y(y):.1f}" for x, y in points)
            style = f'stroke="var(--{colour})" stroke-width="2"'
            yield f'<path d="M{path}" fill="none" {style}/>'
        case shapes.Straight(start=start, end=end, colour=colour):
            (x, y), (u, v) = ((place.x(a), place.y(b)) for a, b in (start, end))
            yield (
                f'<path d="M{x:.1f} {y:.1f}L{u:.1f} {v:.1f}" stroke="var(--{colour})" '
                'stroke-dasharray="5 4" stroke-width="1.5"/>'
            )
        case shapes.Disc():
            yield _disc(shape, place)
        case shapes.Tiles() | shapes.Dots():
            yield _tiles(shape, place) if isinstance(shape, shapes.Tiles) else _dots(shape, place)


def _tiles(shape: shapes.Tiles, place: _Place) -> str:
    path = "z".join(
        "M" + "L".join(f"{place.x(x):.3f} {place.y(y):.3f}" for x, y in corners)
        for corners in shape.corners
    )
    return f'<path fill="{shape.colour}" stroke="{shape.rim}" stroke-width=".1" d="{path}z"/>'


def _dots(shape: shapes.Dots, place: _Place) -> str:
    href = f"data:image/png;base64,{b64encode(shape.png).decode()}"
    size = f'width="{place.right - place.left}" height="{place.bottom - place.top}"'
    style = 'preserveAspectRatio="none" image-rendering="pixelated"'
    return f'<image x="{place.left}" y="{place.top}" {size} {style} href="{href}"/>'


def _disc(shape: shapes.Disc, place: _Place) -> str:
    (a, b), colour = shape.at, f"var(--{shape.colour})"
    x, y = place.x(a), place.y(b)
    across, down = place.x(a + shape.radius) - x, y - place.y(b + shape.radius)
    more = ' fill-opacity="0.25"' if shape.filled else ""
    more += f' stroke-dasharray="{shape.dashes}"' if shape.dashes else ""
    return (
        f'<ellipse cx="{x:.1f}" cy="{y:.1f}" rx="{across:.1f}" ry="{down:.1f}" '
        f'fill="{colour if shape.filled else "none"}" stroke="{colour}"{more}/>'
    )


def _boxes(name: str, shape: shapes.Areas, place: _Place) -> str:
    path = "".join(
        f"M{place.x(left):.1f} {place.y(low):.1f}H{place.x(right):.1f}"
        f"V{place.y(high):.1f}H{place.x(left):.1f}z"
        for left, right, low, high in shape.corners
    )
    edge = f' stroke="var(--{shape.colour})" stroke-width="{shape.edge}"' if shape.edge else ""
    crisp = "" if shape.edge else ' shape-rendering="crispEdges"'
    key = f' id="{shape.key}" class="curve"' if shape.key else ""
    return f'<path{key} d="{path}" fill="{_fill(name, shape.colour)}"{edge}{crisp}/>'


def _fill(name: str, colour: str) -> str:
    if colour.startswith("#"):
        return colour
    return f"url(#{name}-{colour})" if colour in HATCHED else f"var(--{colour})"


#: The marks of measured points, around the origin; of more points than this some have none.
MOST = 60
MARKS = ("M-4 0a4 4 0 1 0 8 0a4 4 0 1 0-8 0z", "M-4-4h8v8h-8z", "M0-5l5 9h-10z", "M0 5l5-9h-10z")


def _curve(shape: shapes.Curve, place: _Place) -> Iterator[str]:
    points = [(place.x(x), place.y(y)) for x, y in shape.points]
    path = "M" + "L".join(f"{x:.1f} {y:.1f}" for x, y in points)
    style = f'stroke="var(--{shape.colour})" stroke-width="1.4"{_dashes(shape)}'
    yield f'<path d="{path}" fill="none" {style}/>'
    if shape.mark is not None:
        yield from (_mark(at, shape) for at in points[:: 1 + (len(points) - 1) // MOST])


def _dashes(shape: shapes.Curve) -> str:
    return f' stroke-dasharray="{shape.dashes}"' if shape.dashes else ""


def _mark(at: shapes.Point, shape: shapes.Curve) -> str:
    if shape.mark is None:
        style = f'stroke="var(--{shape.colour})"{_dashes(shape)}'
        return f'<path d="M{at[0] - 9:.1f} {at[1]:.1f}h18" {style}/>'
    return (
        f'<path d="{MARKS[shape.mark % len(MARKS)]}" fill="var(--{shape.colour})" '
        f'transform="translate({at[0]:.1f} {at[1]:.1f})"/>'
    )


# --- words ---------------------------------------------------------------------------------------


def _text(at: shapes.Point, text: str, anchor: str = "start", weight: str = "") -> str:
    more = f' text-anchor="{anchor}"' if anchor != "start" else ""
    more += f' font-weight="{weight}"' if weight else ""
    text = LETTERS.sub(LOWER, escape(text))
    return f'<text x="{at[0]:.1f}" y="{at[1]:.1f}" fill="var(--ink)"{more}>{text}</text>'


#: W_c or η_c and the letter that follows, and how the c is written below the line.
LETTERS = re.compile(r"\b([Wη])_([cs])(?![A-Za-z0-9_])(.?)")
LOWER = r'\1<tspan dy="4" font-size="11">\2</tspan><tspan dy="-4">\3</tspan>'
_RIM = 'paint-order="stroke" stroke="var(--paper)" stroke-width="4" stroke-linejoin="round"'


def _lines(at: shapes.Point, shape: shapes.Words) -> Iterator[str]:
    """The lines of some words, each with a rim that keeps it readable on colours."""
    for number, line in enumerate(shape.text.split("\n")):
        text = _text((at[0], at[1] + 5 + 18 * number), line, shape.anchor)
        yield text.replace("<text", f"<text {_RIM}", 1)


def _axes(place: _Place) -> Iterator[str]:
    left, right, top, bottom = place.left, place.right, place.top, place.bottom
    yield f'<path d="M{left} {top}V{bottom}H{right}" fill="none" stroke="var(--faint)"/>'
    x, y = place.panel.x, place.panel.y
    for value, text in _shown(x):
        yield f'<path d="M{place.x(value):.1f} {bottom}v5" stroke="var(--faint)"/>'
        inside = min(place.x(value), place.panel.width - LETTER * len(text) / 2)
        yield _text((inside, bottom + 19), text, "middle")
    for value, text in _shown(y):
        yield f'<path d="M{left} {place.y(value):.1f}h-5" stroke="var(--faint)"/>'
        yield _text((left - 8, place.y(value) + 5), text, "end")
    yield _text(((left + right) / 2, bottom + 41), x.label, "middle")
    middle = (top + bottom) / 2
    yield (
        f'<text transform="translate(16 {middle:.1f}) rotate(-90)" text-anchor="middle" '
        f'fill="var(--ink)">{escape(y.label)}</text>'
    )


def _shown(scale: shapes.Scale) -> Iterable[tuple[float, str]]:
    return (tick for tick in scale.ticks if -1e-9 <= scale.share(tick[0]) <= 1 + 1e-9)


def _legend(
    name: str, entries: Sequence[shapes.Areas | shapes.Curve], place: _Place
) -> Iterator[str]:
    """What each colour means, below the panel in one or two columns."""
    top = place.bottom + BOTTOM + 6
    for number, entry in enumerate(entries):
        x = 14 + (number % place.columns) * (place.panel.width / 2 - 8)
        y = top + LEGEND * (number // place.columns)
        if isinstance(entry, shapes.Areas):
            fill = _fill(name, entry.colour)
            yield f'<rect x="{x}" y="{y - 11}" width="18" height="13" fill="{fill}"/>'
        else:
            yield _mark((x + 9, y - 5), entry)
        yield _text((x + 25, y), entry.name)
