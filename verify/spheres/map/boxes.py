"""The verdicts on boxes of a plane of scenes, many at once; each depends on its box alone."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Any

import numpy as np

from verify.language.record import Record
from verify.spheres.flow.law import Pair, State
from verify.spheres.map.branches import Step, advance, begin, is_empty, take, together
from verify.spheres.map.closing import collapsing
from verify.spheres.map.intervals import Array, Intervals, enclosed
from verify.spheres.map.models import Models, from_bounds, one_model, parameter
from verify.spheres.map.planes import Phi, Plane, start, views
from verify.spheres.map.strip import BorderStrip, height

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


def sides(plane: Plane, keys: Sequence[str]) -> tuple[Intervals, Intervals]:
    """The boxes of one level."""
    columns, rows = corners(keys)
    level = len(keys[0])
    return side(plane.x, columns, level), side(plane.y, rows, level)


class BoxNumbers(Record):
    """A kind of numbers for boxes.

    They are made of intervals that one of the two parameters runs over, or of which nothing else is
    known, and of a constant.
    """

    parameter: Callable[[int, Intervals], Any]
    flat: Callable[[Intervals], Any]
    number: Callable[[Fraction], Any]
    spread: Callable[[Any, int], Any]


def _spread(x: Intervals, size: int) -> Intervals:
    return Intervals(np.broadcast_to(x.low, size), np.broadcast_to(x.high, size))


def _spread_model(x: Models, size: int) -> Models:
    c, e = np.broadcast_to(x.c, (6, size)), np.broadcast_to(x.e, size)
    return Models(c, e, _spread(x.bounds, size))


INTERVALS = BoxNumbers(lambda _, x: x, lambda x: x, enclosed, _spread)
MODELS = BoxNumbers(parameter, from_bounds, lambda value: one_model(enclosed(value)), _spread_model)
#: Branches that are shown to collapse, of states with their boxes, and the numbers of each.
Closing = Callable[[State, Array], tuple[Array, Array]]


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

    def take_step(self, step: Step, owners: Array) -> tuple[State, Array]:
        """The branches after a collision that still matter, and whose they are."""
        self.disperse[owners[step.ends]] = True
        self.unclear[owners[step.unclear]] = True
        parts = []
        for places, after in step.states:
            keep = self.open()[owners[places]] & ~is_empty(after)
            parts.append((owners[places][keep], take(after, keep)))
        found = np.concatenate([own for own, _ in parts])
        self.branches += np.maximum(np.bincount(found, minlength=len(self.branches)) - 1, 0)
        self.unclear |= self.branches > MAX_BRANCHES
        return together([after for _, after in parts]), found

    def verdicts(self) -> Verdicts:
        """The letters."""
        good = self.open() & (self.collapse | self.disperse)
        names = np.where(good, np.where(self.collapse, COLLAPSES, DISPERSES), UNDECIDED)
        numbers = [n if c == COLLAPSES else [] for n, c in zip(self.numbers, names, strict=True)]
        return Verdicts("".join(names.tolist()), numbers)


def verdicts(plane: Plane | BorderStrip, keys: Sequence[str]) -> Verdicts:
    """What becomes of all scenes of each box: the boxes are of one level.

    A plane through a scene is tried in intervals first, and then with Taylor models.
    """
    if isinstance(plane, BorderStrip):
        return verdicts_of(MODELS, plane, keys)
    found = verdicts_of(INTERVALS, plane, keys)
    if isinstance(plane, Phi):
        return found
    left = [i for i, letter in enumerate(found.letters) if letter == UNDECIDED]
    if not left:
        return found
    more = verdicts_of(MODELS, plane, [keys[i] for i in left])
    letters, numbers = list(found.letters), found.numbers
    for i, letter, sixes in zip(left, more.letters, more.numbers, strict=True):
        letters[i], numbers[i] = letter, sixes
    return Verdicts("".join(letters), numbers)


def verdicts_of(
    kind: BoxNumbers,
    plane: Plane | BorderStrip,
    keys: Sequence[str],
    closing: Closing | None = None,
) -> Verdicts:
    """The verdicts that one kind of numbers shows."""
    with np.errstate(all="ignore"):
        phi: Plane = plane.phi if isinstance(plane, BorderStrip) else plane
        if isinstance(plane, BorderStrip):
            x, y = tiles(kind, plane, keys)
        else:
            x, y = map(kind.parameter, (0, 1), sides(plane, keys))
        if isinstance(phi, Phi):
            state = _whole(kind, start(phi, x, y, kind.number, lambda x: x.root()), len(keys))
            return follow(phi.r, kind, state, np.arange(len(keys)), closing=closing)
        scenes, pairs = views(phi, x, y, kind.number)
        scenes = [_whole(kind, view, len(keys)) for view in scenes]
        pairs = [Pair(*(kind.spread(x, len(keys)) for x in pair)) for pair in pairs]
        boxes = _Boxes(len(keys))
        step = begin(kind.number(phi.r), scenes, pairs)
        return follow(phi.r, kind, *boxes.take_step(step, np.arange(len(keys))), boxes, closing)


def tiles(kind: BoxNumbers, plane: BorderStrip, keys: Sequence[str]) -> tuple[Any, Any]:
    """φ1 and φ2 on the tiles of a strip."""
    columns, rows = corners(keys)
    below = len(keys[0]) - plane.level
    parts, share = 2**plane.level, Fraction(1, 2**below)
    half = (plane.x[1] - plane.x[0]) / parts / 2
    bands = plane.bands

    def each(values: Sequence[Fraction]) -> Any:
        found = {value: enclosed(value) for value in {*values}}
        ends = [found[value] for value in values]
        low, high = (np.array([getattr(x, name) for x in ends]) for name in ("low", "high"))
        return kind.flat(Intervals(low, high))

    def between(lows: Sequence[Fraction], highs: Sequence[Fraction]) -> Intervals:
        return Intervals(each(lows).low, each(highs).high)

    places = [column >> below for column in columns]
    rest = [(column & (1 << below) - 1) * share for column in columns]
    t = kind.parameter(
        0,
        between([half * (2 * x - 1) for x in rest], [half * (2 * (x + share) - 1) for x in rest]),
    )
    band = [bands[row >> below] for row in rows]
    lift = [(row & (1 << below) - 1) * share for row in rows]
    u = kind.parameter(
        1,
        between(
            [a + (b - a) * x for (a, b), x in zip(band, lift, strict=True)],
            [a + (b - a) * (x + share) for (a, b), x in zip(band, lift, strict=True)],
        ),
    )
    f_0, f_1, f_2 = (each([plane.curve[i][k] for i in places]) for k in range(3))
    up = [plane.is_above(row >> below) for row in rows]
    delta = each([plane.delta if above else -plane.delta for above in up])
    goal = each([plane.y[1] if above else Fraction(0) for above in up])
    phi_1 = t + each([plane.x[0] + half * (2 * i + 1) for i in places])
    return phi_1, height(f_0 + t * (f_1 + t * f_2), u, delta, goal)


def _whole(kind: BoxNumbers, state: State, size: int) -> State:
    return State(*(x if isinstance(x, int) else kind.spread(x, size) for x in state))


def follow(
    r: Fraction,
    kind: BoxNumbers,
    state: State,
    owners: Array,
    boxes: _Boxes | None = None,
    closing: Closing | None = None,
) -> Verdicts:
    """The verdicts on boxes whose branches are in these states."""
    if boxes is None:
        boxes = _Boxes(len(owners))
        boxes.unclear |= ~((state.eps * state.v**2 + 2 * state.C).low > -1)
    number, interval = kind.number(r), enclosed(r)
    for _ in range(MAX_COLLISIONS):
        if not len(owners):
            break
        shown, numbers = closing(state, owners) if closing else collapsing(interval, state)
        boxes.closed(owners[shown], numbers)
        rest = np.ones(len(owners), bool)
        rest[shown] = False
        rest &= boxes.open()[owners]
        state, owners = take(state, rest), owners[rest]
        state, owners = boxes.take_step(advance(number, state), owners)
    boxes.unclear[owners] = True
    return boxes.verdicts()
