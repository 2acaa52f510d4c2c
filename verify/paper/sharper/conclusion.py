"""What follows at every n: bounds on the angle and on the time, and two monotone quantities."""

from __future__ import annotations

from collections.abc import Iterator

from verify.language.argument import Item, Line, plus, power, proof, times
from verify.paper.dynamics.state import C, C_next
from verify.paper.parameters import THEOREM
from verify.paper.sharper.collision import SUMMED, TURNED
from verify.paper.sharper.numbers import C_0, Theta, duration, eta_0, ratio, total
from verify.paper.sharper.state import clock, g

USES = ("bounded-monotone",)


def lines() -> Iterator[Item]:
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
