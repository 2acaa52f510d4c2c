"""Random states of three particles, as vectors, and the values of claims there."""

from __future__ import annotations

import random
from collections.abc import Callable, Iterable, Mapping
from fractions import Fraction
from typing import Any

from flint import arb

from verify.language.fold import fails
from verify.language.statement import Context
from verify.language.terms import Claim
from verify.paper.commands.pages import page
from verify.prover import balls
from verify.prover.balls import BallArithmetic
from verify.prover.program import Machine, Program

#: The step as its page states it.
STEP = page("step").statement
#: The numbers of a state.
NAMES = [v.name.removesuffix("_start") for v in STEP.context("initial").variables]
BITS = 1000
Values = dict[str, arb]
Vector = list[arb]
TINY = Fraction(1, 10**30)


def dot(x: Vector, z: Vector) -> arb:
    """The inner product."""
    return sum((p * q for p, q in zip(x, z, strict=True)), arb(0))


class Random:
    """States in some dimension that satisfy the conditions, extremes included."""

    def __init__(self, seed: int, dimension: int) -> None:
        self.random, self.dimension = random.Random(seed), dimension
        point = STEP.context("parameters").point.items()
        self.numbers: Values = {name: balls.from_fraction(x.value) for name, x in point}

    def share(self) -> arb:
        """A number in (0, 1), often close to an end."""
        exact = self.random.choice([TINY, 1 - TINY, Fraction(self.random.randrange(1, 999), 1000)])
        return balls.from_fraction(exact)

    def between(self, low: arb, high: arb) -> arb:
        """A number between two others."""
        return low + (high - low) * self.share()

    def state(self) -> Values | None:
        """A state that satisfies the conditions of the recursion."""
        v = dict(self.numbers)
        v["g"] = v["eta_bar"] * self.share()
        v["y"] = v["g"] * self.share()
        spread = (1 - v["h_4"] / 2) * v["delta_x"]
        v["eta_s"] = v["y"] * (v["phi_minus"] + self.between(-spread, spread))
        given = STEP.context("state").claims
        terms = {"room": given["Cnd8-upper"].rhs, "least": given["A-lower"].lhs}
        found = evaluate(terms | {"most": given["A-upper"].rhs}, v | {"d": arb(0)})
        for speed in ("A", "B"):
            v[speed] = self.between(found["least"], found["most"])
        limits = (
            v["h_4"] * v["delta_x"] / 8,
            v["delta_2"] * v["h_4"] * v["delta_x"] / 2,
            v["zeta_bar"] * v["y"] ** 2 / (2 * v["A"]),
            found["room"] / 2,
        )
        v["d"] = min(limits, key=float) * self.share()
        room = found["room"] - v["d"]
        v["C"] = v["c"] + self.between(-room, room)
        v["clock"] = arb(0)
        return self.with_vectors(v)

    def start(self) -> Values | None:
        """A state of the initial set."""
        v = dict(self.numbers)
        y = v["eta_bar"] * self.share()
        third = (v["V_1"] - v["V_0"]) / 3
        v |= {
            "y": y,
            "eta_s": y * (v["phi_minus"] + self.between(-v["x_0"], v["x_0"])),
            "A": self.between(v["V_0"] + third, v["V_1"] - third),
            "B": self.between(v["V_0"] + third, v["V_1"] - third),
            "d": min(v["d_const"], v["d_slope"] * y**2, key=float) * self.share(),
            "C": v["c"] + self.between(-v["Delta_theta"] / 4, v["Delta_theta"] / 4),
            "g": y,
            "clock": arb(0),
        }
        found = self.with_vectors(v)
        if found is not None:
            found |= {f"{name}_start": found[name] for name in NAMES}
        return found

    def with_vectors(self, v: Values) -> Values | None:
        """The same with inner products of vectors that have these components."""
        if not v["C"] < 1:
            return None
        omega_s, omega_c = [arb(0)] * self.dimension, [arb(0)] * self.dimension
        omega_s[0], omega_c[0], omega_c[1] = arb(1), -v["C"], (1 - v["C"] ** 2).sqrt()
        W_s = self.velocity(omega_s, v["eta_s"], v["B"])
        W_c = self.velocity(omega_c, -v["y"], v["A"])
        return v | {"a": dot(omega_s, W_c), "b": dot(omega_c, W_s), "w": dot(W_s, W_c)}

    def velocity(self, omega: Vector, normal: arb, square: arb) -> Vector:
        """A vector with a normal component and a norm."""
        draw = [balls.from_fraction(Fraction(self.random.randrange(-99, 99), 100)) for _ in omega]
        draw[-1] += balls.from_fraction(Fraction(1, 1000))
        part = dot(draw, omega)
        across = [p - part * q for p, q in zip(draw, omega, strict=True)]
        length = ((square - normal**2) / dot(across, across)).sqrt()
        return [normal * p + length * q for p, q in zip(omega, across, strict=True)]


def evaluate(terms: Mapping[str, Any], values: Values) -> Values:
    """The values of terms."""
    program = Program(values)
    slots = {name: program.add(term) for name, term in terms.items()}
    run = Machine(program, BallArithmetic()).run(list(values.values())).values
    return {name: run[slot] for name, slot in slots.items()}


def checker(
    contexts: Iterable[Context], claims: Mapping[str, Claim], names: list[str]
) -> Callable[[Values], list[str]]:
    """A function that says which claims are certainly false at given values of these names."""
    program = Program(names)
    for context in contexts:
        for constant in context.constants:
            program.define(constant.name, constant.term)
    slots = {n: (program.add(c.lhs), program.add(c.rhs)) for n, c in claims.items()}
    machine = Machine(program, BallArithmetic())

    def violated(values: Values) -> list[str]:
        found = machine.run([values[name] for name in names]).values
        bad = [n for n, (x, z) in slots.items() if found[x] is None or found[z] is None]
        return bad + [
            name
            for name, (x, z) in slots.items()
            if name not in bad and fails(claims[name].relation, found[x], found[z])
        ]

    return violated
