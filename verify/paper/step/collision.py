"""The collision: the laws of Section 4 as identities of the collision map, angle and norms."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from verify.language.argument import Factor, Item, Line, plus, power, proof, scaled, times
from verify.language.terms import as_term
from verify.paper.dynamics.apart import dot
from verify.paper.dynamics.laws import (
    ANGLE,
    IMPACT_POSITIVE,
    SPIN_SQUARE,
    TURN,
    at_the_contact,
    impact,
    laws,
    spin,
    turn,
)
from verify.paper.dynamics.state import A, A_next, B, B_next, C, C_next, D, d, end, tau, y
from verify.paper.step.flight import SHIFT, below_speed
from verify.paper.step.numbers import c as limit
from verify.paper.step.numbers import eighth, speed
from verify.paper.step.state import carried


def lines() -> Iterator[Item]:
    """The laws, then the estimates of the angle and of the norms."""
    yield from laws()
    yield from _angle()
    yield from _norms()


def _angle() -> Iterator[Item]:
    yield from (
        at_the_contact("angle-pair", "cs-angle"),
        TURN,
        Line("C_next-square", D**2 * C_next**2 <= D**2,
             proof("angle-pair",
                   equations=(("turn", -(D * C_next + turn)), ("contact", -dot(end, end)),
                              ("D-square", as_term(1))))),
        Line("C_next-one", C_next <= 1,
             scaled(times("goal", power("D-positive", 2), plus("goal", 2)), "C_next-square"),
             ANGLE, "-cos θ' ≤ 1"),
        Line("C-positive", 0 < C,
             scaled(times("decay-speed-positive", "goal"), "Cnd8-lower", "obtuse",
                    times("decay-speed-positive", "d-positive"),
                    times(14, "speed-positive", "g-positive")),
             "EQUATSS4.1Recurrence_CndT", "cos θ < 0"),
    )  # fmt: skip
    bound = d + (D - 1) + 4 * speed * tau
    change = times("D-one", plus("d-positive", "D-one", times(4, "speed-positive", "tau-positive")))
    rest = (times("d-one", "tau-positive", "speed-positive"), "time-square")
    for side, sign, first, second in (
        ("upper", 1, "C-one", plus("C-positive", 1)),
        ("lower", -1, plus("C-positive", 1), "C-one"),
    ):
        other = "lower" if sign == 1 else "upper"
        yield Line(f"angle-step-{side}", (C_next - C if sign == 1 else C - C_next) <= bound,
                   scaled(times("D-positive", "goal"), change, times("d-positive", first),
                          times("D-one", second), times("tau-positive", f"a-{other}"),
                          times("d-sum-positive", "tau-positive", f"b-{other}"),
                          times("tau-positive", "tau-positive", f"w-{other}"), *rest)
                   ._replace(equations=(("turn", as_term(-sign)),)), "EQUATSS4.1Recurrence_Cnd8",
                   "|cos θ' - cos θ| ≤ d + d' + 4 V₁^{1/2} τ")  # fmt: skip
    for side in ("upper", "lower"):
        yield next_condition(f"Cnd8-{side}", "EQUATSS4.1Recurrence_Cnd8",
                             "|(-cos θ_n) - (-cos θ₀)| stays below the sum of all later changes",
                             f"Cnd8-{side}", times("decay-speed-positive", f"angle-step-{side}"),
                             times(2, "decay-positive", "distance-speed"),
                             times(4, "decay-positive", "speed-positive", "time-crude"),
                             times(14, "decay-positive", "speed-positive", "Cnd2"), using="d_next",
        )  # fmt: skip
    tail = times(14, "speed-positive", "C_eta-positive", "g-positive")
    room = times("decay-speed-positive", "D-one")
    goal = times("decay-speed-positive", "goal")
    yield Line("C_next-positive", 0 < C_next,
               scaled(goal, "next-Cnd8-lower", "obtuse", room, tail, using="d_next"),
               "EQUATSS4.1Recurrence_CndT", "cos θ' < 0")  # fmt: skip
    for side, term in (("upper", C_next - limit), ("lower", limit - C_next)):
        yield Line(f"angle-{side}", term <= eighth,
                   scaled(goal, f"next-Cnd8-{side}", "y-term-3", room, tail, using="d_next"),
                   "EQUATSS4.1Recurrence_Cnd10", "|(-cos θ') - (-cos θ₀)| ≤ h₄δ_x/8")  # fmt: skip


def _norms() -> Iterator[Item]:
    yield at_the_contact("impact-pair", "cs-impact")
    yield SPIN_SQUARE
    yield from below_speed(
        "spin",
        spin,
        ("spin-square", "B-below"),
        "EQUATSS4.1Recurrence_Cnd6",
        "|W_s·ω_s'| ≤ V₁^{1/2}",
    )
    yield from (
        IMPACT_POSITIVE,
        Line("impact-bound", impact <= 2 * y,
             proof(times("d-one", "Cnd1", "S-positive"), times(2, "Cnd1", "S-one")),
             "EQUATSS4.1Recurrence_Cnd6", "|W_c·ω_s'| ≤ 2(-η_c)"),
    )  # fmt: skip
    bound = 4 * (speed + 2) * y
    plus_r = plus(1, "r-positive")
    square = power("impact-positive", 2)
    below = times("impact-bound", plus("impact-positive", times(2, "Cnd1")))
    moving = (
        times("r-below-one", "impact-positive", "speed-positive"),
        times(2, "speed-positive", "impact-bound"),
    )
    quarter = Fraction(1, 4)
    one = times(4, "Cnd1", "y-one")
    using = "law-norm-c law-norm-s impact-speed"
    for name, claim, says, addends in (
        ("norm-c-upper", A_next - B <= bound, "|W_c'|² - |W_s|²",
         (times(plus_r, "impact-positive", "spin-upper"), *moving,
          times(quarter, "r-below-one", plus(3, "r-positive"), square), below, one,
          times(4, "Cnd1"))),
        ("norm-c-lower", B - A_next <= bound, "|W_s|² - |W_c'|²",
         (times(plus_r, "impact-positive", "spin-lower"), *moving,
          times(quarter, power(plus_r, 2), square), times(8, "Cnd1"))),
        ("norm-s-upper", B_next - A <= bound,
         "|W_s'|² - |W_c|²", (times("r-below-one", plus_r, square), times(SHIFT, "Cnd1"))),
        ("norm-s-lower", A - B_next <= bound, "|W_c|² - |W_s'|²",
         (times(power("r-positive", 2), square), below, one,
          times(4, plus("speed-positive", 1), "Cnd1"))),
    ):  # fmt: skip
        label = "EQUATSS4.1Recurrence_Cnd6" if "-c-" in name else "EQUATSS4.1Recurrence_Cnd7"
        says = f"{says} ≤ 4(V₁^{{1/2}}+2)(-η_c)"
        yield Line(name, claim, proof(*addends, using=using), label, says)
    for new, old, letter in (("A", "B", "c"), ("B", "A", "s")):
        for side in ("upper", "lower"):
            yield next_condition(f"{new}-{side}", "EQUATSS4.1Recurrence_Cnd6",
                                 f"|W_{letter}'|² stays between V₀ and V₁ by the sum of all later "
                                 "changes", f"{old}-{side}",
                                 times("decay-positive", f"norm-{letter}-{side}"),
                                 times("decay-positive", SHIFT, "Cnd2"))  # fmt: skip


def next_condition(name: str, label: str, says: str, *addends: Factor, using: str = "") -> Line:
    """A condition of the recursion at the next state."""
    return carried.line(name, says, *addends, label=label, using=using)
