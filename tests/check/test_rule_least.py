"""``least``: what is less than each entry is less than their minimum."""

from __future__ import annotations

from typing import Any

import pytest

from tests.check.support import BOUNDS, box, ground, in_box, interval, least, verdict

I = interval(BOUNDS)  # noqa: E741


@pytest.mark.parametrize(
    ("claim", "side", "branches", "reason"),
    [
        ("0 <= min(x, 2)", "rhs", 2, "proved"),
        ("-1 < min(x, 2)", "rhs", 2, "proved"),
        ("max(x, 1) <= 1", "lhs", 2, "proved"),
        ("max(x, 1) < 2", "lhs", 2, "proved"),
        ("-1 < min(x, 1, 2)", "rhs", 3, "proved"),
        ("0 < min(x, 2)", "rhs", 2, "expected < between them"),
        ("1 <= min(2, x)", "rhs", 2, "expected <= between them"),
        ("max(x, 2) <= 1", "lhs", 2, "expected <= between them"),
        ("max(2, x) < 2", "lhs", 2, "expected < between them"),
        ("min(x, 2) <= 2", "lhs", 2, "found min on the lhs, expected max"),
        ("0 <= max(x, 2)", "rhs", 2, "found max on the rhs, expected min"),
        ("0 <= min(x, 2)", "lhs", 2, "found rational on the lhs, expected max"),
        ("2 = min(2, 2)", "rhs", 2, "found =, expected < or <="),
        ("0 <= min(x, 2)", "rhs", 1, "found 1 proofs, expected 2"),
        ("0 <= min(x, 2)", "rhs", 0, "found 0 proofs, expected 2"),
        ("0 <= min(x, 2)", "rhs", 3, "found 3 proofs, expected 2"),
        ("0 <= min(2, 1/(1 - 1))", "rhs", 2, "division"),
        ("1/(1 - 1) <= min(2, 3)", "rhs", 2, "division"),
        ("max(1, sqrt(x - 3)) <= 9", "lhs", 2, "the root of a term"),
    ],
)
def test_least(claim: str, side: str, branches: int, reason: str) -> None:
    assert reason in in_box(claim, least(side, *[I] * branches))


@pytest.mark.parametrize(
    ("claim", "side", "equation", "reason"),
    [
        ("0 <= m", "rhs", "m", "proved"),
        ("n <= 2", "lhs", "n", "proved"),
        ("1 <= m", "rhs", "m", "expected <= between them"),
        ("n <= 1", "lhs", "n", "expected <= between them"),
        ("0 <= m", "rhs", None, "found name on the rhs, expected min"),
        ("0 <= m", "rhs", "n", "says nothing of this side"),
        ("0 <= n", "rhs", "n", "found max on the rhs, expected min"),
    ],
)
def test_least_of_names(claim: str, side: str, equation: Any, reason: str) -> None:
    pair = box(("0", "1")).inner("box", "m", "min(x, 2)").inner("box", "n", "max(x, 2)")
    proof = least(side, I, I, equation=equation)
    assert reason in verdict(pair.row("row", claim, proof, "box"))


def test_the_negation_of_an_equation_has_no_least() -> None:
    """The negation of lhs = rhs is rhs != lhs."""
    pair = box(("0", "1")).row("true", "0 <= x", I, "box")
    pair.row("row", "min(x, 2) = 3", least("rhs", I, I), "box", "refuted", "printed")
    assert "found !=, expected < or <=" in verdict(pair)


def test_branches_are_proofs() -> None:
    for wrong in (None, {}, [], "x-low", {"rule": "least"}, {"rule": "nothing"}):
        found = ground("0 <= min(1, 2)", least("rhs", interval(), wrong))
        assert found.startswith("MALFORMED: obligation row: ")
