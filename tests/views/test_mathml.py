"""Formulas as MathML."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET
from fractions import Fraction

import pytest

from verify.language.statement import Constant
from verify.language.terms import Claim, Term, as_term, cos_pi, equal, minimum, sqrt, symbol
from verify.paper.commands.spectrum import state_spectrum
from verify.paper.theorem1 import theorem
from verify.views.mathml import MathML, letter

a, b, c = map(symbol, "abc")
WRITER = MathML({"eta": r"\overline{\eta}", "phi": r"\varphi^-"})


def read(term: Term) -> str:
    """The letters and signs of a formula in a row, a fraction and a power marked."""
    text = WRITER.term(term).replace("<mfrac>", "[").replace("</mfrac>", "]")
    text = text.replace("<msup>", "{").replace("</msup>", "}")
    return re.sub(r"<[^>]*>", "", text).replace("&#x2062;", "").replace("&#x2061;", "")


@pytest.mark.parametrize(
    ("term", "text"),
    [
        (a + b - c, "a+b−c"),
        (a - (b + c), "a−(b+c)"),
        (a - (b - c), "a−(b−c)"),
        (a * (b + c), "a(b+c)"),
        ((a + b) / (a - b), "[a+ba−b]"),
        ((a + b) ** 2, "{(a+b)2}"),
        ((a / b) ** 2, "{([ab])2}"),
        ((a**2) ** 3, "{({a2})3}"),
        (-(a + b), "−(a+b)"),
        (-(0 - a), "−(0−a)"),
        (a + (-b), "a+(−b)"),
        (a * (-b), "a(−b)"),
        (a * (-b * c), "a(−bc)"),
        (a - as_term(-1), "a−(−1)"),
        (2 * as_term(3), "2⋅3"),
        (2 * as_term(3) ** 2, "2⋅{32}"),
        (2 * a, "2a"),
        (as_term(Fraction(-3, 4)) ** 2, "{(−[34])2}"),
        (minimum(a, b + c), "min(a,b+c)"),
        (sqrt(a - b), "a−b"),
        (cos_pi(Fraction(5, 6)), "cos([56]π)"),
        (symbol("phi"), "{φ−}"),
        (symbol("phi") ** 2, "{({φ−})2}"),
        (symbol("eta") ** 2, "{η¯2}"),
        (symbol("delta_theta"), "δθ"),
        (symbol("x.2.1") - symbol("x.0.1"), "x2,1−x0,1"),
        (symbol("flow:m.0"), "m0"),
        (symbol("reach_2"), "reach2"),
    ],
)
def test_parentheses_and_signs(term: Term, text: str) -> None:
    assert read(term) == text


def test_letters_of_constants() -> None:
    assert letter(r"|x_0|").startswith("<mo")
    assert "<mover>" in letter(r"\overline{\eta}")
    assert "<msqrt>" in letter(r"\sqrt{1-\zeta}")
    assert letter("r^(1/3)") == letter("r^{1/3}")
    assert letter(r"\eta_c'").endswith("<mo>′</mo></msup>")
    for wrong in (r"\alpha & 1", r"\unknown", r"\overline", "x_", "{x", "x}", "x_}"):
        with pytest.raises(ValueError, match=r"letter|brace"):
            letter(wrong)


def test_other_latex_is_left_to_the_name() -> None:
    assert read_with({"a": r"\operatorname{a}"}, a) == "a"


def read_with(letters: dict[str, str], term: Term) -> str:
    return re.sub(r"<[^>]*>", "", MathML(letters).term(term))


def test_letters_of_every_variable() -> None:
    for context in state_spectrum().contexts:
        for variable in context.variables:
            ET.fromstring(f"<p>{letter(variable.tex)}</p>")


def every_constant() -> list[Constant]:
    parts = theorem().parts.values()
    return [*theorem().common, *(constant for part in parts for constant in part.bounds)]


def test_every_formula_of_the_paper_is_well_formed() -> None:
    letters = {constant.name: constant.tex for constant in every_constant()}
    for context in state_spectrum().contexts:
        letters |= {variable.name: variable.tex for variable in context.variables}
        letters |= {constant.name: constant.tex for constant in context.constants}
    writer = MathML(letters | {"c": r"(-\cos\theta_0)"})
    rows = [row for part in theorem().parts.values() for row in part.obligations]
    claims = [row.claim for row in (*rows, *state_spectrum().obligations)]
    assert len(claims) > 300
    for claim in claims:
        if isinstance(claim, Claim):
            text = writer.claim(claim).replace("<wbr>", "")
            ET.fromstring(f"<p>{text}</p>")
            assert not re.search(r"<mo[^>]*>[+−]</mo>(<mrow>)*<mo>−</mo>", text)


def test_lines_can_break_before_each_sign() -> None:
    text = WRITER.claim(equal(a + b - c, a))
    assert text.count("<wbr>") == 3
    assert text.count("<math>") == 4


def test_two_minus_signs_never_meet() -> None:
    assert read(Term("neg", Term("neg", a))) == "−(−a)"
