"""``cuts``: enclosures decide between neighbouring cuts."""

from __future__ import annotations

from typing import Any

import pytest

from tests.check.support import proves, verdict
from verify import check

UNIT = {"x": ["0", "1"]}
HUMP = ["mul", "x", ["sub", "1", "x"]]
QUARTERS = ["0", "1/4", "1/2", "3/4", "1"]


def holds(claim: Any, cuts: Any, variables: Any = UNIT) -> bool:
    return proves(claim, "cuts", cuts=cuts, variables=variables)


def test_more_cuts_decide_more() -> None:
    claim = ["<=", HUMP, "1/2"]
    assert not holds(claim, {"x": ["0", "1"]})
    assert holds(claim, {"x": ["0", "1/2", "1"]})
    assert holds(["<=", HUMP, "3/8"], {"x": QUARTERS})
    assert not holds(["<=", HUMP, "37499999/100000000"], {"x": QUARTERS})
    assert holds(["<", HUMP, "37500001/100000000"], {"x": QUARTERS})
    assert not holds(["<", HUMP, "3/8"], {"x": QUARTERS})


@pytest.mark.parametrize(
    "cuts",
    [
        [],
        ["0"],
        ["1"],
        ["0", "0"],
        ["0", "1/4", "1/2", "3/4"],
        ["1/4", "1/2", "3/4", "1"],
        ["0", "1/4", "1/2", "3/4", "999/1000"],
        ["1/1000", "1/4", "1/2", "3/4", "1"],
        ["1", "3/4", "1/2", "1/4", "0"],
        ["0", "1/2", "1/4", "3/4", "1"],
        ["0", "1/4", "1/4", "1/2", "3/4", "1"],
        ["-1", "1/4", "1/2", "3/4", "2"],
    ],
)
def test_the_cuts_must_cover_in_order(cuts: list[str]) -> None:
    found = verdict(["<=", "x", "2"], "cuts", cuts={"x": cuts}, variables=UNIT)
    assert "increase from end to end" in found


def test_two_variables() -> None:
    box = {"x": ["0", "1"], "y": ["1", "2"]}
    claim = ["<=", ["mul", HUMP, "y"], "3/4"]
    assert holds(claim, {"x": QUARTERS, "y": ["1", "2"]}, box)
    assert not holds(claim, {"x": ["0", "1"], "y": ["1", "3/2", "2"]}, box)
    corner = ["<", ["add", "x", "y"], "11/4"]  # false only near (1, 2)
    assert not holds(corner, {"x": QUARTERS, "y": ["1", "5/4", "3/2", "7/4", "2"]}, box)


@pytest.mark.parametrize("names", [[], ["y"], ["x", "y"], ["x", "k"], ["k"]])
def test_each_variable_has_cuts_and_nothing_else(names: list[str]) -> None:
    cuts = {name: ["0", "1"] for name in names}
    found = verdict(["<=", "x", "2"], "cuts", cuts=cuts, variables=UNIT, constants={"k": "1/2"})
    assert "found cuts of" in found


def test_unbounded_variables_have_no_cuts() -> None:
    assert not holds(["<=", "0", "1"], {"x": ["0", "1"]}, {"x": ["0", None]})
    assert not holds(["<=", "0", "1"], {"x": ["0", "1"]}, {"x": [None, "1"]})


def test_too_many_boxes_end(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(check, "MAX_WORK", 100_000)
    points = ["0", *(f"{i}/400" for i in range(1, 400)), "1"]
    box = {name: ["0", "1"] for name in "abcdef"}
    cuts = dict.fromkeys("abcdef", points)
    for claim in (["<=", ["sub", "a", "5"], "b"], ["<=", "0", "1"], ["<=", "a", "1"]):
        assert "too much work" in verdict(claim, "cuts", cuts=cuts, variables=box)


def test_undefined_inside() -> None:
    claim = ["<=", ["sqrt", "x"], "2"]
    assert holds(claim, {"x": QUARTERS})
    ends = {"x": ["-1/1000", "1"]}
    assert not holds(claim, {"x": ["-1/1000", "1/2", "1"]}, ends)
    assert not holds(["<", "0", ["div", "1", "x"]], {"x": QUARTERS})
