"""The collision: the laws of Section 4, then all conditions at the next state.

What follows at every n stands at the end: bounds on the angle and on the time, and two monotone
quantities.
"""

from __future__ import annotations

from collections.abc import Iterator

from verify.language.argument import Item, Line, plus, power, proof, scaled, square, times
from verify.language.terms import as_term
from verify.paper.dynamics.laws import (
    ANGLE,
    COMPONENTS,
    GAINED_UPPER,
    IMPACT_POSITIVE,
    NORMS,
    SPIN_SQUARE,
    TURN,
    absolute,
    at_the_contact,
    half,
    impact,
    laws,
    parts,
    spin,
)
from verify.paper.dynamics.state import A_next, C, C_next, kept, y, y_next
from verify.paper.parameters import THEOREM
from verify.paper.sharper.state import (
    C_0,
    HALF,
    REACH,
    T,
    Theta,
    V,
    X,
    carried,
    clock,
    duration,
    eta_0,
    g,
    k,
    least_ratio,
    m,
    ratio,
    reach,
    root,
    root_lines,
    speed,
    speed_next,
    total,
    zeta_small,
)

#: How far -cos theta can turn until the next collision.
change = 2 * T * V * y + (k + T**2 * V**2) * y**2 + T * V * k * y**3
_TV = times("T-positive", "V-positive")
_SQUARES = plus(power("g-positive", 2), times("g-positive", "Cnd1"), power("Cnd1", 2))
#: That this is at most the difference of two sums over all later collisions.
TURNED = (
    times(2, _TV, "Cnd2"),
    times(plus("k-positive", square(T * V)), "Cnd2", plus("g-positive", "Cnd1")),
    times(_TV, "k-positive", "Cnd2", _SQUARES),
)
SUMMED = (("turn_1-sum", g), ("turn_2-sum", g**2), ("turn_3-sum", g**3))


def lines() -> Iterator[Item]:
    """The laws, then the angle, the speed of the impact, and the speeds."""
    yield from laws()
    yield from _turning()
    yield from _angle()
    yield from _impact()
    yield from _speeds()


def _turning() -> Iterator[Item]:
    sums = plus(
        times("turn_1-positive", "g-positive"),
        times("turn_2-positive", power("g-positive", 2)),
        times("turn_3-positive", power("g-positive", 3)),
    )
    yield TURN
    yield Line("C-positive", 0 < C, proof("angle-lower", "obtuse", sums))
    tv, y1, tau = times("T-positive", "V-positive"), "Cnd1", "tau-positive"
    turned = plus(
        times(2, tv, y1),
        times("k-positive", power(y1, 2)),
        times(square(T * V), power(y1, 2)),
        times(tv, "k-positive", power(y1, 3)),
    )
    late = (
        times("V-positive", plus(2, "d-positive"), "time"),
        times(tv, y1, "d-small"),
        times(square(V), "time", plus(tau, times("T-positive", y1))),
    )
    for side, sign, other, near in (
        ("upper", 1, "lower",
         (times("D-one", "C-positive"), times("d-positive", "C-one"), "d-small")),
        ("lower", -1, "upper",
         (times("d-positive", "C-positive"), times("D-one", "C-one"), "distance-here")),
    ):  # fmt: skip
        yield Line(f"angle-step-{side}", (C_next - C if sign == 1 else C - C_next) <= change,
                   scaled(times("D-positive", "goal"), times("D-one", turned), *near,
                          times(tau, f"a-{other}"), times("d-sum-positive", tau, f"b-{other}"),
                          times(power(tau, 2), f"w-{other}"), *late)
                   ._replace(equations=(("turn", as_term(-sign)),)),
                   ANGLE, "|cos θ' - cos θ| ≤ 2TV(-η_c) + (κ+T²V²)η_c² + TVκ(-η_c)³")  # fmt: skip


def _angle() -> Iterator[Item]:
    for side in ("upper", "lower"):
        yield carried.line(f"angle-{side}",
                           "|(-cos θ) - C₀| stays below Θ less the sum of all later changes",
                           f"angle-step-{side}", f"angle-{side}", *TURNED, equations=SUMMED,
        )  # fmt: skip
    later = plus(
        *(
            times(f"turn_{i}-positive", power(times("growth-positive", "g-positive"), i))
            for i in (1, 2, 3)
        )
    )
    yield Line("C_next-least", C_0 - Theta <= C_next, proof("next-angle-lower", later))
    yield Line("C_next-most", C_next <= C_0 + Theta, proof("next-angle-upper", later))
    yield Line("C_next-positive", 0 < C_next, proof("C_next-least", "obtuse"))


def _impact() -> Iterator[Item]:
    yield from (
        IMPACT_POSITIVE,
        Line("impact-bound", impact <= reach * y,
             proof(times("d-sum-positive", "Cnd1", "S-one"), times("Cnd1", "d-crude")),
             COMPONENTS, "|W_c·ω_s'| ≤ (1+κη₀²)(-η_c)"),
        Line("impact-least", root * y <= impact,
             proof(times("Cnd1", "S-least"), times("d-positive", "Cnd1", "S-positive")),
             COMPONENTS, "|W_c·ω_s'| ≥ (1-TV²)(-η_c)"),
    )  # fmt: skip


def _speeds() -> Iterator[Item]:
    yield at_the_contact("impact-pair", "cs-impact")
    yield SPIN_SQUARE
    yield from absolute("spin", spin, (speed, "speed-positive"), ("spin-square", "B-upper"))
    hit = times(2, HALF, "impact-positive")
    struck = plus("speed-hit", times(2, "speed-positive"), hit)
    slower = times("gain-positive", "growth-positive", "g-positive")
    rest = plus(slower, times(2, plus("speed-positive", "speed-grows")))
    yield from (
        Line("norm-c", A_next <= (speed + half * impact) ** 2,
             proof(times(hit, "spin-upper"), "B-upper", using="law-norm-c impact-speed"),
             NORMS, "|W_c'| ≤ |W_s| + (1+r)/2 |W_c·ω_s'|, with a bound for |W_s|"),
        Line("speed-hit", speed + half * impact <= speed_next,
             proof(times(HALF, "impact-bound"), times(HALF, REACH, "Cnd2"),
                   equations=(("gain-sum", g),))),
        Line("speed-grows", speed <= speed_next,
             proof(times("gain-positive", "decay-positive", "g-positive"))),
        carried.line("A-upper", "|W_c'| stays below V less the sum of all later changes",
             "norm-c", times("speed-hit", struck)),
        carried.line("B-upper", "|W_s'| stays below V less the sum of all later changes",
             "A-upper", times("r-below-one", plus(1, "r-positive"), power("impact-positive", 2)),
             times("speed-grows", plus("speed-grows", times(2, "speed-positive"))),
             using="law-norm-s impact-speed"),
        Line("next-A-below", A_next <= V**2, proof("next-A-upper", times(slower, rest))),
    )  # fmt: skip


# --- the other conditions -------------------------------------------------------------------------


GROWTH = "EQUATSS4.1Lien_x_n_&_y_n_"


def conditions() -> Iterator[Item]:
    """First the ratio of the speeds of approach, on which the others rest."""
    yield from _ratio()
    yield from _sizes()
    yield from _others()


def _ratio() -> Iterator[Item]:
    yield from parts()
    yield from (
        GAINED_UPPER,
        Line("kept-least", (m - X) * y <= reach * kept,
             proof(times("D-positive", "ratio-lower"), times("distance-crude", "recedes"),
                   using="kept")),
        Line("y-upper-bound", y_next <= ratio * y,
             scaled(times(REACH, "goal"), times(REACH, HALF, "impact-bound", "C_next-positive"),
                    times(REACH, HALF, REACH, "Cnd1", "C_next-most"),
                    times(REACH, "gained-positive"), "kept-least", times("Cnd1", "y-upper-room"),
                    using="normal-parts"), GROWTH, "η_c'/η_c ≤ p + Y"),
        Line("y-lower-bound", least_ratio * y <= y_next,
             proof(times(HALF, "impact-least", "C_next-positive"),
                   times(HALF, "root-room", "Cnd1", "C_next-least"), "kept-upper", "ratio-upper",
                   "gained-upper", times("tau-positive", "B-below"), times(square(V), "time"),
                   times("Cnd1", "y-lower-room"), using="normal-parts"),
             GROWTH, "η_c'/η_c ≥ p - Y"),
    )  # fmt: skip


def _sizes() -> Iterator[Item]:
    survives = times("least-ratio-positive", "Cnd1")
    longer = times("k-positive", "y-lower-bound", plus("next-Cnd1", survives))
    yield from (
        carried.line("Cnd1",    "η_c' < 0", "y-lower-bound", survives),
        carried.line("Cnd2",    "|η_c'| ≤ (p+Y)^{n+1} η₀", "y-upper-bound",
             times("growth-positive", "Cnd2")),
        carried.line("g-bound", "(p+Y)^{n+1} η₀ ≤ η₀", "g-bound",
             times("g-positive", "decay-positive")),
        carried.line("d-small", "d' ≤ κη_c'²", "distance-slope", longer, using="d_next"),
    )  # fmt: skip


def _others() -> Iterator[Item]:
    yield from (
        carried.line("recedes",     "η_s' > 0: the pair that just met separates",
             times("r-positive", "impact-positive"), using="law-eta-s"),
        carried.line("ratio-upper", "η_s'/(-η_c') ≤ m + X", times("r-positive", "impact-bound"),
             times("Cnd1", "x-upper-room"), times("ratio-positive", "y-lower-bound"),
             using="law-eta-s"),
        carried.line("ratio-lower", "η_s'/(-η_c') ≥ m - X", times("r-positive", "impact-least"),
             times("Cnd1", "x-lower-room"), times("ratio-room", "y-upper-bound"),
             using="law-eta-s"),
    )  # fmt: skip
    yield from root_lines("next-", carried.following, zeta_small("next-", "next-A-below"))
    yield carried.line("clock-bound",
                       "the time of the next collision is at most T(η₀ - (p+Y)^{n+1}η₀)/(1-p-Y)",
                       "clock-bound", "time", times("T-positive", "Cnd2"),
                       equations=(("duration-sum", g),))  # fmt: skip


USES = ("bounded-monotone",)


def conclusion() -> Iterator[Item]:
    """In every state that satisfies the conditions."""
    sums = plus(*(times(f"turn_{i}-positive", power("g-positive", i)) for i in (1, 2, 3)))
    for side, term in (("upper", C - C_0), ("lower", C_0 - C)):
        yield Line(f"angle-final-{side}", term <= Theta, proof(f"angle-{side}", sums),
                   THEOREM, "|(-cos θ_n) - C₀| ≤ Θ for every n, hence for the final angle", USES,
        )  # fmt: skip
    yield Line("time-total", clock <= duration * eta_0,
               proof("clock-bound", times("duration-positive", "g-positive")),
               THEOREM, "t_n ≤ Tη₀/(1-p-Y) for every n: the times of the collisions converge", USES,
    )  # fmt: skip
    for side, claim, says in (
        ("upper", C_next + total(ratio * g) <= C + total(g), "-cos θ_n + G(g_n) falls with n"),
        ("lower", C - total(g) <= C_next - total(ratio * g), "-cos θ_n - G(g_n) rises with n"),
    ):
        yield Line(f"angle-monotone-{side}", claim,
                   proof(f"angle-step-{side}", *TURNED, equations=SUMMED), THEOREM,
                   f"{says}, with G(g) = G_1 g + G_2 g² + G_3 g³: the angle converges", USES,
        )  # fmt: skip
