"""The claims are about vectors: inner products of random ones, in two and three dimensions."""

from __future__ import annotations

import random
import re
from fractions import Fraction
from typing import Any

import pytest

from tests.pages import Variables, context, rows
from tests.paper.step.states import BITS, checker, evaluate
from verify.language.statement import Always
from verify.language.terms import Claim
from verify.prover import balls

Vector = list[Any]
COLLISION, SPIN, RUN = (context("classification", name) for name in ("collision", "spin", "run"))
run, first = Variables("classification", "run"), Variables("classification", "first")


def dot(x: Vector, z: Vector) -> Any:
    return sum((p * q for p, q in zip(x, z, strict=True)), balls.from_fraction(Fraction(0)))


def plus(x: Vector, z: Vector, factor: Any = 1) -> Vector:
    """The sum of a vector and a multiple of another one."""
    return [p + factor * q for p, q in zip(x, z, strict=True)]


def unit(x: Vector) -> Vector:
    return [p / dot(x, x).sqrt() for p in x]


class Random:
    """Numbers and vectors."""

    def __init__(self, seed: int, dimension: int) -> None:
        self.choose, self.dimension = random.Random(seed), dimension

    def number(self, low: int, high: int) -> Any:
        return balls.from_fraction(Fraction(self.choose.randrange(low * 999, high * 999) + 1, 999))

    def vector(self) -> Vector:
        return [self.number(-2, 2) for _ in range(self.dimension)]


def rows_of(context: str) -> dict[str, Claim]:
    """The claims of the rows of a context."""
    found = rows("classification", context).items()
    return {name: row.claim for name, row in found if isinstance(row.claim, Claim)}


# --- a collision ---------------------------------------------------------------------------------


def collision_values(draw: Random) -> dict[str, Any]:
    """A collision of two balls with vectors e, f, g, p, q, v_i, v_j, v_k, x_i."""
    e, f, g = (unit(draw.vector()) for _ in range(3))
    v_i, v_j, v_k, x_i, p, q = (draw.vector() for _ in range(6))
    rho = -draw.number(0, 2)
    v_j = plus(v_j, e, rho - dot(e, plus(v_j, v_i, -1)))
    known = {"e": e, "f": f, "g": g, "p": p, "q": q, "v_i": v_i, "v_j": v_j, "v_k": v_k, "x_i": x_i}
    values = {
        "collision.m_i": draw.number(0, 3),
        "collision.m_j": draw.number(0, 3),
        "collision.sigma": draw.number(0, 3),
        "collision.rho": rho,
        "collision.rho_new": -rho * draw.number(0, 1),
    }
    for variable in COLLISION.variables:  # the letter says which product it is: e·v_i or |v_i|²
        if match := re.fullmatch(r"(\w+)·(\w+)|\|(\w+)\|²", variable.letter):
            x, z = match[1] or match[3], match[2] or match[3]
            values[variable.name] = dot(known[x], known[z])
    return values


@pytest.mark.parametrize("dimension", [2, 3])
def test_the_laws_of_a_collision_hold_for_vectors(dimension: int) -> None:
    claims = rows_of("collision")
    assert len(claims) > 8
    with balls.precision(BITS):
        values = collision_values(Random(0, dimension))
        assert set(values) == {v.name for v in COLLISION.variables}
        violated = checker([COLLISION], claims, list(values))
        for seed in range(20):
            assert violated(collision_values(Random(seed, dimension))) == []


def test_a_wrong_law_of_a_collision_is_seen() -> None:
    """Nearly all claims are false with a minus sign on one side; the checker of vectors sees it."""
    wrong = {
        name: Claim(claim.relation, claim.lhs, -claim.rhs)
        for name, claim in rows_of("collision").items()
        if claim.relation == "="
    }
    with balls.precision(BITS):
        values = collision_values(Random(1, 3))
        violated = checker([COLLISION], wrong, list(values))
        assert set(violated(values)) == set(wrong)


# --- the angular momentum ------------------------------------------------------------------------


@pytest.mark.parametrize("dimension", [2, 3, 5])
def test_the_angular_momentum_is_bounded_in_any_dimension(dimension: int) -> None:
    """|L|² is the sum over all planes, as the criteria for scenes have it, and at most R²e²."""
    claims = rows_of("spin")
    names = [variable.name for variable in SPIN.variables]
    with balls.precision(BITS):
        violated = checker([SPIN], claims, names)
        for seed in range(20):
            draw = Random(seed, dimension)
            bodies = [(draw.number(0, 3), draw.vector(), draw.vector()) for _ in range(3)]
            planes = [(i, j) for i in range(dimension) for j in range(i)]
            parts = [sum(m * (x[i] * v[j] - x[j] * v[i]) for m, x, v in bodies) for i, j in planes]
            R2, e2 = (sum(m * dot(b[k], b[k]) for m, *b in bodies) for k in (0, 1))
            assert dot(parts, parts) <= R2 * e2
            (_, x, v), p, q = bodies[0], draw.vector(), draw.vector()
            known = (dot(x, x), dot(v, v), dot(x, v), dot(x, p), dot(x, q), dot(v, p), dot(v, q))
            assert violated(dict(zip(names, (*known, draw.number(0, 2)), strict=True))) == []
            wedge = sum((x[i] * v[j] - x[j] * v[i]) ** 2 for i, j in planes)
            assert abs(wedge - (known[0] * known[1] - known[2] ** 2)) < balls.from_fraction(
                Fraction(1, 10**100)
            )


# --- a run ---------------------------------------------------------------------------------------


class Run:
    """0 has just collided with s and is going to collide with c, as vectors."""

    def __init__(self, draw: Random, r: Any) -> None:
        self.r = r
        self.s, self.c = draw.number(0, 2), draw.number(0, 2)
        omega = unit(draw.vector())
        self.x_s = [self.s * p for p in omega]
        self.u = draw.number(0, 2)
        W = draw.vector()
        self.W_s = plus(W, omega, r * self.u - dot(omega, W))
        self.x_c = [(self.c + draw.number(0, 1)) * p for p in unit(draw.vector())]
        self.W_c = plus([-3 * p for p in self.x_c], draw.vector(), draw.number(0, 1) / 9)

    def values(self) -> dict[str, Any]:
        """The numbers of the state."""
        omega_s, omega_c = unit(self.x_s), unit(self.x_c)
        return {
            "s": self.s,
            "c": self.c,
            "D": dot(self.x_c, self.x_c).sqrt(),
            "y": -dot(omega_c, self.W_c),
            "eta": dot(omega_s, self.W_s),
            "C": -dot(omega_s, omega_c),
            "p": dot(omega_s, self.W_c),
            "q": dot(omega_c, self.W_s),
            "A": dot(self.W_c, self.W_c),
            "B": dot(self.W_s, self.W_s),
            "w": dot(self.W_s, self.W_c),
            "u": self.u,
        }

    def collide(self) -> None:
        """Go on through the next collision, with velocities of three balls; the roles change."""
        x, W = self.x_c, self.W_c
        p, square = dot(x, W), dot(W, W)
        t = (-p - (p**2 - square * (dot(x, x) - self.c**2)).sqrt()) / square
        self.x_c, self.x_s = plus(x, W, t), plus(self.x_s, self.W_s, t)
        e = unit(self.x_c)
        v_0 = [balls.from_fraction(Fraction(0)) for _ in e]
        v_c, v_s = plus(v_0, self.W_c), plus(v_0, self.W_s)
        self.u = -dot(e, plus(v_c, v_0, -1))
        push = (1 + self.r) / 2 * self.u
        v_0, v_c = plus(v_0, e, -push), plus(v_c, e, push)
        self.x_s, self.x_c = self.x_c, self.x_s
        self.W_s, self.W_c = plus(v_c, v_0, -1), plus(v_s, v_0, -1)
        self.s, self.c = self.c, self.s


def with_ghosts(values: dict[str, Any], r: Any, a: Any) -> dict[str, Any]:
    """The numbers by their names, r, a, and ghosts as at the beginning of a run."""
    ghosts = {
        "b": a,
        "u_0": (a * values["u"] - values["y"]) / r,
        "low": -1 / r,
        "high": balls.from_fraction(Fraction(0)),
    }
    found = {run.full(name): value for name, value in (values | ghosts).items()}
    return found | {first.full("r"): r, first.full("a"): a}


@pytest.mark.parametrize("dimension", [2, 3])
def test_the_next_state_is_that_of_the_vectors(dimension: int) -> None:
    claims = rows_of("run")
    assert len(claims) > 8
    followed = 0
    with balls.precision(BITS):
        for seed in range(20):
            draw = Random(seed, dimension)
            r, a = draw.number(0, 1), draw.number(0, 1)
            balls_of = Run(draw, r)
            before = with_ghosts(balls_of.values(), r, a)
            violated = checker([RUN], claims, list(before))
            terms = {"meets": next(g.claim.rhs for g in RUN.givens if g.name == "run-meets")}
            if not evaluate(terms, before)["meets"] > 0:
                continue
            followed += 1
            assert violated(before) == []
            balls_of.collide()
            after = balls_of.values()
            for name, value in next_state(before).items():
                assert abs(value - after[name]) < balls.from_fraction(Fraction(1, 10**100)), name
    assert followed > 10


def next_state(before: dict[str, Any]) -> dict[str, Any]:
    """The numbers of the next state, by the definitions of the context."""
    known, claim = dict(before), rows("classification")["run-always"].claim
    assert isinstance(claim, Always)
    for constant in RUN.constants:
        known[constant.name] = evaluate({"x": constant.term}, known)["x"]
    terms = {
        name.partition(".")[2]: term
        for name, term in claim.next.items()
        if name.partition(".")[2] not in ("b", "u_0", "low", "high")
    }
    return evaluate(terms, known)
