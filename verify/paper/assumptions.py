"""What the proof uses and this program does not prove yet: the laws, and estimates for every state.

The state just after the n-th collision is the inner products of (omega_s, W_s, omega_c, W_c) and
the distance d. A later release proves these sentences; until then each is listed with every
verdict.
"""

from __future__ import annotations

from verify.language.statement import Assumption

ASSUMPTIONS = (
    Assumption(
        "collision-map",
        "EQUATSS2.2IterationSystm1",
        "The single-collision mapping describes the motion from one collision of the central "
        "particle to the next, as long as η_c < 0, ζ < 1, d > 0 and the outer pair stays apart; "
        "the pair that just met, with η_s > 0, does not meet again meanwhile.",
    ),
    Assumption(
        "collision-map-roles",
        "EQUATSS4.1SysteDynamColSp",
        "The same mapping with the roles colliding and spectator exchanged at each collision.",
    ),
    Assumption(
        "law-eta-c",
        "EQUATSS4.1EvoluCompoNormC",
        "η_{c,n+1} = η_{s,n}/(1+d_{n+1}) - (1+r)/2 (1+d_n)√(1-ζ_n) (-cos θ_{n+1})(-η_{c,n}) "
        "+ τ_n |W_{s,n}|²/(1+d_{n+1}), for n ≥ 0.",
    ),
    Assumption(
        "law-eta-s",
        "EQUATSS4.1EvoluCompoNormC",
        "η_{s,n+1} = r (1+d_n)√(1-ζ_n) (-η_{c,n}).",
    ),
    Assumption(
        "law-norms",
        "EQUATSS4.1EvoluNormeVitRl",
        "With a = W_{c,n}·ω_{s,n+1} = -(1+d_n)√(1-ζ_n)(-η_{c,n}): |W_{c,n+1}|² = |W_{s,n}|² "
        "- (1+r) a (W_{s,n}·ω_{s,n+1}) + ((1+r)²/4) a² (printed with 2 in place of 4) and "
        "|W_{s,n+1}|² = |W_{c,n}|² - (1-r²) a².",
    ),
    Assumption(
        "law-angle",
        "EQUATSS4.1EvoluCosinAngle",
        "-cos θ_{n+1} = [(1+d_n)(-cos θ_n) - τ_n (ω_s·W_c) - (1+d_n) τ_n (ω_c·W_s) "
        "- τ_n² (W_s·W_c)]/(1+d_{n+1}).",
    ),
    Assumption(
        "zeta-from-distance",
        "EQUATSS4.1BorneParam_ZK0_",
        "x(2+x)/(1+x)² ≤ 2x for x ≥ 0 and ≥ 3x/4 for 0 ≤ x ≤ 1, hence ζ ≤ 2 d |W_c|²/η_c² "
        "and, if d ≤ 1, (3/4) d |W_c|²/η_c² ≤ ζ.",
    ),
    Assumption(
        "root-crude",
        "EQUATSS4.1Recurrence_Cnd3",
        "1 - √(1-ζ) ≤ ζ for 0 ≤ ζ ≤ 1.",
    ),
    Assumption(
        "root-fine",
        "EQUATSS4.1Recurrence_Cnd4",
        "1 - √(1-ζ) ≤ ζ/2 + ζ²/4 for 0 ≤ ζ ≤ 2(√2-1).",
    ),
    Assumption(
        "root-product",
        "EQUATSS4.1Lien_x_n_&_y_n_",
        "|(1+d)√(1-ζ) - 1| ≤ max(d, 2ζ) for d ≥ 0 and 0 ≤ ζ ≤ 1.",
    ),
    Assumption(
        "time",
        "EQUATSS4.1_Controle_Tau_n",
        "If d_n ≤ 1 and |W_{c,n}|² ≥ V₀ then τ_n ≤ 2(-η_{c,n})ζ_n/|W_{c,n}|² ≤ 2(-η_{c,n})ζ_n/V₀.",
    ),
    Assumption(
        "distance",
        "EQUATSS4.1BorneDista_d_1_",
        "d_{n+1} ≤ η_{s,n}τ_n + |W_{s,n}|²τ_n²/2, which is at most (3/2) V₁^{1/2} τ_n "
        "≤ 3 (V₁^{1/2}/V₀)(-η_{c,n}) if V₁^{1/2} τ_n ≤ 1; and d_{n+1} > 0 if η_{s,n}, τ_n > 0.",
    ),
    Assumption(
        "outer-distance",
        "EQUATSS4.1Recurrence_CndT",
        "|(1+d)ω_c - ω_s + τ(W_c-W_s)| ≥ |ω_c-ω_s| - d - 2V₁^{1/2}τ, and "
        "|ω_c-ω_s| = √(2+2(-cos θ)).",
    ),
    Assumption(
        "angle-step",
        "EQUATSS4.1Recurrence_Cnd8",
        "|cos θ_{n+1} - cos θ_n| ≤ d_n + d_{n+1} + τ_n|W_c| + 2τ_n|W_s| + τ_n²|W_s||W_c| "
        "if d_n ≤ 1; with -η_{c,n} ≤ C_η^n (-η_{c,0}) the steps add up to the geometric sum of "
        "the statement.",
    ),
    Assumption(
        "norm-step",
        "EQUATSS4.1Recurrence_Cnd6",
        "The changes of |W_c|², |W_s|² at one collision are bounded, from above and from below, "
        "by law-norms with |W_{s,n}·ω_{s,n+1}| ≤ V₁^{1/2} and |a| ≤ (1+d_n)(-η_{c,n}); with "
        "-η_{c,n} ≤ C_η^n (-η_{c,0}) they add up to the geometric sum Σ C_η^k < 1/(1-C_η).",
    ),
    Assumption(
        "zeta-step",
        "EQUATSS4.1Recurrence_Cnd4",
        "ζ_{n+1} ≤ 2|W_{c,n+1}|² d_{n+1}/η_{c,n+1}², and inserting the bounds on d_{n+1}, τ_n "
        "and the root gives the four printed terms, provided d_n(1+ζ_n/2) ≤ ζ_n/2 absorbs the "
        "factor 1+d_n that the print drops.",
    ),
    Assumption(
        "x-step",
        "EQUATSS4.1DefinReste_x_n_",
        "x_{n+1} = r(1+d_n)√(1-ζ_n)/(α₀-φ⁻-y_n) - φ⁻; and |r/(α₀-φ⁻-y) - φ⁻| ≤ K|y| if "
        "0 ≤ δ < α₀-φ⁻, r/(α₀-φ⁻-δ)² ≤ K and |y| ≤ δ (mean value theorem).",
    ),
    Assumption(
        "y-step",
        "EQUATSS4.1Lien_x_n_&_y_n_",
        "The identity for y_n, its five terms bounded one by one: |1/(1+d)-1| ≤ d, "
        "(1+r)/2 ≤ 1, -cos θ ≤ 1.",
    ),
    Assumption(
        "induction",
        "THEORSS4.1ExistenCollapse",
        "The conditions Cnd1 to Cnd10 and CndT for every n follow from the rows of the "
        "initialization and of the recursion by induction on n.",
    ),
    Assumption(
        "interior",
        "THEORSS4.1ExistenCollapse",
        "The initial data whose inequalities are strict form a non-empty open part of the contact "
        "surface |x₁-x₀| = 1, η_s > 0; flowing for a short time before the next collision, they "
        "sweep out an open set.",
    ),
)
