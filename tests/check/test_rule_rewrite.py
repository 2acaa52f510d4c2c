"""``rewrite``: symbols give way to definitions and entries, then an interval or an identity."""

from __future__ import annotations

from typing import Any

import pytest

from tests.check.support import proves, verdict

R3 = ["sqrt", "3"]


def rewrites(claim: Any, steps: list[Any], closing: str = "identity", **fields: Any) -> bool:
    return proves(claim, "rewrite", steps=steps, closing=closing, **fields)


def why(claim: Any, steps: list[Any], closing: str = "identity", **fields: Any) -> str:
    return verdict(claim, "rewrite", steps=steps, closing=closing, **fields)


# --- identities ----------------------------------------------------------------------------------

FREE = {name: [None, None] for name in "xyz"}


@pytest.mark.parametrize(
    ("lhs", "rhs", "good"),
    [
        (["pow", ["add", "x", "y"], "2"],
         ["add", ["add", ["pow", "x", "2"], ["mul", "2", ["mul", "x", "y"]]], ["pow", "y", "2"]],
         True),
        (["pow", ["add", "x", "y"], "2"],
         ["add", ["add", ["pow", "x", "2"], ["mul", "3", ["mul", "x", "y"]]], ["pow", "y", "2"]],
         False),
        (["mul", "x", "y"], ["mul", "y", "x"], True),
        (["mul", "x", "y"], ["mul", "y", "y"], False),
        (["sub", "x", "y"], ["neg", ["sub", "y", "x"]], True),
        (["sub", "x", "y"], ["neg", ["sub", "x", "y"]], False),
        (["add", "x", "y"], ["add", "x", "z"], False),
        (["mul", "1/3", "x"], ["div", "x", "3"], True),
        (["mul", "1/3", "x"], ["div", "x", "1000000001/333333333"], False),
        (["div", "x", ["div", "2", "3"]], ["mul", "3/2", "x"], True),
        (["mul", R3, ["mul", R3, "x"]], ["mul", "3", "x"], True),
        (["mul", R3, ["mul", R3, "x"]], ["mul", "4", "x"], False),
        (["pow", R3, "5"], ["mul", "9", R3], True),
        (["pow", R3, "5"], ["mul", "9", ["sqrt", "5"]], False),
        (["pow", R3, "3"], ["mul", "9", R3], False),
        (["div", "1", ["sub", R3, "1"]], ["div", ["add", R3, "1"], "2"], True),
        (["div", "1", ["sub", R3, "1"]], ["div", ["add", R3, "1"], "3"], False),
        (["sub", "x", "x"], "0", True),
        (["pow", "x", "3"], ["mul", "x", ["mul", "x", "x"]], True),
        (["pow", "x", "3"], ["mul", "x", "x"], False),
        (["min", "1", "2"], ["min", "1", "2"], True),
        (["min", "1", "2"], ["max", "1", "2"], False),
        (["cos", "1"], ["cos", "1"], True),
        (["cos", "1"], ["cos_pi", "1"], False),
    ],
)  # fmt: skip
def test_identities(lhs: object, rhs: object, good: bool) -> None:
    assert rewrites(["=", lhs, rhs], [], variables=FREE) is good
    assert rewrites(["<=", lhs, rhs], [], variables=FREE) is good


def test_nested_roots() -> None:
    inner = ["sub", "2", R3]
    root = ["sqrt", inner]
    square = ["pow", ["sub", ["sqrt", "6"], ["sqrt", "2"]], "2"]
    assert rewrites(["=", ["pow", root, "4"], ["pow", inner, "2"]], [])
    assert rewrites(["=", ["mul", "4", ["pow", root, "2"]], ["sub", "8", ["mul", "4", R3]]], [])
    assert not rewrites(["=", ["mul", "4", ["pow", root, "2"]], square], [])  # needs √12 = 2√3
    quotient = ["sqrt", ["div", "2", R3]]
    assert rewrites(["=", ["mul", R3, ["pow", quotient, "2"]], "2"], [])
    assert not rewrites(["=", ["mul", R3, ["pow", quotient, "2"]], "3"], [])
    assert rewrites(["=", ["div", ["div", "1", quotient], quotient], ["div", R3, "2"]], [])


def test_an_identity_is_not_strict() -> None:
    assert "equal sides" in why(["<", "x", "x"], [], variables=FREE)
    assert not rewrites(["not", ["=", "1", "1"]], [])
    assert rewrites(["not", ["<", "1", "1"]], [])


def test_identities_hold_only_where_both_sides_are_defined() -> None:
    unit = {"x": ["0", "1"]}
    inverse = ["div", "1", ["div", "1", "x"]]
    assert "contains 0" in why(["=", inverse, "x"], [], variables=unit)
    assert rewrites(["=", inverse, "x"], [], variables={"x": ["1/2", "1"]})
    assert "without bounds" in why(["=", inverse, "x"], [], variables={"x": ["1", None]})
    root = ["pow", ["sqrt", "x"], "2"]
    assert rewrites(["=", root, "x"], [], variables=unit)
    assert "below 0" in why(["=", root, "x"], [], variables={"x": ["-1/10", "1"]})
    cancelled = ["sub", ["sqrt", ["neg", "1"]], ["sqrt", ["neg", "1"]]]
    assert "below 0" in why(["=", ["add", "x", cancelled], "x"], [], variables=unit)
    zero = ["mul", "0", ["div", "1", ["sub", "x", "x"]]]
    assert "contains 0" in why(["=", zero, "0"], [], variables=unit)
    bad = {"k": ["div", "1", ["sub", "1/3", "1/3"]]}
    assert "contains 0" in why(["=", ["mul", "x", "k"], ["mul", "k", "x"]], [],
                               variables=unit, constants=bad)  # fmt: skip


def test_0_over_0_is_no_identity() -> None:
    assert not rewrites(["=", ["div", "x", "x"], "1"], [], variables={"x": ["-1", "1"]})
    assert rewrites(["=", ["div", "x", "x"], "1"], [], variables={"x": ["1/9", "1"]})


# --- definitions ---------------------------------------------------------------------------------

CONSTANTS = {
    "a": ["sqrt", "2"],
    "b": ["sub", "a", "1"],
    "low": ["min", "b", ["mul", "1/2", "a"], "1/2"],
    "high": ["max", "b", ["mul", "1/2", "a"], "1/2"],
}


@pytest.mark.parametrize(
    ("claim", "steps", "good"),
    [
        (["=", "b", ["sub", "a", "1"]], [["b", None]], True),
        (["=", "b", ["sub", "a", "1"]], [], False),
        (["=", "b", ["sub", "a", "2"]], [["b", None]], False),
        (["=", ["mul", "b", ["add", "a", "1"]], "1"], [["b", None]], False),
        (["=", ["mul", "b", ["add", "a", "1"]], "1"], [["b", None], ["a", None]], True),
        (["=", ["mul", "b", ["add", "a", "1"]], "1"], [["a", None], ["b", None]], False),
        (["=", ["mul", "b", ["add", "a", "1"]], "1"],
         [["a", None], ["b", None], ["a", None]], True),
        (["=", ["mul", "b", ["add", "a", "1"]], "2"], [["b", None], ["a", None]], False),
    ],
)  # fmt: skip
def test_definitions(claim: object, steps: list[Any], good: bool) -> None:
    assert rewrites(claim, steps, constants=CONSTANTS) is good


def test_interval_closing() -> None:
    claim = ["<", "b", "1/2"]
    assert rewrites(claim, [["b", None]], "interval", constants=CONSTANTS)
    assert not rewrites(["<", "b", "2/5"], [["b", None]], "interval", constants=CONSTANTS)
    shared = ["<=", ["sub", "x", "a"], ["sub", "b", ["sub", "a", "x"]]]
    assert not rewrites(shared, [["b", None]], "interval", constants=CONSTANTS,
                        variables={"x": ["0", "1"]})  # fmt: skip


@pytest.mark.parametrize("name", ["nobody", "x"])
def test_only_constants_have_definitions(name: str) -> None:
    found = why(["=", "x", "x"], [[name, None]], variables={"x": ["0", "1"]}, constants=CONSTANTS)
    assert found.startswith("malformed")
    assert name in found


# --- entries -------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("claim", "step", "good"),
    [
        (["<=", "low", "b"], ["low", 0], True),
        (["<=", "low", ["mul", "1/2", "a"]], ["low", 1], True),
        (["<=", "low", "1/2"], ["low", 2], True),
        (["<=", "low", "b"], ["low", 1], False),
        (["<=", "low", "1/2"], ["low", 3], False),
        (["<=", "b", "low"], ["low", 0], False),
        (["=", "low", "b"], ["low", 0], False),
        (["not", ["<", "b", "low"]], ["low", 0], True),
        (["not", ["<", "low", "b"]], ["low", 0], False),
        (["<=", ["neg", "b"], ["neg", "low"]], ["low", 0], True),
        (["<=", ["sub", "1", "b"], ["sub", "1", "low"]], ["low", 0], True),
        (["<=", ["sub", "1", "low"], ["sub", "1", "b"]], ["low", 0], False),
        (["<=", ["mul", "a", "low"], ["mul", "a", "b"]], ["low", 0], True),
        (["<=", ["mul", "-3", "b"], ["mul", "-3", "low"]], ["low", 0], True),
        (["<=", ["mul", "-3", "low"], ["mul", "-3", "b"]], ["low", 0], False),
        (["<=", ["mul", "low", "low"], ["mul", "b", "b"]], ["low", 0], True),
        (["<=", ["pow", "low", "2"], ["pow", "b", "2"]], ["low", 0], True),
        (["<=", ["pow", ["neg", "low"], "2"], ["pow", "b", "2"]], ["low", 0], True),
        (["<=", ["pow", ["neg", "b"], "3"], ["pow", ["neg", "low"], "3"]], ["low", 0], True),
        (["<=", ["sqrt", "low"], ["sqrt", "b"]], ["low", 0], True),
        (["<=", ["div", "low", "a"], ["div", "b", "a"]], ["low", 0], True),
        (["<=", ["div", "-1", "low"], ["div", "-1", "b"]], ["low", 0], True),
        (["<=", ["div", "1", "b"], ["div", "1", "low"]], ["low", 0], True),
        (["<=", ["div", "1", "low"], ["div", "1", "b"]], ["low", 0], False),
        (["<=", ["min", "low", "low"], ["min", "b", "b"]], ["low", 0], True),
        (["<=", ["max", "low", "1/9"], ["max", "b", "1/9"]], ["low", 0], True),
        (["<=", ["sub", "low", "low"], ["sub", "b", "b"]], ["low", 0], False),
        (["<=", ["cos", "b"], ["cos", "low"]], ["low", 0], False),
        (["<=", ["cos", "low"], ["cos", "b"]], ["low", 0], False),
        (["<=", ["cos_pi", "low"], ["cos_pi", "b"]], ["low", 0], False),
        (["<=", ["mul", "low", ["sub", "low", "b"]], "0"], ["low", 0], False),
        (["<=", ["mul", "low", ["sub", "low", "1/9"]], ["mul", "b", ["sub", "b", "1/9"]]],
         ["low", 0], True),
        (["<=", "b", "high"], ["high", 0], True),
        (["<=", ["mul", "1/2", "a"], "high"], ["high", 1], True),
        (["<=", "1/2", "high"], ["high", 2], True),
        (["<=", "high", "b"], ["high", 0], False),
        (["<=", "high", ["mul", "1/2", "a"]], ["high", 1], False),
        (["<=", ["neg", "high"], ["neg", "b"]], ["high", 0], True),
        (["<=", "b", "b"], ["b", 0], False),
        (["<=", "a", "a"], ["a", 0], False),
    ],
)  # fmt: skip
def test_entries(claim: object, step: list[Any], good: bool) -> None:
    assert rewrites(claim, [step], constants=CONSTANTS) is good


def test_signs_are_judged_on_the_whole_way_to_the_entry() -> None:
    """At low the factor low - 1/2 is negative, at the entry 2 it is positive."""
    constants = {"low": ["min", "1/4", "2"]}
    lhs = ["mul", "low", ["sub", "low", "1/2"]]
    claim = ["<=", lhs, "3"]
    assert not rewrites(claim, [["low", 1]], "interval", constants=constants)
    falls = ["<=", ["neg", lhs], "0"]  # false at 1/4: -1/4 * -1/4 > 0; true at 2
    assert not rewrites(falls, [["low", 1]], "interval", constants=constants)
    even = ["<=", ["pow", ["sub", "low", "1"], "2"], "1"]  # both at 1/4 and at 2, yet it turns
    assert not rewrites(even, [["low", 1]], "interval", constants=constants)


def test_poles_on_the_way_to_the_entry() -> None:
    constants = {"low": ["min", "1/4", "2"]}
    claim = ["<=", ["div", "-1", ["sub", "low", "1"]], "0"]  # 4/3 at 1/4, -1 at 2
    assert not rewrites(claim, [["low", 1]], "interval", constants=constants)


def test_another_constant_keeps_its_value() -> None:
    constants = {"low": ["min", "1/4", "2"], "k": ["mul", "2", "low"]}
    assert rewrites(["<=", "low", ["sub", "5/2", "k"]], [["low", 1]], "interval",
                    constants=constants)  # fmt: skip
    assert not rewrites(["<=", "low", ["sub", "5/2", "k"]], [["low", 1], ["k", None]], "identity",
                        constants=constants)  # fmt: skip

    assert rewrites(["<=", "low", ["add", "3/2", "k"]], [["low", 1]], "interval",
                    constants=constants)  # fmt: skip


def test_entries_under_variables() -> None:
    constants, unit = {"low": ["min", "1/4", "2"]}, {"x": ["0", "1"]}
    for ends, good in ((["-1", "0"], True), (["-1", "1"], False), (["-1", "1/9"], False)):
        claim = ["<=", ["mul", "x", "2"], ["mul", "x", "low"]]
        assert rewrites(claim, [["low", 1]], constants=constants, variables={"x": ends}) is good
    assert rewrites(["<=", ["mul", "x", "low"], ["mul", "x", "2"]], [["low", 1]],
                    constants=constants, variables=unit)  # fmt: skip
    sign = {"x": ["-1", "1"]}
    assert not rewrites(["<=", ["mul", "x", "low"], ["mul", "x", "2"]], [["low", 1]],
                        constants=constants, variables=sign)  # fmt: skip


@pytest.mark.parametrize("index", [3, 1000, "0", -1, True, [0], 1.0])
def test_indices_that_are_none(index: object) -> None:
    found = why(["<=", "low", "b"], [["low", index]], constants=CONSTANTS)
    assert found.startswith("malformed") or (index == 3 and "none such" in found)


def test_strict_claims_by_entries() -> None:
    assert rewrites(["<", "low", "1"], [["low", 2]], "interval", constants=CONSTANTS)
    assert not rewrites(["<", "low", "1/2"], [["low", 2]], "interval", constants=CONSTANTS)
