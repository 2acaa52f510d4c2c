"""Where the balls are, and how they move between contacts and in them.

Each ball has a straight way since its last contact, or a parabola: where it is, or would be, on
that at an exact time close to a collision, or at the time of a bounce. What is not known of the
time of a collision so enters the ways after it only times the change of velocity there, which is
small where balls collapse. Numbers are exact rationals while these are short, and balls of
arithmetic around the true ones elsewhere. Under gravity all balls fall alike, so that pairs move as
without it.
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
from verify.spheres.scene.scene import inner_product

Vector = Sequence[Number]
#: Whole numbers of periods that are added to a difference; empty without a box.
Shift = tuple[int, ...]
ZERO = balls.fmpq_of(Fraction(0))


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


class Motion:
    """The balls of a system."""

    def __init__(self, system: System, bits: int) -> None:
        self.system, self.bits = system, bits
        rows = zip(system.positions, system.velocities, strict=True)
        self.balls = [
            Ball(ZERO, [balls.fmpq_of(a) for a in x], [balls.fmpq_of(a) for a in v])
            for x, v in rows
        ]
        #: Of a ball that has met a wall last: that wall, and the rate at which it left.
        self.on: dict[int, tuple[int, Number]] = {}
        self.gravity = [balls.fmpq_of(g) for g in system.gravity]
        self.box = [balls.fmpq_of(side) for side in system.box]
        self.normals = [[balls.fmpq_of(a) for a in wall.normal] for wall in system.walls]
        self.norms = [balls.any_root(inner_product(n, n)) for n in self.normals]

    def short(self, value: Number) -> Number:
        """A rational number stays one while it is short."""
        return balls.shortened(value, self.bits)

    def at(self, i: int, time: Number) -> Ball:
        """The ball in free flight at another time."""
        start, x, v = self.balls[i]
        wait = time - start
        if time is start or wait == 0:
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
        square = balls.fmpq_of(self.system.contact(i, j) ** 2)
        return Pair(inner_product(x, x) - square, inner_product(x, w), inner_product(w, w))

    def approach(self, i: int, wall: int, time: Number) -> Approach:
        """How a ball moves towards a wall."""
        fall = inner_product(self.normals[wall], self.gravity) if self.gravity else ZERO
        if time is self.balls[i].time and self.on.get(i, (None, None))[0] == wall:
            return Approach(ZERO, self.on[i][1], fall)
        ball, n, level = self.at(i, time), self.normals[wall], self.system.walls[wall].level
        reach = balls.fmpq_of(self.system.radii[i]) * self.norms[wall]
        gap = inner_product(n, ball.x) - balls.fmpq_of(level) - reach
        return Approach(gap, inner_product(n, ball.v), fall)

    def collide(self, i: int, j: int, time: Number, shift: Shift) -> Number:
        """Afterwards both balls have collided; the normal speed just before is given back."""
        system, one, two = self.system, self.at(i, time), self.at(j, time)
        x, w = self.difference(one, two, shift)
        reach = balls.fmpq_of(system.contact(i, j))
        push = -inner_product(x, w) / (reach * reach)
        whole, total = 1 + system.restitution(i, j), system.masses[i] + system.masses[j]
        for k, other, sign in ((i, j, -1), (j, i, 1)):
            part = push * balls.fmpq_of(sign * whole * system.masses[other] / total)
            self._change(k, time, [part * a for a in x])
        return push * reach

    def bounce(self, i: int, wall: int, time: Number) -> Number:
        """Afterwards the ball has met the wall; the normal speed just before is given back.

        That follows from the energy of the flight, so that it is not less certain than at the start
        of the flight. What changes along the normal is known without the time.
        """
        n, norm, fixed = self.normals[wall], self.norms[wall], self.system.walls[wall]
        way, ball = self.approach(i, wall, self.balls[i].time), self.at(i, time)
        energy = way.rate * way.rate - 2 * way.fall * way.gap
        rate = balls.any_root(energy) if way.fall != 0 else -way.rate
        after = rate * balls.fmpq_of(fixed.r)
        reach = balls.fmpq_of(fixed.level) + balls.fmpq_of(self.system.radii[i]) * norm
        x, v = (
            [self.short(b + a * height / norm**2) for a, b in zip(n, flat, strict=True)]
            for flat, height in (
                (self._flat(wall, ball.x), reach),
                (self._flat(wall, ball.v), after),
            )
        )
        self.balls[i], self.on[i] = Ball(time, x, v), (wall, after)
        return rate / norm

    def _flat(self, wall: int, row: Vector) -> Vector:
        """The part of a vector along a wall; a part that is 0 for any vector is exactly 0."""
        n = self.system.walls[wall].normal
        square = sum((a * a for a in n), Fraction(0))
        found = []
        for k, a in enumerate(n):
            parts = [(balls.fmpq_of((k == j) - a * b / square), row[j]) for j, b in enumerate(n)]
            found.append(reduce(add, (part * x for part, x in parts if part != 0), ZERO))
        return found

    def _change(self, i: int, time: Number, change: Vector) -> None:
        """Afterwards the velocity of a ball has changed at a time."""
        near = time if balls.is_rational(self.short(time)) else balls.middle(balls.as_ball(time))
        _, x, v = self.at(i, near)
        off = time - near
        x = [self.short(a - off * b) for a, b in zip(x, change, strict=True)]
        self.on.pop(i, None)
        self.balls[i] = Ball(near, x, [self.short(a + b) for a, b in zip(v, change, strict=True)])
