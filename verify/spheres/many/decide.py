"""What becomes of many balls: they are followed until a theorem, a time or a budget ends the run.

Nothing here has a certificate: contacts and their order are decided in balls of arithmetic, and so
is that nobody else is near three balls that collapse. For these three there is a scene, which has.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from fractions import Fraction

from verify.language.record import Record
from verify.prover import balls
from verify.prover.decimals import short
from verify.spheres.flow.collapse import Collapse
from verify.spheres.flow.exact_events import GRAZING, TRIPLE
from verify.spheres.flow.follow import UNCLEAR, Flow, UnclearError
from verify.spheres.flow.law import Number
from verify.spheres.many.groups import find_groups
from verify.spheres.many.isolation import (
    exact_time,
    find_between,
    find_rest,
    find_three,
    nearest,
    scene_of,
)
from verify.spheres.many.motion import ZERO, Motion, Shift
from verify.spheres.many.queue import Doubt, Event, Queue, check_apart, meeting
from verify.spheres.many.system import System
from verify.spheres.scene.decide import (
    APART,
    BUDGET,
    COLLAPSES,
    DISPERSES,
    FINITE,
    UNDECIDED,
    Budget,
    decide_scene,
    follow,
)
from verify.spheres.scene.scene import Scene
from verify.spheres.scene.verdict import Impact, ball_ends

FOLLOWED, RESTS = "followed", "rests"
#: Names of reasons: a time was reached, balls fell into groups, the bounces of one accumulate, on
#: a wall or between it and another ball.
UNTIL, GROUPS, BOUNCES, BETWEEN = "until", "groups", "bounces", "wall-and-ball"
#: After so many collisions, and after twice as many each time, groups are looked for.
FIRST_GROUPS = 8
#: So many spans of time without a collision in a box are enough.
EMPTY = 1000
#: Digits of a scene of three beyond its smallest distance, and how often more are tried.
DIGITS, MORE_DIGITS = 15, 4

Ends = tuple[Fraction, Fraction]


class Ending(Record):
    """What ended a run; ``why`` is a name, which ``says`` tells.

    ``contacts`` are the collisions before: pairs, times and normal speeds, with so many bits.
    ``members`` are three balls that collapse, the middle one first, or one that comes to rest on a
    wall; ``time`` encloses when, or else when that happens which is undecided. ``place`` encloses
    where the first of them is then. ``scene`` has the three at the time ``since``, as decimals.
    """

    verdict: str
    why: str
    says: str
    system: System
    bits: int
    contacts: Sequence[tuple[str, Number, Number]]
    members: tuple[int, ...] = ()
    wall: int | None = None
    time: Ends | None = None
    angle: Ends | None = None
    place: Sequence[Ends] = ()
    since: Fraction | None = None
    scene: Scene | None = None

    def impacts(self) -> Iterator[Impact]:
        """The collisions, in decimals."""
        for name, time, speed in self.contacts:
            yield Impact(name, ball_ends(time, self.bits), ball_ends(speed, self.bits))


def decide_system(
    system: System,
    budget: Budget = Budget(),  # noqa: B008
    until: Fraction | None = None,
    watch: Callable[[Iterable[Event], int], Iterable[Event]] = lambda parts, _: parts,
) -> Ending:
    """What ends the run; the precision is doubled until balls decide each step, or it is spent."""
    bits = budget.bits
    while True:
        with balls.precision(bits):
            found = Run(system, bits, budget, until).ending(watch)
        is_final = found.verdict != UNDECIDED or found.why in (TRIPLE, GRAZING, BUDGET)
        if is_final or 2 * bits > budget.max_bits:
            return found
        bits *= 2


class Run:
    """The balls followed at one precision."""

    def __init__(self, system: System, bits: int, budget: Budget, until: Fraction | None) -> None:
        self.system, self.bits, self.budget = system, bits, budget
        self.until = None if until is None else balls.fmpq_of(until)
        self.motion = Motion(system, bits)
        self.queue = Queue(self.motion)
        self.contacts: list[tuple[str, Number, Number]] = []
        #: Of each ball with which ball or wall it has collided last, and before that with another.
        self.last: list[tuple[int | None, int | None]] = [(None, None)] * system.number
        self.found: Ending | None = None
        self.next_groups = FIRST_GROUPS

    def ending(self, watch: Callable[[Iterable[Event], int], Iterable[Event]]) -> Ending:
        """What ends the run."""
        try:
            for _ in watch(self.steps(), self.budget.collisions):
                pass
        except UnclearError as error:
            when = ball_ends(self.queue.when, self.bits)
            says = f"{error}, at the time {short(when)}"
            return self._end(UNDECIDED, error.name, says)._replace(time=when)
        if self.found is None:
            raise UnclearError("the run has no end", UNCLEAR)
        return self.found

    def steps(self) -> Iterator[Event]:
        """The collisions, until something ends the run, which then is ``found``."""
        empty = 0
        while self.found is None:
            if len(self.contacts) >= self.budget.collisions:
                self.found = self.by_groups() or self._spent("collisions were followed")
                return
            events = self.queue.first()
            if not events and self.queue.limit is None:
                self.found = self._end(DISPERSES, APART, "no two collide any more")
            elif not events:
                empty += 1
                if self.until is not None and self.until < self.queue.limit:
                    self.found = self._end(FOLLOWED, UNTIL, "the time was reached")
                elif empty >= EMPTY:
                    sooner = "--until T" if self.until is None else "a smaller --until"
                    self.found = self._spent("collisions, and then long none", sooner)
                else:
                    self.queue.renew()
            elif self._is_late(events):
                self.found = self._end(FOLLOWED, UNTIL, "the time was reached")
            else:
                empty = 0
                self._take(events)
                yield from events

    def _is_late(self, events: Sequence[Event]) -> bool:
        """Whether they are all after the time that is asked for."""
        if self.until is None or all(event.time <= self.until for event in events):
            return False
        if all(event.time > self.until for event in events):
            return True
        names = " and ".join(event.says for event in events)
        raise UnclearError(f"{names} collide at the time that --until says, or nearly so", UNCLEAR)

    def _take(self, events: Sequence[Event]) -> None:
        """Afterwards these contacts have been, and what they show is found."""
        motion = self.motion
        before = {i: motion.balls[i] for event in events for i in event.members}
        for event in events:
            i, j = event.who
            if event.is_bounce:
                speed = motion.bounce(i, -1 - j, event.time)
            else:
                speed = motion.collide(i, j, event.time, event.shift)
            if not speed > 0:
                raise UnclearError(f"{event.says} may touch without approaching", UNCLEAR)
            self.contacts.append((event.says, event.time, speed))
            for ball, other in ((i, j), (j, i)):
                if ball >= 0 and self.last[ball][0] != other:
                    self.last[ball] = other, self.last[ball][0]
        if len(events) > 1:
            check_apart(motion, before, events)
        self.queue.after(events)
        for event in events:
            self.found = self.found or self._after(event)
        if self.found is None and len(self.contacts) >= self.next_groups:
            self.found, self.next_groups = self.by_groups(), 2 * len(self.contacts)

    def _after(self, event: Event) -> Ending | None:
        """What a contact has ended, if anything."""
        i, j = event.who
        if event.is_bounce:
            return self._rest(i, -1 - j, event.time) or self._between(i, -1 - j, event.time)
        for o, s in ((i, j), (j, i)):
            c = self.last[o][1]
            if c is not None and c >= 0:
                found = self._collapse((o, s, c), event.time)
                if found is not None:
                    return found
        return None

    def _rest(self, ball: int, wall: int, time: Number) -> Ending | None:
        found = find_rest(self.queue, ball, wall, time)
        if found is None:
            return None
        says = f"the bounces of ball {ball} on wall {wall} accumulate"
        end, normal = time + found, self.motion.normals[wall]
        above = self.motion.approach(ball, wall, end).gap / self.motion.norms[wall] ** 2
        x = self.motion.at(ball, end).x  # bounces change the velocity along the normal only
        place = [ball_ends(a - above * n, self.bits) for a, n in zip(x, normal, strict=True)]
        return self._end(RESTS, BOUNCES, says)._replace(
            members=(ball,), wall=wall, time=ball_ends(end, self.bits), place=place
        )

    def _between(self, ball: int, wall: int, time: Number) -> Ending | None:
        other = self.last[ball][1]
        found = None
        if other is not None and other >= 0:
            found = find_between(self.queue, ball, wall, other, time)
        if found is None or other is None:
            return None
        says = f"the balls {ball} and {other} collapse on wall {wall}"
        low, high = (ball_ends(end, self.bits) for end in (time, time + found.later))
        angle = tuple(ball_ends(end, self.bits)[k] for k, end in enumerate(found.cosine))
        return self._end(COLLAPSES, BETWEEN, says)._replace(
            members=(ball, other),
            wall=wall,
            time=(low[0], high[1]),
            angle=(angle[0], angle[1]),
            place=self._place(ball, time, found.later, found.reach[0]),
        )

    def _collapse(self, members: tuple[int, int, int], time: Number) -> Ending | None:
        found = find_three(self.queue, members, time)
        if found is None:
            return None
        later = found.collapse.numbers["E_0"] * found.collapse.start.y
        wait = meeting(self.motion.pair(members[0], members[2], time, found.shifts[1]))
        place = self._place(members[0], time, later, found.reach[0])
        end = self._collapses(members, found.collapse, time, later)._replace(place=place)
        if wait is None or isinstance(wait, Doubt):
            return end
        return self._with_scene(end, found.shifts, exact_time(time, wait))

    def _place(self, ball: int, time: Number, later: Number, reach: Number) -> list[Ends]:
        """Where a ball is at some time from now on, if it may be so far off its way per time."""
        wait = balls.hull(balls.as_ball(0), balls.as_ball(later))
        now, off = self.motion.at(ball, time), reach * later
        wide = balls.hull(balls.as_ball(-off), balls.as_ball(off))
        gravity = self.motion.gravity or [ZERO] * len(now.x)
        return [
            ball_ends(a + wait * (b + wait * g / 2) + wide, self.bits)
            for a, b, g in zip(now.x, now.v, gravity, strict=True)
        ]

    # --- groups -----------------------------------------------------------------------------------

    def by_groups(self) -> Ending | None:
        """What becomes of the balls if they are in groups of at most three that never meet."""
        if not self.system.is_open:
            return None
        time = self._in_flight()
        groups = None if time is None else find_groups(self.queue, time)
        if groups is None or time is None:
            return None
        if any(event.unclear for event in self.queue.apart_from(())):
            return None
        found = [self._of_three(group, time) for group in groups if len(group) == 3]
        verdicts = {one.verdict for one in found}
        if UNDECIDED in verdicts:
            return None
        first = [one for one in found if one.verdict == COLLAPSES]
        if len(first) > 1:
            return None
        if first:
            return first[0]
        verdict = FINITE if FINITE in verdicts else DISPERSES
        return self._end(
            verdict, GROUPS, f"{_counted(groups)} never meet again, each decided alone"
        )

    def _in_flight(self) -> Number | None:
        """A time before the next contact at which all balls are in free flight."""
        now = self.queue.when
        following = self.queue.first()
        self.queue.put_back(following)
        if not following:
            return None
        wait = following[0].time - now
        time = exact_time(now, wait) if wait > 0 else now
        is_between = all(time < event.time for event in following)
        return time if is_between and all(one.time <= time for one in self.motion.balls) else None

    def _of_three(self, members: Sequence[int], time: Number) -> Ending:
        """What becomes of three balls that nobody else meets, from this time on."""
        near = [nearest(self.motion, members[0], k, time) for k in members[1:]]
        scene, given = scene_of(self.motion, members, near, time)
        flow = Flow(scene, self.bits)
        flow.start, flow.is_on_a_line = given, self.system.is_on_a_line
        left = max(self.budget.collisions - len(self.contacts), 0)
        fate = follow(flow, Budget(left, None, self.bits, self.bits))
        if fate.collapse is None or flow.now is None:
            return self._end(fate.verdict, fate.name, fate.reason)
        o, s, c = (members[k] for k in flow.now.frame)
        start, end = fate.collapse.time
        found = self._collapses((o, s, c), fate.collapse, time + start, end - start)
        return self._with_scene(found, [(), ()], time)

    # --- what is told -----------------------------------------------------------------------------

    def _with_scene(self, end: Ending, shifts: Sequence[Shift], time: Number) -> Ending:
        """With a scene of the three as decimals, if that collapses, too."""
        _, given = scene_of(self.motion, end.members, shifts, time)
        gaps = [given.pair(i, j).g for i, j in ((0, 1), (0, 2))]
        if not all(gap > 0 for gap in gaps):
            return end
        places = DIGITS + max(0, *(-balls.exponent(gap) for gap in gaps))
        for more in range(MORE_DIGITS):
            rows = [
                [tuple(balls.fraction_of(balls.decimal(a, places << more)) for a in row)
                 for row in part] for part in (given.x, given.v)
            ]  # fmt: skip
            scene = self.system.three(end.members, *rows)
            fate = decide_scene(scene, self.budget._replace(digits=None))
            now = fate.flow.now
            if fate.verdict == COLLAPSES and now is not None and now.frame[0] == 0:
                return end._replace(scene=scene, since=balls.fraction_of(time))
        return end

    def _spent(self, words: str, remedy: str = "a larger --collisions") -> Ending:
        says = f"budget: {len(self.contacts)} {words}; write {remedy}"
        return self._end(UNDECIDED, BUDGET, says)

    def _end(self, verdict: str, why: str, says: str) -> Ending:
        return Ending(verdict, why, says, self.system, self.bits, self.contacts)

    def _collapses(
        self, members: tuple[int, int, int], found: Collapse, time: Number, later: Number
    ) -> Ending:
        low, high = (ball_ends(end, self.bits) for end in (time, time + later))
        says = "the balls {}, {} and {} collapse".format(*members)
        return self._end(COLLAPSES, found.theorem, says)._replace(
            members=members, time=(low[0], high[1]), angle=found.angle
        )


def _counted(groups: Sequence[Sequence[int]]) -> str:
    """How many groups there are."""
    return f"{len(groups)} groups of at most three balls"
