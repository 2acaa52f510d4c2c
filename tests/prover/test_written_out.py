"""Claims with named constants inside functions are those with their definitions."""

from __future__ import annotations

import random
from fractions import Fraction

import pytest

from verify.language.statement import PROVED, REFUTED, Constant
from verify.language.terms import Claim, Term, as_term, atan, equal, exp, log, sqrt, symbol
from verify.library import ask, for_all, lemma, prove
from verify.prover.outcome import Outcome

a, b, x = map(symbol, "abx")
#: Small or large, and of the other.
DEFINITIONS: list[tuple[Term, Term]] = [
    (as_term(10), a + 1),
    (as_term(10) ** 10, 2 * a),
    (as_term(Fraction(7, 2)), a**3),
    (as_term(4), a * a - a / 3),
]
IRRATIONAL: list[tuple[Term, Term]] = [(exp(2), a**2), (1 + sqrt(as_term(2)), 3 * a)]


def asked(claim: Claim, first: Term, second: Term, work: int = 20_000_000) -> Outcome:
    """The claim where x is at least a; the checker has judged it."""
    place = for_all("far", {"above": a <= x}, {"x": a})
    constants = [Constant(n, n, n, n, t) for n, t in (("a", first), ("b", second))]
    return prove(lemma("title", [ask("row", claim, place)], constants, [place]), work=work)


@pytest.mark.parametrize(("first", "second"), DEFINITIONS)
@pytest.mark.parametrize(
    "claim",
    [
        log(x) / x <= log(a) / a,
        a <= x * log(x) + 1,
        log(a) <= log(x),
        exp(-x) <= exp(-a),
        atan(a) * x <= x * atan(x),
        log(b) / b - log(x) <= log(b) / b - log(a),
        equal(x * log(a + b), x * log(b + a)),
    ],
)
def test_claims_of_pages_of_constants(claim: Claim, first: Term, second: Term) -> None:
    assert asked(claim, first, second).decisions["row"].verdict == PROVED


@pytest.mark.parametrize(("first", "second"), IRRATIONAL)
@pytest.mark.parametrize(
    "claim",
    [
        a <= x * log(x) + 1,
        log(a) <= log(x),
        1 < exp(log(x) * b),
    ],
)
def test_constants_that_are_no_rational_numbers(claim: Claim, first: Term, second: Term) -> None:
    assert asked(claim, first, second).decisions["row"].verdict == PROVED


@pytest.mark.parametrize(("first", "second"), [*DEFINITIONS, *IRRATIONAL])
@pytest.mark.parametrize("claim", [log(x) / x < log(a) / a, x <= a * log(b), atan(x) <= atan(a)])
def test_what_is_false_is_refuted_or_left(claim: Claim, first: Term, second: Term) -> None:
    assert asked(claim, first, second, 1_000_000).decisions["row"].verdict != PROVED


def test_random_claims_of_constants_are_decided_as_those_of_numbers() -> None:
    """The checker accepts each proof: a refused one is an error."""
    rng = random.Random(31)
    functions = [exp, log, atan, lambda t: 1 / t, lambda t: t * t]
    seen = set()
    for _ in range(12):
        low = Fraction(rng.randrange(1, 60), rng.choice([1, 2, 7]))
        f, g = rng.choice(functions), rng.choice(functions)
        by_name, by_number = (
            f(x) * g(t) + rng_sum <= g(x) * x + f(t) * g(t) + rng_sum
            for rng_sum in [rng.randrange(3) * log(as_term(3))]
            for t in (a, as_term(low))
        )
        named, plain = (
            asked(claim, as_term(low), a, 3_000_000).decisions["row"].verdict
            for claim in (by_name, by_number)
        )
        seen.add(named)
        if plain == PROVED:
            assert named == PROVED, (low, by_name)
        assert {named, plain} != {PROVED, REFUTED}
    assert PROVED in seen
