"""Derivatives in pages: what `diff(f, x)` is, where it has a value, and what is refused."""

from __future__ import annotations

import math

import pytest

from verify.language.statement import PROVED, UNDECIDED
from verify.language.terms import Claim
from verify.prover.budget import WorkBudget
from verify.wire.inputs import InputError
from verify.wire.questions import decide_page
from verify.wire.text.estimates import estimate
from verify.wire.text.read_page import read_page

HEAD = """
title = "slopes"
[constants]
a = "sqrt(2)"
{let}
[contexts.c]
variables = "x y"
given = [{given}]
constants = {{ u = "x^2" }}
rows = {{ row = "{claim}" }}
"""
LET = '[let]\n"f(t)" = "a*t^3 - 1/t"'
STEP = 1e-5


def page(claim: str, given: str = '"0 < x < 1", "0 < y < 1"') -> bytes:
    let = LET if "f(" in claim.replace("diff(", "") else ""
    return HEAD.format(claim=claim, given=given, let=let).encode()


@pytest.mark.parametrize(
    "term",
    [
        "x^3*y - y^2/x",
        "sin(x*y) + cos(pi*x)*exp(y)",
        "x^x",
        "arctan(sqrt(x)) - arcsin(x)",
        "tanh(x)/cosh(x*y)",
        "root(x, 3)^2 + log(1 + x^2)",
        "f(x^2)*f(y)",
        "diff(x^4*y, x)",
    ],
)
def test_it_is_the_limit_of_quotients(term: str) -> None:
    (row,) = read_page("p.toml", page(f"{term} = diff({term}, x)")).statement.obligations
    assert isinstance(row.claim, Claim)

    def at(x: float) -> tuple[float, float]:
        values = {"x": x, "y": 0.7, "a": math.sqrt(2)}
        return estimate(row.claim.lhs, values), estimate(row.claim.rhs, values)

    ((below, _), (_, slope), (above, _)) = (at(0.3 + step) for step in (-STEP, 0, STEP))
    assert slope == pytest.approx((above - below) / (2 * STEP), rel=1e-6)


@pytest.mark.parametrize(
    ("claim", "given", "found"),
    [
        ("diff(log(x), x) = 1/x", "0 < x", PROVED),
        ("diff(log(x), x) = 1/x", "x < 0", UNDECIDED),
        ("diff(sqrt(x), x) >= 1/2", "0 < x <= 1", PROVED),
        ("diff(sqrt(x), x) >= 1/2", "0 <= x <= 1", UNDECIDED),
        ("diff(x + 1/y, x) = 1", "0 < y", PROVED),
        ("diff(x + 1/y, x) = 1", "0 <= y", UNDECIDED),
        ("diff(a^2 + y, x) = 0", "0 < y", PROVED),
        ("diff(f(x), x) = 3*a*x^2 + 1/x^2", "0 < x", PROVED),
    ],
)
def test_it_has_a_value_where_the_term_has_one_near_by(claim: str, given: str, found: str) -> None:
    text = page(claim, f'"{given}"')
    outcome = decide_page(read_page("p.toml", text), WorkBudget(1_000_000))
    assert {decision.verdict for _, decision in outcome.rows} == {found}


@pytest.mark.parametrize(
    ("claim", "told"),
    [
        ("diff(|x|, x) < 1", "a minimum, a maximum or a modulus has corners: use its parts"),
        ("diff(u*x, x) < 1", "u may depend on x: use its formula"),
        ("diff(f(a), a) < 1", "a derivative is by a variable; write diff"),
        ("diff(x^2, 2*x) < 1", "a derivative is by a variable; write diff"),
        ("diff(x^2) < 1", "a derivative is of a term by a variable, not of 1"),
        ("derivative(x^2, x) < 1", "'derivative' is no function; write diff"),
    ],
)
def test_what_is_refused(claim: str, told: str) -> None:
    with pytest.raises(InputError) as error:
        read_page("p.toml", page(claim))
    assert told in str(error.value)
