"""``entry``: a minimum is at most each of its entries (a maximum at least)."""

from __future__ import annotations

from typing import Any

import pytest

from tests.check.support import INTERVAL, Pair, box, entry, ground, in_box, verdict


@pytest.mark.parametrize(
    ("claim", "side", "good"),
    [
        ("min(x, 2) <= x", "lhs", True),
        ("min(x, 2) <= 2", "lhs", True),
        ("x <= max(x, 2)", "rhs", True),
        ("min(x, 2) <= 1", "lhs", False),
        ("min(x, 2) <= max(x, 3)", "lhs", False),
        ("min(x, 2) < 2", "lhs", False),
        ("2 = min(x, 2)", "rhs", False),
        ("x <= min(x, 2)", "rhs", False),
        ("max(x, 2) <= x", "lhs", False),
        ("x <= max(x, 2)", "lhs", False),
        ("min(x, 2) <= x", "rhs", False),
        ("2 < max(x, 2)", "rhs", False),
        ("max(x, 2) <= max(x, 2)", "rhs", False),
        ("min(x, 1/(x - x)) <= x", "lhs", False),
        ("min(x, sqrt(x - 2)) <= x", "lhs", False),
        ("x <= max(x, 1/x)", "rhs", False),
        ("min(x, min(2, 3)) <= 2", "lhs", False),
    ],
)
def test_entries(claim: str, side: str, good: bool) -> None:
    assert (in_box(claim, entry(side)) == "proved") == good


@pytest.mark.parametrize(
    ("claim", "side", "equation", "reason"),
    [
        ("m <= x", "lhs", "m", "proved"),
        ("m <= 2", "lhs", "m", "proved"),
        ("x <= n", "rhs", "n", "proved"),
        ("m <= x", "lhs", None, "found name on the lhs, expected min"),
        ("m <= x", "lhs", "n", "found n, which says nothing of this side"),
        ("m <= x", "lhs", "x-low", "found x-low, which says nothing of this side"),
        ("m <= x", "lhs", "copy", "found copy, which says nothing of this side"),
        ("n <= x", "lhs", "n", "found max on the lhs, expected min"),
        ("x <= m", "rhs", "m", "found min on the rhs, expected max"),
        ("m <= x", "rhs", "m", "which says nothing of this side"),
        ("m <= 3", "lhs", "m", "found a side that is no entry of the min"),
        ("m < 2", "lhs", "m", "found <, expected <="),
        ("m <= x", "lhs", "late", "found late, which is no fact so far"),
        ("m <= x", "lhs", "@1", "found @1, which no branch adds"),
    ],
)
def test_entries_of_names(claim: str, side: str, equation: str | None, reason: str) -> None:
    pair = box(("0", "1")).inner("box", "m", "min(x, 2)").inner("box", "n", "max(x, 2)")
    pair.lemma("copy", "min(x, 2) = m", {**TOTAL, "using": ["m"]}, "box")
    assert reason in verdict(pair.row("row", claim, entry(side, equation), "box"))


TOTAL: dict[str, Any] = {"rule": "sum", "using": [], "addends": [], "equations": []}


def test_the_other_side_is_defined() -> None:
    """It is an entry, and all entries are cleared."""
    assert "division" in ground("min(1, 1/(1 - 1)) <= 1/(1 - 1)", entry("lhs"))


def test_an_undefined_constant_is_no_minimum() -> None:
    pair = Pair().constant("m", "min(1, sqrt(2))", INTERVAL)
    steps, pair.steps = pair.steps, []
    pair.row("row", ["<=", "m", "1"], entry("lhs", "m"))
    pair.steps += steps
    assert "found a constant before its definition" in verdict(pair)


@pytest.mark.parametrize("side", ["", "left", None, 0, "lhs\n"])
def test_sides(side: Any) -> None:
    assert "entry.side: found" in ground("min(1, 2) <= 1", entry(side))
