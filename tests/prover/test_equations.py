"""Equations that follow by both orders, where givens hold on a thin set only."""

from __future__ import annotations

import pytest

from tests.prover.test_interior import verdict

PROVED = [
    (["a*a + b*b <= 0"], "b = 0"),
    (["a^2 = 0"], "a = 0"),
    (["a <= 3*b", "b <= 2*c", "a >= 6*c"], "a = 3*b"),
    (["0 < a", "a^3 = 8"], "a = 2"),
    (["0 <= a", "a^2 = 2"], "a = sqrt(2)"),
    (["0 < a", "a^2 = b^2", "0 < b"], "a = b"),
    (["a^3 = b^3"], "a = b"),
    (["(a-1)^2 + (b-2)^2 + (c-a)^2 <= 0"], "c = 1"),
    (["a^4 + b^2 <= 0"], "b = 0"),
    (["0 <= a", "0 <= b", "a + b <= 0"], "a*b = 0"),
    (["0 <= a", "a <= 1", "b = a^2", "b >= a", "0 < a"], "a = 1"),
]


@pytest.mark.parametrize(("given", "row"), PROVED)
def test_an_equation_is_proved(given: list[str], row: str) -> None:
    assert verdict([*"abc"], given, row) == "proved"


@pytest.mark.parametrize(
    ("given", "row"),
    [(["a + b = 1"], "a = b"), (["0 <= a", "a^2 = 2"], "a = 1"), (["a^2 = b^2"], "a = b")],
)
def test_an_equation_that_is_false_somewhere_is_refuted(given: list[str], row: str) -> None:
    assert verdict([*"abc"], given, row) == "refuted"
