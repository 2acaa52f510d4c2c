"""Which entries of the printed minima for |Delta_theta| and eta_bar are the least.

That is so for 1/16 <= V_0 <= 10^6: outside these bounds eta_bar may be 1, or its fourth entry.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from verify.language.argument import (
    ByEntry,
    ByLeast,
    Line,
    Reason,
    ToBeFound,
    plus,
    proof,
    scaled,
    times,
)
from verify.language.terms import minimum
from verify.paper.everywhere import chart
from verify.paper.everywhere.chart import p, u
from verify.paper.groups import PRINTED
from verify.paper.initial_data import ETA, X_0, ConstantSet
from verify.paper.parameters import V_0, delta_theta
from verify.paper.preliminaries import C_eta, h_4

LEAST_V_0, GREATEST_V_0 = Fraction(1, 16), Fraction(10**6)
k = ConstantSet(PRINTED)
angle = k.Delta_theta

#: The second entry of |Delta_theta|, and what |Delta_theta| is.
SHARE = h_4 * k.delta_x / 8
LEAST = minimum(SHARE, delta_theta)
THIRD = V_0 / (33 * k.speed) * k.Delta_theta
SHARE_MOST = Fraction(1, 64)


def of(name: str) -> str:
    """The full name of a fact about a constant of the set."""
    return f"{PRINTED}.{name}"


V_0s, ANGLE, ONE = chart.hypothesis("V_0-positive"), of("Delta_theta-positive"), "p-below-one"
ROOT = "V_1-root"
#: V_1 times 3+u, in the chart.
SPEED = times("v-positive", "v-positive", plus(3, "u-positive"))


def speeds() -> Iterator[Line]:
    """What the bounds on V_0 say about the root of V_1."""
    top = 1000
    yield from (
        Line("V_0-below-V_1", 0 < k.V_1 - V_0, ToBeFound()),
        Line("speed-least",   Fraction(1, 4) <= k.speed,
            scaled(times("goal", plus(ROOT, Fraction(1, 4))), "V_0-below-V_1", "V_0-least")),
        Line("V_0-speed",     V_0 <= top * k.speed,
            scaled(times("goal", plus(times(top, ROOT), V_0s)), times(V_0s, "V_0-greatest"),
            times(top**2, "V_0-below-V_1"))),
    )  # fmt: skip


def least() -> Iterator[Line]:
    """The least entries of the minima for |Delta_theta| and eta_bar."""
    branches = (proof("least-1", "share-half"), proof("least-1"), proof("least-2"))
    yield from (
        Line("share-positive",    0 < SHARE, ToBeFound()),
        Line("share-half",        SHARE <= k.bounds()["Delta_theta"][0], ToBeFound()),
        Line("share-small",       SHARE <= SHARE_MOST, ToBeFound(),
            X_0, "h₄δ_x/8 ≤ 1/64, so that δ_θ matters only below 1/64"),
        Line("least-1",           LEAST <= SHARE, ByEntry()),
        Line("least-2",           LEAST <= delta_theta, ByEntry()),
        Line("Delta_theta.least", LEAST <= angle, ByLeast(branches, angle.name),
            X_0, "|Δθ| is the smaller one of h₄δ_x/8 and δ_θ"),
        Line("angle-small", angle <= SHARE_MOST, proof(of("Delta_theta-entry-2"), "share-small")),
    )  # fmt: skip
    yield from _third()


def _third() -> Iterator[Line]:
    entries = k.bounds()["eta_bar"]
    rest = 33 - 1000 * SHARE_MOST
    reasons: dict[int, Reason] = {
        1: proof(times(ANGLE, "V_0-speed"), times(ROOT, plus(times(1000, "angle-small"), rest))),
        2: ToBeFound(),
        4: proof(times(3, ROOT, "room"), times(96, V_0s, ANGLE, "speed-least")),
        5: ToBeFound(),
    }
    yield from _room()
    for number, reason in reasons.items():
        yield Line(f"third-{number}", THIRD <= entries[number - 1], reason)
    branches = tuple(proof(*([] if n == 3 else [f"third-{n}"])) for n in range(1, 6))
    yield Line("eta_bar.least", THIRD <= k.eta_bar, ByLeast(branches, k.eta_bar.name),
        ETA, "entry 3 of the minimum for η̄ is the least")  # fmt: skip


def _room() -> Iterator[Line]:
    """Near u = 1 both |Delta_theta| and V_1 - V_0 tend to 0, as delta_5 is at most p (1-u)."""
    u_plus, u_left = plus(1, "u-positive"), "u-below-one"
    up = times("u-positive", "p-positive")
    yield from (
        Line("root-5-least",  u * p <= chart.root_5,
            scaled(times(u_plus, plus("root-5", up), "goal"),
            times(up, "p-positive", u_left, plus(2, "u-positive")), using="m.chart h_5.chart")),
        Line("delta_x-small", k.delta_x <= p * (1 - u),
            proof(of("delta_x-entry-5"), "root-5-least", using="delta_5.chart")),
        Line("angle-chart",   angle <= (1 - u * p) * p * (1 - u) / 16,
            proof(of("Delta_theta-entry-2"),
            times(Fraction(1, 16), plus(u_left, times("u-positive", ONE)), "delta_x-small"),
            using="h_4.chart")),
        Line("room-left",     0 < 11 * (1 - p) - 9 * (1 + u) * (1 - u * p) * p, ToBeFound()),
        Line("room",          36 * V_0 * angle <= 11 * (1 - C_eta) * (k.V_1 - V_0),
            proof(times(72, SPEED, u_plus, "angle-chart"),
            times(chart.HALF, SPEED, u_left, "room-left"),
            using="C_eta.chart V_0.chart V_1.chart")),
    )  # fmt: skip
