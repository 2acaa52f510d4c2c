"""What a figure is made of: panels with scales, boxes, curves, words."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from fractions import Fraction
from math import ceil, floor, log10

from verify.language.record import Record
from verify.prover.decimals import decimal_exponent, exact_number

Corners = tuple[float, float, float, float]
Point = tuple[float, float]


class Scale(Record):
    """An axis: what it shows, from where to where, and its marks."""

    label: str
    low: float
    high: float
    ticks: Sequence[tuple[float, str]]
    logarithmic: bool = False

    def share(self, value: float) -> float:
        """Where a value lies between the two ends."""
        if not self.logarithmic:
            return (value - self.low) / (self.high - self.low)
        low, high = log10(self.low), log10(self.high)
        return (log10(max(value, self.low / 1e6)) - low) / (high - low)


class Areas(Record):
    """Areas ``(left, right, bottom, top)`` in one colour.

    ``key`` is the anchor that a table refers to, ``name`` the entry in the legend.
    """

    corners: Sequence[Corners]
    colour: str
    edge: float = 0.0
    name: str = ""
    key: str = ""


class Tiles(Record):
    """Areas with any corners, each with a thin rim, in colours that do not follow the page."""

    corners: Sequence[Sequence[Point]]
    colour: str
    rim: str


class Dots(Record):
    """A picture that fills the panel."""

    png: bytes


class Curve(Record):
    """Measured points with a line through them; marks differ in shape, or there are none.

    ``dashes`` are the lengths of strokes and gaps of the line; it is whole without any.
    """

    points: Sequence[Point]
    colour: str
    mark: int | None = 0
    name: str = ""
    dashes: str = ""


class Words(Record):
    """Words at a point; ``anchor`` is start, middle or end."""

    at: Point
    text: str
    anchor: str = "start"


class Disc(Record):
    """A circle in a panel with equal scales, empty or faintly filled."""

    at: Point
    radius: float
    colour: str
    dashes: str = ""
    filled: bool = False


class Rule(Record):
    """A line across the panel."""

    at: float


class Frame(Record):
    """The rim of an area ``(left, right, bottom, top)``."""

    corners: Corners


class Straight(Record):
    """A dashed line between two points, to compare with."""

    start: Point
    end: Point
    colour: str


class Trace(Record):
    """A line through points, without marks."""

    points: Sequence[Point]
    colour: str
    name: str = ""


Shape = Areas | Tiles | Dots | Curve | Words | Disc | Rule | Frame | Straight | Trace


class Panel(Record):
    """One pair of axes; its shapes are made when it is drawn. ``told`` says what is seen.

    Without ``axes`` the two scales only say what is within.
    """

    title: str
    x: Scale
    y: Scale
    shapes: Callable[[], Iterable[Shape]]
    told: str = ""
    width: int = 420
    height: int = 350
    axes: bool = True


class Figure(Record):
    """Panels with one caption.

    ``caption`` has every number that the reader is told, ``rows`` a small table below it (its
    first row is the head). Both come from the enclosures alone: they are the same whatever draws.
    """

    name: str
    title: str
    caption: str
    panels: Sequence[Panel]
    rows: Sequence[Sequence[str]] = ()
    #: For each row below the head the anchor of its curve.
    anchors: Sequence[str] = ()
    #: Whether something in it moves.
    moves: bool = False


def powers(low: int, high: int, step: int = 1) -> list[tuple[float, str]]:
    """Marks at powers of ten."""
    return [(10.0**n, ten(n)) for n in range(low, high + 1, step)]


def ten(exponent: int) -> str:
    """A power of ten as people write it."""
    digits = str(exponent).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))
    return f"10{digits}"


def marks(*texts: str) -> list[tuple[float, str]]:
    """Marks at these numbers."""
    return [(float(Fraction(text)), text.replace("-", "−")) for text in texts]


#: How far round marks are apart, in powers of ten.
STEPS = (Fraction(2), Fraction(1), Fraction(1, 2), Fraction(1, 5), Fraction(1, 10))
#: Marks are decimals, however many digits they have; on axes only if they have so few letters.
MANY, LONG = 60, 7


def round_marks(low: Fraction, high: Fraction, steps: int = 3) -> list[tuple[float, str]]:
    """Marks at multiples of 1, 2 or 5 times a power of ten, so that there are so many steps."""
    return [(float(at), exact_number(at, MANY)) for at in _multiples(low, high, steps)]


def _multiples(low: Fraction, high: Fraction, steps: int) -> list[Fraction]:
    step = round_step(low, high, steps)
    return [k * step for k in range(ceil(low / step), floor(high / step) + 1)]


def round_step(low: Fraction, high: Fraction, steps: int) -> Fraction:
    """1, 2 or 5 times a power of ten, so that there are so many steps of it, or more."""
    unit = Fraction(10) ** decimal_exponent(high - low)
    return next(unit * part for part in STEPS if unit * part * steps <= high - low)


def axis_of(
    name: str, low: Fraction, high: Fraction, steps: int = 4
) -> tuple[str, list[tuple[float, str]]]:
    """What an axis is called, and round marks, so many steps or more: their shares of the way.

    Where marks are long, they say by how much, in a power of ten, they differ from one number.
    """
    marks = _multiples(low, high, steps)
    base, unit = Fraction(0), 0
    if max(len(exact_number(at, MANY)) for at in marks) > LONG:
        most = max(map(abs, marks))
        if most > 1000 * (marks[1] - marks[0]):
            base = marks[0]
            most = marks[-1] - base
        unit = decimal_exponent(most)
        added = f"{exact_number(base, MANY)} + " if base else ""
        name = f"{name} = {added}mark × {ten(unit)}"
    texts = [exact_number((at - base) / Fraction(10) ** unit, MANY) for at in marks]
    return name, [
        (float((at - low) / (high - low)), text) for at, text in zip(marks, texts, strict=True)
    ]


def logarithmic_marks(low: float, high: float) -> list[tuple[float, str]]:
    """Marks at 1, 2 and 5 times powers of ten; or at some of the powers, if they are many."""
    marks = logarithmic_steps(Fraction(low), Fraction(high))
    return [(float(at), exact_number(at, MANY)) for at in marks if low <= at <= high]


def logarithmic_steps(low: Fraction, high: Fraction) -> list[Fraction]:
    """Such numbers, from one that is at most ``low`` to one that is at least ``high``."""
    first, last = decimal_exponent(low), -decimal_exponent(1 / high)
    factors, step = ((1, 2, 5), 1) if last - first <= 3 else ((1,), -(-(last - first) // 8))
    return [k * Fraction(10) ** power for power in range(first, last + step, step) for k in factors]


def round_below(most: float) -> float:
    """The largest length that is 1, 2 or 5 times a power of ten and at most this."""
    unit = 10.0 ** floor(log10(most))
    return float(f"{next(k for k in (5, 2, 1) if k == 1 or k * unit <= most) * unit:.1g}")


def corners(boxes: Iterable[tuple[tuple[Fraction, Fraction], ...]]) -> list[Corners]:
    """Boxes that are given by their two sides."""
    return [(float(a), float(b), float(c), float(d)) for (a, b), (c, d) in boxes]


def merged(cells: Iterable[tuple[Fraction, Fraction, Fraction, Fraction]]) -> list[Corners]:
    """The same area in fewer boxes: neighbours of one height are joined, then of one width."""
    rows = _joined((low, high, left, right) for left, right, low, high in cells)
    columns = _joined((left, right, low, high) for low, high, left, right in rows)
    return [(float(a), float(b), float(c), float(d)) for a, b, c, d in columns]


def _joined(
    cells: Iterable[tuple[Fraction, Fraction, Fraction, Fraction]],
) -> list[tuple[Fraction, Fraction, Fraction, Fraction]]:
    result: list[tuple[Fraction, Fraction, Fraction, Fraction]] = []
    for a, b, c, d in sorted(cells):
        if result and result[-1][:2] == (a, b) and result[-1][3] == c:
            result[-1] = (a, b, result[-1][2], d)
        else:
            result.append((a, b, c, d))
    return result
