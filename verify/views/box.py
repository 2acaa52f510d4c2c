"""What people and scripts see of Theorem 1 on a box of parameters, and on a grid."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator
from fractions import Fraction
from itertools import groupby
from typing import Any

from verify.language.record import Record
from verify.language.statement import PROVED, REFUTED, UNDECIDED, Assumption
from verify.prover.decimals import exact_number
from verify.publication import REPAIRED, Publication
from verify.views.all_parameters import THEOREM
from verify.views.document import assumption_document, claims_document
from verify.views.findings import Answer, ParameterBox, ScannedPoint
from verify.views.restitution import without_interior
from verify.views.words import DOES_NOT_APPLY, believed, given, in_letters

FORMAT = "verify-theorem1-box/1"


def screen(answer: Answer, paper: Publication) -> Iterator[str]:
    """What holds on the box, or on which part of it."""
    cited = answer.outcome.assumptions
    yield f"Theorem 1 at all points with {_words(answer.box)}"
    yield ""
    if answer.verdict == REFUTED:
        yield "The stability condition fails at each of these points."
        yield from (f"Known there: {line}" for line in without_interior(answer.box.r[0]))
        yield ""
        yield f"Verdict: refuted: {in_letters(answer.outcome.statement.title)}"
        return
    where = "all points" if answer.verdict == PROVED else "all points of the certified part"
    yield f"The hypotheses are compared at a corner; by monotony they hold at {where}."
    yield "The constants are the unrounded minima of Theorem 1 for all parameters."
    yield f"{believed(answer.outcome, paper)} Their text: -v."
    yield ""
    yield THEOREM
    yield ""
    if answer.verdict == PROVED:
        yield f"Verdict: proved: {in_letters(answer.outcome.statement.title)}; given {given(cited)}"
        return
    yield "The certified part, as a command:"
    yield f"  {_command(answer)}"
    yield (
        "Verdict: undecided: the hypotheses fail at some points of the box; they hold at all with "
        f"{_words(answer.part)}; given {given(cited)}"
    )


def _words(box: ParameterBox) -> str:
    return f"r {_side(box.r)} and -cos θ₀ {_side(box.c)}"


def _side(side: tuple[Fraction, Fraction]) -> str:
    low, high = side
    texts = exact_number(low), exact_number(high)
    return f"= {texts[0]}" if low == high else f"in [{texts[0]}, {texts[1]}]"


def _command(answer: Answer) -> str:
    """The command that decides the certified part."""
    part, parameters = answer.part, answer.outcome.statement.parameters
    v_0, delta = (parameters[name].value for name in ("V_0", "delta_theta"))
    return (
        f"verify theorem1 --r {_range(part.r)} --neg-cos {_range(part.c)} "
        f"--V0 {v_0} --delta-theta {delta}"
    )


def _range(side: tuple[Fraction, Fraction]) -> str:
    return f"{side[0]}..{side[1]}"


def box_document(answer: Answer, cited: tuple[Assumption, ...]) -> dict[str, Any]:
    """One JSON document; its claims are about the part that is certified."""
    found = claims_document(answer.outcome, "theorem1", FORMAT)
    parameters = answer.outcome.statement.parameters
    found["verdict"] = answer.verdict
    if answer.verdict not in (PROVED, REFUTED):
        found["headline"] = answer.verdict
    found["parameters"] = {
        **_sides(answer.box),
        "delta_theta": str(parameters["delta_theta"].value),
        "V_0": str(parameters["V_0"].value),
    }
    found["certified"] = None if answer.verdict == REFUTED else _sides(answer.part)
    used = () if answer.verdict == REFUTED else cited
    found["assumptions"] = [assumption_document(assumption) for assumption in used]
    return found


def _sides(box: ParameterBox) -> dict[str, list[str]]:
    return {"r": list(map(str, box.r)), "neg_cos_theta0": list(map(str, box.c))}


# --- on a grid -----------------------------------------------------------------------------------


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
