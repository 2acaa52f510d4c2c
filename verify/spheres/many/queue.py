"""Which contact comes next: all that are foreseen, in the order of lower bounds of their times.

Contacts whose order is not certain may come at once if no ball takes part in two of them and all
pairs of different ones stay apart meanwhile: then the order makes no difference.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Iterator, Sequence
from fractions import Fraction
from functools import reduce
from heapq import heappop, heappush
from itertools import combinations, product

from verify.language.record import Record
from verify.prover import balls
from verify.spheres.flow.exact_events import GRAZING, TRIPLE
from verify.spheres.flow.follow import (
    GRAZE,
    NEAR_GRAZING,
    NEAR_TRIPLE,
    UNCLEAR,
    UnclearError,
    never_meets,
)
from verify.spheres.flow.law import Number, Pair
from verify.spheres.many.motion import ZERO, Approach, Ball, Motion, Shift
from verify.spheres.many.nearby import FEW, FOR_EVER, Nearby
from verify.spheres.many.system import name_of
from verify.spheres.scene.scene import inner_product

#: Of the radius of the smallest ball: what is less certain of a place in a box is not used.
CERTAIN = 1e-11
#: The share of its smallest period that two of few balls fly in a box before contacts are sought
#: anew.
PART = 0.5


class Event(Record):
    """A contact that is foreseen: of two balls, or of a ball and a wall, which then is -1 - wall.

    ``stamps`` says how many contacts the balls have had before. Where ``unclear`` is not empty,
    it is not certain that there is a contact, and if so the time is a lower bound.
    """

    time: Number
    who: tuple[int, int]
    shift: Shift
    stamps: tuple[int, int]
    unclear: str = ""
    name: str = ""

    @property
    def is_bounce(self) -> bool:
        """Whether it is of a ball and a wall."""
        return self.who[1] < 0

    @property
    def members(self) -> tuple[int, ...]:
        """The balls."""
        return self.who[:1] if self.is_bounce else self.who

    @property
    def says(self) -> str:
        """The pair as it is written: 3-12, or 3-wall0."""
        i, j = self.who
        return f"{i}-wall{-1 - j}" if self.is_bounce else name_of(i, j)


class Doubt(Record):
    """A contact that may be: not before this time; why it is unclear, and the name of that."""

    wait: Number
    why: str
    name: str


class Queue:
    """The contacts that are foreseen from the motion as it is."""

    def __init__(self, motion: Motion) -> None:
        self.motion, self.serial = motion, 0
        self.heap: list[tuple[float, int, Event]] = []
        self.stamps = [0] * motion.system.number
        self.nearby = Nearby(motion)
        self.certain = float(min(motion.system.radii)) * CERTAIN if motion.box else 0.0
        #: In a box all contacts before this time are foreseen.
        self.limit: Number = None
        #: The limits before this one; all contacts before the earlier of them have been.
        self.begun = 0.0, 0.0
        #: About when that happened which was looked at last.
        self.when: Number = ZERO
        self.renew()

    # --- what is foreseen -------------------------------------------------------------------------

    def renew(self) -> None:
        """Afterwards contacts are foreseen anew; in a box up to a later limit."""
        count = self.motion.system.number
        self.heap.clear()
        if self.motion.box:
            speeds = zip(*(v for _, _, v in self.nearby.ways), strict=True)
            fastest = max(max(row) - min(row) for row in speeds)
            part = PART / max(1.0, math.sqrt(count / FEW))  # so that few of many are near
            wait = part * min(self.nearby.sides) / fastest if fastest > 0 else 1
            start = ZERO if self.limit is None else self.limit
            self.begun = self.begun[1], below(start)
            self.limit = start + balls.fmpq_of(Fraction(f"{wait:.3g}"))
        for i in range(count):
            for j in self._others(i):
                if i < j:
                    self._foresee(i, j, None)
            self._foresee_walls(i, None)

    def after(self, events: Sequence[Event]) -> None:
        """Afterwards what comes after these contacts is foreseen, and nothing that was before.

        Raises:
            UnclearError: if another ball may touch one of theirs at that time.
        """
        for event in events:
            for i in event.members:
                self.stamps[i] += 1
                self.nearby.moved(i)
                if self.motion.box:
                    self._check_certain(i)
        done: set[tuple[int, int]] = set()
        for event in events:
            for i in event.members:
                for j in self._others(i):
                    pair = (min(i, j), max(i, j))
                    if pair not in done:
                        done.add(pair)
                        self._foresee(*pair, event)
                self._foresee_walls(i, event)

    def _others(self, i: int) -> Iterable[int]:
        """The balls that may touch this one up to the limit, and some more."""
        return self.nearby.others(i, FOR_EVER if self.limit is None else balls.as_float(self.limit))

    def _check_certain(self, i: int) -> None:
        ball, least = self.motion.balls[i], self.certain
        limit = balls.as_float(self.limit - ball.time)
        for row, size in ((ball.x, 1.0), (ball.v, max(limit, 0.0))):
            if not all(float(balls.as_ball(a).rad()) * size <= least for a in row):
                raise UnclearError(f"the place of ball {i} is not known well enough")

    def _foresee(self, i: int, j: int, met: Event | None) -> list[Event]:
        """Afterwards the contacts of two balls are foreseen, which are given back."""
        found = []
        motion, (one, two) = self.motion, (self.motion.balls[k].time for k in (i, j))
        time = two if one < two else one
        for shift in self._shifts(i, j, time):
            pair = motion.pair(i, j, time, shift)
            if met is not None and met.who != (i, j):
                off = met.time - time
                _check_off(pair.g + off * (2 * pair.p + off * pair.m), met, (i, j))
            found += self._add(meeting(pair), time, (i, j), shift)
        return found

    def _shifts(self, i: int, j: int, time: Number) -> Iterator[Shift]:
        """The images that may touch up to the limit."""
        if not self.motion.box:
            yield ()
            return
        start, end = max(balls.as_float(time), self.begun[0]), balls.as_float(self.limit)
        yield from self.nearby.images(i, j, (start, max(end, start)), 0.0)

    def _foresee_walls(self, i: int, met: Event | None) -> None:
        for wall in range(len(self.motion.normals)):
            who, time = (i, -1 - wall), self.motion.balls[i].time
            way = self.motion.approach(i, wall, time)
            if met is not None and met.who != who:
                off = met.time - time
                _check_off(way.gap + off * (way.rate + off * way.fall / 2), met, who)
            self._add(arrival(way, touches=met is not None and met.who == who), time, who, ())

    def _add(self, wait: Number | Doubt | None, time: Number, who: tuple[int, int],
             shift: Shift) -> list[Event]:  # fmt: skip
        if wait is None:
            return []
        stamps = (self.stamps[who[0]], 0 if who[1] < 0 else self.stamps[who[1]])
        unclear, name = "", ""
        if isinstance(wait, Doubt):
            wait, unclear, name = wait
        if not balls.as_ball(wait).is_finite():
            wait, unclear, name = ZERO, "meet at an unknown time", UNCLEAR
        found = [Event(time + wait, who, shift, stamps, unclear, name)]
        self.put_back(found)
        return found

    # --- what comes next --------------------------------------------------------------------------

    def is_valid(self, event: Event) -> bool:
        """Whether none of its balls has had another contact meanwhile."""
        i, j = event.who
        return event.stamps == (self.stamps[i], 0 if j < 0 else self.stamps[j])

    def first(self) -> list[Event]:
        """The next contact, or some whose order makes no difference; none if there is none.

        In a box none means: none before the limit.

        Raises:
            UnclearError: naming two contacts whose order is not certain.
        """
        found = self._nearest()
        self.when = found[0].time if found else self.when
        if not found or (self.limit is not None and not all(e.time < self.limit for e in found)):
            self.put_back(found)
            return []
        for event in found:
            if event.unclear:
                raise UnclearError(f"{event.says} {event.unclear}", event.name)
        for one, two in combinations(found, 2):
            if {*one.members} & {*two.members}:
                names = " and ".join(sorted((one.says, two.says)))
                if balls.is_same(one.time, two.time):
                    raise UnclearError(f"{names} touch at once", TRIPLE)
                raise UnclearError(f"{names} meet at the same time, or too nearly so", NEAR_TRIPLE)
        return found

    def _nearest(self) -> list[Event]:
        """A contact before which there is none, with all that are not certainly later, and so on.

        They are taken out.
        """
        taken: list[Event] = []
        group: list[Event] = []
        end = math.inf
        while self._due(end):
            event = heappop(self.heap)[2]
            if not self.is_valid(event):
                continue
            taken.append(event)
            group = _first_group(taken)
            end = max(above(one.time) for one in group)
        self.put_back(event for event in taken if not any(event is one for one in group))
        return group

    def _due(self, end: float) -> bool:
        """Whether a contact may be up to a time; if so, that which may be first is on top."""
        while True:
            first = self.heap[0][0] if self.heap else math.inf
            pair = self.nearby.due(min(first, end))
            if pair is None:
                return first <= end and bool(self.heap)
            self._foresee(*pair, None)

    def put_back(self, events: Iterable[Event]) -> None:
        """Afterwards these are foreseen, too."""
        for event in events:
            self.serial += 1
            heappush(self.heap, (below(event.time), self.serial, event))

    def apart_from(self, members: Collection[int], end: float = FOR_EVER) -> Iterator[Event]:
        """The contacts foreseen in which none of these balls takes part, up to a time at least."""
        found = [event for _, _, event in self.heap]
        while True:
            for event in found:
                if self.is_valid(event) and not {*event.members} & {*members}:
                    yield event
            pair = self.nearby.due(end)
            if pair is None:
                return
            found = self._foresee(*pair, None)


def _check_off(gap: Number, met: Event, who: tuple[int, int]) -> None:
    """Afterwards it is certain that these are not in contact when others meet.

    Raises:
        UnclearError: if that is not certain.
    """
    if gap > 0:
        return
    names = met.says, met._replace(who=who).says
    if balls.is_same(gap, ZERO):
        raise UnclearError("{} and {} touch at once".format(*names), TRIPLE)
    raise UnclearError("{} meets, and {} may touch then".format(*names), NEAR_TRIPLE)


def check_apart(motion: Motion, before: dict[int, Ball], events: Sequence[Event]) -> None:
    """Afterwards it is certain that contacts at nearly the same time do not touch one another.

    The motion is that after all of them; ``before`` has the balls as they were.

    Raises:
        UnclearError: if that is not certain.
    """
    time = reduce(balls.hull, (balls.as_ball(event.time) for event in events))
    paths = {k: _path(motion, (ball, motion.balls[k]), time) for k, ball in before.items()}
    spans = {k: _spans(motion, k, path) for k, path in paths.items()}
    for one, two in combinations(events, 2):
        for i, j in product(one.members, two.members):
            both = zip(spans[i], spans[j], strict=True)
            if any(a[1] < b[0] or b[1] < a[0] for a, b in both):
                continue
            difference = [b - a for a, b in zip(paths[i], paths[j], strict=True)]
            square = balls.fmpq_of(motion.system.contact(i, j) ** 2)
            for place in near_images(motion, difference):
                if not inner_product(place, place) > square:
                    raise UnclearError(
                        f"{one.says} and {two.says} meet at the same time, and {name_of(i, j)} may "
                        "touch then", NEAR_TRIPLE,
                    )  # fmt: skip


def _path(motion: Motion, ways: tuple[Ball, Ball], time: Number) -> list[Number]:
    """Where a ball is at all these times, before and after its contact."""
    gravity = motion.gravity or [ZERO] * motion.system.dimension
    before, after = (
        [
            balls.as_ball(a + wait * (b + wait * g / 2))
            for a, b, g in zip(way.x, way.v, gravity, strict=True)
        ]
        for way, wait in ((way, time - way.time) for way in ways)
    )
    return [balls.hull(a, b) for a, b in zip(before, after, strict=True)]


def _spans(motion: Motion, i: int, path: Sequence[Number]) -> list[tuple[float, float]]:
    """Between which floats all of a ball is in each coordinate; nothing is said in a box."""
    if motion.box:
        return [(-math.inf, math.inf)] * len(path)
    radius = balls.fmpq_of(motion.system.radii[i])
    return [(below(a - radius), above(a + radius)) for a in path]


def near_images(motion: Motion, difference: Sequence[Number]) -> Iterator[list[Number]]:
    """A difference of places, or those of the nearest images in each direction."""
    choices = [[a] for a in difference]
    for k, side in enumerate(motion.box):
        a = difference[k]
        n = math.floor(balls.as_float(a) / balls.as_float(side))
        choices[k] = [a - n * side, a - (n + 1) * side]
    yield from map(list, product(*choices))


def _first_group(events: Sequence[Event]) -> list[Event]:
    first = reduce(lambda a, b: b if b.time < a.time else a, events)
    group, rest = [first], [event for event in events if event is not first]
    while True:
        later = [all(one.time < event.time for one in group) for event in rest]
        if all(later):
            return group
        group += [event for event, is_later in zip(rest, later, strict=True) if not is_later]
        rest = [event for event, is_later in zip(rest, later, strict=True) if is_later]


def meeting(pair: Pair) -> Number | Doubt | None:
    """After which time the pair collides; None if it never does."""
    g, p, m = pair
    if never_meets(pair):
        return None
    if not (g >= 0 and p < 0):
        most = balls.as_ball(p).abs_upper()
        soonest = g / (2 * most) if g > 0 and most > 0 else ZERO  # as g + 2pt + mt² >= g - 2|p|t
        return Doubt(soonest, "may approach or part", UNCLEAR)
    below_root = p * p - m * g
    if below_root > 0:
        return g / (balls.any_root(below_root) - p)
    if balls.is_same(below_root, ZERO):
        return Doubt(g / -p, "touch and neither approach nor part", GRAZING)
    most = balls.as_ball(below_root).upper()
    return Doubt(g / (balls.root(most) - p), GRAZE, NEAR_GRAZING)


def arrival(way: Approach, *, touches: bool = False) -> Number | Doubt | None:
    """After which time the ball meets the wall, again if it has just met it; None if never."""
    gap, rate, fall = way
    if fall >= 0:
        if rate >= 0:
            return None
        below_root = rate * rate - 2 * fall * gap
        if below_root < 0:
            return None
        if not (gap >= 0 and rate < 0):
            return Doubt(ZERO, "may approach or part", UNCLEAR)
        if below_root > 0:
            return 2 * gap / (balls.any_root(below_root) - rate)
        if balls.is_same(below_root, ZERO):
            return Doubt(gap / -rate, "touch and neither approach nor part", GRAZING)
        return Doubt(gap / -rate, GRAZE, NEAR_GRAZING)
    if touches and rate > 0:
        return (rate + balls.any_root(rate * rate - 2 * fall * gap)) / -fall
    if not gap >= 0 or (not gap > 0 and not rate < 0 and not rate > 0):
        return Doubt(ZERO, "may be in contact and at rest", UNCLEAR)
    root = balls.any_root(rate * rate - 2 * fall * gap)
    return 2 * gap / (root - rate) if rate < 0 else (rate + root) / -fall


def below(value: Number) -> float:
    """A float that is no larger."""
    found = float(balls.as_ball(value).lower())
    return math.nextafter(math.nextafter(found, -math.inf), -math.inf)


def above(value: Number) -> float:
    """A float that is no smaller."""
    return -below(-value)
