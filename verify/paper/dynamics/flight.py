"""From one collision to the next: the root, the time between them, and the next distance.

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
    proof,
    scaled,
    square,
    times,
)
from verify.language.terms import Term, equal, sqrt
from verify.paper.dynamics.state import (
    A,
    B,
    D,
    S,
    d,
    d_next,
    end,
    eta_s,
    frame,
    omega_next,
    tau,
    y,
    zeta,
    zeta_of,
)

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
