"""What the step needs to know of the constants of Theorem 1, and that it knows it.

The step, `verify/paper/step.toml`, holds for all numbers that satisfy the givens of its context
`parameters`. Each of these is a row of the theorem, the definition of a constant, or follows from
such rows.
"""

from __future__ import annotations

from collections.abc import Mapping

from verify.language.statement import NEEDED, Applies, Obligation
from verify.language.terms import Claim, Term, equal, symbol
from verify.paper.parameters import HYPOTHESES, REPAIRED, THEOREM, V_0, r

#: The step's name where it is cited, and its context of numbers.
STEP = "step"
CONTEXT = "parameters"

#: The row that the step applies to the constants of the theorem.
COLLAPSE = "collapse"

#: The variables of the context that are the same in both sets of constants, and the others.
COMMON = "r c V_0 delta_theta alpha_0 phi_minus delta_2 C_eta h_4 h_5"
OWN = "V_1 delta_x delta_y x_0 Delta_theta eta_bar zeta_bar d_slope d_const d_bar T_star"

#: Each variable with the term that Theorem 1 has for it.
MEANING: Mapping[str, Term] = {
    **{name: symbol(name) for name in COMMON.split()},
    **{name: symbol(f"{REPAIRED}.{name}") for name in OWN.split()},
}

_gap = MEANING["alpha_0"] - MEANING["phi_minus"]
_decay = 1 - MEANING["C_eta"]
#: What the step needs of the constants and is neither a row nor a definition.
BETWEEN: Mapping[str, Claim] = {
    "V_1-positive": 0 < MEANING["V_1"],
    "decay-positive": 0 < _decay,
    "decay-speed-positive": 0 < V_0 * _decay,
    "gap-square-positive": 0 < (_gap - MEANING["delta_y"]) ** 2,
    "r-product": equal(r, MEANING["phi_minus"] * _gap),
}

#: The constants that givens define.
DEFINED = {
    "alpha": MEANING["alpha_0"].name,
    "same-delta": MEANING["delta_y"].name,
    "d_bar-least": MEANING["d_bar"].name,
}

_NAMES = """
    r-positive r-below-one angle-obtuse angle-real
    V_0-positive V_1-above-V_0 phi-positive gap-positive alpha-positive delta_2-positive
    C_eta-positive C_eta-below-one h_4-positive h_4-below-one h_5-positive delta_x-positive
    x_0-positive Delta_theta-positive eta_bar-positive zeta_bar-positive d_slope-positive
    d_const-positive
    V_1-positive decay-positive decay-speed-positive gap-square-positive
    alpha r-product same-delta d_bar-least
    x_0-entry-1 d_const-entry-1 d_const-entry-3 d_const-entry-4 set-eta_c set-eta_s phi-below-half
    init-Cnd3 init-Cnd4 eta-below-one tau-small d-below-one Cnd5-upper eta-contraction zeta-root
    zeta-denominator zeta-dropped-factor zeta-total obtuse CndT x-term-1-d x-term-1-zeta
    x-contraction y-ratio y-term-1 y-term-2-d y-term-2-zeta y-term-3 y-term-4 final-angle
    collapse-time"""
#: The givens of the context, in its order.
GIVENS = tuple(_NAMES.split())

#: Those of them that are hypotheses of the theorem.
ROWS_OF_HYPOTHESES = ("r-positive", "r-below-one", "angle-obtuse", "angle-real")


def row_names() -> dict[str, str]:
    """The row of the theorem that each given is, if it is one."""
    rows = [name for name in GIVENS if name not in BETWEEN and name not in DEFINED]
    groups = dict.fromkeys(ROWS_OF_HYPOTHESES, HYPOTHESES)
    return {name: f"{groups.get(name, REPAIRED)}.{name}" for name in rows}


def collapse(group: str) -> Obligation:
    """The row of a theorem that cites the step: its constants satisfy all that the step needs."""
    return Obligation(COLLAPSE, group, THEOREM, NEEDED,
                      "the constants satisfy what the step needs: from each datum of the set the "
                      "particles collapse", Applies(f"{STEP}:{CONTEXT}", MEANING))  # fmt: skip
