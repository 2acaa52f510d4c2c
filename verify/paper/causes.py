"""Which printed rows are false for one and the same reason, and what the reason is.

Every row that has a severity belongs to exactly one cause. A cause is about the print: that its
rows are refuted is decided for given parameters, and some of them hold for others.
"""

from __future__ import annotations

from verify.language.record import Record


class Cause(Record):
    """What is wrong, once, with the names of all rows that show it."""

    rows: tuple[str, ...]
    text: str


CAUSES = (
    Cause(("hypotheses.angle-as-printed", "printed.second-assumption-as-printed"),
        "< is printed for >, which `EQUATSS3.4ZKCl2CondiStabi` has. The two conditions exclude "
        "each other: wherever h₅ > 0, as the text asks, the printed hypothesis fails (at r = "
        "3/100 with -cos θ₀ = 1, for one), and the other rows are judged outside it. One slip, "
        "two rows."),
    Cause(("printed.r_stabi-gives-fixed-points",),
        "The two fixed points come from the condition on the angle, read with >; r < r_stabi does "
        "not give them."),
    Cause(("printed.phi-minus-called-unstable",), "'Unstable' is printed for 'stable'."),
    Cause(("printed.set-interior",),
        "ω_{c,0}·ω_{s,0} = cos θ₀ is an equation, so this set has no interior, not even among the "
        "data in contact, and the theorem claims one. The union of such sets over neighbouring "
        "angles has one; the text does not form it."),
    Cause(("printed.init-zeta-bound-2",),
        "The bound 2 is printed for the bound 2x, which is true too and which the display uses."),
    Cause(("printed.d-index",), "The right-hand side bounds d_{n+1}; d_n is printed."),
    Cause(("printed.norm-law-as-printed",),
        "(1+r)²/2 is printed for (1+r)²/4; all that is used is that it is at most 2."),
    Cause(("printed.Cnd5-lower-as-printed",),
        "Cnd6 and Cnd7 lack absolute values. The bound (1+d_n)²η² on a difference that is never "
        "positive shows that they are meant, and the same constants bound them."),
    Cause(("printed.zeta-time-square",), "τ_n/(-η_{c,n}) is printed for its square."),
    Cause(("printed.zeta-x-bound", "printed.zeta-term-2", "printed.zeta-remainders",
        "printed.zeta-total"),
        "Only of x₀ is it assumed that it is at most (V₀/V₁) δ₂² h₅/12; of the others the text "
        "has the bound δ_x, which is larger."),
    Cause(("printed.CndT-as-printed",), "'1 +' is missing in front of (√2-1)/2."),
    Cause(("printed.angle-sign",),
        "- is printed for + in front of the last term (and = for ≤); the line below has +."),
    Cause(("printed.angle-absorbed", "printed.y-term-3", "printed.final-angle"),
        "The entry V₀/(33 V₁^{1/2}) |Δθ| of η̄ has no factor 1-C_η, and the angles may drift by "
        "14 (V₁^{1/2}/V₀) η̄/(1-C_η). Which of the three steps fail depends on the parameters: at "
        "r = 3/100 the first two for δ_θ = 1/10, the first and the last for δ_θ = 1/1000. Only "
        "the last breaks the argument: in y_n the second has the factor (1+r)/2, with which it "
        "holds (`y-term-3-factor`)."),
    Cause(("printed.alone-eta-y-1", "printed.alone-eta-y-2", "printed.alone-eta-x-1",
        "printed.x-term-1-d", "printed.alone-zeta-y-2", "printed.alone-zeta-x-1",
        "printed.alone-zeta-y-4", "printed.alone-d-y-3", "printed.alone-d-x-1"),
        "An entry of a min is the sum of the bounds that several steps need, and so bounds none "
        "of them. Each step has its own row and may hold all the same, because another entry is "
        "smaller; `x-term-1-d` does not at r = 1/1000000 with -cos θ₀ = 1/20, but for the factor "
        "r in front of it (`x-term-1-factor`). Once δ_x is repaired, the steps do need what is "
        "alone in entry 3 of ζ̄ (at r = 3/100, say)."),
)  # fmt: skip
