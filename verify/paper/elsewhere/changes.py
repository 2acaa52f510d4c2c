"""What one collision changes: normal components, directions, tangential components.

Printed as O(...), the estimates are here inequalities with constants, for every state of the
mapping, or equations; where the text divides, both sides are multiplied.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from verify.language.argument import (
    Chapter,
    Item,
    Line,
    Value,
    identity,
    plus,
    power,
    proof,
    scaled,
    square,
    times,
)
from verify.language.terms import as_term, equal
from verify.language.vectors import scale
from verify.paper.elsewhere.estimates import one_d
from verify.paper.elsewhere.mapping import (
    W_1,
    W_2,
    bracket,
    c,
    dot,
    end,
    grown,
    half,
    kappa,
    n,
    new_1,
    new_2,
    omega_1,
    omega_2,
    p,
    rest_1,
    speed_1,
)
from verify.paper.letters import Refuted, minus

NORMALS = "EQUATSS3.3PROPOComp1_eta'"
TURNS = "EQUATSS3.3PROPOComp1omga'"
TANGENTS = "EQUATSS3.3PROPOComp1PerpD"
PROPOSITION = "PROPOSS3.3AsympCompa__I__"

d, y, S, tau, A, B, D, eta, r = n.d, n.y, n.S, n.tau, n.A, n.B, n.D, n.eta, n.r


def chapters() -> Iterator[Chapter]:
    """Normal components, their changes, directions, tangential components."""
    yield Chapter(n.context, (*_normals(), *_changes(), *_turns(), *_tangents()))


def _normals() -> Iterator[Item]:
    bound = times("goal", plus("goal", 2))
    part = half * c * (1 + d) * y * S
    more = plus("map-receding", times("map-tau-positive", "B-positive"))
    yield from (
        Line("cosine-square",  c**2 <= 1,
             scaled(times("goal", power("map-D-positive", 2)), "map-cs-turn")
             ._replace(equations=(("map-distance", as_term(1)), ("meets", -dot(end, end)),
                                  ("cosine", -(D * c + dot(end, new_2)))))),
        Line("cosine-upper",   c <= 1, scaled(bound, "cosine-square")),
        Line("cosine-lower",   -c <= 1, scaled(bound, "cosine-square")),
        Line("normal-1-value", equal(-(half * c * kappa), part),
             identity("", (("hit", -(half * c)),)),
             NORMALS, "so η₁' = (η₁+τ|W₁|²)/(1+d') + (1+r)/2 (ω₁'·ω₂')(1+d)√(1-ζ)(-η₂)"),
        Line("normal-1-upper", grown + part <= eta + tau * B + (1 + d) * y,
             proof(times(more, "longer"), _short("cosine-upper")),
             NORMALS, "η₁' ≤ η₁ + τ|W₁|² + (1+d)(-η₂)"),
        Line("normal-1-lower", -(grown + part) <= (1 + d) * y, proof(more, _short("cosine-lower")),
             NORMALS, "-η₁' ≤ (1+d)(-η₂)"),
        Line("normal-2-upper", -r * kappa <= r * (1 + d) * y,
             proof(times("map-r-positive", one_d, "map-closing", "S-one"), equations=(("hit", r),)),
             NORMALS, "η₂' ≤ r(1+d)(-η₂)"),
    )  # fmt: skip


def _short(cosine: str) -> Value:
    """D (1+d) y times 1 -+ (1+r)/2 c S, which is >= 0."""
    factor = times(Fraction(1, 2), plus(1, "map-r-positive"))
    rest = plus("S-one", times("map-S-positive", cosine))
    whole = plus(times(Fraction(1, 2), "map-r-one"), times(factor, rest))
    return times("map-D-positive", one_d, "map-closing", whole)


def _changes() -> Iterator[Item]:
    yield from (
        Line("change-1",
             equal(dot(speed_1, new_1) - eta + half * c * -y,
                   (tau * B - (D - 1) * eta) / D - half * c * (-(d * y) + tau * A)),
             identity("map-c map-kappa"), PROPOSITION,
             "η₁' - η₁ + (1+r)/2 (ω₁'·ω₂')η₂ = (τ|W₁|²-d'η₁)/(1+d') - (1+r)/2 "
             "(ω₁'·ω₂')(dη₂+τ|W₂|²)"),
        Line("change-2", equal(-r * kappa - r * y, -r * (-(d * y) + tau * A)),
             identity("map-kappa"), PROPOSITION, "η₂' + rη₂ = -r(dη₂ + τ|W₂|²)"),
    )  # fmt: skip


def _turns() -> Iterator[Item]:
    moved, turned = minus(end, scale(D, omega_1)), minus(new_2, omega_2)
    yield from (
        Line("turn-1", dot(moved, moved) <= D**2 * (tau**2 * B),
             proof(times("map-D-positive", square(D - 1)),
                   times("map-D-positive", "B-positive", power("map-tau-positive", 2), "longer"),
                   equations=(("map-distance", 1 - D),)),
             TURNS, "|ω₁'-ω₁| ≤ τ|W₁|, squared and times (1+d')²"),
        Line("turn-2", dot(turned, turned) <= tau**2 * A,
             proof(times("map-d-positive", "distance-by-time")),
             TURNS, "|ω₂'-ω₂| ≤ τ|W₂|, squared"),
    )  # fmt: skip


def _tangents() -> Iterator[Item]:
    flown_1 = minus(scale(eta, omega_1), scale(grown, new_1))
    cleared = minus(scale(D**2 * eta, omega_1), scale(eta + tau * B, end))
    across = minus(scale(c, end), scale(D, new_2))
    flown_2 = minus(scale(-y, omega_2), scale(kappa, new_2))
    yield from (
        Line("change-tangential-1",
             equal(dot(p, minus(rest_1(), minus(W_1, scale(eta, omega_1)))),
                   dot(p, flown_1) + half * kappa * dot(p, bracket)), identity(), TANGENTS,
             "(W₁⊥)'-W₁⊥ = η₁ω₁ - (η₁+τ|W₁|²)/(1+d') ω₁' + (1+r)/2 (W₂·ω₂')[(ω₁'·ω₂')ω₁'-ω₂']"),
        Line("flown-1", equal(dot(cleared, cleared), D**2 * (tau**2 * B * (B - eta**2))),
             identity("", (("map-distance", D**2 * eta**2 - (eta + tau * B) ** 2),)), TANGENTS,
             "the flight alone changes W₁⊥ by τ|W₁||W₁⊥|/(1+d'), squared and times (1+d')⁴"),
        Line("bracket-short", equal(dot(across, across), D**2 * (1 - c**2)),
             identity("", (("map-distance", -(c**2)), ("meets", D**2), ("cosine", 2 * c * D))),
             TANGENTS,
             "|(ω₁'·ω₂')ω₁'-ω₂'| ≤ 1: the collision changes W₁⊥ by at most (1+r)/2 (1+d)(-η₂)"),
        Line("change-tangential-2",
             equal(dot(p, minus(minus(W_2, scale(kappa, new_2)), minus(W_2, scale(-y, omega_2)))),
                   dot(p, flown_2)), identity(), TANGENTS, "(W₂⊥)'-W₂⊥ = η₂ω₂ - (W₂·ω₂')ω₂'"),
        Line("flown-2", equal(dot(flown_2, flown_2), tau**2 * A * (A - y**2)),
             identity("map-kappa", (("meets", dot(W_2, new_2) ** 2 - y**2),)),
             TANGENTS, "W₂⊥ changes by τ|W₂||W₂⊥| in length, squared"),
    )  # fmt: skip


def misprints() -> Iterator[Refuted]:
    """None here: `aligned` has the two equations of this part that are misprinted."""
    yield from ()
