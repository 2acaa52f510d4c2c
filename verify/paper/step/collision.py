"""The collision: the laws of Section 4 as identities of the collision map, angle and norms.

Then the other conditions of the recursion at the next state: the ratios, zeta, and the time. What
follows at every n stands at the end: bounds on the angle and on the time, and two monotone
quantities.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from verify.language.argument import Factor, Item, Line, plus, power, proof, scaled, times
from verify.language.terms import as_term
from verify.paper.dynamics.apart import dot
from verify.paper.dynamics.laws import (
    ANGLE,
    GAINED_UPPER,
    IMPACT_POSITIVE,
    SPIN_SQUARE,
    TURN,
    at_the_contact,
    impact,
    laws,
    parts,
    spin,
    turn,
)
from verify.paper.dynamics.state import (
    A,
    A_next,
    B,
    B_next,
    C,
    C_next,
    D,
    S,
    d,
    d_next,
    end,
    eta_s,
    gained,
    kept,
    tau,
    y,
    y_next,
    zeta,
)
from verify.paper.parameters import THEOREM
from verify.paper.step.flight import SHIFT, below_speed, small
from verify.paper.step.numbers import (
    V_0,
    V_1,
    C_eta,
    T_star,
    alpha_0,
    c,
    delta_2,
    delta_theta,
    delta_x,
    eighth,
    gap,
    phi_minus,
    speed,
    zeta_bar,
)
from verify.paper.step.numbers import c as limit
from verify.paper.step.state import beta, carried, clock, g


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
    yield from below_speed("spin", spin, ("spin-square", "B-below"),
                           "EQUATSS4.1Recurrence_Cnd6", "|W_s·ω_s'| ≤ V₁^{1/2}")  # fmt: skip
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


# --- the other conditions -------------------------------------------------------------------------


LINK = "EQUATSS4.1Lien_x_n_&_y_n_"
RATIO = "EQUATSS4.1DefinReste_x_n_"
HALF = Fraction(1, 2)
MINUS_R = times(HALF, "r-below-one")
PLUS_R = times(HALF, plus(1, "r-positive"))


def conditions() -> Iterator[Item]:
    """In the paper's order: y, then x, then zeta, then what is carried of C_eta and the time."""
    yield from _terms_of_y()
    yield from _y()
    yield from _x()
    yield from _zeta_products()
    yield from _zeta()
    yield from _time()


def _terms_of_y() -> Iterator[Item]:
    yield from parts()
    goal = times("V_0-positive", "goal")
    yield from (
        Line("kept-loss", eta_s - kept <= eta_s * (D - 1),
             proof(times("recedes", "D-one", "D-one"), using="kept"), LINK, "|1/(1+d') - 1| ≤ d'"),
        GAINED_UPPER,
        Line("ratio-bound", eta_s <= alpha_0 / 2 * y,
             proof("Cnd9-upper", times("Cnd1", "ratio-half")),
             "EQUATSS4.1Recurrence_Cnd10", "η_s/(-η_c) ≤ α₀/2"),
        Line("y-term-kept", eta_s - kept <= eighth * y,
             scaled(goal, times("V_0-positive", "kept-loss"),
                    times("V_0-positive", "D-one", "ratio-bound"),
                    times(HALF, "alpha-positive", "Cnd1", "distance-later"),
                    times("Cnd1", "y-term-1")),
             LINK, "first term of y: (1 - 1/(1+d')) η_s/(-η_c) ≤ h₄δ_x/8"),
        Line("y-term-gained", gained <= eighth * y,
             scaled(goal, times("V_0-positive", "gained-upper"),
                    times("V_0-positive", "tau-positive", "B-below"), times("V_1-positive", "time"),
                    times(2, "V_1-positive", "Cnd1", "zeta-bound"), times("Cnd1", "y-term-4")),
             LINK, "fourth term of y: τ|W_s|²/((1+d')(-η_c)) ≤ h₄δ_x/8"),
        Line("y-term-root-upper", (1 + d) * S - 1 <= eighth, proof("root-product-upper", "d-share"),
             LINK, "second term of y: |(1+d)√(1-ζ) - 1| ≤ h₄δ_x/8"),
        Line("y-term-root-lower", 1 - (1 + d) * S <= eighth,
             proof("root-product-lower", times(2, "zeta-bound"), "y-term-2-zeta"),
             LINK, "second term of y, other half"),
    )  # fmt: skip


def _y() -> Iterator[Item]:
    spare = times("eighth-positive", "Cnd1")
    for side, sign, facts in (
        ("upper", 1, ("Cnd9-lower", "y-term-kept", "gained-positive")),
        ("lower", -1, ("Cnd9-upper", "y-term-gained", "kept-upper")),
    ):
        product = plus(
            times(f"y-term-root-{side}", "C_next-positive"), times("eighth-positive", "C_next-one")
        )
        rounded = times(MINUS_R, "eighth-positive")
        distance = y_next - gap * y if sign == 1 else gap * y - y_next
        yield Line(f"y-{side}-bound", distance <= delta_x * y,
                   proof(times("Cnd1", plus(times(PLUS_R, product), rounded)),
                         times("Cnd1", plus(times(PLUS_R, f"angle-{side}"), rounded)), *facts,
                         spare, using="normal-parts",
                         equations=(("alpha", y if sign == 1 else -y),)),
                   "EQUATSS4.1Recurrence_Cnd10", "|η_c'/(-η_c) - (φ⁻-α₀)| = |y_n| ≤ δ_y",
        )  # fmt: skip
    yield from (
        Line("y-contracts", y_next <= C_eta * y, proof("y-upper-bound", times("Cnd1", "gap-upper")),
             "EQUATSS4.1Recurrence_Cnd2", "|η_c'| ≤ C_η |η_c|"),
        Line("y-survives", delta_2 * y <= y_next,
             proof("y-lower-bound", times("Cnd1", "gap-lower")),
             "EQUATSS4.1Recurrence_Cnd1", "η_c'/(-η_c) ≤ -δ₂"),
        next_condition("Cnd1", "EQUATSS4.1Recurrence_Cnd1", "η_c' < 0", "y-survives",
             times("delta_2-positive", "Cnd1")),
        next_condition("Cnd2", "EQUATSS4.1Recurrence_Cnd2",
             "|η_c'| ≤ C_η^{n+1} |η_{c,0}|", "y-contracts", times("C_eta-positive", "Cnd2")),
        next_condition("g-bound", "EQUATSS4.1Recurrence_Cnd2",
             "C_η^{n+1} |η_{c,0}| ≤ η̄", "g-bound", times("g-positive", "C_eta-below-one")),
        next_condition("recedes",
             "EQUATSS4.1EvoluCompoNormC", "η_s' > 0: the pair that just met separates",
             times("r-positive", "impact-positive"), using="law-eta-s"),
    )  # fmt: skip


def _x() -> Iterator[Item]:
    yield from (
        Line("x-term-upper", (1 + d) * S - 1 <= small, proof("root-product-upper", "d-small"),
             RATIO, "first term of x': |(1+d)√(1-ζ) - 1|/δ₂ ≤ h₄δ_x/2"),
        Line("x-term-lower", 1 - (1 + d) * S <= small,
             proof("root-product-lower", times(2, "zeta-bound"), "zeta_bar-small"),
             RATIO, "first term of x', other half"),
    )  # fmt: skip
    for side, other in (("upper", "lower"), ("lower", "upper")):
        first = plus(
            times("phi-positive", "gap-positive", f"x-term-{side}"),
            times("r-below-one", "small-positive"),
        )
        yield next_condition(f"Cnd9-{side}", "EQUATSS4.1Recurrence_Cnd9",
                             "|x_{n+1}| ≤ (1-h₄/2) δ_x", times("Cnd1", first),
                             times(HALF, "h_4-positive", "delta_x-positive", "y-survives"),
                             times("phi-positive", f"y-{other}-bound"),
                             times("delta_x-positive", "h_4-room", "y-lower-bound"),
                             times("delta_x-positive", "Cnd1", "contraction"),
                             using="r-product law-eta-s")  # fmt: skip


def _zeta_products() -> Iterator[Item]:
    two_more = plus(2, "zeta-positive")
    goal = times("decay-positive", "goal")
    shift = times(SHIFT, "C_eta-positive", "g-positive")
    yield from (
        Line("zeta-distance",   3 * d * A <= 4 * zeta * y**2,
             scaled(times(power("d-sum-positive", 2), "goal"),
                    times("d-positive", "A-positive", "d-one", plus(5, times(3, "d-positive"))))
             ._replace(equations=(("zeta-product", as_term(-4)),)),
             "EQUATSS4.1BorneParam_ZK0_", "(3/4) d |W_c|²/η_c² ≤ ζ if d ≤ 1"),
        Line("zeta-dropped",    d * (2 + zeta) <= zeta,
             scaled(times(3, "V_0-positive", "goal"), times(3, "d-positive", two_more, "A-above"),
                    times(two_more, "zeta-distance"),
                    times(4, "zeta-positive", "zeta-bound", power("eta_bar-positive", 2)),
                    times(4, "zeta-positive", two_more, "y-bound",
                          plus("eta_bar-positive", "Cnd1")),
                    times(3, "zeta-positive", "zeta-dropped-factor")), "EQUATSS4.1Recurrence_Cnd4",
             "d(1+ζ/2) ≤ ζ/2 absorbs the factor 1+d that the print drops"),
        Line("root-twice",      2 * (1 + d) * (1 - S) <= zeta + zeta**2,
             proof(times(2, "d-sum-positive", "root-fine"),
                   times(HALF, "zeta-positive", "zeta-dropped")),
             "EQUATSS4.1Recurrence_Cnd4", "2(1+d)(1-√(1-ζ)) ≤ ζ + ζ²"),
        Line("A_next-below",    A_next <= V_1, scaled(goal, "next-A-upper", "Cnd5-upper", shift)),
        Line("next-A-positive", 0 < A_next,
             scaled(goal, "next-A-lower", "Cnd5-upper", shift,
                    times("decay-positive", "V_0-positive"))),
        Line("ratio-worst",     eta_s <= (phi_minus + delta_x) * y,
             proof("Cnd9-upper", times(HALF, "h_4-positive", "delta_x-positive", "Cnd1")),
             "EQUATSS4.1Recurrence_Cnd4", "η_s/(-η_c) ≤ φ⁻ + |x_n|"),
    )  # fmt: skip
    for name, term, fact in (("A_next", A_next, "A_next-below"), ("B", B, "B-below")):
        yield Line(f"{name}-ratio", V_0 * term <= V_1 * A,
                   proof(times("V_0-positive", fact), times("V_1-positive", "A-above")),
        )  # fmt: skip


def _zeta() -> Iterator[Item]:
    v0, v1 = "V_0-positive", "V_1-positive"
    growth = plus("zeta-positive", power("zeta-positive", 2))
    more = plus(times("A-positive", "tau-positive"), times(2, "Cnd1", "zeta-positive"))
    ratios = plus(times(v0, "B-positive", "A_next-ratio"), times(v1, "A-positive", "B-ratio"))
    y2 = power("Cnd1", 2)
    change = 2 * eta_s * tau + B * tau**2
    gains = plus(times(2, "recedes", "tau-positive"), times("B-positive", power("tau-positive", 2)))
    size = times(power("D-positive", 2), power("next-Cnd1", 2))
    yield from (
        Line("zeta-first", 2 * A * eta_s * tau <= eta_s * y * (zeta + zeta**2),
             proof(times("recedes", "Cnd1", "root-twice"),
                   equations=(("tau-product", -2 * eta_s),))),
        Line("zeta-terms-1-to-3",
             V_0**2 * A**2 * (2 * eta_s * tau) * A_next
             <= V_0 * V_1 * A**2 * eta_s * y * (zeta + zeta**2),
             proof(times(v0, v0, "A-positive", "next-A-positive", "zeta-first"),
                   times(v0, "A-positive", "recedes", "Cnd1", "A_next-ratio", growth)),
             "EQUATSS4.1Recurrence_Cnd4", "first, second and third term of ζ'"),
        Line("zeta-term-4",
             V_0**2 * A**2 * B * tau**2 * A_next <= 4 * V_1**2 * A**2 * y**2 * zeta**2,
             proof(times(v0, v0, "B-positive", "next-A-positive", "time-product", more),
                   times(4, power("Cnd1", 2), power("zeta-positive", 2), ratios)),
             "EQUATSS4.1Recurrence_Cnd4", "fourth term of ζ'"),
        Line("zeta-all",
             V_0 * V_1 * eta_s * y * (zeta + zeta**2) + 4 * V_1**2 * y**2 * zeta**2
             <= V_0**2 * zeta_bar * y_next**2,
             proof(times(v0, v1, "Cnd1", growth, "ratio-worst"),
                   times(v0, v1, y2, "zeta-positive", "ratio-positive", "zeta-bound"),
                   times(v0, v1, y2, "zeta-positive", "zeta_bar-positive", "y-ratio"),
                   times(4, power(v1, 2), y2, "zeta-positive", "zeta-bound"),
                   times(y2, "zeta-positive", "zeta-room"),
                   times(v0, v0, y2, "zeta-bound", power("gap-room", 2)),
                   times(v0, v0, "zeta_bar-positive", "y-lower-bound",
                         plus("next-Cnd1", times("gap-room", "Cnd1")))),
             "EQUATSS4.1Recurrence_Cnd4", "the four terms together"),
        Line("zeta-cleared", change * A_next <= zeta_bar * y_next**2,
             scaled(times(v0, v0, power("A-positive", 2), "goal"), "zeta-terms-1-to-3",
                    "zeta-term-4", times(power("A-positive", 2), "zeta-all"))),
        Line("zeta-product-next", (D - 1) * (2 + (D - 1)) * A_next <= zeta_bar * D**2 * y_next**2,
             proof("zeta-cleared", times("zeta_bar-positive", power("next-Cnd1", 2), gains),
                   using="D")),
        next_condition("Cnd4",
             "EQUATSS4.1Recurrence_Cnd4", "ζ' ≤ ζ̄", "zeta-product-next", using="d_next"),
        next_condition("Cnd3", "EQUATSS4.1Recurrence_Cnd3", "ζ' < 1", "zeta-product-next",
             times(size, "init-Cnd3"), using="d_next"),
    )  # fmt: skip


def _time() -> Iterator[Item]:
    yield next_condition("clock-bound", THEOREM,
                         "the time of the next collision is at most 2ζ̄(η̄ - "
                         "C_η^{n+1}|η_{c,0}|)/(V₀(1-C_η))", "clock-bound",
                         times("decay-positive", "time"),
                         times(2, "decay-positive", "Cnd1", "zeta-bound"),
                         times(2, "decay-positive", "zeta_bar-positive", "Cnd2"))  # fmt: skip


def conclusion() -> Iterator[Item]:
    """In every state that satisfies the conditions."""
    goal = times("decay-speed-positive", "goal")
    spent = (times("decay-speed-positive", "d-positive"), times(14, "speed-positive", "g-positive"))
    for side, term in (("upper", C - c), ("lower", c - C)):
        yield Line(f"angle-final-{side}", term <= delta_theta,
                   scaled(goal, f"Cnd8-{side}", *spent, "final-angle"), THEOREM,
                   "|(-cos θ_n) - (-cos θ₀)| ≤ δ_θ for every n, hence for the final angle",
                   ("bounded-monotone",))  # fmt: skip
    yield Line("time-total", clock <= T_star,
               scaled(goal, "clock-bound", "collapse-time",
                      times(2, "zeta_bar-positive", "g-positive")), THEOREM,
               "t_n ≤ T* for every n: the times of the collisions converge", ("bounded-monotone",),
    )  # fmt: skip
    moving = (
        times(2, "decay-positive", "distance-speed"),
        times(4, "decay-positive", "speed-positive", "time-crude"),
        times(14, "decay-positive", "speed-positive", "Cnd2"),
    )
    size, size_next = d + beta * g, d_next + beta * (C_eta * g)
    for side, claim, says in (
        ("upper", C_next + size_next <= C + size, "-cos θ_n + d_n + β g_n falls with n"),
        ("lower", C - size <= C_next - size_next, "-cos θ_n - d_n - β g_n rises with n"),
    ):
        changes = (times("decay-speed-positive", f"angle-step-{side}"), *moving)
        yield Line(f"angle-monotone-{side}", claim,
                   proof(*(times("decay-speed-positive", change) for change in changes),
                         using="d_next"),
                   THEOREM, f"{says}: the angle converges", ("bounded-monotone",))  # fmt: skip
