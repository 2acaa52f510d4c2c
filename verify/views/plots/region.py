"""Over the region: where the printed steps fail, and where the repaired construction closes.

Both panels are drawn from statements for all parameters. In the region the larger fixed point is
phi_plus < q just where r < q^3 and c < 2 (q^2 + r)/(q (1 + r)), which grows with r, as the
stability threshold does.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from fractions import Fraction
from itertools import pairwise

from verify.language.statement import PRINTED, PROVED, REFUTED
from verify.paper.commands.covers import WIDTH, threshold_boxes
from verify.paper.commands.everywhere import decide_printed_everywhere
from verify.paper.commands.thresholds import certified, decide_thresholds
from verify.paper.everywhere.thresholds import STRIPS
from verify.prover.cover import Box
from verify.prover.outcome import Outcome
from verify.views.everywhere import dependences
from verify.views.plots.figure import Figure
from verify.views.plots.shapes import Areas, Corners, Panel, Scale, Shape, Words, marks

#: Values of r at which the axis of s = r^(1/3) is marked.
TICKS = ("0.0005", "0.005", "0.02", "0.05")

#: How many intervals of s are drawn.
COLUMNS = 300


def picture(everywhere: Outcome) -> Figure:
    """The map of the README: the printed proof beside the repaired one, for all parameters."""
    printed, where = decide_printed_everywhere(), decide_thresholds()
    refuted = [(row, found) for row, found in printed.rows if found.verdict == REFUTED]
    always = [row for row, found in refuted if row.role == PRINTED and not found.witness]
    needed = everywhere.rows
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
    return Figure(
        "region",
        "Where the printed proof fails, and where the repaired one closes",
        caption,
        (
            Panel("As printed: steps refuted", S, C, lambda: _printed(len(always)), TOLD_PRINTED),
            Panel("Repaired: closes", S, C, _closing, TOLD_REPAIRED),
        ),
        [("Step", "Where it holds, and where it does not"), *dependences(printed, where)],
    )


# --- cells ---------------------------------------------------------------------------------------


def refuted_at(low: Fraction, high: Fraction) -> int | None:
    """How many rows are refuted for phi_plus in an open interval; None if one is not decided."""
    rows = dict.fromkeys(strip.row for strip in STRIPS)
    strips = certified(decide_thresholds())
    there = {s.row: s.verdict for s in strips if s.low <= low and high <= s.high}
    return None if there.keys() != rows.keys() else list(there.values()).count(REFUTED)


def bands() -> Iterator[tuple[Fraction, Fraction, int | None]]:
    """The values of phi_plus between neighbouring ends of strips, with what is refuted there."""
    ends = sorted({end for strip in STRIPS for end in (strip.low, strip.high)})
    for low, high in pairwise(ends):
        yield low, high, refuted_at(low, high)


def cells(low: Fraction, high: Fraction) -> Iterator[Box]:
    """Areas of s and c inside of the region in which phi_plus lies in an interval."""
    for k in range(COLUMNS):
        left, right = WIDTH * k / COLUMNS, WIDTH * (k + 1) / COLUMNS
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


S = Scale(
    "r (on the scale of its cube root)",
    0,
    float(WIDTH),
    [(float(Fraction(t)) ** (1 / 3), t) for t in TICKS],
)
C = Scale("−cos θ₀", 0, 1, marks("0", "0.2", "0.4", "0.6", "0.8", "1"))

TOLD_PRINTED = (
    "The plane of r and −cos θ₀. The whole region above the curve of stability is hatched orange: "
    "steps are refuted everywhere, their numbers stand in its bands."
)
TOLD_REPAIRED = "The same plane: the whole region above the curve of stability is blue: it closes."


def _printed(always: int) -> Iterator[Shape]:
    named = False
    for low, high, refuted in bands():
        colour = "undecided" if refuted is None else "refuted-area"
        name = "" if named or refuted is None else "steps refuted"
        yield Areas(_corners(cells(low, high)), colour, name=name)
        named = named or bool(name)
        middle = float(min(Fraction(1), level(high, Fraction(0))) + level(low, Fraction(0))) / 2
        if refuted is not None:
            yield Words((0.006, middle), f"{always + refuted}")
    yield from curves()
    yield WHICH


def _closing() -> Iterator[Shape]:
    yield Areas(_corners(cells(Fraction(0), Fraction(1, 2))), "proved-area", name="all proved")
    yield from curves()
    yield WHICH


WHICH = Words((0.2, 0.24), "upper curve: stability\nlower curve: existence")


def _corners(found: Iterable[Box]) -> list[Corners]:
    return [
        (float(left), float(right), float(low), float(high)) for (left, right), (low, high) in found
    ]


def curves() -> Iterator[Areas]:
    """Both thresholds."""
    for curve in threshold_boxes(400).values():
        part = [
            (float(left), float(right), float(low), float(high))
            for (left, right), (low, high) in curve
            if low <= 1 and left <= WIDTH
        ]
        yield Areas(part, "ink", 0.8)
