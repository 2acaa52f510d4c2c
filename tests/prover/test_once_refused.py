"""Claims that the search once called proved, and the checker refused; or at which it broke."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

import pytest

from verify.language.statement import PROVED, REFUTED, UNDECIDED
from verify.language.terms import Claim, as_term, cos_pi, equal, minimum, sqrt, symbol
from verify.library import ask, constant, for_all, lemma, prove
from verify.prover.budget import WorkBudget
from verify.prover.goal import Bounds
from verify.prover.search import tree
from verify.prover.search.tree import Tree
from verify.wire.inputs import InputError

x, k = symbol("x"), symbol("k")
ONE, ZERO = as_term(1), as_term(0)


def decided(claim: Claim, givens: Mapping[str, Claim], point: int, **constants: Any) -> str:
    """The verdict, with the checker's consent."""
    place = for_all("all", givens, {"x": point})
    named = [constant(name, value) for name, value in constants.items()]
    statement = lemma("title", [ask("row", claim, place)], named, [place])
    outcome = prove(statement, WorkBudget(5_000_000))
    assert "failed" not in outcome.decisions["row"].reason
    return outcome.verdict


@pytest.mark.parametrize(
    ("claim", "truth"),
    [
        (Claim("<=", ONE, cos_pi(sqrt(4))), True),
        (Claim("<", cos_pi(sqrt(0)), ONE), False),
        (equal(cos_pi(sqrt(as_term(4) / 9) * 2), as_term(Fraction(-1, 2))), True),
    ],
)
def test_angles_that_are_rational_only_after_a_root(claim: Claim, truth: bool) -> None:
    outcome = prove(lemma("title", [ask("row", claim)]))
    assert outcome.verdict in (UNDECIDED, PROVED if truth else REFUTED)


def test_a_constant_with_a_root_in_a_proof_by_algebra() -> None:
    root = -sqrt(as_term(-1) ** 2)
    assert decided(1 / k <= x, {"low": ONE <= x}, 1, k=root) == PROVED


def test_a_claim_from_which_a_square_is_left_out() -> None:
    givens = {"low": ZERO <= x, "high": x**2 <= ZERO}
    assert decided(equal(x**3 + x, x), givens, 0) in (PROVED, UNDECIDED)
    assert decided(x**3 <= ZERO, givens, 0) in (PROVED, UNDECIDED)
    assert decided(0 <= x**3 * (x - 2) ** 2, {"low": ZERO <= x}, 0) == PROVED


def test_long_powers() -> None:
    assert decided(0 <= x**120 - 2 * x**60 + 1, {}, 0) == PROVED


@pytest.mark.parametrize("n", [150, 200])
def test_what_the_checker_cannot_afford_is_not_claimed(n: int) -> None:
    unit = for_all("all", {"low": ZERO <= x, "high": x <= ONE}, {"x": 0})
    rows = [
        ask("before", x <= as_term(2), unit),
        ask("long", x**n * (1 - x) <= as_term(Fraction(1, n + 1)), unit),
        ask("after", x**2 <= x, unit),
    ]
    found = prove(lemma("title", rows, (), [unit])).decisions
    assert [found[name].verdict for name in ("before", "long", "after")] == [
        PROVED,
        UNDECIDED,
        PROVED,
    ]
    assert "found more work than the limit" in found["long"].reason


def test_equal_minima() -> None:
    y = symbol("x")
    least = minimum(y, 2 * y)
    assert decided(least < least, {"low": -1 <= y}, 0) == REFUTED


def test_one_name_for_two_things() -> None:
    with pytest.raises(InputError, match="the name x twice: one name stands for two things"):
        decided(0 <= x, {"x": 0 <= x}, 0)


@pytest.mark.parametrize("levels", [150, 900, 3000])
def test_terms_that_are_too_deep(levels: int) -> None:
    term = x
    for _ in range(levels):
        term = term + 1
    with pytest.raises(InputError, match=r"more than 100 nested brackets|too deep"):
        decided(x < term, {"low": 0 <= x}, 1)


@pytest.mark.parametrize("end", [0, -1, Fraction(1, 3)])
def test_a_variable_with_one_value(end: Fraction) -> None:
    givens = {"low": as_term(end) <= x, "high": x <= as_term(end)}
    place = for_all("all", givens, {"x": end})
    rows = [ask("one", x <= x**2 - end**2 + end, place), ask("two", x * x <= x * end, place)]
    found = prove(lemma("title", rows, (), [place]), WorkBudget(10**6))
    assert found.verdict in (PROVED, UNDECIDED)


# --- floats say nothing for certain ---------------------------------------------------------------


def test_equal_sides_are_not_told_apart_by_floats() -> None:
    angle = as_term(Fraction(-3, 2))
    claim = 100000 * cos_pi(angle) < cos_pi(angle) * x
    givens = {"low": as_term(Fraction(3, 2)) <= x, "high": x <= as_term(Fraction(8, 5))}
    bounds = {"x": Bounds(Fraction(3, 2), Fraction(8, 5), "low", "high", "<=", "<=")}
    assert Tree(claim, bounds, {}, WorkBudget(10**6)).prove(300) is None
    place = for_all("all", givens, {"x": Fraction(3, 2)})
    outcome = prove(lemma("title", [ask("row", claim, place)], (), [place]))
    assert outcome.verdict in (UNDECIDED, REFUTED)


@pytest.mark.parametrize("relation", ["<", "<="])
def test_ranges_that_lie_prove_nothing(monkeypatch: pytest.MonkeyPatch, relation: str) -> None:
    bounds = {"x": Bounds(Fraction(0), Fraction(1), "low", "high", "<=", "<=")}
    true = Claim(relation, x * (1 - x), as_term(Fraction(1, 3)))
    false = Claim(relation, x * (1 - x), as_term(Fraction(1, 5)))
    assert Tree(true, bounds, {}, WorkBudget(10**6)).prove(300) is not None
    lies = lambda *_: lambda *_: (0.0, 0.0, 1.0, 1.0)  # noqa: E731
    monkeypatch.setattr(tree, "range_function", lies)
    assert Tree(false, bounds, {}, WorkBudget(10**6)).prove(300) is None
