"""Pages of constants: what they say, that they are read back, and what is said of mistakes."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable
from fractions import Fraction
from hashlib import sha256
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from verify import check
from verify.cli import main
from verify.language.fold import TERMS
from verify.language.statement import Always, Statement
from verify.language.terms import (
    Claim,
    Term,
    as_term,
    cos,
    equal,
    exp,
    log,
    maximum,
    nth_root,
    pi,
    sin,
    sqrt,
    symbol,
)
from verify.wire.inputs import InputError
from verify.wire.questions import decide, read_questions
from verify.wire.text.infix import (
    Names,
    read_claims,
    read_givens,
    read_term,
)
from verify.wire.text.letters import letter_of
from verify.wire.text.read_page import read_page
from verify.wire.text.write_page import page_text
from verify.wire.text.written import claim_text, term_text
from verify.wire.write import write

CERTIFICATES = Path(__file__).resolve().parents[2] / "certificates"
STATEMENTS = sorted(CERTIFICATES.rglob("statement.json"))
NAMES = ["x", "y", "delta_1", "printed.a", "a-b", "sqrt", "e"]
X, Y = symbol("x"), symbol("y")


def own_names(names: Iterable[str]) -> Names:
    """Names that stand for themselves."""
    return Names({name: name for name in names})


def read(text: str) -> Statement:
    return read_page("page.toml", text.encode()).statement


# --- what is written is read back ----------------------------------------------------------------


@pytest.mark.parametrize("path", STATEMENTS, ids=lambda p: p.parent.relative_to(CERTIFICATES))
def test_every_committed_statement_is_a_page(path: Path) -> None:
    folder = check.read_folders([str(path.parent)])[0]
    others = [*folder.cited, *(p.read_bytes() for p in STATEMENTS)]
    statement = read_questions(folder.statement, {sha256(c).hexdigest(): c for c in others})
    page = page_text(statement)
    again = read_page("page.toml", page.encode(), statement.cites).statement
    assert again == statement
    assert page_text(again) == page


NUMBERS = st.builds(Fraction, st.integers(-20, 20), st.sampled_from([1, 2, 3, 10, 200, 3000]))
NUMBERS = NUMBERS.map(as_term)
LEAVES = NUMBERS | st.sampled_from(NAMES).map(symbol)


def _branches(children: st.SearchStrategy[Term]) -> st.SearchStrategy[Term]:
    two = st.tuples(st.sampled_from(("add", "sub", "mul", "div", "min", "max")), children, children)
    one = st.tuples(st.sampled_from(("neg", "sqrt", "cos", "cos_pi")), children)
    powers = st.builds(lambda term, k: term**k, children, st.integers(1, 9))
    return (two | one).map(lambda parts: Term(*parts)) | powers


@settings(max_examples=500, deadline=None)
@given(st.recursive(LEAVES, _branches, max_leaves=12))
def test_a_formula_is_read_as_it_was_written(term: Term) -> None:
    assert read_term("", term_text(term), own_names(NAMES)) is term


@pytest.mark.parametrize(
    ("number", "text"),
    [("1/10", "1/10"), ("191/1000", "0.191"), ("-1307/10000", "-0.1307"), ("1/300", "1/300")],
)
def test_numbers_are_written_as_in_papers(number: str, text: str) -> None:
    assert term_text(as_term(Fraction(number))) == text


def test_every_operation_is_written_and_read() -> None:
    arguments = {"rational": (Fraction(1, 3),), "symbol": ("x",), "pi": ()}
    arguments |= dict.fromkeys(("pow", "root"), (X, 3))
    two = dict.fromkeys(("add", "sub", "mul", "div", "min", "max"), (X, Y))
    for op in TERMS:
        term = Term(op, *(arguments | two).get(op, (X,)))
        assert read_term("", term_text(term), own_names(NAMES)) is term


# --- what formulas mean --------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("text", "term"),
    [
        ("0.1", as_term(Fraction(1, 10))),
        ("1e-3", as_term(Fraction(1, 1000))),
        ("-1/4", as_term(Fraction(-1, 4))),
        ("1/4*x", Fraction(1, 4) * X),
        ("x/1/4", X / 1 / 4),
        ("-x^2", -(X**2)),
        ("-x*y", -X * Y),
        ("2 - 3 - x", as_term(2) - 3 - X),
        ("x² · √y", X**2 * sqrt(Y)),
        ("√(x + y)", sqrt(X + Y)),
        ("x**-2", 1 / X**2),
        ("x^(1/2)", sqrt(X)),
        ("x^(3/2)", sqrt(X) ** 3),
        ("x^(-2/3)", 1 / nth_root(X, 3) ** 2),
        ("x^y", exp(Y * log(X))),
        ("e^(x + 1)", exp(X + 1)),
        ("2*π*e", 2 * pi * exp(1)),
        ("sum(x^k/k, k, 1, 3)", X / 1 + X**2 / 2 + X**3 / 3),
        ("sum(x^k, k, 0, 1)", 1 + X),
        ("prod(x + k, k, -1, 0)", (X + as_term(-1)) * (X + 0)),
        ("sum([1, k, k, 2][2]*x, k, 1, 2)", 1 * X + 2 * X),
        ("sum([x, 3*x][k], k, 1, [1, 2][2])", X + 3 * X),
        ("sum(sum(j*k, j, 1, k), k, 1, 2)", as_term(1) * 1 + (as_term(1) * 2 + as_term(2) * 2)),
        ("tan(x)", sin(X) / cos(X)),
        ("ln(x) + root(x, 5)", log(X) + nth_root(X, 5)),
        ("|x - y|", maximum(X - Y, -(X - Y))),
        ("abs(cos(x))", maximum(cos(X), -cos(X))),
        ("δ₁", symbol("delta_1")),
        ("`a-b`", symbol("a-b")),
    ],
)
def test_what_a_formula_means(text: str, term: Term) -> None:
    assert read_term("", text, own_names({*NAMES} - {"e"})) is term


def test_a_chain_is_several_claims() -> None:
    found = read_claims("", "1 ≥ x > y = 0", own_names(NAMES))
    assert found == (Claim("<=", X, as_term(1)), Claim("<", Y, X), Claim("=", Y, as_term(0)))


@pytest.mark.parametrize(
    ("text", "claims"),
    [
        ("x != y", (0 < (X - Y) ** 2,)),
        ("x ≠ 0", (0 < X**2,)),
        ("x < 1 and y >= 2", (X < 1, as_term(2) <= Y)),
        ("x <= 1 or x >= 2", (0 <= maximum(1 - X, X - 2),)),
        ("x < 0 or y != 0 or 1 < x", (0 < maximum(-X, Y**2, X - 1),)),
        ("x = 0 or x = y", (equal(0, X * (X - Y)),)),
    ],
)
def test_what_is_no_inequality_is_read_as_one(text: str, claims: tuple[Claim, ...]) -> None:
    assert read_claims("", text, own_names(NAMES)) == claims


@pytest.mark.parametrize(
    ("name", "letters"),
    [
        ("alpha_0", ("α₀", r"\alpha_{0}")),
        ("u12", ("u₁₂", "u_{12}")),
        ("half.u", ("u", "u")),
        ("x.0.1", ("x.0.1", "x.0.1")),
        ("q_bar", ("q_bar", "q_bar")),
    ],
)
def test_letters(name: str, letters: tuple[str, str]) -> None:
    assert letter_of(name) == letters


# --- pages ---------------------------------------------------------------------------------------

PAGE = """
title = "Two contexts"

[constants]
b = "1 + sqrt(2)"

[contexts.low]
variables = ["x"]
given = ["0 < x < b"]
constants = { d = "x^2 + 1" }
rows = { positive = "0 < d" }

[contexts.inner]
in = "low"
given = { below = "0 < y <= x" }
point = { y = "x" }

[contexts.high]
variables = ["x"]
given = ["b <= x"]

[rows]
smaller = "y < d"
high-x = { in = "high", claim = "1 < x" }
number = "2 < b < 3"
"""


def test_rows_find_their_contexts() -> None:
    statement = read(PAGE)
    assert [(row.name, row.context) for row in statement.obligations] == [
        ("positive", "low"),
        ("smaller", "inner"),
        ("high-x", "high"),
        ("number.1", None),
        ("number.2", None),
    ]
    low, inner, high = statement.contexts
    assert [given.name for given in low.givens] == ["low.1", "low.2"]
    assert [given.name for given in inner.givens] == ["below.1", "below.2"]
    assert (high.variables[0].name, high.variables[0].letter) == ("high.x", "x")
    assert statement.obligations[2].claim == (1 < symbol("high.x"))


def test_points_are_found_that_the_checker_accepts() -> None:
    """Between bounds with roots, near an open end, and in terms of the variables around."""
    statement = read(PAGE.replace('point = { y = "x" }', 'variables = ["y"]'))
    low, inner, high = statement.contexts
    assert low.point == {"x": as_term(1)}
    assert inner.point == {"y": (as_term(0) + X) / 2}
    assert high.point == {"high.x": as_term(3)}


def test_equations_are_solved_for_a_point() -> None:
    page = 'title = "t"\n[contexts.c]\nvariables = ["x", "y", "z"]\n'
    page += 'given = ["0 < x < y", "x + y = 1", "x*y*z = 1"]\n[rows]\na = "x*y < 1/4"\n'
    point = read(page).contexts[0].point
    x, y, z = (point[name].value for name in "xyz")
    assert 0 < x < y
    assert (x + y, x * y * z) == (1, 1)


def test_greek_names_may_be_written() -> None:
    statement = read('title = "t"\n[constants]\n"ε₀" = 0.1\n[rows]\na = "ε_0 < 1"\n')
    assert (statement.constants[0].name, statement.constants[0].letter) == ("epsilon_0", "ε₀")
    assert statement.obligations[0].claim == (symbol("epsilon_0") < 1)


@pytest.mark.parametrize(
    ("tables", "formula", "says"),
    [
        ('[constants]\nb = 3\neta = 5\nbeta = "1/2"', "bη < 1", r"write b\*η"),
        ("[constants]\nx_11 = 1", "x1₁ < 2", "x1_1"),
        ('[constants]\n"bη" = 1', "beta < 2", "bη"),
        ("[constants]\nalpha = 10", "sum(alpha, α, 1, 3) = 30", "no new letter"),
        ('[let]\n"δ" = 2\n[constants]\ndelta = 1', "δ > delta", "something else"),
        ('[let]\n"f(δ)" = "δ"', "1 < 2", "no name"),
        ('[let]\n"x^2" = 5\n[constants]\nx = 1', "x^2 < 2", "no name"),
    ],
)
def test_a_name_stands_for_one_thing(tables: str, formula: str, says: str) -> None:
    with pytest.raises(InputError, match=says):
        read(f'title = "t"\n{tables}\n[rows]\na = "{formula}"\n')


def test_names_that_are_written_alike_are_one() -> None:
    page = 'title = "t"\n[let]\n"δ₁" = 2\n[rows]\na = "δ_1 < sum(α*alpha, α, 1, 3)"\n'
    (row,) = read(page).obligations
    assert row.claim == (as_term(2) < as_term(1) * 1 + as_term(2) * 2 + as_term(3) * 3)


def test_a_variable_has_one_value() -> None:
    page = 'title = "t"\n[contexts.b]\nvariables = "x"\n[contexts.c]\nvariables = "x"\n'
    for where in (
        'point = { x = 1, "c.x" = 2 }\n[rows]\na = "c.x < 3"\n',
        'states = { s = "x = 1, c.x = 2" }\n[rows]\na = "c.x < 3"\n',
        '[rows]\na = { applies = "c", at = { x = 1, "c.x" = 2 } }\n',
    ):
        with pytest.raises(InputError, match=r"'c.x' has two values"):
            read(page + where)


def test_a_point_on_a_curve_is_asked_for() -> None:
    page = 'title = "t"\n[contexts.c]\nvariables = ["x", "y"]\ngiven = ["exp(x) + exp(y) = 7"]\n'
    with pytest.raises(InputError, match=r"line 2: contexts.c: no point was found .* point = "):
        read(page + '[rows]\na = "x < 3"\n')


def test_other_signs_of_print_are_read() -> None:
    (row,) = read('title = "t"\n[constants]\nb = 2\n[rows]\na = "3⋅b ⩽ 7"\n').obligations
    assert row.claim == (3 * symbol("b") <= 7)
    (row,) = read('title = "t"\n[constants]\nb = 2\n[rows]\na = "b ⩾ 1"\n').obligations
    assert row.claim == (as_term(1) <= symbol("b"))


def test_givens_that_contradict_one_another_are_thought_of() -> None:
    page = 'title = "t"\n[contexts.c]\nvariables = ["x"]\ngiven = ["x < 0", "x > 1"]\n'
    with pytest.raises(InputError, match=r"contradict each other: .* says 0 < -1; mend one"):
        read(page + '[rows]\na = "x < 3"\n')


INDUCTION = """
title = "A sequence"

[assumptions]
grows = "every step is at least 1"

[contexts.state]
variables = ["t", "s"]
carried = ["t >= 1"]
standing = { step = { claim = "s >= 1", assumption = "grows" } }
point = { t = 1, s = 1 }

[rows.always]
always = "state"
start = { t = 1, s = 1 }
next = { t = "t + s", s = "s" }
uses = ["grows"]
"""


def test_an_induction() -> None:
    statement = read(INDUCTION)
    t, s = symbol("t"), symbol("s")
    row = statement.obligations[0]
    assert row.claim == Always("state", {"t": as_term(1), "s": as_term(1)}, {"t": t + s, "s": s})
    assert (row.context, row.uses) == (None, ("grows",))
    assert [(g.kind, g.assumption) for g in statement.contexts[0].givens] == [
        ("carried", None),
        ("standing", "grows"),
    ]


@pytest.mark.parametrize(
    ("written", "same"),
    [
        ("x < 1 or (y < 1 and x < y)", ("x < 1 or y < 1", "x < 1 or x < y")),
        (
            "(x < 1 and y < 1) or (x < 2 and y < 2)",
            ("x < 1 or x < 2", "x < 1 or y < 2", "y < 1 or x < 2", "y < 1 or y < 2"),
        ),
        ("(0 <= x <= 1) or y <= 1", ("0 <= x or y <= 1", "x <= 1 or y <= 1")),
        ("x < 1 and (y < 1 or (x < y))", ("x < 1", "y < 1 or x < y")),
        ("(x < 1) or ((x < 1) and y < 1)", ("x < 1", "x < 1 or y < 1")),
        ("((x + 1)*(y) < (2))", ("(x + 1)*y < 2",)),
        ("(x + 1)*y < 2 or (x) < (y)", ("(x + 1)*y < 2 or x < y",)),
    ],
)
def test_and_beside_or(written: str, same: tuple[str, ...]) -> None:
    found = read_claims("", written, own_names(("x", "y")))
    each = [claim for text in same for claim in read_claims("", text, own_names(("x", "y")))]
    assert [*found] == each


def test_bounds_of_a_modulus_behind_and() -> None:
    names = own_names(("x", "y"))
    assert len(read_givens("", "|x| <= 1 and (|y| <= 2)", names)) == 4
    assert len(read_givens("", "|x| <= 1 or |y| <= 2", names)) == 1


# --- mistakes ------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        ('"1 + sqrt(2)"', '"1 + sqr(2)"', "line 5: constants.b: '1 + sqr(2)': 'sqr' is no funct"),
        ('"1 + sqrt(2)"', '"1 + c"', "line 5: constants.b: 'c' is not defined here; define it"),
        ('"1 + sqrt(2)"', '"1 + 2b"', "no sign stands between 2 and b; write 2*b"),
        ('"1 + sqrt(2)"', '"(1 + 2"', "it ends, where ) is missing"),
        ('"1 + sqrt(2)"', '"1 < 2"', "constants.b: '1 < 2' is a claim; write a term"),
        ('"1 + sqrt(2)"', '"1/0"', "divides by zero"),
        ('"1 + sqrt(2)"', "true", "constants.b: 'True' is no text; write a formula in"),
        ('"1 + sqrt(2)"', '"2^x"', "line 5: constants.b"),
        ('"1 + sqrt(2)"', '"2^(1/1000)"', "the exponent 1/1000 is not usable; write m or m/n"),
        ('"1 + sqrt(2)"', '"root(2)"', "a root has a term and an index, such as root(x, 3)"),
        ('"1 + sqrt(2)"', '"max(1)"', "max is of at least two terms, and 1 stand there"),
        ('"y < d"', '"y < d and d"', "claims nothing; write a claim on each side of and"),
        ('"y < d"', '"y < d or d < 9 and d < 8"', "has both and and or in it; write two claims"),
        ('"y < d"', '"y < d or (d < 9 and d <= 8)"', "alternatives need one relation in all"),
        ('"y < d"', '"(y < d or d < 9) + 1"', "'+' follows, and does not belong there"),
        ('"y < d"', '"(y < d and d) or y < 8"', "claims nothing; write a claim on each side of"),
        ('"y < d"', '"(y < d and (d < 9 or y < 8)"', "it ends, where ) is missing"),
        (
            '"y < d"',
            '"y < d or 0 < d < 8"',
            "a chain is no alternative; write one sign on",
        ),
        (
            '"y < d"',
            '"y < d or d <= 8"',
            "alternatives need one relation in all of them",
        ),
        ('"1 + sqrt(2)"', '"1 or 2"', "constants.b: '1 or 2' is a claim; write a term"),
        ('"1 + sqrt(2)"', '"sum(1/k, k, 3, 2)"', "there is no number from 3 to 2; write sum(1/k^2"),
        ('"1 + sqrt(2)"', '"sum(1/k, 3, 2)"', "'3' is no new letter to number terms by; write sum"),
        (
            '"1 + sqrt(2)"',
            '"prod(1/k)"',
            "a prod has a term, a letter and two whole numbers",
        ),
        ('"1 + sqrt(2)"', '"sum(k, k, 1, 1/2)"', "a bound is no whole number; write sum(1/k^2, k"),
        ('"1 + sqrt(2)"', '"sum(k, k, 1, 1001)"', "it has more than 1000 terms; split it, or name"),
        ('"1 + sqrt(2)"', '"sum(1/k, k, 0, 2)"', "divides by zero"),
        ('"1 + sqrt(2)"', '"sum([k, k, 1, 2)"', "a sum has a term, a letter and two whole"),
        ('"1 + sqrt(2)"', '"sum([k, k], k, 1, 2)"', "a vector of 2 stands where a number is"),
        ('"1 + sqrt(2)"', '"sum(k 2, k, 1, 2)"', "'2' follows, and does not belong there"),
        ('"1 + sqrt(2)"', '"1 # 2"', "cannot read '# 2'"),
        ('"1 + sqrt(2)"', '"2⁻¹"', "cannot read '⁻¹'; write x^-2 for x⁻²"),
        ('"1 + sqrt(2)"', '"2,50"', "',' follows, and does not belong there; write 2.50"),
        ('"y < d"', '"y =< d"', "'<' follows, where a number or a name is missing; write <="),
        ('"y < d"', '"y => d"', "'>' follows, where a number or a name is missing; write >="),
        ('"1 + sqrt(2)"', '"int(k^2, k, 0, 1)"', "'int' is no function; did you mean"),
        ('"1 + sqrt(2)"', '"2,x"', "',' follows, and does not belong there"),
        ('"1 + sqrt(2)"', "'\\frac{1}{2}'", "TeX is not read, write for example (a/b)*sqrt(x)"),
        ('"1 + sqrt(2)"', '"\\frac{1}{2}"', "TeX is not read, write for example (a/b)*sqrt(x)"),
        ('"1 + sqrt(2)"', '"4!"', "cannot read '!'; write prod(k, k, 1, 5) for 5!"),
        ('"1 + sqrt(2)"', '"log10(2)"', "'log10' is no function; write log(x)/log(10)"),
        (
            '"1 + sqrt(2)"',
            '"1"\nb = "2"',
            "a name stands there twice",
        ),
        ("[rows]", "[constants]\n[rows]", "write its lines together"),
        ('"y < d"', '"y < dd"', "line 23: rows.smaller: 'dd' is not defined here; did you mean d?"),
        ('"y < d"', '"y"', "line 23: rows.smaller: 'y' claims nothing; write for example y > 0"),
        ('"y < d"', '"0 < y > d"', "a chain has < and > in it"),
        ('"y < d"', '"y < high.x"', "its names are of the contexts inner and high, of which none"),
        (
            '"y < d"',
            '"x < d"',
            "'x' is a name of the context low and of high; say in which by in = \"low\"",
        ),
        ('"1 < x"', '"1 < y"', "'y' is a name of the context inner; write in = \"inner\""),
        ('in = "low"', 'in = "lo"', "line 14: contexts.inner.in: 'lo' is no context; did you mean"),
        ('in = "high",', 'inn = "high",', "rows.high-x.inn: 'inn' is not known here; did you mean"),
        ("[rows]", "[row]", "line 22: row: 'row' is not known here; did you mean rows?"),
        ("smaller =", "b =", "rows.b: 'b' is already the name of constants.b; choose another"),
        ("number =", '"2nd" =', "'2nd.1' is no name; write ASCII letters"),
        ('{ y = "x" }', "{ y = 1, z = 1 }\nvariables = 'y'", "'z' is no variable of the context"),
        ('title = "Two contexts"', "", "the title is missing"),
        ('["b <= x"]', '["b <= x", 3]', "contexts.high.given: '3' claims nothing"),
        ('"2 < b < 3"', '{ claim = "b < 3", uses = ["schwarz"] }', "'schwarz' is no assumption"),
        ('"2 < b < 3"', '{ claim = "b < 3", role = "must" }', "'must' is unknown; write needed"),
        ('"2 < b < 3"', '{ claim = "b < 3", using = ["ball"] }', "'ball' is no given, and no earl"),
        ('"2 < b < 3"', '{ claim = "b < 3", using = ["smal"] }', "did you mean smaller?"),
        ('"2 < b < 3"', '{ claim = "b < 3", by = "magic" }', "'magic' is no fact before it, a"),
        ('"2 < b < 3"', '{ says = "b" }', "rows.number: it has no claim; write one claim"),
        ('"2 < b < 3"', '{ applies = "lou", at = {} }', "'lou' is no context; did you mean low?"),
        ('"2 < b < 3"', '{ applies = "low", at = {} }', "'x' has no value; write values of x"),
        ("[constants]", "[cites]\nm = 'mean'\n[constants]", "no statement of the theorem 'mean'"),
        ('"0 < d"', '"' + "(" * 3000 + 'd"', "nests too deeply"),
        ("[rows]", "[rows", "is not valid TOML"),
    ],
)
def test_what_is_said_of_a_mistake(old: str, new: str, says: str) -> None:
    assert old in PAGE
    with pytest.raises(InputError) as error:
        read(PAGE.replace(old, new, 1))
    message = str(error.value)
    assert message.startswith("page.toml")
    assert says in message
    assert "\n" not in message


@pytest.mark.parametrize(
    "variables",
    [
        *('{ x = "0..1" }', '{ x = "[0, 1]" }', '{ x = "real" }', '{ x = "(0, oo)" }'),
        *('{ x = "> 0" }', '{ x = "0 < x" }', '{ x = "3/4" }', '{ x = "ℝ" }', '{ x = "Integers" }'),
        *('{ x = ["0..1", "y"] }', '{ x = { letter = "x ≥ 0" } }', '"x: 0..1"', '"y, x: > 0"'),
        '{ x = "" }',
    ],
)
def test_what_is_known_of_a_variable_is_no_letter(variables: str) -> None:
    """A range in the place of a letter was taken for one, and the claim refuted outside of it."""
    rows = '[contexts.c.rows]\nr = "x^2 <= x"\n'
    with pytest.raises(InputError, match="is no letter of x"):
        read(f'title = "t"\n[contexts.c]\nvariables = {variables}\n{rows}')


@pytest.mark.parametrize(
    ("claim", "says"),
    [
        ("x(1) < 2", "write x*(...)"),
        ("1_000 < x", "write 1000"),
        ("1,000 < x", "write 1000, or 1.000 if the comma is a decimal comma"),
        ("1 000 < x", "write 1000"),
        ("1'000 < x", "write 1000"),
        ("x < 1,5", "write 1.5"),
        ("x < 1.2.3", "1.2.3 is no number"),
        ("x < 1;", "leave it out"),
        ("x < ∞", "leave a bound out that is infinite"),
        ("x < oo", "leave a bound out that is infinite"),
        ("x < 1 => y < 1", 'write given = ["x < 1"] in its context, and the claim "y < 1"'),
        ("x < 1 ⇒ y < 1", 'write given = ["x < 1"]'),
        ("x < 1 iff y < 1", "write a claim for each direction"),
        ("x <== 1", "write <="),
        ("x in [0, 1]", "write 0 <= x <= 1"),
        ("x in ]0,1]", "write 0 < x <= 1"),
        ("y in (0, infinity)", "write 0 < y"),
        ("x ∈ [0, y)", "write 0 <= x < y"),
        ("z in [0, 1]", "write 0 <= z <= 1"),
        ("x in {1, 2}", "write x = 1 or x = 2"),
        ("x is positive", "write x > 0"),
        ("exists y: x < y", "a claim is for all values"),
        ("x < y for some y", "a claim is for all values"),
        ("x integer", "variables are real numbers"),
        ("sum(1/k^2, k, 1, inf) < 2", "a sum has finitely many terms"),
        ("integral(x, x, 0, 1) < 1", "there are no limits and no integrals"),
        ("0 < gamma(x)", "name the value that you need"),
        ("min(x/2; 0.1) < 1", "write min(x/2, 0.1) < 1"),
        ("min(0,5; 0,1) < x", "write min(0.5, 0.1) < x"),
        ("min(x, 0,1) < 1", "write min(x, 0.1) < 1, or a space behind each comma"),
        ("sin(1,5) < x", "write sin(1.5) < x"),
        ("sin(1;5) < x", "write sin(1.5) < x"),
        ("root(0,5, 3) < x", "write root(0.5, 3) < x"),
        ("sqrt(x < 1", "where ) is missing"),
        ("sqrt(x", "where ) is missing; write sqrt(x)"),
        ("x =< 1", "write <="),
        ("x <> 1", "write !="),
        ("x =! y", "write !="),
        ("sqrt 2 < x", "write sqrt(2)"),
        ("sin x < 1", "write sin(x)"),
        ("sin²(x) < 1", "write sin(...)^2"),
        ("cos^2(x) < 1", "write cos(...)^2"),
        ("x ∈ [0, 1]", "write 0 <= x <= 1"),
        ("x < 1e", "write 1e-3, or 1*e"),
        ("2x < 1", "write 2*x"),
        ("|x < 1", "where | is missing"),
        ("pi() < 4", "it is a number; write pi"),
        ("max(x) < 1", "max is of at least two terms"),
        ("x! < 1", "write prod(k, k, 1, 5) for 5!"),
        ("x < y && y < 1", "write and"),
        ("x < y || y < 1", "write or"),
        ("x mod 2 < 1", "there are no remainders"),
        ("x < 50%", "write 1/2 for 50%"),
        ("x < 90°", "write a*pi/180"),
        ("½ < x", "write 1/2"),
        ("∛x < 1", "write root(x, 3)"),
        ("x ÷ y < 1", "write /"),
        ("x – y < 1", "write -"),
        ("x' < 1", "write for example x_next"),
        ("floor(x) < 1", "write bounds"),
        ("cot(x) < 1", "write 1/tan(x)"),
        ("lg(x) < 1", "write log(x)/log(10)"),
        ("SIN(x) < 1", "did you mean sin?"),
        ("X < 1", "did you mean x?"),
        ("Pi < 4", "did you mean pi?"),
    ],
)
def test_what_is_said_of_a_slip_in_a_claim(claim: str, says: str) -> None:
    page = f"title = 't'\n[contexts.c]\nvariables = ['x', 'y']\n[rows]\nr = \"{claim}\"\n"
    with pytest.raises(InputError) as error:
        read(page)
    message = str(error.value)
    assert "line 5: rows.r" in message
    assert says in message


@pytest.mark.parametrize("claim", ["x² ≤ 1", "x − 1 < 1", "2·x < 1", "x**2 < 1", "ln(x) < e^x"])
def test_what_is_read_as_it_is_written(claim: str) -> None:
    read(f"title = 't'\n[contexts.c]\nvariables = ['x']\n[rows]\nr = '{claim}'\n")


def test_a_standing_given_needs_its_assumption() -> None:
    with pytest.raises(InputError, match=r"line 10: .*needs the assumption that grants it"):
        read(INDUCTION.replace(', assumption = "grows"', ""))


# --- the commands --------------------------------------------------------------------------------


def test_a_page_is_proved_and_comes_back(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    page, out = tmp_path / "page.toml", tmp_path / "out"
    text = 'title = "t"\n\n[constants]\nb = "1 + sqrt(2)"\n\n[rows]\nlarge = "2 < b"\n'
    page.write_text(text, encoding="utf-8")
    assert main(["prove", str(page), "--out", str(out)]) == 0
    assert main(["check", str(out)]) == 0
    capsys.readouterr()
    assert main(["export", "text", str(out)]) == 0
    assert capsys.readouterr().out == text


HINTS = """
title = "Hints"
[contexts.c]
variables = ["x"]
given = ["0 <= x <= 1"]
[rows]
lemma = "x^2 <= x"
other = "x^3 <= x"
last = "x^4 <= 1"
"""


@pytest.mark.parametrize(
    ("hint", "verdict"),
    [
        ("", "proved"),
        (', by = ["linear sums", "squares"]', "proved"),
        (', by = "angles"', "undecided"),
        (', using = ["lemma"]', "proved"),
        (", using = []", "proved"),
    ],
)
def test_hints_restrict_the_search(hint: str, verdict: str) -> None:
    text = HINTS.replace('last = "x^4 <= 1"', f'last = {{ claim = "x^4 <= 1"{hint} }}')
    page = read_page("page.toml", text.encode())
    assert list(page.hints) == (["last"] if hint else [])
    outcome = decide(page.statement, None, page.hints)
    assert outcome.decisions["last"].verdict == verdict
    proof = outcome.decisions["last"].proof
    used = {name for name in ("lemma", "other") if proof and f"'{name}'" in repr(proof)}
    assert used <= ({"lemma"} if hint == ', using = ["lemma"]' else {"lemma", "other"})
    assert not (used and hint == ", using = []")


def test_a_page_cites_what_lies_beside_it(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    mean, cited = CERTIFICATES / "examples/mean", tmp_path / "cited"
    cited.mkdir()
    (cited / "mean.json").write_bytes((mean / "statement.json").read_bytes())
    (cited / "mean.certificate.json").write_bytes((mean / "certificate.json").read_bytes())
    theorem = json.loads((mean / "statement.json").read_text(encoding="utf-8"))["theorem"]
    page, out = tmp_path / "page.toml", tmp_path / "out"
    page.write_text(
        f'title = "t"\n[cites]\nm = "{theorem}"\n[rows]\n'
        'r = { applies = "m:pair", at = { x = 1, y = "sqrt(2)" } }\n',
        encoding="utf-8",
    )
    assert main(["prove", str(page), "--out", str(out)]) == 0
    captured = capsys.readouterr()
    assert "m:pair at x = 1, y = √2" in captured.out
    assert "given no assumptions of the cited 'm'" in captured.out
    assert main(["check", str(out)]) == 0


def test_cited_constants_are_known(tmp_path: Path) -> None:
    """Their definitions, and what is proved of them; a page of one's own is cited."""
    first, second, out = tmp_path / "first.toml", tmp_path / "second.toml", tmp_path / "out"
    first.write_text(
        'title = "one"\n[constants]\nq = "sqrt(2)"\np = "q + 1"\n[contexts.c]\nvariables = "x"\n'
        'given = ["0 <= x <= q"]\nconstants = { d = "x^2" }\n'
        '[rows]\nsmall = "d <= 2"\nr = "p < 3"\n',
        encoding="utf-8",
    )
    assert main(["prove", str(first), "--out", str(tmp_path / "one")]) == 0
    (tmp_path / "cited").mkdir()
    for name, new in (("statement", "one.json"), ("certificate", "one.certificate.json")):
        (tmp_path / "one" / f"{name}.json").rename(tmp_path / "cited" / new)
    second.write_text(
        'title = "two"\n[cites]\nm = "one"\n[constants]\ns = "m:p/2"\n[rows]\na = "s < 3/2"\n'
        'b = "m:q^2 = 2"\nc = { applies = "m:c", at = { x = "m:q - 1" } }\n',
        encoding="utf-8",
    )
    assert main(["prove", str(second), "--out", str(out)]) == 0
    assert main(["check", str(out)]) == 0


def test_a_bound_of_a_modulus_is_two_givens_where_it_is_written_as_one() -> None:
    names = own_names(["x"])
    assert [claim_text(c) for c in read_givens("f", "|x - 1| <= 1/2", names)] == [
        "-1/2 <= x - 1",
        "x - 1 <= 1/2",
    ]
    assert len(read_givens("f", "2 > |x| > 1", names)) == 3
    assert len(read_givens("f", "max(x, -x) <= 1", names)) == 1
    assert len(read_givens("f", "|x| + 1 <= 2", names)) == 1


ROOT = """
title = "Numbers that are roots"
[constants]
one = "1"
[contexts.plastic]
variables = ["rho"]
root = "rho^3 - rho - one"
between = [1, "2"]
rows = { size = "1.3247179572 < rho < 1.3247179573", square = "rho^2 < 1.76" }
[contexts.dottie]
variables = ["d"]
root = "cos(d) - d"
between = [0, 1]
[rows]
near = "0.7390851332 < d < 0.7390851333"
"""


def test_a_root_comes_with_rows_that_show_that_it_exists() -> None:
    page = read_page("f.toml", ROOT.encode())
    outcome = decide(page.statement)
    assert outcome.claimed == "proved"
    rows = {row.name: row for row, _ in outcome.rows}
    assert {"plastic.begins", "plastic.ends", "plastic.rises", "dottie.falls"} <= rows.keys()
    assert claim_text(rows["plastic.rises"].claim) == "0 < 3*plastic.range.rho^2 - 1"
    assert "intermediate value theorem" in rows["plastic.begins"].says
    files = write(outcome)
    assert check.check(files["statement.json"], files["certificate.json"], {}).verdict == "PROVED"
    again = read_page("f.toml", page_text(page.statement).encode())
    assert again.statement == page.statement


@pytest.mark.parametrize(
    ("root", "between", "row"),
    [
        ("d - 1e30 - 1/3", "[0, 1e31]", "1e30 < d < 1e30 + 1"),
        ("d - (1 - 1e-30)", "[0, 1]", "d > 1/2"),
        ("d*1e-400", "[-1, 3]", "d < 1"),
        ("exp(d) - 1e300", "[0, 1000]", "690 < d < 691"),
        ("one*d - 1/2", "[0, 1]", "d < 0.6"),
    ],
)
def test_a_root_is_found_where_floats_do_not_tell_signs(root: str, between: str, row: str) -> None:
    text = f"""title = "t"
[constants]
one = "1"
[contexts.c]
variables = "d"
root = "{root}"
between = {between}
rows = {{ near = "{row}" }}
"""
    assert decide(read_page("f.toml", text.encode()).statement).claimed == "proved"
    false = text.replace(row, "d < -1/2")
    assert decide(read_page("f.toml", false.encode()).statement).claimed == "refuted"


def test_abbreviations_may_be_over_constants_and_these_over_abbreviations() -> None:
    text = """title = "t"
[let]
d = "c*3"
"f(t)" = "t*c + d"
"g(c)" = "c^2"
w = "1"
[constants]
c = "2"
e = "g(c) + w"
[rows]
a = "d = 6"
b = "f(2) = 10"
h = "e = 5"
"""
    assert decide(read_page("f.toml", text.encode()).statement).claimed == "proved"
    with pytest.raises(InputError, match="'d' is not defined here"):
        read_page("f.toml", text.replace("g(c) + w", "d + w").encode())


def test_a_root_that_is_not_the_only_one_is_not_proved() -> None:
    # The sign changes at 1 alone, and the derivative is negative in between.
    text = ROOT.replace("rho^3 - rho - one", "(rho - 1)*(rho - 2)^2").replace("[1, ", "[0.5, ")
    text = text.replace('"2"', "3").replace('"1.3247179572 < rho < 1.3247179573"', '"rho < 2"')
    outcome = decide(read_page("f.toml", text.encode()).statement)
    assert outcome.decisions["plastic.rises"].claimed == "refuted"


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("between = [0, 1]", "between = [1, 2]", "does not change its sign from 1 to 2"),
        ("between = [0, 1]", "", "write between = [1, 2]"),
        ("between = [0, 1]", 'between = [0, "sqrt(2)"]', "are no numbers"),
        ("between = [0, 1]", 'between = [0, 1]\ngiven = ["0 <= d"]', "leave it out"),
        ('"cos(d) - d"', '"|d| - 1/2"', "has no derivative"),
    ],
)
def test_what_is_said_of_a_root_that_cannot_be_used(old: str, new: str, message: str) -> None:
    with pytest.raises(InputError, match=re.escape(message)):
        read_page("f.toml", ROOT.replace(old, new).encode())


ALTERNATIVES = """
title = "A gap"
[contexts.gap]
variables = ["x"]
given = ["0 <= x <= 3", "x <= 1 or x >= 2"]
[rows]
not-in-it = "x != 3/2"
beside-it = "x < 3/2 or x > 3/2"
outside = { claim = "(x - 1)*(x - 2) >= 0", in = "gap" }
at-its-ends = { claim = "x < 1 or x > 2", in = "gap" }
"""


def test_alternatives_among_givens_and_claims_are_decided() -> None:
    outcome = decide(read(ALTERNATIVES))
    verdicts = {row.name: decision.verdict for row, decision in outcome.rows}
    *proved, last = verdicts.values()
    assert ([*proved], last) == (["proved"] * 3, "refuted")
    files = write(outcome)
    checked = check.check(files["statement.json"], files["certificate.json"], {})
    assert checked.rows == verdicts


@pytest.mark.parametrize(
    ("name", "text", "says", "never"),
    [
        ("a.fpcore", "(FPCore (x) :pre (<= 1 x 0x1p3) x)", "no number", "declare"),
        ("a.fpcore", "(FPCore (x) :pre (<= 1 x 2) (+ x .5.))", "no number", "declare"),
        ("a.fpcore", "(FPCore (x) :pre (<= 1 x INFINITY) x)", "not read", "declare"),
        ("a.fpcore", "(FPCore (x) :pre (<= 1 x 2) (exp2 x))", "not read", "did you mean"),
        ("a.fpcore", "(FPCore (x) :pre (<= 1 x 2) (fma x x x))", "not read", "did you mean"),
        ("a.fpcore", "(FPCore (x) :pre (<= 1 x 2) (+ x zeta))", "arguments", "declare"),
        ("a.fpcore", "(FPCore (x) :Pre (<= 1 x 2) :pre (<= 1 x 3) x)", "line 1", "twice"),
        ("a.fpcore", "(FPCore (x) :pre (<= 1 x 2) (! :pre (<= 1 x 1) x))", "line 1", "declare"),
        (
            "a.toml",
            (
                'title = "t"\n[contexts.c]\nvariables = ["w", "z"]\n'
                'given = "0 <= w <= 1, 0 <= z"\n'
                '[rows]\na = {in = "c", claim = "w <= 2"}\n'
            ),
            "in a list",
            "write 1.0",
        ),
    ],
)
def test_what_cannot_be_read_is_refused_with_its_remedy(
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    name: str,
    text: str,
    says: str,
    never: str,
) -> None:
    path = tmp_path / name
    path.write_text(text)
    assert main(["prove", str(path)]) == 2
    out, err = capsys.readouterr()
    assert (out, err.count("\n")) == ("", 1)
    assert says in err
    assert never not in err


LARGE_AND_SMALL = [
    ("1 x 1e300) (* x (* x x))", 0),
    ("1e-300 x 1e-200) (* x (* x x))", 0),
    ("1 x 1e300) (/ x (* x x))", 0),
    ("0 x 1000) (exp x)", 0),
    ("0 x 1) (* 1e-300 (* x (* 1e-300 1e600)))", 0),
    ("0 x 1) (- (+ x 1e20) 1e20)", 0),
    ("1e400 x 2e400) x", 0),
    ("1/3 x 1/2) (sqrt (- x 1/3))", 0),
    ("1 x 1e300) (exp x)", 2),
    ("0 x 1) (/ 1 x)", 2),
]


@pytest.mark.parametrize(("text", "code"), LARGE_AND_SMALL)
def test_ranges_of_large_and_small_values_are_true(tmp_path: Path, text: str, code: int) -> None:
    """They are read exactly, or refused; a bound that leaves out a value would be refuted."""
    path = tmp_path / "a.fpcore"
    path.write_text(f"(FPCore (x) :pre (<= {text})")
    assert main(["prove", str(path)]) == code


@pytest.mark.parametrize(
    ("claim", "says", "never"),
    [
        ("0,5 <= x", "0.5", "list"),
        ("x <= 0,5", "0.5", "list"),
        ("x <= 0x10", "decimal digits", "0*x"),
        ("sin x <= 1", "sin(", "did you mean"),
        ("abs x <= 1", "abs(", "did you mean"),
        ("not x <= 1", "opposite", "dot"),
        ("x <= inf", "leave", "sin"),
        ("x <= 1 if x <= 2", "given", "1*if"),
    ],
)
def test_the_remedy_for_a_claim(claim: str, says: str, never: str) -> None:
    page = (
        'title = "t"\n[contexts.c]\nvariables = ["x"]\ngiven = "0 <= x <= 1"\n'
        f'[rows]\na = {{in = "c", claim = "{claim}"}}\n'
    )
    with pytest.raises(InputError) as error:
        read_page("a.toml", page.encode(), {})
    assert says in str(error.value)
    assert never not in str(error.value)
