"""Facts that bound one variable after the other, down to a polynomial on a box."""

from __future__ import annotations

import pytest

from tests.prover.test_named import verdict
from verify.language.statement import PROVED, UNDECIDED
from verify.language.terms import Claim, symbol

x, y = symbol("x"), symbol("y")
#: The point of these givens is x = 1, y = 2.
BOX = {"x-low": 0 < x, "x-high": x < 3, "y-low": 0 < y, "y-high": y <= x + 2}


@pytest.mark.parametrize(
    ("claim", "facts"),
    [
        (x**9 < 3 * x**8, ("x-low", "x-high")),
        (0 < x**12 * (3 - x) ** 7 + x, ("x-low", "x-high")),
        (y**6 <= (x + 2) ** 6, ("x-low", "y-low", "y-high")),
        (x**5 * y**6 < 3 * x**4 * (x + 2) ** 6, ("x-low", "x-high", "y-low", "y-high")),
        (0 <= (x - y) ** 6 * x, ("x-low",)),
    ],
)
def test_high_degrees_on_a_box_are_found(claim: Claim, facts: tuple[str, ...]) -> None:
    assert verdict(claim, *facts, givens=BOX) == PROVED


@pytest.mark.parametrize(
    ("claim", "facts"),
    [
        (x**9 < 2 * x**8, ("x-low", "x-high")),
        (x**9 < 3 * x**8, ("x-low",)),
        (y**6 < (x + 2) ** 6, ("x-low", "y-low", "y-high")),
        (y**6 <= (x + 2) ** 6, ("x-low", "y-low")),
        (0 <= (x - y) ** 5 * x, ("x-low", "y-low")),
    ],
)
def test_what_is_false_or_rests_on_other_facts_is_not(claim: Claim, facts: tuple[str, ...]) -> None:
    assert verdict(claim, *facts, givens=BOX) == UNDECIDED
