"""``bernstein``: the coefficients of rhs - lhs on an interval have no sign change."""

from __future__ import annotations

from typing import Any

import pytest

from tests.check.support import proves, verdict

UNIT = {"x": ["0", "1"]}


def holds(claim: Any, degree: int, variables: Any = UNIT, **fields: Any) -> bool:
    return proves(claim, "bernstein", degree=degree, variables=variables, **fields)


def polynomial(*coefficients: str) -> Any:
    term: Any = coefficients[0]
    for k, coefficient in enumerate(coefficients[1:], 1):
        term = ["add", term, ["mul", coefficient, ["pow", "x", str(k)]]]
    return term


@pytest.mark.parametrize(
    ("coefficients", "degree", "good"),
    [
        (("1", "-2", "1"), 2, True),  # (1-x)^2: 1, 0, 0
        (("1", "-2", "10001/10000"), 2, True),
        (("1", "-2", "9999/10000"), 2, False),
        (("1", "-20001/10000", "1"), 2, False),
        (("0", "1", "-1"), 2, True),  # x(1-x): 0, 1/2, 0
        (("0", "1", "-10001/10000"), 2, False),
        (("1/3", "-1", "1"), 2, False),  # positive, but 1/3, -1/6, 1/3 at degree 2
        (("1/3", "-1", "1"), 3, True),  # 1/3, 0, 0, 1/3
        (("1/3", "-1", "1"), 12, True),
        (("1/4", "-1", "1"), 50, False),  # vanishes at 1/2
        (("0", "0", "0", "0", "1"), 4, True),
        (("0", "0", "0", "0", "1"), 3, False),  # the degree is too low
        (("0", "0", "0", "0", "-1"), 4, False),
    ],
)  # fmt: skip
def test_on_the_unit_interval(coefficients: tuple[str, ...], degree: int, good: bool) -> None:
    assert holds(["<=", "0", polynomial(*coefficients)], degree) is good
    assert holds(["<", "0", polynomial(*coefficients)], degree) is good


def test_zero_is_not_positive() -> None:
    assert holds(["<=", "x", "x"], 1)
    assert not holds(["<", "x", "x"], 1)
    assert holds(["<=", "0", "0"], 0)
    assert not holds(["<", "0", "0"], 0)
    assert holds(["<", "0", "1"], 0)


@pytest.mark.parametrize(
    ("ends", "good"),
    [(["1", "2"], True), (["9/10", "2"], False), (["1", "21/10"], False), (["3/2", "7/4"], True)],
)
def test_on_other_intervals(ends: list[str], good: bool) -> None:
    claim = ["<=", "0", ["mul", ["sub", "x", "1"], ["sub", "2", "x"]]]
    assert holds(claim, 2, {"x": ends}) is good


def test_negative_ends() -> None:
    assert holds(["<", ["pow", "x", "3"], "0"], 3, {"x": ["-5", "0"]})
    assert not holds(["<", ["pow", "x", "3"], "0"], 3, {"x": ["-5", "1/100"]})
    assert not holds(["<", "0", ["pow", "x", "3"]], 3, {"x": ["-5", "0"]})


@pytest.mark.parametrize(("bound", "good"), [("119/100", True), ("121/100", False)])
def test_coefficients_keep_their_size(bound: str, good: bool) -> None:
    """x/a + b x^2 - 3/2 is at most 3 + 1/5 - 2 = 6/5, and at least 6/5 at x = 1."""
    constants = {"zero": "0", "a": "1/3", "b": ["div", "1", "5"], "c": ["div", "2", "1"]}
    sum_ = ["add", ["div", "x", "a"], ["mul", "b", ["pow", "x", "2"]]]
    claim = ["<=", bound, ["sub", sum_, "c"]]
    assert holds(claim, 2, {"x": ["1", "2"]}, constants=constants) is good
    other = ["<=", ["sub", sum_, "c"], ["neg", ["sub", "0", "6/5"]]]
    assert holds(other, 2, constants=constants)
    assert holds(other, 3, {"x": ["-1", "1"]}, constants=constants)
    assert not holds(other, 2, {"x": ["0", "101/100"]}, constants=constants)
    assert not holds(other, 1, constants=constants)


def test_constants_of_rational_value() -> None:
    constants = {"a": "1/3", "b": ["sqrt", ["mul", "a", "3/4"]]}
    claim = ["<=", "0", ["add", ["mul", "b", "x"], ["div", "x", "a"]]]
    assert holds(claim, 1, constants=constants)
    assert not holds(["<=", "0", ["sub", ["mul", "b", "x"], ["div", "x", "a"]]], 1,
                     constants=constants)  # fmt: skip
    found = verdict(["<=", "0", ["mul", "r", "x"]], "bernstein", degree=1, variables=UNIT,
                    constants={"r": ["sqrt", "2"]})  # fmt: skip
    assert "found a coefficient in" in found


@pytest.mark.parametrize(
    "term",
    [
        ["div", "1", ["add", "1", "x"]],
        ["sqrt", ["add", "1", "x"]],
        ["max", "x", "1/2"],
        ["cos", "x"],
    ],
)
def test_what_is_no_polynomial(term: object) -> None:
    assert not holds(["<=", "0", term], 8)


def test_undefined_terms_do_not_cancel() -> None:
    root = ["sqrt", ["sub", "x", "1/2"]]
    claim = ["<=", "0", ["add", "1", ["sub", root, root]]]
    assert "below 0" in verdict(claim, "bernstein", degree=3, variables=UNIT)
    inverse = ["div", "1", ["div", "1", "x"]]
    assert "contains 0" in verdict(["<=", "0", inverse], "bernstein", degree=3, variables=UNIT)


@pytest.mark.parametrize(
    ("claim", "variables"),
    [
        (["=", "x", "x"], UNIT),
        (["<=", "0", "1"], {}),
        (["<=", "0", "x"], {"x": ["0", None]}),
        (["<=", "0", ["pow", "x", "2"]], {"x": [None, None]}),
        (["<=", "0", ["mul", "x", "y"]], {"x": ["0", "1"], "y": ["0", "1"]}),
        (["<=", "0", "x"], {"x": ["0", "1"], "y": ["0", "1"]}),
        (["<=", "0", "x"], {"x": ["0", "1"], "y": [None, "1"]}),
    ],
)
def test_where_it_does_not_apply(claim: object, variables: object) -> None:
    assert not holds(claim, 4, variables)


@pytest.mark.parametrize("degree", [257, -1, True, "2", None, [2]])
def test_degrees_that_are_none(degree: object) -> None:
    found = verdict(["<=", "0", "x"], "bernstein", degree=degree, variables=UNIT)
    assert found.startswith("malformed")
