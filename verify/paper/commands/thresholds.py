"""Where the printed rows hold that depend on the parameters, by `verify/paper/thresholds.toml`.

The chart is the set of all u and p with 0 < u < 1, 0 < p and 2(p + u p^2) <= 1 + u p^3, which is
c <= 1; p is phi_plus. A strip of it is what lies between two values of p.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from fractions import Fraction
from functools import cache
from itertools import pairwise

from verify.language.record import Record
from verify.language.statement import PROVED, REFUTED, UNDECIDED
from verify.prover.outcome import Ends, Outcome
from verify.views.all_parameters import LEFT_OPEN

#: How many parts 0 < u < 1 is cut into to enclose areas, and how often ends are halved there.
PARTS, HALVINGS = 500, 24
#: All of the chart has p less than this.
WHOLE = Fraction(1, 2)


#: Where the drift is |Delta_theta|, were it not for d_bar, and where d_n/delta_2 is h_4 delta_x/2.
DRIFT_ENDS, SLOPE_STARTS = Fraction(5, 33), Fraction(1, 22)
#: How far from a threshold nothing is said.
STRIP = Fraction(1, 100000)


class Strip(Record):
    """A row that is proved, or refuted, for phi_plus from ``low`` to ``high``; ``by`` says so."""

    row: str
    verdict: str
    low: Fraction
    high: Fraction
    by: str


#: What is certified at V_0 = 1 and delta_theta = 1/10.
STRIPS = (
    Strip("angle-absorbed", PROVED, Fraction(0), DRIFT_ENDS - STRIP, "angle-absorbed.holds"),
    Strip("angle-absorbed", REFUTED, DRIFT_ENDS, WHOLE, "angle-absorbed.fails"),
    Strip("x-term-1-d", REFUTED, Fraction(0), SLOPE_STARTS, "x-term-1-d.fails"),
    Strip("x-term-1-d", PROVED, SLOPE_STARTS, WHOLE, "x-term-1-d.holds"),
    Strip("y-term-3", PROVED, Fraction(0), DRIFT_ENDS - STRIP, "y-term-3.holds"),
    Strip("y-term-3", REFUTED, DRIFT_ENDS, WHOLE, "y-term-3.fails"),
    Strip("final-angle", PROVED, Fraction(0), WHOLE, "final-angle.wide"),
)


# --- areas ---------------------------------------------------------------------------------------


def certified(where: Outcome) -> list[Strip]:
    """The strips whose verdict an outcome proves."""
    return [s for s in STRIPS if where.decisions[s.by].verdict == PROVED]


def all_shares(where: Outcome) -> dict[str, Mapping[str, Ends]]:
    """For each row that depends on phi_plus the bounds of its shares."""
    return {row: shares(row, where) for row in dict.fromkeys(strip.row for strip in STRIPS)}


def shares(row: str, where: Outcome) -> Mapping[str, Ends]:
    """Bounds of the share of the chart on which a row is proved, refuted, or neither.

    Where one interval of phi_plus is left open, `LEFT_OPEN` has its ends.
    """
    strips = [strip for strip in certified(where) if strip.row == row]
    found = {verdict: _share(strips, verdict) for verdict in (PROVED, REFUTED)}
    gaps = _gaps(strips)
    width = sum((high - low for low, high in gaps), Fraction(0))
    one = {LEFT_OPEN: gaps[0]} if len(gaps) == 1 else {}
    return {**found, **one, UNDECIDED: (Fraction(0), width / _area(WHOLE)[0])}


def _share(every: Iterable[Strip], verdict: str) -> Ends:
    strips = [strip for strip in every if strip.verdict == verdict]
    if any(strip.low == 0 and strip.high == WHOLE for strip in strips):
        return Fraction(1), Fraction(1)
    (least, most), low, high = _area(WHOLE), Fraction(0), Fraction(0)
    for strip in strips:
        inner, outer = _area(strip.low), _area(strip.high)
        low += max(Fraction(0), outer[0] - inner[1])
        high += outer[1] - inner[0]
    return low / most, high / least


def refuted_at(strips: Iterable[Strip], low: Fraction, high: Fraction) -> int | None:
    """How many rows are refuted for phi_plus in an open interval; None if one is not decided."""
    rows = {strip.row for strip in STRIPS}
    there = {s.row: s.verdict for s in strips if s.low <= low and high <= s.high}
    return None if there.keys() != rows else list(there.values()).count(REFUTED)


def bands(where: Outcome) -> Iterator[tuple[Fraction, Fraction, int | None]]:
    """The values of phi_plus between neighbouring ends of strips, with what is refuted there."""
    strips = certified(where)
    ends = sorted({end for strip in STRIPS for end in (strip.low, strip.high)})
    for low, high in pairwise(ends):
        yield low, high, refuted_at(strips, low, high)


def _gaps(strips: Iterable[Strip]) -> list[Ends]:
    """The intervals of p between some strips; their width bounds their area."""
    known = sorted((strip.low, strip.high) for strip in strips)
    ends = [Fraction(0), *(end for strip in known for end in strip), WHOLE]
    pairs = zip(ends[::2], ends[1::2], strict=True)
    return [(low, high) for low, high in pairs if low < high]


@cache
def _area(most: Fraction) -> Ends:
    """Bounds of the area of the part of the chart with p at most this."""
    heights = [_height(Fraction(k, PARTS)) for k in range(PARTS + 1)]
    low = sum((min(most, height[0]) for height in heights[1:]), Fraction(0))
    high = sum((min(most, height[1]) for height in heights[:-1]), Fraction(0))
    return low / PARTS, high / PARTS


@cache
def _height(u: Fraction) -> Ends:
    """Bounds of the largest p with c <= 1, which falls with u: c grows with u and with p."""
    low, high = Fraction(0), WHOLE
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        inside = 2 * (middle + u * middle**2) <= 1 + u * middle**3
        low, high = (middle, high) if inside else (low, middle)
    return low, high
