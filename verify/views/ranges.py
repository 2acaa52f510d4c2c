"""Verdicts at many values of r, told as ranges of neighbouring points with the same verdicts."""

from __future__ import annotations

import json
import sys
from collections import Counter
from collections.abc import Iterable, Iterator
from fractions import Fraction
from itertools import groupby

from verify.jobs.scan import ScannedPoint
from verify.language.record import Record
from verify.language.statement import PROVED, REFUTED, UNDECIDED
from verify.prover.decimals import exact_number
from verify.prover.outcome import EXIT_CODES


class Range(Record):
    """Neighbouring points with the same verdicts on all rows."""

    first: Fraction
    last: Fraction
    points: int
    verdict: str
    refuted: tuple[str, ...]


def show_ranges(points: Iterable[tuple[Fraction, ScannedPoint]], *, as_json: bool) -> int:
    """Print what was found, and return the exit code: refuted beats undecided beats proved."""
    found = list(ranges(points))
    total = Counter[str]()
    for item in found:
        total[item.verdict] += item.points
    verdict = next((v for v in (REFUTED, UNDECIDED) if total[v]), PROVED)
    if as_json:
        _print_document(found, total, verdict)
        return EXIT_CODES[verdict]
    for item in found:
        sys.stdout.write(
            f"r = {exact_number(item.first)} "
            f"to {exact_number(item.last)}: {item.points} points {item.verdict}, "
            f"{len(item.refuted)} rows refuted\n"
        )
    counts = ", ".join(f"{count} {name}" for name, count in total.items())
    sys.stdout.write(f"Verdict at the points of the grid, not between them: {counts}\n")
    return EXIT_CODES[verdict]


def _print_document(found: list[Range], total: Counter[str], verdict: str) -> None:
    document = {
        "format": "verify-theorem1-scan/1",
        "command": "theorem1",
        "verdict": verdict,
        "points": dict(total),
        "ranges": [
            {
                "r": [str(item.first), str(item.last)],
                "points": item.points,
                "verdict": item.verdict,
                "refuted": list(item.refuted),
            }
            for item in found
        ],
    }
    print(json.dumps(document, ensure_ascii=False, indent=1))


def ranges(points: Iterable[tuple[Fraction, ScannedPoint]]) -> Iterator[Range]:
    """Neighbouring points with the same verdicts, put together."""
    for (verdict, refuted), group in groupby(points, _kind):
        here = [r for r, _ in group]
        yield Range(here[0], here[-1], len(here), verdict, refuted)


def _kind(item: tuple[Fraction, ScannedPoint]) -> tuple[str, tuple[str, ...]]:
    rows = item[1].rows.items()
    return item[1].verdict, tuple(name for name, verdict in rows if verdict == REFUTED)
