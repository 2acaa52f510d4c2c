"""``witness``: a point where a claim for all values fails."""

from __future__ import annotations

from typing import Any

import pytest

from tests.check.support import proves, verdict

BOX = {"x": ["0", "2"]}
CLAIM = ["not", ["<", ["pow", "x", "2"], "2"]]


def refutes(claim: Any, point: Any, variables: Any = BOX, **fields: Any) -> bool:
    return proves(claim, "witness", point=point, variables=variables, **fields)


@pytest.mark.parametrize(
    ("value", "good"),
    [("3/2", True), ("7/5", False), ("141421356237/100000000000", False),
     ("141421356238/100000000000", True), ("1999/1000", True), ("2", False), ("3", False),
     ("0", False), ("-3/2", False)],
)  # fmt: skip
def test_points(value: str, good: bool) -> None:
    assert refutes(CLAIM, {"x": value}) is good


@pytest.mark.parametrize(("relation", "good"), [("<", True), ("<=", False), ("=", False)])
def test_on_the_border(relation: str, good: bool) -> None:
    assert refutes(["not", [relation, "x", "1"]], {"x": "1"}) is good


def test_equations() -> None:
    assert refutes(["not", ["=", ["pow", "x", "2"], "x"]], {"x": "1/2"})
    assert not refutes(["not", ["=", ["pow", "x", "2"], "x"]], {"x": "1"})
    root = ["not", ["=", ["sqrt", "x"], "x"]]
    assert refutes(root, {"x": "1/2"})
    assert not refutes(root, {"x": "1"})


def test_the_ends_are_not_inside() -> None:
    claim = ["not", ["<", "x", "1"]]
    assert "inside" in verdict(claim, "witness", point={"x": "2"}, variables=BOX)
    assert "inside" in verdict(["not", ["<", "0", "x"]], "witness", point={"x": "0"}, variables=BOX)
    assert refutes(claim, {"x": "2"}, {"x": ["0", None]})
    assert refutes(["not", ["<", "0", "x"]], {"x": "0"}, {"x": [None, "1"]})
    assert refutes(["not", ["<", "0", "x"]], {"x": "-7"}, {"x": [None, None]})


@pytest.mark.parametrize("point", [{}, {"y": "1"}, {"x": "3/2", "y": "1"}, {"x": "3/2", "k": "1"}])
def test_each_variable_has_a_value_and_nothing_else(point: dict[str, str]) -> None:
    found = verdict(CLAIM, "witness", point=point, variables=BOX, constants={"k": "1"})
    assert "found a point with" in found


def test_two_variables() -> None:
    box = BOX | {"y": [None, None]}
    claim = ["not", ["<=", ["add", "x", "y"], "3"]]
    assert refutes(claim, {"x": "1", "y": "201/100"}, box)
    assert not refutes(claim, {"x": "1", "y": "2"}, box)
    assert not refutes(claim, {"x": "201/100", "y": "1"}, box)


def test_undefined_at_the_point() -> None:
    claim = ["not", ["<", ["div", "1", ["sub", "x", "1"]], "0"]]
    assert refutes(claim, {"x": "3/2"})
    assert "contains 0" in verdict(claim, "witness", point={"x": "1"}, variables=BOX)


def test_a_point_does_not_prove_a_claim_for_all_values() -> None:
    found = verdict(["<", "x", "1"], "witness", point={"x": "1/2"}, variables=BOX)
    assert "expected witness" in found
    assert not proves(["not", ["<", "2", "1"]], "witness", point={})
    double = ["not", ["not", ["<", "x", "1"]]]
    assert not refutes(double, {"x": "1/2"})
    assert refutes(["not", double], {"x": "3/2"})


def test_a_row_may_not_define_what_another_needs() -> None:
    found = verdict(["<", "x", "1"], "interval", variables={})
    assert found.startswith("malformed")
