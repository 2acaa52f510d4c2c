"""Which entry of the min that bounds eta_bar is the least, over the region."""

from __future__ import annotations

from collections import Counter
from fractions import Fraction
from functools import cache
from typing import Any

from verify.prover import balls
from verify.views.plots.constructions import as_formulas, definitions
from verify.views.plots.drawing import COLOURS, Panel, boxes, merged
from verify.views.plots.field import Cell, Field, Values, bisected
from verify.views.plots.figure import Figure
from verify.views.plots.plane import CUBE, INPUTS, PLANE, stability
from verify.views.plots.region import frame
from verify.views.plots.slopes import BITS
from verify.prover.ground import PROVED, REFUTED, UNDECIDED
from verify.paper.groups import PRINTED, REPAIRED
from verify.language.terms import Term

DEPTH = 6

#: The colour of each entry; the third one is the usual answer.
SHADES = ("series-2", "series-4", "proved-area", "series-1", "series-6", "series-7", "series-5")


@cache
def least_entries(group: str) -> list[tuple[Cell, int | None]]:
    """The cells of the region, each with the entry that is the least at every point, if one is."""
    statement = as_formulas(group, Fraction(1))
    field = Field(INPUTS, (CUBE, *definitions(statement)))
    bound = next(c.term for c in statement.constants if c.name == f"{group}.eta_bar")
    gate = field.slots({"stability": stability()})["stability"]
    found: list[tuple[Cell, int | None]] = []
    todo: list[tuple[Cell, int]] = [(PLANE, 0)]
    with balls.precision(BITS):
        while todo:
            cell, level = todo.pop()
            values = field.on(cell)
            admissible = values.judge(gate)
            if admissible == REFUTED:
                continue
            least = _least(values, bound) if admissible == PROVED else None
            if least is None and level < DEPTH:
                for half in bisected(cell, 0):
                    todo += [(quarter, level + 1) for quarter in bisected(half, 1)]
            else:
                found.append((cell, least))
    return sorted(found, key=lambda pair: pair[0])


def _least(values: Values, bound: Term) -> int | None:
    """The entry that is at most each other one; where two may be equal there is none."""
    entries = [values[entry] for entry in bound.children]
    if any(entry is None for entry in entries):
        return None
    known = [entry for entry in entries if entry is not None]
    index = min(range(len(known)), key=lambda i: float(known[i].centre.mid()))
    for other, entry in enumerate(known):
        difference = values.apply("sub", entry, known[index])
        if other != index and (difference is None or balls.sign(difference.range) != 1):
            return None
    return index


def figure() -> Figure:
    """Both sets side by side."""
    captions = []
    for group in (PRINTED, REPAIRED):
        cells = least_entries(group)
        counts = Counter(index for _, index in cells)
        parts = ", ".join(
            f"entry {index + 1} on {counts[index]} cells"
            for index in sorted(i for i in counts if i is not None)
        )
        captions.append(f"{group}: {parts}, undecided on {counts[None]}")
    return Figure(
        "minimum",
        "Which entry of η̄ is the smallest",
        "On each coloured cell one entry of the min that defines or bounds η̄ is at most each other "
        f"one at every point of the cell ({'; '.join(captions)}). Grey: two entries cross there, "
        "or the cell is too wide to tell.",
        (
            Panel("As printed", lambda axis: _draw(axis, PRINTED), 400, 330),
            Panel("Repaired", lambda axis: _draw(axis, REPAIRED), 400, 330),
        ),
    )


def _draw(axis: Any, group: str) -> None:
    cells = least_entries(group)
    for index in [None, *sorted({i for _, i in cells if i is not None})]:
        part = merged((*cell[0], *cell[1]) for cell, least in cells if least == index)
        if index is None:
            boxes(axis, part, "undecided", name=UNDECIDED)
        else:
            boxes(axis, part, SHADES[index], name=f"entry {index + 1}")
    frame(axis, labels=False)
    axis.legend(loc="lower right", labelcolor=COLOURS["ink"])
