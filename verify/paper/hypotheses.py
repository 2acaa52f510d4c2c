"""The hypotheses of `THEORSS4.1ExistenCollapse`, and the observations at the start of its proof.

The hypotheses stand here as printed and as the construction needs them. With s = r^(1/3), the
threshold 2s(1+s)/(1+r) of `EQUATSS4.1ThExiCondiTheta` is met by c exactly when
x = alpha_0 = (1+r)c/2 equals s + s^2, and

    x^3 - 3rx - r(1+r) = (x - s - s^2) (x^2 + (s + s^2) x + s^2 - s^3 + s^4),

whose second factor is positive for s, x > 0. So a comparison of c with the threshold is the sign
of a polynomial in r and c, and no root is taken. Likewise r < 9 - 4 sqrt(5) is
r^2 - 18r + 1 > 0, because r < 1 lies below the other root 9 + 4 sqrt(5).

The observations are the signs and orders of the first constants.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from verify.language.statement import Obligation
from verify.language.terms import Claim, as_term, sqrt
from verify.paper.initial_data import (
    C_eta,
    ConstantSet,
    alpha_0,
    delta_1,
    delta_2,
    delta_3,
    delta_4,
    delta_5,
    discriminant,
    gap,
    h_4,
    h_5,
    phi_minus,
    phi_plus,
)
from verify.paper.parameters import HYPOTHESES, THEOREM, V_0, c, delta_theta, r
from verify.paper.rows import OTHERWISE, REMARK, SLIP, misprint, needed

RESTITUTION = "EQUATSS4.1ThExiCondi_r_1_"
ANGLE = "EQUATSS4.1ThExiCondiTheta"
STABLE = "EQUATSS4.1DerivFonctF_1P-"
C_ETA = "EQUATSS4.1Quantite_C_eta_"

_alpha = (1 + r) / 2 * c


def hypotheses() -> Iterator[Obligation]:
    """Yield the hypotheses, each with its role."""
    yield from (
        # 0 < r < r_stabi = 9 - 4√5 (`EQUATSS4.1ThExiCondi_r_1_`).
        _needed("r-positive",    RESTITUTION, "0 < r", 0 < r),
        _needed("r-below-one",   RESTITUTION, "r < 1", r < 1),
        _needed("r-below-stabi", RESTITUTION, "r < r_stabi = 9 - 4√5", 18 * r - r**2 < as_term(1)),
        # 0 < -cos θ₀ < 2r^(1/3)(1+r^(1/3))/(1+r), as printed (`EQUATSS4.1ThExiCondiTheta`). The
        # construction needs > (as in `EQUATSS3.4ZKCl2CondiStabi`), so the two exclude each other:
        # wherever the constants exist, the printed hypothesis does not hold.
        _needed("angle-obtuse",  ANGLE, "0 < -cos θ₀", 0 < c),
        _needed("angle-real",    ANGLE, "-cos θ₀ ≤ 1", c <= 1),
        misprint(f"{HYPOTHESES}.angle-as-printed", ANGLE,
            "this point satisfies -cos θ₀ < 2r^(1/3)(1+r^(1/3))/(1+r), the hypothesis as printed; "
            "where it does not, all other rows are judged outside it",
            _alpha**3 < 3 * r * _alpha + r * (1 + r),
            group=HYPOTHESES, severity=REMARK, corrected_by=f"{HYPOTHESES}.stability"),
        _needed("existence",     "EQUATSS3.4ZKCl1CondiExist",
            "-cos θ₀ > 4√r/(1+r): the fixed points φ⁻ < φ⁺ exist", 4 * r < _alpha**2),
        _needed("stability",     ANGLE,
            "-cos θ₀ > 2r^(1/3)(1+r^(1/3))/(1+r), as the construction needs it",
            3 * r * _alpha + r * (1 + r) < _alpha**3),
        # The other two parameters.
        _needed("V_0-positive",         "EQUATSS4.1Recurrence_Cnd5", "0 < V₀", 0 < V_0),
        _needed("delta-theta-positive", THEOREM, "0 < δ_θ", 0 < delta_theta),
    )  # fmt: skip


def _needed(name: str, label: str, says: str, claim: Claim) -> Obligation:
    return needed(f"{HYPOTHESES}.{name}", label, says, claim, group=HYPOTHESES)


# --- observations ---------------------------------------------------------------------------------


def observations(k: ConstantSet) -> Iterator[Obligation]:
    """Yield the rows on alpha_0, the fixed points, delta_1 to delta_5, C_eta, h_4 and h_5."""
    yield from _fixed_points(k)
    yield from _stability(k)
    yield from _second_ratio(k)
    yield k.row("V_0-positive", "EQUATSS4.1Recurrence_Cnd5", "0 < V₀", 0 < V_0)


def _fixed_points(k: ConstantSet) -> Iterator[Obligation]:
    """α₀ and the two fixed points."""
    root = (alpha_0 - sqrt(discriminant)) / 2
    yield from (
        # α₀ = ((1+r)/2)(-cos θ₀), positive and smaller than 1.
        k.row("alpha-positive",  THEOREM, "α₀ is positive", 0 < alpha_0),
        k.row("alpha-below-one", THEOREM, "α₀ is smaller than 1", alpha_0 < 1),
        # `EQUATSS4.1ThExiCondi_r_1_` ensures that F₁: φ ↦ r/(α₀-φ) has two positive fixed points.
        # At r = 1/20 < r_stabi and c = 1/2, which satisfy the printed hypotheses, it has none:
        # alpha_0^2 = (21/80)^2 is below 4r = 1/5.
        *k.misprint("r_stabi-gives-fixed-points", RESTITUTION, "r < r_stabi ensures the two fixed "
            "points: at r = 1/20, -cos θ₀ = 1/2 (with >, they exist: the condition on the angle "
            "ensures them)", as_term(Fraction(1, 5)) < as_term(Fraction(21, 80)) ** 2, OTHERWISE,
            "fixed-points-exist"),
        k.row("fixed-points-exist",               RESTITUTION,
            "F₁ has two fixed points: α₀² > 4r (from the angle, not from r < r_stabi)",
            4 * r < alpha_0**2),
        # φ^± are the two positive fixed points of F₁: φ ↦ r/(α₀-φ).
        k.row("phi-positive",   THEOREM, "φ⁻ is positive", 0 < phi_minus),
        k.row("phi-ordered",    THEOREM, "φ⁻ is the smaller one", phi_minus < phi_plus),
        k.row("phi-below-pole", THEOREM, "F₁ is defined at φ⁺: φ⁺ < α₀", phi_plus < alpha_0),
        k.row("phi-minus-fixed-upper", THEOREM, "φ⁻ is a fixed point of F₁, one half",
            r / (alpha_0 - phi_minus) <= phi_minus),
        k.row("phi-minus-fixed-lower", THEOREM, "φ⁻ is a fixed point of F₁, other half",
            phi_minus <= r / (alpha_0 - phi_minus)),
        k.row("phi-plus-fixed-upper", THEOREM, "φ⁺ is a fixed point of F₁, one half",
            r / (alpha_0 - phi_plus) <= phi_plus),
        k.row("phi-plus-fixed-lower", THEOREM, "φ⁺ is a fixed point of F₁, other half",
            phi_plus <= r / (alpha_0 - phi_plus)),
        # φ^± = (α₀ ± √(α₀²-4r))/2.
        k.row("phi-form-upper", THEOREM, "φ⁻ = (α₀-√(α₀²-4r))/2, one half", phi_minus <= root),
        k.row("phi-form-lower", THEOREM, "φ⁻ = (α₀-√(α₀²-4r))/2, other half", root <= phi_minus),
    )  # fmt: skip


def _stability(k: ConstantSet) -> Iterator[Obligation]:
    """Which fixed point is stable, and the first constants."""
    slope = r / (alpha_0 - phi_minus) ** 2
    at_delta_4 = r / (alpha_0 - (phi_minus + delta_4)) ** 2
    yield from (
        # Only φ⁻ is stable: |F₁'(φ⁻)| = r/(α₀-φ⁻)² < 1 (`EQUATSS4.1DerivFonctF_1P-`).
        k.row("phi-minus-stable",                STABLE, "φ⁻ is stable: |F₁'(φ⁻)| < 1", slope < 1),
        k.row("phi-plus-unstable",               STABLE, "only φ⁻ is stable: |F₁'(φ⁺)| > 1",
            1 < r / (alpha_0 - phi_plus) ** 2),
        *k.misprint("phi-minus-called-unstable", "EQUATSS4.1Recurrence_Cnd9",
            "the wording 'the unstable fixed point φ⁻': |F₁'(φ⁻)| > 1", 1 < slope, SLIP,
            "phi-minus-stable"),
        # φ⁻ < α₀/2 and -1 < φ⁻-α₀ < 0; hence δ₁, δ₂, δ₃ are positive and 0 < C_η < 1.
        k.row("phi-below-half",   THEOREM, "φ⁻ < α₀/2 by definition", phi_minus < alpha_0 / 2),
        k.row("delta_1-positive", THEOREM, "0 < δ₁", 0 < delta_1),
        k.row("gap-below-one",    THEOREM, "-1 < φ⁻ - α₀", -1 < phi_minus - alpha_0),
        k.row("gap-positive",     THEOREM, "φ⁻ - α₀ < 0", phi_minus - alpha_0 < 0),
        k.row("delta_2-positive", THEOREM, "0 < δ₂", 0 < delta_2),
        k.row("delta_3-positive", THEOREM, "0 < δ₃", 0 < delta_3),
        k.row("C_eta-positive",   C_ETA, "0 < C_η", 0 < C_eta),
        k.row("C_eta-below-one",  C_ETA, "C_η < 1", C_eta < 1),
        # h₄ = (1 - r/(α₀-φ⁻)²)/2 > 0, and δ₄ > 0 with r/(α₀-(φ⁻+δ₄))² = 1-h₄.
        k.row("h_4-positive",      STABLE, "0 < h₄", 0 < h_4),
        k.row("h_4-below-one",     STABLE, "h₄ < 1", h_4 < 1),
        k.row("delta_4-positive",  STABLE, "0 < δ₄", 0 < delta_4),
        k.row("delta_4-below-gap", STABLE, "δ₄ < α₀ - φ⁻", delta_4 < gap),
        k.row("delta_4-upper",     STABLE, "the equation of δ₄, one half", at_delta_4 <= 1 - h_4),
        k.row("delta_4-lower",     STABLE, "the equation of δ₄, other half", 1 - h_4 <= at_delta_4),
    )  # fmt: skip


def _second_ratio(k: ConstantSet) -> Iterator[Obligation]:
    """The second assumption, and h₅."""
    ratio = phi_minus / gap**2
    at_delta_5 = phi_minus / (alpha_0 - (phi_minus + delta_5)) ** 2
    yield from (
        # `EQUATSS4.1ThExiCondiTheta` ensures that φ⁻/(α₀-φ⁻)² lies between 0 and 1.
        # r = 1/60, c = 38/61 satisfy the hypothesis as printed; then alpha_0 = 19/60, the fixed
        # points are 1/15 and 1/4, and phi_minus / (alpha_0 - phi_minus)^2 = 16/15.
        *k.misprint("second-assumption-as-printed", ANGLE, "-cos θ₀ < 2r^(1/3)(1+r^(1/3))/(1+r) "
            "ensures φ⁻/(α₀-φ⁻)² < 1: at r = 1/60, -cos θ₀ = 38/61",
            as_term(Fraction(1, 15)) / as_term(Fraction(1, 4)) ** 2 < 1, SLIP, "second-ratio"),
        k.row("second-ratio-positive",              ANGLE, "φ⁻/(α₀-φ⁻)² is positive", 0 < ratio),
        k.row("second-ratio", ANGLE, "φ⁻/(α₀-φ⁻)² is strictly smaller than 1", ratio < 1),
        # h₅ = (1 - φ⁻/(α₀-φ⁻)²)/2 > 0, and δ₅ > 0 with φ⁻/(α₀-(φ⁻+δ₅))² = 1-h₅.
        k.row("h_5-positive",      ANGLE, "0 < h₅", 0 < h_5),
        k.row("h_5-below-one",     ANGLE, "h₅ < 1", h_5 < 1),
        k.row("delta_5-positive",  ANGLE, "0 < δ₅", 0 < delta_5),
        k.row("delta_5-below-gap", ANGLE, "δ₅ < α₀ - φ⁻", delta_5 < gap),
        k.row("delta_5-upper",     ANGLE, "the equation of δ₅, one half", at_delta_5 <= 1 - h_5),
        k.row("delta_5-lower",     ANGLE, "the equation of δ₅, other half", 1 - h_5 <= at_delta_5),
    )  # fmt: skip
