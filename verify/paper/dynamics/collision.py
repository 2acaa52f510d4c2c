"""The laws of Section 4 as identities of the collision map."""

from __future__ import annotations

from collections.abc import Iterator

from verify.language.argument import Defined, Item, Line, identity, proof, times
from verify.language.terms import as_term, equal
from verify.language.vectors import W_s
from verify.paper.dynamics.state import (
    A,
    A_next,
    B,
    B_next,
    C,
    C_next,
    D,
    S,
    a,
    b,
    d,
    eta_s,
    eta_s_next,
    frame,
    gained,
    inequalities,
    kappa,
    kept,
    omega_next,
    r,
    tau,
    w,
    y,
    y_next,
)

COMPONENTS = "EQUATSS4.1EvoluCompoNormC"
NORMS = "EQUATSS4.1EvoluNormeVitRl"
ANGLE = "EQUATSS4.1EvoluCosinAngle"

half = (1 + r) / 2
#: -W_c.omega_s' = (1+d) sqrt(1-zeta) (-eta_c), the speed of the impact.
impact = (1 + d) * y * S
spin = frame.dot(W_s, omega_next)
turn = (1 + d) * C - tau * a - (1 + d) * tau * b - tau**2 * w

#: The cosine without a quotient.
TURN = Line("turn", equal(D * C_next, turn), identity("law-angle"))
SPIN_SQUARE = Line("spin-square", spin**2 <= B, proof("impact-pair", equations=(("contact", -B),)))
IMPACT_POSITIVE = Line(
    "impact-positive",
    0 < impact,
    proof(times("d-sum-positive", "Cnd1", "S-positive")),
    COMPONENTS,
    "W_c·ω_s' < 0: at the contact the pair approaches",
)


def at_the_contact(name: str, pair: str, using: str = "tau") -> Line:
    """A Cauchy-Schwarz inequality that uses the time to the collision, under the name of that."""
    claim = inequalities(frame, tau, (pair,))[pair]
    return Line(name, claim, proof(pair, using=using))


def laws() -> Iterator[Item]:
    """The next state, number by number."""
    for name in ("kappa", "C_next", "y_next", "eta_s_next", "A_next", "B_next"):
        yield Defined(name)
    for name in ("a_next", "b_next", "w_next"):
        yield Defined(name)
    yield from (
        Line("impact-speed", equal(kappa, -impact), identity("kappa tau S"), COMPONENTS,
             "W_c·ω_s' = -(1+d)√(1-ζ)(-η_c)"),
        Line("law-angle", equal(C_next, turn / D), identity("C_next"), ANGLE,
             "-cos θ' = [(1+d)(-cos θ) - τ ω_s·W_c - (1+d)τ ω_c·W_s - τ² W_s·W_c]/(1+d')"),
    )  # fmt: skip
    yield from _components()
    yield from _norms()


def _components() -> Iterator[Item]:
    yield from (
        Line("law-eta-c", equal(y_next, half * impact * C_next - (eta_s + tau * B) / D),
             identity("y_next C_next impact-speed"), COMPONENTS,
             "η_c' = η_s/(1+d') - (1+r)/2 (1+d)√(1-ζ)(-cos θ')(-η_c) + τ|W_s|²/(1+d')"),
        Line("law-eta-s", equal(eta_s_next, r * impact),
             identity("eta_s_next",
                      (("contact", -((1 + r) * kappa)), ("kappa", as_term(-1)),
                       ("impact-speed", -r))), COMPONENTS, "η_s' = r(1+d)√(1-ζ)(-η_c)"),
    )  # fmt: skip


def _norms() -> Iterator[Item]:
    yield from (
        Line("law-norm-c", equal(A_next, B - (1 + r) * kappa * spin + half**2 * kappa**2),
             identity("A_next", (("contact", half**2 * kappa**2),)), NORMS,
             "|W_c'|² = |W_s|² - (1+r)(W_c·ω_s')(W_s·ω_s') + ((1+r)²/4)(W_c·ω_s')²"),
        Line("law-norm-s", equal(B_next, A - (1 - r**2) * kappa**2),
             identity("B_next",
                      (("contact", (1 + r) ** 2 * kappa**2), ("kappa", 2 * (1 + r) * kappa))),
             NORMS, "|W_s'|² = |W_c|² - (1-r²)(W_c·ω_s')²"),
    )  # fmt: skip


def parts() -> Iterator[Item]:
    """The two parts of the normal component of W_s after the flight."""
    yield from (
        Defined("kept"),
        Defined("gained"),
        Line("gained-positive", 0 < gained,
             proof(times("tau-positive", "B-positive"), using="gained")),
        Line("normal-parts", equal(y_next, half * impact * C_next - kept - gained),
             identity("law-eta-c kept gained")),
        Line("kept-upper", kept <= eta_s, proof(times("recedes", "D-one"), using="kept")),
    )  # fmt: skip


#: What is gained, without a quotient.
GAINED_UPPER = Line(
    "gained-upper",
    gained <= tau * B,
    proof(times("tau-positive", "B-positive", "D-one"), using="gained"),
)
