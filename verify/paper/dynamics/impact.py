"""The law of collision, and that it gives the relative velocities of the collision map.

Particle 0 is hit by particle c; omega points from 0 to c, kappa = (v_c - v_0).omega < 0. Vectors
are compared by their components along an arbitrary direction e.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from verify.language.argument import Item, Line, identity
from verify.language.statement import Context, Variable
from verify.language.terms import as_term, equal, symbol

CONTEXT = "impact"
LAW = "EQUATSS2.2IterationSystm1"
LETTERS = {
    "e_r": ("r", "r"),
    "e_0": ("v₀·e", r"v_0\cdot e"),
    "e_c": ("v_c·e", r"v_c\cdot e"),
    "e_s": ("v_s·e", r"v_s\cdot e"),
    "e_omega": ("ω·e", r"\omega\cdot e"),
    "n_0": ("v₀·ω", r"v_0\cdot\omega"),
    "n_c": ("v_c·ω", r"v_c\cdot\omega"),
    "s_0": ("|v₀|²", "|v_0|^2"),
    "s_c": ("|v_c|²", "|v_c|^2"),
}
r, e_0, e_c, e_s, e_omega, n_0, n_c, s_0, s_c = map(symbol, LETTERS)
kappa = n_c - n_0
jump = (1 + r) / 2 * kappa


def context() -> Context:
    """The components of the velocities before a collision."""
    variables = tuple(Variable(name, *letters) for name, letters in LETTERS.items())
    point = {name: as_term(Fraction(1, 2)) for name in LETTERS}
    return Context(CONTEXT, variables, (), point, None, "two particles that collide")


def lines() -> Iterator[Item]:
    """After it v_0' = v_0 + J omega and v_c' = v_c - J omega with J = (1+r)/2 kappa."""
    new_0, new_c = e_0 + jump * e_omega, e_c - jump * e_omega
    for name, claim, says in (
        ("momentum", equal(new_0 + new_c, e_0 + e_c), "v_0' + v_c' = v_0 + v_c"),
        (
            "restitution",
            equal((n_c - jump) - (n_0 + jump), -(r * kappa)),
            "(v_c' - v_0')·ω = -r (v_c - v_0)·ω",
        ),
        (
            "velocity-s",
            equal(new_c - new_0, (e_c - e_0) - (1 + r) * kappa * e_omega),
            "W_s' = W_c - (1+r)(W_c·ω) ω",
        ),
        (
            "velocity-c",
            equal(e_s - new_0, (e_s - e_0) - (1 + r) / 2 * kappa * e_omega),
            "W_c' = W_s - (1+r)/2 (W_c·ω) ω",
        ),
        (
            "energy",
            equal(
                (s_0 + 2 * jump * n_0 + jump**2) + (s_c - 2 * jump * n_c + jump**2),
                s_0 + s_c - (1 - r**2) / 2 * kappa**2,
            ),
            "|v_0'|² + |v_c'|² = |v_0|² + |v_c|² - (1-r²)/2 ((v_c - v_0)·ω)²",
        ),
    ):
        yield Line(f"impact-{name}", claim, identity(), LAW, says)
