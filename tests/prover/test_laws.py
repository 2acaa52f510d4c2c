"""Exponentials of sums and logarithms of products, taken apart; each proof is checked."""

from __future__ import annotations

import random
from fractions import Fraction
from functools import reduce
from operator import add, mul

import pytest

from verify.language.statement import PROVED
from verify.language.terms import Claim, Term, as_term, equal, exp, log, pi, sqrt, symbol
from verify.library import ask, for_all, lemma, prove

a, b, t, x = map(symbol, "abtx")


def verdict(claim: Claim, *givens: Claim, point: dict[str, int] | None = None) -> str:
    """What becomes of a claim, in a context if there are givens."""
    place = for_all("all", list(givens), point) if givens else None
    contexts = [place] if place else []
    found = prove(lemma("title", [ask("row", claim, place)], contexts=contexts), work=20_000_000)
    return found.decisions["row"].verdict


@pytest.mark.parametrize(
    "claim",
    [
        equal(exp(2), exp(1) ** 2),
        equal(exp(-1), 1 / exp(1)),
        equal(exp(Fraction(1, 2)) ** 2, exp(1)),
        equal(exp(3 * log(2)), as_term(8)),
        equal(log(4), 2 * log(2)),
        equal(log(Fraction(1, 6)), -log(2) - log(3)),
        equal(log(sqrt(2)), log(2) / 2),
        equal(log(2 * pi), log(2) + log(pi)),
        exp(-1) * exp(1) <= 1,
        log(6) <= log(2) + log(3),
    ],
)
def test_numbers(claim: Claim) -> None:
    assert verdict(claim) == PROVED


@pytest.mark.parametrize(
    "claim",
    [
        exp((a + b) / 2) <= (exp(a) + exp(b)) / 2,
        log(a) + log(b) <= 2 * log((a + b) / 2),
        equal(log(a / b), log(a) - log(b)),
        equal(exp(a - b) * exp(b), exp(a)),
        equal(exp(log(a) + b), a * exp(b)),
        log(a**2 * b) <= 3 * log((2 * a + b) / 3),
        t * exp(-t) <= exp(-1),
        t**2 * exp(-t) <= 4 * exp(-2),
        t * exp(-t) <= 1 / exp(1),
    ],
)
def test_claims_for_all_positive_numbers(claim: Claim) -> None:
    names = {"t"} if "Term('symbol', 't')" in repr(claim) else {"a", "b"}
    givens = [0 < symbol(name) for name in sorted(names)]
    assert verdict(claim, *givens, point=dict.fromkeys(sorted(names), 1)) == PROVED


@pytest.mark.parametrize(
    "claim",
    [
        equal(exp(2), exp(1) ** 3),
        equal(log(4), 3 * log(2)),
        log(2) + log(3) < log(6),
        exp(1) ** 2 < exp(2),
        equal(log(sqrt(2)), log(2)),
    ],
)
def test_what_is_false_is_not_proved(claim: Claim) -> None:
    assert verdict(claim) != PROVED


def test_a_logarithm_is_taken_apart_only_where_its_factors_are_positive() -> None:
    claim = equal(log(a * b), log(-a) + log(-b))
    assert verdict(claim, a < 0, b < 0, point={"a": -1, "b": -1}) == PROVED
    assert verdict(equal(log(x**2), 2 * log(-x)), x < 0, point={"x": -1}) == PROVED


@pytest.mark.parametrize("seed", range(12))
def test_random_products(seed: int) -> None:
    """The same exponentials and logarithms, put together in two ways."""
    draw = random.Random(seed)
    parts = [draw.choice((a, b, a * b, as_term(1))) for _ in range(3)]
    factors = [Fraction(draw.randrange(-4, 5), draw.choice((1, 1, 2))) for _ in parts]
    whole = exp(reduce(add, (f * p for f, p in zip(factors, parts, strict=True))))
    product: Term = reduce(mul, (exp(f * p) for f, p in zip(factors, parts, strict=True)))
    assert verdict(equal(whole, product), 0 < a, 0 < b, point={"a": 1, "b": 1}) == PROVED


@pytest.mark.parametrize("seed", range(12))
def test_random_logarithms(seed: int) -> None:
    """The logarithm of a quotient is that of its factors."""
    draw = random.Random(seed)
    high, low = (draw.randrange(1, 200) for _ in "hl")
    n, m = (draw.randrange(4) for _ in "nm")
    whole = log(a**n * high / (b**m * low)) if n and m else log(Fraction(high, low) * a)
    parts = [n * log(a), -m * log(b)] if n and m else [log(a)]
    total = reduce(add, parts) + log(high) - log(low)
    assert verdict(equal(whole, total), 0 < a, 0 < b, point={"a": 1, "b": 1}) == PROVED


def test_an_exponential_inside_another_one_stays() -> None:
    """The checker replaces no atom inside another one, so that this proof was refused."""
    claim = exp(exp(Fraction(-2, 3)) + 3) <= exp(exp(Fraction(-2, 3))) * exp(3)
    assert verdict(claim) == PROVED


def test_the_range_of_a_function_is_a_fact_before_it_is_used() -> None:
    """What equations make of it was written down before it was."""
    place = for_all("all", [2 <= x, x <= Fraction(5, 2)], {"x": 2})
    claims = {
        "law": equal(log(exp(Fraction(1, 3)) * exp(exp(x))), Fraction(1, 3) + exp(x)),
        "product": exp(x) * exp(-x) <= 1 + Fraction(1, 10**20),
    }
    rows = [ask(name, claim, place) for name, claim in claims.items()]
    found = prove(lemma("title", rows, contexts=[place]), work=1_500_000)
    assert {found.decisions[name].verdict for name in claims} == {PROVED}
