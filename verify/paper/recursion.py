"""The recursion: the conditions at n give the conditions at n + 1.

Each row is judged at the worst state that the conditions at n allow: -eta_{c,n} = eta_bar,
zeta_n = zeta_bar, |x_n| = delta_x, |y_n| = delta_y, |W|^2 anywhere in [V_0, V_1], d_n up to the
larger of d_bar and 3 (V_1^{1/2}/V_0) eta_bar.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from verify.language.statement import Obligation
from verify.language.terms import as_term, minimum, sqrt
from verify.paper.initial_data import ETA, ConstantSet
from verify.paper.parameters import V_0, c, r
from verify.paper.preliminaries import (
    C_eta,
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

CND = "EQUATSS4.1Recurrence_Cnd"
TAU = "EQUATSS4.1_Controle_Tau_n"
NORM = "EQUATSS4.1EvoluNormeVitRl"
X_LINK = "EQUATSS4.1Lien_x_n_&_y_n_"
X_BETTER = "EQUATSS4.1Cntrlx_n+1Ameli"
COSINE = "EQUATSS4.1EvoluCosinAngle"


def rows(k: ConstantSet) -> Iterator[Obligation]:
    """Yield the rows of the recursion, in the paper's order."""
    yield from _norms(k)
    yield from _normal_component(k)
    yield from _zeta(k)
    yield from _no_outer_collision(k)
    yield from _angle(k)
    yield from _x(k)
    yield from _y(k)


def _norms(k: ConstantSet) -> Iterator[Obligation]:
    cnd5, cnd6 = f"{CND}5", f"{CND}6"
    step = 4 * (k.speed + 2)
    yield k.row("d_0-below-one", cnd6, "1 + d_n ≤ 2 for n = 0", k.d_bar <= 1)
    yield k.row("d-below-one", cnd6, "1 + d_n ≤ 2 for n ≥ 1", k.d_later <= 1, ["distance", "time"])
    if k.printed:
        # tau_n <= (1 + zeta_n/2) d_n/(-eta_{c,n}) and tau_n <= 2 (-eta_{c,n}) zeta_n/V_0, so the
        # right-hand side is at most d_n times the number below; the display is about d_{n+1}.
        yield k.row(
            "d-index",
            TAU,
            "d_n ≤ |η_{s,n}|τ_n + |W_{s,n}|²τ_n²/2 (it bounds d_{n+1}): "
            "as τ_n ≤ (1+ζ_n/2) d_n/(-η_{c,n}) it needs 1 ≤ (1+ζ̄/2)(φ⁻+δ_x+(V₁/V₀)ζ̄)",
            1 <= (1 + k.zeta_bar / 2) * (phi_minus + k.delta_x + k.V_1 / V_0 * k.zeta_bar),
            ["time", "root-fine", "zeta-from-distance"],
            corrected_by="d-below-one",
        )
    yield k.row("eta-below-one", cnd6, "η² ≤ η ≤ 1", k.eta_bar <= 1)
    yield k.row(
        "tau-small", TAU, "V₁ τ_n² ≤ V₁^{1/2} τ_n ≤ 1", k.speed * k.tau_crude <= 1, ["time"]
    )
    coefficient = ((1 + r) / 2) ** 2
    if k.printed:
        yield k.row(
            "norm-law-as-printed",
            NORM,
            "the coefficient of (W_{c,n}·ω_{s,n+1})² is (1+r)²/2: it is the square of (1+r)/2",
            (1 + r) ** 2 / 2 <= coefficient,
            corrected_by="norm-law",
        )
    else:
        yield k.row(
            "norm-law",
            NORM,
            "the coefficient of (W_{c,n}·ω_{s,n+1})² is the square of (1+r)/2, (1+r)²/4",
            coefficient <= (1 + r) ** 2 / 4,
        )
    yield k.row("norm-factor-1", cnd6, "1+r ≤ 2", 1 + r <= 2)
    yield k.row("norm-factor-2", cnd6, "(1+r)²/4 ≤ (1+r)²/2 ≤ 2", (1 + r) ** 2 / 2 <= 2)
    yield k.row("norm-factor-3", cnd6, "|W_{s,n+1}|² - |W_{c,n}|² ≤ 0: r² - 1 ≤ 0", r**2 - 1 <= 0)
    yield k.row(
        "norm-c-upper",
        cnd6,
        "2V₁^{1/2}(1+d_n)η + 2(1+d_n)²η² ≤ 4(V₁^{1/2}+2)η, divided by η = -η_{c,n}",
        2 * k.speed * (1 + k.d_any) + 2 * (1 + k.d_any) ** 2 * k.eta_bar <= step,
        ["law-norms", "norm-step"],
    )
    yield k.row(
        "norm-s-upper",
        cnd6,
        "(1+d_n)²η² ≤ 4η, divided by η = -η_{c,n}",
        (1 + k.d_any) ** 2 * k.eta_bar <= 4,
        ["law-norms", "norm-step"],
    )
    yield k.row(
        "norm-c-lower",
        cnd6,
        "|W_{c,n+1}|² - |W_{s,n}|² ≥ -(1+r)V₁^{1/2}(1+d_n)η ≥ -4(V₁^{1/2}+2)η",
        (1 + r) * k.speed * (1 + k.d_any) <= step,
        ["law-norms", "norm-step"],
    )
    yield k.row(
        "norm-s-lower",
        cnd6,
        "|W_{s,n+1}|² - |W_{c,n}|² ≥ -(1-r²)(1+d_n)²η² ≥ -4(V₁^{1/2}+2)η",
        (1 - r**2) * (1 + k.d_any) ** 2 * k.eta_bar <= step,
        ["law-norms", "norm-step"],
    )
    third = (k.V_1 - V_0) / 3
    yield k.row(
        "Cnd5-upper",
        cnd5,
        "|W|² ≤ V₁ - (V₁-V₀)/3 + 4(V₁^{1/2}+2)/(1-C_η) η̄ ≤ V₁",
        k.norm_drift <= third,
        ["norm-step"],
    )
    if k.printed:
        yield k.row(
            "Cnd5-lower-as-printed",
            cnd5,
            "V₀ ≤ |W_{s,n+1}|² at |W_{c,n}|² = V₀, -η_{c,n} = C_η η̄: Cnd6 and Cnd7 are upper "
            "bounds, and the law subtracts (1-r²)(1+d_n)²(1-ζ_n)η_{c,n}²",
            V_0 <= V_0 - (1 - r**2) * (1 - k.zeta_bar) * (C_eta * k.eta_bar) ** 2,
            ["law-norms"],
            corrected_by="Cnd5-lower",
        )
    yield k.row(
        "Cnd5-lower",
        cnd5,
        "V₀ ≤ V₀ + (V₁-V₀)/3 - 4(V₁^{1/2}+2)/(1-C_η) η̄ ≤ |W|², by the two-sided estimates",
        V_0 + k.norm_drift <= V_0 + third,
        ["norm-step"],
    )


def _normal_component(k: ConstantSet) -> Iterator[Obligation]:
    cnd1, cnd2 = f"{CND}1", f"{CND}2"
    yield k.row("y-below-delta_2", cnd1, "|y_n| ≤ δ₂ by Cnd10", k.delta_y <= delta_2)
    yield k.row("y-below-delta_3", cnd2, "|y_n| ≤ δ₃ by Cnd10", k.delta_y <= delta_3)
    yield k.row("eta-chain-1", cnd2, "-1 < -1 + δ₃", -1 < -1 + delta_3)
    yield k.row(
        "eta-chain-2",
        cnd2,
        "-1 + δ₃ ≤ φ⁻ - α₀ + y_n",
        -1 + delta_3 <= phi_minus - alpha_0 - k.delta_y,
        ["law-eta-c"],
    )
    yield k.row(
        "eta-chain-3",
        cnd1,
        "φ⁻ - α₀ + y_n ≤ -δ₂",
        phi_minus - alpha_0 + k.delta_y <= -delta_2,
        ["law-eta-c"],
    )
    yield k.row("eta-chain-4", cnd1, "-δ₂ < 0, so η_{c,n+1} < 0", -delta_2 < 0)
    yield k.row(
        "eta-contraction",
        cnd2,
        "|η_{c,n+1}| ≤ C_η |η_{c,n}|",
        gap + k.delta_y <= C_eta,
        ["law-eta-c"],
    )


def _zeta(k: ConstantSet) -> Iterator[Obligation]:
    cnd = f"{CND}4"
    ratio = k.V_1 / V_0
    yield k.row(
        "zeta-root",
        cnd,
        "ζ_n ≤ 2(√2-1), where 1-√(1-ζ) ≤ ζ/2 + ζ²/4",
        k.zeta_bar <= 2 * (sqrt(2) - 1),
        ["root-fine"],
    )
    if k.printed:
        # tau/(-eta_c) >= zeta/(2 |W_c|^2); the state has |W_c|^2 = V_0 and a small zeta.
        zeta = minimum(k.zeta_bar, V_0 / 16)
        yield k.row(
            "zeta-time-square",
            cnd,
            "bounding τ/(-η_{c,n}) by 4ζ_n²/|W_{c,n}|⁴, at |W_{c,n}|² = V₀, ζ_n = min(ζ̄, V₀/16)",
            zeta / (2 * V_0) <= 4 * zeta**2 / V_0**2,
            ["time"],
            corrected_by="zeta-time-square",
        )
    else:
        yield k.row(
            "zeta-time-square",
            cnd,
            "(τ_n/(-η_{c,n}))² ≤ 4ζ_n²/|W_{c,n}|⁴",
            (k.tau_crude * k.zeta_bar) ** 2 <= 4 * k.zeta_bar**2 / V_0**2 * k.eta_bar**2,
            ["time"],
        )
    yield k.row(
        "zeta-dropped-factor",
        cnd,
        "the dropped factor 1+d_n: d_n(1+ζ_n/2) ≤ ζ_n/2, as d_n ≤ (4/3) ζ_n η_{c,n}²/V₀",
        Fraction(4, 3) * (2 + k.zeta_bar) * k.eta_bar**2 <= V_0,
        ["zeta-step", "zeta-from-distance"],
    )
    yield k.row(
        "zeta-denominator",
        cnd,
        "|φ⁻ - α₀ + y_n| ≥ δ₂, since |y_n| is small enough",
        delta_2 + k.delta_y <= gap,
    )
    yield k.row(
        "zeta-x_0",
        cnd,
        "second term at n = 0: (V₁/V₀) |x₀|/δ₂² ≤ h₅/12",
        ratio / delta_2**2 * k.x_0 <= h_5 / 12,
        ["zeta-step", "time"],
    )
    yield k.row(
        "zeta-x-bound",
        f"{CND}9",
        "Cnd9 implies |x_n| ≤ (V₀/V₁) δ₂² h₅/12",
        k.delta_x <= V_0 / k.V_1 * (delta_2**2 * h_5 / 12),
    )
    yield k.row(
        "zeta-term-2",
        cnd,
        "second term: (V₁/V₀) |x_n|/δ₂² ≤ h₅/12",
        ratio / delta_2**2 * k.delta_x <= h_5 / 12,
        ["zeta-step"],
    )
    square = (gap - k.delta_y) ** 2
    yield k.row(
        "zeta-term-2-denominator",
        cnd,
        "second term: (V₁/V₀) |x_n|/(φ⁻-α₀+y_n)² ≤ (V₁/V₀) |x_n|/δ₂²",
        ratio * k.delta_x / square <= ratio / delta_2**2 * k.delta_x,
        ["zeta-step"],
    )
    yield k.row(
        "zeta-ratio",
        cnd,
        "η_{s,n}/(-η_{c,n}) ≤ φ⁻ + |x_n| ≤ α₀/2, as |x_n| ≤ δ₁",
        phi_minus + k.delta_x <= alpha_0 / 2,
    )
    third, fourth = ratio * (alpha_0 / 2) / delta_2**2, ratio**2 * 4 / delta_2**2
    yield k.row(
        "zeta-term-3",
        cnd,
        "third term: at most (V₁/V₀)(α₀/2)/δ₂²",
        ratio * (phi_minus + k.delta_x) / square <= third,
        ["zeta-step"],
    )
    yield k.row(
        "zeta-term-4",
        cnd,
        "fourth term: at most 4V₁²/(V₀²δ₂²)",
        ratio**2 * 4 / square <= fourth,
        ["zeta-step"],
    )
    last_two = ratio / (2 * delta_2**2) * (alpha_0 + 8 * ratio)
    yield k.row(
        "zeta-terms-3-4",
        cnd,
        "third and fourth term: the sum of their bounds is V₁/(2V₀δ₂²)(α₀ + 8V₁/V₀)",
        third + fourth <= last_two,
        ["zeta-step"],
    )
    yield k.row(
        "zeta-small",
        cnd,
        "V₁/(2V₀δ₂²)(α₀ + 8V₁/V₀) ζ_n ≤ h₅/6, implied by Cnd4",
        last_two * k.zeta_bar <= h_5 / 6,
        ["zeta-step"],
    )
    yield k.row("zeta-remainder", cnd, "h₅/12 + h₅/6 = h₅/4", h_5 / 12 + h_5 / 6 <= h_5 / 4)
    yield k.row(
        "zeta-remainders",
        cnd,
        "the three remainder terms together are at most h₅/4, at |x_n| = δ_x",
        ratio / delta_2**2 * k.delta_x + last_two * k.zeta_bar <= h_5 / 4,
        ["zeta-step"],
    )
    yield k.row("zeta-y-bound", f"{CND}10", "|y_n| ≤ δ₅ by Cnd10", k.delta_y <= delta_5)
    yield k.row(
        "zeta-main-y",
        cnd,
        "main term: φ⁻/(φ⁻-α₀+y_n)² ≤ 1-h₅",
        phi_minus / square <= 1 - h_5,
        ["zeta-step"],
    )
    yield k.row(
        "zeta-main",
        cnd,
        "main term: (V₁/V₀)(1-h₅) ≤ 1-h₅/2",
        ratio * (1 - h_5) <= 1 - h_5 / 2,
        ["zeta-step"],
    )
    yield k.row("zeta-sum", cnd, "(1-h₅/2) + h₅/4 = 1-h₅/4", (1 - h_5 / 2) + h_5 / 4 <= 1 - h_5 / 4)
    yield k.row("zeta-factor-below-one", cnd, "1-h₅/4 < 1", 1 - h_5 / 4 < 1)
    total = (
        ratio * (phi_minus + k.delta_x) / square
        + (ratio * (alpha_0 / 2) / square + ratio**2 * 4 / square) * k.zeta_bar
    )
    yield k.row(
        "zeta-total",
        cnd,
        "ζ_{n+1} ≤ (1-h₅/4) ζ_n: the four terms together, at |x_n| = δ_x and |y_n| = δ_y",
        total <= 1 - h_5 / 4,
        ["zeta-step"],
    )
    yield k.row(
        "Cnd3",
        f"{CND}3",
        "ζ_{n+1} ≤ (1-h₅/4) ζ̄ < 1",
        (1 - h_5 / 4) * k.zeta_bar < 1,
        ["collision-map"],
    )


def _no_outer_collision(k: ConstantSet) -> Iterator[Obligation]:
    cnd = f"{CND}T"
    yield k.row(
        "obtuse",
        cnd,
        "Cnd8 and Cnd2 imply cos θ_{n+1} < 0",
        k.drift < c,
        ["angle-step"],
    )
    yield k.row(
        "obtuse-distance",
        cnd,
        "|ω_{c,n+1} - ω_{s,n+1}| ≥ √2",
        sqrt(2) <= sqrt(2 + 2 * (c - k.drift)),
        ["outer-distance", "angle-step"],
    )
    total = 3 * k.speed / V_0 * k.eta_bar + 4 * k.speed / V_0 * k.eta_bar
    half = (sqrt(2) - 1) / 2
    yield k.row(
        "CndT-half",
        cnd,
        "3(V₁^{1/2}/V₀)(-η_{c,n}) + 4(V₁^{1/2}/V₀)(-η_{c,n+1}) ≤ (√2-1)/2",
        total <= half,
        ["outer-distance", "distance", "time"],
    )
    if k.printed:
        yield k.row(
            "CndT-as-printed",
            cnd,
            "the distance 1-2 'is always larger than (√2-1)/2', so there is no collision",
            as_term(1) <= half,
            corrected_by="CndT",
        )
    yield k.row(
        "CndT",
        cnd,
        "√2 - d_{n+1} - 2V₁^{1/2} τ_{n+1} > 1",
        1 < sqrt(2) - total,
        ["outer-distance", "distance", "time", "collision-map"],
    )


def _angle(k: ConstantSet) -> Iterator[Obligation]:
    cnd = f"{CND}8"
    if k.printed:
        yield k.row(
            "angle-sign",
            COSINE,
            "the bound on |cos θ_{n+2} - cos θ_{n+1}| with -|W_s·W_c| τ²/(1+d), at W_s·W_c < 0: "
            "the last term enters with the wrong sign",
            V_0 * k.tau_crude**2 <= -V_0 * k.tau_crude**2,
            corrected_by="angle-step-time",
        )
    yield k.row(
        "angle-step-time",
        cnd,
        "V₁^{1/2} τ + 2V₁^{1/2} τ + V₁ τ² ≤ 8 (V₁^{1/2}/V₀)(-η_{c,n+1})",
        3 * k.speed * k.tau_crude + k.V_1 * k.tau_crude**2 <= 8 * k.speed / V_0 * k.eta_bar,
        ["law-angle", "angle-step"],
    )
    yield k.row(
        "angle-step",
        cnd,
        "3 + (3 + 8) C_η ≤ 3 + 11 C_η: one step of Cnd8, divided by (V₁^{1/2}/V₀)(-η_{c,n})",
        3 + 3 * C_eta + 8 * C_eta <= C_eta * ((3 + 11 * C_eta) / C_eta),
        ["angle-step"],
    )
    yield k.row(
        "angle-tail",
        cnd,
        "11 + (3 + 11C_η)/C_η Σ_{k≥1} C_η^k = 14/(1-C_η)",
        11 + (3 + 11 * C_eta) / C_eta * (C_eta / (1 - C_eta)) <= 14 / (1 - C_eta),
        ["angle-step"],
    )
    yield k.row(
        "angle-absorbed",
        cnd,
        "|(-cos θ_n) - (-cos θ₀)| ≤ |Δθ| for every n: the bound of Cnd8, summed",
        k.drift <= k.Delta_theta,
        ["angle-step"],
    )


def _x(k: ConstantSet) -> Iterator[Obligation]:
    cnd = f"{CND}9"
    half = h_4 * k.delta_x / 2
    for name, letter, size in (
        ("d_0", "d₀", k.d_bar),
        ("d", "d_n, n ≥ 1", k.d_later),
        ("zeta", "2ζ_n", 2 * k.zeta_bar),
    ):
        yield k.row(
            f"x-term-1-{name}",
            cnd,
            f"first term, at most max(d_n, 2ζ_n)/δ₂: {letter}, divided by δ₂, is ≤ h₄δ_x/2",
            size / delta_2 <= half,
            ["x-step", "root-product"],
        )
    if k.printed:
        yield from _entries_alone(k)
    yield k.row("x-y-bound", f"{CND}10", "|y_n| ≤ δ₄ by Cnd10", k.delta_y <= delta_4)
    yield k.row(
        "x-contraction",
        cnd,
        "|r/(α₀-φ⁻-y_n) - φ⁻| ≤ (1-h₄)|y_n|",
        r / (gap - k.delta_y) ** 2 <= 1 - h_4,
        ["x-step"],
    )
    yield k.row(
        "x-term-2", cnd, "(1-h₄)|y_n| ≤ (1-h₄)δ_x", (1 - h_4) * k.delta_y <= (1 - h_4) * k.delta_x
    )
    better = (1 - h_4 / 2) * k.delta_x
    yield k.row(
        "x-improved",
        X_BETTER,
        "|x_{n+1}| ≤ h₄δ_x/2 + (1-h₄)δ_x = (1-h₄/2)δ_x",
        h_4 * k.delta_x / 2 + (1 - h_4) * k.delta_x <= better,
        ["law-eta-s", "x-step"],
    )
    yield k.row("x-propagates", cnd, "(1-h₄/2)δ_x < δ_x", better < k.delta_x)


def _y(k: ConstantSet) -> Iterator[Obligation]:
    cnd = f"{CND}10"
    eighth = h_4 * k.delta_x / 8
    yield k.row(
        "y-ratio",
        cnd,
        "η_{s,n+1}/(-η_{c,n+1}) ≤ φ⁻ + |x_{n+1}| ≤ α₀/2",
        phi_minus + k.delta_x <= alpha_0 / 2,
    )
    yield k.row(
        "y-term-1",
        cnd,
        "d_{n+2} α₀/2 ≤ h₄δ_x/8",
        k.d_later * (alpha_0 / 2) <= eighth,
        ["y-step", "distance"],
    )
    for name, letter, size in (("d", "d_{n+1}", k.d_later), ("zeta", "2ζ_{n+1}", 2 * k.zeta_bar)):
        yield k.row(
            f"y-term-2-{name}",
            cnd,
            f"second term, at most max(d_{{n+1}}, 2ζ_{{n+1}}): {letter} ≤ h₄δ_x/8",
            size <= eighth,
            ["y-step", "root-product"],
        )
    yield k.row(
        "y-term-3",
        cnd,
        "|(-cos θ_{n+2}) - (-cos θ₀)| ≤ h₄δ_x/8",
        k.drift <= eighth,
        ["y-step", "angle-step"],
    )
    yield k.row(
        "y-term-4",
        cnd,
        "V₁ τ_{n+1}/(-η_{c,n+1}) ≤ 2(V₁/V₀)ζ̄ ≤ h₄δ_x/8",
        2 * k.V_1 / V_0 * k.zeta_bar <= eighth,
        ["y-step", "time"],
    )
    yield k.row(
        "y-sum",
        cnd,
        "|y_{n+1}| ≤ 4 · h₄δ_x/8 + (1-h₄/2)δ_x = δ_x",
        eighth + eighth + eighth + eighth + (1 - h_4 / 2) * k.delta_x <= k.delta_y,
        ["law-eta-c", "y-step"],
    )


def _entries_alone(k: ConstantSet) -> Iterator[Obligation]:
    """The entries with a sum, each against the step that it is there for.

    Where another entry of the min is smaller the step itself holds all the same; these rows show
    that the sum is not what the step needs.
    """
    bounds = k.bounds()
    eta_5 = bounds["eta_bar"][4]
    zeta_3 = bounds["zeta_bar"][2]
    d_4 = bounds["d_const"][3]
    share = h_4 * k.delta_x
    d_eta = 3 * k.speed / V_0 * eta_5
    zeta_label, d_label = "EQUATSS4.1DefinBorne_Zeta", "EQUATSS4.1DefinBorne_d_0_"
    for name, label, says, claim, correction in (
        ("eta-y-1", ETA, "entry 5 of η̄: d_{n+2} α₀/2 ≤ h₄δ_x/8", d_eta * alpha_0 / 2 <= share / 8,
         "y-term-1"),
        ("eta-y-2", ETA, "entry 5 of η̄: d_{n+1} ≤ h₄δ_x/8", d_eta <= share / 8, "y-term-2-d"),
        ("eta-x-1", ETA, "entry 5 of η̄: d_n/δ₂ ≤ h₄δ_x/2", d_eta / delta_2 <= share / 2,
         "x-term-1-d"),
        ("zeta-y-2", zeta_label, "entry 3 of ζ̄: 2ζ_{n+1} ≤ h₄δ_x/8", 2 * zeta_3 <= share / 8,
         "y-term-2-zeta"),
        ("zeta-x-1", zeta_label, "entry 3 of ζ̄: 2ζ_n/δ₂ ≤ h₄δ_x/2",
         2 * zeta_3 / delta_2 <= share / 2, "x-term-1-zeta"),
        ("zeta-y-4", zeta_label, "entry 3 of ζ̄: 2(V₁/V₀)ζ̄ ≤ h₄δ_x/8",
         2 * k.V_1 / V_0 * zeta_3 <= share / 8, "y-term-4"),
        ("d-y-3", d_label, "entry 4 of d̄: d₀ ≤ h₄δ_x/4", d_4 <= share / 4, "init-y-term-3-d"),
        ("d-x-1", d_label, "entry 4 of d̄: d₀/δ₂ ≤ h₄δ_x/2", d_4 / delta_2 <= share / 2,
         "x-term-1-d_0"),
    ):  # fmt: skip
        yield k.row(f"alone-{name}", label, f"{says}, alone", claim, corrected_by=correction)
