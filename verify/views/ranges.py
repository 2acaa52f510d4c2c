"""Verdicts at many values of r, told as ranges of neighbouring points with the same verdicts."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator
from fractions import Fraction
from itertools import groupby
from typing import Any

from verify.language.record import Record
from verify.language.statement import PROVED, REFUTED, REPAIRED, UNDECIDED
from verify.prover.decimals import exact_number
from verify.views.material import ScannedPoint
from verify.views.words import DOES_NOT_APPLY


class Range(Record):
    """Neighbouring points with the same verdicts on all rows."""

    first: Fraction
    last: Fraction
    points: int
    verdict: str
    refuted: tuple[str, ...]


def verdict_of(found: Iterable[Range]) -> str:
    """The verdict on all points: refuted beats undecided beats proved."""
    kinds = {item.verdict for item in found}
    return next((v for v in (REFUTED, UNDECIDED, PROVED) if v in kinds), UNDECIDED)


def range_lines(found: Iterable[Range]) -> Iterator[str]:
    """A line for each range, and the verdict."""
    total = Counter[str]()
    for item in found:
        told = _told(item)
        total[told] += item.points
        where = f"r = {exact_number(item.first)}"
        if item.points > 1:
            where += f" to {exact_number(item.last)}: {item.points} points"
        rows = f"{len(item.refuted)} {'row' if len(item.refuted) == 1 else 'rows'}"
        yield f"{where}: {told}, {rows} refuted"
    words = {DOES_NOT_APPLY: "where it does not apply"}
    counts = ", ".join(f"{count} {words.get(name, name)}" for name, count in total.items())
    yield f"Verdict at the points of the grid, not between them: {counts}"


def _told(item: Range) -> str:
    """The verdict in words: the theorem does not apply where only hypotheses are refuted."""
    fails = any(name.startswith(f"{REPAIRED}.") for name in item.refuted)
    return DOES_NOT_APPLY if item.verdict == REFUTED and not fails else item.verdict


def ranges_document(found: Iterable[Range]) -> dict[str, Any]:
    """The ranges as one JSON document."""
    ranges, total = list(found), Counter[str]()
    for item in ranges:
        total[item.verdict] += item.points
    return {
        "format": "verify-theorem1-scan/1",
        "command": "theorem1",
        "verdict": verdict_of(ranges),
        "points": dict(total),
        "ranges": [
            {
                "r": [str(item.first), str(item.last)],
                "points": item.points,
                "verdict": item.verdict,
                "refuted": list(item.refuted),
            }
            for item in ranges
        ],
    }


def ranges(points: Iterable[tuple[Fraction, ScannedPoint]]) -> Iterator[Range]:
    """Neighbouring points with the same verdicts, put together."""
    for (verdict, refuted), group in groupby(points, _kind):
        here = [r for r, _ in group]
        yield Range(here[0], here[-1], len(here), verdict, refuted)


def _kind(item: tuple[Fraction, ScannedPoint]) -> tuple[str, tuple[str, ...]]:
    rows = item[1].rows.items()
    return item[1].verdict, tuple(name for name, verdict in rows if verdict == REFUTED)
