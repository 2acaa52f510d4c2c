"""The separatrix in the plane of the paper's φ₁ and φ₂: with its certified strip, or for several r.

Between two values of q that were decided, all states below the value at the right one collapse, and
all above the value at the left one end: corners of rectangles, as f decreases.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from itertools import pairwise
from typing import Any

from verify.prover.decimals import exact_number, short
from verify.views.plots.drawing import LEGEND, standalone, svg
from verify.views.plots.shapes import (
    Areas,
    Curve,
    Figure,
    Panel,
    Point,
    Scale,
    Shape,
    Words,
    round_marks,
)
from verify.views.separatrix import line_of

#: What the spheres know of a separatrix, and of its curve at a place.
Separatrix = Any
CurveAt = Any

COLLAPSES, ENDS, BETWEEN = "refuted-area", "proved-area", "ink"
WIDTH, HEIGHT = 440, 360
#: The vertical axis; this stands above it, since there is no room beside its marks.
UP = "φ₂ |W_c|²"
#: The strokes of neighbouring curves, which are told apart without colours, too.
DASHES = ("", "6 2", "1.5 2", "6 2 1.5 2")
#: No number in a legend has more letters.
MOST_LETTERS = 12
#: How far from a mark on the axis its name stands, and the room that it needs to the left of φ⁻.
BESIDE, ROOM = 0.02, 0.1


def phi_2(u: Fraction) -> float:
    """φ₂|W_c|² = u(2-u)/2."""
    return float(u * (2 - u) / 2)


def strip_panel(found: Separatrix, strips: Sequence[CurveAt]) -> Panel:
    """The certified areas below and above the curve, the strip between them, and its points."""
    high = max(phi_2(strip.high) for strip in strips)
    right = max(strip.q for strip in strips)
    where = line_of(found.parameters)
    told = f"Below the curve at {where} the collisions go on for ever, above it they end."
    x, y = _scale("φ₁", right), _scale("", Fraction(high) * Fraction(6, 5))
    return Panel(UP, x, y, lambda: _strip(found, strips, y.high), told, WIDTH, HEIGHT)


def strip_svg(found: Separatrix, strips: Sequence[CurveAt]) -> str:
    """The same as a file."""
    panel = strip_panel(found, strips)
    return standalone(svg("separatrix", [panel], panel.told, [line_of(found.parameters)]))


def figure(found: Separatrix, strips: Sequence[CurveAt]) -> Figure:
    """The same with a caption."""
    (minus, plus), (q, (low, high)) = found.fixed, found.cycle[:2]
    ends = low * (2 - low) / 2, high * (2 - high) / 2
    saddle = f"φ₁ = {short(q, 8)} and φ₂|W_c|² = {short(ends, 8)}"
    caption = (
        f"{line_of(found.parameters)}. In every state of the hatched area the collisions "
        "never end, in every state above it they end (both are proved); the curve lies in the thin "
        f"steps between them. On the axis are φ⁻ = {short(minus, 8)}, where orbits below the curve "
        f"go, and φ⁺ = {short(plus, 8)}, where the curve ends. Orbits on it go to the saddle, "
        f"{saddle}."
    )
    return Figure("curve", "Where collisions never end", caption, (strip_panel(found, strips),))


def _strip(found: Separatrix, strips: Sequence[CurveAt], top: float) -> Iterator[Shape]:
    cells = [(float(a.q), float(b.q), phi_2(b.low), phi_2(a.high)) for a, b in pairwise(strips)]
    below = [(left, right, 0.0, low) for left, right, low, _ in cells if low > 0]
    above = [(left, right, high, top) for left, right, _, high in cells]
    yield Areas(above, ENDS, 0.0, "collisions end (proved)")
    yield Areas(below, COLLAPSES, 0.0, "they never end (proved)")
    strip = [(left, right, low, high) for left, right, low, high in cells]
    yield Areas(strip, BETWEEN, 0.0, "the separatrix lies here")
    right = max(cell[1] for cell in cells)
    for (low, high), name in zip(found.fixed, ("φ⁻", "φ⁺"), strict=False):
        at = float((low + high) / 2)
        is_left = name == "φ⁻" and at > ROOM * right
        yield Curve([(at, 0.0)], "ink", 0)
        x = at + (-BESIDE if is_left else BESIDE) * right
        yield Words((x, 0.055 * top), name, "end" if is_left else "start")
    yield from _cycle(found, top)


def _cycle(found: Separatrix, top: float) -> Iterator[Shape]:
    """The saddle, and with a ratio other than 1 its image, which is on the curve of 1/ratio."""
    if found.cycle:
        (low, high), u = found.cycle[:2]
        at = float((low + high) / 2), phi_2(sum(u) / 2)
        name = "saddle" if found.is_steady else "saddle of period two"
        yield Curve([at], "ink", 1)
        yield Words((at[0] + 0.02, at[1] + 0.04 * top), name)


def curves_svg(curves: Sequence[tuple[Separatrix, Sequence[CurveAt]]]) -> str:
    """How the curve moves with r; where there is none, nothing is drawn."""
    drawn = [(found, strips) for found, strips in curves if strips]
    where = line_of(curves[0][0].parameters, of_one=False)
    first, last = (exact_number(found.parameters.r) for found, _ in (curves[0], curves[-1]))
    title = f"r from {first} (top) to {last}, {where}"
    none = ", ".join(exact_number(found.parameters.r) for found, strips in curves if not strips)
    heading = [title, *([f"no curve at r = {none}"] if none else [])]
    right = max((strip.q for _, strips in drawn for strip in strips), default=Fraction(1))
    high = max((phi_2(s.high) for _, strips in drawn for s in strips), default=1.0)
    told = "the separatrix for several r, the least r on top"
    x, y = _scale("φ₁", right), _scale("", Fraction(high) * Fraction(11, 10))
    height = HEIGHT + LEGEND * -(-len(drawn) // 2)
    panel = Panel(UP, x, y, lambda: _curves(drawn), told, WIDTH, height)
    return standalone(svg("separatrices", [panel], f"{title}: {told}", heading))


def _curves(drawn: Iterable[tuple[Separatrix, Sequence[CurveAt]]]) -> Iterator[Shape]:
    for number, (found, strips) in enumerate(drawn):
        points = [_middle(strip) for strip in strips]
        name, dashes = f"r = {_told(found.parameters.r)}", DASHES[number % len(DASHES)]
        yield Curve(points, f"series-{1 + number % 7}", None, name, dashes)


def _told(value: Fraction) -> str:
    """A number as it is; shortened, with a sign …, if it is long."""
    exact = exact_number(value)
    return exact if len(exact) <= MOST_LETTERS else short((value, value), 8)


def _middle(strip: CurveAt) -> Point:
    return float(strip.q), phi_2((strip.low + strip.high) / 2)


def _scale(label: str, end: Fraction) -> Scale:
    """An axis from 0 with some five round marks."""
    return Scale(label, 0.0, float(end), round_marks(Fraction(0), end, 5))
