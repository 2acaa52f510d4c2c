"""Maps coloured by what becomes of the scene in the middle of each box, with a colour bar.

From dark to light the colours get lighter evenly, so that they can be told apart in grey.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from html import escape
from textwrap import wrap

from verify.prover.decimals import decimal_text, people, round_decimal
from verify.prover.outcome import Ends
from verify.views.map import Box, Middle, middle_time
from verify.views.plots.shapes import axis_of, logarithmic_marks, round_marks

#: From dark to light.
RAMP = ("#0b1f4b", "#32407a", "#6a5f86", "#a3807c", "#d6a767", "#f6d860")
#: The three balls.
BALLS = (RAMP[0], RAMP[3], RAMP[5])
SIDE, LEFT, TOP, LINE, BAR, STEPS = 400, 64, 34, 18, 18, 64
INK = "#1c2128"
#: No letter of a text is wider than this, on average.
LETTER = 7
#: The patterns of what is undecided, and of collisions that are finitely many, but not counted.
PATTERNS = (
    '<defs><pattern id="open" width="4" height="4" patternUnits="userSpaceOnUse">'
    f'<path d="M-1 1L1 -1M0 4L4 0M3 5L5 3" stroke="{INK}" stroke-width="1.2"/></pattern>'
    '<pattern id="some" width="5" height="5" patternUnits="userSpaceOnUse">'
    f'<path d="M1 1h2v2h-2z" fill="{INK}"/></pattern></defs>'
)
#: Values that differ by such a factor are drawn on a logarithmic scale.
WIDE = 50.0

Axes = Sequence[tuple[str, Fraction, Fraction]]
Pairs = Sequence[tuple[Box, Middle]]


class Colouring:
    """A name, a title, what is drawn, what the colour bar shows, and what white is."""

    def __init__(
        self, name: str, title: str, value: Callable[[Middle], float | None], bar: str, white: str
    ) -> None:
        self.name, self.title, self.value, self.bar, self.white = name, title, value, bar, white


def _central(middle: Middle) -> float | None:
    return None if middle.central is None else float(middle.central)


def _number(middle: Middle) -> float | None:
    return float(middle.collisions) if middle.verdict == "disperses" else None


def _time(middle: Middle) -> float | None:
    found = middle_time(middle)
    return None if found is None else float(found)


COLOURINGS = (
    Colouring("central", "central ball of the collapse", _central, "", "no collapse"),
    Colouring("collisions", "number of collisions", _number, "collisions", "infinitely many"),
    Colouring("time", "time of the collapse", _time, "time", "no collapse"),
)


def coloured(
    colouring: Colouring, axes: Axes, pairs: Pairs, heading: Sequence[str], unit: str
) -> str:
    """The picture, with these lines above it; times are in this unit."""
    width, height = LEFT + SIDE + 230, TOP + SIDE + 90
    title = f"{colouring.title}, at the middle of each box"
    lines = [line for given in (*heading, title) for line in wrap(given, width // LETTER)]
    font = f'font-family="sans-serif" font-size="12" fill="{INK}" style="background:#fff"'
    values = [colouring.value(middle) for _, middle in pairs]
    known = [value for value in values if value is not None]
    scale = Ramp(known)
    is_balls, is_count = colouring.name == "central", colouring.name == "collisions"
    view = f'viewBox="0 0 {width} {height + LINE * len(lines)}"'
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" {view} role="img" {font}>',
        f"<title>{escape(title)}</title>",
        PATTERNS,
        *(_text(8, LINE * k, line, "start") for k, line in enumerate(lines, 1)),
        f'<g transform="translate(0 {LINE * len(lines)})">',
    ]
    parts.append('<g shape-rendering="crispEdges">')
    for (box, middle), value in zip(pairs, values, strict=True):
        fill = "#fff" if value is None else scale.colour(value)
        if is_balls and value is not None:
            fill = BALLS[int(value)]
        if is_count and middle.verdict == "finite":
            fill = "url(#some)"
        if middle.verdict == "undecided":
            fill = "url(#open)"
        parts.append(_box(axes, box, fill))
    parts.append("</g>")
    parts += _axes(axes)
    if is_balls:
        parts += _balls()
    elif known:
        named = f"time ({unit})" if unit and not is_count else colouring.bar
        parts += _bar(scale, named, is_count=is_count)
    parts += _keys(colouring.white, 70 if is_balls else SIDE - 150)
    if is_count:
        parts += _key(SIDE - 106, "url(#some)", "finitely many, not counted")
    if colouring.name == "time":
        times = [middle.time for _, middle in pairs if middle.time is not None]
        for k, line in enumerate(widths_lines(scale, times, unit)):
            parts.append(_text(8, height - 26 + LINE * k, line, "start"))
    return "\n".join([*parts, "</g></svg>", ""])


def widths_lines(scale: Ramp, times: Sequence[Ends], unit: str) -> Sequence[str]:
    """How wide the enclosures are whose middles have the colours; nothing without any."""
    if not times:
        return ()
    widest = people(decimal_text(*round_decimal(max(b - a for a, b in times), 2, up=True)))
    most = f"at most {widest} {unit}".rstrip()
    steps = [scale.share(float(high)) - scale.share(float(low)) for low, high in times]
    wide = sum(STEPS * step > 1 for step in steps)
    return (
        f"Each colour shows the middle of an enclosure of the time, which is {most} wide;",
        f"{wide} of the {len(times)} enclosures are wider than 1/{STEPS} of the bar of colours.",
    )


class Ramp:
    """Colours for values between the least and the largest, linear or logarithmic."""

    def __init__(self, values: Sequence[float]) -> None:
        self.low, self.high = (min(values), max(values)) if values else (0.0, 1.0)
        self.is_logarithmic = self.low > 0 and self.high > WIDE * self.low

    def share(self, value: float) -> float:
        """Where between the ends a value is, from 0 to 1."""
        if self.high == self.low:
            return 0.0
        if self.is_logarithmic:
            return math.log(value / self.low) / math.log(self.high / self.low)
        return (value - self.low) / (self.high - self.low)

    def marks(self) -> list[tuple[float, str]]:
        """Round values between the ends."""
        if self.is_logarithmic:
            return logarithmic_marks(self.low, self.high)
        return round_marks(Fraction(self.low), Fraction(self.high), 4)

    def colour(self, value: float) -> str:
        """The colour of a value."""
        return between(self.share(value))


def between(share: float) -> str:
    """The colour at a share of the ramp."""
    place = min(max(share, 0.0), 1.0) * (len(RAMP) - 1)
    k = min(int(place), len(RAMP) - 2)
    parts = zip(_rgb(RAMP[k]), _rgb(RAMP[k + 1]), strict=True)
    return "#" + "".join(f"{round(a + (b - a) * (place - k)):02x}" for a, b in parts)


def _rgb(colour: str) -> Sequence[int]:
    return bytes.fromhex(colour[1:])


def _box(axes: Axes, box: Box, fill: str) -> str:
    sides = [box.x, (Fraction(0), Fraction(1)) if box.y is None else box.y]
    ends = [(low, high) for _, low, high in axes] + [(Fraction(0), Fraction(1))]
    (x_0, x_1), (y_0, y_1) = (
        [float((end - low) / (high - low)) * SIDE for end in side]
        for side, (low, high) in zip(sides, ends, strict=False)
    )
    place = f'x="{LEFT + x_0:.6g}" y="{TOP + SIDE - y_1:.6g}"'
    return f'<rect {place} width="{x_1 - x_0:.6g}" height="{y_1 - y_0:.6g}" fill="{fill}"/>'


def _axes(axes: Axes) -> Iterator[str]:
    low = TOP + SIDE
    yield f'<rect x="{LEFT}" y="{TOP}" width="{SIDE}" height="{SIDE}" fill="none" stroke="{INK}"/>'
    for number, given in enumerate(axes):
        name, marks = axis_of(*given)
        for share, text in marks:
            along = share * SIDE
            if number == 0:
                yield f'<path d="M{LEFT + along:g} {low}v5" stroke="{INK}"/>'
                yield _text(LEFT + along, low + 18, text, "middle")
            else:
                yield f'<path d="M{LEFT} {low - along:g}h-5" stroke="{INK}"/>'
                yield _text(LEFT - 8, low - along + 4, text, "end")
        if number == 0:
            yield _text(LEFT + SIDE / 2, low + 38, name, "middle")
        else:
            yield _text(LEFT - 6, TOP - 8, name, "start")


def _bar(scale: Ramp, name: str, *, is_count: bool) -> Iterator[str]:
    """The colour bar, with round values; or one colour for one value."""
    left, height = LEFT + SIDE + 30, SIDE - 180
    yield _text(left, TOP - 8, name, "start")
    if scale.low == scale.high:
        yield from _key(0, scale.colour(scale.low), f"{scale.low:.6g}")
        return
    size = height / STEPS
    yield '<g shape-rendering="crispEdges">'
    for k in range(STEPS):
        place = f'x="{left}" y="{TOP + height - (k + 1) * size:.6g}" width="{BAR}"'
        yield f'<rect {place} height="{size + 0.3:.6g}" fill="{between((k + 0.5) / STEPS)}"/>'
    yield "</g>"
    for value, text in scale.marks():
        if not (is_count and value % 1):
            y = TOP + height * (1 - scale.share(value))
            yield f'<path d="M{left + BAR} {y:.6g}h4" stroke="{INK}"/>'
            yield _text(left + BAR + 8, y + 4, text, "start")


def _balls() -> Iterator[str]:
    for ball, colour in enumerate(BALLS):
        yield from _key(22 * ball, colour, f"ball {ball}")


def _keys(white: str, top: float) -> Iterator[str]:
    yield from _key(top, "#fff", white)
    yield from _key(top + 22, "url(#open)", "undecided")


def _key(down: float, fill: str, text: str) -> Iterator[str]:
    left = LEFT + SIDE + 30
    place = f'x="{left}" y="{TOP + down:g}" width="14" height="14"'
    yield f'<rect {place} fill="{fill}" stroke="{INK}"/>'
    yield _text(left + 20, TOP + down + 12, text, "start")


def _text(x: float, y: float, text: str, anchor: str) -> str:
    return f'<text x="{x:g}" y="{y:g}" text-anchor="{anchor}">{escape(text)}</text>'
