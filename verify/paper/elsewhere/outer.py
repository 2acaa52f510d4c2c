"""The outer pair: what the definition of the mapping asks for does not keep 1 and 2 apart.

In `outer` x is the vector from 1 to 2 and u their relative velocity. In `three` the balls are in a
plane: 1 touches 0 in the direction (1, 0), and 2 is at X.
"""

from __future__ import annotations

from collections.abc import Iterator

from verify.language.argument import Chapter, Item, Line, Opened, power, proof, scaled, times
from verify.language.terms import Claim, equal
from verify.paper.letters import Letters, Refuted, refuted
from verify.paper.rows import HARMLESS

SYSTEM = "EQUATSS2.2IterationSystm1"

n = Letters("outer", G="|x|²", k="x·u", U="|u|²", t="t", tau="τ")
v = Letters("three", X_1="X₁", X_2="X₂", a_1="(W₁)₁", a_2="(W₁)₂", b_1="(W₂)₁", b_2="(W₂)₂",
            tau="τ", t="t")  # fmt: skip
STATE = "3/4 1 1/10 1 -3/40 -1/10 2 1/10"


def chapters() -> Iterator[Chapter]:
    """What keeps them apart, and states that satisfy what the definition asks for."""
    apart = n.opened(
        "1 and 2 are apart now, and so far that they are at the time τ of the next collision too",
        "4 -1 1 1/2 1",
        {
            "now": 1 < n.G,
            "later": 1 < n.G + 2 * n.tau * n.k,
            "speed": 0 <= n.U,
            "time": 0 < n.t,
            "before": n.t <= n.tau,
        },
    )
    says = "three balls in a plane, as in the definition of the mapping, at a time t before τ"
    yield Chapter(None, (Opened(apart), Opened(v.opened(says, STATE, conditions()))))
    yield Chapter(n.context, tuple(_lines()))


def conditions() -> dict[str, Claim]:
    """What the definition asks for; that 1 and 2 are apart; and the time of 0 and 2."""
    inner, size = v.X_1 * v.b_1 + v.X_2 * v.b_2, v.X_1**2 + v.X_2**2
    speed = v.b_1**2 + v.b_2**2
    end_1, end_2 = v.X_1 + v.tau * v.b_1, v.X_2 + v.tau * v.b_2
    return {
        "apart": 1 < size,
        "recedes": 0 < v.a_1,
        "approaches": inner < 0,
        "zeta": (size - 1) * speed < inner**2,
        "outer": 1 < (v.X_1 - 1) ** 2 + v.X_2**2,
        "meets": equal(end_1**2 + end_2**2, 1),
        "impact": end_1 * v.b_1 + end_2 * v.b_2 < 0,
        "time": 0 < v.t,
        "before": v.t < v.tau,
    }


def _lines() -> Iterator[Item]:
    yield from (
        Line("tau-positive", 0 < n.tau, proof("outer-time", "outer-before")),
        Line("outer-apart",  1 < n.G + 2 * n.t * n.k + n.t**2 * n.U,
             scaled(times("goal", "tau-positive"), times("outer-now", "outer-before"),
                    times("outer-later", "outer-time"),
                    times("tau-positive", power("outer-time", 2), "outer-speed")), SYSTEM,
             "they stay apart if 1 < |x|² + 2τx·u besides: then 0 and 2 are the next to collide"),
    )  # fmt: skip


def misprints() -> Iterator[Refuted]:
    """What is false here, each with a point at which it is."""
    yield refuted(v, "next-collision",
                  1 <= (v.X_1 + v.t * (v.b_1 - v.a_1) - 1) ** 2
                  + (v.X_2 + v.t * (v.b_2 - v.a_2)) ** 2, STATE, label=SYSTEM,
                  says="0 and 2 are the next to collide if η₁ > 0, η₂ < 0 and ζ < 1, as the "
                       "definition of the mapping writes it out; here 1 and 2 meet before",
                  severity=HARMLESS, corrected_by="outer-apart")  # fmt: skip
