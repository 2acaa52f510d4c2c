"""What comes after a collapse: the velocities to which those of the spheres tend, and what then.

In the limit the pairs that collided in turn neither approach nor part. If their relative velocities
do not vanish, the spheres part at once; on a line all three have the same velocity.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from verify.language.record import Record
from verify.prover import balls
from verify.spheres.flow.collapse import Collapse
from verify.spheres.flow.follow import Moment, never_meets
from verify.spheres.flow.law import Number
from verify.spheres.scene.decide import MAX_DIGITS, Budget, Fate, decide_scene
from verify.spheres.scene.energy import energy_lost, later_speeds, masses_of
from verify.spheres.scene.scene import Coordinates, Frame, pair_name
from verify.spheres.scene.trajectory import Ends, shares, trajectory
from verify.spheres.scene.verdict import ball_ends, time_ends

#: How the spheres move on: on a line together, for ever apart, two meet again, or nobody knows.
TOGETHER, APART, MEET, UNKNOWN = "together", "apart", "meet", "unknown"
#: How many digits the velocities have where no others are asked for.
DIGITS = 6


class Afterwards(Record):
    """Enclosures of the velocities at the collapse, and of the energy that all collisions take.

    ``then`` says what happens if the spheres move on with these: ``pair`` names those that meet
    again, and ``wait`` encloses how long after the collapse they do.
    """

    velocities: Sequence[Sequence[Ends]]
    energy: Ends
    then: str
    pair: str = ""
    wait: Ends | None = None

    @property
    def width(self) -> Fraction:
        """The width of the widest enclosure of a velocity."""
        widths = [high - low for row in self.velocities for low, high in row]
        return max(widths, default=Fraction(0))

    @property
    def spread(self) -> Fraction:
        """No more than the largest difference of two velocities, in one coordinate; or 0."""
        columns = zip(*self.velocities, strict=True)
        found: list[Fraction] = [
            max(low for low, _ in c) - min(high for _, high in c) for c in columns
        ]
        return max(Fraction(0), *found)


def afterwards(found: Fate, budget: Budget | None) -> Afterwards | None:
    """What comes after a collapse; None without one.

    The velocities have as many digits as are asked for, in proportion to the largest difference of
    two: more collisions are followed for them than the theorem needs, as far as the budget goes.
    Without a budget they are as the theorem's first state shows them.
    """
    if budget is None:
        return _at_the_end(found)
    known, digits = _at_the_end(found), DIGITS if budget.digits is None else 2 * budget.digits
    needed, tried = Fraction(1, 10 ** (budget.digits or DIGITS)), 0
    while known is not None and known.width > needed * known.spread and tried < MAX_DIGITS:
        tried = digits = min(digits, MAX_DIGITS)
        more = _at_the_end(decide_scene(found.flow.scene, budget._replace(digits=digits)))
        if more is None or more.width >= known.width:  # the budget is spent
            break
        known, digits = more, 2 * digits
    return known


def collisions_until(found: Fate, cutoff: Fraction, budget: Budget) -> tuple[int, int] | None:
    """The least number of collisions after which less time than the cutoff is left to a collapse.

    It is between two numbers; None without a collapse, or if the budget does not suffice.
    """
    start, digits = (Fraction(0), Fraction(0)), 0
    while (whole := time_ends(found)) is not None and digits < MAX_DIGITS:
        low, high = whole
        if high >= cutoff * 10**MAX_DIGITS:  # no scene is followed to so many digits
            return None
        times = [start, *(ball_ends(m.after.time, found.flow.bits) for m in found.flow.collisions)]
        least = next((n for n, (_, late) in enumerate(times) if low - late < cutoff), None)
        most = next((n for n, (early, _) in enumerate(times) if high - early < cutoff), None)
        if least is not None and most is not None:
            return least, most
        digits = min(max(digits + 8, len(str(int(high / cutoff))) + 3), MAX_DIGITS)
        found = decide_scene(found.flow.scene, budget._replace(digits=digits))
    return None


def _at_the_end(found: Fate) -> Afterwards | None:
    end, now = found.collapse, found.flow.now
    if end is None or now is None:
        return None
    if found.flow.is_on_a_line:
        return Afterwards(_of_the_centre(found), energy_lost(found), TOGETHER)
    *_, last = trajectory(found)
    bits = found.flow.bits
    with balls.precision(bits):
        x, v = _limits(found, end, now, last.particles)
        at_end = Coordinates(x, v, found.flow.start.squares)
        velocities = [[ball_ends(number, bits) for number in row] for row in v]
        return Afterwards(velocities, energy_lost(found), *_what_then(at_end, now.frame, bits))


def _of_the_centre(found: Fate) -> Sequence[Sequence[Ends]]:
    """The velocity of the centre of mass, for each sphere."""
    masses, rows = masses_of(found.flow.scene), found.flow.scene.velocities
    columns = zip(*rows, strict=True)
    sums = (sum(m * v for m, v in zip(masses, c, strict=True)) for c in columns)
    mean = [total / sum(masses) for total in sums]
    return [[(value, value) for value in mean]] * len(rows)


def _limits(
    found: Fate, end: Collapse, last: Moment, particles: Sequence[Sequence[Ends]]
) -> tuple[list[list[Number]], list[list[Number]]]:
    """Centres and velocities at the collapse, from those just after the last collision."""
    o, s, c = last.frame
    speeds, fall = later_speeds(found.flow.r, end)
    change = [balls.as_ball(balls.fmpq_of(Fraction(0)))] * 3
    for other, speed in zip((c, s), speeds, strict=True):
        for sphere, share in zip((o, other), shares(found.flow.scene, o, other), strict=True):
            change[sphere] += share * speed / (1 - fall)
    wait = balls.hull(*map(balls.as_ball, end.time)) - last.time
    x, v = [], []
    for ends, more in zip(particles, change, strict=True):
        numbers = [balls.hull(*map(balls.from_fraction, pair)) for pair in ends]
        half = len(numbers) // 2
        v.append([number + balls.hull(-more, more) for number in numbers[half:]])
        x.append([a + wait * b for a, b in zip(numbers[:half], v[-1], strict=True)])
    return x, v


def _what_then(at_end: Coordinates, frame: Frame, bits: int) -> tuple[str, str, Ends | None]:
    """How the spheres move on from the collapse, which pair meets again, and after what time.

    The middle one touches both others, at right angles to their relative velocities: where these do
    not vanish, |x + tw|² = σ² + t²|w|², and it parts from them.
    """
    o, s, c = frame
    if not all(at_end.pair(o, other).m > 0 for other in (s, c)):
        return UNKNOWN, "", None
    outer = at_end.pair(s, c)
    if never_meets(outer):
        return APART, "", None
    g, p, m = outer
    discriminant = p * p - m * g
    if not (g > 0 and p < 0 and discriminant > 0):
        return UNKNOWN, pair_name(s, c), None
    return MEET, pair_name(s, c), ball_ends(g / (balls.root(discriminant) - p), bits)
