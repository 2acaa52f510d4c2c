"""Rows, and lemmas for them, of which no search finds a short proof, with what closes them."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from fractions import Fraction

from verify.language.argument import (
    ByLeast,
    BySum,
    Line,
    Reason,
    ToBeFound,
    plus,
    proof,
    scaled,
    times,
)
from verify.paper.everywhere.chart import (
    HALF,
    LEAST_DELTA,
    ONE,
    PLUS_R,
    REPAIRED_SET,
    R,
    hypothesis,
    p,
)
from verify.paper.initial_data import ConstantSet, h_4
from verify.paper.parameters import REPAIRED, V_0


def row(name: str) -> str:
    """The full name of a row, or a constant, of the repaired set."""
    return f"{REPAIRED}.{name}"


def about_d_bar() -> Iterator[Line]:
    """Why the entry of d_bar with the slope is always the smaller one."""
    k = REPAIRED_SET
    size, slope, first = k.d_slope * k.eta_bar**2, row("init-Cnd4"), row("V_1-above-V_0")
    eta2 = times(row("eta_bar-positive"), row("eta_bar-positive"))
    zeta, angle = row("zeta_bar-positive"), row("Delta_theta-positive")
    share = Fraction(3, 8)
    V_0s, V_1s = hypothesis("V_0-positive"), "V_1-sign"
    lost, part = row("C_eta-below-one"), Fraction(3, 28)
    yield from (
        Line("d_bar-zeta",  size <= Fraction(3, 16) * k.zeta_bar,
            scaled(times(2, "V_1-sign", "goal"), times(eta2, slope), times(share, zeta, first),
            times(share, zeta, row("zeta-dropped-factor")), times(HALF, zeta, zeta, eta2))),
        Line("d_bar-angle", size <= k.Delta_theta / 4, scaled(times(8, V_1s, V_1s, "goal"),
            times(4, V_1s, eta2, slope), times(4, V_1s, eta2, row("init-Cnd3")),
            times(2, "V_1-root", row("eta_bar-positive"), row("tau-small")),
            times(Fraction(1, 7), V_0s, row("angle-absorbed")),
            times(Fraction(1, 7), row("d_bar-positive"), lost, V_0s, V_0s),
            times(part, angle, row("C_eta-positive"), V_0s, V_0s),
            times(part, angle, first, plus(V_0s, V_1s)), times(2 - part, angle, V_1s, V_1s))),
    )  # fmt: skip
    for number, entry in enumerate(k.bounds()["d_const"], 1):
        if number != 2:
            yield Line(f"d_bar-{number}", Fraction(3, 16) * k.zeta_bar <= entry, ToBeFound())


#: The bound of delta_x from below, and that of zeta_bar by delta_x.
LEAST, ZETA_SHARE = "delta_x-least", "zeta_bar-share"


def about_zeta_bar(k: ConstantSet) -> Iterator[Line]:
    """12 (V_1/V_0) zeta_bar is at most phi_plus h_4 delta_x."""
    left = plus("u-below-one", times("u-positive", "p-below-one"))
    size = 12 * k.V_1 * k.zeta_bar
    yield from (
        Line("zeta_bar-least", size <= p * h_4 * V_0 * LEAST_DELTA, ToBeFound()),
        Line(ZETA_SHARE, size <= p * h_4 * V_0 * k.delta_x, proof("zeta_bar-least",
            times(HALF, "p-positive", left, hypothesis("V_0-positive"), LEAST), using="h_4.chart")),
    )  # fmt: skip


def _zeta_hints(of: Callable[[str], str]) -> dict[str, BySum]:
    """The rows with zeta_bar alone on the left, from its bound by delta_x."""
    zeta, V_0s, V_1s = of("zeta_bar-positive"), hypothesis("V_0-positive"), "V_1-sign"
    above, half = times(12, of("V_1-above-V_0")), "p-below-half"
    left = times(zeta, plus(above, times(8, V_0s), times(8, V_0s, half)))
    more = times(zeta, plus(above, times(4, V_0s), times(16, V_0s, half)))
    goal = times("p-positive", V_0s, "goal")
    return {
        "init-y-term-3-zeta": scaled(times(4, goal), ZETA_SHARE, left),
        "init-y-term-5": scaled(
            times(2, goal), times(V_1s, ZETA_SHARE), times(V_1s, left), using=of("d_slope")
        ),
        "x-term-1-zeta": scaled(
            times(4, V_0s, "goal"),
            ZETA_SHARE,
            times(zeta, plus(times(8, of("V_1-above-V_0")), times(4, V_1s))),
            using="delta_2.chart",
        ),
        "y-term-2-zeta": scaled(times(8, goal), ZETA_SHARE, more),
        "y-term-4": scaled(
            times(8, "p-positive", "goal"), ZETA_SHARE, times(zeta, V_1s, plus(4, times(16, half)))
        ),
    }


def hints(k: ConstantSet = REPAIRED_SET) -> dict[str, tuple[Reason, ...]]:
    """Rows of which no search finds a short proof, each after those that it uses.

    A row with a maximum, or minimum, has a reason for each of its entries. Rows that are false have
    ``not`` before their names.
    """

    def of(name: str) -> str:
        return f"{k.group}.{name}"

    eta, V_0s = of("eta_bar-positive"), hypothesis("V_0-positive")
    found: dict[str, tuple[Reason, ...]] = {
        of("norm-s-upper"): (
            proof(
                times(4, of("eta-below-one")),
                times(eta, of("d_0-below-one"), plus(3, of("d_bar-positive"))),
                using="@1",
            ),
            proof(
                times(4, of("eta-below-one"), V_0s, V_0s),
                times(eta, of("d-below-one"), plus(times(3, V_0s), times(3, "V_1-root", eta))),
                using="@1",
            ),
        ),
        of("norm-s-lower"): (
            proof(
                times(ONE, PLUS_R, of("norm-s-upper")),
                times(4, R, R),
                times(4, "V_1-root"),
                4,
            ),
        ),
        of("norm-c-upper"): (
            proof(
                times(2, "V_1-root", of("d_0-below-one")), times(2, of("norm-s-upper")), using="@1"
            ),
            proof(
                times(2, "V_1-root", of("d-below-one"), V_0s, V_0s),
                times(2, of("norm-s-upper"), V_0s),
                using="@1",
            ),
        ),
    }
    if k.printed:
        zeta = of("zeta_bar-positive")
        found[f"not {of('zeta-time-square')}"] = (
            proof(times(8, zeta, V_0s, "@2"), times(HALF, zeta, V_0s, V_0s), using="@1"),
            proof(times(Fraction(1, 32), V_0s, V_0s, V_0s), using="@1"),
        )
        found |= {of(name): (reason,) for name, reason in _zeta_hints(of).items()}
    else:
        found["redundant.d_bar-1"] = (
            ByLeast(
                (
                    proof("d_bar-zeta", "d_bar-1"),
                    proof("d_bar-angle"),
                    proof("d_bar-zeta", "d_bar-3"),
                    proof("d_bar-zeta", "d_bar-4"),
                ),
                row("d_const"),
            ),
        )
    return found
