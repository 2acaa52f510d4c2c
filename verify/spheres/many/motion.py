"""Where the balls are, and how they move between contacts and in them.

Each ball has a straight way since its last contact, or a parabola: where it is, or would be, on
that at an exact time close to the contact. What is not known of the time of a contact so enters the
ways after it only times the change of velocity there, which is small where balls collapse. Numbers
are exact rationals while these are short, and balls of arithmetic around the true ones elsewhere.
Under gravity all balls fall alike, so that pairs move as without it.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from functools import reduce
from operator import add

from verify.language.record import Record
from verify.prover import balls
from verify.spheres.flow.law import Number, Pair
from verify.spheres.many.system import System

Vector = Sequence[Number]
#: Whole numbers of periods that are added to a difference; empty without a box.
Shift = tuple[int, ...]
ZERO = balls.exact(Fraction(0))


class Ball(Record):
    """The way of a ball since its last contact: where it is at an exact time, with its velocity."""

    time: Number
    x: Vector
    v: Vector


class Approach(Record):
    """A ball and a wall: the distance times |n|, its rate, and the acceleration along n."""

    gap: Number
    rate: Number
    fall: Number


def inner(x: Vector, z: Vector) -> Number:
    """The inner product."""
    return reduce(add, (a * b for a, b in zip(x, z, strict=True)))


class Motion:
    """The balls of a system."""

    def __init__(self, system: System, bits: int) -> None:
        self.system, self.bits = system, bits
        rows = zip(system.positions, system.velocities, strict=True)
        self.balls = [
            Ball(ZERO, [balls.exact(a) for a in x], [balls.exact(a) for a in v]) for x, v in rows
        ]
        self.gravity = [balls.exact(g) for g in system.gravity]
        self.box = [balls.exact(side) for side in system.box]
        self.normals = [[balls.exact(a) for a in wall.normal] for wall in system.walls]
        self.norms = [balls.any_root(inner(n, n)) for n in self.normals]

    def short(self, value: Number) -> Number:
        """A rational number stays one while it is short."""
        return balls.shortened(value, self.bits)

    def at(self, i: int, time: Number) -> Ball:
        """The ball in free flight at another time."""
        start, x, v = self.balls[i]
        wait = time - start
        if wait == 0:
            return self.balls[i]
        place = [a + wait * b for a, b in zip(x, v, strict=True)]
        if self.gravity:
            half = wait * wait / 2
            place = [a + half * g for a, g in zip(place, self.gravity, strict=True)]
            v = [b + wait * g for b, g in zip(v, self.gravity, strict=True)]
        return Ball(time, [self.short(a) for a in place], [self.short(b) for b in v])

    def difference(self, one: Ball, two: Ball, shift: Shift) -> tuple[Vector, Vector]:
        """The place and the velocity of the second ball, or of an image, seen from the first."""
        x = [b - a for a, b in zip(one.x, two.x, strict=True)]
        if shift:
            x = [a + n * side for a, n, side in zip(x, shift, self.box, strict=True)]
        return x, [b - a for a, b in zip(one.v, two.v, strict=True)]

    def pair(self, i: int, j: int, time: Number, shift: Shift) -> Pair:
        """The two balls at a time; at the time 0 of the pair, in the words of the law."""
        x, w = self.difference(self.at(i, time), self.at(j, time), shift)
        square = balls.exact(self.system.contact(i, j) ** 2)
        return Pair(inner(x, x) - square, inner(x, w), inner(w, w))

    def approach(self, i: int, wall: int, time: Number) -> Approach:
        """How a ball moves towards a wall."""
        ball, n, level = self.at(i, time), self.normals[wall], self.system.walls[wall].level
        reach = balls.exact(self.system.radii[i]) * self.norms[wall]
        gap = inner(n, ball.x) - balls.exact(level) - reach
        fall = inner(n, self.gravity) if self.gravity else ZERO
        return Approach(gap, inner(n, ball.v), fall)

    def collide(self, i: int, j: int, time: Number, shift: Shift) -> Number:
        """Afterwards both balls have collided; the normal speed just before is given back."""
        system, one, two = self.system, self.at(i, time), self.at(j, time)
        x, w = self.difference(one, two, shift)
        reach = balls.exact(system.contact(i, j))
        push = -inner(x, w) / (reach * reach)
        whole, total = 1 + system.restitution(i, j), system.masses[i] + system.masses[j]
        for k, other, sign in ((i, j, -1), (j, i, 1)):
            part = push * balls.exact(sign * whole * system.masses[other] / total)
            self._change(k, time, [part * a for a in x])
        return push * reach

    def bounce(self, i: int, wall: int, time: Number) -> Number:
        """Afterwards the ball has met the wall; the normal speed just before is given back."""
        n, norm = self.normals[wall], self.norms[wall]
        speed = -inner(n, self.at(i, time).v) / norm
        part = speed * balls.exact(1 + self.system.walls[wall].r) / norm
        self._change(i, time, [part * a for a in n])
        return speed

    def _change(self, i: int, time: Number, change: Vector) -> None:
        """Afterwards the velocity of a ball has changed at a time."""
        near = time if balls.is_rational(self.short(time)) else balls.middle(balls.as_ball(time))
        _, x, v = self.at(i, near)
        off = time - near
        x = [self.short(a - off * b) for a, b in zip(x, change, strict=True)]
        self.balls[i] = Ball(near, x, [self.short(a + b) for a, b in zip(v, change, strict=True)])
