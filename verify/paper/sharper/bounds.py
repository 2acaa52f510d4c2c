"""What follows from the inequalities between the numbers, before any collision.

Among it that the outer particles stay apart: no inequality has to ask for that.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from verify.language.argument import Item, Line, plus, power, proof, scaled, square, times
from verify.paper.dynamics.carried import start, summed
from verify.paper.dynamics.state import r
from verify.paper.sharper.state import (
    C_0,
    SUMS,
    V_0,
    T,
    Theta,
    V,
    X,
    eta_0,
    gain,
    half,
    k,
    least_ratio,
    m,
    ratio,
    root,
    total,
)

#: TV^2: the bound of the root is 1 - loss. With how it is positive, and other products that are.
loss = T * V**2
LOSS = times("T-positive", square(V))
HALF = times(Fraction(1, 2), plus(1, "r-positive"))
EXCESS = times("k-positive", power("eta_0-positive", 2))
REACH = plus(1, EXCESS)


def lines() -> Iterator[Item]:
    """In an order in which each follows from those before."""
    yield from _signs()
    yield from _sums()
    yield from _ratios()
    yield from _apart()


def _signs() -> Iterator[Item]:
    y2 = power("start-Cnd1", 2)
    both = ("start-ratio-upper", "start-ratio-lower")
    used = ("least-ratio-positive", "ratio-positive", LOSS)
    yield from (
        Line("eta_0-positive", 0 < eta_0, proof("start-Cnd1", "start-Cnd2")),
        Line("V_0-positive", 0 < V_0, proof("eta_0-positive", "speed-start")),
        Line("k-positive", 0 < k, scaled(times("goal", y2), "start-d-positive", "start-d-small")),
        Line("T-positive", 0 < T,
             scaled(times(2, "goal"), "time-room", square(T * V), times(2, "k-positive"))),
        Line("T-least", k <= T, scaled(times(2, "goal"), "time-room", square(T * V))),
        Line("X-positive", 0 <= X, scaled(times(2, "goal", "start-Cnd1"), *both)),
        Line("ratio-positive", 0 < m + X,
             scaled(times("goal", "start-Cnd1"), "start-ratio-upper", "start-recedes")),
        Line("root-room", 0 < root, scaled(times(HALF, "obtuse", "goal"), "y-lower-room", *used)),
        Line("zeta-room", 0 < 1 - 2 * k * V**2,
             proof(times(square(V), "time-room"), power("root-room", 2))),
    )  # fmt: skip


def _sums() -> Iterator[Item]:
    added = times(HALF, REACH, "eta_0-positive")
    yield Line("V-above", V_0 <= V, scaled(times("decay-positive", "goal"), "speed-room", added))
    yield Line("V-positive", 0 < V, proof("V-above", "V_0-positive"))
    signs = {
        "gain": times(HALF, REACH),
        "turn_1": times(2, "T-positive", "V-positive"),
        "turn_2": plus("k-positive", square(T * V)),
        "turn_3": times("T-positive", "V-positive", "k-positive"),
        "duration": "T-positive",
    }
    for name, sign in signs.items():
        yield from summed(name, SUMS, sign)
    yield Line("speed-least", V_0 <= V - gain * eta_0, proof("speed-room", using="gain"))
    using = "turn_1 turn_2 turn_3"
    for side, change in (("upper", start.C - C_0), ("lower", C_0 - start.C)):
        claim = change <= Theta - total(eta_0)
        yield Line(f"start-angle-{side}", claim, proof(f"start-C-{side}", using=using))
    yield from (
        Line("Theta-room",     0 <= Theta - total(eta_0),
             scaled(times(2, "goal"), "start-angle-upper", "start-angle-lower")),
        Line("Theta-positive", 0 < Theta, proof("Theta-room", TOTAL)),
    )  # fmt: skip


TOTAL = plus(
    times("turn_1-positive", "eta_0-positive"),
    times("turn_2-positive", power("eta_0-positive", 2)),
    times("turn_3-positive", power("eta_0-positive", 3)),
)


def _ratios() -> Iterator[Item]:
    angle = plus(
        times(EXCESS, plus("obtuse", times(2, "Theta-positive"))),
        times(2, "Theta-positive"),
        times(LOSS, "obtuse"),
    )
    below = times("least-ratio-below", plus(1, "least-ratio-positive"))
    yield from (
        Line("ratio-order",       least_ratio + loss <= ratio,
             scaled(times(REACH, "goal"), "y-upper-room", times(REACH, "y-lower-room"),
                    times(2, "X-positive"), times(EXCESS, "ratio-positive"),
                    times(HALF, REACH, angle)), says="p - Y + TV² ≤ p + Y"),
        Line("loss-decay",        loss <= ratio, proof("ratio-order", "least-ratio-positive")),
        Line("growth-positive",   0 < ratio, proof("ratio-order", "least-ratio-positive", LOSS)),
        Line("least-ratio-below", 0 < 1 - least_ratio,
             proof("ratio-order", LOSS, "decay-positive")),
        Line("ratio-below",       0 < 1 - (m + X),
             scaled(times("T-positive", "goal"), "d-room",
                    times("T-least", power("least-ratio-positive", 2)), times("T-positive", below),
                    times(Fraction(1, 2), square(T * V)))),
        Line("r-below-one",       0 < 1 - r,
             proof("x-upper-room", times("r-positive", EXCESS),
                   times("ratio-positive", "least-ratio-below"), "ratio-below"),
             says="the inequalities imply r < 1"),
    )  # fmt: skip


def _apart() -> Iterator[Item]:
    cubic = plus(
        times("root-room", square(1 - Fraction(27, 10) * loss)),
        times(LOSS, square(Fraction(3, 2) * loss - Fraction(3, 5))),
        times(Fraction(1, 25), LOSS),
        times(Fraction(11, 100), power(LOSS, 2)),
        times(Fraction(1, 25), power(LOSS, 3)),
    )
    yield from (
        Line("loss-bound",   loss <= half * root,
             proof("y-lower-room", times(HALF, "root-room", plus("angle-real", "Theta-positive")),
                   "ratio-positive", "least-ratio-positive")),
        Line("apart-least",  0 <= root * (1 - 5 * loss) + half,
             scaled(times("root-room", "goal"), "loss-bound", cubic)),
        Line("apart-most",   0 <= (1 - ratio) * (1 - 5 * loss) + half,
             scaled(times("root-room", "goal"), times("decay-positive", "apart-least"),
                    times(HALF, "loss-decay"))),
        Line("apart-scaled", 5 * loss * eta_0 <= V,
             scaled(times("decay-positive", "goal"), "speed-room",
                    times("decay-positive", "speed-start"), times("eta_0-positive", "apart-most"),
                    times(HALF, EXCESS, "eta_0-positive"))),
        Line("apart-room",   5 * T * V * eta_0 <= 1,
             scaled(times("V-positive", "goal"), "apart-scaled"),
             says="the inequalities imply TVη₀ ≤ 1/5: in one step no particle gets far"),
    )  # fmt: skip
