"""Groups of balls that never meet again: each moves as if it were alone.

A group of the mass M has its centre of mass at X + tW, R² = Σ m|x|² and e² = Σ m|v|² about it; as
collisions never raise e, R is at most R + te after the time t, and a ball of mass m is no further
from the centre than c(R + te), where c² = (M - m)/(mM). So two groups never meet, at least not
before one of them collapses, if |X + tW| > A + tB for all t >= 0, where A adds up the largest of
radius + cR in each, and B the largest ce.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from verify.language.record import Record
from verify.prover import balls
from verify.spheres.flow.law import Number
from verify.spheres.many.isolation import is_apart
from verify.spheres.many.motion import ZERO, Motion
from verify.spheres.many.queue import Queue
from verify.spheres.scene.scene import inner_product

MOST = 3


class Cloud(Record):
    """A group: its centre, the velocity of that, and within which distance its balls are."""

    x: list[Number]
    v: list[Number]
    reach: Number
    growth: Number


def find_groups(queue: Queue, time: Number) -> list[list[int]] | None:
    """Groups of at most three balls that never meet; None if none are found.

    At the time all balls are in free flight.
    """
    of = {k: [k] for k in range(queue.motion.system.number)}
    for first, second in (event.members for event in queue.apart_from(())):
        if of[first] is not of[second] and not _join(of, of[first], of[second]):
            return None
    found: dict[int, Cloud] = {}
    waiting = [group for k, group in of.items() if group[0] == k]
    while waiting:
        group = waiting.pop()
        cloud = _cloud(queue.motion, group, time)
        # Single balls that meet have been joined.
        near = (k for k, one in found.items()
                if len(group) + len(of[k]) > 2 and not _are_apart(cloud, one))  # fmt: skip
        other = next(near, -1)
        if other < 0:
            found[group[0]] = cloud
        elif not _join(of, group, of[other]):
            return None
        else:
            del found[other]
            waiting.append(of[other])
    return [of[k] for k in sorted(found)]


def _join(of: dict[int, list[int]], one: list[int], two: list[int]) -> bool:
    """Whether two groups are few enough together; if so, they are one afterwards."""
    joined = sorted(one + two)
    of |= dict.fromkeys(joined, joined)
    return len(joined) <= MOST


def _are_apart(one: Cloud, two: Cloud) -> bool:
    """True only if two groups never meet."""
    x = [b - a for a, b in zip(one.x, two.x, strict=True)]
    w = [b - a for a, b in zip(one.v, two.v, strict=True)]
    return is_apart(x, w, one.reach + two.reach, one.growth + two.growth, None)


def _cloud(motion: Motion, group: Sequence[int], time: Number) -> Cloud:
    """A group at a time."""
    system, now = motion.system, [motion.at(k, time) for k in group]
    masses = [system.masses[k] for k in group]
    total = sum(masses, Fraction(0))
    parts = [balls.fmpq_of(mass / total) for mass in masses]
    x, v = ([inner_product(parts, row) for row in zip(*rows, strict=True)]
            for rows in ([b.x for b in now], [b.v for b in now]))  # fmt: skip
    if len(group) == 1:
        return Cloud(x, v, balls.fmpq_of(system.radii[group[0]]), ZERO)
    size, speed = (
        _root_above(sum((balls.fmpq_of(m) * _square(row, centre)
                         for m, row in zip(masses, rows, strict=True)), ZERO))
        for rows, centre in (([b.x for b in now], x), ([b.v for b in now], v))
    )  # fmt: skip
    lever = [_root_above(balls.fmpq_of((total - m) / (m * total))) for m in masses]
    reach = [balls.fmpq_of(system.radii[k]) + c * size for k, c in zip(group, lever, strict=True)]
    return Cloud(x, v, _largest(reach), _largest([c * speed for c in lever]))


def _square(row: Sequence[Number], centre: Sequence[Number]) -> Number:
    difference = [a - b for a, b in zip(row, centre, strict=True)]
    return inner_product(difference, difference)


def _root_above(value: Number) -> Number:
    """The root of a number that is not negative, or a little more."""
    most = balls.as_ball(value).upper()
    return balls.root(most).upper() if most > 0 else ZERO


def _largest(numbers: Sequence[Number]) -> Number:
    found = numbers[0]
    for number in numbers[1:]:
        found = balls.larger(found, number)
    return found
