"""The rows: which are refuted, by which point, and what breaks them."""

from __future__ import annotations

import operator
from fractions import Fraction

import pytest
import sympy

from verify.prover.forall import decide_row
from verify.paper.spectrum.printed import COEFFICIENTS, MATRIX, Printed
from verify.paper.spectrum.theorem import theorem
from verify.prover.ground import PROVED, REFUTED
from verify.jobs.spectrum import Outcome, decide
from verify.language.statement import Obligation
from verify.language.terms import Term, as_term

#: The sentences that are false as printed, and the rows that correct them.
FALSE = {
    "A_a-stated": "A_a",
    "A_c-stated": "A_c",
    "matrix-stated": "matrix",
    "eigenspace-stated": "eigenspace-flipped",
    "cone-x-bound-2": "cone-x-bound-2-equal",
    "cone-z-bound-2": "cone-z-bound-2-equal",
    "cone-y-stated": "cone-y-flipped",
    "manifold": "manifold-empty",
    "rate-complex-stated": "rate-complex",
}

SIXTY_FOURTH = as_term(Fraction(1, 64))


@pytest.fixture(scope="module")
def outcome() -> Outcome:
    return decide()


@pytest.fixture(scope="module")
def rows() -> dict[str, Obligation]:
    return {row.name: row for row in theorem().obligations}


def test_every_needed_row_is_proved(outcome: Outcome) -> None:
    assert outcome.exit_code == 0
    assert {f.verdict for row, f in outcome.rows if row.role == "needed"} == {PROVED}


def test_exactly_these_sentences_are_refuted(outcome: Outcome) -> None:
    refuted = {row.name: row.corrected_by for row, f in outcome.rows if f.verdict == REFUTED}
    assert refuted == FALSE
    roles = {row.name: row.role for row, _ in outcome.rows}
    assert {roles[name] for name in FALSE} == {"printed"}
    assert {roles[name] for name in FALSE.values()} == {"needed"}


def test_names_are_unique_and_assumptions_exist(outcome: Outcome) -> None:
    names = [row.name for row, _ in outcome.rows]
    assert len(names) == len(set(names))
    known = {a.name for a in outcome.statement.assumptions}
    assert {a.name for a in outcome.assumptions} == known
    assert {name for row, _ in outcome.rows for name in row.uses} == known


OPERATIONS = {
    "add": operator.add,
    "sub": operator.sub,
    "mul": operator.mul,
    "div": operator.truediv,
    "neg": operator.neg,
    "sqrt": sympy.sqrt,
    "max": sympy.Max,
}


def to_sympy(term: Term, values: dict[str, sympy.Expr]) -> sympy.Expr:
    if term.op == "rational":
        return sympy.Rational(term.value.numerator, term.value.denominator)
    if term.op == "symbol":
        return values[term.name]
    parts = [to_sympy(child, values) for child in term.children]
    if term.op == "pow":
        return parts[0] ** term.exponent
    return OPERATIONS[term.op](*parts)


@pytest.mark.parametrize("name", FALSE)
def test_each_witness_is_exact(outcome: Outcome, name: str) -> None:
    """At the point, inside the intervals, the claim fails in exact arithmetic over Q(sqrt 3)."""
    row, finding = next(pair for pair in outcome.rows if pair[0].name == name)
    assert set(finding.point) == {variable.name for variable in row.variables}
    for variable in row.variables:
        value = finding.point[variable.name]
        assert variable.lower is None or variable.lower < value
        assert variable.upper is None or value < variable.upper
    values = {
        key: sympy.Rational(value.numerator, value.denominator)
        for key, value in finding.point.items()
    }
    lhs, rhs = (
        sympy.expand(to_sympy(side, values), deep=True) for side in (row.claim.lhs, row.claim.rhs)
    )
    difference = sympy.radsimp(rhs - lhs)
    if row.claim.relation == "=":
        assert difference != 0
    elif row.claim.relation == "<":
        assert difference.is_nonpositive
    else:
        assert difference.is_negative


@pytest.mark.parametrize("sign", [1, -1])
@pytest.mark.parametrize("i", range(4))
@pytest.mark.parametrize("j", range(4))
def test_a_broken_entry_of_the_matrix_is_found(i: int, j: int, sign: int) -> None:
    broken = [list(row) for row in MATRIX]
    broken[i][j] = broken[i][j] + sign * SIXTY_FOURTH
    outcome = decide(Printed(matrix=tuple(map(tuple, broken))))
    assert outcome.exit_code == 1
    verdicts = {row.name: f.verdict for row, f in outcome.rows}
    assert verdicts[f"entry-{i + 1}-{j + 1}"] == REFUTED
    assert verdicts["matrix"] == REFUTED
    entries = [name for name, verdict in verdicts.items() if name.startswith("entry-")]
    assert sum(verdicts[name] == REFUTED for name in entries) == 1


@pytest.mark.parametrize("sign", [1, -1])
@pytest.mark.parametrize("power", range(4))
def test_a_broken_coefficient_of_q_is_found(power: int, sign: int) -> None:
    broken = list(COEFFICIENTS)
    broken[power] = broken[power] + sign * SIXTY_FOURTH
    outcome = decide(Printed(coefficients=tuple(broken)))
    assert outcome.exit_code == 1
    verdicts = {row.name: f.verdict for row, f in outcome.rows}
    assert verdicts["characteristic"] == REFUTED
    assert verdicts["Q-factorised"] == REFUTED


def test_a_broken_leaf_of_the_printed_formulas_is_found(rows: dict[str, Obligation]) -> None:
    """Each number in the printed coefficients of Q matters, not only their sums."""
    for power in range(3):
        for broken in altered(COEFFICIENTS[power]):
            changed = (*COEFFICIENTS[:power], broken, *COEFFICIENTS[power + 1 :])
            row = next(
                row
                for row in theorem(Printed(coefficients=changed)).obligations
                if row.name == "characteristic"
            )
            assert decide_row(row).verdict == REFUTED


def altered(term: Term) -> list[Term]:
    """The term with each of its rational leaves changed by 1/64, one at a time."""
    if term.op == "rational":
        return [as_term(term.value + Fraction(1, 64))]
    found = []
    for i, arg in enumerate(term.args):
        if isinstance(arg, Term):
            found += [
                Term(term.op, *term.args[:i], other, *term.args[i + 1 :]) for other in altered(arg)
            ]
    return found
