"""Three particles as vectors, followed from contact to contact: nothing of the recursion is used.

Positions and velocities are balls of many bits; every comparison is certain or fails.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from itertools import combinations

from flint import arb

from verify.prover import balls

Vector = list[arb]


def dot(x: Vector, z: Vector) -> arb:
    """The inner product."""
    return sum((p * q for p, q in zip(x, z, strict=True)), arb(0))


def combine(x: Vector, number: arb, z: Vector) -> Vector:
    """x + number z."""
    return [p + number * q for p, q in zip(x, z, strict=True)]


def directions(dimension: int, C: Fraction) -> tuple[Vector, Vector]:
    """Two unit vectors whose inner product is -C."""
    first, second = [arb(0)] * dimension, [arb(0)] * dimension
    cosine = balls.from_fraction(C)
    first[0], second[0], second[1] = arb(1), -cosine, (1 - cosine**2).sqrt()
    return first, second


def sign(number: arb) -> int:
    """-1 or 1, and 0 if the ball contains 0."""
    return 1 if number > 0 else -1 if number < 0 else 0


@dataclass
class Flying:
    """Balls at their places, with their velocities."""

    places: list[Vector]
    velocities: list[Vector]

    def contact(self, _i: int, _j: int) -> arb:
        """The distance at which two of them touch."""
        return arb(1)

    def relative(self, i: int, j: int) -> tuple[Vector, Vector]:
        """Place and velocity of j seen from i."""
        minus = arb(-1)
        return (
            combine(self.places[j], minus, self.places[i]),
            combine(self.velocities[j], minus, self.velocities[i]),
        )

    def meeting(self, i: int, j: int) -> arb | None:
        """The time until two particles meet."""
        x, u = self.relative(i, j)
        approach = dot(x, u)
        if sign(approach) == 1:
            return None
        assert sign(approach) == -1
        gap = dot(x, x) - self.contact(i, j) ** 2
        radicand = approach**2 - dot(u, u) * gap
        if sign(radicand) == -1:
            return None
        assert sign(radicand) == 1
        return gap / (radicand.sqrt() - approach)

    def next(self) -> tuple[arb, int, int] | None:
        """The first meeting: its time and its pair."""
        found: tuple[arb, int, int] | None = None
        for i, j in combinations(range(3), 2):
            time = self.meeting(i, j)
            if time is None:
                continue
            assert time > 0
            assert found is None or time < found[0] or found[0] < time
            if found is None or time < found[0]:
                found = time, i, j
        return found

    def fly(self, time: arb) -> None:
        """Let that time pass."""
        self.places = [
            combine(x, time, v) for x, v in zip(self.places, self.velocities, strict=True)
        ]


@dataclass
class Particles(Flying):
    """Particles of diameter 1 and equal mass."""

    r: arb

    def collide(self, time: arb, i: int, j: int) -> None:
        """Fly for that time, and let the pair collide."""
        self.fly(time)
        omega, u = self.relative(i, j)
        impulse = (1 + self.r) / 2 * dot(u, omega)
        self.velocities[i] = combine(self.velocities[i], impulse, omega)
        self.velocities[j] = combine(self.velocities[j], -impulse, omega)
