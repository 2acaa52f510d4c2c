"""The picture of the letters: three spheres, their directions, velocities, the gap, the angle."""

from __future__ import annotations

from collections.abc import Iterator
from math import cos, pi, sin

#: A unit of length, the diameter of a sphere, in units of the drawing.
UNIT = 130.0
WIDTH, HEIGHT = 560, 290
GAP = 0.5

Point = tuple[float, float]

TOLD = (
    "Three equal spheres. 0 is in the middle. s touches it at the upper left and moves away. c is "
    "at the right, with a gap d, and comes nearer. Arrows from the centre of 0 show the unit "
    "vectors ω_s and ω_c with the angle θ between them; arrows from the centres of s and c show "
    "the velocities W_s and W_c relative to 0, and their parts η_s, η_c along the lines of centres."
)


def letters_drawing() -> str:
    """The picture as one SVG element in the colours of the page."""
    body = "\n".join(_parts())
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" role="img" '
        f'aria-label="{TOLD}" class="letters">\n{_MARKERS}\n{body}\n</svg>'
    )


def _parts() -> Iterator[str]:
    zero = (255.0, 170.0)
    s, c = _from(zero, 140, UNIT), _from(zero, -10, UNIT * (1 + GAP))
    for centre, kind in ((zero, "ink"), (s, "series-1"), (c, "series-2")):
        yield _sphere(centre, kind)
    yield _line(zero, c, "faint", dashed=True)
    yield _arc(zero, -10, 140, 40)
    yield _text(_from(zero, 65, 56), "θ")
    yield _arrow(zero, s, "ink")
    yield _arrow(zero, _from(zero, -10, UNIT), "ink")
    yield _text(_beside(_from(zero, 140, 0.66 * UNIT), 140, 17), "ω", "s")
    yield _text(_beside(_from(zero, -10, 0.74 * UNIT), -10, -20), "ω", "c")
    yield from _gap(zero)
    yield from _velocity(s, 140, 46, 60, "series-1", "s")
    yield from _velocity(c, 170, 56, -54, "series-2", "c")
    yield _text((zero[0] - 6, zero[1] + 26), "0")
    yield _text((s[0] + 4, s[1] + 46), "s")
    yield _text((c[0] + 38, c[1] + 24), "c")


def _gap(zero: Point) -> Iterator[str]:
    """The gap between the surfaces of 0 and c, drawn below the line of centres."""
    inner, outer = (_from(zero, -10, UNIT * part) for part in (0.5, 0.5 + GAP))
    low, high = _beside(inner, -10, 34), _beside(outer, -10, 34)
    yield _line(inner, low, "faint")
    yield _line(outer, high, "faint")
    yield _line(low, high, "ink")
    yield _text(_beside(_from(zero, -10, UNIT * (0.5 + GAP / 2)), -10, 52), "d")


def _velocity(
    at: Point, along: float, part: float, across: float, colour: str, name: str
) -> Iterator[str]:
    """A velocity, and its part along the line of centres."""
    foot = _from(at, along, part)
    tip = _from(foot, along + 90, across)
    yield _line(tip, foot, colour, dashed=True)
    yield _arrow(at, foot, colour, thick=True)
    yield _arrow(at, tip, colour)
    outside = 1 if across > 0 else -1
    yield _text(_from(tip, along + 90, 14 * outside), "W", name)
    yield _text(_from(_from(at, along, part / 2), along - 90, 18 * outside), "η", name)


# --- shapes --------------------------------------------------------------------------------------


def _from(at: Point, degrees: float, length: float) -> Point:
    """A point in a direction, counterclockwise from the right."""
    angle = degrees * pi / 180
    return at[0] + length * cos(angle), at[1] - length * sin(angle)


def _beside(at: Point, degrees: float, length: float) -> Point:
    """A point to the right of a direction."""
    return _from(at, degrees - 90, length)


def _sphere(at: Point, colour: str) -> str:
    return (
        f'<circle cx="{at[0]:.1f}" cy="{at[1]:.1f}" r="{UNIT / 2:g}" stroke="var(--{colour})" '
        f'fill="var(--{colour})" fill-opacity="0.1" stroke-width="1.5"/>'
    )


def _line(a: Point, b: Point, colour: str, *, dashed: bool = False) -> str:
    dashes = ' stroke-dasharray="5 4"' if dashed else ""
    return f'<path d="{_path(a, b)}" stroke="var(--{colour})" stroke-width="1.3"{dashes}/>'


def _arrow(a: Point, b: Point, colour: str, *, thick: bool = False) -> str:
    width = 3.4 if thick else 1.8
    return (
        f'<path d="{_path(a, b)}" stroke="var(--{colour})" stroke-width="{width}" '
        f'marker-end="url(#tip-{colour})"/>'
    )


def _path(a: Point, b: Point) -> str:
    return f"M{a[0]:.1f} {a[1]:.1f}L{b[0]:.1f} {b[1]:.1f}"


def _arc(at: Point, low: float, high: float, radius: float) -> str:
    a, b = _from(at, low, radius), _from(at, high, radius)
    return (
        f'<path d="M{a[0]:.1f} {a[1]:.1f}A{radius} {radius} 0 0 0 {b[0]:.1f} {b[1]:.1f}" '
        'fill="none" stroke="var(--ink)" stroke-width="1.3"/>'
    )


def _text(at: Point, letter: str, index: str = "") -> str:
    lower = f'<tspan dy="4" font-size="14">{index}</tspan>' if index else ""
    return (
        f'<text x="{at[0]:.1f}" y="{at[1] + 6:.1f}" text-anchor="middle" font-size="19" '
        f'font-style="italic" fill="var(--ink)">{letter}{lower}</text>'
    )


_MARKERS = (
    "<defs>"
    + "".join(
        f'<marker id="tip-{colour}" viewBox="0 0 8 8" refX="7" refY="4" markerWidth="9" '
        'markerHeight="9" markerUnits="userSpaceOnUse" orient="auto">'
        f'<path d="M0 0L8 4L0 8z" fill="var(--{colour})"/></marker>'
        for colour in ("ink", "series-1", "series-2")
    )
    + "</defs>"
)
