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
from verify.paper.parameters import THEOREM, V_0, c, delta_theta, r
from verify.paper.rows import SLIP, misprint, needed

RESTITUTION = "EQUATSS4.1ThExiCondi_r_1_"
ANGLE = "EQUATSS4.1ThExiCondiTheta"

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
            "-cos θ₀ < 2r^(1/3)(1+r^(1/3))/(1+r), as printed (all other rows are judged outside "
            "it)", _alpha**3 < 3 * r * _alpha + r * (1 + r),
            group=HYPOTHESES, severity=SLIP, corrected_by=f"{HYPOTHESES}.stability"),
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
