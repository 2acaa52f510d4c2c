"""Random states just after a collision, on both sides of what the sandwich theorem allows."""

from __future__ import annotations

import random
from collections.abc import Mapping, Sequence
from fractions import Fraction
from itertools import pairwise
from typing import Any, NamedTuple

from flint import arb

from tests.evaluation import value
from tests.paper.sharper.particles import Particles, Vector, combine, directions, dot
from verify.language.terms import Claim
from verify.paper.commands.pages import page
from verify.prover import balls
from verify.spheres.flow.collapse import Start
from verify.spheres.flow.sandwich import Bounds, Stair, numbers_of, search

BELOW = page("sandwich_below").statement
GIVENS = BELOW.context("start").claims
STAIR = BELOW.context("stair").claims

#: Exact rational numbers, and balls for the state.
Values = dict[str, Any]


class Applied(NamedTuple):
    """Particles, and the numbers with which the theorem applies to them."""

    particles: Particles
    values: Values
    points: tuple[tuple[Fraction, Fraction], ...]


def holds(claim: Claim, at: Values) -> bool:
    """Whether a claim is certain."""
    lhs, rhs = (value(side, at, balls.fmpq_of) for side in (claim.lhs, claim.rhs))
    return bool(lhs < rhs if claim.relation == "<" else lhs <= rhs)


def start_of(particles: Particles) -> Start:
    """The state after a collision of 0 with 1, in the letters of the theorem."""
    (x_s, W_s), (x_c, W_c) = particles.relative(0, 1), particles.relative(0, 2)
    far = dot(x_c, x_c).sqrt()
    omega = [x / far for x in x_c]
    return Start(
        -dot(omega, W_c), dot(x_s, W_s), -dot(x_s, omega), dot(x_s, W_c), dot(omega, W_s),
        dot(W_c, W_c), dot(W_s, W_s), dot(W_s, W_c), far - 1,
    )  # fmt: skip


def values_of(found: tuple[Bounds, Stair], unit: Fraction, start: Start) -> Values:
    """The numbers and the state, by their names in the statement."""
    numbers = numbers_of(*found, balls.fmpq_of(unit))
    return {**numbers, **{f"{name}_start": x for name, x in start._asdict().items()}}


def fails(at: Values, points: tuple[tuple[Fraction, Fraction], ...]) -> list[str]:
    """The hypotheses that are not certain."""
    found = [name for name, claim in GIVENS.items() if not holds(claim, at)]
    half = (1 + at["r"]) / 2
    widths = at["w_0"], at["w_1"]
    each = [
        {
            "alpha": half * (at["C_0"] - at["Theta"]),
            "rho": at["G"] * (widths[1 - n] / widths[n]) ** 2,
            "R": at["r"] * at["G"],
            "U_b": at["U_b"],
        }
        for n in (0, 1)
    ]
    return found + stair_fails(STAIR, each, points)


def stair_fails(
    claims: Mapping[str, Claim], each: Sequence[Values], points: Sequence[tuple[Fraction, Fraction]]
) -> list[str]:
    """What is not certain of a stair; each second step has the same numbers."""
    found = []
    for n, ((Q, U), (Q_next, U_next)) in enumerate(pairwise(points)):
        numbers = {"Q": Q, "U": U, "Q_next": Q_next, "U_next": U_next}
        step = {name: balls.fmpq_of(x) for name, x in numbers.items()} | each[n % 2]
        named = {f"stair.{name}": x for name, x in step.items()}
        found += [name for name, claim in claims.items() if not holds(claim, named)]
    if points[-1][0] > points[-3][0] or points[-1][1] > points[-3][1]:
        found.append("period")
    return found


class Drawn:
    """What is drawn in some dimension."""

    finest = 10**12

    def __init__(self, seed: int, dimension: int) -> None:
        self.random, self.dimension = random.Random(seed), dimension

    def number(self, low: float, high: float) -> Fraction:
        """A number between two others, their logarithms evenly spread."""
        return Fraction(low * (high / low) ** self.random.random()).limit_denominator(self.finest)

    def velocity(self, omega: Vector, normal: Fraction, across: Fraction) -> Vector:
        """A velocity with these sizes of its normal and its tangential part."""
        draw = [balls.from_fraction(Fraction(self.random.randrange(-99, 99), 100)) for _ in omega]
        draw[-1] += balls.from_fraction(Fraction(1, 1000))
        aside = combine(draw, -dot(draw, omega), omega)
        length = balls.from_fraction(across) / dot(aside, aside).sqrt()
        return combine([balls.from_fraction(normal) * x for x in omega], length, aside)


class Random(Drawn):
    """Particles in some dimension."""

    def particles(self) -> Particles:
        """Two relative velocities, mostly tangential, and particle 2 near contact."""
        y = self.number(1e-4, 0.3)
        eta_s = y * self.number(0.01, 0.4)
        speeds = self.number(0.5, 2), self.number(0.5, 2)
        d = y**2 / speeds[0] ** 2 * self.number(1e-4, 0.3)
        C = 1 - self.number(1e-4, 0.3)
        omega_s, omega_c = directions(self.dimension, C)
        W_s = self.velocity(omega_s, eta_s, speeds[1])
        W_c = self.velocity(omega_c, -y, speeds[0])
        away = [balls.from_fraction(1 + d) * x for x in omega_c]
        r = balls.from_fraction(self.number(1e-3, 0.06))
        rest = [arb(0)] * self.dimension
        return Particles([rest, omega_s, away], [rest, W_s, W_c], r)

    def applied(self) -> Applied | None:
        """Particles to which the theorem applies, or nothing."""
        particles = self.particles()
        start, unit = start_of(particles), Fraction(2)
        r = balls.short_rational(particles.r)
        particles.r = balls.from_fraction(r)
        found = search(r, start, unit)
        if found is None:
            return None
        at = values_of(found, unit, start)
        points = found[1].points
        return None if fails(at, points) else Applied(particles, at, points)
