"""Vectors, matrices and functions in pages: what they mean, and what is refused."""

from __future__ import annotations

import random
import time

import pytest
import sympy

from tests.paper.spectrum.test_rows import to_sympy
from verify.language.argument import Line
from verify.language.statement import PROVED, UNDECIDED
from verify.language.terms import Claim, Term
from verify.wire.inputs import InputError
from verify.wire.questions import decide
from verify.wire.text import Page
from verify.wire.text.read_page import read_page

HEAD = """
title = "tables"

[let]
{let}

[contexts.c]
variables = "x y"
point = "x = 1, y = 2"

[rows]
row = {{ claim = "{claim}", in = "c" }}
"""


def page(let: str, claim: str) -> Page:
    return read_page("p.toml", HEAD.format(let=let, claim=claim).encode())


def left(let: str, formula: str) -> Term:
    (row,) = page(let, f"{formula} = 0").statement.obligations
    assert isinstance(row.claim, Claim)
    return row.claim.lhs


def value(let: str, formula: str) -> sympy.Expr:
    return to_sympy(left(let, formula), {name: sympy.Symbol(name) for name in "xy"})


def drawn(choice: random.Random, rows: int, columns: int) -> list[list[int]]:
    """Entries of which many are 0 or 1."""
    return [[choice.choice((0, 0, 1, -1, 2, 3)) for _ in range(columns)] for _ in range(rows)]


@pytest.mark.parametrize("seed", range(40))
def test_what_tables_are_is_what_sympy_says(seed: int) -> None:
    choice = random.Random(seed)
    n, m = choice.randint(1, 4), choice.randint(1, 4)
    a, b, s = drawn(choice, n, m), drawn(choice, m, n), drawn(choice, n, n)
    (u,), (v,), (w,) = drawn(choice, 1, n), drawn(choice, 1, m), drawn(choice, 1, n)
    names = {"a": a, "b": b, "s": s, "u": u, "v": v, "w": w}
    let = "\n".join(f"{name} = {entries}" for name, entries in names.items())
    A, B, S = map(sympy.Matrix, (a, b, s))
    U, V, W = map(sympy.Matrix, (u, v, w))
    i, j = choice.randint(1, n), choice.randint(1, n)
    for formula, expected in (
        ("det(s)", S.det()),
        ("det(2*s - a*b)", (2 * S - A * B).det()),
        (f"(a*b)[{i}, {j}]", (A * B)[i - 1, j - 1]),
        (f"(-s/3)[{i}, {j}]", -S[i - 1, j - 1] / sympy.Integer(3)),
        (f"s[{i}]*w", (S[i - 1, :] * W)[0]),
        ("u*(a*v)", (U.T * A * V)[0]),
        ("u*a*v", (U.T * A * V)[0]),
        ("form(u, a, v)", (U.T * A * V)[0]),
        ("(u + 2*w)*w", ((U + 2 * W).T * W)[0]),
    ):
        assert value(let, formula) == expected, formula


def test_zero_and_one_are_not_written_out() -> None:
    let = "e = [0, 1]\nA = [[2, 0], [1, 3]]"
    assert left(let, "e*(A*[x, y])") == left("", "x + 3*y")
    assert left(let, "det([[x, 0], [0, 1]])") == left("", "x")
    assert left(let, "form([x, 0], A, [0, y])") == left("", "0")


def test_a_function_is_its_formula_with_the_values() -> None:
    let = '"f(x, k)" = "x*k - k"'
    assert left(let, "f(y, x + 1)") == left("", "y*(x + 1) - (x + 1)")
    let += '\n"A(x)" = [["x", 1], [0, "f(x, 2)"]]'
    assert value(let, "det(A(y))") == value("", "y*(y*2 - 2)")


@pytest.mark.parametrize(
    ("let", "formula", "told"),
    [
        ("A = [[1, 2], [3]]", "det(A)", "different lengths"),
        ("A = []", "det(A)", "no entry"),
        ("A = [[1, 2], 3]", "det(A)", "is no list"),
        ("A = [true, 2]", "A[1]", "is no text"),
        (f"A = {[1] * 9}", "A[1]", "more than 8"),
        ("A = [1, 2]", "A", "where a number is needed"),
        ("A = [1, 2]", "A + x", "have no sum"),
        ("A = [1, 2]", "A + [1, 2, 3]", "have no sum"),
        ("A = [1, 2]", "A*[1, 2, 3]", "have no product"),
        ("A = [1, 2]", "x/A", "no divisor"),
        ("A = [1, 2]", "A^2", "where a number is needed"),
        ("A = [1, 2]", "sqrt(A)", "where a number is needed"),
        ("A = [1, 2]", "max(A, x)", "where a number is needed"),
        ("A = [1, 2]", "|A|", "where a number is needed"),
        ("A = [1, 2]", "A[3]", "has no entry"),
        ("A = [1, 2]", "A[0]", "has no entry"),
        ("A = [1, 2]", "A[-1]", "has no entry"),
        ("A = [1, 2]", "A[1, 1]", "has no entry"),
        ("A = [1, 2]", "A[x]", "no whole number"),
        ("A = [1, 2]", "A[1/2]", "no whole number"),
        ("A = [1, 2]", "det(A)", "of a matrix"),
        ("A = [[1, 2]]", "det(A)", "square"),
        ("A = [1, 2]", "form(A, A, A)", "a vector, a matrix and a vector"),
        ("A = [1, 2]", "form(A, A)", "form is of 3"),
        ("", "[x, [y]]*[x, y]", "entry of a table is a table"),
        ('"f(z)" = "z + x"', "f(1)", "'x' is not defined|is a name of the context"),
        ('"f(z)" = "z"', "f(1, 2)", "write f"),
        ('"f(z)" = "z"', "x", "not used"),
        ('"f(z, z)" = "z"', "f(1, 2)", "twice"),
        ('"sin(z)" = "z"', "sin(1)", "stands for something"),
        ('f = "1"\n"f(z)" = "z"', "f(1)", "stands for something"),
        ('"f(z)" = "f(z - 1)"', "f(1)", "no function"),
        ('"f(z)" = "z"', "f([1, 2])", "where a number is needed"),
    ],
)
def test_what_is_refused(let: str, formula: str, told: str) -> None:
    with pytest.raises(InputError, match=told):
        left(let, formula)


def test_an_author_may_ask_of_a_matrix() -> None:
    asked = page('M = [[2, 1], [1, 2]]\n"q(s, t)" = "[s, t]*(M*[s, t])"', "q(x, y) >= 0")
    assert decide(asked.statement).verdict == PROVED


CHAPTERS = """
title = "places"
[contexts.c]
variables = "x"
given = ["x > 1"]
[contexts.d]
variables = ".x"
given = ["0 < x < 1"]
[[chapters]]
in = "c"
[chapters.rows]
large = { claim = "x^2 > x" }
small = { claim = "x^2 < x", in = "d" }
number = { claim = "1 < 2", in = "" }
"""


def test_a_line_may_name_its_context() -> None:
    found = read_page("p.toml", CHAPTERS.encode())
    assert [row.context for row in found.statement.obligations] == ["c", "d", None]
    lines = [(c.context, i.name) for c in found.chapters for i in c.items if isinstance(i, Line)]
    assert lines == [("c", "large"), ("d", "small"), (None, "number")]
    assert decide(found.statement).verdict == PROVED
    with pytest.raises(InputError, match="no context"):
        read_page("p.toml", CHAPTERS.replace('in = "d"', 'in = "e"').encode())


def test_fractions_are_exact() -> None:
    assert value('A = [["0.1", "1/3"]]', "A[1, 1] + A[1, 2]") == sympy.Rational(13, 30)


FUNCTIONS = "".join(f'"f{i}(x)" = "f{i - 1}(x)*f{i - 1}(x + 1)"\n' for i in range(1, 40))
CONSTANTS = "".join(f"c{i} = 1\n" for i in range(12_000))
VECTORS = ", ".join(f'W{i} = "W{i - 1} + W{i - 2}"' for i in range(2, 60))
OF_VECTORS = f"""[contexts.c]
variables = "x"
gram = {{ V = "1" }}
vectors = {{ W0 = "V", W1 = "V", {VECTORS} }}"""


@pytest.mark.parametrize(
    "text",
    {
        "functions": f'[let]\n"f0(x)" = "x + 1"\n{FUNCTIONS}[rows]\nrow = "0 < f39(1)"',
        "constants": f'[constants]\n{CONSTANTS}[rows]\nrow = "0 < c1"',
        "abbreviations": f'[let]\n{CONSTANTS}[rows]\nrow = "0 < c1"',
        "vectors": f'{OF_VECTORS}\n[rows]\nrow = {{ claim = "0 < dot(W59, V)", in = "c" }}',
    }.values(),
    ids=["functions", "constants", "abbreviations", "vectors"],
)
def test_a_page_that_would_take_long_is_refused(text: str) -> None:
    begin = time.process_time()
    with pytest.raises(InputError):
        read_page("p.toml", f'title = "t"\n{text}'.encode())
    assert time.process_time() - begin < 6


@pytest.mark.parametrize(
    "claim",
    [
        "det([[0, log(-x)], [0, 1]]) = 0",
        "[0, 1]*[log(-x), 1] = 1",
        "form([0, 0], [[log(-x), 1], [1, 1]], [0, 0]) = 0",
        "(0*[log(-x), 2])[1] = 0",
        "([0, 1]/log(-x))[1] = 0",
        "first(3, log(-x)) = 3",
        "first(3, [log(-x), 1]) = 3",
        "first([3, 1], log(-x))[1] = 3",
        "sum(sqrt(-x)^k, k, 0, 0) = 1",
        "prod(k/(x - x), k, 0, 2) = 0",
    ],
)
def test_what_has_no_value_stays(claim: str) -> None:
    """A factor 0 takes nothing away that has no value; x is positive."""
    asked = page(
        '"first(a, b)" = "a"', f'first(1, x) = 1", in = "c" }}\nother = {{ claim = "{claim}'
    )
    first, other = decide(asked.statement).decisions.values()
    assert first.verdict == PROVED
    assert other.verdict == UNDECIDED
