"""What follows at every n: bounds on the angle and on the time, and two monotone quantities."""

from __future__ import annotations

from collections.abc import Iterator

from verify.language.argument import Item, Line, proof, scaled, times
from verify.paper.dynamics.state import C, C_next, d, d_next
from verify.paper.parameters import THEOREM
from verify.paper.step.numbers import C_eta, T_star, c, delta_theta
from verify.paper.step.state import beta, clock, g


def lines() -> Iterator[Item]:
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
