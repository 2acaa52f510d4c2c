"""What is wrong with the print, what the repaired set changes, and remarks on the text.

Every row that has a severity belongs to exactly one cause. A cause is about the print: that its
rows are refuted is decided for given parameters, and some of them hold for others. The changes are
the table `paper | needed | why`; each names the rows of the repaired set that prove it. Remarks
stand where no inequality decides.
"""

from __future__ import annotations

from verify.paper.parameters import THEOREM
from verify.publication import Cause, Change, Remark

X_0, X_LINK = "EQUATSS4.1DescrDoIniColla", "EQUATSS4.1Lien_x_n_&_y_n_"
DELTA, ETA = "EQUATSS4.1DefinDeltxDelty", "EQUATSS4.1DefinBorne_Eta_"
ZETA, D_0 = "EQUATSS4.1DefinBorne_Zeta", "EQUATSS4.1DefinBorne_d_0_"

CAUSES = (
    Cause(("hypotheses.angle-as-printed", "printed.second-assumption-as-printed"),
        "< is printed for >, which (4.6), `EQUATSS3.4ZKCl2CondiStabi`, has. The two conditions "
        "exclude each other: wherever h₅ > 0, as the text asks, the printed hypothesis fails (at r "
        "= 3/100 with -cos θ₀ = 1, for one), and the other rows are judged outside it. What is "
        "refuted here is what the text concludes from the hypothesis. That the point does not "
        "satisfy the hypothesis as printed is a remark (`angle-as-printed`)."),
    Cause(("printed.r_stabi-gives-fixed-points",),
        "The two fixed points come from the condition on the angle, read with >; r < r_stabi, "
        "which the text names, does not give them."),
    Cause(("printed.phi-minus-called-unstable",), "'Unstable' is printed for 'stable'."),
    Cause(("printed.set-interior",),
        "ω_{c,0}·ω_{s,0} = cos θ₀ is an equation, so this set has no interior, not even among the "
        "data in contact, and the theorem claims one. The union of such sets over neighbouring "
        "angles has one; the text does not form it. So the text does not reach this claim of "
        "the theorem. The claim is true: the set can be given room for the angle "
        "(`certificates/printed-set`)."),
    Cause(("printed.init-zeta-bound-2",),
        "The bound 2 is printed for the bound 2x, which the display uses. Both bounds and the "
        "display are true."),
    Cause(("printed.d-index",), "The right-hand side bounds d_{n+1}; d_n is printed."),
    Cause(("printed.norm-law-as-printed",),
        "(1+r)²/2 is printed for (1+r)²/4; all that is used is that it is at most 2."),
    Cause(("printed.Cnd5-lower-as-printed",),
        "Cnd6 and Cnd7 lack absolute values. The bound (1+d_n)²η² on a difference that is never "
        "positive shows that they are meant, and the same constants bound them."),
    Cause(("printed.zeta-time-square",), "τ_n/(-η_{c,n}) is printed for its square."),
    Cause(("printed.zeta-x-bound", "printed.zeta-term-2", "printed.zeta-remainders",
        "printed.zeta-total"),
        "The bound (V₀/V₁) δ₂² h₅/12 is assumed for x₀ only; for later x_n the text has the bound "
        "δ_x, which is larger."),
    Cause(("printed.CndT-as-printed",),
        "For the distance of the centres '1 +' is missing in front of (√2-1)/2; for the gap "
        "between the two balls the sentence is right as it stands."),
    Cause(("printed.angle-sign",),
        "- is printed for + in front of the last term (and = for ≤); the line below has +."),
    Cause(("printed.angle-absorbed", "printed.y-term-3", "printed.final-angle"),
        "The entry V₀/(33 V₁^{1/2}) |Δθ| of η̄ has no factor 1-C_η, and the printed bounds let the "
        "angle drift by 14 (V₁^{1/2}/V₀) η̄/(1-C_η). It depends on the parameters which step "
        "fails: at r = 3/100 `y-term-3` for δ_θ = 1/10, and `final-angle` for δ_θ = 1/1000. The "
        "step `final-angle` is what the theorem claims of the final angle; where it fails, it "
        "breaks the argument. In y_n the step `y-term-3` has the factor (1+r)/2, with which it "
        "holds (`y-term-3-factor`). That the whole drift is at most |Δθ| (`angle-absorbed`) fails "
        "for both, but no sentence of the text claims it: a remark."),
    Cause(("printed.x-term-1-d",),
        "d_n/δ₂ ≤ h₄δ_x/2 fails at r = 1/1000000 with -cos θ₀ = 1/20, for one. The display has the "
        "factor r in front of it, which the text drops; with it the step holds for all parameters "
        "(`x-term-1-factor`)."),
    Cause(("printed.alone-eta-y-1", "printed.alone-eta-y-2", "printed.alone-eta-x-1",
        "printed.alone-zeta-y-2", "printed.alone-zeta-x-1", "printed.alone-zeta-y-4",
        "printed.alone-d-y-3", "printed.alone-d-x-1"),
        "A remark: these rows ask of one entry of a min what the text claims only of the min. An "
        "entry adds up the bounds that several steps need, so that it guarantees none of them "
        "alone. Each step has its own row and may hold all the same, because another entry is "
        "smaller. Once δ_x is repaired, the steps do need what is alone in entry 3 of ζ̄ (at r = "
        "3/100, say)."),
)  # fmt: skip


CHANGES = (
    Change("EQUATSS4.1ThExiCondiTheta", "-cos θ₀ < 2r^(1/3)(1+r^(1/3))/(1+r)",
        "-cos θ₀ > 2r^(1/3)(1+r^(1/3))/(1+r)",
        "the fixed points exist and h₅ > 0 exactly with >; with < either the fixed points are not "
        "real, and nothing is constructed, or h₅ < 0.",
        ("second-ratio",)),
    Change(DELTA, "δ_x = δ_y = min(δ₁, …, δ₅)", "also at most (V₀/V₁) δ₂² h₅/12",
        "Cnd9 must give |x_n| ≤ (V₀/V₁) δ₂² h₅/12 for every n, not only for n = 0.",
        ("zeta-x-bound",)),
    Change(X_0, "ω_{c,0}·ω_{s,0} = cos θ₀", "|cos θ_init - cos θ₀| ≤ |Δθ|/4",
        "with the angle fixed the set has no interior.",
        ("set-interior",)),
    Change("EQUATSS4.1Recurrence_Cnd5", "(nothing)",
        "d_n ≤ 1 among the conditions of the recursion",
        "1+d_n ≤ 2 is used in the bounds on τ_n and on the norms.",
        ("d_0-below-one", "d-below-one")),
    Change(ETA, "entry V₀/(33 V₁^{1/2}) |Δθ|", "(1-C_η)/28 · V₀/V₁^{1/2} · |Δθ|",
        "the tail of Cnd8 is 14 (V₁^{1/2}/V₀) η̄/(1-C_η); half of |Δθ| is left for it.",
        ("angle-absorbed",)),
    Change(ETA, "entry V₀/V₁^{1/2} (2/(15α₀) + h₄δ₂/6 + h₄/(12α₀) + h₄/24) δ_x",
        "V₀/V₁^{1/2} h₄δ_x times each of 1/(12α₀), δ₂/6, 1/24",
        "each later step needs its own bound; their sum is larger than each of them.",
        ("y-term-1", "x-term-1-d", "y-term-2-d")),
    Change(ZETA, "entry (1 + 4δ₂ + V₀/V₁) h₄δ_x/16", "h₄δ_x/16 times each of 1, 4δ₂, V₀/V₁",
        "the same.",
        ("y-term-2-zeta", "x-term-1-zeta", "y-term-4")),
    Change(D_0, "entries |Δθ|/3, (1+δ₂h₄)δ_x/5, (1+2δ₂)h₄δ_x/4", "|Δθ|/4, δ₂h₄δ_x/2, h₄δ_x/8",
        "the same; and a quarter of |Δθ| is left for the initial angle.",
        ("angle-absorbed", "x-term-1-d_0", "init-y-term-3-d")),
    Change("EQUATSS4.1EvoluNormeVitRl", "(1+r)²/2 (W_c·ω)²", "(1+r)²/4 (W_c·ω)²",
        "the square of the impulse; the printed bound 2|W_c·ω|² holds with either.",
        ("norm-law",)),
    Change("EQUATSS4.1Recurrence_Cnd6", "|W_{c,n}|² - |W_{s,0}|² ≤ …, upper bounds only",
        "the absolute values of the differences",
        "V₀ ≤ |W|² needs a bound from below; the same constant serves.",
        ("norm-c-lower", "norm-s-lower", "Cnd5-lower")),
    Change("THEORSS4.1ExistenCollapse", "(nothing)",
        "Σ τ_n ≤ 2 η̄ ζ̄/(V₀(1-C_η)) ≤ T*, and |Δθ| ≤ δ_θ for the limit angle",
        "the finite collapse time and the final angle are claimed and not concluded.",
        ("collapse-time", "final-angle")),
)  # fmt: skip


REMARKS = (
    Remark(THEOREM,
        "δ₄ is defined by an equation with two positive roots, and so is δ₅; the smaller is "
        "meant."),
    Remark("EQUATSS4.1DerivFonctF_1P-",
        "The display before it begins with 'F₁:' and goes on with the fixed points: the mapping "
        "that F₁ names, φ ↦ r/(α₀-φ), stands above without its name, and here is its derivative."),
    Remark("EQUATSS3.4EvoluVNormLinea",
        "The change of the cosine is written as a factor, cos θ̄ (1+ε_{3,n}), which says too much "
        "where cos θ̄ = 0: there only cos θ̄ + ε_{3,n} is known. That cos θ̄ is not 0 in a collapse "
        "follows from theorem II (`certificates/classification`), not from what stands before."),
    Remark("EQUATSS4.1_Controle_Tau_n",
        "τ_n is the time before the n-th collision in Section 3, t_n - t_{n-1} (printed as t_n - "
        "τ_{n-1}), and the time after it in Section 4 and in the mapping. This program has the "
        "second one everywhere."),
    Remark("EQUATSS4.1DonneInitiColSp",
        "η_{c,n} < 0, ζ_n < 1 and the condition on the outer pair are called necessary and "
        "sufficient for the collapse; that it happens in finite time, Σ τ_n < ∞, is a further "
        "condition."),
    Remark("EQUATSS4.1EvoluCompoNormC", "The law is stated for n ≥ 1 and used for n = 0."),
    Remark(ETA, "The 1 and the 2 in η̄ are speeds: they fix a unit."),
    Remark(ETA, "No step here uses the summand 2/(15α₀)."),
    Remark(D_0, "No step here uses the entry (1+δ₂h₄)δ_x/5."),
    Remark(X_0,
        "The set asks for d₀ ≤ d̄ only: 0 < d₀ is part of the model, `EQUATSS2.2LoiEvDistaInit1`. "
        "Likewise η_{s,0} > 0 is what post-collisional means, `EQUATSS2.2LoiEvW1Om1Init1`."),
    Remark("EQUATSS4.1Recurrence_Cnd2",
        "The second inequality is stated for all k ≤ n and means 1 ≤ k ≤ n."),
    Remark("EQUATSS4.1Recurrence_Cnd6",
        "Called trivial at n = 0, where Cnd7 applies, as 0 is even."),
    Remark("EQUATSS4.1Recurrence_Cnd6",
        "Cited in the second term of ζ_{n+1} for a bound that Cnd5 gives."),
    Remark("EQUATSS4.1Recurrence_Cnd8",
        "The induction is announced for Cnd1 to Cnd8, and Cnd9 and Cnd10 are used and proved too."),
    Remark("EQUATSS4.1_Controle_Tau_n",
        "d_n ≤ 1 is not among the conditions; it is used to bound τ_n, which serves to bound d_n."),
    Remark("EQUATSS4.1Recurrence_Cnd4",
        "The factor 1+d_n disappears between two displays; `zeta-dropped-factor` shows that it "
        "may."),
    Remark("EQUATSS4.1Recurrence_Cnd4",
        "In the display with h₅/12 the absolute value of x_n is missing."),
    Remark(X_LINK, "The term with τ_n/(-η_{c,n}) needs the bound on τ_n with its factor ζ_n."),
    Remark(THEOREM,
        "The proof ends with infinitely many collisions: that they happen in finite time and that "
        "the final angle is near θ₀ is not concluded."),
)  # fmt: skip
