"""The hypotheses of `THEORSS4.1ExistenCollapse`, as printed and as the construction needs them.

With s = r^(1/3), the threshold 2s(1+s)/(1+r) of `EQUATSS4.1ThExiCondiTheta` is met by c exactly
when x = alpha_0 = (1+r)c/2 equals s + s^2, and

    x^3 - 3rx - r(1+r) = (x - s - s^2) (x^2 + (s + s^2) x + s^2 - s^3 + s^4),

whose second factor is positive for s, x > 0. So a comparison of c with the threshold is the sign
of a polynomial in r and c, and no root is taken. Likewise r < 9 - 4 sqrt(5) is
r^2 - 18r + 1 > 0, because r < 1 lies below the other root 9 + 4 sqrt(5).
"""

from __future__ import annotations

from collections.abc import Iterator

from verify.language.statement import Obligation
from verify.language.terms import Claim, as_term
from verify.paper.groups import HYPOTHESES
from verify.paper.parameters import V_0, c, delta_theta, r

RESTITUTION = "EQUATSS4.1ThExiCondi_r_1_"
ANGLE = "EQUATSS4.1ThExiCondiTheta"

_alpha = (1 + r) / 2 * c


def hypotheses() -> Iterator[Obligation]:
    """Yield the hypotheses, each with its role."""

    def hypothesis(
        name: str,
        label: str,
        role: str,
        says: str,
        claim: Claim,
        corrected_by: str | None = None,
    ) -> Obligation:
        full = f"{HYPOTHESES}.{name}"
        return Obligation(full, HYPOTHESES, label, role, says, claim, (), corrected_by)

    yield hypothesis("r-positive", RESTITUTION, "needed", "0 < r", 0 < r)
    yield hypothesis("r-below-one", RESTITUTION, "needed", "r < 1", r < 1)
    yield hypothesis(
        "r-below-stabi", RESTITUTION, "needed", "r < r_stabi = 9 - 4√5", 18 * r - r**2 < as_term(1)
    )
    yield hypothesis("angle-obtuse", ANGLE, "needed", "0 < -cos θ₀", 0 < c)
    yield hypothesis("angle-real", ANGLE, "needed", "-cos θ₀ ≤ 1", c <= 1)
    yield hypothesis(
        "angle-as-printed",
        ANGLE,
        "printed",
        "-cos θ₀ < 2r^(1/3)(1+r^(1/3))/(1+r), as printed",
        _alpha**3 < 3 * r * _alpha + r * (1 + r),
        f"{HYPOTHESES}.stability",
    )
    yield hypothesis(
        "existence",
        "EQUATSS3.4ZKCl1CondiExist",
        "needed",
        "-cos θ₀ > 4√r/(1+r): the fixed points φ⁻ < φ⁺ exist",
        4 * r < _alpha**2,
    )
    yield hypothesis(
        "stability",
        ANGLE,
        "needed",
        "-cos θ₀ > 2r^(1/3)(1+r^(1/3))/(1+r), as the construction needs it",
        3 * r * _alpha + r * (1 + r) < _alpha**3,
    )
    yield hypothesis("V_0-positive", "EQUATSS4.1Recurrence_Cnd5", "needed", "0 < V₀", 0 < V_0)
    yield hypothesis(
        "delta-theta-positive",
        "THEORSS4.1ExistenCollapse",
        "needed",
        "0 < δ_θ",
        0 < delta_theta,
    )
