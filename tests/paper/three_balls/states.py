"""Random states of three balls of different masses and radii, just after a collision."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any, NamedTuple

from flint import arb

from tests.paper.sandwich.states import Drawn, holds, stair_fails
from tests.paper.sharper.particles import Flying, combine, directions, dot
from verify.language.terms import Claim
from verify.paper.commands.pages import page
from verify.prover import balls
from verify.spheres.flow.collapse import Start
from verify.spheres.flow.sandwich import Stair
from verify.spheres.flow.three_balls import Bodies, Bounds, numbers_of, search

STATEMENT = page("three_balls").statement
GIVENS = STATEMENT.context("start").claims
STAIR = STATEMENT.context("stair").claims
#: A unit of speed that is no less than any drawn one.
UNIT = Fraction(100)

#: Exact rational numbers, and balls for the state.
Values = dict[str, Any]


@dataclass
class Balls(Flying):
    """Three balls of which nothing is scaled.

    ``r`` has the coefficients of restitution of the pairs 0-1 and 0-2.
    """

    masses: tuple[Fraction, Fraction, Fraction]
    radii: tuple[Fraction, Fraction, Fraction]
    r: dict[int, Fraction]

    def contact(self, i: int, j: int) -> arb:
        """The sum of their radii."""
        return balls.from_fraction(self.radii[i] + self.radii[j])

    def collide(self, time: arb, i: int, j: int) -> None:
        """Fly for that time, and let ball 0 collide with another one."""
        assert i == 0
        self.fly(time)
        omega, u = self.relative(0, j)
        m, m_j = (balls.from_fraction(self.masses[k]) for k in (0, j))
        normal = dot(u, omega) / dot(omega, omega)
        impulse = (1 + balls.from_fraction(self.r[j])) * m * m_j / (m + m_j) * normal
        self.velocities[0] = combine(self.velocities[0], impulse / m, omega)
        self.velocities[j] = combine(self.velocities[j], -impulse / m_j, omega)

    def bodies(self, s: int, c: int) -> Bodies:
        """What the theorem needs of them, where 0 has met s and meets c next."""
        contacts = tuple(self.radii[0] + self.radii[i] for i in (c, s))
        return Bodies(
            self.masses[0], (self.masses[c], self.masses[s]), (contacts[0], contacts[1]),
            self.radii[c] + self.radii[s], (self.r[c], self.r[s]),
        )  # fmt: skip

    def start(self, s: int, c: int) -> Start:
        """The state in the letters of the theorem: scaled, with unit vectors."""
        (x_s, u_s), (x_c, u_c) = self.relative(0, s), self.relative(0, c)
        to_s, to_c = 1 / self.contact(0, s), 1 / self.contact(0, c)
        far_s, far_c = dot(x_s, x_s).sqrt(), dot(x_c, x_c).sqrt()
        omega_s, omega_c = [x / far_s for x in x_s], [x / far_c for x in x_c]
        V_s, V_c = [to_s * x for x in u_s], [to_c * x for x in u_c]
        return Start(
            -dot(omega_c, V_c), dot(omega_s, V_s), -dot(omega_s, omega_c), dot(omega_s, V_c),
            dot(omega_c, V_s), dot(V_c, V_c), dot(V_s, V_s), dot(V_s, V_c), far_c * to_c - 1,
        )  # fmt: skip


class Applied(NamedTuple):
    """Balls, and the numbers with which the theorem applies to them."""

    bodies: Balls
    values: Values
    points: tuple[tuple[Fraction, Fraction], ...]


def values_of(found: tuple[Bounds, Stair], start: Start) -> Values:
    """The numbers and the state, by their names in the statement."""
    numbers = numbers_of(*found, balls.fmpq_of(UNIT))
    return {**numbers, **{f"{name}_start": x for name, x in start._asdict().items()}}


def fails(at: Values, points: tuple[tuple[Fraction, Fraction], ...]) -> list[str]:
    """The hypotheses that are not certain."""
    found = [name for name, claim in GIVENS.items() if not _holds(claim, at)]
    each = [
        {
            "alpha": at[f"beta_{c}"] * (at["C_0"] - at["Theta"]),
            "rho": at["G"] * (at[f"w_{1 - c}"] / at[f"w_{c}"]) ** 2,
            "R": at[f"r_{c}"] * at["G"],
            "U_b": at["U_b"],
        }
        for c in (0, 1)
    ]
    return found + stair_fails(STAIR, each, points)


def _holds(claim: Claim, at: Values) -> bool:
    """Whether a claim is certain; an equation is one of rational numbers."""
    if claim.relation != "=":
        return holds(claim, at)
    both = (Claim("<=", claim.lhs, claim.rhs), Claim("<=", claim.rhs, claim.lhs))
    return all(holds(one, at) for one in both)


class Random(Drawn):
    """Balls in some dimension; those that have one mass, one radius and one r if `equal`."""

    finest = 10**9

    def __init__(self, seed: int, dimension: int, *, equal: bool = False) -> None:
        super().__init__(seed, dimension)
        self.equal = equal

    def numbers(self, low: float, high: float, count: int) -> tuple[Fraction, ...]:
        """So many of them."""
        first = self.number(low, high)
        return (first, *(first if self.equal else self.number(low, high) for _ in range(count - 1)))

    def balls(self) -> Balls:
        """Two relative velocities, mostly tangential, and ball 2 near contact; 1 is in contact."""
        radii, masses = self.numbers(0.1, 5, 3), self.numbers(0.1, 10, 3)
        if not self.equal:
            masses = (self.number(0.003, 5), *masses[1:])
        r_1, r_2 = self.numbers(1e-3, 0.06 if self.equal else 0.6, 2)
        y = self.number(1e-4, 0.1)
        eta_s = y * self.number(0.01, 1)
        speeds = self.number(0.5, 2), self.number(0.5, 2)
        d = y**2 / speeds[0] ** 2 * self.number(1e-4, 0.3)
        C = 1 - self.number(1e-4, 0.2)
        zero = arb(0)
        omega_s, omega_c = directions(self.dimension, C)
        near, next_one = (balls.from_fraction(radii[0] + radii[i]) for i in (1, 2))
        V_s = self.velocity(omega_s, eta_s, speeds[1])
        V_c = self.velocity(omega_c, -y, speeds[0])
        away = [next_one * balls.from_fraction(1 + d) * x for x in omega_c]
        places = [[zero] * self.dimension, [near * x for x in omega_s], away]
        velocities = [[zero] * self.dimension, [near * x for x in V_s], [next_one * x for x in V_c]]
        (m_0, m_1, m_2), (R_0, R_1, R_2) = masses, radii
        return Balls(places, velocities, (m_0, m_1, m_2), (R_0, R_1, R_2), {1: r_1, 2: r_2})

    def applied(self) -> Applied | None:
        """Balls to which the theorem applies, or nothing."""
        found = self.balls()
        start = found.start(1, 2)
        numbers = search(found.bodies(1, 2), start, UNIT)
        if numbers is None:
            return None
        at, points = values_of(numbers, start), numbers[1].points
        return None if fails(at, points) else Applied(found, at, points)
