"""Whether a simulation with many digits confirms what was decided of a scene."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise

import mpmath

from verify.measure.simulation import DIGITS, Impact, simulate
from verify.prover import balls
from verify.spheres.scene.decide import COLLAPSES, DISPERSES, Fate
from verify.spheres.scene.verdict import central, pairs_of, time_ends

#: Collisions of the simulation after the last one that was followed.
MORE = 60


def contradictions(found: Fate, digits: int = DIGITS) -> list[str]:
    """What an independent simulation does not confirm."""
    count = len(found.flow.collisions)
    more = MORE if found.verdict == COLLAPSES else 5
    seen = simulate(found.flow.scene, found.collisions + more, digits)
    wrong = []
    if [collision.pair for collision in seen[:count]] != pairs_of(found):
        wrong.append("the pairs differ")
    for collision, move in zip(seen, found.flow.collisions, strict=False):
        with balls.precision(found.flow.bits):
            if not is_inside(collision.time, balls.ends(balls.as_ball(move.after.time)), digits):
                wrong.append("a time differs")
    if found.verdict == DISPERSES and len(seen) != found.collisions:
        wrong.append("there are more collisions")
    ends, o = time_ends(found), central(found)
    if found.collapse is not None and ends is not None and o is not None:
        rest = seen[count - 1 :]
        turns = pairwise(rest)
        if any(a.pair == b.pair or str(o) not in b.pair for a, b in turns):
            wrong.append("the pairs do not take turns")
        if len(seen) != count + MORE or not is_inside(seen[-1].time, ends, digits):
            wrong.append("the collapse is at another time")
        angle = found.collapse.angle
        if not all(is_inside(neg_cos(c, o, digits), angle, digits) for c in rest):
            wrong.append("the angle is another one")
    return wrong


def neg_cos(collision: Impact, central: int, digits: int) -> object:
    """-cos of the angle at the central particle, at a collision."""
    with mpmath.workdps(digits):
        a, b = (
            [u - v for u, v in zip(place, collision.positions[central], strict=True)]
            for k, place in enumerate(collision.positions)
            if k != central
        )
        return -mpmath.fdot(a, b) / mpmath.sqrt(mpmath.fdot(a, a) * mpmath.fdot(b, b))


def is_inside(value: object, ends: tuple[Fraction, Fraction], digits: int = DIGITS) -> bool:
    """Whether a number is in an interval, up to what so many digits leave open."""
    with mpmath.workdps(digits):
        low, high = (mpmath.mpf(end.numerator) / end.denominator for end in ends)
        slack = mpmath.mpf(10) ** (20 - digits)
        return bool(low - slack <= value <= high + slack)
