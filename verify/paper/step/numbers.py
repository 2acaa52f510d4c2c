"""The numbers of the theorem as variables, and what the step needs to know of them.

Each given is a row of the hypotheses or of the repaired set, word for word, a sign that follows
from these rows, or a definition; so the step holds for the
constants of that set, rounded or not, and for any others that satisfy these rows.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from verify.language.statement import NEEDED, Applies, Context, Given, Obligation, Variable
from verify.language.terms import (
    Claim,
    Term,
    as_term,
    equal,
    minimum,
    sqrt,
    substitute_claim,
    symbol,
)
from verify.paper.initial_data import ConstantSet
from verify.paper.parameters import HYPOTHESES, REPAIRED, THEOREM
from verify.paper.theorem1 import theorem

#: The step's name where it is cited, and its context of numbers.
STEP = "step"
CONTEXT = "parameters"

#: The row that the step applies to the constants of the theorem.
COLLAPSE = "collapse"

#: Theorem 1 at r = 3/100 and c = 95/103, where the fixed points are rational, V_0 = 1 and
#: delta_theta = 1/10.
POINT = {
    "r": "3/100",
    "c": "95/103",
    "V_0": "1",
    "delta_theta": "1/10",
    "alpha_0": "19/40",
    "phi_minus": "3/40",
    "delta_2": "1/5",
    "C_eta": "7/10",
    "h_4": "13/32",
    "h_5": "17/64",
    "V_1": "59/50",
    "delta_x": "3/4000",
    "delta_y": "3/4000",
    "x_0": "89/200000",
    "Delta_theta": "19/500000",
    "eta_bar": "187/500000000",
    "zeta_bar": "19/1250000",
    "d_slope": "161/25000000",
    "d_const": "19/2000000",
    "d_bar": "5630009/6250000000000000000000000",
    "T_star": "379/10000000000000",
}

#: The letters of the parameters.
LETTERS = {
    "r": ("r", "r"),
    "c": ("c", "c"),
    "V_0": ("V₀", "V_0"),
    "delta_theta": ("δ_θ", r"\delta_\theta"),
}

#: Those that are the same in both sets of constants.
COMMON = ("r", "c", "V_0", "delta_theta", "alpha_0", "phi_minus", "delta_2", "C_eta", "h_4", "h_5")

#: Each variable with the term that Theorem 1 has for it.
MEANING: Mapping[str, Term] = {
    name: symbol(name if name in COMMON else f"{REPAIRED}.{name}") for name in POINT
}

(
    r, c, V_0, delta_theta, alpha_0, phi_minus, delta_2, C_eta, h_4, h_5, V_1, delta_x, delta_y,
    x_0, Delta_theta, eta_bar, zeta_bar, d_slope, d_const, d_bar, T_star,
) = map(symbol, MEANING)  # fmt: skip
gap = alpha_0 - phi_minus
speed = sqrt(V_1)
share = h_4 * delta_x
eighth = share / 8
third = (V_1 - V_0) / 3
#: What the constant set says of its own symbols, said of the variables here.
_RENAMED = {term.name: symbol(name) for name, term in MEANING.items()}

#: Signs that show that quotients and roots in rows have a value.
SIGNS = {
    "V_1-positive": 0 < V_1,
    "decay-positive": 0 < 1 - C_eta,
    "decay-speed-positive": 0 < V_0 * (1 - C_eta),
    "gap-square-positive": 0 < (gap - delta_y) ** 2,
}

#: What defines constants, and r = phi_minus phi_plus, for phi_plus = alpha_0 - phi_minus.
DEFINITIONS = {
    "alpha": equal(alpha_0, (1 + r) / 2 * c),
    "r-product": equal(r, phi_minus * gap),
    "same-delta": equal(delta_y, delta_x),
    "d_bar-least": equal(d_bar, minimum(d_const, d_slope * eta_bar**2)),
}

#: Rows of the theorem that are used; quotients come after the signs of their divisors.
ROWS_OF_HYPOTHESES = ("r-positive", "r-below-one", "angle-obtuse", "angle-real")
SIMPLE_ROWS = (
    "V_0-positive", "V_1-above-V_0", "phi-positive", "gap-positive", "alpha-positive",
    "delta_2-positive", "C_eta-positive", "C_eta-below-one", "h_4-positive", "h_4-below-one",
    "h_5-positive", "delta_x-positive", "x_0-positive", "Delta_theta-positive", "eta_bar-positive",
    "zeta_bar-positive", "d_slope-positive", "d_const-positive",
)  # fmt: skip
ROWS = (
    "x_0-entry-1", "d_const-entry-1", "d_const-entry-3", "d_const-entry-4", "set-eta_c",
    "set-eta_s", "phi-below-half", "init-Cnd3", "init-Cnd4", "eta-below-one", "tau-small",
    "d-below-one", "Cnd5-upper", "eta-contraction", "zeta-root", "zeta-denominator",
    "zeta-dropped-factor", "zeta-total", "obtuse", "CndT", "x-term-1-d", "x-term-1-zeta",
    "x-contraction", "y-ratio", "y-term-1", "y-term-2-d", "y-term-2-zeta", "y-term-3", "y-term-4",
    "final-angle", "collapse-time",
)  # fmt: skip


def row_names() -> dict[str, str]:
    """The name that each given row has in the theorem."""
    hypotheses = {name: f"{HYPOTHESES}.{name}" for name in ROWS_OF_HYPOTHESES}
    return hypotheses | {name: f"{REPAIRED}.{name}" for name in (*SIMPLE_ROWS, *ROWS)}


#: The definitions among the givens, by the names that the constants have in the theorem.
DEFINED = {
    "alpha": MEANING["alpha_0"].name,
    "same-delta": MEANING["delta_y"].name,
    "d_bar-least": MEANING["d_bar"].name,
}
#: What the step needs and is no row, about the constants of the theorem.
BETWEEN = {
    name: substitute_claim(claim, MEANING)
    for name, claim in (SIGNS | DEFINITIONS).items()
    if name not in DEFINED
}


def renamed(claim: Claim) -> Claim:
    """A claim about the theorem's constants, said of the variables here."""
    return substitute_claim(claim, _RENAMED)


def renamed_term(term: Term) -> Term:
    """A term in the theorem's constants, in the variables here."""
    return renamed(term <= term).lhs


def _claims() -> dict[str, Claim]:
    parts = theorem().parts
    found = {
        row.name: row.claim
        for group in (HYPOTHESES, REPAIRED)
        for row in parts[group].obligations
        if isinstance(row.claim, Claim)
    }
    return {name: renamed(found[full]) for name, full in row_names().items()}


def givens() -> tuple[str, ...]:
    """The names of what the step needs to know of the numbers, in an order that defines them."""
    return (*ROWS_OF_HYPOTHESES, *SIMPLE_ROWS, *SIGNS, *DEFINITIONS, *ROWS)


def collapse(group: str) -> Obligation:
    """The row of a theorem that cites the step: its constants satisfy all that the step needs."""
    return Obligation(COLLAPSE, group, THEOREM, NEEDED,
                      "the constants satisfy what the step needs: from each datum of the set the "
                      "particles collapse", Applies(f"{STEP}:{CONTEXT}", MEANING))  # fmt: skip


def context() -> Context:
    """The numbers of the theorem, with the rows that the step uses."""
    claims = _claims() | SIGNS | DEFINITIONS
    constants = (*theorem().common, *theorem().parts[REPAIRED].bounds)
    letters = LETTERS | {constant.name: (constant.letter, constant.tex) for constant in constants}
    return Context(
        CONTEXT,
        tuple(Variable(name, *letters[term.name]) for name, term in MEANING.items()),
        tuple(Given(name, claims[name]) for name in givens()),
        {name: as_term(Fraction(text)) for name, text in POINT.items()},
        says="numbers that satisfy the rows of the repaired set",
    )


_k = ConstantSet(REPAIRED)
drift = renamed_term(_k.drift)
d_later = renamed_term(_k.d_later)
