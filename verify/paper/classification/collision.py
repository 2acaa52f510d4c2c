"""A collision: what it does to the two balls, and to rho of one of them and a free ball.

Balls i and j touch; e points from i to j, and rho = e.(v_j - v_i) < 0. The impulse J e goes from i
to j and leaves rho' with 0 <= rho' <= -rho. f and g point from i and from j to a free ball k, and
p, q are any two vectors. Masses, distances and dimension are arbitrary.
"""

from __future__ import annotations

from collections.abc import Iterator

from verify.language.argument import (
    Chapter,
    Defined,
    Item,
    Line,
    Opened,
    identity,
    plus,
    proof,
    times,
)
from verify.language.statement import Constant, Context
from verify.language.terms import Term, as_term, equal, symbol
from verify.language.vectors import Combination, add, basis_vector, scale
from verify.paper.letters import Letters, Space, minus

CONTEXT = "collision"
LAW = "EQUATSS2.1VitesPost-Colli"
ENERGY = "EQUATSS2.1DissiEnergCinet"
PARTS = "DEFINSS2.1DecmpVitesNrmTg"

n = Letters(
    CONTEXT, m_i="m_i", m_j="m_j", sigma="σ", rho="ρ", rho_new="ρ'", e_i="e·v_i", s_i="|v_i|²",
    s_j="|v_j|²", f_e="f·e", f_i="f·v_i", f_k="f·v_k", g_e="g·e", g_j="g·v_j", g_k="g·v_k",
    x_e="x_i·e", x_i="x_i·v_i", x_j="x_i·v_j", p_e="p·e", p_x="p·x_i", p_i="p·v_i", p_j="p·v_j",
    q_e="q·e", q_x="q·x_i", q_i="q·v_i", q_j="q·v_j",
)  # fmt: skip
mu, J = symbol("mu"), symbol("J")
NAMES = ("e", "f", "g", "p", "q", "v_i", "v_j", "v_k", "x_i")
e, f, g, p, q, v_i, v_j, v_k, x_i = map(basis_vector, NAMES)
space = Space({
    ("e", "e"): as_term(1), ("e", "v_i"): n.e_i, ("e", "v_j"): n.e_i + n.rho, ("v_i", "v_i"): n.s_i,
    ("v_j", "v_j"): n.s_j, ("f", "e"): n.f_e, ("f", "v_i"): n.f_i, ("f", "v_k"): n.f_k,
    ("g", "e"): n.g_e, ("g", "v_j"): n.g_j, ("g", "v_k"): n.g_k, ("x_i", "e"): n.x_e,
    ("x_i", "v_i"): n.x_i, ("x_i", "v_j"): n.x_j,
    **{(letter, other): getattr(n, f"{letter}_{short}") for letter in ("p", "q")
       for other, short in (("e", "e"), ("x_i", "x"), ("v_i", "i"), ("v_j", "j"))},
})  # fmt: skip
dot = space.dot
x_j = add(x_i, scale(n.sigma, e))
new_i = minus(v_i, scale(J / n.m_i, e))
new_j = add(v_j, scale(J / n.m_j, e))


def context() -> Context:
    """Two balls that collide, with a free one."""
    given = {
        "mass-i": 0 < n.m_i,
        "mass-j": 0 < n.m_j,
        "contact": 0 < n.sigma,
        "approach": n.rho < 0,
        "inelastic-lower": 0 <= n.rho_new,
        "inelastic-upper": n.rho_new <= -n.rho,
    }
    found = n.opened(
        "balls i and j touch and approach, e is the unit vector from i to j, ρ = e·(v_j-v_i); f "
        "and g point from i and j to a third ball k, p and q are any vectors",
        "1 1 1 -1 " + " ".join("0" * (len(n.letters) - 4)),
        given,
    )
    reduced = n.m_i * n.m_j / (n.m_i + n.m_j)
    return found._replace(
        constants=(
            Constant("mu", "μ", r"\mu", LAW, reduced),
            Constant("J", "J", "J", LAW, mu * (n.rho_new - n.rho)),
        )
    )


def chapters() -> Iterator[Chapter]:
    """The law, the two balls with a free one, the sums over all balls, and equal masses."""
    yield Chapter(None, (Opened(context()),))
    yield Chapter(CONTEXT, (*_law(), *_free(), *_dissipation(), *_sums()))
    yield from _equal()


def _law() -> Iterator[Item]:
    masses = plus("collision-mass-i", "collision-mass-j")
    yield from (
        Line("mass-sum", 0 < n.m_i + n.m_j, proof(masses)),
        Defined("mu"),
        Line("reduced-mass", 0 < mu,
             proof(times("collision-mass-i", "collision-mass-j"), using="mu"),
             LAW, "the reduced mass is positive"),
        Defined("J"),
        Line("impulse-least", mu * -n.rho <= J,
             proof(times("reduced-mass", "collision-inelastic-lower"), using="J"),
             LAW, "the impulse is at least μ|ρ|: so what sums over J sums over |ρ|"),
        Line("impulse-positive", 0 < J,
             proof("impulse-least", times("reduced-mass", "collision-approach")),
             LAW, "the impulse is positive"),
        Line("restitution", equal(dot(e, new_j) - dot(e, new_i), n.rho_new), identity("J mu"),
             LAW, "the collision law, with J = μ(ρ'-ρ), turns ρ into ρ'", ("hard-spheres",)),
        Line("momentum",
             equal(n.m_i * dot(p, new_i) + n.m_j * dot(p, new_j),
                   n.m_i * dot(p, v_i) + n.m_j * dot(p, v_j)), identity(), LAW,
             "and keeps the momentum along every p", ("hard-spheres",)),
    )  # fmt: skip


def _free() -> Iterator[Item]:
    uses = ("hard-spheres",)
    yield from (
        Line("free-i",
             equal(dot(f, minus(v_k, new_i)), dot(f, minus(v_k, v_i)) + J / n.m_i * n.f_e),
             identity(), PARTS, "ρ_ik grows by (J/m_i) times the cosine of the angle at i", uses),
        Line("free-j",
             equal(dot(g, minus(v_k, new_j)), dot(g, minus(v_k, v_j)) + J / n.m_j * -n.g_e),
             identity(), PARTS,
             "ρ_jk grows by (J/m_j) times the cosine of the angle at j (-e points from j to i)",
             uses),
    )  # fmt: skip


def _dissipation() -> Iterator[Item]:
    energy = _energy(new_i, new_j) - _energy(v_i, v_j)
    both = times(
        "collision-inelastic-upper", plus("collision-approach", "collision-inelastic-lower")
    )
    yield from (
        Line("energy-law", equal(energy, mu * (n.rho_new**2 - n.rho**2)), identity("J mu"), ENERGY,
             "e² changes by μ(ρ'²-ρ²), which is -(1-r²)μρ² where ρ' = -rρ", ("hard-spheres",)),
        Line("energy-falls", mu * (n.rho_new**2 - n.rho**2) <= 0,
             proof(times("reduced-mass", both)), ENERGY, "e² never rises"),
    )  # fmt: skip


def _sums() -> Iterator[Item]:
    uses = ("hard-spheres",)
    difference = minus(new_i, v_i)
    yield from (
        Line("virial-law",      equal(_virial(new_i, new_j) - _virial(v_i, v_j), J * n.sigma),
             identity(), LAW, "A = Σ m x·v grows by Jσ", uses),
        Line("virial-rises",    0 < J * n.sigma,
             proof(times("impulse-positive", "collision-contact")), LAW, "A jumps up"),
        Line("spin-law",        equal(_spin(new_i, new_j), _spin(v_i, v_j)), identity(),
             LAW, "the angular momentum is kept: Σ m ((x·p)(v·q)-(x·q)(v·p)) for all p, q", uses),
        Line("velocity-change", equal(dot(difference, difference), (J / n.m_i) ** 2), identity(),
             LAW, "v_i changes by J/m_i in length", uses),
    )  # fmt: skip


def _energy(first: Combination, second: Combination) -> Term:
    return n.m_i * dot(first, first) + n.m_j * dot(second, second)


def _virial(first: Combination, second: Combination) -> Term:
    return n.m_i * dot(x_i, first) + n.m_j * dot(x_j, second)


def _spin(first: Combination, second: Combination) -> Term:
    parts = [
        mass * (dot(p, x) * dot(q, velocity) - dot(q, x) * dot(p, velocity))
        for mass, x, velocity in ((n.m_i, x_i, first), (n.m_j, x_j, second))
    ]
    return parts[0] + parts[1]


same = Letters("equal", m="m", rho="ρ", r="r")


def _equal() -> Iterator[Chapter]:
    """Balls of equal mass with one coefficient of restitution, as in the text."""
    context = same.opened(
        "two balls of the same mass with ρ' = -rρ, r > 0",
        "1 -1 1/2",
        {"mass": 0 < same.m, "share": 0 < same.r},
    )
    reduced = same.m * same.m / (2 * same.m)
    line = Line("equal-masses",
                equal(reduced * (-(same.r * same.rho) - same.rho) / same.m,
                      (1 + same.r) / 2 * -same.rho), identity(), LAW,
                "for equal masses and ρ' = -rρ each velocity changes by J/m = (1+r)/2 (-ρ)",
    )  # fmt: skip
    inverse = Line("equal-inverse",
                   equal(-(same.r * same.rho) - same.rho, (1 + 1 / same.r) * -(same.r * same.rho)),
                   identity(), LAW,
                   "for any masses ρ'-ρ = (1+1/r)ρ' where ρ' = -rρ: what follows a collision "
                   "determines J")  # fmt: skip
    double = Line("equal-double", 0 < 2 * same.m, proof(times(2, "equal-mass")))
    yield Chapter(None, (Opened(context),))
    yield Chapter(same.context, (double, line, inverse))
