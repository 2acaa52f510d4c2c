"""The verdicts on boxes of a plane of scenes, many at once; each depends on its box alone."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

import numpy as np

from verify.language.record import Record
from verify.paper.flow.law import State
from verify.paper.map.plane import Phi, start
from verify.prover.map_branches import advance, take, together
from verify.prover.map_closing import NUMBERS, collapsing
from verify.prover.map_intervals import Array, Intervals, enclosed, joined, square_root

COLLAPSES, DISPERSES, UNDECIDED = "c", "d", "u"
#: How far boxes are followed, and how often one is split where spheres may graze.
MAX_COLLISIONS, MAX_BRANCHES = 60, 24


class Verdicts(Record):
    """One letter a box, and for each box the numbers of the branches that collapse."""

    letters: str
    numbers: list[list[tuple[int, ...]]]


def corners(keys: Sequence[str]) -> tuple[list[int], list[int]]:
    """The columns and rows of boxes: a quadkey has one digit a level, x + 2y."""
    columns = [int("".join("01"[int(d) & 1] for d in key) or "0", 2) for key in keys]
    rows = [int("".join("01"[int(d) >> 1] for d in key) or "0", 2) for key in keys]
    return columns, rows


def side(ends: tuple[Fraction, Fraction], places: Sequence[int], level: int) -> Intervals:
    """The part of a side at each place, 2^level parts in all; neighbours overlap."""
    low, width = ends[0], (ends[1] - ends[0]) / 2**level
    grid = {i: enclosed(low + width * i) for place in {*places} for i in (place, place + 1)}
    return Intervals(
        np.array([grid[i].low for i in places]), np.array([grid[i + 1].high for i in places])
    )


def states(plane: Phi, keys: Sequence[str]) -> State:
    """All states of the boxes of one level."""
    columns, rows = corners(keys)
    x, y = (
        side(ends, places, len(keys[0])) for ends, places in ((plane.x, columns), (plane.y, rows))
    )
    found = start(plane, x, y, enclosed, square_root)
    return State(*(x if isinstance(x, int) else _spread(x, len(keys)) for x in found))


def _spread(x: Intervals, size: int) -> Intervals:
    return Intervals(np.broadcast_to(x.low, size), np.broadcast_to(x.high, size))


class _Boxes:
    """What is known of each box: whether some branch collapses, disperses, or is unclear."""

    def __init__(self, size: int) -> None:
        self.collapse, self.disperse, self.unclear = (np.zeros(size, bool) for _ in range(3))
        self.branches = np.ones(size, int)
        self.numbers: list[list[tuple[int, ...]]] = [[] for _ in range(size)]

    def closed(self, boxes: Array, numbers: Array) -> None:
        """Some branches of these boxes collapse."""
        self.collapse[boxes] = True
        for box, column in zip(boxes.tolist(), numbers.T.astype(int).tolist(), strict=True):
            self.numbers[box].append(tuple(column))

    def open(self) -> Array:
        """Whether a box may still get a verdict."""
        return ~self.unclear & ~(self.collapse & self.disperse)

    def verdicts(self) -> Verdicts:
        """The letters."""
        good = self.open() & (self.collapse | self.disperse)
        names = np.where(good, np.where(self.collapse, COLLAPSES, DISPERSES), UNDECIDED)
        numbers = [n if c == COLLAPSES else [] for n, c in zip(self.numbers, names, strict=True)]
        return Verdicts("".join(names.tolist()), numbers)


def verdicts(plane: Phi, keys: Sequence[str]) -> Verdicts:
    """What becomes of all scenes of each box: the boxes are of one level."""
    r = enclosed(plane.r)
    with np.errstate(all="ignore"):
        state, owners = states(plane, keys), np.arange(len(keys))
        boxes = _Boxes(len(keys))
        boxes.unclear |= ~_separate(state)
        for _ in range(MAX_COLLISIONS):
            state, owners = _one_step(r, state, owners, boxes)
            if not len(owners):
                break
        boxes.unclear[owners] = True
    return boxes.verdicts()


def _separate(state: State) -> Array:
    """Whether s and c are apart at the start."""
    gap = (state.eps + state.sig) * state.v**2 + 2 * state.C
    return gap.low > -1


def _one_step(r: Intervals, state: State, owners: Array, boxes: _Boxes) -> tuple[State, Array]:
    """Close the branches that collapse, and advance the others."""
    shown, numbers = collapsing(r, state)
    boxes.closed(owners[shown], numbers)
    rest = np.ones(len(owners), bool)
    rest[shown] = False
    rest &= boxes.open()[owners]
    state, owners = take(state, rest), owners[rest]
    step = advance(r, state)
    boxes.disperse[owners[step.ends]] = True
    boxes.unclear[owners[step.unclear]] = True
    parts = []
    for places, after in step.states:
        keep = boxes.open()[owners[places]]
        parts.append((owners[places][keep], take(after, keep)))
    found = np.concatenate([own for own, _ in parts])
    boxes.branches += np.maximum(np.bincount(found, minlength=len(boxes.branches)) - 1, 0)
    boxes.unclear |= boxes.branches > MAX_BRANCHES
    return together([after for _, after in parts]), found


__all__ = ["COLLAPSES", "DISPERSES", "NUMBERS", "UNDECIDED", "Verdicts", "joined", "verdicts"]
