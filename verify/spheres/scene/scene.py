"""Three spheres of diameter 1 at the time 0: exact numbers, and what they are seen from one."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Any

from verify.language.record import Record
from verify.spheres.flow.law import Number, Pair, State

#: The three pairs, and for each the third sphere.
PAIRS = ((0, 1), (0, 2), (1, 2))
#: A central sphere o, the spectator s, and the sphere c that is looked at.
Frame = tuple[int, int, int]
#: Frames in which the pairs 01, 02 and 12 are o, c.
FIRST_FRAMES: tuple[Frame, ...] = ((0, 2, 1), (0, 1, 2), (1, 0, 2))
Vector = Sequence[Number]


class Labels(Record):
    """What a scene is called, and its units of time and length; each may be empty."""

    title: str = ""
    time_unit: str = ""
    length_unit: str = ""


class Scene(Record):
    """Centres and velocities of the spheres 0, 1, 2, and the coefficient of restitution."""

    r: Fraction
    positions: tuple[tuple[Fraction, ...], ...]
    velocities: tuple[tuple[Fraction, ...], ...]
    labels: Labels = Labels()

    @property
    def dimension(self) -> int:
        """The number of coordinates."""
        return len(self.positions[0])


class Coordinates(Record):
    """Centres and velocities in numbers of any kind."""

    x: Sequence[Vector]
    v: Sequence[Vector]

    def pair(self, i: int, j: int) -> Pair:
        """|x|² - 1, x·w and |w|² of a pair."""
        x, w = difference(self.x, i, j), difference(self.v, i, j)
        return Pair(inner_product(x, x) - 1, inner_product(x, w), inner_product(w, w))

    def state(self, frame: Frame, keep: Callable[[str, Number], Number]) -> State:
        """The scene seen from one of its spheres, with the unit of speed 1."""
        o, s, c = frame
        x_s, x_c = difference(self.x, o, s), difference(self.x, o, c)
        W_s, W_c = difference(self.v, o, s), difference(self.v, o, c)
        return State(
            1,
            keep("lam", -inner_product(x_c, W_c)),
            keep("rho", inner_product(x_s, W_s)),
            keep("eps", inner_product(x_c, x_c) - 1),
            keep("sig", inner_product(x_s, x_s) - 1),
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

    return Coordinates(all_of(scene.positions), all_of(scene.velocities))


def difference(rows: Sequence[Vector], i: int, j: int) -> Vector:
    """The vector from the i-th to the j-th."""
    return [b - a for a, b in zip(rows[i], rows[j], strict=True)]


def inner_product(x: Vector, z: Vector) -> Number:
    """The inner product."""
    total = x[0] * z[0]
    for a, b in zip(x[1:], z[1:], strict=True):
        total = total + a * b
    return total


def pair_name(i: int, j: int) -> str:
    """A pair as people write it: 01, 02 or 12."""
    return f"{min(i, j)}{max(i, j)}"
