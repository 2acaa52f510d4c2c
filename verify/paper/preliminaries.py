"""The first constants: alpha_0, the fixed points, delta_1 to delta_5, C_eta, h_4, h_5, V_1.

All but V_1 = V_1(V_0, h_5) depend on r and c alone.
"""

from __future__ import annotations

from verify.language.statement import Constant
from verify.language.terms import sqrt, symbol
from verify.paper.parameters import THEOREM, V_0, c, r

alpha_0 = symbol("alpha_0")
phi_minus = symbol("phi_minus")
phi_plus = symbol("phi_plus")
delta_1 = symbol("delta_1")
delta_2 = symbol("delta_2")
delta_3 = symbol("delta_3")
delta_4 = symbol("delta_4")
delta_5 = symbol("delta_5")
C_eta = symbol("C_eta")
h_4 = symbol("h_4")
h_5 = symbol("h_5")
V_1 = symbol("V_1")

discriminant = alpha_0**2 - 4 * r

#: What the paper writes ``alpha_0 - phi_minus``; it is also the larger fixed point.
gap = alpha_0 - phi_minus

CONSTANTS = (
    Constant("alpha_0", "α₀", r"\alpha_0", THEOREM, (1 + r) / 2 * c),
    # (alpha_0 - sqrt(discriminant))/2 cancels as r -> 0; a row shows that the two forms agree.
    Constant("phi_minus", "φ⁻", r"\varphi^-", THEOREM, 2 * r / (alpha_0 + sqrt(discriminant))),
    Constant("phi_plus", "φ⁺", r"\varphi^+", THEOREM, (alpha_0 + sqrt(discriminant)) / 2),
    Constant("delta_1", "δ₁", r"\delta_1", THEOREM, alpha_0 / 2 - phi_minus),
    Constant("delta_2", "δ₂", r"\delta_2", THEOREM, gap / 2),
    Constant("delta_3", "δ₃", r"\delta_3", THEOREM, (1 - gap) / 2),
    Constant("C_eta", "C_η", r"C_\eta", "EQUATSS4.1Quantite_C_eta_", 1 - delta_3),
    Constant("h_4", "h₄", "h_4", "EQUATSS4.1DerivFonctF_1P-", (1 - r / gap**2) / 2),
    # The solution of r / (alpha_0 - (phi_minus + delta_4))^2 = 1 - h_4; likewise delta_5.
    Constant("delta_4", "δ₄", r"\delta_4", THEOREM, gap - sqrt(r / (1 - h_4))),
    Constant("h_5", "h₅", "h_5", "EQUATSS4.1ThExiCondiTheta", (1 - phi_minus / gap**2) / 2),
    Constant("delta_5", "δ₅", r"\delta_5", THEOREM, gap - sqrt(phi_minus / (1 - h_5))),
    Constant("V_1", "V₁", "V_1", "EQUATSS4.1Recurrence_Cnd5", V_0 * ((1 - h_5 / 2) / (1 - h_5))),
)
