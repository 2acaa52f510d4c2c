"""Two balls at contact: the law of the collision, its energy, and a third ball.

e is the unit vector from i to j, f that from i to a ball k that does not collide; u is orthogonal
to e, and p is any vector. Nothing but inner products is used.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from verify.language.argument import Chapter, Item, Line, Opened, identity, plus, proof, times
from verify.language.terms import as_term, equal
from verify.language.vectors import add, basis_vector, scale
from verify.paper.letters import Letters, Refuted, Space, minus, refuted
from verify.paper.rows import OTHERWISE, REMARK, SLIP

LAW = "EQUATSS2.1VitesPost-Colli"
FLOW = "DEFINSS2.1FlotrInelaSphDu"
PARTS = "DEFINSS2.1DecmpVitesNrmTg"
NORMAL = "REMARSS2.1DissiCompoNorma"
ENERGY = "EQUATSS2.1DissiEnergCinet"
SUMMABLE = "PROPOSS3.2SommaCompNormlV"

n = Letters(
    "pair", r="r", eta="η", e_i="e·v_i", s_i="|v_i|²", s_j="|v_j|²", m="v_i·v_j", p_e="p·e",
    p_i="p·v_i", p_j="p·v_j", p_k="p·v_k", p_u="p·u", f_e="f·e", f_i="f·v_i", f_j="f·v_j",
    f_k="f·v_k",
)  # fmt: skip
e, v_i, v_j, v_k, p, f, u = map(basis_vector, ("e", "v_i", "v_j", "v_k", "p", "f", "u"))
space = Space({
    ("e", "e"): as_term(1), ("e", "u"): as_term(0), ("e", "v_i"): n.e_i,
    ("e", "v_j"): n.e_i + n.eta, ("v_i", "v_i"): n.s_i, ("v_j", "v_j"): n.s_j, ("v_i", "v_j"): n.m,
    ("p", "e"): n.p_e, ("p", "v_i"): n.p_i, ("p", "v_j"): n.p_j, ("p", "v_k"): n.p_k,
    ("p", "u"): n.p_u, ("f", "e"): n.f_e, ("f", "v_i"): n.f_i, ("f", "v_j"): n.f_j,
    ("f", "v_k"): n.f_k,
})  # fmt: skip
dot = space.dot
half = (1 + n.r) / 2
W = minus(v_j, v_i)
tangential = minus(W, scale(dot(W, e), e))
# (v_i - v_j)·e e, as the law has it
blow = scale(half * dot(minus(v_i, v_j), e), e)
new_i, new_j = minus(v_i, blow), add(v_j, blow)
new_W = minus(new_j, new_i)
# the same with -e for e
other_i = minus(v_i, scale(half * dot(minus(v_i, v_j), scale(-1, e)), scale(-1, e)))


def chapters() -> Iterator[Chapter]:
    """The law in all its forms, for any vector p; approach is asked for where it is needed."""
    context = n.opened(
        "balls i and j at contact, e the unit vector from i to j, η = (v_j-v_i)·e; f points from "
        "i to a ball k that does not collide, u is orthogonal to e, p any vector",
        "1/2 -1 0 1 1 0 1 0 0 0 1 1/2 0 0 0",
        {"r-positive": 0 < n.r, "r-one": n.r < 1},
    )
    yield Chapter(None, (Opened(context),))
    yield Chapter(n.context, (*_law(), *_energy(), *_third()))
    yield from _approach()


def _law() -> Iterator[Item]:
    for name, claim, label, says in (
        ("momentum-kept",         equal(dot(p, add(new_i, new_j)), dot(p, add(v_i, v_j))),
         LAW, "the law keeps the momentum, along every p"),
        ("normal-reversed",       equal(dot(new_W, e), -n.r * n.eta), NORMAL, "η' = -rη"),
        ("tangential-kept",       equal(dot(p, minus(new_W, scale(dot(new_W, e), e))),
                                        dot(p, tangential)), PARTS,
         "the law keeps the tangential component: p·(W⊥)' = p·W⊥ for every p"),
        ("tangential-orthogonal", equal(dot(tangential, e), 0),
         PARTS, "W⊥ = W - (W·e)e is orthogonal to e"),
        ("direction-even",        equal(dot(p, other_i), dot(p, new_i)),
         LAW, "the law is the same with -e for e: x_i-x_j in the law, x_j-x_i later"),
        ("two-laws-momentum",     equal(dot(p, add(add(new_i, u), minus(new_j, u))),
                                        dot(p, add(v_i, v_j))), LAW,
         "v_i'+u and v_j'-u, for any u orthogonal to e, keep the momentum too"),
        ("two-laws-normal",       equal(dot(minus(minus(new_j, u), add(new_i, u)), e),
                                        -n.r * n.eta), LAW, "and turn η into -rη too"),
    ):  # fmt: skip
        yield Line(name, claim, identity(), label, says)


def _energy() -> Iterator[Item]:
    before = (dot(v_i, v_i) + dot(v_j, v_j)) / 2
    after = (dot(new_i, new_i) + dot(new_j, new_j)) / 2
    total = add(v_i, v_j)
    yield from (
        Line("energy-loss",  equal(after, before - (1 - n.r**2) / 4 * n.eta**2), identity(),
             ENERGY, "E' = E - (1-r²)/4 η², E half the sum of the squares of the two speeds"),
        Line("energy-parts",
             equal(after,
                   (dot(total, total) + dot(tangential, tangential) + (n.r * n.eta) ** 2) / 4),
             identity(), ENERGY, "E' = |v_i+v_j|²/4 + |W⊥|²/4 + r²η²/4"),
    )  # fmt: skip


def _third() -> Iterator[Item]:
    seen = minus(v_k, new_i)
    yield from (
        Line("third-velocity",
             equal(dot(p, seen), dot(p, minus(v_k, v_i)) + half * dot(minus(v_i, v_j), e) * n.p_e),
             identity(), SUMMABLE,
             "where k does not collide, v_k' - v_i' = v_k - v_i + (1+r)/2 ((v_i-v_j)·e)e"),
        Line("third-normal",   equal(dot(seen, f), dot(minus(v_k, v_i), f) - half * n.eta * n.f_e),
             identity(), SUMMABLE,
             "so its normal component, along f, changes by -(1+r)/2 η (e·f), both directions from "
             "i"),
    )  # fmt: skip


# --- approach -------------------------------------------------------------------------------------

g = Letters("approach", r="r", eta="η")


def _approach() -> Iterator[Chapter]:
    """After a collision of a pair that approaches it recedes."""
    givens = {"r-positive": 0 < g.r, "r-one": g.r < 1, "closing": g.eta < 0}
    context = g.opened("a pair at contact that approaches", "1/2 -1", givens)
    yield Chapter(None, (Opened(context),))
    yield Chapter(g.context, (
        Line("recedes-after", 0 < -g.r * g.eta,
             proof(times("approach-r-positive", "approach-closing")),
             FLOW, "a pair that approaches at contact recedes after the collision"),
        Line("energy-lost",   0 < (1 - g.r**2) / 4 * g.eta**2,
             proof(times(Fraction(1, 4), "approach-r-one", plus(1, "approach-r-positive"),
                         "approach-closing", "approach-closing")),
             ENERGY, "and the collision dissipates energy"),
    ))  # fmt: skip


def misprints() -> Iterator[Refuted]:
    """What is false here, each with a point at which it is."""
    yield from (
        refuted(n, "two-laws-determine", equal(dot(p, add(new_i, u)), dot(p, new_i)),
                "1/2 -1 0 1 1 0 1 0 0 0 1 1/2 0 0 0", label=LAW,
                says="the introduction: conservation of momentum and the law for the normal "
                     "component give the velocities, and with them the tangential components",
                severity=OTHERWISE, corrected_by="tangential-kept"),
        refuted(n, "law-at-every-contact", 0 <= dot(new_W, e), "1/2 1 0 1 1 0 1 0 0 0 1 1/2 0 0 0",
                label=FLOW,
                says="the law of collision applies whenever a pair touches, even if it recedes, "
                     "and the pair then recedes: the definition speaks of any contact, and means "
                     "a pair that approaches", severity=REMARK, corrected_by="recedes-after"),
        refuted(n, "colliding-pair-index", equal(dot(new_W, e), n.eta + half * n.eta * dot(e, e)),
                "1/2 -1 0 1 1 0 1 0 0 0 1 1/2 0 0 0", label=SUMMABLE,
                says="η'_(i,k) = η_(i,k) + (1+r)/2 η_(i,k) ω_(i,k)·ω_(i,k): in the second case of "
                     "the proof the pair (i,k) that collides stands for the pair (i,j) that does "
                     "not", severity=SLIP, corrected_by="third-normal"),
    )  # fmt: skip
