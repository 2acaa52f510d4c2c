"""The mapping against vectors: random states in space, with every number rational.

Where the balls are before and after the flight is drawn; with its time that gives the velocities,
so that no root is needed. The collision is that of three velocities, not the one of the mapping.
"""

from __future__ import annotations

import random
from fractions import Fraction
from functools import cache

import pytest

from tests.pages import Variables, claim, context, rows
from tests.paper.sections_1_to_4.values import holds, value, with_constants
from verify.language.statement import NEEDED
from verify.language.terms import Claim, Term

Vector = tuple[Fraction, Fraction, Fraction]
SEEDS = range(25)
PAGE = "sections_1_to_4"
CONTEXT, MAP = context(PAGE, "map"), Variables(PAGE, "map")
ROWS = [row for row in rows(PAGE, "map").values() if row.role == NEEDED]


def dot(x: Vector, z: Vector) -> Fraction:
    return x[0] * z[0] + x[1] * z[1] + x[2] * z[2]


def along(x: Vector, factor: Fraction, z: Vector) -> Vector:
    """x + factor z"""
    return x[0] + factor * z[0], x[1] + factor * z[1], x[2] + factor * z[2]


def unit(draw: random.Random, size: int) -> Vector:
    """A unit vector by its stereographic coordinates, near (1, 0, 0) if ``size`` is large."""
    p, q = (Fraction(draw.randint(-9, 9), size) for _ in range(2))
    scale = 1 + p**2 + q**2
    return (2 - scale) / scale, 2 * p / scale, 2 * q / scale


class Drawn:
    """A state and its flight, with the numbers of the mapping."""

    def __init__(self, seed: int) -> None:
        draw = random.Random(seed)
        size = draw.choice((10, 100))
        self.r, self.d = Fraction(draw.randint(1, 19), 20), Fraction(draw.randint(1, 40), size)
        self.tau = Fraction(draw.randint(1, 20), 7)
        self.o_1, self.new_1 = unit(draw, size), unit(draw, size)
        x, y, z = unit(draw, size)
        self.o_2 = (-x, y, z)
        x, y, z = unit(draw, size)
        self.new_2 = (-x, y, z)
        self.p = unit(draw, 3)
        self.D = (1 + Fraction(draw.randint(1, 40), size)) / dot(self.o_1, self.new_1)
        self.W_1 = self.velocity(self.o_1, Fraction(1), self.new_1, self.D)
        self.W_2 = self.velocity(self.o_2, 1 + self.d, self.new_2, Fraction(1))

    def velocity(self, old: Vector, before: Fraction, new: Vector, after: Fraction) -> Vector:
        moved = along((after * new[0], after * new[1], after * new[2]), -before, old)
        return along((Fraction(0),) * 3, 1 / self.tau, moved)

    def numbers(self) -> dict[str, Term]:
        y, hit = -dot(self.W_2, self.o_2), dot(self.W_2, self.new_2)
        return MAP.at(
            r=self.r,
            d=self.d,
            y=y,
            eta=dot(self.W_1, self.o_1),
            cos=dot(self.o_1, self.o_2),
            a=dot(self.o_1, self.W_2),
            b=dot(self.o_2, self.W_1),
            A=dot(self.W_2, self.W_2),
            B=dot(self.W_1, self.W_1),
            w=dot(self.W_1, self.W_2),
            S=-hit / ((1 + self.d) * y),
            tau=self.tau,
            D=self.D,
            p_1=dot(self.p, self.o_1),
            p_2=dot(self.p, self.o_2),
            q_1=dot(self.p, self.W_1),
            q_2=dot(self.p, self.W_2),
        )

    def meets(self) -> bool:
        """2 approaches and is met for the first time, 1 recedes."""
        approaches = dot(self.W_2, self.o_2) < 0 and dot(self.W_2, self.new_2) < 0
        return approaches and self.D > 0 and dot(self.W_1, self.o_1) > 0


@cache
def states() -> list[Drawn]:
    found = [drawn for drawn in map(Drawn, range(1000)) if drawn.meets()]
    return found[: len(SEEDS)]


@pytest.mark.parametrize("seed", SEEDS)
def test_a_state_of_vectors_satisfies_what_the_context_asks_for(seed: int) -> None:
    at = states()[seed].numbers()
    assert [given.name for given in CONTEXT.givens if not holds(given.claim, at)] == []


@pytest.mark.parametrize("seed", SEEDS)
def test_every_row_holds_there(seed: int) -> None:
    known = with_constants(CONTEXT, states()[seed].numbers())
    claims = {row.name: row.claim for row in ROWS if isinstance(row.claim, Claim)}
    assert [name for name, claim in claims.items() if not holds(claim, known)] == []
    assert len(claims) > 30


@pytest.mark.parametrize("seed", SEEDS)
def test_the_collision_is_that_of_three_velocities(seed: int) -> None:
    """0 is at rest before: the blow changes its velocity and that of 2, and not that of 1."""
    s = states()[seed]
    blow = (1 + s.r) / 2 * dot(s.W_2, s.new_2)
    v_0 = along((Fraction(0),) * 3, blow, s.new_2)
    W_1 = along(s.W_1, Fraction(-1), v_0)
    W_2 = along(along(s.W_2, -blow, s.new_2), Fraction(-1), v_0)
    left_1 = along(W_1, -dot(W_1, s.new_1), s.new_1)
    left_2 = along(W_2, -dot(W_2, s.new_2), s.new_2)
    known = with_constants(CONTEXT, s.numbers())
    for name, expected in (
        ("normal-1", dot(W_1, s.new_1)),
        ("normal-2", dot(W_2, s.new_2)),
        ("tangential-1", dot(s.p, left_1)),
        ("tangential-2", dot(s.p, left_2)),
    ):
        found = claim(PAGE, name)
        assert value(found.lhs, known) == value(found.rhs, known) == expected
    assert value(known["map-c"], {}) == dot(s.new_1, s.new_2)
