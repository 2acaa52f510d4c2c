"""What one collision changes, and times and distances compared, for every state of the mapping.

Printed as O(...), these inequalities hold at each collision, with constants; some are equations.
Where the text divides, both sides are multiplied.
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
from verify.paper.letters import Refuted, minus, refuted
from verify.paper.rows import HARMLESS

NORMALS = "EQUATSS3.3PROPOComp1_eta'"
TURNS = "EQUATSS3.3PROPOComp1omga'"
TANGENTS = "EQUATSS3.3PROPOComp1PerpD"

TIMES = "EQUATSS3.3AsympCompa_Tau_Zeta_"
BY_TIME = "EQUATSS3.3PROPOComp1Tau_d"
TRAVEL = "EQUATSS3.3PROPOComp1_d'__"
SQUARE = "EQUATSS3.3CompaAsymp_d__3"
LEADING = "EQUATSS3.3CompaAsympTauV3"
PROPOSITION = "PROPOSS3.3AsympCompa__I__"

d, y, S, tau, A, B, D, eta = n.d, n.y, n.S, n.tau, n.A, n.B, n.D, n.eta
one_d = plus(1, "map-d-positive")
fly = times(one_d, "map-closing", "map-tau-positive")
#: eta_1 tau + |W_1|^2 tau^2 / 2
first = eta * tau + B * tau**2 / 2


def chapters() -> Iterator[Chapter]:
    """The root, the time, the parameter of Zhou and Kadanoff, and the distance of the spectator."""
    yield Chapter(n.context, (*_root(), *_times(), *_zeta(), *_travel()))


def _root() -> Iterator[Item]:
    yield from (
        Line("A-positive", 0 < A, proof("map-cs-2", power("map-closing", 2))),
        Line("B-positive", 0 < B, proof("map-cs-1", power("map-receding", 2))),
        Line("S-one",      0 < 1 - S,
             scaled(times("goal", one_d, "map-closing"), times("A-positive", "map-tau-positive"))
             ._replace(equations=(("map-speed-time", as_term(-1)),))),
        Line("root-lower", (1 - S**2) / 2 <= 1 - S, proof(times(Fraction(1, 2), square(1 - S))),
             PROPOSITION, "x/2 ≤ 1-√(1-x), where √(1-x) = S"),
        Line("root-upper", 1 - S <= 1 - S**2, proof(times("map-S-positive", "S-one")),
             PROPOSITION, "1-√(1-x) ≤ x"),
    )  # fmt: skip


def _times() -> Iterator[Item]:
    contact = "map-contact-time"
    last = times("map-d-positive", one_d, "map-S-positive", "S-one", plus(2, "map-S-positive"))
    yield from (
        Line("time-lower",       d * (2 + d) <= 2 * (1 + d) * y * tau,
             proof(times(fly, "S-one"), equations=((contact, as_term(1)),)),
             TIMES, "d(2+d)/(2(1+d)(-η₂)) ≤ τ"),
        Line("time-upper",       (1 + d) * y * tau <= d * (2 + d),
             proof(times(fly, "map-S-positive"), equations=((contact, as_term(-1)),)),
             TIMES, "τ ≤ d(2+d)/((1+d)(-η₂))"),
        Line("distance-by-time", d <= 2 * y * tau,
             scaled(times("goal", one_d), "time-lower", "map-d-positive"),
             BY_TIME, "d ≤ 2τ(-η₂): so d = o(τ) and d = o(-η₂) where η₂ and τ tend to 0"),
        Line("time-by-distance", y * tau <= 2 * d,
             scaled(times("goal", one_d), "time-upper", power("map-d-positive", 2)),
             "EQUATSS3.3CompaAsympTauV2",
             "τ ≤ 2d/(-η₂): with the row before, τ and d/(-η₂) are of one order"),
        Line("time-leading",     d <= (1 + d) * y * tau,
             scaled(times("goal", 2), "time-lower", power("map-d-positive", 2)),
             LEADING, "d/(-η₂) ≤ (1+d)τ"),
        Line("time-trailing",    y * tau <= d * (2 - S**2),
             scaled(times("goal", one_d, plus(1, "map-S-positive")), power("map-d-positive", 2),
                    last)
             ._replace(equations=((contact, as_term(-1)),)),
             LEADING, "τ ≤ (1+ζ) d/(-η₂): with the row before, τ ~ d/(-η₂) where ζ tends to 0"),
    )  # fmt: skip


def _zeta() -> Iterator[Item]:
    left = (1 - S**2) * (1 + d) ** 2 * y**2
    value = "zeta-value"
    twice, thrice = times(2, "map-d-positive"), times(3, "map-d-positive")
    whole = power(one_d, 2)
    push = times("map-d-positive", "map-d-positive", "A-positive")
    yield from (
        Line(value, equal(left, d * (2 + d) * A),
             identity("", (("map-contact-time", A), ("map-speed-time", -((1 + d) * y * (1 + S))))),
             "EQUATSS2.2DefinParZK_zeta", "ζ = d(2+d)|W₂|²/((1+d)²η₂²), where S² = 1-ζ"),
        Line("discriminant",   equal((2 * (1 + d) * -y) ** 2 - 4 * A * d * (2 + d),
                                     4 * ((1 + d) * y * S) ** 2),
             identity("", ((value, as_term(4)),)), "EQUATSS2.2DiscrTrinox2-x0",
             "Δ = 4[(1+d)²η₂² - d(2+d)|W₂|²] = 4(1+d)²η₂²(1-ζ)"),
        Line("zeta-below-one", d * (2 + d) * A < (1 + d) ** 2 * y**2,
             proof(times(power("map-S-positive", 2), whole, power("map-closing", 2)),
                   equations=((value, as_term(1)),)),
             SQUARE, "d < (1+d)²/(2+d) η₂²/|W₂|²: so d = O(η₂²) where |W₂| does not tend to 0"),
        Line("zeta-upper",     (1 - S**2) * y**2 <= 2 * d * A,
             scaled(times("goal", whole), times(push, plus(3, twice)))
             ._replace(equations=((value, as_term(-1)),)), LEADING, "ζ ≤ 2d|W₂|²/η₂²"),
        Line("zeta-lower",     d * A * (2 - 3 * d) <= (1 - S**2) * y**2,
             scaled(times("goal", whole), times(push, "map-d-positive", plus(4, thrice)))
             ._replace(equations=((value, as_term(1)),)), LEADING, "(2-3d) d|W₂|²/η₂² ≤ ζ"),
        Line("distance-half",  equal((2 + d) * (2 * d * A - y**2),
                                     y**2 * (2 * (1 + d) ** 2 * (1 - S**2) - (2 + d))),
             identity("", ((value, as_term(-2)),)), PROPOSITION,
             "2d|W₂|² exceeds η₂² as soon as S² = 1-ζ is below 1 - (2+d)/(2(1+d)²), at any d > 0"),
    )  # fmt: skip


def _travel() -> Iterator[Item]:
    distance = "map-distance"
    gains = (
        times(2, "map-receding", "map-tau-positive"),
        times("B-positive", "map-tau-positive", "map-tau-positive"),
    )
    yield from (
        Line("longer",       0 < D - 1,
             scaled(times("goal", plus(1, "map-D-positive")), *gains)
             ._replace(equations=((distance, as_term(1)),)),
             TRAVEL, "0 < d': the spectator recedes"),
        Line("travel-upper", D - 1 <= first,
             scaled(times(2, "goal"), square(D - 1))._replace(equations=((distance, as_term(-1)),)),
             TRAVEL, "d' ≤ η₁τ + |W₁|²τ²/2"),
        Line("travel-lower", first - first**2 / 2 <= D - 1,
             scaled(times(2, "goal"),
                    times("travel-upper", plus("travel-upper", times(2, "longer"))))
             ._replace(equations=((distance, as_term(1)),)),
             TRAVEL, "and that is all but (η₁τ + |W₁|²τ²/2)²/2"),
    )  # fmt: skip


def misprints() -> Iterator[Refuted]:
    """What is false here, each with a point at which it is."""
    yield refuted(n, "distance-half-printed", 2 * d * A <= y**2,
                  "1/20 1/10 1 1 -1 1 -1 3993/700 1 1 1/10 21/121 142/121 0 0 0 0",
                  label=PROPOSITION,
                  says="ζ < 1, so d ≤ η₂²/(2|W₂|²) for n large: the factor (1+d)²/(2+d) is above "
                       "1/2", severity=HARMLESS, corrected_by="zeta-below-one")  # fmt: skip


r = n.r


def changes() -> Iterator[Chapter]:
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
