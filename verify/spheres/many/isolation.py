"""Three balls that collapse, or one whose bounces accumulate, while no other ball comes near.

Let the theorem on three balls hold for three balls in their state just after a contact, and let it
give them the time T. With the closing speed y of the pair that meets next, and Γ, Y_0, Y_1 of the
theorem, the closing speeds of the two pairs add up to at most H_0 = Γy/(1 - Y_0Y_1) and
H_1 = Y_0 H_0, in units of the contact distances. So the velocity of an outer ball differs from
what it is in free flight by at most D_i = (1+r_i) m/(m+m_i) σ_i H_i, that of the middle one, whose
mass is m, by D = Σ (1+r_i) m_i/(m+m_i) σ_i H_i.

If until T no contact of two other balls, or of one with a wall, is foreseen, and if each other ball
k, and each image, stays apart, |x + tw| > σ + D_i t, and each wall, too, then the three collapse:
before the first contact with another ball, all of them move as they would alone, and at that
contact the distance would be larger than σ.

A ball that falls back to a wall with the speed u along the normal n, and with the acceleration -g,
meets it again after the times 2u/g, 2ur/g, …: all bounces are over after 2u/(g(1-r)). The changes
of its velocity add up to (1+r)u/(1-r), and the same condition says that nothing else meets it.
Other balls that bounce meanwhile are looked at in the same way, with the speeds at which they land.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from itertools import combinations, product

from verify.language.record import Record
from verify.prover import balls
from verify.spheres.flow.collapse import Collapse, start_of
from verify.spheres.flow.law import Number
from verify.spheres.flow.three_balls import Bodies, find_three_balls, scaled
from verify.spheres.flow.wall import Start, WallCollapse, WallPair, find_wall
from verify.spheres.many.motion import ZERO, Approach, Motion, Shift
from verify.spheres.many.queue import Queue, above
from verify.spheres.many.system import System
from verify.spheres.scene.decide import bodies_of
from verify.spheres.scene.scene import Coordinates, Scene, inner_product, sizes_of

#: The middle ball, that which it has met, and that which it meets next, in a scene of the three.
FRAME = (0, 1, 2)


class Three(Record):
    """Three balls, the middle one first, that collapse within the time of the theorem.

    ``shifts`` are those of the other two. ``reach`` is how far each is from its straight way at
    most, divided by the time.
    """

    members: tuple[int, int, int]
    shifts: tuple[Shift, Shift]
    collapse: Collapse
    reach: tuple[Number, Number, Number]


def is_apart(
    x: Sequence[Number], w: Sequence[Number], reach: Number, slope: Number, time: Number | None
) -> bool:
    """True only if |x + tw| > reach + slope·t for all t from 0 to a time; None: for ever."""
    c, b, a = (
        inner_product(x, x) - reach * reach,
        inner_product(x, w) - reach * slope,
        inner_product(w, w) - slope * slope,
    )
    if not c > 0:
        return False
    if b >= 0 and a >= 0:
        return True
    if time is None:
        return bool(a > 0 and b * b < a * c)
    return bool(c + 2 * b * time + a * time * time > 0) and bool(
        b + a * time <= 0 or a <= 0 or b * b < a * c
    )


def nearest(motion: Motion, i: int, j: int, time: Number) -> Shift:
    """The image of the second ball that is about nearest to the first one."""
    x, _ = motion.difference(motion.at(i, time), motion.at(j, time), ())
    return tuple(
        -round(balls.as_float(a) / balls.as_float(side))
        for a, side in zip(x, motion.box, strict=False)
    )


def scene_of(
    motion: Motion, members: Sequence[int], shifts: Sequence[Shift], time: Number
) -> tuple[Scene, Coordinates]:
    """Three balls at a time, seen from the first of them; in the scene they are near that."""
    first = motion.at(members[0], time)
    rows = [([ZERO] * len(first.x), [ZERO] * len(first.x))]
    for k, shift in zip(members[1:], shifts, strict=True):
        x, w = motion.difference(first, motion.at(k, time), shift)
        rows.append((list(x), list(w)))
    x, v = ([row[part] for row in rows] for part in (0, 1))
    near = [[tuple(balls.short_rational(a) for a in row) for row in part] for part in (x, v)]
    scene = motion.system.three(members, *near)
    pairs = combinations(range(3), 2)
    return scene, Coordinates(x, v, [balls.fmpq_of(scene.contact(i, j) ** 2) for i, j in pairs])


def find_three(queue: Queue, members: tuple[int, int, int], time: Number) -> Three | None:
    """Why they collapse: the first has just met the second, and meets the third one next."""
    motion = queue.motion
    shifts = tuple(nearest(motion, members[0], k, time) for k in members[1:])
    scene, given = scene_of(motion, members, shifts, time)
    if scene.bodies is None or not given.pair(0, 2).p < 0:
        return None
    state = given.state(FRAME, lambda _, value: motion.short(value))
    bodies = bodies_of(scene, scene.bodies, FRAME)
    try:
        start = scaled(start_of(state, sizes_of(scene, FRAME, balls.fmpq_of)), bodies.contacts)
        found = find_three_balls(bodies, start, time)
    except OverflowError:  # what is looked for with floats is beyond their range
        return None
    if found is None:
        return None
    reach = impulses(bodies, found)
    later = found.numbers["E_0"] * found.start.y
    if not stays_alone(queue, dict(zip(members, reach, strict=True)), time, later):
        return None
    return Three(members, (shifts[0], shifts[1]), found, reach)


def impulses(bodies: Bodies, found: Collapse) -> tuple[Number, Number, Number]:
    """What the velocities of the middle ball, of that which it has met, and of the next change."""
    x = found.numbers
    first = x["G"] * found.start.y / (1 - x["Y_0"] * x["Y_1"])
    outer, middle = [], ZERO
    for i, speed in enumerate((first, x["Y_0"] * first)):
        push = speed * balls.fmpq_of((1 + bodies.r[i]) * bodies.contacts[i])
        total = bodies.m + bodies.masses[i]
        outer.append(push * balls.fmpq_of(bodies.m / total))
        middle += push * balls.fmpq_of(bodies.masses[i] / total)
    return middle, outer[1], outer[0]


def find_between(
    queue: Queue, ball: int, wall: int, other: int, time: Number
) -> WallCollapse | None:
    """Why a ball that has just met a wall collapses between it and another ball."""
    motion, system = queue.motion, queue.motion.system
    way, shift = motion.approach(ball, wall, time), nearest(motion, ball, other, time)
    if way.fall != 0 or not way.rate > 0:
        return None
    sigma = system.contact(ball, other)
    reach, norm = balls.fmpq_of(sigma), motion.norms[wall]
    x, w = motion.difference(motion.at(ball, time), motion.at(other, time), shift)
    gap = inner_product(x, x) - reach * reach
    if not gap > 0:
        return None
    size = balls.any_root(gap + reach * reach)
    start = Start(
        -inner_product(x, w) / size / reach,
        way.rate / norm / reach,
        gap / (reach * (size + reach)),
        inner_product(w, w) / (reach * reach),
        inner_product(motion.normals[wall], x) / (norm * size),
    )
    try:
        found = find_wall(_pair_of(system, ball, wall, other), start)
    except OverflowError:  # what is looked for with floats is beyond their range
        return None
    if found is None:
        return None
    members = dict(zip((ball, other), found.reach, strict=True))
    alone = stays_alone(queue, members, time, found.later, {ball: wall}, together=True)
    return found if alone else None


def _pair_of(system: System, ball: int, wall: int, other: int) -> WallPair:
    own, next_one = system.masses[ball], system.masses[other]
    r, r_wall = system.restitution(ball, other), system.walls[wall].r
    sigma = system.contact(ball, other)
    return WallPair(
        ((1 + r) * next_one / (own + next_one), 1 + r_wall),
        (r, r_wall),
        (system.radii[other] - system.radii[ball]) / sigma,
        sigma,
        (1 + r) * own / (own + next_one),
    )


def find_rest(queue: Queue, ball: int, wall: int, time: Number) -> Number | None:
    """After which time all bounces of a ball on a wall are over, which it has just met.

    Other balls may bounce meanwhile, too, if each does so on one wall and comes to rest no sooner.
    """
    motion = queue.motion
    way = motion.approach(ball, wall, time)
    if motion.system.walls[wall].r == 1 or not (way.fall < 0 and way.rate > 0):
        return None
    later, reach = _bounces(motion, wall, way.rate, way.fall)
    members, walls = {ball: reach}, {ball: wall}
    for event in queue.apart_from(members, above(time + later)):
        k, own = event.who[0], -1 - event.who[1]
        if time + later < event.time:
            continue
        if not event.is_bounce or event.unclear or k in walls:
            return None
        way, r = motion.approach(k, own, event.time), motion.system.walls[own].r
        if r == 1 or not (way.fall < 0 and way.rate < 0):
            return None
        rest, members[k] = _bounces(motion, own, -way.rate, way.fall)
        walls[k] = own
        if event.time + rest * balls.fmpq_of(r) < time + later:
            return None
    return later if stays_alone(queue, members, time, later, walls, together=False) else None


def _bounces(motion: Motion, wall: int, speed: Number, fall: Number) -> tuple[Number, Number]:
    """How long bounces last that begin at such a speed, and how much they change the velocity."""
    r = motion.system.walls[wall].r
    change = speed * balls.fmpq_of((1 + r) / (1 - r)) / motion.norms[wall]
    return 2 * speed / -fall / balls.fmpq_of(1 - r), change


def stays_alone(
    queue: Queue,
    members: Mapping[int, Number],
    start: Number,
    later: Number,
    on: Mapping[int, int] = {},
    *,
    together: bool = True,
) -> bool:
    """True only if nothing else meets these balls within a time, and no others meet.

    Each ball may be off its way in free flight by so much per time. They meet one another, if they
    are ``together``, and each the wall that ``on`` names.
    """
    motion, end = queue.motion, start + later
    if queue.limit is not None and not end < queue.limit:
        return False
    if not all(end < event.time for event in queue.apart_from(members, above(end))):
        return False
    pairs = [(i, k) for i in members for k in range(motion.system.number) if k not in members]
    slopes = {pair: members[pair[0]] for pair in pairs}
    slopes |= {(i, j): members[i] + members[j] for i, j in combinations(members, 2)}
    # Those that collapse meet one another, but no images of one another.
    meeting = members if together else ()
    near = {k: nearest(motion, next(iter(members)), k, start) for k in meeting}
    first = balls.as_float(start)
    span = first, max(first, balls.as_float(end))
    for (i, j), slope in slopes.items():
        own = tuple(b - a for a, b in zip(near[i], near[j], strict=True)) if j in near else None
        for shift in queue.nearby.images(i, j, span, balls.as_float(slope * later)):
            if shift == own:
                continue
            x, w = motion.difference(motion.at(i, start), motion.at(j, start), shift)
            if not is_apart(x, w, balls.fmpq_of(motion.system.contact(i, j)), slope, later):
                return False
    return all(
        _is_off(motion.approach(i, wall, start), members[i] * motion.norms[wall], later)
        for i, wall in product(members, range(len(motion.normals)))
        if on.get(i) != wall
    )


def _is_off(way: Approach, slope: Number, later: Number) -> bool:
    """True only if a ball that may be off its way by so much per time does not meet the wall."""
    bend = way.fall / 2 if way.fall < 0 else ZERO
    return bool(way.gap > 0) and bool(way.gap + later * (way.rate - slope + later * bend) > 0)


def exact_time(time: Number, wait: Number) -> Number:
    """A decimal about halfway from a time to that later one, and strictly between."""
    part = wait * balls.fmpq_of(Fraction(1, 2))
    return balls.decimal(time + part, 2 - balls.exponent(part))
