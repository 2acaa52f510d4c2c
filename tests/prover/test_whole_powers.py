"""Claims about products that are given: by powers of both sides, and never more than is true."""

from __future__ import annotations

from fractions import Fraction

import pytest

from verify import check
from verify.language.terms import Claim, Number, Term, equal, symbol
from verify.library import ask, certificate, for_all, lemma, prove
from verify.prover.budget import WorkBudget
from verify.prover.outcome import Outcome
from verify.wire.inputs import InputError
from verify.wire.questions import decide_page
from verify.wire.text.read_page import read_page

a, b, c = map(symbol, "abc")
POSITIVE = [0 < a, 0 < b, 0 < c]
ONE = for_all("one", [*POSITIVE, equal(a * b * c, 1)], {"a": 1, "b": 1, "c": 1})
EIGHT = for_all("eight", [*POSITIVE, equal(8, a * b * c)], {"a": 2, "b": 2, "c": 2})
TWO = for_all("two", [0 < a, 0 < b, equal(a * b, 2)], {"a": 1, "b": 2})


def verdict(claim: Claim, context: object) -> str:
    """What is found, after the checker has agreed."""
    outcome = prove(lemma("t", [ask("row", claim, context)], (), [context]))  # type: ignore[arg-type,list-item]
    if outcome.verdict != "undecided":
        check_files(outcome)
    return outcome.decisions["row"].verdict


def check_files(outcome: Outcome) -> None:
    """The checker agrees on all rows."""
    files = certificate(outcome)
    report = check.check(files["statement.json"], files["certificate.json"], {})
    assert report.rows == {row.name: decision.verdict for row, decision in outcome.rows}


@pytest.mark.parametrize(
    ("least", "term", "context"),
    [
        (3, a + b + c, ONE),
        (3, a * b + b * c + c * a, ONE),
        (6, a + b + c, EIGHT),
        (12, a * b + b * c + c * a, EIGHT),
        (Fraction(28, 10), a + b, TWO),
    ],
)
def test_a_least_value_is_found_and_no_larger_one(
    least: Number, term: Term, context: object
) -> None:
    assert verdict(least <= term, context) == "proved"
    assert verdict(least + Fraction(1, 2) <= term, context) != "proved"


def test_atoms_of_an_equation_are_not_looked_up_among_those_of_the_claim() -> None:
    """The search ended with a KeyError, told as the reason."""
    text = """title = "t"
constants = { q = "sqrt(2) - 1" }
[contexts.o]
variables = "x y"
given = ["x = q", "y = x^2", "0 < y"]
[rows]
a = "y < 1/10"
b = "y = 3 - 2*sqrt(2)"
d = "y < 3 - 2*sqrt(2)"
f = "x + y > 1"
g = "x + y < 1"
"""
    page = read_page("f.toml", text.encode())
    found = {
        name: d.claimed for name, d in decide_page(page, WorkBudget(300_000)).decisions.items()
    }
    assert found == {"a": "refuted", "b": "proved", "d": "refuted", "f": "refuted", "g": "proved"}


@pytest.mark.parametrize(
    ("row", "found"),
    [
        ("0 <= x^9890", "proved"),
        ("0 <= x^9891", "refuted"),
        ("x^2003/x^2000 = x^3", "undecided"),
        ("(x^2 + 1)*x^1999 = x^2001 + x^1999", "proved"),
        ("-0.15921 < sin(2^1000) < -0.1592", "proved"),
        ("1.0001^9999 < e < 1.0001^10001", "proved"),
        ("1.0001^10001 < e", "refuted"),
    ],
)
def test_large_exponents(row: str, found: str) -> None:
    """Powers of powers; at x = 0 the quotient has no value."""
    text = f'title = "t"\n[contexts.c]\nvariables = "x"\ngiven = []\n[rows]\nr = "{row}"\n'
    outcome = decide_page(read_page("f.toml", text.encode()), WorkBudget(300_000))
    assert {decision.claimed for _, decision in outcome.rows} == {found}
    check_files(outcome)


def test_products_of_large_powers_keep_to_the_exponents_of_the_checker() -> None:
    text = """title = "t"
[contexts.c]
variables = "x"
given = ["0 <= x <= 1"]
[rows]
r = "x^2003 <= x^2000"
"""
    outcome = decide_page(read_page("f.toml", text.encode()), WorkBudget(5_000_000))
    assert outcome.verdict == "proved"
    check_files(outcome)


def test_an_exponent_that_is_not_read() -> None:
    text = 'title = "t"\n[rows]\nr = "0 < 2^100000"\n'
    with pytest.raises(InputError, match="write m or m/n, m from 1 to 99999"):
        read_page("f.toml", text.encode())
