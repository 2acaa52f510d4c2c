"""Scenes as a table with commas, one line each; and how a scene moves, as another one."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from typing import Any

from verify.prover.decimals import decimal_text, exact_number, outward, round_decimal
from verify.views.scene import COLLAPSES, DISPERSES, UNDECIDED, Told

#: Digits of the enclosures.
DIGITS = 17
COLUMNS = (
    "file", "verdict", "reason", "central", "collisions_certain", "collisions_total",
    "time_low", "time_high", "neg_cos_low", "neg_cos_high", "energy_lost_low", "energy_lost_high",
    "event_time_low", "event_time_high", "judged_by", "title", "time_unit", "length_unit",
)  # fmt: skip
Cells = Sequence[str]
Ends = tuple[Fraction, Fraction]
#: A row of a trajectory: `verify.spheres.scene.trajectory.Instant`.
Instant = Any


def cells(file: str, told: Told, judge: str) -> Cells:
    """A line of the table; a cell without a value is empty."""
    pairs = (told.time, told.angle, told.energy, told.event)
    ends = [_ends(pair) for pair in pairs]
    return (
        file,
        told.verdict,
        told.reason,
        "" if told.central is None else str(told.central),
        str(told.collisions),
        {COLLAPSES: "inf", DISPERSES: str(told.collisions)}.get(told.verdict, ""),
        *(end for pair in ends for end in pair),
        "" if told.verdict == UNDECIDED else judge,
        *told.scene.labels,
    )


def unusable_cells(file: str, verdict: str) -> Cells:
    """The line of a file that tells of no scene."""
    return (file, verdict, verdict, *("" for _ in COLUMNS[3:]))


def parameter_heads(names: Iterable[str]) -> Cells:
    """The heads of two columns for each parameter, in the order of their names."""
    return [head for name in sorted(names) for head in (name, f"{name}_decimal")]


def parameter_cells(values: Mapping[str, Fraction]) -> Cells:
    """Each parameter exactly, and as a decimal that is rounded down."""
    found = [values[name] for name in sorted(values)]
    decimals = [decimal_text(*round_decimal(value, DIGITS, up=False)) for value in found]
    return [cell for pair in zip(map(str, found), decimals, strict=True) for cell in pair]


def _ends(pair: tuple[Any, Any] | None) -> Sequence[str]:
    return ("", "") if pair is None else outward(pair, DIGITS)


def csv_text(rows: Iterable[Cells]) -> str:
    """The lines of a file with commas; a name with a comma or a quote stands in quotes."""
    return "".join(",".join(map(_quoted, row)) + "\n" for row in rows)


def _quoted(cell: str) -> str:
    if not any(sign in cell for sign in ',"\n\r'):
        return cell
    return '"' + cell.replace('"', '""') + '"'


def counts_of(rows: Iterable[Cells]) -> list[str]:
    """How many scenes have which verdict, for which reason; the most frequent first."""
    return list(_count_lines(Counter((row[1], row[2]) for row in rows)))


def _count_lines(counts: Mapping[tuple[str, str], int]) -> Iterator[str]:
    total = sum(counts.values())
    yield f"{'verdict':<11}{'reason':<21}{'scenes':>8}  {'share':>9}"
    for (verdict, reason), count in _ordered(counts):
        yield f"{verdict:<11}{reason:<21}{count:>8}  {100 * count / total:7.3f} %"
    yield f"{'all':<32}{total:>8}"


def _ordered(counts: Mapping[tuple[str, str], int]) -> list[tuple[tuple[str, str], int]]:
    return sorted(counts.items(), key=lambda item: (-item[1], item[0]))


def trajectory_rows(instants: Iterable[Instant], dimension: int) -> Iterator[Cells]:
    """A head, and a line for each particle at the start and just after each collision."""
    names = [f"{letter}{k}" for letter in ("x", "v") for k in range(1, dimension + 1)]
    ends = [f"{name}_{end}" for name in names for end in ("low", "high")]
    yield "collision", "pair", "time_low", "time_high", "particle", *ends
    for n, instant in enumerate(instants):
        time = outward(instant.time, DIGITS)
        for i, numbers in enumerate(instant.particles):
            found = [end for number in numbers for end in outward(number, DIGITS)]
            yield str(n), instant.pair, *time, str(i), *found


# --- a sample of a family ------------------------------------------------------------------------


def sample_document(
    sides: Mapping[str, Ends],
    counts: Mapping[tuple[str, str], int],
    seed: int,
    left_out: int,
    confidence: Fraction,
    shares: Mapping[str, Sequence[Fraction]],
) -> dict[str, Any]:
    """A sample as JSON; every number but a count is a text."""
    return {
        "format": "verify-sample/1",
        "command": "scene",
        "parameters": {name: [str(low), str(high)] for name, (low, high) in sides.items()},
        "sample": sum(counts.values()),
        "seed": str(seed),
        "left_out": left_out,
        "counts": [
            {"verdict": verdict, "reason": reason, "count": count}
            for (verdict, reason), count in _ordered(counts)
        ],
        "confidence": str(confidence),
        "shares": {name: outward((low, high), 6) for name, (low, high) in shares.items()},
    }


def sample_lines(document: Mapping[str, Any]) -> Iterator[str]:
    """A sample for a reader."""
    yield from drawn_lines(document)
    counts = {(one["verdict"], one["reason"]): one["count"] for one in document["counts"]}
    yield from _count_lines(counts)
    yield from share_lines(document)


def drawn_lines(document: Mapping[str, Any]) -> Iterator[str]:
    """Which points were drawn."""
    drawn = f"{document['sample']} random points, seed {document['seed']}"
    yield f"{drawn}; uniform and independent are"
    for name, ends in document["parameters"].items():
        low, high = (exact_number(Fraction(end)) for end in ends)
        yield f"  {name} in [{low}, {high}]" if low != high else f"  {name} = {low}"
    if document["left_out"]:
        yield f"{document['left_out']} more were left out: particles overlap there"


def share_lines(document: Mapping[str, Any]) -> Iterator[str]:
    """Between what the shares lie, that of collapses first."""
    level = exact_number(100 * Fraction(document["confidence"]))
    yield f"share of the family, with a confidence of at least {level} % (Clopper-Pearson),"
    yield "where what is undecided counts as both:"
    for name, (low, high) in document["shares"].items():
        yield f"  {name.replace('_', ' ')} collisions: [{low}, {high}]"
