"""The other conditions at the next state: the ratios, the distance, zeta, and the time.

What follows at every n stands at the end: bounds on the angle and on the time, and two monotone
quantities.
"""

from __future__ import annotations

from collections.abc import Iterator

from verify.language.argument import Item, Line, plus, power, proof, scaled, square, times
from verify.paper.dynamics.laws import GAINED_UPPER, parts
from verify.paper.dynamics.state import C, C_next, kept, y, y_next
from verify.paper.parameters import THEOREM
from verify.paper.sharper.bounds import HALF, REACH
from verify.paper.sharper.collision import SUMMED, TURNED
from verify.paper.sharper.numbers import (
    C_0,
    Theta,
    V,
    X,
    duration,
    eta_0,
    least_ratio,
    m,
    ratio,
    reach,
    total,
)
from verify.paper.sharper.state import carried, clock, g, root_lines, zeta_small

GROWTH = "EQUATSS4.1Lien_x_n_&_y_n_"


def lines() -> Iterator[Item]:
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
