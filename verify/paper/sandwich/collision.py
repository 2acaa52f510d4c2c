"""The collision: the angle, the speeds, and the map of two numbers at the next state."""

from __future__ import annotations

from collections.abc import Iterator

from verify.language.argument import Item, Line, identity, plus, power, proof, scaled, times
from verify.language.terms import as_term
from verify.paper.dynamics.carried import Carried, start
from verify.paper.dynamics.laws import (
    ANGLE,
    C_NEXT_ONE,
    COMPONENTS,
    GAINED_UPPER,
    IMPACT_POSITIVE,
    NORMS,
    TURN,
    impact,
    laws,
    parts,
    spin,
    spinning,
)
from verify.paper.dynamics.state import A_next, C, C_next, D, S, d_next, kept, tau, y, y_next
from verify.paper.parameters import THEOREM
from verify.paper.sandwich.flight import PUSH
from verify.paper.sandwich.state import (
    C_0,
    G_POSITIVE,
    HALF,
    G,
    Theta,
    U,
    carried,
    clock,
    duration,
    g,
    gain,
    half,
    load,
    pace,
    ratio,
    turning,
    w_0,
    w_1,
    w_s,
)

GROWTH = "EQUATSS4.1Lien_x_n_&_y_n_"
#: How far -cos theta can turning until the next collision.
change = (w_0 + w_1 + start.y) * tau


def lines() -> Iterator[Item]:
    """The laws, then all conditions at the next state."""
    yield from _turning()
    yield from laws()
    yield TURN
    yield from _angle()
    yield from _impact()
    yield from _speeds()
    yield from _ratio()
    yield from _next_u()
    yield from _others()


SUM = plus("w_0-positive", "w_1-positive", "start-y")


def _turning() -> Iterator[Item]:
    yield Line(
        "C-positive", 0 < C, proof("angle-lower", "obtuse", times("turning-positive", "g-positive"))
    )
    more = times("turning-positive", "ratio-positive", "Cnd1")
    yield Line("turned", change <= turning * (1 - ratio) * y,
               scaled(times("goal", power("w_b-positive", 2)), times(SUM, "time"),
                      equations=(("turning-sum", y),)))  # fmt: skip
    yield Line("turn-short", 0 < C - change,
               proof("turned", "angle-lower", "obtuse",
                     times("turning-positive", "Cnd2"), more),
               ANGLE, "until the next collision -cos θ turns by less than itself")  # fmt: skip


def _angle() -> Iterator[Item]:
    yield from spinning((w_s, "w_s-positive"))
    wide = times("D-one", "tau-positive", SUM)
    further = times("tau-positive", "y-most")
    sums = ("w-sum", -tau)
    yield from (
        Line("angle-step-lower", C - C_next <= change,
             scaled(times("D-positive", "goal"), times("d-positive", "C-positive"), "outward",
                    further, times("D-one", "C-one"), wide,
                    times("tau-positive", plus("a-upper", "spin-upper")),
                    equations=(("turn", as_term(1)), sums)),
             ANGLE, "-cos θ' ≥ -cos θ - (w_c+w_s+η₀)τ"),
        Line("angle-step-upper", C_next - C <= change,
             scaled(times("D-positive", "goal"), times("D-one", "C-positive"), "inward", further,
                    times("d-positive", "C-one"), wide,
                    times("tau-positive", plus("a-lower", "spin-lower")),
                    equations=(("turn", as_term(-1)), sums)),
             ANGLE, "-cos θ' ≤ -cos θ + (w_c+w_s+η₀)τ"),
    )  # fmt: skip
    slower = times("turning-positive", "decay-positive", "Cnd2")
    for side in ("upper", "lower"):
        yield carried.line(f"angle-{side}",
                           "|(-cos θ) - C₀| stays below Θ less the sum of all later changes",
                           f"angle-step-{side}", f"angle-{side}", "turned", slower)  # fmt: skip
    later = times("turning-positive", "ratio-positive", "g-positive")
    yield from (
        Line("C_next-least", C_0 - Theta <= C_next, proof("next-angle-lower", later)),
        Line("C_next-positive", 0 < C_next, proof("C_next-least", "obtuse")),
        C_NEXT_ONE,
    )  # fmt: skip


IMPACT_BOUND = Line("impact-bound", impact <= G * y,
                    proof(times("d-sum-positive", "Cnd1", "S-one"), times("Cnd1", "reach-here")),
                    COMPONENTS, "|W_c·ω_s'| ≤ Γ(-η_c)")  # fmt: skip


def _impact() -> Iterator[Item]:
    yield from (
        IMPACT_POSITIVE,
        IMPACT_BOUND,
        Line("impact-least", (1 - U) * y <= impact,
             proof(times("Cnd1", "S-least"), times("d-positive", "Cnd1", "S-positive")),
             COMPONENTS, "|W_c·ω_s'| ≥ (1-U)(-η_c)"),
    )  # fmt: skip


#: The bound of |W_s| less the sum of all later changes.
high = w_s - gain * g


def struck() -> Iterator[Item]:
    """The most that the collision makes of the speed of the particle that is struck."""
    hit = times(HALF, "impact-positive")
    yield from (
        Line("spin-high",   spin <= high,
             scaled(times("goal", plus("goal", times(2, "high-s"))), "spin-square", "B-upper")),
        Line("struck-most", A_next <= (high + half * impact) ** 2,
             proof(times(2, hit, "spin-high"), "B-upper", using="law-norm-c impact-speed"),
             NORMS, "|W_c'| ≤ |W_s| + (1+r)/2 |W_c·ω_s'|, with a bound for |W_s|"),
    )  # fmt: skip


def _speeds() -> Iterator[Item]:
    """Each bound leaves room for the sum of all later changes."""
    most = w_s - ratio * gain * (ratio * g)
    hit = times(HALF, "impact-positive")
    later = times(power("ratio-positive", 2), "gain-positive", "g-positive")
    energy = times("r-below-one", plus(1, "r-positive"), power("impact-positive", 2))
    falls = times("gain-positive", "g-positive", "decay-2-positive")
    yield from (
        *struck(),
        Line("struck-room", high + half * impact <= most,
             proof(times(HALF, "impact-bound"), times(HALF, G_POSITIVE, "Cnd2"),
                   equations=(("gain-sum", g),))),
        carried.line("high-c", "w_s stays above the bound of |W_c'|", "high-s", falls),
        carried.line("high-s", "w_c stays above the bound of |W_s'|", "high-c"),
        carried.line("A-upper", "|W_c'| stays below w_s less the sum of all later changes",
             "struck-most",
             times("struck-room", plus("struck-room", times(2, plus("high-s", hit))))),
        carried.line("B-upper", "|W_s'| stays below w_c less the sum of all later changes",
             "A-upper", energy, using="law-norm-s impact-speed"),
        Line("next-A-below", A_next <= w_s**2,
             proof("next-A-upper", times(later, plus("next-high-c", "w_s-positive")))),
    )  # fmt: skip


def slower(of: Carried) -> Iterator[Item]:
    """The speed of approach falls by the factor Λ at least."""
    yield from (
        of.line("Cnd2", "|η_c'| ≤ Λ^{n+1} η₀",
             times(HALF, "impact-positive", "C_next-one"), times(HALF, "impact-bound"),
             "kept-positive", "gained-positive", times("ratio-positive", "Cnd2"),
             using="normal-parts"),
        of.line("g-bound", "Λ^{n+1} η₀ ≤ η₀", "g-bound", times("g-positive", "decay-positive")),
    )  # fmt: skip


KEPT_POSITIVE = Line("kept-positive", 0 < kept, proof("recedes", using="kept"))


def _ratio() -> Iterator[Item]:
    yield from parts()
    lost = plus("kept-upper", "gained-upper", "pull-most")
    slow = plus(times("S-least", "Q-positive", "Cnd1"), times("U-one", "q-bound"))
    pushed = times("S-least", PUSH, "Cnd1")
    turned = plus(times("d-positive", "C_next-positive"), "C_next-least")
    yield from (
        GAINED_UPPER,
        KEPT_POSITIVE,
        Line("next-pace", pace * y <= y_next,
             proof(times(HALF, "impact-least", "C_next-positive"),
                   times(HALF, "U-one", "Cnd1", "C_next-least"), lost, "q-bound",
                   using="normal-parts pace-law"), GROWTH, "η_c'/η_c ≥ P"),
        Line("order", pace * y * S <= (1 - U) * y_next,
             proof(times("U-one", HALF, "S-positive", "Cnd1", turned), times("U-one", lost),
                   slow, pushed,
                   using="normal-parts pace-law"), GROWTH,
             "√(1-ζ)/(1-U) ≤ (η_c'/η_c)/P: the step keeps the order"),
        carried.line("Cnd1", "η_c' < 0", "next-pace", times("pace-positive", "Cnd1")),
        *slower(carried),
        carried.line("recedes", "η_s' > 0: the pair that just met separates",
             times("r-positive", "impact-positive"), using="law-eta-s"),
        Line("next-q-bound", carried.at_next("q-bound"),
             scaled(times("goal", "pace-positive"),
                    times("r-positive", "d-sum-positive", "order"),
                    times("r-positive", "reach-here", "U-one", "next-Cnd1"),
                    equations=(("Q-next-law", y_next),), using="law-eta-s"),
             says="η_s'/(-η_c') ≤ Q'"),
    )  # fmt: skip


def _next_u() -> Iterator[Item]:
    push = times(PUSH, "Cnd1")
    faster = times("next-pace", plus("next-pace", times(2, "pace-positive", "Cnd1")))
    further = times("next-d-positive", plus(2, "next-d-positive"))
    bent = times(power("next-d-sum-positive", 2), power("next-Cnd1", 2))
    pulled = times("B-below", power(times("w_s-positive", "tau-positive"), 2))
    yield from (
        Line("spread", w_s**2 * (D**2 - 1) <= load * y**2,
             proof(times(2, "q-bound", push), times(2, "recedes", "pull"), pulled,
                   times("pull", plus(push, times(power("w_s-positive", 2), "tau-positive"))),
                   equations=(("D-square", -(w_s**2)),), using="load-law")),
        Line("next-spread", w_s**2 * (d_next * (2 + d_next)) <= load * y**2,
             proof("spread", using="d_next")),
        Line("next-u-bound", carried.at_next("u-bound"),
             scaled(times("goal", power("pace-positive", 2)),
                    times("next-spread", power("pace-positive", 2)), times("load-positive", faster),
                    times("load-positive", further, power("next-Cnd1", 2)),
                    equations=(("U-next-law", (1 + d_next) ** 2 * y_next**2),)),
             says="u' ≤ U'"),
        Line("next-Cnd3", carried.at_next("Cnd3"),
             proof("next-u-bound", times(further, "next-A-below"),
                   times(power("U-next-one", 2), bent)), says="ζ' < 1"),
    )  # fmt: skip
    yield from carried.root("next-", carried.following)


def _others() -> Iterator[Item]:
    for name in ("w_c-positive", "w_c-least"):
        other = name.replace("w_c", "w_s")
        for one, source in ((name, other), (other, name)):
            yield Line(f"next-{one}", carried.at_next(one), proof(source))
    yield Line("next-w-sum", carried.at_next("w-sum"), identity("", (("w-sum", as_term(1)),)))
    v2 = power("w_b-positive", 2)
    yield Line("next-clock-bound", carried.at_next("clock-bound"),
               scaled(times("goal", v2), times("clock-bound", v2), "time",
                      times("duration-positive", "decay-positive", "Cnd2", v2),
                      equations=(("duration-sum", y),)),
               says="the time of the next collision is at most G_T(η₀ - Λ^{n+1}η₀)")  # fmt: skip


USES = ("bounded-monotone",)


def conclusion() -> Iterator[Item]:
    """In every state that satisfies the conditions."""
    later = times("turning-positive", "g-positive")
    for side, term in (("upper", C - C_0), ("lower", C_0 - C)):
        yield Line(f"angle-final-{side}", term <= Theta, proof(f"angle-{side}", later),
                   THEOREM, "|(-cos θ_n) - C₀| ≤ Θ for every n, hence for the final angle", USES,
        )  # fmt: skip
    yield Line("time-total", clock <= duration * start.y,
               proof("clock-bound", times("duration-positive", "g-positive")),
               THEOREM, "t_n ≤ G_T η₀ for every n: the times of the collisions converge", USES,
    )  # fmt: skip
    slower = times("turning-positive", "decay-positive", "Cnd2")
    for side, claim, says in (
        (
            "upper",
            C_next + turning * (ratio * g) <= C + turning * g,
            "-cos θ_n + G_C g_n falls with n",
        ),
        (
            "lower",
            C - turning * g <= C_next - turning * (ratio * g),
            "-cos θ_n - G_C g_n rises with n",
        ),
    ):
        yield Line(f"angle-monotone-{side}", claim, proof(f"angle-step-{side}", "turned", slower),
                   THEOREM, f"{says}: the angle converges", USES)  # fmt: skip
