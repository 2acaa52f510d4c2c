"""Claims that the search once called proved, and the checker refused; or at which it broke."""

from __future__ import annotations

import math
from collections.abc import Mapping
from fractions import Fraction
from typing import Any

import pytest
from flint import Ordering, fmpq, fmpq_mpoly_ctx

from verify.language.statement import PROVED, REFUTED, UNDECIDED
from verify.language.terms import (
    Claim,
    Term,
    as_term,
    cos_pi,
    equal,
    maximum,
    minimum,
    sqrt,
    symbol,
)
from verify.library import ask, constant, for_all, lemma, prove
from verify.prover import prove as search
from verify.prover.balls import float_of
from verify.prover.budget import WorkBudget
from verify.prover.goal import Bounds, Goal
from verify.prover.search import tree
from verify.prover.search.faces import value_at
from verify.prover.search.local_minima import Minima
from verify.prover.search.tree import Tree, _binary_exponent
from verify.wire.inputs import InputError, TooDeepError

x, y, k = symbol("x"), symbol("y"), symbol("k")
ONE, ZERO = as_term(1), as_term(0)


def decided(claim: Claim, givens: Mapping[str, Claim], point: int, **constants: Any) -> str:
    """The verdict, with the checker's consent."""
    place = for_all("all", givens, {"x": point})
    named = [constant(name, value) for name, value in constants.items()]
    statement = lemma("title", [ask("row", claim, place)], named, [place])
    outcome = prove(statement, work=5_000_000)
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


def test_a_bound_of_a_variable_that_divides_by_a_constant() -> None:
    givens = {"low": as_term(-2) <= x, "high": x <= -1, "far": x < 2000 / (k + 1)}
    assert decided(ONE <= x + k, givens, -1, k=ONE) == REFUTED
    assert decided(x + k <= ONE, givens, -1, k=ONE) == PROVED


def test_a_claim_from_which_a_square_is_left_out() -> None:
    givens = {"low": ZERO <= x, "high": x**2 <= ZERO}
    assert decided(equal(x**3 + x, x), givens, 0) in (PROVED, UNDECIDED)
    assert decided(x**3 <= ZERO, givens, 0) in (PROVED, UNDECIDED)
    assert decided(0 <= x**3 * (x - 2) ** 2, {"low": ZERO <= x}, 0) == PROVED


def test_long_powers() -> None:
    assert decided(0 <= x**120 - 2 * x**60 + 1, {}, 0) == PROVED


@pytest.mark.parametrize("n", [150, 200])
def test_what_the_checker_cannot_afford_is_not_claimed(
    n: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    claim = x**n * (1 - x) <= as_term(Fraction(1, n + 1))
    assert decided(claim, {"low": ZERO <= x, "high": x <= ONE}, 0) == PROVED  # in another way
    monkeypatch.setattr(search, "MAX_REFUSED", 0)
    unit = for_all("all", {"low": ZERO <= x, "high": x <= ONE}, {"x": 0})
    rows = [
        ask("before", x <= as_term(2), unit),
        ask("long", claim, unit),
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
    least = minimum(x, 2 * x)
    assert decided(least < least, {"low": -1 <= x}, 0) == REFUTED


def test_one_name_for_two_things() -> None:
    with pytest.raises(InputError, match="x is the name of a variable and of a given"):
        decided(0 <= x, {"x": 0 <= x}, 0)


@pytest.mark.parametrize("levels", [150, 900, 3000])
def test_terms_that_are_too_deep(levels: int) -> None:
    term = x
    for _ in range(levels):
        term = term + 1
    with pytest.raises(TooDeepError, match="its terms are too deep; nest fewer operations"):
        decided(x < term, {"low": 0 <= x}, 1)


@pytest.mark.parametrize("end", [0, -1, Fraction(1, 3)])
def test_a_variable_with_one_value(end: Fraction) -> None:
    givens = {"low": as_term(end) <= x, "high": x <= as_term(end)}
    place = for_all("all", givens, {"x": end})
    rows = [ask("one", x <= x**2 - end**2 + end, place), ask("two", x * x <= x * end, place)]
    found = prove(lemma("title", rows, (), [place]), work=10**6)
    assert found.verdict in (PROVED, UNDECIDED)


@pytest.mark.parametrize("end", [-3, 0, 4])
def test_a_cosine_of_a_variable_with_one_value(end: int) -> None:
    givens = {"low": as_term(end) <= x, "high": x <= as_term(end)}
    sign = as_term(-1 if end % 2 else 1)
    for claim in (Claim("<=", cos_pi(x), sign), equal(x, sign * cos_pi(x) * x)):
        assert decided(claim, givens, end) in (PROVED, UNDECIDED)


def test_bounds_that_are_no_interval_are_not_used_as_one() -> None:
    lie = Bounds(Fraction(1), Fraction(1), "low", "high", "<=", "<=")
    assert lie.ends is not None
    assert lie.interval is None
    assert Bounds(Fraction(0), Fraction(1), "low", "high", "=", "<=").interval is None
    assert Bounds(Fraction(0), Fraction(1), "low", "high", "<=", "<").interval == (0, 1)


def test_a_row_that_enclosures_prove_as_a_fact_for_the_next() -> None:
    givens = {"low": as_term(-3) <= x, "high": x <= as_term(Fraction(-5, 3))}
    place = for_all("all", givens, {"x": -2, "y": 0})
    rows = [
        ask("first", sqrt(x**2) * x < 0 / x - 1, place),
        ask("second", minimum(y, x) <= (y - 1) * y, place),
    ]
    found = prove(lemma("title", rows, (), [place]), work=10**6).decisions
    assert found["first"].verdict == PROVED
    assert "failed" not in found["second"].reason


# --- numbers beyond the largest float -------------------------------------------------------------

HUGE = as_term(10**400)
BEYOND: dict[str, tuple[Claim, dict[str, Claim]]] = {
    "squares": (0 <= HUGE * x**2 - 2 * x + 1, {}),
    "two": (0 <= x**4 * HUGE + x * y + y**2 * HUGE, {}),
    "squared": (x * y <= (x**2 + y**2) * HUGE, {"low": 0 <= x, "least": 0 <= y}),
    "half-line": (1 <= x**2, {"low": HUGE <= x}),
    "quotient": (0 <= 1 + 1 / x, {"low": HUGE <= x}),
    "box": (x <= x**2, {"low": HUGE <= x, "high": x <= 2 * HUGE}),
    "minimum": (minimum(x, y) <= (x + y) / 2, {"low": HUGE <= x, "high": x <= HUGE + 1}),
    "maximum": (x <= maximum(x * HUGE, y), {"low": 0 <= x, "least": 0 <= y}),
    "root": (sqrt(x) <= HUGE * x, {"low": HUGE <= x}),
    "roots": (sqrt(x**2 + 1) * HUGE <= x * HUGE + HUGE, {"low": 0 <= x}),
    "cosine": (HUGE * cos_pi(x) <= HUGE, {}),
    "angle": (cos_pi(x * HUGE) <= 1, {"low": 0 <= x, "high": x <= 1}),
    "equation": (equal(x * HUGE + y, y + x * HUGE + 1 / HUGE), {}),
    "false": (x**2 <= x * HUGE, {"low": HUGE <= x}),
    "tiny": (x**2 * cos_pi(x) <= x, {"low": 0 <= x, "high": x <= 1 / HUGE}),
}


@pytest.mark.parametrize("name", BEYOND)
def test_numbers_that_no_float_is_near(name: str) -> None:
    claim, givens = BEYOND[name]
    far = any(given.lhs == HUGE for given in givens.values())
    place = for_all("all", givens, {"x": 10**400 if far else 0, "y": 0})
    found = prove(lemma("title", [ask("row", claim, place)], (), [place]), work=2_000_000)
    decision = found.decisions["row"]
    assert found.spent == ""
    assert "failed" not in decision.reason
    assert "terms are too deep" not in decision.reason
    assert decision.verdict != (PROVED if name in ("equation", "false") else REFUTED)


def test_a_float_near_a_number() -> None:
    assert float_of(Fraction(1, 3)) == float_of(fmpq(1, 3)) == 1 / 3
    assert float_of(Fraction(10) ** 400) == math.inf
    assert float_of(fmpq(-10) ** 401) == -math.inf
    assert float_of(Fraction(1, 10**400)) == 0


def test_local_minima_are_finite() -> None:
    bounds = {"x": Bounds(Fraction(10) ** 400), "y": Bounds(None, Fraction(1))}
    for claim in (0 <= 1 + 1 / x, 0 <= -(y**3), 0 <= y):
        found = Minima(Goal(claim, None, bounds, (), {}), WorkBudget(10**7)).found()
        assert all(math.isfinite(n) for value, point in found for n in (value, *point))


def test_a_polynomial_at_floats_that_are_too_large() -> None:
    (u,) = (context := fmpq_mpoly_ctx.get(("u",), Ordering.lex)).gens()
    assert value_at(u**2 + context.constant(1), (3.0,)) == 10
    assert math.isnan(value_at(u**2, (1e200,)))


@pytest.mark.parametrize("value", [1, 2, 3, 4, 1023, 1024, Fraction(1, 3), Fraction(1, 10**400)])
def test_a_binary_exponent(value: Fraction) -> None:
    e = _binary_exponent(Fraction(value))
    assert Fraction(2) ** e <= value < Fraction(2) ** (e + 1)


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


@pytest.mark.parametrize("places", [3, 40, 400, 4000])
def test_cosines_of_large_numbers(places: int) -> None:
    """The checker loses the bits of the reduction; where it has too few, the row is undecided."""
    large = Term("cos", as_term(10**places))
    rows = [ask("row", 0 < large), ask("other", large < 0 * ONE)]
    outcome = prove(lemma("title", rows[: 1 if places > 400 else 2]))  # one is work enough
    found = {decision.verdict for decision in outcome.decisions.values()}
    assert found == ({UNDECIDED} if places > 400 else {PROVED, REFUTED})
