"""The rows, solved for what the later lines need."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from verify.language.argument import ByInterval, ByRoot, Item, Line, power, proof, scaled, times
from verify.language.terms import sqrt
from verify.paper.step.numbers import (
    V_0,
    V_1,
    C_eta,
    alpha_0,
    d_const,
    d_later,
    delta_2,
    delta_x,
    eighth,
    eta_bar,
    gap,
    h_4,
    phi_minus,
    share,
    speed,
    zeta_bar,
)

root_two = sqrt(2)
small = delta_2 * share / 2


def ground_lines() -> Iterator[Item]:
    """Bounds on the square root of two."""
    yield Line("root-two-lower", 1 < root_two, ByInterval())
    yield Line("root-two-upper", root_two < Fraction(19, 12), ByInterval())


def lines() -> Iterator[Item]:
    """Consequences of the rows alone."""
    total = V_0 * V_1 * (phi_minus + delta_x) + (V_0 * V_1 * (alpha_0 / 2) + 4 * V_1**2) * zeta_bar
    yield from (
        Line("speed-positive", 0 < speed, ByRoot()),
        Line("ratio-half", phi_minus + (1 - h_4 / 2) * delta_x <= alpha_0 / 2,
             proof("y-ratio", times(Fraction(1, 2), "h_4-positive", "delta_x-positive"))),
        Line("gap-upper", gap + delta_x <= C_eta, proof("eta-contraction", using="same-delta")),
        Line("gap-lower", delta_2 <= gap - delta_x, proof("zeta-denominator", using="same-delta")),
        Line("gap-room", 0 < gap - delta_x, proof("gap-lower", "delta_2-positive")),
        Line("h_4-room", 0 < 1 - h_4, proof("h_4-below-one")),
        Line("contraction", phi_minus <= (1 - h_4) * (gap - delta_x),
             scaled(times("gap-positive", "goal"), "x-contraction",
                    times("h_4-room", "gap-room", "delta_x-positive"),
                    using="same-delta r-product")),
        Line("zeta_bar-small", 2 * zeta_bar <= small, proof("x-term-1-zeta")),
        Line("d_later-small", d_later <= small, proof("x-term-1-d")),
        Line("time-short", 1 < root_two - 7 * speed / V_0 * eta_bar, proof("CndT")),
        Line("zeta-room", total <= V_0**2 * (gap - delta_x) ** 2,
             scaled(times("V_0-positive", "V_0-positive", power("gap-room", 4), "goal"),
                    "zeta-total",
                    times(Fraction(1, 4), power("V_0-positive", 4), power("gap-room", 6),
                          "h_5-positive"), using="same-delta")),
        Line("d_const-one", d_const <= 1,
             scaled(times(4, "goal"), times(4, "d_const-entry-1"), "root-two-upper",
                    Fraction(41, 12))),
        Line("d_const-share", d_const <= eighth, proof("d_const-entry-4")),
        Line("d_const-small", d_const <= small, proof("d_const-entry-3")),
        Line("eighth-positive", 0 < eighth, proof(times(Fraction(1, 8), *_SHARE))),
        Line("small-positive", 0 < small,
             proof(times(Fraction(1, 2), "delta_2-positive", *_SHARE))),
        Line("ratio-positive", 0 < phi_minus + delta_x, proof("phi-positive", "delta_x-positive")),
    )  # fmt: skip


_SHARE = ("h_4-positive", "delta_x-positive")
