"""Balls, walls, gravity and a box at the time 0: exact numbers, in the units of the file."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction

from verify.language.record import Record
from verify.spheres.flow.line import is_on_a_line
from verify.spheres.scene.scene import PAIRS, Bodies, Labels, Scene

Vector = tuple[Fraction, ...]


class Wall(Record):
    """A flat wall that stays where it is: balls are where normal·x >= level."""

    normal: Vector
    level: Fraction
    r: Fraction


class System(Record):
    """The balls 0, 1, …, N - 1.

    ``r`` is the coefficient of restitution of a pair that is not in ``restitutions``; pairs there
    have the smaller number first. ``box`` has the periods, and is empty without a box.
    """

    r: Fraction
    masses: Vector
    radii: Vector
    positions: tuple[Vector, ...]
    velocities: tuple[Vector, ...]
    labels: Labels = Labels()
    restitutions: Mapping[tuple[int, int], Fraction] = {}
    gravity: Vector = ()
    walls: tuple[Wall, ...] = ()
    box: Vector = ()

    @property
    def number(self) -> int:
        """The number of balls."""
        return len(self.positions)

    @property
    def dimension(self) -> int:
        """The number of coordinates."""
        return len(self.positions[0])

    @property
    def is_open(self) -> bool:
        """Whether there are neither walls nor a box."""
        return not self.walls and not self.box

    @property
    def is_on_a_line(self) -> bool:
        """Whether the balls are and stay on one line, and there are no walls."""
        others = range(2, self.number)
        rows = (self.positions, self.velocities)
        scenes = (self.three(n, *([row[k] for k in n] for row in rows))
                  for n in ((0, 1, other) for other in others))  # fmt: skip
        return self.is_open and all(map(is_on_a_line, scenes))

    def restitution(self, i: int, j: int) -> Fraction:
        """The coefficient of restitution of a pair."""
        return self.restitutions.get((min(i, j), max(i, j)), self.r)

    def contact(self, i: int, j: int) -> Fraction:
        """The distance of the centres of a pair when it touches."""
        return self.radii[i] + self.radii[j]

    def three(
        self, balls: Sequence[int], positions: Sequence[Vector], velocities: Sequence[Vector]
    ) -> Scene:
        """A scene of three of the balls, there and with these velocities."""
        masses, radii = (tuple(row[i] for i in balls) for row in (self.masses, self.radii))
        one, two, three = (self.restitution(balls[i], balls[j]) for i, j in PAIRS)
        several = None if one == two == three else (one, two, three)
        return Scene(
            max(one, two, three), tuple(positions), tuple(velocities), Labels(),
            Bodies(masses, radii), masses[0], several,
        )  # fmt: skip


def name_of(i: int, j: int) -> str:
    """A pair as it is written: 3-12."""
    return f"{min(i, j)}-{max(i, j)}"
