"""What becomes of a scene: it is followed until a theorem says so, or the budget is spent."""

from __future__ import annotations

import math
from fractions import Fraction

from verify.language.record import Record
from verify.prover import balls
from verify.spheres.flow.collapse import Collapse, find_collapse, find_line_collapse, start_of
from verify.spheres.flow.exact_events import GRAZING, TRIPLE, Event, what_happens
from verify.spheres.flow.exact_events import SAYS as EVENTS
from verify.spheres.flow.follow import Flow, UnclearError, name_of
from verify.spheres.flow.line import LineRun, follow_line, is_on_a_line
from verify.spheres.flow.sandwich import find_sandwich
from verify.spheres.flow.three_balls import Bodies, find_three_balls, scaled
from verify.spheres.scene.criteria import Criterion, finitely_many
from verify.spheres.scene.scene import HALF, Frame, Scene
from verify.spheres.scene.scene import Bodies as Given

COLLAPSES, DISPERSES, FINITE, UNDECIDED = "collapses", "disperses", "finite", "undecided"
#: Names of reasons; a criterion and what balls leave open have theirs.
APART, BUDGET, FOR_EVER = "apart", "budget", "for-ever"
#: An exact answer, although it is no verdict.
EXACT = (TRIPLE, GRAZING, FOR_EVER)
FIRST_BITS, MAX_BITS = 128, 4096
MAX_COLLISIONS = 1000
#: No more digits of the collapse time can be asked for.
MAX_DIGITS = 200
#: Smaller relative widths of the collapse time are not worth a float.
LEAST_WIDTH = 1e-300
#: More collisions on a line than this cost the flow more digits than they are worth.
LONG_LINE = 200
#: More collisions at one time are no end of them that the law of pairs knows.
MANY_AT_ONCE = 100
#: After n collisions the sharper theorem is tried again n/PATIENCE collisions later.
PATIENCE = 16


class Budget(Record):
    """How far a scene is followed, and how many digits of the collapse time are asked for."""

    collisions: int = MAX_COLLISIONS
    digits: int | None = None
    bits: int = FIRST_BITS
    max_bits: int = MAX_BITS


class Fate(Record):
    """The verdict on a scene with its evidence: the flow, and what ends it.

    ``reason`` is for people; ``why`` is its name, where neither a collapse nor a criterion has one.
    """

    verdict: str
    reason: str
    flow: Flow
    collapse: Collapse | None = None
    criterion: Criterion | None = None
    line: LineRun | None = None
    why: str = ""
    event: Event | None = None

    @property
    def name(self) -> str:
        """The name of what shows the verdict, or of why there is none."""
        if self.collapse is not None:
            return self.collapse.theorem
        return self.why if self.criterion is None else self.criterion.name

    @property
    def collisions(self) -> int:
        """How many collisions are certain."""
        return len(self.flow.collisions) if self.line is None else self.line.collisions


def decide_scene(scene: Scene, budget: Budget = Budget()) -> Fate:  # noqa: B008
    """The verdict; where equal spheres touch at once, as the law for any spheres says it."""
    found = _decide(scene, budget)
    if scene.bodies is not None or found.why != TRIPLE:
        return found
    equal = Given((scene.mass,) * 3, (HALF,) * 3)
    more = _decide(scene._replace(bodies=equal), budget)
    return more if more.collisions > found.collisions else found


def _decide(scene: Scene, budget: Budget) -> Fate:
    """The verdict; the precision is doubled until balls decide every step, or it is spent."""
    bits = max(budget.bits, 64 + 4 * (budget.digits or 0))
    while True:
        found = at_precision(scene, budget, bits)
        if not (found.verdict == UNDECIDED or (found.collapse and found.reason)) or found.event:
            return found
        is_last = len(found.flow.collisions) >= budget.collisions or bits >= budget.max_bits
        line = on_a_line(found, budget)
        if is_last or (line is not None and line.collisions > LONG_LINE):
            return line or found
        bits *= 2


def on_a_line(found: Fate, budget: Budget) -> Fate | None:
    """More about spheres on a line, where the flow itself has become unclear."""
    with balls.precision(found.flow.bits):
        is_open = found.collapse is None
        line = follow_line(found.flow, budget.collisions) if is_open else None
        criterion = None if line is None else finitely_many(found.flow)
    if line is None:
        return None
    if line.repeats:
        reason = "on this line collisions go on for ever, with the same ratios of speeds"
        return found._replace(reason=reason, why=FOR_EVER)
    if line.collisions <= found.collisions:
        return None
    if line.ends:
        return Fate(DISPERSES, "no pair meets any more", found.flow, line=line, why=APART)
    reason = spent(budget)
    verdict = UNDECIDED if criterion is None else FINITE
    return Fate(verdict, reason, found.flow, None, criterion, line, BUDGET)


def at_precision(scene: Scene, budget: Budget, bits: int) -> Fate:
    """The verdict as far as balls of one precision show it."""
    with balls.precision(bits):
        return follow(Flow(scene, bits), budget)


def follow(flow: Flow, budget: Budget) -> Fate:
    """The verdict as far as balls of the current precision show it, from the start of a flow."""
    known: Fate | None = None
    wait = found_at = 0
    event: Event | None = None
    try:
        while True:
            end = None
            if flow.now is not None and wait <= 0:
                end = find_end(flow)
                wait = len(flow.collisions) // PATIENCE
            if end is not None:
                known, found_at = Fate(COLLAPSES, "", flow, end), len(flow.collisions)
                if is_tight(end, budget.digits):
                    return known
                wait = more_collisions(end, budget.digits)
            if len(flow.collisions) >= budget.collisions:
                break
            if not flow.advance():
                return Fate(DISPERSES, "no pair meets any more", flow, why=APART)
            wait -= 1
        reason, why = spent(budget), BUDGET
        event = None if known else in_no_time(flow)
        criterion = None if known or event else finitely_many(flow)
    except UnclearError as error:
        reason, why, criterion = str(error), error.name, None
        event = None if known else what_happens(flow)
    if known is not None:
        return _at_last(known._replace(reason=reason), found_at, budget.digits)
    if event is not None:
        return Fate(UNDECIDED, told_event(event), flow, why=event.name, event=event)
    verdict = UNDECIDED if criterion is None else FINITE
    return Fate(verdict, reason, flow, None, criterion, None, why)


def in_no_time(flow: Flow) -> Event | None:
    """Three spheres in contact if many collisions were at that time; those are forgotten."""
    count = 0
    for move in reversed(flow.collisions):
        count += 1
        time = None if move.way is None or move.weights is None else move.way.T
        if time is None or time != 0:
            break
    if count <= MANY_AT_ONCE or flow.now is None:
        return None
    names = sorted(name_of(move.before.frame) for move in flow.collisions[-2:])
    event = Event(TRIPLE, (names[0], names[1]), flow.now.time)
    flow.end_after(len(flow.collisions) - count)
    return event


def spent(budget: Budget) -> str:
    """Why there is no verdict after so many collisions."""
    return f"budget: {budget.collisions} collisions were followed, as --collisions says"


def told_event(event: Event) -> str:
    """What happens exactly, in words."""
    return EVENTS[event.name].format(*event.pairs)


def find_end(flow: Flow) -> Collapse | None:
    """Why the spheres collapse, as the moment after the last collision shows it."""
    try:
        return _end_after(flow)
    except OverflowError:  # what is looked for with floats is beyond their range
        return None


def _end_after(flow: Flow) -> Collapse | None:
    now, scene = flow.now, flow.scene
    if now is None:
        return None
    o, s, c = now.frame
    r, is_one = scene.restitution(o, c), scene.restitution(o, c) == scene.restitution(o, s)
    if flow.is_on_a_line is None:
        flow.is_on_a_line = is_on_a_line(flow.scene)
    if flow.is_on_a_line and is_one:  # the theorem on a line is about one r
        sizes, other = flow.sizes(now.frame), flow.sizes((o, c, s))
        return find_line_collapse(r, now.state, now.time, sizes, other)
    if scene.bodies is not None:  # the others are about diameters that are 1
        bodies = bodies_of(scene, scene.bodies, now.frame)
        start = scaled(start_of(now.state, flow.sizes(now.frame)), bodies.contacts)
        return find_three_balls(bodies, start, now.time)
    if r == 1:
        return None
    found = find_collapse(r, now.state, now.time)
    return find_sandwich(r, now.state, now.time) if found is None else found


def bodies_of(scene: Scene, given: Given, frame: Frame) -> Bodies:
    """Masses, distances of contact and restitutions as the theorem on three balls names them."""
    o, s, c = frame
    mass, radius = given.masses, given.radii
    contacts = (radius[o] + radius[c], radius[o] + radius[s])
    both = scene.restitution(o, c), scene.restitution(o, s)
    return Bodies(mass[o], (mass[c], mass[s]), contacts, radius[c] + radius[s], both)


def _at_last(known: Fate, found_at: int, digits: int | None) -> Fate:
    """A collapse as the last state shows it, or else the one after so many collisions."""
    flow = known.flow
    end = find_end(flow)
    if end is None:
        flow.end_after(found_at)
        return known
    return known._replace(collapse=end, reason="" if is_tight(end, digits) else known.reason)


def more_collisions(end: Collapse, digits: int | None) -> int:
    """About how many collisions later the enclosures may be tight enough."""
    low, high = end.time
    width = max(balls.as_float((high - low) / high), LEAST_WIDTH)
    missing = math.log(width) + (digits or 0) * math.log(10)
    return max(1, int(missing / -math.log(end.ratio)) - 1)


def is_tight(end: Collapse, digits: int | None) -> bool:
    """Whether the enclosures of time and angle have so many digits."""
    if digits is None:
        return True
    low, high = end.time
    width = balls.fmpq_of(Fraction(1, 10**digits))
    angle = end.angle[1] - end.angle[0]
    return bool(high - low <= width * low) and angle <= Fraction(1, 10**digits)
