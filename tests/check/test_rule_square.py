"""``square``: sides that are not negative stand as their squares do."""

from __future__ import annotations

from typing import Any

import pytest

from tests.check.support import proves, verdict

INTERVAL = {"rule": "interval", "bits": 64}
IDENTITY = {"rule": "rewrite", "bits": 64, "steps": [], "closing": "identity"}


def squares(claim: Any, then: Any = IDENTITY, **fields: Any) -> bool:
    return proves(claim, "square", then=then, **fields)


R2, R3, R6 = (["sqrt", n] for n in ("2", "3", "6"))


@pytest.mark.parametrize(
    ("claim", "then", "good"),
    [
        (["=", ["mul", R2, R3], R6], IDENTITY, True),
        (["<=", ["mul", R2, R3], R6], IDENTITY, True),
        (["<", ["mul", R2, R3], R6], IDENTITY, False),
        (["=", ["mul", R2, R3], ["sqrt", "7"]], IDENTITY, False),
        (["<", R2, "3/2"], INTERVAL, True),
        (["<", R2, "141/100"], INTERVAL, False),
        (["not", ["<", R6, ["mul", R2, R3]]], IDENTITY, True),
        (["not", ["=", R2, "3/2"]], INTERVAL, True),
        (["not", ["=", ["mul", R2, R3], R6]], INTERVAL, False),
        (["<", "0", R2], INTERVAL, True),
    ],
)
def test_squares(claim: object, then: object, good: bool) -> None:
    assert squares(claim, then) is good


@pytest.mark.parametrize(
    "claim", [["<", "1", "-2"], ["<=", "-1", "1"], ["=", "-1", "1"], ["<", "-1/1000000", "1"]]
)
def test_negative_sides_are_refused(claim: object) -> None:
    assert "not negative" in verdict(claim, "square", then=INTERVAL)
    assert "not negative" in verdict(claim, "square", then=IDENTITY)


def test_variables() -> None:
    unit = {"x": ["0", "1"]}
    claim = ["<=", ["sqrt", "x"], "1"]
    assert squares(claim, INTERVAL, variables=unit)
    assert not squares(claim, INTERVAL, variables={"x": ["0", "2"]})
    assert not squares(["<=", "x", "1"], INTERVAL, variables={"x": ["-3", "1"]})
    assert not squares(["<=", "x", "2"], INTERVAL, variables={"x": ["-1", "1"]})
    assert squares(["<=", "x", "2"], INTERVAL, variables={"x": ["0", "1"]})


def test_nesting() -> None:
    twice = {"rule": "square", "bits": 64, "then": IDENTITY}
    fourth = ["sqrt", ["sqrt", "4"]]
    assert squares(["=", fourth, R2], twice)
    assert not squares(["=", fourth, R3], twice)
    deep: Any = INTERVAL
    for _ in range(60):
        deep = {"rule": "square", "bits": 64, "then": deep}
    assert not squares(["<", R2, R3], deep)


@pytest.mark.parametrize(
    "then",
    [
        None,
        "interval",
        [],
        {},
        {"rule": "interval"},
        {"rule": "nothing", "bits": 64},
        {**INTERVAL, "extra": 1},
        {**INTERVAL, "obligation": "row"},
        {"rule": "square", "bits": 64, "then": None},
        {**INTERVAL, "bits": 1},
    ],
)
def test_malformed_inner_proofs(then: object) -> None:
    assert verdict(["<", R2, R3], "square", then=then).startswith("malformed")
