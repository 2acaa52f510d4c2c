"""``range``: the ends between which the values of a function lie."""

from __future__ import annotations

import pytest

from tests.check.support import Pair, ground, verdict

RANGE = {"rule": "range"}
WRONG = "expected an end of the range"


CASES = [
    ("0 < exp(x)", "proved"),
    ("0 < exp(x/p)", "proved"),
    ("-1 <= sin(x)", "proved"),
    ("sin(x) <= 1", "proved"),
    ("-1 <= cos(x)", "proved"),
    ("cos(x) <= 1", "proved"),
    ("-1 <= cos_pi(x)", "proved"),
    ("cos_pi(x) <= 1", "proved"),
    ("-(pi()/2) < atan(x)", "proved"),
    ("atan(x) < pi()/2", "proved"),
    ("atan(x) <= pi()/2", WRONG),
    ("-(pi()/2) <= atan(x)", WRONG),
    ("atan(x) < pi()/3", WRONG),
    ("-(pi()/3) < atan(x)", WRONG),
    ("pi()/2 < atan(x)", WRONG),
    ("atan(x) < -(pi()/2)", WRONG),
    ("0 <= exp(x)", WRONG),
    ("1 < exp(x)", WRONG),
    ("exp(x) < 0", WRONG),
    ("0 = exp(x)", WRONG),
    ("exp(x) <= 1", WRONG),
    ("sin(x) < 1", WRONG),
    ("-1 < sin(x)", WRONG),
    ("sin(x) = 1", WRONG),
    ("sin(x) <= 0", WRONG),
    ("sin(x) <= -1", WRONG),
    ("0 <= sin(x)", WRONG),
    ("1 <= cos(x)", WRONG),
    ("0 < sin(x)", WRONG),
    ("0 < log(p)", WRONG),
    ("-1 <= log(p)", WRONG),
    ("0 < x", WRONG),
    ("0 < exp(1/x)", "a division by a term"),
    ("atan(sqrt(x)) < pi()/2", "the root of a term"),
]


def statement(claim: str) -> Pair:
    """The claim, as a range for any x and a positive p."""
    pair = Pair().context("c", {"x": "0", "p": "1"}, {"p-pos": "0 < p"})
    return pair.row("row", claim, RANGE, "c")


@pytest.mark.parametrize(("claim", "found"), CASES)
def test_ranges(claim: str, found: str) -> None:
    assert found in verdict(statement(claim))


@pytest.mark.parametrize("claim", ["x < 3", "3 < x", "x < p", "p < x", "x < 1", "1 < x"])
def test_the_first_terms_of_a_statement_are_no_ends(claim: str) -> None:
    """Neither 3, which is the first term of this statement, nor p, which is the second."""
    pair = Pair().parameter("p", "3").context("c", {"x": "1"}, {})
    assert WRONG in verdict(pair.row("row", claim, RANGE, "c"))


def test_without_variables() -> None:
    assert ground("0 < exp(-10**999)", RANGE) == "proved"
