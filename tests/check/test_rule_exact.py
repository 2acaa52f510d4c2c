"""``exact``: rational values decide."""

from __future__ import annotations

import pytest

from tests.check.support import proves, verdict

LONG = "1" + "0" * 3000


@pytest.mark.parametrize(
    ("claim", "good"),
    [
        (["<=", ["div", "1", "3"], "1/3"], True),
        (["<", ["div", "1", "3"], "1/3"], False),
        (["=", ["sub", "2/3", "1/3"], ["div", "1", "3"]], True),
        (["=", "1/3", f"{LONG}/3{LONG[1:-1]}1"], False),
        (["<", f"{LONG}/3{LONG[1:-1]}1", "1/3"], True),
        (["<", "1/3", f"{LONG}/3{LONG[1:-1]}1"], False),
        (["=", ["sqrt", "9/16"], "3/4"], True),
        (["<", ["pow", ["sub", "1/3", "1/7"], "40"], ["pow", "4/21", "40"]], False),
        (["<=", ["pow", ["sub", "1/3", "1/7"], "40"], ["pow", "4/21", "40"]], True),
        (["=", ["min", "1/3", "2/3", "1/5"], "1/5"], True),
        (["=", ["max", "1/3", "2/3", "1/5"], "1/5"], False),
        (["not", ["=", "1/3", "1/3"]], False),
        (["not", ["=", "1/3", f"{LONG}/3{LONG[1:-1]}1"]], True),
        (["not", ["<", ["div", "1", "3"], "1/3"]], True),
    ],
)
def test_rationals(claim: object, good: bool) -> None:
    assert proves(claim, "exact", bits=2, lhs=["-1e9", "1e9"], rhs=["-1e9", "1e9"]) is good


def test_the_precision_of_the_proof_does_not_matter() -> None:
    claim = ["<", ["sub", f"{LONG}1/{LONG}0", "1"], "1/1" + "0" * 2999]
    assert proves(claim, "exact", bits=64)


def test_an_irrational_equality_is_not_decided() -> None:
    claim = ["=", ["mul", ["sqrt", "2"], ["sqrt", "2"]], "2"]
    assert not proves(claim, "exact")


def test_undefined() -> None:
    assert "contains 0" in verdict(["=", ["div", "1", ["sub", "1/3", "1/3"]], "1"], "exact")
    assert "below 0" in verdict(["=", ["sqrt", "-1/4"], "1"], "exact")


def test_cosines_and_variables_have_no_value() -> None:
    assert not proves(["=", ["cos_pi", "1/3"], "1/2"], "exact")
    assert not proves(["<", "x", "3"], "exact", variables={"x": [None, None]})


def test_constants() -> None:
    constants = {"a": "1/3", "b": ["mul", "a", "3"], "c": ["sqrt", ["add", "b", "3"]]}
    assert proves(["=", "c", "2"], "exact", constants=constants)
    assert not proves(["=", "c", "2"], "exact", constants=constants | {"a": "1/4"})
