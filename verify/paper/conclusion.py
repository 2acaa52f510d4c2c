"""The conclusion: infinitely many collisions, in finite time, with the announced final angle."""

from __future__ import annotations

from collections.abc import Iterator

from verify.language.statement import Obligation
from verify.language.terms import sqrt
from verify.paper.initial_data import ConstantSet
from verify.paper.parameters import THEOREM, V_0, delta_theta, r
from verify.paper.preliminaries import C_eta
from verify.paper.rows import BREAKS


def rows(k: ConstantSet) -> Iterator[Obligation]:
    """Yield what the theorem claims beyond the recursion; the paper leaves these steps out."""
    yield from (
        k.row("eta_s-stays-positive",    THEOREM,
            "η_{s,n+1} ≥ r√(1-ζ̄)(-η_{c,n}) > 0: the pair that just met separates",
            0 < r * sqrt(1 - k.zeta_bar), ["law-eta-s", "collision-map"]),
        k.row("distance-stays-positive", THEOREM,
            "the set leaves room for d₀ > 0, which the model asks for, and then d_{n+1} > 0",
            0 < k.d_bar, ["distance", "law-eta-s", "time", "induction"]),
        k.row("final-angle",             THEOREM,
            "|(-cos θ̄) - (-cos θ₀)| ≤ δ_θ for the final angle", k.drift <= delta_theta,
            ["angle-step", "induction"], if_false=BREAKS),
        k.row("collapse-time",           THEOREM,
            "the collapse time Σ τ_n ≤ 2η̄ζ̄/(V₀(1-C_η)) ≤ T* is finite",
            2 / (V_0 * (1 - C_eta)) * k.eta_bar * k.zeta_bar <= k.T_star,
            ["time", "induction", "collision-map", "collision-map-roles"]),
    )  # fmt: skip
