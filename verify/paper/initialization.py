"""The initialization: the conditions Cnd1 to Cnd10 and CndT hold for n = 0.

Each row is judged at the worst state of the initial set: |eta_{c,0}| = eta_bar, d_0 = d_bar (or
d_0 = slope * eta_{c,0}^2 where the step divides by eta_{c,0}), zeta_0 = zeta_bar.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from verify.language.statement import Obligation
from verify.language.terms import as_term, sqrt
from verify.paper.initial_data import ConstantSet
from verify.paper.parameters import V_0, c
from verify.paper.preliminaries import alpha_0, h_4, phi_minus
from verify.paper.rows import BREAKS, OTHERWISE

CND1 = "EQUATSS4.1Recurrence_Cnd1"
CND2 = "EQUATSS4.1Recurrence_Cnd2"
CND3 = "EQUATSS4.1Recurrence_Cnd3"
CND4 = "EQUATSS4.1Recurrence_Cnd4"
CND5 = "EQUATSS4.1Recurrence_Cnd5"
CND6 = "EQUATSS4.1Recurrence_Cnd6"
CND8 = "EQUATSS4.1Recurrence_Cnd8"
CND9 = "EQUATSS4.1Recurrence_Cnd9"
CNDT = "EQUATSS4.1Recurrence_CndT"
CND10 = "EQUATSS4.1Recurrence_Cnd10"
DATA = "EQUATSS4.1DescrDoIniColla"
ZETA_0 = "EQUATSS4.1BorneParam_ZK0_"
D_1 = "EQUATSS4.1BorneDista_d_1_"


def rows(k: ConstantSet) -> Iterator[Obligation]:
    """Yield the rows of the initialization, in the paper's order."""
    yield from _set(k)
    yield from _zeta_and_norms(k)
    yield from _outer_pair(k)
    yield from _y(k)


def _set(k: ConstantSet) -> Iterator[Obligation]:
    """The set of initial data, and Cnd1 and Cnd2."""
    lower = V_0 + (k.V_1 - V_0) / 3
    upper = k.V_1 - (k.V_1 - V_0) / 3
    yield from (
        # The set of `EQUATSS4.1DescrDoIniColla` is not empty.
        k.row("set-norms",          DATA, "the interval of |W|² is not empty", lower < upper),
        k.row("set-eta_c", DATA, "|η_{c,0}| = η̄ leaves room for |W_{c,0}|²", k.eta_bar**2 < lower),
        k.row("set-eta_s",          DATA, "η_{s,0} ≤ (α₀/2) η̄ leaves room for |W_{s,0}|²",
            (alpha_0 / 2 * k.eta_bar) ** 2 < lower),
        k.row("set-eta_s-positive", DATA,
            "η_{s,0} = φ⁻ (-η_{c,0}) > 0 is in the set: a post-collisional pair",
            0 < phi_minus * k.eta_bar),
        # The theorem claims a non-trivial interior; the printed set has ω_{c,0}·ω_{s,0} = cos θ₀.
        k.row("set-interior", DATA,
            "a non-trivial interior: the width that the set leaves for -cos of the angle",
            0 < as_term(k.initial_slack), ["interior"], if_false=BREAKS),
        *k.repair("set-x_0",  DATA, "… and for η_{s,0}/(-η_{c,0}), on both sides of φ⁻", 0 < k.x_0),
        # Cnd1 and Cnd2.
        k.row("init-Cnd1", CND1, "η_{c,0} < 0 by assumption", -k.eta_bar < 0),
        k.row("init-Cnd2", CND2, "|η_{c,0}| ≤ η̄ by construction", k.eta_bar <= k.eta_bar),
    )  # fmt: skip


def _zeta_and_norms(k: ConstantSet) -> Iterator[Obligation]:
    """Cnd3 to Cnd7."""
    third = (k.V_1 - V_0) / 3
    empty_sum = 4 * (k.speed + 2) * 0
    yield from (
        # ζ₀ = d₀(2+d₀)/(1+d₀)² |W_{c,0}|²/η_{c,0}² ≤ 2d₀ |W_{c,0}|²/η_{c,0}².
        # The paper bounds x(2+x)/(1+x)² by 2, which gives 2 |W|²/η²; the display needs 2x, which is
        # also true.
        *k.misprint("init-zeta-bound-2", ZETA_0,
            "ζ₀ ≤ 2d₀|W_{c,0}|²/η_{c,0}² is derived from x(2+x)/(1+x)² ≤ 2; both are true, but "
            "that needs the bound 2x: the bound 2 would do if 2 ≤ 2d₀ at d₀ = d̄",
            2 <= 2 * k.d_bar, OTHERWISE, "init-Cnd4"),
        k.row("init-Cnd3", CND3, "ζ₀ < 1", k.zeta_bar < 1, ["zeta-from-distance", "collision-map"]),
        k.row("init-Cnd4",               CND4,
            "ζ₀ ≤ 2 d₀ |W_{c,0}|²/η_{c,0}² ≤ ζ̄, with d₀ = k_d η_{c,0}²",
            2 * k.V_1 * k.d_slope <= k.zeta_bar, ["zeta-from-distance"]),
        k.row("init-Cnd4-room",          ZETA_0, "|W_{c,0}|² ≤ V₁ - (V₁-V₀)/3 ≤ V₁",
            k.V_1 - (k.V_1 - V_0) / 3 <= k.V_1),
        # V₀ + (V₁-V₀)/3 ≤ |W_{c,0}|², |W_{s,0}|² ≤ V₁ - (V₁-V₀)/3 gives Cnd5.
        k.row("init-Cnd5-lower", CND5, "V₀ ≤ |W|² at n = 0", V_0 <= V_0 + third),
        k.row("init-Cnd5-upper", CND5, "|W|² ≤ V₁ at n = 0", k.V_1 - third <= k.V_1),
        k.row("init-Cnd6",       CND6, "trivial since n = 0 (it is Cnd7, n even)", 0 <= empty_sum),
    )  # fmt: skip


def _outer_pair(k: ConstantSet) -> Iterator[Obligation]:
    """CndT and Cnd8."""
    tau_0 = k.tau_crude * k.zeta_bar
    obtuse = sqrt(2 + 2 * (c - k.initial_slack))
    yield from (
        # |(1+d₀)ω_{c,0} - ω_{s,0} + τ(W_{c,0}-W_{s,0})| ≥ √2 - d₀ - 2V₁^{1/2}τ₀ > 1.
        k.row("init-d_0-below-one", CNDT, "1 + d₀ ≤ 2, used in the bound on τ₀", k.d_bar <= 1),
        k.row("init-obtuse", CNDT, "|ω_{1,0} - ω_{2,0}| ≥ √2 since cos θ < 0", sqrt(2) <= obtuse),
        k.row("init-CndT",          CNDT, "√2 - d₀ - 2V₁^{1/2} τ₀ > 1",
            1 < sqrt(2) - k.d_bar - 2 * k.speed * tau_0,
            ["time", "root-crude", "outer-distance", "collision-map"]),
        # d₁ ≤ (3/2) V₁^{1/2} τ₀ (`EQUATSS4.1BorneDista_d_1_`), and with it Cnd8 for n = 0.
        k.row("init-tau-small", D_1, "V₁ τ₀² ≤ V₁^{1/2} τ₀ ≤ 1",
            k.speed * k.tau_crude <= 1, ["time"]),
        k.row("init-d_1",       D_1, "d₁ ≤ (3/2) V₁^{1/2} τ₀ ≤ 3 (V₁^{1/2}/V₀)(-η_{c,0})",
            as_term(Fraction(3, 2)) * k.speed * k.tau_crude <= k.d_later, ["time", "distance"]),
        k.row("init-Cnd8",      CND8, "d₀ + d₁ + 4V₁^{1/2} τ₀ ≤ d₀ + 11 (V₁^{1/2}/V₀)(-η_{c,0})",
            k.d_bar + k.d_later + 4 * k.speed * k.tau_crude <= k.d_bar + 11 * k.speed / V_0
            * k.eta_bar, ["law-angle", "angle-step"]),
    )  # fmt: skip


def _y(k: ConstantSet) -> Iterator[Obligation]:
    """Cnd9, and the five terms of y₀ for Cnd10."""
    quarter = h_4 * k.delta_x / 4
    yield from (
        # |η_{s,0}/(-η_{c,0}) - φ⁻| ≤ |x₀|, so that η_{s,0}/(-η_{c,0}) ≤ α₀/2.
        k.row("init-Cnd9",  CND9, "|x₀| ≤ δ_x by assumption", k.x_0 <= k.delta_x),
        k.row("init-ratio", CND10, "|η_{s,0}/η_{c,0}| ≤ φ⁻ + |x₀| ≤ α₀/2",
            phi_minus + k.x_0 <= alpha_0 / 2),
        # [1/(1+d₁) - 1] η_{s,0}/η_{c,0} + [φ⁻ - η_{s,0}/(-η_{c,0})].
        k.row("init-y-term-1", CND10, "first term of y₀: d₁ α₀/2 ≤ h₄δ_x/4",
            k.d_later * (alpha_0 / 2) <= h_4 * k.delta_x / 4, ["y-step", "distance"]),
        k.row("init-y-term-2", CND10, "second term of y₀: |x₀| ≤ (1-h₄)δ_x",
            k.x_0 <= (1 - h_4) * k.delta_x),
        # [(1+d₀)√(1-ζ₀) - 1] ((1+r)/2)(-ω_{s,1}·ω_{c,1}), at most max(d₀, 2ζ₀).
        k.row("init-y-term-3-d", CND10, "third term of y₀, at most max(d₀, 2ζ₀): d₀ ≤ h₄δ_x/4",
            k.d_bar <= quarter, ["y-step", "root-product"]),
        k.row("init-y-term-3-zeta", CND10, "third term of y₀, at most max(d₀, 2ζ₀): 2ζ₀ ≤ h₄δ_x/4",
            2 * k.zeta_bar <= quarter, ["y-step", "root-product"]),
        # ((1+r)/2)(-ω_{s,1}·ω_{c,1}) - α₀, then τ₀ |W_{s,0}|²/((1+d₁) η_{c,0}); and the sum of all.
        k.row("init-y-term-4", CND10, "fourth term of y₀: the variation of the angle ≤ h₄δ_x/4",
            k.initial_slack + k.d_bar + 11 * k.speed / V_0 * k.eta_bar <= quarter,
            ["y-step", "angle-step"]),
        k.row("init-y-term-5", CND10,
            "fifth term of y₀: V₁ τ₀/(-η_{c,0}) ≤ 4V₁ d₀/η_{c,0}² = 4V₁ k_d ≤ h₄δ_x/4",
            4 * k.V_1 * k.d_slope <= quarter, ["y-step", "time", "zeta-from-distance"]),
        k.row("init-Cnd10",    CND10, "|y₀| ≤ |x₀| + 4 · h₄δ_x/4 ≤ δ_y",
            k.x_0 + 4 * quarter <= k.delta_y, ["law-eta-c", "y-step"]),
    )  # fmt: skip
