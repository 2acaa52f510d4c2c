"""Planes of scenes: a rectangle with a scene at each of its points.

In the plane of the two ratios the scene is one just after a collision: sphere s has just collided
with o, and c comes near: φ1 = eta_s/(-eta_c) and φ2 = d/eta_c^2, where the companion paper sees a
border between what collapses and what does not. In a plane through a scene two numbers vary.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

from verify.language.record import Record
from verify.spheres.flow.law import Number, Pair, State
from verify.spheres.scene.scene import PAIRS, Coordinates, Frame, Scene

#: Two numbers between which another one lies.
Side = tuple[Fraction, Fraction]


class Phi(Record):
    """r, -cos θ, -eta_c, the tangential velocities of c and s, and the rectangle of (φ1, φ2).

    With ω_c and ω_s the unit vectors from o to c and s, W_c = eta_c ω_c + u_c n_c and
    W_s = eta_s ω_s + u_s n_s, where n is ω turned by a right angle to the left.
    """

    r: Fraction
    neg_cos: Fraction
    speed: Fraction = Fraction(1, 100)
    tangential: tuple[Fraction, Fraction] = (Fraction(1), Fraction(1))
    x: Side = (Fraction(0), Fraction(1, 2))
    y: Side = (Fraction(0), Fraction(1, 4))


def start(
    plane: Phi,
    phi_1: Number,
    phi_2: Number,
    number: Callable[[Fraction], Number],
    root: Callable[[Number], Number],
) -> State:
    """The state of the scene at (φ1, φ2), with -eta_c for the unit of speed.

    Only φ1 > 0 and φ2 > 0 are meant: elsewhere the spheres overlap or three of them touch.
    """
    C, v = number(plane.neg_cos), number(plane.speed)
    u_c, u_s = map(number, plane.tangential)
    sine = root(1 - C * C) if plane.neg_cos < 1 else number(Fraction(0))
    d, eta_s = phi_2 * (v * v), phi_1 * v
    D = 1 + d
    return State(
        v,
        D,
        phi_1,
        phi_2 * (2 + d),
        0,
        v * v + u_c * u_c,
        eta_s * eta_s + u_s * u_s,
        D * C,
        C * v - sine * u_c,
        D * (sine * u_s - C * eta_s),
        C * (eta_s * v - u_c * u_s) - sine * (u_s * v + u_c * eta_s),
    )


#: Positions or velocities, a particle, a coordinate.
Place = tuple[str, int, int]
#: Frames in which the three pairs, in their order, are o, c.
FRAMES: tuple[Frame, ...] = ((0, 2, 1), (0, 1, 2), (1, 0, 2))


class Through(Record):
    """A scene two numbers of which are varied, each in an interval."""

    scene: Scene
    x_at: Place
    y_at: Place
    x: Side
    y: Side

    @property
    def r(self) -> Fraction:
        """The coefficient of restitution."""
        return self.scene.r


Plane = Phi | Through


def views(
    plane: Through, x: Number, y: Number, number: Callable[[Fraction], Number]
) -> tuple[list[State], list[Pair]]:
    """The scene with two other numbers, in each of the three frames; and the three pairs."""
    varied = {plane.x_at: x, plane.y_at: y}

    def rows(kind: str, given: tuple[tuple[Fraction, ...], ...]) -> list[list[Number]]:
        return [
            [
                varied[kind, i, k] if (kind, i, k) in varied else number(value)
                for k, value in enumerate(row)
            ]
            for i, row in enumerate(given)
        ]

    scene = plane.scene
    at = Coordinates(rows("positions", scene.positions), rows("velocities", scene.velocities))
    given = Coordinates(scene.positions, scene.velocities)

    def pair(i: int, j: int) -> Pair:
        """A pair that does not vary is known exactly: it may be in contact."""
        if any(particle in (i, j) for _, particle, _ in varied):
            return at.pair(i, j)
        return Pair(*map(number, given.pair(i, j)))

    found = [at.state(frame, lambda _, value: value) for frame in FRAMES]
    return found, [pair(i, j) for i, j in PAIRS]
