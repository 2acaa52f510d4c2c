"""How close the two sides of each obligation are, over r at theta_0 = pi."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from verify.jobs.covers import END, FACTOR, SHARE, WHOLE, Ratios, intervals, ratios
from verify.language.statement import PROVED, REFUTED
from verify.paper.groups import PRINTED, REPAIRED
from verify.prover.decimals import decimal_text, round_decimal
from verify.views.plots.drawing import COLOURS, Panel, boxes
from verify.views.plots.figure import Figure

TIGHTEST = 14


def printed_ratios() -> tuple[list[Ratios], list[Ratios]]:
    """The printed rows that are refuted somewhere, and the tightest of the others."""
    every = ratios(PRINTED, WHOLE)
    refuted = [row for row in every if REFUTED in row.verdicts]
    others = [row for row in every if REFUTED not in row.verdicts]
    return refuted, others[:TIGHTEST]


def figure() -> Figure:
    """Both sets, one below the other on a phone."""
    refuted, others = printed_ratios()
    repaired = ratios(REPAIRED, SHARE)
    tightest = repaired[:TIGHTEST]
    count = sum(len(row.boxes) for row in (*refuted, *others, *tightest))
    proved = [row for row in repaired if row.verdicts == {PROVED}]
    table = [("Drawn step (from the largest ratio)", "set", "left/right at r ≈ 0.0279, at most")]
    for name, part in (("printed, refuted", refuted), ("printed", others), ("repaired", tightest)):
        table += ((row.says, name, decimal_up(row.middle)) for row in part)
    return Figure(
        "margins",
        "How close each step is, over r at θ₀ = π",
        f"The ratio of the two sides, left/right, on {len(intervals())} intervals of r between 0 "
        f"and 9-4√5; the relative margin (right-left)/right is 1 minus it, and a step holds below "
        f"1. Each of the {count} boxes contains the ratio at every r of its interval; boxes higher "
        f"than a factor {FACTOR} are left out. Left: the {len(refuted)} printed steps that are "
        f"refuted (red), and the {len(others)} tightest of the others (green). Right: the "
        f"{len(tightest)} tightest steps of the repaired construction, each constant at half of "
        f"its bound; {len(proved)} of its {len(repaired)} rows with two positive sides that are "
        f"not identities are proved on every interval, from r = {_end(0)} to r = {_end(-1)}.",
        (
            Panel("As printed", _draw_printed, 400, 330),
            Panel("Repaired", _draw_repaired, 400, 330),
        ),
        table,
    )


def _end(index: int) -> str:
    """The first or the last end of the intervals, to three digits inside."""
    value = intervals()[index][index]
    return decimal_text(*round_decimal(value, 5, up=index == 0))


def decimal_up(value: Fraction) -> str:
    """A short upper bound."""
    return decimal_text(*round_decimal(value, 4, up=True))


def _draw_printed(axis: Any) -> None:
    refuted, others = printed_ratios()
    for colour, part in (("proved", others), ("refuted", refuted)):
        boxes(axis, _boxes(part), colour, edge=0.8)
    _frame(axis)
    axis.set_ylim(0.1, 3e3)


def _draw_repaired(axis: Any) -> None:
    boxes(axis, _boxes(ratios(REPAIRED, SHARE)[:TIGHTEST]), "proved", edge=0.8)
    _frame(axis)
    axis.set_yscale("linear")
    axis.set_ylim(0.5, 1.05)


def _boxes(part: list[Ratios]) -> list[tuple[float, float, float, float]]:
    return [
        (float(left), float(right), float(low), float(high))
        for row in part
        for (left, right), (low, high) in row.boxes
    ]


def _frame(axis: Any) -> None:
    axis.set_yscale("log")
    axis.set_xlim(0, float(END))
    axis.axhline(1, color=COLOURS["ink"], linewidth=1)
    axis.set_xlabel("r")
    axis.set_ylabel("left / right")
    for side in ("top", "right"):
        axis.spines[side].set_visible(False)
