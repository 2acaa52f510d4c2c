"""``antisymmetry``: two numbers are equal if each is at most the other."""

from __future__ import annotations

import pytest

from tests.check.support import (
    BOUNDS,
    IDENTITY,
    INTERVAL,
    Json,
    Pair,
    box,
    ground,
    interval,
    verdict,
)

GOAL = {**IDENTITY, "addends": ["goal"]}


def both(*branches: Json) -> Json:
    """A proof for each order."""
    return {"rule": "antisymmetry", "branches": list(branches)}


@pytest.mark.parametrize(
    ("claim", "branches", "reason"),
    [
        ("sqrt(4) = 2", (INTERVAL, INTERVAL), "proved"),
        ("(sqrt(2) + 1)*(sqrt(2) - 1) = 1", (GOAL, GOAL), "proved"),
        ("sqrt(2) = 7/5", (INTERVAL, INTERVAL), "expected <= between"),
        ("7/5 = sqrt(2)", (INTERVAL, INTERVAL), "expected <= between"),
        ("2 <= sqrt(4)", (INTERVAL, INTERVAL), "found <=, expected ="),
        ("1 < 2", (INTERVAL, INTERVAL), "found <, expected ="),
        ("sqrt(4) = 2", (INTERVAL,), "found 1 proofs, expected 2"),
        ("sqrt(4) = 2", (INTERVAL, INTERVAL, INTERVAL), "found 3 proofs, expected 2"),
        ("sqrt(4) = 2", (), "found 0 proofs, expected 2"),
        ("sqrt(4) = 2", (INTERVAL, {"rule": "angels"}), "rule: found angels"),
        ("sqrt(0 - 1) = sqrt(0 - 1)", (GOAL, GOAL), "not known to be >= 0"),
    ],
)
def test_antisymmetry(claim: str, branches: tuple[Json, ...], reason: str) -> None:
    assert reason in ground(claim, both(*branches))


def test_one_order_is_not_enough() -> None:
    proof = both(interval(BOUNDS), interval(BOUNDS))
    assert "REFUSED" in verdict(box(("0", "1")).row("row", "x = 1", proof, "box"))


def test_a_refuted_equation_is_no_equation() -> None:
    """The negation of = is no claim that two orders show."""
    pair = Pair().row("row", "1 = 2", both(INTERVAL, INTERVAL), verdict="refuted")
    assert "found !=, expected =" in verdict(pair)
