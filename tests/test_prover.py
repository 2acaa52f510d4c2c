"""The prover's three methods, and what they must not do."""

from __future__ import annotations

from fractions import Fraction

import pytest

from verify.prover.algebra import is_identity
from verify.prover.ground import PROVED, REFUTED, UNDECIDED, Prover, direction, round_to_digits
from verify.language.statement import Constant, Statement
from verify.language.terms import Claim, Term, as_term, maximum, minimum, sqrt, symbol

a, b, m, n = (symbol(name) for name in "abmn")


def prover_with(**terms: Term | int) -> Prover:
    constants = tuple(
        Constant(name, name, name, "label", as_term(term)) for name, term in terms.items()
    )
    return Prover(Statement("test", (), constants, (), ()), {}, 64, 1024)


def test_balls_decide_strict_inequalities() -> None:
    prover = prover_with(a=sqrt(2))
    assert prover.decide(a < Fraction(1415, 1000)).verdict == PROVED
    assert prover.decide(a < Fraction(1414, 1000)).verdict == REFUTED


def test_the_ladder_climbs_to_the_precision_that_decides() -> None:
    prover = prover_with(a=sqrt(2))
    near = Fraction(14142135623730950488016887242096980785696718753769480731766797, 10**61)
    decision = prover.decide(a < near + Fraction(1, 10**61))
    assert decision.verdict == PROVED
    assert decision.bits > 128
    assert prover.decide(a <= near).verdict == REFUTED


def test_exact_values_decide_equalities_of_rationals() -> None:
    prover = prover_with(a=Fraction(1, 3))
    assert prover.decide(3 * a <= 1).verdict == PROVED
    decision = prover.decide(3 * a < 1)
    assert (decision.verdict, decision.method) == (REFUTED, "exact")


def test_a_min_is_at_most_each_entry_and_not_less_than_the_least() -> None:
    prover = prover_with(a=sqrt(2), b=sqrt(3), m=minimum(a, b))
    decision = prover.decide(m <= a)
    assert (decision.verdict, decision.steps, decision.closing) == (PROVED, (("m", 0),), "identity")
    assert prover.decide(m < a).verdict == UNDECIDED
    assert prover.decide(2 * m <= a + a).verdict == PROVED
    assert prover.decide(a <= m).verdict == UNDECIDED


def test_a_min_is_not_replaced_where_that_would_make_the_claim_easier() -> None:
    prover = prover_with(a=sqrt(2), m=minimum(a, sqrt(2) + 0))
    assert prover.decide(a <= m).verdict == UNDECIDED
    assert prover.decide(-m <= -a).verdict == UNDECIDED
    assert prover.decide(1 / a <= 1 / m).verdict == PROVED
    assert prover.decide(1 / m <= 1 / a).verdict == UNDECIDED


def test_definitions_are_unfolded_down_to_an_identity() -> None:
    prover = prover_with(a=sqrt(5), b=(1 - a) / 2, n=1 - b)
    decision = prover.decide(a + 2 * b <= 1)
    assert (decision.verdict, decision.method) == (PROVED, "rewrite")
    assert prover.decide(n <= (1 + a) / 2).verdict == PROVED
    assert prover.decide(n < (1 + a) / 2).verdict == REFUTED


def test_an_identity_needs_roots_to_be_squared() -> None:
    assert is_identity(a / sqrt(a / b) ** 2, b)
    assert is_identity((sqrt(a) + 1) * (sqrt(a) - 1), a - 1)
    assert not is_identity(sqrt(a**2), a)
    assert not is_identity(a / b, a / b + Fraction(1, 10**40))
    assert not is_identity(sqrt(a) * sqrt(a), a + b)
    assert is_identity(minimum(a, b) * 2, minimum(a, b) + minimum(a, b))


@pytest.mark.parametrize(
    ("term", "expected"),
    [
        (m, 1),
        (a, 0),
        (a - m, -1),
        (a * m, 1),
        (-a * m, -1),
        (a / m, -1),
        (m / a, 1),
        (m - m * m, None),
        (m**2, 1),
        ((m - 5) ** 2, None),
        (sqrt(m), 1),
        (maximum(m, a), 1),
        (b * m, None),
    ],
)
def test_direction(term: Term, expected: int | None) -> None:
    """With a and m positive and the sign of b unknown."""
    signs = {a: 1, m: 1, -a: -1, as_term(1): 1}
    assert direction(term, "m", lambda t: signs.get(t, 0)) == expected


def test_an_undefined_side_is_never_decided() -> None:
    prover = prover_with(a=sqrt(2), b=1 / (a * a - 2))
    for claim in (b < 1, b <= b, Claim("<", as_term(0), b)):
        assert prover.decide(claim).verdict == UNDECIDED


@pytest.mark.parametrize(
    ("value", "up", "expected"),
    [
        ("0.12345", False, "0.123"),
        ("0.12345", True, "0.124"),
        ("999.5", True, "1000"),
        ("7", True, "7"),
    ],
)
def test_rounding_to_short_decimals(value: str, up: bool, expected: str) -> None:
    assert round_to_digits(Fraction(value), up) == Fraction(expected)
