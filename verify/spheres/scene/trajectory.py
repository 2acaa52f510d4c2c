"""Where the spheres of a scene are, and how fast they move, at its collisions."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction

from verify.language.record import Record
from verify.prover import balls
from verify.spheres.flow.follow import name_of
from verify.spheres.flow.law import Number
from verify.spheres.scene.decide import Fate
from verify.spheres.scene.energy import masses_of, normal_speeds
from verify.spheres.scene.scene import Scene
from verify.spheres.scene.verdict import ball_ends

Ends = tuple[Fraction, Fraction]
Rows = list[list[Number]]


class Instant(Record):
    """The start or the moment just after a collision: enclosures for each particle.

    Of a particle these are its coordinates, and then those of its velocity.
    """

    pair: str
    time: Ends
    particles: Sequence[Sequence[Ends]]


def trajectory(found: Fate) -> Iterator[Instant]:
    """The start, and the moments just after the collisions that were followed.

    The flow itself needs inner products only; here the same collisions are applied to centres and
    velocities. Every number is a ball around the true one.
    """
    flow, bits = found.flow, found.flow.bits
    x: Rows = [list(row) for row in flow.start.x]
    v: Rows = [list(row) for row in flow.start.v]
    time: Number = balls.fmpq_of(Fraction(0))
    yield _instant("", time, x, v, bits)
    for move, speed in zip(flow.collisions, normal_speeds(found), strict=True):
        with balls.precision(bits):
            wait, time = move.after.time - time, move.after.time
            x = [[_short(a + wait * b, bits) for a, b in zip(*row, strict=True)]
                 for row in zip(x, v, strict=True)]  # fmt: skip
            o, _, c = move.before.frame
            parts = shares(flow.scene, o, c)
            push = speed / balls.fmpq_of(flow.scene.contact(o, c))
            for k, (a, b) in enumerate(zip(x[o], x[c], strict=True)):
                v[o][k] = _short(v[o][k] - parts[0] * push * (b - a), bits)
                v[c][k] = _short(v[c][k] + parts[1] * push * (b - a), bits)
        yield _instant(name_of(move.before.frame), time, x, v, bits)


def shares(scene: Scene, o: int, c: int) -> tuple[Number, Number]:
    """The changes of both velocities in a collision, per normal speed."""
    masses, whole = masses_of(scene), 1 + scene.restitution(o, c)
    total = masses[o] + masses[c]
    return balls.fmpq_of(whole * masses[c] / total), balls.fmpq_of(whole * masses[o] / total)


def _short(value: Number, bits: int) -> Number:
    return balls.shortened(value, bits)


def _instant(pair: str, time: Number, x: Rows, v: Rows, bits: int) -> Instant:
    particles = [
        [ball_ends(number, bits) for number in (*place, *speed)]
        for place, speed in zip(x, v, strict=True)
    ]
    return Instant(pair, ball_ends(time, bits), particles)
