"""Gaps and slips of wording of the printed proof that have no inequality to decide."""

from __future__ import annotations

from verify.language.record import Record
from verify.paper.initial_data import D_0, ETA, X_0
from verify.paper.parameters import THEOREM
from verify.paper.recursion import X_LINK


class Remark(Record):
    r"""A sentence about the text near one of the paper's ``\label``s."""

    label: str
    text: str


REMARKS = (
    Remark(THEOREM,
        "δ₄ is defined by an equation with two positive roots, and so is δ₅; the smaller is "
        "meant."),
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
