"""One collision as the collision map has it: the flight before it, and the laws of Section 4.

What is used of a state are facts with these names: Cnd1 (0 < y), Cnd3 (0 < 1-zeta), d-positive,
d-sum-positive (0 < 1+d), recedes (0 < eta_s), A-positive and B-positive.
"""

from __future__ import annotations

from collections.abc import Iterator

from verify.language.argument import (
    ByRoot,
    Defined,
    Factor,
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
from verify.language.terms import Term, as_term, equal, sqrt
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
    d_next,
    end,
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
    zeta,
    zeta_of,
)

COMPONENTS = "EQUATSS4.1EvoluCompoNormC"
NORMS = "EQUATSS4.1EvoluNormeVitRl"
ANGLE = "EQUATSS4.1EvoluCosinAngle"

TIME = "EQUATSS4.1_Controle_Tau_n"
DISTANCE = "EQUATSS4.1BorneDista_d_1_"

dot = frame.dot


def absolute(
    name: str,
    term: Term,
    bound: tuple[Term, Factor],
    facts: tuple[Value, ...],
    label: str = "",
    says: str = "",
) -> Iterator[Item]:
    """|x| <= bound, both halves, for facts that add up to x^2 <= bound^2 and one that it is > 0."""
    goal = times("goal", plus("goal", times(2, bound[1])))
    for suffix, side in (("upper", term), ("lower", -term)):
        yield Line(f"{name}-{suffix}", side <= bound[0], scaled(goal, *facts), label, says)


def components(c: tuple[Term, Factor], s: tuple[Term, Factor], both: Factor) -> Iterator[Item]:
    """Bounds of the other inner products, where c and s bound the speeds; ``both``: 0 < c s."""
    facts = (times("A-below", "B-positive"), times(square(c[0]), "B-below"))
    yield from absolute("a", a, c, ("cs-a", "A-below"))
    yield from absolute("b", b, s, ("cs-b", "B-below"))
    product = c[0] ** 2 if c == s else c[0] * s[0]
    yield from absolute("w", w, (product, both), ("cs-w", *facts))
    yield Line("C-one", C <= 1, scaled(times("goal", plus("goal", 2)), "cs-omega"))


def root() -> Iterator[Item]:
    """The root that the time of the contact needs."""
    yield from (
        Defined("zeta"),
        Line("root-positive", 0 < sqrt(1 - zeta_of(frame)), ByRoot()),
        Defined("S"),
        Defined("tau"),
        Line("S-positive", 0 < S, proof("root-positive", using="S")),
        Line("S-square", equal(zeta, 1 - S**2), identity("zeta S"), "EQUATSS4.1Recurrence_Cnd3",
             "ζ = 1 - √(1-ζ)²"),
    )  # fmt: skip


def between_zero_and_one() -> Iterator[Item]:
    """Zeta and its root lie between 0 and 1."""
    cnd3 = "EQUATSS4.1Recurrence_Cnd3"
    yield from (
        Line("zeta-positive", 0 < zeta,
             proof(times("d-positive", plus(2, "d-positive"), "A-positive"), using="zeta"), cnd3,
             "0 < ζ"),
        Line("zeta-one", 0 < 1 - zeta, proof("Cnd3", using="zeta"), cnd3, "ζ < 1"),
        Line("zeta-product", equal(d * (2 + d) * A, zeta * (1 + d) ** 2 * y**2), identity("zeta"),
             cnd3, "ζ = d(2+d)|W_c|²/((1+d)²η_c²)"),
        Line("S-one", 0 < 1 - S,
             scaled(times("goal", plus(1, "S-positive")), "zeta-positive", using="S-square")),
    )  # fmt: skip


def time(positive: Value) -> Iterator[Item]:
    """The time to the contact, and the contact; given why the time is positive."""
    yield from (
        Line("tau-positive", 0 < tau, proof(positive, using="tau S"), TIME, "0 < τ"),
        Line("tau-product", equal(A * tau, (1 + d) * y * (1 - S)), identity("tau S"), TIME,
             "|W_c|² τ = (1+d)(-η_c)(1-√(1-ζ))"),
        Line("contact", equal(dot(omega_next, omega_next), 1), identity("tau"), TIME,
             "after the time τ particle c is in contact: |ω_s'| = 1"),
    )  # fmt: skip


#: For a time without a quotient by |W_c|^2.
TIME_ROOT = Line("time-root", equal(tau * (1 + d) * y * (1 + S), d * (2 + d)), identity("tau S"),
                 TIME, "τ = d(2+d)/((1+d)(-η_c)(1+√(1-ζ)))")  # fmt: skip


def distance() -> Iterator[Item]:
    """How far particle s is then."""
    gains = (
        times(2, "recedes", "tau-positive"),
        times("B-positive", "tau-positive", "tau-positive"),
    )
    yield from (
        Line("end-positive", 0 < dot(end, end), proof(1, *gains)),
        Line("end-root", 0 < sqrt(dot(end, end)), ByRoot()),
        Defined("D"),
        Defined("d_next"),
        Line("D-positive", 0 < D, proof("end-root", using="D")),
        Line("D-square", equal(D**2, 1 + 2 * eta_s * tau + B * tau**2), identity("D"), DISTANCE,
             "(1+d')² = 1 + 2η_sτ + |W_s|²τ²"),
        Line("D-one", 0 < D - 1, scaled(times("goal", plus(1, "D-positive")), *gains, using="D")),
        Line("distance", D - 1 <= eta_s * tau + B * tau**2 / 2,
             scaled(times(2, "goal"), square(D - 1), using="D"), DISTANCE,
             "d' ≤ η_sτ + |W_s|²τ²/2"),
    )  # fmt: skip


#: Two conditions at the next state.
NEXT_D_POSITIVE = Line(
    "next-d-positive", 0 < d_next, proof("D-one", using="d_next"), DISTANCE, "0 < d'"
)
NEXT_D_SUM_POSITIVE = Line(
    "next-d-sum-positive", 0 < 1 + d_next, proof("D-positive", using="d_next")
)


half = (1 + r) / 2
#: -W_c.omega_s' = (1+d) sqrt(1-zeta) (-eta_c), the speed of the impact.
impact = (1 + d) * y * S
spin = frame.dot(W_s, omega_next)
turn = (1 + d) * C - tau * a - (1 + d) * tau * b - tau**2 * w

#: The cosine without a quotient.
TURN = Line("turn", equal(D * C_next, turn), identity("law-angle"))
SPIN_SQUARE = Line("spin-square", spin**2 <= B, proof("impact-pair", equations=(("contact", -B),)))
IMPACT_POSITIVE = Line("impact-positive", 0 < impact,
                       proof(times("d-sum-positive", "Cnd1", "S-positive")), COMPONENTS,
                       "W_c·ω_s' < 0: at the contact the pair approaches")  # fmt: skip


def at_the_contact(name: str, pair: str, using: str = "tau") -> Line:
    """A Cauchy-Schwarz inequality that uses the time to the collision, under the name of that."""
    claim = inequalities(frame, tau, (pair,))[pair]
    return Line(name, claim, proof(pair, using=using))


#: With the inequality `angle-pair`.
C_NEXT_ONE = Line("C_next-one", C_next <= 1,
                  scaled(times("goal", plus("goal", 2), power("D-positive", 2)), "angle-pair",
                         equations=(("turn", -(D * C_next + turn)), ("contact", -dot(end, end)),
                                    ("D-square", as_term(1)))))  # fmt: skip


def spinning(bound: tuple[Term, Factor]) -> Iterator[Item]:
    """At the contact: the pairs of vectors, and W_s along omega_s'; ``bound`` is that of |W_s|."""
    yield at_the_contact("impact-pair", "cs-impact")
    yield at_the_contact("angle-pair", "cs-angle")
    yield SPIN_SQUARE
    yield from absolute("spin", spin, bound, ("spin-square", "B-below"))


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
GAINED_UPPER = Line("gained-upper", gained <= tau * B,
                    proof(times("tau-positive", "B-positive", "D-one"),
                          using="gained"))  # fmt: skip
