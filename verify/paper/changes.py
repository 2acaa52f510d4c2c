"""What the repaired set changes, and why: the table `paper | needed | why`."""

from __future__ import annotations

from verify.language.statement import Change
from verify.paper.initial_data import D_0, DELTA, ETA, X_0, ZETA

CHANGES = (
    Change("EQUATSS4.1ThExiCondiTheta", "-cos θ₀ < 2r^(1/3)(1+r^(1/3))/(1+r)",
        "-cos θ₀ > 2r^(1/3)(1+r^(1/3))/(1+r)",
        "h₅ > 0 is equivalent to >; with < the construction has h₅ < 0."),
    Change(DELTA, "δ_x = δ_y = min(δ₁, …, δ₅)", "also at most (V₀/V₁) δ₂² h₅/12",
        "Cnd9 must give |x_n| ≤ (V₀/V₁) δ₂² h₅/12 for every n, not only for n = 0."),
    Change(X_0, "ω_{c,0}·ω_{s,0} = cos θ₀", "|cos θ_init - cos θ₀| ≤ |Δθ|/4",
        "with the angle fixed the set has no interior."),
    Change("EQUATSS4.1Recurrence_Cnd5", "(nothing)",
        "d_n ≤ 1 among the conditions of the recursion",
        "1+d_n ≤ 2 is used in the bounds on τ_n and on the norms."),
    Change(ETA, "entry V₀/(33 V₁^{1/2}) |Δθ|", "(1-C_η)/28 · V₀/V₁^{1/2} · |Δθ|",
        "the tail of Cnd8 is 14 (V₁^{1/2}/V₀) η̄/(1-C_η); half of |Δθ| is left for it."),
    Change(ETA, "entry V₀/V₁^{1/2} (2/(15α₀) + h₄δ₂/6 + h₄/(12α₀) + h₄/24) δ_x",
        "V₀/V₁^{1/2} h₄δ_x times each of 1/(12α₀), δ₂/6, 1/24",
        "each later step needs its own bound; their sum is larger than each of them."),
    Change(ZETA, "entry (1 + 4δ₂ + V₀/V₁) h₄δ_x/16", "h₄δ_x/16 times each of 1, 4δ₂, V₀/V₁",
        "the same."),
    Change(D_0, "entries |Δθ|/3, (1+δ₂h₄)δ_x/5, (1+2δ₂)h₄δ_x/4", "|Δθ|/4, δ₂h₄δ_x/2, h₄δ_x/8",
        "the same; and a quarter of |Δθ| is left for the initial angle."),
    Change("EQUATSS4.1EvoluNormeVitRl", "(1+r)²/2 (W_c·ω)²", "(1+r)²/4 (W_c·ω)²",
        "the square of the impulse; the printed bound 2|W_c·ω|² holds with either."),
    Change("EQUATSS4.1Recurrence_Cnd6", "|W_{c,n}|² - |W_{s,0}|² ≤ …, upper bounds only",
        "the absolute values of the differences",
        "V₀ ≤ |W|² needs a bound from below; the same constant serves."),
    Change("THEORSS4.1ExistenCollapse", "(nothing)",
        "Σ τ_n ≤ 2 η̄ ζ̄/(V₀(1-C_η)) ≤ T*, and |Δθ| ≤ δ_θ for the limit angle",
        "the finite collapse time and the final angle are claimed and not concluded."),
)  # fmt: skip
