"""From one collision to the next: sizes, the time between them, and the next distance.

First the rows are solved for what the later lines need; at the end: until the collision, and at its
instant, no other pair of particles is in contact.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from verify.language.argument import (
    ByInterval,
    ByRoot,
    Chapter,
    Item,
    Line,
    Value,
    plus,
    power,
    proof,
    scaled,
    square,
    times,
)
from verify.language.terms import Term, as_term, sqrt
from verify.language.vectors import Combination, add, omega_c, omega_s, scale
from verify.paper.dynamics import laws
from verify.paper.dynamics.apart import colliding, contexts, opened, spectator, t
from verify.paper.dynamics.laws import DISTANCE, TIME
from verify.paper.dynamics.state import (
    A,
    B,
    C,
    D,
    S,
    a,
    b,
    d,
    d_next,
    difference,
    eta_s,
    frame,
    tau,
    w,
    y,
    zeta,
)
from verify.paper.step.numbers import (
    V_0,
    V_1,
    C_eta,
    alpha_0,
    d_const,
    d_later,
    delta_2,
    delta_x,
    eighth,
    eta_bar,
    gap,
    h_4,
    phi_minus,
    share,
    speed,
    zeta_bar,
)
from verify.paper.step.state import g

FINE = "EQUATSS4.1Recurrence_Cnd4"
PRODUCT = "EQUATSS4.1Lien_x_n_&_y_n_"

root_two = sqrt(2)
small = delta_2 * share / 2


def ground_lines() -> Iterator[Item]:
    """Bounds on the square root of two."""
    yield Line("root-two-lower", 1 < root_two, ByInterval())
    yield Line("root-two-upper", root_two < Fraction(19, 12), ByInterval())


def rearranged() -> Iterator[Item]:
    """Consequences of the rows alone."""
    total = V_0 * V_1 * (phi_minus + delta_x) + (V_0 * V_1 * (alpha_0 / 2) + 4 * V_1**2) * zeta_bar
    yield from (
        Line("speed-positive", 0 < speed, ByRoot()),
        Line("ratio-half", phi_minus + (1 - h_4 / 2) * delta_x <= alpha_0 / 2,
             proof("y-ratio", times(Fraction(1, 2), "h_4-positive", "delta_x-positive"))),
        Line("gap-upper", gap + delta_x <= C_eta, proof("eta-contraction", using="same-delta")),
        Line("gap-lower", delta_2 <= gap - delta_x, proof("zeta-denominator", using="same-delta")),
        Line("gap-room", 0 < gap - delta_x, proof("gap-lower", "delta_2-positive")),
        Line("h_4-room", 0 < 1 - h_4, proof("h_4-below-one")),
        Line("contraction", phi_minus <= (1 - h_4) * (gap - delta_x),
             scaled(times("gap-positive", "goal"), "x-contraction",
                    times("h_4-room", "gap-room", "delta_x-positive"),
                    using="same-delta r-product")),
        Line("zeta_bar-small", 2 * zeta_bar <= small, proof("x-term-1-zeta")),
        Line("d_later-small", d_later <= small, proof("x-term-1-d")),
        Line("time-short", 1 < root_two - 7 * speed / V_0 * eta_bar, proof("CndT")),
        Line("zeta-room", total <= V_0**2 * (gap - delta_x) ** 2,
             scaled(times("V_0-positive", "V_0-positive", power("gap-room", 4), "goal"),
                    "zeta-total",
                    times(Fraction(1, 4), power("V_0-positive", 4), power("gap-room", 6),
                          "h_5-positive"), using="same-delta")),
        Line("d_const-one", d_const <= 1,
             scaled(times(4, "goal"), times(4, "d_const-entry-1"), "root-two-upper",
                    Fraction(41, 12))),
        Line("d_const-share", d_const <= eighth, proof("d_const-entry-4")),
        Line("d_const-small", d_const <= small, proof("d_const-entry-3")),
        Line("eighth-positive", 0 < eighth, proof(times(Fraction(1, 8), *_SHARE))),
        Line("small-positive", 0 < small,
             proof(times(Fraction(1, 2), "delta_2-positive", *_SHARE))),
        Line("ratio-positive", 0 < phi_minus + delta_x, proof("phi-positive", "delta_x-positive")),
    )  # fmt: skip


_SHARE = ("h_4-positive", "delta_x-positive")


HALF = Fraction(1, 2)

#: The number that the invariant on the norms shifts by at each collision.
SHIFT = times(4, plus("speed-positive", 2))


def lines() -> Iterator[Item]:
    """Everything about the time tau between the two collisions, and d_next."""
    yield from _norms()
    yield from _components()
    yield from _root()
    yield from _time()
    yield from _distance()


def below_speed(
    name: str, term: Term, facts: tuple[Value, ...], label: str = "", says: str = ""
) -> Iterator[Item]:
    """|x| <= V_1^(1/2), both halves, where the facts add up to x^2 <= V_1."""
    yield from laws.absolute(name, term, (speed, "speed-positive"), facts, label, says)


def _norms() -> Iterator[Item]:
    yield Line("g-positive", 0 < g, proof("Cnd2", "Cnd1"))
    goal = times("decay-positive", "goal")
    for name, letter, size in (("A", "c", A), ("B", "s", B)):
        facts = ("Cnd5-upper", times(SHIFT, "g-positive"))
        yield from (
            Line(f"{name}-above", V_0 <= size, scaled(goal, f"{name}-lower", *facts),
                 "EQUATSS4.1Recurrence_Cnd5", f"V₀ ≤ |W_{letter}|²"),
            Line(f"{name}-below", size <= V_1, scaled(goal, f"{name}-upper", *facts),
                 "EQUATSS4.1Recurrence_Cnd5", f"|W_{letter}|² ≤ V₁"),
        )  # fmt: skip
    yield Line("B-positive", 0 < B, proof("B-above", "V_0-positive"))


def _components() -> Iterator[Item]:
    yield Line("y-bound", y <= eta_bar, proof("Cnd2", "g-bound"))
    yield Line("y-one", y <= 1, proof("y-bound", "eta-below-one"))
    yield from below_speed("eta_s", eta_s, ("cs-s", "B-below"))
    yield from below_speed("y", y, ("cs-c", "A-below"))
    yield from below_speed("a", a, ("cs-a", "A-below"))
    yield from below_speed("b", b, ("cs-b", "B-below"))
    goal = times("goal", plus("goal", times(2, "V_1-positive")))
    facts = ("cs-w", times("A-below", "B-positive"), times("V_1-positive", "B-below"))
    yield Line("C-one", C <= 1, scaled(times("goal", plus("goal", 2)), "cs-omega"))
    yield Line("w-upper", w <= V_1, scaled(goal, *facts))
    yield Line("w-lower", -w <= V_1, scaled(goal, *facts))


def _root() -> Iterator[Item]:
    cnd3 = "EQUATSS4.1Recurrence_Cnd3"
    yield from laws.root()
    yield Line("zeta-bound", zeta <= zeta_bar, proof("Cnd4", using="zeta"),
               "EQUATSS4.1Recurrence_Cnd4", "ζ ≤ ζ̄")  # fmt: skip
    yield from laws.between_zero_and_one()
    fine = times(Fraction(1, 4), power("S-one", 2), "root-room")
    yield from (
        Line("root-crude",         1 - S <= zeta,
             proof(times("S-positive", "S-one"), using="S-square"), cnd3, "1 - √(1-ζ) ≤ ζ"),
        Line("root-room",          root_two - 1 <= S,
             scaled(times("goal", plus("S-positive", "root-two-lower")), "zeta-bound", "zeta-root",
                    using="S-square")),
        Line("root-fine",          1 - S <= zeta / 2 + zeta**2 / 4,
             proof(times(fine, plus("S-positive", 2, "root-two-lower")), using="S-square"),
             FINE, "1 - √(1-ζ) ≤ ζ/2 + ζ²/4"),
        Line("root-product-upper", (1 + d) * S - 1 <= d, proof(times("d-sum-positive", "S-one")),
             PRODUCT, "(1+d)√(1-ζ) - 1 ≤ d"),
        Line("root-product-lower", 1 - (1 + d) * S <= 2 * zeta,
             proof("root-crude", times("d-positive", "S-positive"), "zeta-positive"),
             PRODUCT, "1 - (1+d)√(1-ζ) ≤ 2ζ"),
    )  # fmt: skip


def _time() -> Iterator[Item]:
    yield from laws.time(times("d-sum-positive", "Cnd1", "S-one"))
    yield from (
        Line("time-product", A * tau <= 2 * y * zeta,
             proof(times("d-one", "Cnd1", "S-one"), times(2, "Cnd1", "root-crude"),
                   equations=(("tau-product", as_term(-1)),)), TIME, "τ ≤ 2(-η_c)ζ/|W_c|²"),
        Line("time",         V_0 * tau <= 2 * y * zeta,
             proof("time-product", times("tau-positive", "A-above")), TIME, "τ ≤ 2(-η_c)ζ/V₀"),
        Line("time-crude",   V_0 * tau <= 2 * y, proof("time", times(2, "Cnd1", "zeta-one")),
             TIME, "τ ≤ 2(-η_c)/V₀"),
        Line("time-speed",   speed * tau <= 1,
             scaled(times("V_0-positive", "goal"), "tau-small",
                    times(2, "speed-positive", "y-bound"), times("speed-positive", "time-crude")),
             TIME, "V₁^{1/2} τ ≤ 1"),
        Line("time-square",  V_1 * tau**2 <= speed * tau,
             proof(times("speed-positive", "tau-positive", "time-speed")),
             TIME, "V₁ τ² ≤ V₁^{1/2} τ"),
    )  # fmt: skip


def _distance() -> Iterator[Item]:
    yield from laws.distance()
    goal = times("V_0-positive", "goal")
    yield from (
        Line("distance-time", D - 1 <= Fraction(3, 2) * speed * tau,
             proof("distance", times("tau-positive", "eta_s-upper"),
                   times(HALF, "tau-positive", "tau-positive", "B-below"),
                   times(HALF, "speed-positive", "tau-positive", "time-speed")),
             DISTANCE, "d' ≤ (3/2) V₁^{1/2} τ"),
        Line("distance-speed", V_0 * (D - 1) <= 3 * speed * y,
             proof(times("V_0-positive", "distance-time"),
                   times(Fraction(3, 2), "speed-positive", "time-crude")),
             DISTANCE, "d' ≤ 3 (V₁^{1/2}/V₀)(-η_c)"),
        Line("distance-later", D - 1 <= d_later,
             proof("distance-speed", times(3, "speed-positive", "y-bound"))),
        laws.NEXT_D_POSITIVE,
        Line("next-d-one", d_next <= 1,
             scaled(goal, "distance-later", "d-below-one", using="d_next"),
             "EQUATSS4.1Recurrence_Cnd6", "d' ≤ 1"),
        laws.NEXT_D_SUM_POSITIVE,
        Line("next-d-share", d_next <= eighth,
             scaled(goal, "distance-later", "y-term-2-d", using="d_next")),
        Line("next-d-small", d_next <= small,
             scaled(goal, "distance-later", "d_later-small", using="d_next")),
    )  # fmt: skip


dot = frame.dot


def apart() -> Iterator[Chapter]:
    """The three pairs."""
    before, meanwhile = contexts()
    yield opened()
    yield Chapter(before.name, tuple(colliding()))
    yield Chapter(meanwhile.name, (spectator(), _outer_pair()))


def _outer_pair() -> Line:
    outer: Combination = add(add(scale(1 + d, omega_c), scale(-1, omega_s)), scale(t, difference))
    v0, speed = "V_0-positive", "speed-positive"
    together = plus(
        times(2, "C-positive", "d-sum-positive"),
        times(2, "d-positive"),
        square(d - t * (y + b)),
        times(square(t), "cs-outer"),
        times(2, "t-lower", plus("y-upper", "a-upper", "b-upper", "recedes")),
        times(6, "t-upper", speed),
    )
    reason = scaled(
        times(v0, "goal"),
        times(v0, together),
        times(6, speed, "time-crude"),
        times(12, speed, "y-bound"),
        times(Fraction(12, 7), "time-short"),
        times(Fraction(12, 7), v0, "root-two-upper"),
    )
    return Line("outer-pair-apart", 1 < dot(outer, outer), reason, "EQUATSS4.1Recurrence_CndT",
                "the outer pair s-c is apart for all times from 0 to τ, both included")  # fmt: skip
