"""How close the two sides of each obligation are, over r at theta_0 = pi."""

from __future__ import annotations

from fractions import Fraction
from functools import cache
from itertools import pairwise
from typing import Any, NamedTuple

from verify.prover import balls
from verify.prover.decimals import decimal_text, round_decimal
from verify.views.plots.constructions import as_formulas, definitions, rows
from verify.views.plots.drawing import COLOURS, Panel, boxes
from verify.views.plots.field import Field
from verify.views.plots.figure import Figure
from verify.views.plots.slopes import BITS, Side
from verify.prover.ground import PROVED, REFUTED, Ends
from verify.paper.groups import PRINTED, REPAIRED
from verify.language.terms import as_term

#: r_stabi = 9 - 4√5 = 0.0557280900008…; the axis ends just below it.
END = Fraction("0.055728")

#: The share of its bound at which each repaired constant stands, as on the map of the region.
SHARE = Fraction(1, 2)

TIGHTEST = 14

#: An enclosure is drawn if its ends differ by at most this factor.
FACTOR = 2


def intervals() -> list[Side]:
    """Intervals of r that shrink by a fixed factor towards both ends."""
    left, right = (_distances(Fraction(1, part)) for part in (5, 14))
    return list(pairwise([*reversed(left), *(END - x for x in right[1:])]))


def _distances(share: Fraction) -> list[Fraction]:
    """Distances from an end, from the middle on; each step is at most a share of what is left."""
    distances = [END / 2]
    while distances[-1] > END / 4000:
        distances.append(distances[-1] - min(distances[-1] * share, END / 80))
    return distances


class Row(NamedTuple):
    """A row with its ratio lhs/rhs on each cell of r where it is enclosed, and its verdicts."""

    says: str
    ratios: list[tuple[Side, Ends]]
    verdicts: set[str]


@cache
def ratios(group: str, share: Fraction) -> list[Row]:
    """The rows of a set whose two sides are positive, from the largest ratio to the smallest."""
    definition = (("c", as_term(1)), *definitions(as_formulas(group, share)))
    field = Field(("r",), definition)
    open_rows = rows(group, share).open
    slots = field.slots({row.name: row.claim for row in open_rows})
    found = {row.name: Row(row.says, [], set()) for row in open_rows}
    with balls.precision(BITS):
        for side in intervals():
            values = field.on((side,))
            for name, slot in slots.items():
                found[name].verdicts.add(values.judge(slot))
                ends = values.ratio(slot)
                lhs, rhs = values.at(slot[1]), values.at(slot[2])
                positive = lhs is not None and rhs is not None and lhs.range > 0 and rhs.range > 0
                if positive and ends is not None and ends[1] < FACTOR * ends[0]:
                    found[name].ratios.append((side, ends))
    drawn = [row for row in found.values() if len(row.ratios) > 10]
    return sorted(drawn, key=_middle, reverse=True)


def _middle(row: Row) -> Fraction:
    """The ratio halfway between the ends, or where it is next enclosed."""
    return min(row.ratios, key=lambda pair: abs(pair[0][0] - END / 2))[1][1]


def printed_rows() -> tuple[list[Row], list[Row]]:
    """The printed rows that are refuted somewhere, and the tightest of the others."""
    every = ratios(PRINTED, Fraction(1))
    refuted = [row for row in every if REFUTED in row.verdicts]
    others = [row for row in every if REFUTED not in row.verdicts]
    return refuted, others[:TIGHTEST]


def figure() -> Figure:
    """Both sets, one below the other on a phone."""
    refuted, others = printed_rows()
    repaired = ratios(REPAIRED, SHARE)
    tightest = repaired[:TIGHTEST]
    count = sum(len(row.ratios) for row in (*refuted, *others, *tightest))
    proved = [row for row in repaired if row.verdicts == {PROVED}]
    table = [("Drawn step (from the largest ratio)", "set", "left/right at r ≈ 0.0279, at most")]
    for name, part in (("printed, refuted", refuted), ("printed", others), ("repaired", tightest)):
        table += ((row.says, name, decimal_up(_middle(row))) for row in part)
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
    refuted, others = printed_rows()
    for colour, part in (("proved", others), ("refuted", refuted)):
        boxes(axis, _boxes(part), colour, edge=0.8)
    _frame(axis)
    axis.set_ylim(0.1, 3e3)


def _draw_repaired(axis: Any) -> None:
    boxes(axis, _boxes(ratios(REPAIRED, SHARE)[:TIGHTEST]), "proved", edge=0.8)
    _frame(axis)
    axis.set_yscale("linear")
    axis.set_ylim(0.5, 1.05)


def _boxes(part: list[Row]) -> list[tuple[float, float, float, float]]:
    return [
        (float(left), float(right), float(low), float(high))
        for row in part
        for (left, right), (low, high) in row.ratios
    ]


def _frame(axis: Any) -> None:
    axis.set_yscale("log")
    axis.set_xlim(0, float(END))
    axis.axhline(1, color=COLOURS["ink"], linewidth=1)
    axis.set_xlabel("r")
    axis.set_ylabel("left / right")
    for side in ("top", "right"):
        axis.spines[side].set_visible(False)
