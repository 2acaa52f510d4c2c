"""The constants of Theorem 1 are defined as the paper defines them, and a change is noticed."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import pytest
import sympy

from tests.paper.changed_page import changed_page
from verify.cli import main
from verify.language.errors import OwnError
from verify.language.statement import Constant
from verify.language.terms import Term, minimum, substitute, substitute_claim, symbol
from verify.paper import printed_definitions
from verify.paper.parameters import PRINTED
from verify.paper.printed_definitions import DEFINITIONS, AsPrinted, check_definitions, complaints
from verify.paper.theorem1 import theorem

OPERATIONS: Mapping[str, Callable[..., Any]] = {
    "add": lambda x, z: x + z,
    "sub": lambda x, z: x - z,
    "mul": lambda x, z: x * z,
    "div": lambda x, z: x / z,
    "neg": lambda x: -x,
    "sqrt": sympy.sqrt,
}

NAMES = [definition.constant.name for definition in DEFINITIONS]


def constants() -> dict[str, Constant]:
    found = (*theorem().common, *theorem().parts[PRINTED].bounds)
    return {constant.name: constant for constant in found}


def entries(term: Term) -> list[Any]:
    """A term for SymPy, or the entries of a minimum."""
    if term.op == "min":
        return [found for entry in term.children for found in entries(entry)]
    return [expression(term)]


def expression(term: Term) -> Any:
    if term.op == "symbol":
        return sympy.Symbol(term.name, positive=True)
    if term.op == "rational":
        return sympy.Rational(term.value.numerator, term.value.denominator)
    if term.op == "pow":
        return expression(term.children[0]) ** term.exponent
    return OPERATIONS[term.op](*map(expression, term.children))


@pytest.mark.parametrize("definition", DEFINITIONS, ids=NAMES)
def test_each_definition_satisfies_the_printed_equation_as_algebra_shows(
    definition: AsPrinted,
) -> None:
    known = constants()
    parts = {part.name: known[part.name].term for part in printed_definitions.PARTS_OF_D_BAR}
    own = substitute(known[definition.constant.name].term, parts)
    claim = substitute_claim(definition.printed, {definition.constant.name: own})
    left, right = entries(claim.lhs), entries(claim.rhs)
    assert [sympy.radsimp(sympy.simplify(x - z)) for x, z in zip(left, right, strict=True)] == [
        0
    ] * len(left)


def test_every_constant_of_the_printed_set_has_a_printed_one() -> None:
    elsewhere = {term.name for term in printed_definitions.NOT_IN_THE_PAPER}
    assert set(constants()) == {*NAMES} | elsewhere
    assert len(set(NAMES)) == len(NAMES)


@pytest.mark.parametrize(
    "change",
    [lambda term: term / 2, lambda term: -term, lambda term: minimum(term, symbol("r")) * 1],
    ids=["half", "negative", "another operation"],
)
@pytest.mark.parametrize("name", NAMES)
def test_a_changed_definition_is_noticed(name: str, change: Callable[[Term], Term]) -> None:
    known = constants()
    old = known[name]
    (complaint,) = complaints(known | {name: old._replace(term=change(old.term))})
    assert complaint.startswith(f"{old.letter} ({old.label}) is not the paper's: the paper has ")


def test_a_changed_part_of_d_bar_is_noticed() -> None:
    known = constants()
    for part in printed_definitions.PARTS_OF_D_BAR:
        changed = known[part.name]._replace(term=known[part.name].term / 2)
        (complaint,) = complaints(known | {part.name: changed})
        assert complaint.startswith("d̄ (EQUATSS4.1DefinBorne_d_0_) is not the paper's")


def test_a_definition_at_another_label_is_noticed() -> None:
    known = constants()
    moved = known | {"C_eta": known["C_eta"]._replace(label="EQUATSS4.1Recurrence_Cnd2")}
    with pytest.raises(
        OwnError, match=r"^C_η belongs to \S*Quantite_C_eta_ in .* to \S*_Cnd2 here"
    ):
        check_definitions(moved.values())


def test_theorem1_says_nothing_of_theorem_1_with_another_definition(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    with changed_page(tmp_path, ("C_eta: 1 - delta_3;", "C_eta: 1 - delta_3/2;")):
        code = main(["theorem1", "--r", "0.03"])
    assert code == 5
    printed, complaint = capsys.readouterr()
    assert printed == ""
    assert complaint == (
        "verify: C_η (EQUATSS4.1Quantite_C_eta_) is not the paper's: the paper has "
        "C_η = 1 - δ₃, and this program has C_η = 1 - δ₃/2\n"
    )
