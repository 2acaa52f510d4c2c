"""Three spheres of diameter 1 at the time 0: exact numbers, and what they are seen from one."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import reduce
from operator import add
from typing import Any

from verify.language.record import Record
from verify.spheres.flow.law import EQUAL, Number, Pair, Sizes, State

#: The three pairs, and for each the third sphere.
PAIRS = ((0, 1), (0, 2), (1, 2))
#: A central sphere o, the spectator s, and the sphere c that is looked at.
Frame = tuple[int, int, int]
#: Frames in which the pairs 01, 02 and 12 are o, c.
FIRST_FRAMES: tuple[Frame, ...] = ((0, 2, 1), (0, 1, 2), (1, 0, 2))
#: A frame in which 0 touches or collides with both others, seen so that 01 is o, c and 02 is c, s.
AROUND_FIRST: Frame = (1, 2, 0)
Vector = Sequence[Number]
HALF = Fraction(1, 2)


class Labels(Record):
    """What a scene is called, and its units of time and length; each may be empty."""

    title: str = ""
    time_unit: str = ""
    length_unit: str = ""


class Bodies(Record):
    """Masses and radii, of which some differ."""

    masses: tuple[Fraction, ...]
    radii: tuple[Fraction, ...]

    @property
    def has_one_mass(self) -> bool:
        """Whether all masses are the same: then only radii differ."""
        return len({*self.masses}) == 1

    def square(self, i: int, j: int) -> Fraction:
        """The square of the contact distance of a pair."""
        return (self.radii[i] + self.radii[j]) ** 2

    def sizes(self, frame: Frame, number: Callable[[Fraction], Number]) -> Sizes:
        """What the law of collision needs of them, seen from a sphere."""
        o, s, c = frame
        ratio = 1 + self.masses[o] / self.masses[c]
        squares = (self.square(o, c), self.square(o, s), self.square(s, c))
        return Sizes(*map(number, (*squares, ratio)))


class Scene(Record):
    """Centres and velocities of the spheres 0, 1, 2, and the coefficient of restitution.

    Where that differs from pair to pair, ``r`` is the largest.
    """

    r: Fraction
    positions: tuple[tuple[Fraction, ...], ...]
    velocities: tuple[tuple[Fraction, ...], ...]
    labels: Labels = Labels()
    #: None if all masses are equal and all diameters are 1.
    bodies: Bodies | None = None
    #: Of each particle where there are no bodies; only energies depend on it.
    mass: Fraction = Fraction(1)
    #: That of each pair, in the order of `PAIRS`, where they differ: then there are bodies.
    restitutions: tuple[Fraction, Fraction, Fraction] | None = None

    def restitution(self, i: int, j: int) -> Fraction:
        """The coefficient of restitution of a pair."""
        return self.r if self.restitutions is None else self.restitutions[i + j - 1]

    def contact(self, i: int, j: int) -> Fraction:
        """The distance of the centres of a pair when it touches."""
        return Fraction(1) if self.bodies is None else self.bodies.radii[i] + self.bodies.radii[j]

    @property
    def dimension(self) -> int:
        """The number of coordinates."""
        return len(self.positions[0])

    @property
    def has_one_mass(self) -> bool:
        """Whether all masses are the same."""
        return self.bodies is None or self.bodies.has_one_mass

    @property
    def is_in_diameters(self) -> bool:
        """Whether lengths are measured in the diameter of all three."""
        return self.bodies is None or {*self.bodies.radii} == {HALF}


class Coordinates(Record):
    """Centres and velocities in numbers of any kind."""

    x: Sequence[Vector]
    v: Sequence[Vector]
    #: The squares of the contact distances, in the order of `PAIRS`.
    squares: Sequence[Number] = (1, 1, 1)

    def square(self, i: int, j: int) -> Number:
        """The square of the contact distance of a pair."""
        return self.squares[i + j - 1]

    def pair(self, i: int, j: int) -> Pair:
        """|x|² less the square of the contact distance, x·w and |w|² of a pair."""
        x, w = difference(self.x, i, j), difference(self.v, i, j)
        gap = inner_product(x, x) - self.square(i, j)
        return Pair(gap, inner_product(x, w), inner_product(w, w))

    def state(self, frame: Frame, keep: Callable[[str, Number], Number]) -> State:
        """The scene seen from one of its spheres, with the unit of speed 1."""
        o, s, c = frame
        x_s, x_c = difference(self.x, o, s), difference(self.x, o, c)
        W_s, W_c = difference(self.v, o, s), difference(self.v, o, c)
        return State(
            1,
            keep("lam", -inner_product(x_c, W_c)),
            keep("rho", inner_product(x_s, W_s)),
            keep("eps", inner_product(x_c, x_c) - self.square(o, c)),
            keep("sig", inner_product(x_s, x_s) - self.square(o, s)),
            keep("A", inner_product(W_c, W_c)),
            keep("B", inner_product(W_s, W_s)),
            keep("C", -inner_product(x_s, x_c)),
            keep("a", inner_product(x_s, W_c)),
            keep("b", inner_product(x_c, W_s)),
            keep("w", inner_product(W_s, W_c)),
        )


def coordinates(scene: Scene, number: Callable[[Fraction], Number]) -> Coordinates:
    """The coordinates of a scene as numbers of another kind."""

    def all_of(rows: Sequence[Sequence[Any]]) -> tuple[tuple[Number, ...], ...]:
        return tuple(tuple(number(value) for value in row) for row in rows)

    x, v = all_of(scene.positions), all_of(scene.velocities)
    if scene.bodies is None:
        return Coordinates(x, v)
    return Coordinates(x, v, [number(scene.bodies.square(i, j)) for i, j in PAIRS])


def sizes_of(scene: Scene, frame: Frame, number: Callable[[Fraction], Number]) -> Sizes:
    """What the law of collision needs of the spheres besides r."""
    return EQUAL if scene.bodies is None else scene.bodies.sizes(frame, number)


def difference(rows: Sequence[Vector], i: int, j: int) -> Vector:
    """The vector from the i-th to the j-th."""
    return [b - a for a, b in zip(rows[i], rows[j], strict=True)]


def inner_product(x: Vector, z: Vector) -> Number:
    """The inner product."""
    return reduce(add, (a * b for a, b in zip(x, z, strict=True)))


def pair_name(i: int, j: int) -> str:
    """A pair as people write it: 01, 02 or 12."""
    return f"{min(i, j)}{max(i, j)}"
