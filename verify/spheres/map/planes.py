"""Planes of scenes: a rectangle with a scene at each of its points.

In the plane of the two ratios the scene is one just after a collision: sphere s has just collided
with o, and c comes near: φ1 = eta_s/(-eta_c) and φ2 = d/eta_c^2, where the companion paper sees a
border between what collapses and what does not. In a plane through a scene two numbers vary; in a
family the numbers are terms of two parameters, or of one, and r may be such a term.
"""

from __future__ import annotations

import operator
from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Any

from verify.language.record import Record
from verify.spheres.flow.law import Number, Pair, State
from verify.spheres.scene.scene import PAIRS, Coordinates, Frame, Scene

#: A number, or "x" or "y", or an operation with two terms.
Term = Any
Terms = Sequence[Sequence[Term]]
#: The operations of terms.
OPERATORS: dict[str, Callable[[Any, Any], Any]] = {
    "+": operator.add,
    "-": operator.sub,
    "*": operator.mul,
    "/": operator.truediv,
}
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

    @property
    def coordinates(self) -> Coordinates:
        """Positions and velocities, as terms."""
        names = {self.x_at: "x", self.y_at: "y"}

        def rows(kind: str, given: Terms) -> Terms:
            return [
                [names.get((kind, i, k), value) for k, value in enumerate(row)]
                for i, row in enumerate(given)
            ]

        scene = self.scene
        return Coordinates(rows("positions", scene.positions), rows("velocities", scene.velocities))


class FamilyPlane(Record):
    """Scenes whose numbers are terms of x and y, with names for these; or of x alone."""

    r: Term
    coordinates: Coordinates
    axes: tuple[str, ...]
    x: Side
    y: Side | None = None


Plane = Phi | Through | FamilyPlane
#: The planes whose scenes are free at the start.
Scenes = Through | FamilyPlane


def digits_of(plane: object) -> str:
    """The digits of the key of a box: it is cut into as many."""
    return "01" if isinstance(plane, FamilyPlane) and plane.y is None else "0123"


def is_on_a_line(plane: Plane) -> bool:
    """Whether all vectors between spheres are multiples of one vector, in every scene.

    Where a coordinate is no polynomial of x and y, this is said only of lines along an axis.
    """
    if isinstance(plane, Phi):
        return False
    vectors: list[list[Polynomial]] = []
    for rows in (plane.coordinates.x, plane.coordinates.v):
        found = [[_polynomial(cell) for cell in row] for row in rows]
        vectors += [
            [_sum(b, a, -1) for a, b in zip(found[0], row, strict=True) if a and b]
            for row in found[1:]
        ]
    if any(len(vector) < len(plane.coordinates.x[0]) for vector in vectors):
        return _is_along_an_axis(plane)
    parts = [
        [cell.get(power, Fraction(0)) for cell in vector]
        for vector in vectors
        for power in {power for cell in vector for power in cell}
    ]
    parts = [part for part in parts if any(part)]
    return all(_are_parallel(parts[0], part) for part in parts[1:])


#: The coefficients of x^i y^j by i, j; a zero polynomial has one of them, which is 0.
Polynomial = dict[tuple[int, int], Fraction]
#: Polynomials with more coefficients are not looked at.
MAX_COEFFICIENTS = 100


def _polynomial(term: Term) -> Polynomial | None:
    """A term as a polynomial; None if it is none, or a long one."""
    if isinstance(term, Fraction):
        return {(0, 0): term}
    if isinstance(term, str):
        return {(1, 0) if term == "x" else (0, 1): Fraction(1)}
    name, *parts = term
    one, two = map(_polynomial, parts)
    if one is None or two is None:
        return None
    if name in ("+", "-"):
        return _sum(one, two, 1 if name == "+" else -1)
    if name == "/":
        divisor = two.get((0, 0))
        if not divisor or len(two) > 1:
            return None
        return {power: value / divisor for power, value in one.items()}
    found: Polynomial = {}
    for (i, j), a in one.items():
        for (k, m), b in two.items():
            found[i + k, j + m] = found.get((i + k, j + m), Fraction(0)) + a * b
    return found if len(found) <= MAX_COEFFICIENTS else None


def _sum(one: Polynomial, two: Polynomial, factor: int) -> Polynomial:
    zero = Fraction(0)
    powers = {**one, **two}
    return {power: one.get(power, zero) + factor * two.get(power, zero) for power in powers}


def _are_parallel(one: Sequence[Fraction], two: Sequence[Fraction]) -> bool:
    k = next(k for k, value in enumerate(one) if value)
    return all(a * two[k] == b * one[k] for a, b in zip(one, two, strict=True))


def _is_along_an_axis(plane: Scenes) -> bool:
    """Whether at most one coordinate, the same for all, ever differs between spheres."""
    moving = set()
    for rows in (plane.coordinates.x, plane.coordinates.v):
        for k, cells in enumerate(zip(*rows, strict=True)):
            if not all(isinstance(cell, Fraction) and cell == cells[0] for cell in cells):
                moving.add(k)
    return len(moving) <= 1


def value_of(term: Term, x: Number, y: Number, number: Callable[[Fraction], Number]) -> Number:
    """A term at the parameters."""
    if isinstance(term, Fraction):
        return number(term)
    if isinstance(term, str):
        return x if term == "x" else y
    name, one, two = term
    a = value_of(one, x, y, number)
    if name == "*" and one == two:
        return a**2
    return OPERATORS[name](a, value_of(two, x, y, number))


def views(
    plane: Scenes, x: Number, y: Number, number: Callable[[Fraction], Number]
) -> tuple[list[State], list[Pair]]:
    """The scenes of a plane, in each of the three frames; and the three pairs."""
    given = plane.coordinates
    at = Coordinates(
        *(
            [[value_of(term, x, y, number) for term in row] for row in rows]
            for rows in (given.x, given.v)
        )
    )

    def pair(i: int, j: int) -> Pair:
        """A pair that does not vary is known exactly: it may be in contact."""
        cells = (x for rows in (given.x, given.v) for k in (i, j) for x in rows[k])
        if all(isinstance(x, Fraction) for x in cells):
            return Pair(*map(number, given.pair(i, j)))
        return at.pair(i, j)

    found = [at.state(frame, lambda _, value: value) for frame in FRAMES]
    return found, [pair(i, j) for i, j in PAIRS]
