"""The map of two numbers (Q, U) that the dynamics stays above, and what orders its orbits.

With alpha, rho and R it is P = alpha (1-U) - Q - rho U, Q' = R (1-U)/P, and 1 - (1-U')^2 = rho U
(2 Q + rho U)/P^2. It goes on from (Q, U) if P > 0 and this is below 1. A floor has numbers that
satisfy the same with inequalities, rounded down; the orbit stays above them.
"""

from __future__ import annotations

from collections.abc import Iterator

from verify.language.argument import (
    ByRoot,
    Chapter,
    Item,
    Line,
    Opened,
    plus,
    power,
    proof,
    scaled,
    times,
)
from verify.language.statement import Context
from verify.language.terms import sqrt
from verify.paper.letters import Letters
from verify.paper.sandwich.comparison import LABEL, step

n = Letters(
    "floor", alpha="α", rho="ρ", R="R", Q_n="Q_n", U_n="U_n", Q_next="Q_{n+1}", U_next="U_{n+1}",
    Q="Q", U="U",
)  # fmt: skip
below = step(n.alpha, n.rho, n.R, n.Q_n, n.U_n)
above = step(n.alpha, n.rho, n.R, n.Q, n.U)


def context() -> Context:
    """Numbers from which one step of the map is bounded from below, and a point above them."""
    return n.opened(
        "a step of a floor: numbers Q_{n+1}, U_{n+1} below where the map leads from Q_n, U_n; and "
        "a point (Q, U) above, from which the map goes on",
        "1/2 1 3/100 1/10 1/10 1/50 1/50 1/10 1/10",
        {
            "alpha": 0 <= n.alpha,
            "rho": 0 <= n.rho,
            "R": 0 <= n.R,
            "Q": 0 <= n.Q_n,
            "U": 0 <= n.U_n,
            "U_next": 0 <= n.U_next,
            "U_next-room": n.U_next <= 1,
            "rises-Q": n.Q_next * below.P <= n.R * (1 - n.U_n),
            "rises-U": n.U_next * (2 - n.U_next) * below.P**2 <= below.load,
            "over-Q": n.Q_n <= n.Q,
            "over-U": n.U_n <= n.U,
            "room": 0 < 1 - n.U,
            "approaches": above.approaches,
            "meets": above.meets,
        },
    )


def chapters() -> Iterator[Chapter]:
    """What lies above a step of a floor stays above the next one, or stops."""
    yield Chapter(None, (Opened(context()),))
    yield Chapter(n.context, tuple(_above()))


def _above() -> Iterator[Item]:
    lower = times(plus("floor-alpha", "floor-rho"), "floor-over-U")
    least = plus("floor-approaches", "over-pace")
    U_least, Q_least = plus("floor-U", "floor-over-U"), plus("floor-Q", "floor-over-Q")
    heavier = times(
        "floor-rho",
        plus(times(2, "floor-over-U", Q_least), times(2, "floor-U", "floor-over-Q"),
             times("floor-rho", "floor-over-U", plus("floor-U", U_least))),
    )  # fmt: skip
    slower = times("over-pace", plus("floor-approaches", least))
    order = plus(
        times("floor-room", plus("floor-over-Q", times("floor-rho", "floor-over-U"))),
        times("floor-over-U", plus(Q_least, times("floor-rho", U_least))),
    )
    small = times("floor-U_next", plus(1, "floor-U_next-room"), slower)
    yield from (
        Line("over-pace",       above.P <= below.P, proof("floor-over-Q", lower)),
        Line("over-goes",       below.approaches, proof("over-pace", "floor-approaches"),
             LABEL, "where the map goes on from a point above a floor, P > 0 on the floor"),
        Line("over-load",       below.load <= above.load, proof(heavier)),
        Line("over-met",        below.meets, proof("over-load", "floor-meets", slower),
             LABEL, "and ρU(2Q+ρU) < P² there: so where the floor ends, so does every orbit above"),
        Line("over-Q-rises",    n.Q_next <= above.next_q,
             scaled(times("goal", "over-goes"),
                    times("floor-rises-Q", "floor-approaches"), times("floor-R", order)),
             LABEL, "Q_{n+1} ≤ Q'"),
        Line("over-radicand",   0 < above.radicand, proof("floor-meets")),
        Line("over-root",       0 < sqrt(above.radicand), ByRoot()),
        Line("over-U-rises",    n.U_next <= above.next_u,
             scaled(times("goal", plus("over-root", "floor-U_next-room"),
                          power("floor-approaches", 2)),
                    "floor-rises-U", "over-load", small),
             LABEL, "U_{n+1} ≤ U': it is above the next step"),
    )  # fmt: skip
