"""Over the region: where the printed steps fail, and where the repaired construction closes.

Both panels are drawn from statements for all parameters. In the region the larger fixed point is
phi_plus < q just where r < q^3 and c < 2 (q^2 + r)/(q (1 + r)), which grows with r, as the
stability threshold does.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from verify.language.statement import PRINTED, PROVED, REFUTED
from verify.views.all_parameters import dependences
from verify.views.findings import Cell, Region
from verify.views.plots import shapes
from verify.views.words import fair

#: Values of r at which the axis of s = r^(1/3) is marked.
TICKS = ("0.0005", "0.005", "0.02", "0.05")

#: How many intervals of s are drawn.
COLUMNS = 300


def picture(region: Region) -> shapes.Figure:
    """The map of the README: the printed proof beside the repaired one, for all parameters."""
    rows = region.printed.rows
    refuted = [(row, found) for row, found in rows if fair(region.printed, row, found) == REFUTED]
    always = [row for row, found in refuted if row.role == PRINTED and not found.witness]
    needed, across = region.everywhere.rows, scale(region)
    proved = [row for row, found in needed if found.verdict == PROVED]
    caption = (
        f"Left: {len(always)} printed rows are refuted at all parameters of the region, so that "
        f"the printed proof fails at each of them; {len(refuted) - len(always)} more fail at some, "
        f"as the table says. The numbers count those that are refuted at all points of their part "
        f"of the region; the boundaries are φ⁺ = 1/22 and φ⁺ = 5/33. "
        f"Right: {len(proved)} of {len(needed)} needed rows (the repaired set, the hypotheses, "
        f"which entries are least, the step) are proved at all parameters. Thresholds are drawn as "
        f"boxes that contain the curves: the lower curve is that of existence 4√r/(1+r), the upper "
        f"one that of stability 2r^(1/3)(1+r^(1/3))/(1+r), "
        f"which the proof needs. V₀ = 1, δ_θ = 1/10."
    )
    return shapes.Figure(
        "region",
        "Where the printed proof fails, and where the repaired one closes",
        caption,
        (
            shapes.Panel(
                "As printed: steps refuted",
                across,
                C,
                lambda: _printed(region, len(always)),
                TOLD_PRINTED,
            ),
            shapes.Panel("Repaired: closes", across, C, lambda: _closing(region), TOLD_REPAIRED),
        ),
        [
            ("Step", "Where it holds, and where it does not"),
            *dependences(region.printed, region.thresholds, region.shares),
        ],
    )


# --- cells ---------------------------------------------------------------------------------------


def cells(width: Fraction, low: Fraction, high: Fraction) -> Iterator[Cell]:
    """Areas of s and c inside of the region in which phi_plus lies in an interval."""
    for k in range(COLUMNS):
        left, right = width * k / COLUMNS, width * (k + 1) / COLUMNS
        bottom = max(stability(right), level(low, right) if left < low else Fraction(0))
        top = min(Fraction(1), level(high, left))
        if right <= high and bottom < top:
            yield (left, right), (bottom, top)


def stability(s: Fraction) -> Fraction:
    """The threshold of c, which grows with s."""
    return 2 * s * (1 + s) / (1 + s**3)


def level(q: Fraction, s: Fraction) -> Fraction:
    """The c at which phi_plus is q, which grows with s as long as s is at most q."""
    return 2 * (q**2 + s**3) / (q * (1 + s**3)) if q else Fraction(0)


# --- drawing -------------------------------------------------------------------------------------


def scale(region: Region) -> shapes.Scale:
    """The axis of s."""
    ticks = [(float(Fraction(t)) ** (1 / 3), t) for t in TICKS]
    return shapes.Scale("r (on the scale of its cube root)", 0, float(region.width), ticks)


C = shapes.Scale("−cos θ₀", 0, 1, shapes.marks("0", "0.2", "0.4", "0.6", "0.8", "1"))

TOLD_PRINTED = (
    "The plane of r and −cos θ₀. The whole region above the curve of stability is hatched orange: "
    "steps are refuted everywhere, their numbers stand in its bands."
)
TOLD_REPAIRED = "The same plane: the whole region above the curve of stability is blue: it closes."


def _printed(region: Region, always: int) -> Iterator[shapes.Shape]:
    named = False
    for low, high, refuted in region.bands:
        colour = "undecided" if refuted is None else "refuted-area"
        name = "" if named or refuted is None else "steps refuted"
        yield shapes.Areas(shapes.corners(cells(region.width, low, high)), colour, name=name)
        named = named or bool(name)
        middle = float(min(Fraction(1), level(high, Fraction(0))) + level(low, Fraction(0))) / 2
        if refuted is not None:
            yield shapes.Words((0.006, middle), f"{always + refuted}")
    yield from curves(region)
    yield WHICH


def _closing(region: Region) -> Iterator[shapes.Shape]:
    inside = cells(region.width, Fraction(0), Fraction(1, 2))
    yield shapes.Areas(shapes.corners(inside), "proved-area", name="all proved")
    yield from curves(region)
    yield WHICH


WHICH = shapes.Words((0.2, 0.24), "upper curve: stability\nlower curve: existence")


def curves(region: Region) -> Iterator[shapes.Areas]:
    """Both thresholds."""
    for curve in region.curves:
        part = (box for box in curve if box[1][0] <= 1 and box[0][0] <= region.width)
        yield shapes.Areas(shapes.corners(part), "ink", 0.8)
