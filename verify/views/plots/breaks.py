"""The steps that break the printed argument: by how much, over r, and the same steps repaired."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import groupby

from verify.language.statement import BREAKS, PRINTED, REFUTED, REPAIRED
from verify.views.material import Margins, Ratios
from verify.views.plots.shapes import Areas, Figure, Panel, Rule, Scale, Shape, Words, marks, powers

WIDTH, HEIGHT = 440, 380
#: Below this ratio nothing is drawn.
LOW = 0.1
#: A curve that rises into view has its name beside this ratio.
RISEN = Fraction(4, 5)
#: Curves whose names would stand upon each other have one name: their ratios differ by less.
NEAR = 1.2


def figure(found: Margins) -> Figure:
    """One panel: orange above 1, blue below."""
    broken = [row for row in found.printed if row.severity == BREAKS and REFUTED in row.verdicts]
    names = {f"{REPAIRED}.{row.name.removeprefix(f'{PRINTED}.')}" for row in broken}
    repaired = [row for row in found.repaired if row.name in names]
    across = Scale("r", 0, float(found.end), marks("0", "0.01", "0.02", "0.03", "0.04", "0.05"))
    up = Scale("left side / right side", LOW, 1e3, powers(-1, 3), logarithmic=True)
    return Figure(
        "breaks",
        "Where the printed proof breaks, and by how much",
        f"{len(broken)} inequalities of the printed proof, over r at θ₀ = π: the left side "
        "divided by the right side. A step holds where this is at most 1. Orange: as "
        "printed. Blue: the same steps with the repaired constants. Each box contains the ratio at "
        "every r of its interval. A fifth step that breaks has no curve: 0 < 0, in the claim that "
        "the set has interior points.",
        (
            Panel(
                "The steps that break the argument",
                across,
                up,
                lambda: _shapes(broken, repaired),
                "The orange curves of the printed steps lie above the line at 1, two of them "
                "about a hundred times as high; the blue ones of the repaired steps lie below it.",
                WIDTH,
                HEIGHT,
            ),
        ),
    )


def _shapes(broken: Sequence[Ratios], repaired: Sequence[Ratios]) -> Iterator[Shape]:
    yield Rule(1)
    yield Words((0.001, 1.3), "above this line a step fails")
    for part, colour, name in (
        (broken, "refuted", "as printed"),
        (repaired, "proved", "repaired"),
    ):
        for number, row in enumerate(part):
            yield Areas(_boxes(row), colour, 0.9, name if number == 0 else "")
        yield from _names(part)


def _boxes(row: Ratios) -> list[tuple[float, float, float, float]]:
    return [
        (float(left), float(right), float(low), float(high))
        for (left, right), (low, high) in row.boxes
    ]


def _names(part: Sequence[Ratios]) -> Iterator[Words]:
    """A name above each curve, at its left end, or before the end of one that rises into view."""
    for group in _near(part):
        text = ", ".join(row.name.partition(".")[2] for row in group)
        (left, _), (_, height) = group[0].boxes[0]
        if height > LOW:
            yield Words((float(left) + 0.001, float(height) * 1.35), text)
        else:
            (left, _), (_, height) = next(box for box in group[0].boxes if box[1][1] > RISEN)
            yield Words((float(left) - 0.001, float(height)), text, "end")


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
