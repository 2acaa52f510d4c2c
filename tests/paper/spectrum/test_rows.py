"""The rows: which are refuted, by which point, and what breaks them."""

from __future__ import annotations

import json
import operator
import re
from collections import Counter
from fractions import Fraction

import pytest
import sympy

from tests.paper.spectrum.page import TEXT, changed, read, with_a_broken_entry
from verify.language.statement import PROVED, REFUTED, Context, Statement
from verify.language.terms import Claim, Term, as_term, names_of, symbol
from verify.paper.commands.spectrum import cite_spectrum
from verify.prover.outcome import Outcome
from verify.prover.prove import prove
from verify.publication import REMARK, SLIP
from verify.views.words import fair
from verify.wire.judge import judged

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


@pytest.fixture(scope="module")
def outcome() -> Outcome:
    return cite_spectrum()


def test_the_numbers_of_rows_and_verdicts(outcome: Outcome) -> None:
    counts = Counter((row.role, found.verdict) for row, found in outcome.rows)
    assert counts == {
        ("needed", PROVED): 194,
        ("printed", PROVED): 27,
        ("printed", REFUTED): 9,
    }


def test_every_needed_row_is_proved(outcome: Outcome) -> None:
    assert outcome.exit_code == 0
    assert {f.verdict for row, f in outcome.rows if row.role == "needed"} == {PROVED}


def test_exactly_these_sentences_are_refuted(outcome: Outcome) -> None:
    refuted = {row.name: row.corrected_by for row, f in outcome.rows if f.verdict == REFUTED}
    assert refuted == FALSE
    roles = {row.name: row.role for row, _ in outcome.rows}
    assert {roles[name] for name in FALSE} == {"printed"}
    assert {roles[name] for name in FALSE.values()} == {"needed"}


def test_what_is_held_against_the_text_is_one_slip(outcome: Outcome) -> None:
    """The basis has the wrong sign; what the text does not claim of collapses is a remark."""
    found = {row.name: fair(outcome, row, d) for row, d in outcome.rows}
    against = {name for name, verdict in found.items() if verdict == REFUTED}
    assert against == {"A_a-stated", "A_c-stated", "matrix-stated", "eigenspace-stated"} | {
        "cone-y-stated"
    }
    assert {found[name] for name in FALSE.keys() - against} == {REMARK}
    assert {row.severity for row, _ in outcome.rows if row.name in against} == {SLIP}


def test_names_are_unique_and_assumptions_exist(outcome: Outcome) -> None:
    contexts = outcome.statement.contexts
    names = [row.name for row, _ in outcome.rows]
    names += [context.name for context in contexts]
    names += [variable.name for context in contexts for variable in context.variables]
    names += [given.name for context in contexts for given in context.givens]
    assert len(names) == len(set(names))
    known = {a.name for a in outcome.statement.assumptions}
    assert {a.name for a in outcome.own_assumptions} == known - {"monotone"}  # of printed rows
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


def context_of(statement: Statement, name: str | None) -> Context:
    return next(context for context in statement.contexts if context.name == name)


#: For which numbers rows are claimed that are not claimed for the usual ones.
INTERVALS = {
    "q-convex": {},
    "cone-sign-x-range": {},
    "triangle": {},
    "cone-x-bound-2": {"r": (0, 1), "x": (None, 0), "y": None, "t": None},
    "cone-y-stated": {"a": (0, None), "b": (0, None), "g": (0, None), "r": (0, 1), "t": None},
    "q-negative": {"s": (1, 2)},
    "C2-large-r-sign": {"r": (Fraction(1, 3), 1)},
    "C2-two-y": {"r": (0, Fraction(1, 3))},
    "manifold": {"k": None, "m": (0, 1)},
    "full-jump": {"g": (None, 0), "r": (0, 1), "p": None, "q": None, "cosine": None},
    "rate-complex-stated": {"k": (0, Fraction(1, 2)), "s": (0, 1)},
    "rate-existence": {"s": (0, 1), "y": (0, None)},
    "stability-eigenvalues": {"p": (0, 1), "v": (0, 1)},
    "linear-real-plus": {"C": None, "d": (0, None), "r": (0, 1)},
    "law-01-W1": {"r": (0, 1), "g": None, "w": None, "v_0": None, "v_1": None},
}


@pytest.mark.parametrize("name", INTERVALS)
def test_a_row_is_claimed_for_its_numbers(outcome: Outcome, name: str) -> None:
    row = next(row for row, _ in outcome.rows if row.name == name)
    givens = {g.name: g.claim for g in context_of(outcome.statement, row.context).givens}
    assert isinstance(row.claim, Claim)
    expected = INTERVALS[name]
    names = {
        variable.rpartition(".")[2]: variable for variable in names_of(row.claim.lhs, row.claim.rhs)
    }
    if expected:
        assert set(names) == set(expected)
    for short, variable in names.items():
        low, high = expected.get(short) or (None, None)
        claims = (
            None if low is None else Claim("<", as_term(low), symbol(variable)),
            None if high is None else Claim("<", symbol(variable), as_term(high)),
        )
        assert (givens.get(f"{variable}.low"), givens.get(f"{variable}.high")) == claims


@pytest.mark.parametrize("name", FALSE)
def test_each_witness_is_exact(outcome: Outcome, name: str) -> None:
    """At the point, inside the intervals, the claim fails in exact arithmetic over Q(sqrt 3)."""
    row, decision = next(pair for pair in outcome.rows if pair[0].name == name)
    context = context_of(outcome.statement, row.context)
    assert isinstance(row.claim, Claim)
    assert set(decision.witness) == {variable.name for variable in context.variables}
    values = {key: to_sympy(term, {}) for key, term in decision.witness.items()}
    for given in context.givens:
        assert given.claim.relation == "<"
        assert to_sympy(given.claim.lhs, values) < to_sympy(given.claim.rhs, values)
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


#: The rows about the matrix and its polynomial alone.
NAMES = {"matrix", "characteristic", "Q-factorised"}


def verdicts_of(stated: Statement) -> dict[str, str]:
    """What is said of the rows about the matrix and its polynomial alone."""
    rows = [x for x in stated.obligations if x.name in NAMES or x.name.startswith("entry-")]
    outcome = judged(prove(stated._replace(obligations=tuple(rows))))
    return {row.name: found.verdict for row, found in outcome.rows}


def test_a_broken_entry_fails_the_whole() -> None:
    outcome = with_a_broken_entry()
    assert outcome.exit_code == 1
    found = {row.name: decision.verdict for row, decision in outcome.rows}
    assert verdicts_of(outcome.statement).items() <= found.items()


#: The matrix as the page writes it, entry by entry.
MATRIX = re.findall(r'"([^"]+)"', TEXT.partition('"A(r)" = [')[2].partition("\n]")[0])


@pytest.mark.parametrize("sign", ["+", "-"])
@pytest.mark.parametrize("place", range(16))
def test_a_broken_entry_of_the_matrix_is_found(place: int, sign: str) -> None:
    broken = [f"{entry} {sign} 1/64" if i == place else entry for i, entry in enumerate(MATRIX)]
    before, _, rest = TEXT.partition('"A(r)" = [')
    rows = [broken[i : i + 4] for i in range(0, 16, 4)]
    text = before + f'"A(r)" = {json.dumps(rows)}' + rest.partition("\n]")[2]
    verdicts = verdicts_of(read(text))
    assert verdicts[f"entry-{place // 4 + 1}-{place % 4 + 1}"] == REFUTED
    assert verdicts["matrix"] == REFUTED
    entries = [name for name, verdict in verdicts.items() if name.startswith("entry-")]
    assert sum(verdicts[name] == REFUTED for name in entries) == 1


#: The coefficients of Q as the page writes them.
Q = '"Q(x, r)" = "x^3 + a_2(r)*x^2 + a_1(r)*x + r^3"'


@pytest.mark.parametrize("sign", ["+", "-"])
@pytest.mark.parametrize("part", ["x^3", "x^2", "a_1(r)*x", "+ r^3"])
def test_a_broken_coefficient_of_q_is_found(part: str, sign: str) -> None:
    power = {"x^3": "x^3", "x^2": "x^2", "a_1(r)*x": "x", "+ r^3": "1"}[part]
    verdicts = verdicts_of(changed(Q, f'{Q[:-1]} {sign} 1/64*{power}"'))
    assert verdicts["characteristic"] == REFUTED
    assert verdicts["Q-factorised"] == REFUTED


LEAVES = [
    (name, match)
    for name in ('"a_1(r)"', '"a_2(r)"')
    for match in re.finditer(r"(?<![\^\d])\d+", re.search(rf"{re.escape(name)} = (.*)", TEXT)[1])
]


@pytest.mark.parametrize(("name", "match"), LEAVES, ids=lambda x: x if isinstance(x, str) else x[0])
def test_a_broken_leaf_of_the_printed_formulas_is_found(name: str, match: re.Match[str]) -> None:
    """Each number in the printed coefficients of Q matters, not only their sums."""
    line = f"{name} = {match.string}"
    broken = match.string[: match.start()] + f"({match[0]} + 1/64)" + match.string[match.end() :]
    stated = changed(line, f"{name} = {broken}")
    rows = [row for row in stated.obligations if row.name == "characteristic"]
    outcome = prove(stated._replace(obligations=tuple(rows)))
    assert outcome.decisions["characteristic"].claimed == REFUTED
