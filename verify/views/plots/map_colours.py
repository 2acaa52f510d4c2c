"""Maps coloured by what becomes of the scene in the middle of each box, with a colour bar.

From dark to light the colours get lighter evenly, so that they can be told apart in grey.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from html import escape

from verify.views.map import Box, Middle, middle_time
from verify.views.plots.shapes import shares_of

#: From dark to light.
RAMP = ("#0b1f4b", "#32407a", "#6a5f86", "#a3807c", "#d6a767", "#f6d860")
#: The three balls.
BALLS = (RAMP[0], RAMP[3], RAMP[5])
SIDE, LEFT, TOP, BAR = 400, 64, 46, 18
INK, GREY = "#1c2128", "#c9ced4"
#: The pattern of what is undecided.
OPEN = (
    '<defs><pattern id="open" width="6" height="6" patternUnits="userSpaceOnUse">'
    f'<path d="M0 6L6 0" stroke="{INK}" stroke-width="1.2"/></pattern></defs>'
)
#: Values that differ by such a factor are drawn on a logarithmic scale.
WIDE = 50.0

Axes = Sequence[tuple[str, Fraction, Fraction]]
Pairs = Sequence[tuple[Box, Middle]]


class Colouring:
    """A name, a title, what is drawn, and what white is."""

    def __init__(
        self, name: str, title: str, value: Callable[[Middle], float | None], white: str
    ) -> None:
        self.name, self.title, self.value, self.white = name, title, value, white


def _central(middle: Middle) -> float | None:
    return None if middle.central is None else float(middle.central)


def _number(middle: Middle) -> float | None:
    return float(middle.collisions) if middle.verdict == "disperses" else None


def _time(middle: Middle) -> float | None:
    found = middle_time(middle)
    return None if found is None else float(found)


COLOURINGS = (
    Colouring("central", "central ball of the collapse", _central, "no collapse"),
    Colouring("collisions", "number of collisions", _number, "infinitely many"),
    Colouring("time", "time of the collapse", _time, "no collapse"),
)


def coloured(colouring: Colouring, axes: Axes, pairs: Pairs, unit: str) -> str:
    """The picture."""
    width, height = LEFT + SIDE + 230, TOP + SIDE + 74
    font = f'font-family="sans-serif" font-size="12" fill="{INK}" style="background:#fff"'
    values = [colouring.value(middle) for _, middle in pairs]
    scale = Ramp([value for value in values if value is not None])
    title = f"{colouring.title}, at the middle of each box"
    is_balls, is_count = colouring.name == "central", colouring.name == "collisions"
    view = f'viewBox="0 0 {width} {height}"'
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" {view} role="img" {font}>',
        f"<title>{escape(title)}</title>",
        OPEN,
        _text(LEFT, 18, title, "start"),
    ]
    parts.append('<g shape-rendering="crispEdges">')
    for (box, middle), value in zip(pairs, values, strict=True):
        fill = "#fff" if value is None else scale.colour(value)
        if is_balls and value is not None:
            fill = BALLS[int(value)]
        if is_count and middle.verdict == "finite":
            fill = GREY
        if middle.verdict == "undecided":
            fill = "url(#open)"
        parts.append(_box(axes, box, fill))
    parts.append("</g>")
    parts += _axes(axes)
    named = unit if colouring.name == "time" else ""
    parts += _balls() if is_balls else _bar(scale, named, is_count=is_count)
    parts += _keys(colouring.white, 70 if is_balls else SIDE - 150)
    if is_count:
        parts += _key(SIDE - 106, GREY, "finitely many, not counted")
    return "\n".join([*parts, "</svg>", ""])


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

    def at(self, share: float) -> float:
        """The value there."""
        if self.is_logarithmic:
            return self.low * math.exp(share * math.log(self.high / self.low))
        return self.low + (self.high - self.low) * share

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
    for number, (name, first, last) in enumerate(axes):
        for share, text in shares_of(first, last):
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


def _bar(scale: Ramp, unit: str, *, is_count: bool) -> Iterator[str]:
    """The colour bar, with five values; or with as many whole numbers, if so many are in it."""
    left, steps, height = LEFT + SIDE + 30, 64, SIDE - 180
    size = height / steps
    yield '<g shape-rendering="crispEdges">'
    for k in range(steps):
        place = f'x="{left}" y="{TOP + height - (k + 1) * size:.6g}" width="{BAR}"'
        yield f'<rect {place} height="{size + 0.3:.6g}" fill="{between((k + 0.5) / steps)}"/>'
    yield "</g>"
    values = [scale.at(quarter / 4) for quarter in range(5)]
    if is_count:
        values = sorted({float(round(value)) for value in values})
    for value in values:
        y = TOP + height * (1 - scale.share(value))
        yield _text(left + BAR + 6, y + 4, f"{value:.4g} {unit}".rstrip(), "start")


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
