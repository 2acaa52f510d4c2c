"""The initialization, the recursion, and what follows from it.

The conditions Cnd1 to Cnd10 and CndT hold for n = 0. Each row of that is judged at the worst state
of the initial set: |eta_{c,0}| = eta_bar, d_0 = d_bar (or d_0 = slope * eta_{c,0}^2 where the step
divides by eta_{c,0}), zeta_0 = zeta_bar.

Then the conditions at n give the conditions at n + 1. Each row is judged at the worst state that
the conditions at n allow: -eta_{c,n} = eta_bar, zeta_n = zeta_bar, |x_n| = delta_x, |y_n| =
delta_y, |W|^2 anywhere in [V_0, V_1], d_n up to the larger of d_bar and 3 (V_1^{1/2}/V_0) eta_bar.

The conclusion stands at the end: infinitely many collisions, in finite time, with the announced
final angle.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from verify.language.statement import Obligation
from verify.language.terms import Claim, Term, as_term, maximum, minimum, sqrt
from verify.paper.initial_data import (
    D_0,
    ETA,
    ZETA,
    C_eta,
    ConstantSet,
    alpha_0,
    delta_2,
    delta_3,
    delta_4,
    delta_5,
    gap,
    h_4,
    h_5,
    phi_minus,
)
from verify.paper.parameters import THEOREM, V_0, c, delta_theta, r
from verify.paper.rows import BREAKS, HARMLESS, OTHERWISE, REMARK, SLIP

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


def initialization(k: ConstantSet) -> Iterator[Obligation]:
    """Yield the rows of the initialization, in the paper's order."""
    yield from _initial_set(k)
    yield from _initial_norms(k)
    yield from _initial_angle(k)
    yield from _y_0(k)


def _initial_set(k: ConstantSet) -> Iterator[Obligation]:
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


def _initial_norms(k: ConstantSet) -> Iterator[Obligation]:
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


def _initial_angle(k: ConstantSet) -> Iterator[Obligation]:
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


def _y_0(k: ConstantSet) -> Iterator[Obligation]:
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


# --- the recursion --------------------------------------------------------------------------------


TAU = "EQUATSS4.1_Controle_Tau_n"
NORM = "EQUATSS4.1EvoluNormeVitRl"
X_LINK = "EQUATSS4.1Lien_x_n_&_y_n_"
X_BETTER = "EQUATSS4.1Cntrlx_n+1Ameli"
COSINE = "EQUATSS4.1EvoluCosinAngle"


def rows(k: ConstantSet) -> Iterator[Obligation]:
    """Yield the rows of the recursion, in the paper's order."""
    paragraphs = (
        _distance_and_time, _norms, _eta, _zeta_first_terms, _zeta_remainders, _zeta,
        _no_outer_collision, _angle_step, _angle_sum, _x_term_1, _sums_alone, _x, _y,
    )  # fmt: skip
    for paragraph in paragraphs:
        yield from paragraph(k)


def _distance_and_time(k: ConstantSet) -> Iterator[Obligation]:
    """1 + d_n ≤ 2 and the bounds on τ_n."""
    yield from (
        # d_n ≤ |η_{s,n}|τ_n + |W_{s,n}|²τ_n²/2 ≤ (3/2) V₁^{1/2} τ_n ≤ 3 (V₁^{1/2}/V₀)(-η_{c,n}).
        # The display is about d_{n+1}. That it bounds d_n is refuted as follows: as tau_n <= (1 +
        # zeta_n/2) d_n/(-eta_{c,n}) and tau_n <= 2 (-eta_{c,n}) zeta_n/V_0, its right-hand side is
        # at most d_n times the number of the row.
        k.row("d_0-below-one", CND6, "1 + d_n ≤ 2 for n = 0", k.d_bar <= 1),
        k.row("d-below-one",   CND6, "1 + d_n ≤ 2 for n ≥ 1", k.d_later <= 1, ["distance", "time"]),
        *k.misprint("d-index", TAU, "d_n ≤ |η_{s,n}|τ_n + |W_{s,n}|²τ_n²/2 (it bounds d_{n+1}): "
            "as τ_n ≤ (1+ζ_n/2) d_n/(-η_{c,n}) it needs 1 ≤ (1+ζ̄/2)(φ⁻+δ_x+(V₁/V₀)ζ̄)",
            1 <= (1 + k.zeta_bar / 2) * (phi_minus + k.delta_x + k.V_1 / V_0 * k.zeta_bar), SLIP,
            "d-below-one", ["time", "root-fine", "zeta-from-distance"]),
        # (-η_{c,n})² ≤ -η_{c,n} ≤ 1; V₁τ_n² ≤ V₁^{1/2}τ_n ≤ 1 (`EQUATSS4.1_Controle_Tau_n`).
        k.row("eta-below-one", CND6, "η² ≤ η ≤ 1", k.eta_bar <= 1),
        k.row("tau-small", TAU, "V₁ τ_n² ≤ V₁^{1/2} τ_n ≤ 1", k.speed * k.tau_crude <= 1, ["time"]),
    )  # fmt: skip


def _norms(k: ConstantSet) -> Iterator[Obligation]:
    """The law of the norms, and Cnd5 to Cnd7 for n+1."""
    coefficient = ((1 + r) / 2) ** 2
    step = 4 * (k.speed + 2)
    third = (k.V_1 - V_0) / 3
    yield from (
        # |W_{c,n+1}|² = |W_{s,n}|² - (1+r) (…)(…) + ((1+r)²/2)(W_{c,n}·ω_{s,n+1})², as printed.
        *k.misprint("norm-law-as-printed", NORM, "the coefficient of (W_{c,n}·ω_{s,n+1})² is "
            "(1+r)²/2: it is the square of (1+r)/2 (only that it is at most 2 is used)",
            (1 + r) ** 2 / 2 <= coefficient, HARMLESS, "norm-law"),
        *k.repair("norm-law",              NORM,
            "the coefficient of (W_{c,n}·ω_{s,n+1})² is the square of (1+r)/2, (1+r)²/4",
            coefficient <= (1 + r) ** 2 / 4),
        # … ≤ 2 |W_{s,n}| |W_{c,n}·ω_{s,n+1}| + 2 |W_{c,n}·ω_{s,n+1}|².
        k.row("norm-factor-1", CND6, "1+r ≤ 2", 1 + r <= 2),
        k.row("norm-factor-2", CND6, "(1+r)²/4 ≤ (1+r)²/2 ≤ 2", (1 + r) ** 2 / 2 <= 2),
        k.row("norm-factor-3", CND6, "|W_{s,n+1}|² - |W_{c,n}|² ≤ 0: r² - 1 ≤ 0", r**2 - 1 <= 0),
        # … ≤ 2V₁^{1/2}(1+d_n)(-η_{c,n}) + 2(1+d_n)²η_{c,n}² ≤ 4(V₁^{1/2}+2)(-η_{c,n}).
        k.row("norm-c-upper", CND6,
            "2V₁^{1/2}(1+d_n)η + 2(1+d_n)²η² ≤ 4(V₁^{1/2}+2)η, divided by η = -η_{c,n}",
            2 * k.speed * (1 + k.d_any) + 2 * (1 + k.d_any) ** 2 * k.eta_bar <= step,
            ["law-norms", "norm-step"]),
        k.row("norm-s-upper", CND6, "(1+d_n)²η² ≤ 4η, divided by η = -η_{c,n}",
            (1 + k.d_any) ** 2 * k.eta_bar <= 4, ["law-norms", "norm-step"]),
        # The same bounds hold for the absolute values of the differences, which Cnd5 needs.
        k.row("norm-c-lower", CND6,
            "|W_{c,n+1}|² - |W_{s,n}|² ≥ -(1+r)V₁^{1/2}(1+d_n)η ≥ -4(V₁^{1/2}+2)η",
            (1 + r) * k.speed * (1 + k.d_any) <= step, ["law-norms", "norm-step"]),
        k.row("norm-s-lower", CND6,
            "|W_{s,n+1}|² - |W_{c,n}|² ≥ -(1-r²)(1+d_n)²η² ≥ -4(V₁^{1/2}+2)η",
            (1 - r**2) * (1 + k.d_any) ** 2 * k.eta_bar <= step, ["law-norms", "norm-step"]),
        # Σ C_η^k < 1/(1-C_η) and η̄ ≤ (1-C_η)(V₁-V₀)/(12(V₁^{1/2}+2)) give Cnd5 for n+1.
        # Cnd6 and Cnd7 are printed as upper bounds; with absolute values, which the same constants
        # bound, they give both halves.
        k.row("Cnd5-upper",                  CND5,
            "|W|² ≤ V₁ - (V₁-V₀)/3 + 4(V₁^{1/2}+2)/(1-C_η) η̄ ≤ V₁", k.norm_drift <= third,
            ["norm-step"]),
        *k.misprint("Cnd5-lower-as-printed", CND5, "V₀ ≤ |W_{s,n+1}|² at |W_{c,n}|² = V₀, "
            "-η_{c,n} = C_η η̄: Cnd6 and Cnd7 are upper bounds, and the law subtracts "
            "(1-r²)(1+d_n)²(1-ζ_n)η_{c,n}²",
            V_0 <= V_0 - (1 - r**2) * (1 - k.zeta_bar) * (C_eta * k.eta_bar) ** 2, SLIP,
            "Cnd5-lower", ["law-norms"]),
        k.row("Cnd5-lower",                  CND5,
            "V₀ ≤ V₀ + (V₁-V₀)/3 - 4(V₁^{1/2}+2)/(1-C_η) η̄ ≤ |W|², by the two-sided estimates",
            V_0 + k.norm_drift <= V_0 + third, ["norm-step"]),
    )  # fmt: skip


def _eta(k: ConstantSet) -> Iterator[Obligation]:
    """Cnd1 and Cnd2 for n+1."""
    yield from (
        # |y_n| ≤ δ₂ and |y_n| ≤ δ₃, by Cnd10.
        k.row("y-below-delta_2", CND1, "|y_n| ≤ δ₂ by Cnd10", k.delta_y <= delta_2),
        k.row("y-below-delta_3", CND2, "|y_n| ≤ δ₃ by Cnd10", k.delta_y <= delta_3),
        # -1 < -1 + δ₃ ≤ φ⁻ - α₀ + y_n ≤ -δ₂ < 0, hence Cnd1 and Cnd2 for n+1.
        k.row("eta-chain-1",     CND2, "-1 < -1 + δ₃", -1 < -1 + delta_3),
        k.row("eta-chain-2",     CND2, "-1 + δ₃ ≤ φ⁻ - α₀ + y_n",
            -1 + delta_3 <= phi_minus - alpha_0 - k.delta_y, ["law-eta-c"]),
        k.row("eta-chain-3",     CND1, "φ⁻ - α₀ + y_n ≤ -δ₂",
            phi_minus - alpha_0 + k.delta_y <= -delta_2, ["law-eta-c"]),
        k.row("eta-chain-4",     CND1, "-δ₂ < 0, so η_{c,n+1} < 0", -delta_2 < 0),
        k.row("eta-contraction", CND2, "|η_{c,n+1}| ≤ C_η |η_{c,n}|",
            gap + k.delta_y <= C_eta, ["law-eta-c"]),
    )  # fmt: skip


def _zeta_first_terms(k: ConstantSet) -> Iterator[Obligation]:
    """The root, and the second term of ζ_{n+1}."""
    zeta = minimum(k.zeta_bar, V_0 / 16)
    bound = k.V_1 / V_0 / delta_2**2
    yield from (
        # 1-√(1-ζ_n) ≤ ζ_n/2 + ζ_n²/4 as soon as ζ_n ≤ 2(√2-1).
        k.row("zeta-root", CND4, "ζ_n ≤ 2(√2-1), where 1-√(1-ζ) ≤ ζ/2 + ζ²/4",
            k.zeta_bar <= 2 * (sqrt(2) - 1), ["root-fine"]),
        # 'Bounding τ/(-η_{c,n}) by 4ζ_n²/|W_{c,n}|⁴', which is meant for the square; the factor
        # 1+d_n.
        # tau/(-eta_c) >= zeta/(2 |W_c|^2); the state has |W_c|^2 = V_0 and a small zeta.
        *k.misprint("zeta-time-square", CND4,
            "bounding τ/(-η_{c,n}) by 4ζ_n²/|W_{c,n}|⁴, at |W_{c,n}|² = V₀, ζ_n = min(ζ̄, V₀/16)",
            zeta / (2 * V_0) <= 4 * zeta**2 / V_0**2, SLIP, "zeta-time-square", ["time"]),
        *k.repair("zeta-time-square",   CND4, "(τ_n/(-η_{c,n}))² ≤ 4ζ_n²/|W_{c,n}|⁴",
            (k.tau_crude * k.zeta_bar) ** 2 <= 4 * k.zeta_bar**2 / V_0**2 * k.eta_bar**2, ["time"]),
        k.row("zeta-dropped-factor",    CND4,
            "the dropped factor 1+d_n: d_n(1+ζ_n/2) ≤ ζ_n/2, as d_n ≤ (4/3) ζ_n η_{c,n}²/V₀",
            Fraction(4, 3) * (2 + k.zeta_bar) * k.eta_bar**2 <= V_0,
            ["zeta-step", "zeta-from-distance"]),
        # (|W_{c,n+1}|²/|W_{c,n}|²) |x_n|/(φ⁻-α₀+y_n)² ≤ (V₁/V₀) |x_n|/δ₂² ≤ h₅/12.
        k.row("zeta-denominator",        CND4, "|φ⁻ - α₀ + y_n| ≥ δ₂, since |y_n| is small enough",
            delta_2 + k.delta_y <= gap),
        k.row("zeta-x_0",                CND4, "second term at n = 0: (V₁/V₀) |x₀|/δ₂² ≤ h₅/12",
            bound * k.x_0 <= h_5 / 12, ["zeta-step", "time"]),
        k.row("zeta-x-bound",            CND9, "Cnd9 implies |x_n| ≤ (V₀/V₁) δ₂² h₅/12",
            k.delta_x <= V_0 / k.V_1 * (delta_2**2 * h_5 / 12), if_false=BREAKS),
        k.row("zeta-term-2",             CND4, "second term: (V₁/V₀) |x_n|/δ₂² ≤ h₅/12",
            bound * k.delta_x <= h_5 / 12, ["zeta-step"], if_false=BREAKS),
        k.row("zeta-term-2-denominator", CND4,
            "second term: (V₁/V₀) |x_n|/(φ⁻-α₀+y_n)² ≤ (V₁/V₀) |x_n|/δ₂²",
            k.V_1 / V_0 * k.delta_x / _ratio_square(k) <= bound * k.delta_x, ["zeta-step"]),
    )  # fmt: skip


def _ratio_square(k: ConstantSet) -> Term:
    """(η_{c,n+1}/η_{c,n})² = (φ⁻-α₀+y_n)², at the least that it can be."""
    return (gap - k.delta_y) ** 2


def _third(k: ConstantSet) -> Term:
    return k.V_1 / V_0 * (alpha_0 / 2) / delta_2**2


def _fourth(k: ConstantSet) -> Term:
    return (k.V_1 / V_0) ** 2 * 4 / delta_2**2


def _last_two(k: ConstantSet) -> Term:
    """V₁/(2V₀δ₂²) (α₀ + 8V₁/V₀)."""
    ratio = k.V_1 / V_0
    return ratio / (2 * delta_2**2) * (alpha_0 + 8 * ratio)


def _zeta_remainders(k: ConstantSet) -> Iterator[Obligation]:
    """The three remainder terms of ζ_{n+1}."""
    ratio = k.V_1 / V_0
    square = _ratio_square(k)
    yield from (
        # … ≤ (V₁/V₀) (α₀/2)/δ₂² and … ≤ (V₁²/V₀²) 4/δ₂², as |x_n| ≤ δ₁.
        k.row("zeta-ratio",  CND4, "η_{s,n}/(-η_{c,n}) ≤ φ⁻ + |x_n| ≤ α₀/2, as |x_n| ≤ δ₁",
            phi_minus + k.delta_x <= alpha_0 / 2),
        k.row("zeta-term-3", CND4, "third term: at most (V₁/V₀)(α₀/2)/δ₂²",
            ratio * (phi_minus + k.delta_x) / square <= _third(k), ["zeta-step"]),
        k.row("zeta-term-4", CND4, "fourth term: at most 4V₁²/(V₀²δ₂²)",
            ratio**2 * 4 / square <= _fourth(k), ["zeta-step"]),
        # V₁/(2V₀δ₂²)(α₀ + 8V₁/V₀) ζ_n ≤ h₅/6, and the three remainder terms ≤ h₅/12 + h₅/6 = h₅/4.
        k.row("zeta-terms-3-4",  CND4,
            "third and fourth term: the sum of their bounds is V₁/(2V₀δ₂²)(α₀ + 8V₁/V₀)",
            _third(k) + _fourth(k) <= _last_two(k), ["zeta-step"]),
        k.row("zeta-small",      CND4, "V₁/(2V₀δ₂²)(α₀ + 8V₁/V₀) ζ_n ≤ h₅/6, implied by Cnd4",
            _last_two(k) * k.zeta_bar <= h_5 / 6, ["zeta-step"]),
        k.row("zeta-remainder",  CND4, "h₅/12 + h₅/6 = h₅/4", h_5 / 12 + h_5 / 6 <= h_5 / 4),
        k.row("zeta-remainders", CND4,
            "the three remainder terms together are at most h₅/4, at |x_n| = δ_x",
            k.V_1 / V_0 / delta_2**2 * k.delta_x + _last_two(k) * k.zeta_bar <= h_5 / 4,
            ["zeta-step"], if_false=BREAKS),
    )  # fmt: skip


def _zeta(k: ConstantSet) -> Iterator[Obligation]:
    """The main term of ζ_{n+1}, and Cnd3 and Cnd4 for n+1."""
    ratio = k.V_1 / V_0
    square = _ratio_square(k)
    total = (
        ratio * (phi_minus + k.delta_x) / square
        + (ratio * (alpha_0 / 2) / square + ratio**2 * 4 / square) * k.zeta_bar
    )
    yield from (
        # (|W_{c,n+1}|²/|W_{c,n}|²) φ⁻/(φ⁻-α₀+y_n)² ≤ (V₁/V₀)(1-h₅) ≤ 1-h₅/2.
        k.row("zeta-y-bound", CND10, "|y_n| ≤ δ₅ by Cnd10", k.delta_y <= delta_5),
        k.row("zeta-main-y",  CND4, "main term: φ⁻/(φ⁻-α₀+y_n)² ≤ 1-h₅",
            phi_minus / _ratio_square(k) <= 1 - h_5, ["zeta-step"]),
        k.row("zeta-main",    CND4, "main term: (V₁/V₀)(1-h₅) ≤ 1-h₅/2",
            k.V_1 / V_0 * (1 - h_5) <= 1 - h_5 / 2, ["zeta-step"]),
        # ζ_{n+1} ≤ (1-h₅/2) ζ_n + (h₅/4) ζ_n = (1-h₅/4) ζ_n, hence Cnd3 and Cnd4 for n+1.
        k.row("zeta-sum", CND4, "(1-h₅/2) + h₅/4 = 1-h₅/4", (1 - h_5 / 2) + h_5 / 4 <= 1 - h_5 / 4),
        k.row("zeta-factor-below-one", CND4, "1-h₅/4 < 1", 1 - h_5 / 4 < 1),
        k.row("zeta-total",            CND4,
            "ζ_{n+1} ≤ (1-h₅/4) ζ_n: the four terms together, at |x_n| = δ_x and |y_n| = δ_y",
            total <= 1 - h_5 / 4, ["zeta-step"], if_false=BREAKS),
        k.row("Cnd3",                  CND3, "ζ_{n+1} ≤ (1-h₅/4) ζ̄ < 1",
            (1 - h_5 / 4) * k.zeta_bar < 1, ["collision-map"]),
    )  # fmt: skip


def _no_outer_collision(k: ConstantSet) -> Iterator[Obligation]:
    """CndT for n+1."""
    total = 3 * k.speed / V_0 * k.eta_bar + 4 * k.speed / V_0 * k.eta_bar
    half = (sqrt(2) - 1) / 2
    yield from (
        # The angle is obtuse, cos θ_{n+1} < 0, hence |ω_{c,n+1} - ω_{s,n+1}| ≥ √2.
        k.row("obtuse", CNDT, "Cnd8 and Cnd2 imply cos θ_{n+1} < 0", k.drift < c, ["angle-step"]),
        k.row("obtuse-distance", CNDT, "|ω_{c,n+1} - ω_{s,n+1}| ≥ √2",
            sqrt(2) <= sqrt(2 + 2 * (c - k.drift)), ["outer-distance", "angle-step"]),
        # The distance 1-2 ≥ √2 - 3(V₁^{1/2}/V₀)(-η_{c,n}) - 4(V₁^{1/2}/V₀)(-η_{c,n+1}) > 1.
        k.row("CndT-half",             CNDT,
            "3(V₁^{1/2}/V₀)(-η_{c,n}) + 4(V₁^{1/2}/V₀)(-η_{c,n+1}) ≤ (√2-1)/2", total <= half,
            ["outer-distance", "distance", "time"]),
        *k.misprint("CndT-as-printed", CNDT,
            "the distance 1-2 is larger than (√2-1)/2, so there is no collision: both are true, "
            "but for centres that needs a distance above 1, that is 1 ≤ (√2-1)/2",
            as_term(1) <= half, OTHERWISE, "CndT"),
        k.row("CndT",                  CNDT, "√2 - d_{n+1} - 2V₁^{1/2} τ_{n+1} > 1",
            1 < sqrt(2) - total, ["outer-distance", "distance", "time", "collision-map"]),
    )  # fmt: skip


def _angle_step(k: ConstantSet) -> Iterator[Obligation]:
    """|cos θ_{n+2} - cos θ_{n+1}| ≤ d_{n+1} + d_{n+2} + 3V₁^{1/2}τ_{n+1} + V₁τ_{n+1}²."""
    yield from (
        *k.misprint("angle-sign", COSINE, "|cos θ_{n+2} - cos θ_{n+1}| with - |W_s·W_c| "
            "τ²/(1+d_{n+2}) as its last term: in dimension ≥ 3, at ω_s·W_c = ω_c·W_s = 0 > "
            "W_s·W_c, it enters with the wrong sign", _angle_display(k), SLIP, "angle-step-time",
            ["law-angle"]),
        k.row("angle-step-time",  CND8,
            "V₁^{1/2} τ + 2V₁^{1/2} τ + V₁ τ² ≤ 8 (V₁^{1/2}/V₀)(-η_{c,n+1})",
            3 * k.speed * k.tau_crude + k.V_1 * k.tau_crude**2 <= 8 * k.speed / V_0 * k.eta_bar,
            ["law-angle", "angle-step"]),
    )  # fmt: skip


def _angle_display(k: ConstantSet) -> Claim:
    """The display after `EQUATSS4.1EvoluCosinAngle` is used for n + 1, at one state."""
    state = angle_state(k)
    eta, distance, norm_c = state["eta"], state["distance"], state["norm_c"]
    time = contact_time(eta, distance, norm_c, contact_zeta(eta, distance, norm_c))
    following = next_distance(state["spectator"], state["norm_s"], time)
    return angle_claim(distance, time, following, state["product"], state["cosine"])


def angle_state(k: ConstantSet) -> dict[str, Term]:
    """A state that the conditions allow.

    With η = -η_{c,n+1}, C = -cos θ_{n+1} and V = (V₀+V₁)/2 the state is η = C_η η̄,
    η_{s,n+1} = φ⁻η, d_{n+1} = k_d η², ω_s·W_c = ω_c·W_s = 0 and

        |W_c|² = V + η²/(1-C²), |W_s|² = V + (φ⁻η)²/(1-C²), -W_s·W_c = V + φ⁻η²C/(1-C²):

    the parts of W_c and W_s that are orthogonal to ω_s and ω_c are opposite vectors of length √V.
    C is as far from -cos θ₀ as Cnd8 lets it be for n = 0.
    """
    eta, cosine = C_eta * k.eta_bar, c - 11 * k.speed / V_0 * k.eta_bar
    spectator, distance = phi_minus * eta, k.d_slope * eta**2
    sine_square = 1 - cosine**2
    tangent = (V_0 + k.V_1) / 2
    return {
        "eta": eta,
        "spectator": spectator,
        "distance": distance,
        "norm_c": tangent + eta**2 / sine_square,
        "norm_s": tangent + spectator**2 / sine_square,
        "product": tangent + spectator * eta * cosine / sine_square,
        "cosine": cosine,
    }


def contact_zeta(eta: Term, distance: Term, norm_c: Term) -> Term:
    """The ζ of a state."""
    return distance * (2 + distance) / (1 + distance) ** 2 * norm_c / eta**2


def contact_time(eta: Term, distance: Term, norm_c: Term, zeta: Term) -> Term:
    """The time to the next contact."""
    return (1 + distance) / norm_c * eta * (1 - sqrt(1 - zeta))


def next_distance(spectator: Term, norm_s: Term, time: Term) -> Term:
    """1 + d_{n+2}, the distance of the centres of the pair that is apart at the next contact."""
    return sqrt(1 + 2 * spectator * time + norm_s * time**2)


def angle_claim(distance: Term, time: Term, following: Term, product: Term, cosine: Term) -> Claim:
    """The display at a state with ω_s·W_c = ω_c·W_s = 0."""
    last = product * time**2 / following
    change = (1 + distance) / following * cosine + last - cosine
    return _absolute(change) <= _absolute((1 + distance) / following - 1) * cosine - last


def _absolute(term: Term) -> Term:
    return maximum(term, -term)


def _angle_sum(k: ConstantSet) -> Iterator[Obligation]:
    """… ≤ 3(V₁^{1/2}/V₀)(-η_{c,n}) + (3+8)(V₁^{1/2}/V₀)(-η_{c,n+1}), hence Cnd8 for n+1."""
    yield from (
        k.row("angle-step",     CND8,
            "3 + (3 + 8) C_η ≤ 3 + 11 C_η: one step of Cnd8, divided by (V₁^{1/2}/V₀)(-η_{c,n})",
            3 + 3 * C_eta + 8 * C_eta <= C_eta * ((3 + 11 * C_eta) / C_eta), ["angle-step"]),
        k.row("angle-tail",     CND8, "11 + (3 + 11C_η)/C_η Σ_{k≥1} C_η^k = 14/(1-C_η)",
            11 + (3 + 11 * C_eta) / C_eta * (C_eta / (1 - C_eta)) <= 14 / (1 - C_eta),
            ["angle-step"]),
        k.row("angle-absorbed", CND8,
            "|(-cos θ_n) - (-cos θ₀)| ≤ |Δθ| for every n: the bound of Cnd8, summed",
            k.drift <= k.Delta_theta, ["angle-step"], if_false=REMARK),
    )  # fmt: skip


def _x_term_1(k: ConstantSet) -> Iterator[Obligation]:
    """|r[(1+d_n)√(1-ζ_n) - 1]/(η_{c,n+1}/η_{c,n})| ≤ max(d_n, 2ζ_n)/δ₂ ≤ h₄δ_x/2."""
    says = "first term, at most max(d_n, 2ζ_n)/δ₂: {}, divided by δ₂, is ≤ h₄δ_x/2"
    uses = ["x-step", "root-product"]
    half = h_4 * k.delta_x / 2
    d, zeta = k.d_later, 2 * k.zeta_bar
    yield from (
        k.row("x-term-1-d_0",       CND9, says.format("d₀"), k.d_bar / delta_2 <= half, uses),
        k.row("x-term-1-d",         CND9, says.format("d_n, n ≥ 1"),
            d / delta_2 <= half, uses, if_false=HARMLESS),
        *k.aside("x-term-1-factor", CND9,
            says.format("r d_n, n ≥ 1, with the factor that the display begins with"),
            r * d / delta_2 <= half, uses),
        k.row("x-term-1-zeta",      CND9, says.format("2ζ_n"), zeta / delta_2 <= half, uses),
    )  # fmt: skip


def _sums_alone(k: ConstantSet) -> Iterator[Obligation]:
    """The entries with a sum, each against the steps that it is there for.

    The rows show that the sum is not what the step needs. Whether the step holds all the same,
    because another entry of the min is smaller, is the row without `alone`.
    """

    def alone(
        name: str, label: str, says: str, claim: Claim, corrected_by: str
    ) -> Iterator[Obligation]:
        return k.misprint(name, label, f"{says}, alone", claim, REMARK, corrected_by)

    bounds, share = k.bounds(), h_4 * k.delta_x
    d_n, zeta = 3 * k.speed / V_0 * bounds["eta_bar"][4], bounds["zeta_bar"][2]
    d_0 = bounds["d_const"][3]
    yield from (
        # (V₀/V₁^{1/2}) (2/(15α₀) + h₄δ₂/6 + h₄/(12α₀) + h₄/24) δ_x
        *alone("alone-eta-y-1", ETA, "entry 5 of η̄: d_{n+2} α₀/2 ≤ h₄δ_x/8",
            d_n * alpha_0 / 2 <= share / 8, "y-term-1"),
        *alone("alone-eta-y-2", ETA, "entry 5 of η̄: d_{n+1} ≤ h₄δ_x/8",
            d_n <= share / 8, "y-term-2-d"),
        *alone("alone-eta-x-1", ETA, "entry 5 of η̄: d_n/δ₂ ≤ h₄δ_x/2",
            d_n / delta_2 <= share / 2, "x-term-1-d"),
        # (1 + 4δ₂ + V₀/V₁) h₄δ_x/16
        *alone("alone-zeta-y-2", ZETA, "entry 3 of ζ̄: 2ζ_{n+1} ≤ h₄δ_x/8",
            2 * zeta <= share / 8, "y-term-2-zeta"),
        *alone("alone-zeta-x-1", ZETA, "entry 3 of ζ̄: 2ζ_n/δ₂ ≤ h₄δ_x/2",
            2 * zeta / delta_2 <= share / 2, "x-term-1-zeta"),
        *alone("alone-zeta-y-4", ZETA, "entry 3 of ζ̄: 2(V₁/V₀)ζ̄ ≤ h₄δ_x/8",
            2 * k.V_1 / V_0 * zeta <= share / 8, "y-term-4"),
        # (1 + 2δ₂) h₄δ_x/4
        *alone("alone-d-y-3", D_0, "entry 4 of d̄: d₀ ≤ h₄δ_x/4",
            d_0 <= share / 4, "init-y-term-3-d"),
        *alone("alone-d-x-1", D_0, "entry 4 of d̄: d₀/δ₂ ≤ h₄δ_x/2",
            d_0 / delta_2 <= share / 2, "x-term-1-d_0"),
    )  # fmt: skip


def _x(k: ConstantSet) -> Iterator[Obligation]:
    """The second term of x_{n+1}, and Cnd9 for n+1."""
    better = (1 - h_4 / 2) * k.delta_x
    yield from (
        # |r/(α₀-φ⁻-y_n) - φ⁻| ≤ (1-h₄)|y_n| ≤ (1-h₄)δ_x, since |y_n| ≤ δ₄.
        k.row("x-y-bound",     CND10, "|y_n| ≤ δ₄ by Cnd10", k.delta_y <= delta_4),
        k.row("x-contraction", CND9, "|r/(α₀-φ⁻-y_n) - φ⁻| ≤ (1-h₄)|y_n|",
            r / (gap - k.delta_y) ** 2 <= 1 - h_4, ["x-step"]),
        k.row("x-term-2",      CND9, "(1-h₄)|y_n| ≤ (1-h₄)δ_x",
            (1 - h_4) * k.delta_y <= (1 - h_4) * k.delta_x),
        # |x_{n+1}| ≤ h₄δ_x/2 + (1-h₄)δ_x = (1-h₄/2)δ_x (`EQUATSS4.1Cntrlx_n+1Ameli`).
        k.row("x-improved",   X_BETTER, "|x_{n+1}| ≤ h₄δ_x/2 + (1-h₄)δ_x = (1-h₄/2)δ_x",
            h_4 * k.delta_x / 2 + (1 - h_4) * k.delta_x <= better, ["law-eta-s", "x-step"]),
        k.row("x-propagates", CND9, "(1-h₄/2)δ_x < δ_x", better < k.delta_x),
    )  # fmt: skip


def _y(k: ConstantSet) -> Iterator[Obligation]:
    """The four terms of y_{n+1}, and Cnd10 for n+1."""
    eighth = h_4 * k.delta_x / 8
    yield from (
        # d_{n+2} η_{s,n+1}/(-η_{c,n+1}) + max(d_{n+1}, 2ζ_{n+1}).
        k.row("y-ratio",  CND10, "η_{s,n+1}/(-η_{c,n+1}) ≤ φ⁻ + |x_{n+1}| ≤ α₀/2",
            phi_minus + k.delta_x <= alpha_0 / 2),
        k.row("y-term-1", CND10, "d_{n+2} α₀/2 ≤ h₄δ_x/8",
            k.d_later * (alpha_0 / 2) <= eighth, ["y-step", "distance"]),
        k.row("y-term-2-d", CND10,
            "second term, at most max(d_{n+1}, 2ζ_{n+1}): d_{n+1} ≤ h₄δ_x/8",
            k.d_later <= eighth, ["y-step", "root-product"]),
        k.row("y-term-2-zeta", CND10,
            "second term, at most max(d_{n+1}, 2ζ_{n+1}): 2ζ_{n+1} ≤ h₄δ_x/8",
            2 * k.zeta_bar <= eighth, ["y-step", "root-product"]),
        # |(-cos θ_{n+2}) - (-cos θ₀)| + V₁ τ_{n+1}/(-η_{c,n+1}).
        k.row("y-term-3",           CND10, "|(-cos θ_{n+2}) - (-cos θ₀)| ≤ h₄δ_x/8",
            k.drift <= eighth, ["y-step", "angle-step"], if_false=HARMLESS),
        *k.aside("y-term-3-factor", X_LINK,
            "((1+r)/2) |(-cos θ_{n+2}) - (-cos θ₀)| ≤ h₄δ_x/8, with the factor that y_n has",
            (1 + r) / 2 * k.drift <= eighth, ["y-step", "angle-step"]),
        k.row("y-term-4",           CND10, "V₁ τ_{n+1}/(-η_{c,n+1}) ≤ 2(V₁/V₀)ζ̄ ≤ h₄δ_x/8",
            2 * k.V_1 / V_0 * k.zeta_bar <= eighth, ["y-step", "time"]),
        # |y_{n+1}| ≤ 4 · h₄δ_x/8 + (1-h₄/2)δ_x = δ_x, hence Cnd10 for n+1.
        k.row("y-sum", CND10, "|y_{n+1}| ≤ 4 · h₄δ_x/8 + (1-h₄/2)δ_x = δ_x",
            eighth + eighth + eighth + eighth + (1 - h_4 / 2) * k.delta_x <= k.delta_y,
            ["law-eta-c", "y-step"]),
    )  # fmt: skip


# --- conclusion -----------------------------------------------------------------------------------


def conclusion(k: ConstantSet) -> Iterator[Obligation]:
    """Yield what the theorem claims beyond the recursion; the paper leaves these steps out."""
    yield from (
        k.row("eta_s-stays-positive",    THEOREM,
            "η_{s,n+1} ≥ r√(1-ζ̄)(-η_{c,n}) > 0: the pair that just met separates",
            0 < r * sqrt(1 - k.zeta_bar), ["law-eta-s", "collision-map"]),
        k.row("distance-stays-positive", THEOREM,
            "the set leaves room for d₀ > 0, which the model asks for, and then d_{n+1} > 0",
            0 < k.d_bar, ["distance", "law-eta-s", "time", "induction"]),
        k.row("final-angle",             THEOREM,
            "|(-cos θ̄) - (-cos θ₀)| ≤ δ_θ for the final angle", k.drift <= delta_theta,
            ["angle-step", "induction"], if_false=BREAKS),
        k.row("collapse-time",           THEOREM,
            "the collapse time Σ τ_n ≤ 2η̄ζ̄/(V₀(1-C_η)) ≤ T* is finite",
            2 / (V_0 * (1 - C_eta)) * k.eta_bar * k.zeta_bar <= k.T_star,
            ["time", "induction", "collision-map", "collision-map-roles"]),
    )  # fmt: skip
