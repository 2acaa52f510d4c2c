"""From one collision to the next: sizes, the time between them, and the next distance."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from verify.language.terms import Term, as_term, equal, sqrt
from verify.paper.argument import (
    ByRoot,
    Defined,
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
from verify.paper.step.numbers import (
    V_0,
    V_1,
    d_later,
    eighth,
    eta_bar,
    speed,
    zeta_bar,
)
from verify.paper.step.rearranged import root_two, small
from verify.paper.step.state import (
    A,
    B,
    C,
    D,
    S,
    a,
    b,
    d,
    d_next,
    end,
    eta_s,
    frame,
    g,
    omega_next,
    tau,
    w,
    y,
    zeta,
    zeta_of,
)

TIME = "EQUATSS4.1_Controle_Tau_n"
DISTANCE = "EQUATSS4.1BorneDista_d_1_"
FINE = "EQUATSS4.1Recurrence_Cnd4"
PRODUCT = "EQUATSS4.1Lien_x_n_&_y_n_"
HALF = Fraction(1, 2)

#: The number that the invariant on the norms shifts by at each collision.
SHIFT = times(4, plus("speed-positive", 2))

dot = frame.dot


def lines() -> Iterator[Item]:
    """Everything about the time tau between the two collisions, and d_next."""
    yield from _norms()
    yield from _components()
    yield from _root()
    yield from _time()
    yield from _distance()


def absolute(
    name: str, term: Term, facts: tuple[Value, ...], label: str = "", says: str = ""
) -> Iterator[Item]:
    """|x| <= V_1^(1/2), both halves, where the facts add up to x^2 <= V_1."""
    goal = times("goal", plus("goal", times(2, "speed-positive")))
    for suffix, side in (("upper", term), ("lower", -term)):
        yield Line(f"{name}-{suffix}", side <= speed, scaled(goal, *facts), label, says)


def _norms() -> Iterator[Item]:
    yield Line("g-positive", 0 < g, proof("Cnd2", "Cnd1"))
    goal = times("decay-positive", "goal")
    for name, letter, size in (("A", "c", A), ("B", "s", B)):
        facts = ("Cnd5-upper", times(SHIFT, "g-positive"))
        yield Line(
            f"{name}-above",
            V_0 <= size,
            scaled(goal, f"{name}-lower", *facts),
            "EQUATSS4.1Recurrence_Cnd5",
            f"V₀ ≤ |W_{letter}|²",
        )
        yield Line(
            f"{name}-below",
            size <= V_1,
            scaled(goal, f"{name}-upper", *facts),
            "EQUATSS4.1Recurrence_Cnd5",
            f"|W_{letter}|² ≤ V₁",
        )
    yield Line("B-positive", 0 < B, proof("B-above", "V_0-positive"))


def _components() -> Iterator[Item]:
    yield Line("y-bound", y <= eta_bar, proof("Cnd2", "g-bound"))
    yield Line("y-one", y <= 1, proof("y-bound", "eta-below-one"))
    yield from absolute("eta_s", eta_s, ("cs-s", "B-below"))
    yield from absolute("y", y, ("cs-c", "A-below"))
    yield from absolute("a", a, ("cs-a", "A-below"))
    yield from absolute("b", b, ("cs-b", "B-below"))
    yield Line("C-one", C <= 1, scaled(times("goal", plus("goal", 2)), "cs-omega"))
    goal = times("goal", plus("goal", times(2, "V_1-positive")))
    facts = ("cs-w", times("A-below", "B-positive"), times("V_1-positive", "B-below"))
    yield Line("w-upper", w <= V_1, scaled(goal, *facts))
    yield Line("w-lower", -w <= V_1, scaled(goal, *facts))


def _root() -> Iterator[Item]:
    cnd3 = "EQUATSS4.1Recurrence_Cnd3"
    yield Defined("zeta")
    yield Line("root-positive", 0 < sqrt(1 - zeta_of(frame)), ByRoot())
    yield Defined("S")
    yield Defined("tau")
    yield Line("S-positive", 0 < S, proof("root-positive", using="S"))
    yield Line("S-square", equal(zeta, 1 - S**2), identity("zeta S"), cnd3, "ζ = 1 - √(1-ζ)²")
    yield Line(
        "zeta-bound",
        zeta <= zeta_bar,
        proof("Cnd4", using="zeta"),
        "EQUATSS4.1Recurrence_Cnd4",
        "ζ ≤ ζ̄",
    )
    yield Line(
        "zeta-positive",
        0 < zeta,
        proof(times("d-positive", plus(2, "d-positive"), "A-positive"), using="zeta"),
        cnd3,
        "0 < ζ",
    )
    yield Line("zeta-one", 0 < 1 - zeta, proof("Cnd3", using="zeta"), cnd3, "ζ < 1")
    yield Line(
        "zeta-product",
        equal(d * (2 + d) * A, zeta * (1 + d) ** 2 * y**2),
        identity("zeta"),
        cnd3,
        "ζ = d(2+d)|W_c|²/((1+d)²η_c²)",
    )
    yield Line(
        "S-one",
        0 < 1 - S,
        scaled(times("goal", plus(1, "S-positive")), "zeta-positive", using="S-square"),
    )
    yield Line(
        "root-crude",
        1 - S <= zeta,
        proof(times("S-positive", "S-one"), using="S-square"),
        cnd3,
        "1 - √(1-ζ) ≤ ζ",
    )
    yield Line(
        "root-room",
        root_two - 1 <= S,
        scaled(
            times("goal", plus("S-positive", "root-two-lower")),
            "zeta-bound",
            "zeta-root",
            using="S-square",
        ),
    )
    fine = times(Fraction(1, 4), power("S-one", 2), "root-room")
    yield Line(
        "root-fine",
        1 - S <= zeta / 2 + zeta**2 / 4,
        proof(times(fine, plus("S-positive", 2, "root-two-lower")), using="S-square"),
        FINE,
        "1 - √(1-ζ) ≤ ζ/2 + ζ²/4",
    )
    yield Line(
        "root-product-upper",
        (1 + d) * S - 1 <= d,
        proof(times("d-sum-positive", "S-one")),
        PRODUCT,
        "(1+d)√(1-ζ) - 1 ≤ d",
    )
    yield Line(
        "root-product-lower",
        1 - (1 + d) * S <= 2 * zeta,
        proof("root-crude", times("d-positive", "S-positive"), "zeta-positive"),
        PRODUCT,
        "1 - (1+d)√(1-ζ) ≤ 2ζ",
    )


def _time() -> Iterator[Item]:
    yield Line(
        "tau-positive",
        0 < tau,
        proof(times("d-sum-positive", "Cnd1", "S-one"), using="tau S"),
        TIME,
        "0 < τ",
    )
    yield Line(
        "tau-product",
        equal(A * tau, (1 + d) * y * (1 - S)),
        identity("tau S"),
        TIME,
        "|W_c|² τ = (1+d)(-η_c)(1-√(1-ζ))",
    )
    yield Line(
        "contact",
        equal(dot(omega_next, omega_next), 1),
        identity("tau"),
        TIME,
        "after the time τ particle c is in contact: |ω_s'| = 1",
    )
    yield Line(
        "time-product",
        A * tau <= 2 * y * zeta,
        proof(
            times("d-one", "Cnd1", "S-one"),
            times(2, "Cnd1", "root-crude"),
            equations=(("tau-product", as_term(-1)),),
        ),
        TIME,
        "τ ≤ 2(-η_c)ζ/|W_c|²",
    )
    yield Line(
        "time",
        V_0 * tau <= 2 * y * zeta,
        proof("time-product", times("tau-positive", "A-above")),
        TIME,
        "τ ≤ 2(-η_c)ζ/V₀",
    )
    yield Line(
        "time-crude", V_0 * tau <= 2 * y, proof("time", times(2, "Cnd1", "zeta-one")), TIME,
        "τ ≤ 2(-η_c)/V₀",
    )  # fmt: skip
    yield Line(
        "time-speed",
        speed * tau <= 1,
        scaled(
            times("V_0-positive", "goal"),
            "tau-small",
            times(2, "speed-positive", "y-bound"),
            times("speed-positive", "time-crude"),
        ),
        TIME,
        "V₁^{1/2} τ ≤ 1",
    )
    yield Line(
        "time-square",
        V_1 * tau**2 <= speed * tau,
        proof(times("speed-positive", "tau-positive", "time-speed")),
        TIME,
        "V₁ τ² ≤ V₁^{1/2} τ",
    )


def _distance() -> Iterator[Item]:
    gains = (
        times(2, "recedes", "tau-positive"),
        times("B-positive", "tau-positive", "tau-positive"),
    )
    yield Line("end-positive", 0 < dot(end, end), proof(1, *gains))
    yield Line("end-root", 0 < sqrt(dot(end, end)), ByRoot())
    yield Defined("D")
    yield Defined("d_next")
    yield Line("D-positive", 0 < D, proof("end-root", using="D"))
    yield Line(
        "D-square",
        equal(D**2, 1 + 2 * eta_s * tau + B * tau**2),
        identity("D"),
        DISTANCE,
        "(1+d')² = 1 + 2η_sτ + |W_s|²τ²",
    )
    yield Line("D-one", 0 < D - 1, scaled(times("goal", plus(1, "D-positive")), *gains, using="D"))
    yield Line(
        "distance",
        D - 1 <= eta_s * tau + B * tau**2 / 2,
        scaled(times(2, "goal"), square(D - 1), using="D"),
        DISTANCE,
        "d' ≤ η_sτ + |W_s|²τ²/2",
    )
    yield Line(
        "distance-time",
        D - 1 <= Fraction(3, 2) * speed * tau,
        proof(
            "distance",
            times("tau-positive", "eta_s-upper"),
            times(HALF, "tau-positive", "tau-positive", "B-below"),
            times(HALF, "speed-positive", "tau-positive", "time-speed"),
        ),
        DISTANCE,
        "d' ≤ (3/2) V₁^{1/2} τ",
    )
    yield Line(
        "distance-speed",
        V_0 * (D - 1) <= 3 * speed * y,
        proof(
            times("V_0-positive", "distance-time"),
            times(Fraction(3, 2), "speed-positive", "time-crude"),
        ),
        DISTANCE,
        "d' ≤ 3 (V₁^{1/2}/V₀)(-η_c)",
    )
    yield Line(
        "distance-later",
        D - 1 <= d_later,
        proof("distance-speed", times(3, "speed-positive", "y-bound")),
    )
    goal = times("V_0-positive", "goal")
    yield Line("next-d-positive", 0 < d_next, proof("D-one", using="d_next"), DISTANCE, "0 < d'")
    yield Line(
        "next-d-one", d_next <= 1, scaled(goal, "distance-later", "d-below-one", using="d_next"),
        "EQUATSS4.1Recurrence_Cnd6", "d' ≤ 1",
    )  # fmt: skip
    yield Line("next-d-sum-positive", 0 < 1 + d_next, proof("D-positive", using="d_next"))
    yield Line(
        "next-d-share",
        d_next <= eighth,
        scaled(goal, "distance-later", "y-term-2-d", using="d_next"),
    )
    yield Line(
        "next-d-small",
        d_next <= small,
        scaled(goal, "distance-later", "d_later-small", using="d_next"),
    )
