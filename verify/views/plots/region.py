"""Over the region: where the printed steps fail, and where the repaired construction closes."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from fractions import Fraction
from math import log10
from typing import Any

from verify.jobs.constructions import sorted_rows
from verify.jobs.covers import (
    SHARE,
    WHOLE,
    WIDTH,
    closes,
    mapped,
    maps,
    refuted_steps,
    share_of,
    threshold_boxes,
)
from verify.language.statement import PROVED, REFUTED, UNDECIDED
from verify.paper.groups import PRINTED, REPAIRED
from verify.prover.cover import JudgedBox
from verify.prover.decimals import decimal_exponent
from verify.views.plots.drawing import Panel, boxes, merged
from verify.views.plots.figure import Figure

#: Values of r at which the axis of s = r^(1/3) is marked.
TICKS = ("0.0001", "0.001", "0.005", "0.01", "0.02", "0.03", "0.05")

#: The steps that have a map of their own, as a short title.
TITLES = {
    "zeta-x-bound": "|xₙ| ≤ (V₀/V₁) δ₂² h₅/12",
    "zeta-total": "ζₙ₊₁ ≤ (1 − h₅/4) ζₙ",
    "angle-absorbed": "the angle stays within |Δθ|",
    "x-term-1-d": "dₙ/δ₂ ≤ h₄δₓ/2",
}


def picture(depth: int) -> Figure:
    """The map of the README: the printed proof beside the repaired one."""
    printed, repaired = maps(depth)
    failing = [judged for judged in printed if refuted_steps(judged)]
    closing = [judged for judged in repaired if closes(judged)]
    least = min(refuted_steps(judged) for judged in failing)
    most = max(refuted_steps(judged) for judged in failing)
    open_rows, algebraic = sorted_rows(REPAIRED, SHARE)
    share = Fraction(_area(closing), _area(repaired))
    caption = (
        f"Each box is a cell of parameters judged as a whole, by enclosures over all its points. "
        f"Left: {len(failing)} of {len(printed)} cells have printed steps refuted at every point "
        f"({least} to {most} of them). Right: on {len(closing)} of {len(repaired)} cells "
        f"({_percent(share)} of the area) all {len(open_rows)} inequalities of the repaired "
        f"construction that are not identities are proved at every point, with each constant at "
        f"half of its bound; the other {len(algebraic)} hold by algebra. The colour is the size "
        f"of the set, a lower bound of η̄ from {_least_size(closing)} (faint) to "
        f"{_greatest_size(closing)} (full). Grey: undecided at this size of cells. The lower curve "
        f"is the threshold of existence 4√r/(1+r), the upper one that of stability "
        f"2r^(1/3)(1+r^(1/3))/(1+r), which the proof needs: both are drawn as enclosures. V₀ = 1, "
        f"δ_θ = 1/10."
    )
    return Figure(
        "region",
        "Where the printed proof fails, and where the repaired one closes",
        caption,
        (
            Panel("As printed: steps refuted", lambda axis: _draw_printed(axis, printed)),
            Panel("Repaired: closes", lambda axis: _draw_closing(axis, repaired)),
        ),
    )


def _percent(share: Fraction) -> str:
    return f"{int(100 * share)} %"


def _area(cells: Iterable[JudgedBox]) -> int:
    return sum(judged.weight for judged in cells)


def _least_size(cells: Iterable[JudgedBox]) -> str:
    return _power(min(_size(judged) for judged in cells))


def _greatest_size(cells: Iterable[JudgedBox]) -> str:
    return _power(max(_size(judged) for judged in cells))


def _size(judged: JudgedBox) -> Fraction:
    """A lower bound of eta_bar on a cell on which the set closes."""
    if judged.size is None or judged.size[0] <= 0:
        raise ValueError("eta_bar is positive where the construction closes")
    return judged.size[0]


def _power(value: Fraction) -> str:
    return f"1e{decimal_exponent(value)}"


def _level(judged: JudgedBox) -> int:
    """A shade for each quarter of a decade."""
    return int(4 * log10(_size(judged)) // 1)


def _corners(judged: JudgedBox) -> tuple[Fraction, Fraction, Fraction, Fraction]:
    (left, right), (low, high) = judged.box
    return left, right, low, high


def _draw_printed(axis: Any, cells: list[JudgedBox]) -> None:
    boxes(axis, merged(_corners(j) for j in cells if not refuted_steps(j)), "undecided")
    counts = sorted({refuted_steps(judged) for judged in cells} - {0})
    low, high = counts[0], counts[-1]
    for step in range(4):
        part = [j for j in cells if refuted_steps(j) and
                min(3, 4 * (refuted_steps(j) - low) // max(1, high - low + 1)) == step]  # fmt: skip
        boxes(axis, merged(map(_corners, part)), "refuted-area", (0.4, 0.6, 0.8, 1)[step])
    frame(axis)


def _draw_closing(axis: Any, cells: list[JudgedBox]) -> None:
    boxes(axis, merged(_corners(j) for j in cells if not closes(j)), "undecided")
    closing = [judged for judged in cells if closes(judged)]
    levels = sorted({_level(judged) for judged in closing})
    for index, level in enumerate(levels):
        part = [judged for judged in closing if _level(judged) == level]
        opacity = 1 - 0.8 * (len(levels) - 1 - index) / len(levels)
        boxes(axis, merged(map(_corners, part)), "proved-area", opacity)
    frame(axis)


def frame(axis: Any, labels: bool = True) -> None:
    """The axes of the plane with both thresholds."""
    for curve in threshold_boxes(400).values():
        part = [
            (float(left), float(right), float(low), float(high))
            for (left, right), (low, high) in curve
            if low <= 1 and left <= WIDTH
        ]
        boxes(axis, part, "ink")
    if labels:
        axis.text(0.19, 0.2, "upper curve: stability\nlower curve: existence", fontsize=10)
    axis.set_xlim(0, float(WIDTH))
    axis.set_ylim(0, 1)
    axis.set_xticks([float(Fraction(t)) ** (1 / 3) for t in TICKS], TICKS, fontsize=9)
    axis.set_xlabel("r (on the scale of its cube root)")
    axis.set_ylabel("−cos θ₀")
    for side_name in ("top", "right"):
        axis.spines[side_name].set_visible(False)


def defect_maps(depth: int) -> Figure:
    """One map for each printed step whose failure depends on the parameters."""
    cells = maps(depth).printed
    panels = [
        Panel(TITLES[row.name.removeprefix(f"{PRINTED}.")], _map(row.name, cells), 400, 300)
        for row in mapped()
    ]
    table: list[tuple[str, ...]] = [("Step", "refuted", "proved", "undecided")]
    for row in sorted_rows(PRINTED, WHOLE).open:
        if any(judged.verdicts.get(row.name) == REFUTED for judged in cells):
            shares = [share_of(cells, row.name, v) for v in (REFUTED, PROVED, UNDECIDED)]
            table.append((row.says, *(_percent(share) for share in shares)))
    inside = sum(judged.condition == PROVED for judged in cells)
    caption = (
        f"Each map has the {len(cells)} cells of the plane, of which {inside} are surely "
        f"admissible. Red: the step is refuted at every point of the cell; green: it is proved "
        f"there; grey: undecided at this size of cells. The table has the share of each verdict, "
        f"by area in the plane as drawn and rounded down, for all {len(table) - 1} steps that are "
        f"refuted somewhere."
    )
    return Figure("defects", "Where each defective step fails", caption, panels, table)


def _map(name: str, cells: list[JudgedBox]) -> Callable[[Any], None]:
    def draw(axis: Any) -> None:
        for verdict in (UNDECIDED, PROVED, REFUTED):
            part = [j for j in cells if j.verdicts.get(name, UNDECIDED) == verdict]
            colour = verdict if verdict == UNDECIDED else f"{verdict}-area"
            boxes(axis, merged(map(_corners, part)), colour)
        frame(axis, labels=False)
        axis.set_xticks(axis.get_xticks()[1::2], TICKS[1::2])
        axis.set_xlabel("r")

    return draw
