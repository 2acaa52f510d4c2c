"""Claims that told mutants of the checker from the checker itself."""

from __future__ import annotations

from typing import Any

import pytest

from tests.check.support import proves


def distance(point: str) -> list[Any]:
    """(M - point)^2, written as a product."""
    return ["mul", ["sub", "M", point], ["sub", "M", point]]


@pytest.mark.parametrize(
    ("claim", "least", "entry"),
    [
        # false at M = 2 and true at the other entry: the factor changes its sign in between
        (["<=", "1/2", distance("11/5")], "2", "3"),
        (["<=", distance("14/5"), "1/10"], "2", "3"),
        (["<=", "1/2", ["pow", ["sub", "M", "11/5"], "2"]], "2", "3"),
        # a cosine falls here, and rises elsewhere: its direction is never used
        (["<=", ["cos", "M"], "-1/2"], "2", "3"),
        (["<=", ["cos_pi", "M"], "0"], "1/4", "3/4"),
        (["<=", "0", ["cos", "M"]], "4", "6"),
        # a quotient falls with its divisor only where the numerator is not negative
        (["<=", "0", ["div", ["sub", "M", "5/2"], "M"]], "2", "3"),
    ],
)
def test_an_unknown_direction_is_refused(claim: Any, least: str, entry: str) -> None:
    constants = {"M": ["min", least, entry]}
    assert not proves(claim, "rewrite", constants=constants, steps=[["M", 1]], closing="interval")


def test_a_known_direction_is_accepted() -> None:
    claim = ["<=", ["mul", "M", "M"], "9"]
    constants = {"M": ["min", "2", "3"]}
    assert proves(claim, "rewrite", constants=constants, steps=[["M", 1]], closing="interval")


def test_a_side_that_may_be_negative_has_no_square() -> None:
    assert not proves(
        ["<=", "0", "x"],
        "square",
        variables={"x": ["-3", "1"]},
        then={"rule": "interval", "bits": 64},
    )


@pytest.mark.parametrize(
    ("polynomial", "degree", "good"),
    [
        (["add", ["div", "x", "c"], ["sub", "1", "x"]], 1, True),
        (["sub", ["div", "x", "c"], "1/4"], 1, False),
        (["add", ["mul", "c", ["pow", "x", "2"]], ["sub", "1", ["mul", "2", "x"]]], 4, True),
        (["add", ["mul", "c", ["pow", "x", "2"]], ["sub", "1/3", ["mul", "2", "x"]]], 4, False),
        (["mul", "c", ["mul", "x", ["sub", "1", "x"]]], 2, True),
        (["mul", "c", ["mul", "x", ["sub", "1", "x"]]], 1, False),
    ],
)
def test_bernstein_with_named_constants(polynomial: Any, degree: int, good: bool) -> None:
    """The constants come first, so that the variable is not the first symbol."""
    found = proves(
        ["<", "0", polynomial],
        "bernstein",
        constants={"b": "7", "c": "2"},
        variables={"x": ["0", "1"]},
        degree=degree,
    )
    assert found == good
