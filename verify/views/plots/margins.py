"""How close the two sides of each obligation are, over r at theta_0 = pi; and which break."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import groupby

from verify.language.statement import PRINTED, PROVED, REFUTED
from verify.prover.decimals import decimal_text, round_decimal
from verify.publication import BREAKS, REPAIRED
from verify.views.findings import Margins, Ratios
from verify.views.plots import shapes

TIGHTEST = 14

TOLD_PRINTED = (
    "Curves over r from 0 to 0.056. Those of the refuted printed steps lie above the line at 1, "
    "some a hundred times as high; those of the others below it."
)
TOLD_REPAIRED = "Curves over r from 0 to 0.056, all of them below the line at 1."


def printed_ratios(every: Sequence[Ratios]) -> tuple[list[Ratios], list[Ratios]]:
    """The printed rows that are refuted somewhere, and the tightest of the others."""
    refuted = [row for row in every if REFUTED in row.verdicts]
    others = [row for row in every if REFUTED not in row.verdicts]
    return refuted, others[:TIGHTEST]


def figure(found: Margins) -> shapes.Figure:
    """Both sets, one below the other on a phone."""
    refuted, others = printed_ratios(found.printed)
    repaired, across = found.repaired, _scale(found.end)
    tightest = repaired[:TIGHTEST]
    count = sum(len(row.boxes) for row in (*refuted, *others, *tightest))
    proved = [row for row in repaired if row.verdicts == {PROVED}]
    table = [("Drawn step (from the largest ratio)", "set", "left/right at r ≈ 0.0279, at most")]
    for name, part in (("printed, refuted", refuted), ("printed", others), ("repaired", tightest)):
        table += ((row.says, name, decimal_up(row.middle)) for row in part)
    return shapes.Figure(
        "margins",
        "How close each step is, over r at θ₀ = π",
        f"The ratio of the two sides, left/right, on {len(found.intervals)} intervals of r between "
        f"0 and 9-4√5; the relative margin (right-left)/right is 1 minus it, and a step holds "
        f"below 1. Each of the {count} boxes contains the ratio at every r of its interval; boxes "
        f"higher than a factor {found.factor} are left out. Left: the {len(refuted)} printed steps "
        f"that are refuted (orange), and the {len(others)} tightest of the others (blue). Right: "
        f"the {len(tightest)} tightest steps of the repaired construction, each constant at half "
        f"of its bound; {len(proved)} of its {len(repaired)} rows with two positive sides that are "
        f"not identities are proved on every interval, from r = {_end(found, 0)} to "
        f"r = {_end(found, -1)}. A step in the table below leads to its curve.",
        (
            shapes.Panel(
                "As printed", across, _WIDE, lambda: _printed(refuted, others), TOLD_PRINTED
            ),
            shapes.Panel("Repaired", across, _NARROW, lambda: _repaired(tightest), TOLD_REPAIRED),
        ),
        table,
        [
            f"margin-{name}-{number}"
            for name, part in (("p", (*refuted, *others)), ("r", tightest))
            for number in range(1, len(part) + 1)
        ],
    )


def _end(found: Margins, index: int) -> str:
    """The first or the last end of the intervals, to three digits inside."""
    value = found.intervals[index][index]
    return decimal_text(*round_decimal(value, 5, up=index == 0))


def decimal_up(value: Fraction) -> str:
    """A short upper bound."""
    return decimal_text(*round_decimal(value, 4, up=True))


def _printed(refuted: Sequence[Ratios], others: Sequence[Ratios]) -> Iterator[shapes.Shape]:
    yield shapes.Rule(1)
    yield from _curves("p", others, "proved", "holds", len(refuted))
    yield from _curves("p", refuted, "refuted", "refuted")


def _repaired(tightest: Sequence[Ratios]) -> Iterator[shapes.Shape]:
    yield shapes.Rule(1)
    yield from _curves("r", tightest, "proved", "proved")


def _curves(
    panel: str, part: Sequence[Ratios], colour: str, name: str, before: int = 0
) -> Iterator[shapes.Areas]:
    """A curve for each row, which its row in the table refers to; the first is in the legend."""
    for number, row in enumerate(part, before + 1):
        key, entry = f"margin-{panel}-{number}", name if number == before + 1 else ""
        yield shapes.Areas(shapes.corners(row.boxes), colour, 0.9, entry, key)


def _scale(end: Fraction) -> shapes.Scale:
    return shapes.Scale(
        "r", 0, float(end), shapes.marks("0", "0.01", "0.02", "0.03", "0.04", "0.05")
    )


_WIDE = shapes.Scale("left / right", 0.1, 3e3, shapes.powers(-1, 3), logarithmic=True)
_NARROW = shapes.Scale(
    "left / right", 0.5, 1.05, shapes.marks("0.5", "0.6", "0.7", "0.8", "0.9", "1")
)


# --- the steps that break the printed argument ----------------------------------------------------

WIDTH, HEIGHT = 440, 380
#: Below this ratio nothing is drawn.
LOW = 0.1
#: A curve that rises into view has its name beside this ratio.
RISEN = Fraction(4, 5)
#: Curves whose names would stand upon each other have one name: their ratios differ by less.
NEAR = 1.2


def broken_steps(found: Margins) -> shapes.Figure:
    """The steps that break the printed argument, and the same steps repaired: one panel."""
    broken = [row for row in found.printed if row.severity == BREAKS and REFUTED in row.verdicts]
    names = {f"{REPAIRED}.{row.name.removeprefix(f'{PRINTED}.')}" for row in broken}
    repaired = [row for row in found.repaired if row.name in names]
    across = _scale(found.end)
    up = shapes.Scale("left side / right side", LOW, 1e3, shapes.powers(-1, 3), logarithmic=True)
    return shapes.Figure(
        "breaks",
        "Where the printed proof breaks, and by how much",
        f"{len(broken)} inequalities of the printed proof, over r at θ₀ = π: the left side "
        "divided by the right side. A step holds where this is at most 1. Orange: as "
        "printed. Blue: the same steps with the repaired constants. Each box contains the ratio at "
        "every r of its interval. A fifth step that breaks has no curve: 0 < 0, in the claim that "
        "the set has interior points.",
        (
            shapes.Panel(
                "The steps that break the argument",
                across,
                up,
                lambda: _broken(broken, repaired),
                "The orange curves of the printed steps lie above the line at 1, two of them "
                "about a hundred times as high; the blue ones of the repaired steps lie below it.",
                WIDTH,
                HEIGHT,
            ),
        ),
    )


def _broken(broken: Sequence[Ratios], repaired: Sequence[Ratios]) -> Iterator[shapes.Shape]:
    yield shapes.Rule(1)
    yield shapes.Words((0.001, 1.3), "above this line a step fails")
    for part, colour, name in ((broken, "refuted", "as printed"), (repaired, "proved", "repaired")):
        for number, row in enumerate(part):
            yield shapes.Areas(shapes.corners(row.boxes), colour, 0.9, name if number == 0 else "")
        yield from _names(part)


def _names(part: Sequence[Ratios]) -> Iterator[shapes.Words]:
    """A name above each curve, at its left end, or before the end of one that rises into view."""
    for group in _near(part):
        text = ", ".join(row.name.partition(".")[2] for row in group)
        (left, _), (_, height) = group[0].boxes[0]
        if height > LOW:
            yield shapes.Words((float(left) + 0.001, float(height) * 1.35), text)
        else:
            (left, _), (_, height) = next(box for box in group[0].boxes if box[1][1] > RISEN)
            yield shapes.Words((float(left) - 0.001, float(height)), text, "end")


def _near(part: Sequence[Ratios]) -> list[list[Ratios]]:
    """The curves, from the highest, in groups that cannot be told apart."""
    numbers: list[int] = []
    last = 0.0
    for row in part:
        here = float(row.middle)
        numbers.append(numbers[-1] + (last > NEAR * here) if numbers else 0)
        last = here
    pairs = zip(numbers, part, strict=True)
    return [[row for _, row in group] for _, group in groupby(pairs, key=lambda pair: pair[0])]
