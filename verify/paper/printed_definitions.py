"""The definitions of the constants, read from the paper a second time, as the paper prints them.

Each line has the label, the constant and the paper's equation for it. The program may write a
constant in another form: with that form in the place of its name the equation must still hold.
This is tested with rational numbers in the place of all names, chosen so that the roots which
matter are rational. Numbers can show only that two readings differ; that they are the same is
proved in `tests/paper/test_printed_definitions.py`.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from fractions import Fraction
from math import isqrt

from verify.language.errors import OwnError
from verify.language.fold import RATIONAL, MissingOperationError, fold
from verify.language.record import Record
from verify.language.statement import Constant
from verify.language.terms import (
    Claim,
    Term,
    equal,
    minimum,
    sqrt,
    substitute,
    substitute_claim,
    symbol,
)
from verify.paper.parameters import PRINTED, THEOREM, V_0, c, delta_theta, r


class AsPrinted(Record):
    """The paper's equation for a constant, and the label where it stands or that is nearest."""

    label: str
    constant: Term
    printed: Claim


alpha_0, phi_minus, phi_plus, C_eta, h_4, h_5, V_1 = map(
    symbol, ("alpha_0", "phi_minus", "phi_plus", "C_eta", "h_4", "h_5", "V_1")
)
delta_1, delta_2, delta_3, delta_4, delta_5 = (symbol(f"delta_{i}") for i in range(1, 6))
delta_x, delta_y, x_0, Delta_theta, eta_bar, zeta_bar, d_bar, d_const, d_slope, T_star = (
    symbol(f"{PRINTED}.{name}")
    for name in (
        *("delta_x", "delta_y", "x_0", "Delta_theta", "eta_bar", "zeta_bar"),
        *("d_bar", "d_const", "d_slope", "T_star"),
    )
)
half = Fraction(1, 2)
root_2, root_V_1 = sqrt(2), sqrt(V_1)

DEFINITIONS = (
    AsPrinted(THEOREM, alpha_0, equal(alpha_0, (1 + r) / 2 * c)),
    AsPrinted(THEOREM, phi_minus, equal(phi_minus, (alpha_0 - sqrt(alpha_0**2 - 4 * r)) / 2)),
    AsPrinted(THEOREM, phi_plus, equal(phi_plus, (alpha_0 + sqrt(alpha_0**2 - 4 * r)) / 2)),
    AsPrinted(THEOREM, delta_1, equal(delta_1, alpha_0 / 2 - phi_minus)),
    AsPrinted(THEOREM, delta_2, equal(delta_2, half * (alpha_0 - phi_minus))),
    AsPrinted(THEOREM, delta_3, equal(delta_3, half * (1 - (alpha_0 - phi_minus)))),
    AsPrinted("EQUATSS4.1Quantite_C_eta_", C_eta, equal(C_eta, 1 - delta_3)),
    AsPrinted("EQUATSS4.1DerivFonctF_1P-", h_4,
        equal(h_4, half * (1 - r / (alpha_0 - phi_minus) ** 2))),
    AsPrinted(THEOREM, delta_4, equal(r / (alpha_0 - (phi_minus + delta_4)) ** 2, 1 - h_4)),
    AsPrinted("EQUATSS4.1ThExiCondiTheta", h_5,
        equal(h_5, half * (1 - phi_minus / (alpha_0 - phi_minus) ** 2))),
    AsPrinted(THEOREM, delta_5, equal(phi_minus / (alpha_0 - (phi_minus + delta_5)) ** 2, 1 - h_5)),
    AsPrinted("EQUATSS4.1Recurrence_Cnd5", V_1, equal(V_1 / V_0, (1 - h_5 / 2) / (1 - h_5))),
    AsPrinted("EQUATSS4.1DefinDeltxDelty", delta_x,
        equal(delta_x, minimum(delta_1, delta_2, delta_3, delta_4, delta_5))),
    AsPrinted("EQUATSS4.1DefinDeltxDelty", delta_y, equal(delta_x, delta_y)),
    AsPrinted("EQUATSS4.1DescrDoIniColla", x_0,
        equal(x_0, minimum((1 - h_4) * delta_x, V_0 / V_1 * (delta_2**2 * h_5 / 12)))),
    AsPrinted("EQUATSS4.1DescrDoIniColla", Delta_theta,  # |cos θ₀|/2, and -cos θ₀ > 0
        equal(Delta_theta, minimum(c / 2, h_4 / 8 * delta_x, delta_theta))),
    AsPrinted("EQUATSS4.1DefinBorne_Eta_", eta_bar,
        equal(eta_bar, minimum(
            1,
            (root_2 - 1) / 16 * (V_0 / root_V_1),
            V_0 / (33 * root_V_1) * Delta_theta,
            (1 - C_eta) * (V_1 - V_0) / (12 * (root_V_1 + 2)),
            V_0 / root_V_1
            * (2 / (15 * alpha_0) + h_4 * delta_2 / 6 + h_4 / (12 * alpha_0) + h_4 / 24)
            * delta_x))),
    AsPrinted("EQUATSS4.1DefinBorne_Zeta", zeta_bar,
        equal(zeta_bar, minimum(
            2 * (root_2 - 1),
            V_0 * h_5 / (3 * V_1 * (alpha_0 + 8 * V_1 / V_0)) * delta_2**2,
            Fraction(1, 16) * (1 + 4 * delta_2 + V_0 / V_1) * h_4 * delta_x))),
    AsPrinted("EQUATSS4.1DefinBorne_d_0_", d_bar,  # at |η_{c,0}| = η̄
        equal(d_bar, minimum(
            (root_2 - 1) / 4,
            Delta_theta / 3,
            Fraction(1, 5) * (1 + delta_2 * h_4) * delta_x,
            Fraction(1, 4) * (1 + 2 * delta_2) * h_4 * delta_x,
            zeta_bar / (2 * V_1) * eta_bar**2))),
)  # fmt: skip

#: Parts of the paper's d̄ that have a name here only, and a bound that the paper leaves out.
PARTS_OF_D_BAR = (d_const, d_slope)
NOT_IN_THE_PAPER = (*PARTS_OF_D_BAR, T_star)

#: Numbers for the names: α₀²-4r, r/(1-h₄), φ⁻/(1-h₅) and V₁ are squares; the rest has no meaning.
NUMBERS = {
    r: "3/100", c: "2/7", V_0: "5/3", delta_theta: "11/13", alpha_0: "19/40", phi_minus: "3/40",
    phi_plus: "23/47", delta_1: "29/31", delta_2: "37/41", delta_3: "43/53", delta_4: "59/61",
    delta_5: "67/71", C_eta: "73/79", h_4: "1/4", h_5: "7/10", V_1: "9/4", delta_x: "83/89",
    delta_y: "97/101", x_0: "103/107", Delta_theta: "109/113", eta_bar: "127/131",
    zeta_bar: "137/139", d_bar: "149/151",
}  # fmt: skip

#: How the parameters are written.
LETTERS = {"c": "(-cos θ₀)", "V_0": "V₀", "delta_theta": "δ_θ"}


def check_definitions(constants: Iterable[Constant]) -> None:
    """Nothing, if the constants are the paper's as far as numbers can tell.

    Raises:
        OwnError: if one is not; with its letter, its label and both readings.
    """
    for complaint in complaints({constant.name: constant for constant in constants}):
        raise OwnError(complaint)


def complaints(constants: Mapping[str, Constant]) -> Iterator[str]:
    """What is wrong with the constants, in the paper's order."""
    at = {term: Fraction(number) for term, number in NUMBERS.items()}
    parts = {part.name: constants[part.name].term for part in PARTS_OF_D_BAR}
    for label, constant, printed in DEFINITIONS:
        own = constants[constant.name]
        term = substitute(own.term, parts)
        if own.label != label:
            yield f"{own.letter} belongs to {label} in the paper, and to {own.label} here"
        elif not _holds(substitute_claim(printed, {constant.name: term}), at):
            from verify.language.typeset import Typesetter  # loaded only where it is used

            write = Typesetter(LETTERS | {name: known.letter for name, known in constants.items()})
            yield (
                f"{own.letter} ({label}) is not the paper's: the paper has "
                f"{write.claim(printed)}, and this program has {write.claim(equal(constant, term))}"
            )


def _holds(claim: Claim, at: Mapping[Term, Fraction]) -> bool:
    """Whether both sides are the same; not with a name, an operation or a pole of its own."""
    try:
        return _numbers(claim.lhs, at) == _numbers(claim.rhs, at)
    except (MissingOperationError, ZeroDivisionError):
        return False


def _numbers(term: Term, at: Mapping[Term, Fraction]) -> list[Fraction]:
    """The number that a term is, or those that are the entries of a minimum."""
    if term.op == "min":
        return [number for entry in term.children for number in _numbers(entry, at)]
    return [fold(term, _ALGEBRA, dict(at))]


def _root(number: Fraction) -> Fraction:
    """The root; where it is not rational another number for it, the same one each time."""
    root = Fraction(isqrt(abs(number.numerator)), isqrt(number.denominator))
    return root if root**2 == number else number + half


_ALGEBRA = {**RATIONAL, "sqrt": _root}
