"""The plane of the parameters, cut into cells, and each cell judged as a whole.

The sides of a cell are intervals of s = r^(1/3) and of c = -cos theta_0. In s both thresholds are
smooth down to r = 0: the stability threshold is 2s(1+s)/(1+s^3), that of existence is
4 s^(3/2)/(1+s^3).
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from functools import cache
from typing import NamedTuple

from verify.prover import balls
from verify.paper.hypotheses import hypotheses
from verify.views.plots.constructions import as_formulas, definitions
from verify.views.plots.field import Cell, Field, Slots, Values, bisected
from verify.views.plots.slopes import BITS, Side
from verify.prover.ground import PROVED, REFUTED, UNDECIDED, Ends
from verify.paper.groups import REPAIRED
from verify.language.terms import Claim, symbol

#: Just beyond (3-√5)/2 = 0.38196…, the cube root of r_stabi = 9-4√5.
WIDTH = Fraction(49, 128)

INPUTS = ("s", "c")
CUBE = ("r", symbol("s") ** 3)

#: All of them: r up to just beyond r_stabi, any angle.
PLANE: Cell = ((Fraction(0), WIDTH), (Fraction(0), Fraction(1)))

#: An interval of the first coordinate, and an enclosure of the second one on it.
Box = tuple[Side, Ends]


class Judged(NamedTuple):
    """A cell where the hypothesis ``stability`` was ``proved``, or left ``undecided``.

    ``verdicts`` has a verdict for each row, for all points of the cell at once, and ``size`` an
    enclosure of the repaired eta_bar, where all wanted rows are decided; ``weight`` is the cell's
    area in the plane as drawn, in units of the smallest cell.
    """

    cell: Cell
    admissible: str
    verdicts: dict[str, str]
    size: Ends | None
    weight: int


@cache
def stability() -> Claim:
    """The hypothesis that the construction needs."""
    return next(row.claim for row in hypotheses() if row.name == "hypotheses.stability")


def judge(
    group: str,
    share: Fraction,
    claims: dict[str, Claim],
    wanted: Iterable[str],
    depth: int,
) -> list[Judged]:
    """Cut the plane until every wanted row is decided on each cell, at most ``depth`` times a side.

    Cells on which the hypothesis is refuted are left out. A verdict on a cell holds on its
    halves, so only what is undecided is asked again.
    """
    field = Field(INPUTS, (CUBE, *definitions(as_formulas(group, share))))
    slots = field.slots(claims)
    gate = field.slots({"stability": stability()})["stability"]
    asked = set(wanted)
    eta_bar = symbol(f"{group}.eta_bar")
    found: list[Judged] = []
    todo = [Judged(PLANE, UNDECIDED, {}, None, 4**depth)]
    with balls.precision(BITS):
        while todo:
            before = todo.pop()
            values = field.on(before.cell)
            now = _judged(values, gate, slots, before)
            if now.admissible == REFUTED:
                continue
            clear = now.admissible == PROVED and UNDECIDED not in map(now.verdicts.get, asked)
            if clear or now.weight == 1:
                size = values[eta_bar] if group == REPAIRED and clear else None
                found.append(now._replace(size=None if size is None else balls.ends(size.range)))
                continue
            for half in bisected(now.cell, 0):
                quarters = bisected(half, 1)
                todo += (now._replace(cell=part, weight=now.weight // 4) for part in quarters)
    return sorted(found, key=lambda judged: judged.cell)


def _judged(values: Values, gate: Slots, slots: Mapping[str, Slots], before: Judged) -> Judged:
    """What is undecided so far, asked on the cell; the rest is known from a larger cell."""
    admissible = before.admissible
    if admissible == UNDECIDED:
        admissible = values.judge(gate)
    verdicts = dict(before.verdicts)
    if admissible == PROVED:
        for name, slot in slots.items():
            if verdicts.get(name, UNDECIDED) == UNDECIDED:
                verdicts[name] = values.judge(slot)
    return before._replace(admissible=admissible, verdicts=verdicts)


@cache
def thresholds(cells: int) -> dict[str, list[Box]]:
    """Enclosures of the two thresholds of c over intervals of s: boxes that contain the curves."""
    s = symbol("s")
    root = symbol("q")  # q = s^(1/2), so that the second one is rational too
    curves = {
        "stability": (2 * s * (1 + s) / (1 + s**3), "s", WIDTH),
        "existence": (4 * root**3 / (1 + root**6), "q", Fraction(619, 1000)),
    }
    result: dict[str, list[Box]] = {}
    with balls.precision(BITS):
        for name, (term, letter, end) in curves.items():
            field = Field((letter,), ())
            boxes: list[Box] = []
            count = cells if letter == "s" else 2 * cells
            for index in range(count):
                side = (end * index / count, end * (index + 1) / count)
                slope = field.on((side,))[term]
                if slope is not None:
                    power = 1 if letter == "s" else 2
                    boxes.append(((side[0] ** power, side[1] ** power), balls.ends(slope.range)))
            result[name] = boxes
    return result


def share_of(cells: Sequence[Judged], name: str, verdict: str) -> Fraction:
    """The share of the surely admissible cells, by area as drawn, with a verdict on a row."""
    inside = [judged for judged in cells if judged.admissible == PROVED]
    total = sum(judged.weight for judged in inside)
    part = sum(judged.weight for judged in inside if judged.verdicts[name] == verdict)
    return Fraction(part, total) if total else Fraction(0)
