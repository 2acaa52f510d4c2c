"""Claims without variables: what is decided, what must not be, and that the checker agrees."""

from __future__ import annotations

import time
from fractions import Fraction
from math import isqrt

import pytest

from verify import check
from verify.language.statement import (
    NEEDED,
    PROVED,
    REFUTED,
    UNDECIDED,
    Constant,
    Obligation,
    Statement,
)
from verify.language.terms import Claim, Term, as_term, exp, minimum, sin, sqrt, symbol
from verify.library import ask, lemma, prove
from verify.prover.choices import round_to_digits
from verify.prover.ground import Ground
from verify.prover.outcome import Decision, Outcome
from verify.prover.rules import Interval, Sum
from verify.prover.session import Session
from verify.prover.tight import Tight
from verify.wire.write import write

a, b, m, n = (symbol(name) for name in "abmn")


class Defined:
    """Some constants, and decisions on claims about them, each checked by the kernel."""

    def __init__(self, **terms: Term | int | Fraction) -> None:
        self.constants = [
            Constant(name, name, name, "label", as_term(term)) for name, term in terms.items()
        ]

    def decide(self, claim: Claim) -> Decision:
        ground = Ground(Session(), 64, 1024)
        defined = [c for c in self.constants if ground.define(c)]
        row = Obligation("row", "", "", NEEDED, "says", claim)
        decision = ground.decide(row)
        if decision.verdict != UNDECIDED:
            statement = Statement("test", "test", {}, tuple(defined), (), (row,), ())
            steps = tuple(ground.session.steps)
            enclosures = {c.name: e for c in defined if (e := ground.enclose(c.term)) is not None}
            files = write(Outcome(statement, {"row": decision}, steps, enclosures))
            report = check.check(files["statement.json"], files["certificate.json"], {})
            assert report.verdict == decision.verdict.upper(), report.lines
        return decision

    def verdict(self, claim: Claim) -> str:
        return self.decide(claim).verdict


def test_balls_decide_strict_inequalities() -> None:
    defined = Defined(a=sqrt(2))
    assert defined.verdict(a < Fraction(1415, 1000)) == PROVED
    assert defined.verdict(a < Fraction(1414, 1000)) == REFUTED


def test_the_ladder_climbs_to_the_precision_that_decides() -> None:
    defined = Defined(a=sqrt(2))
    near = Fraction(14142135623730950488016887242096980785696718753769480731766797, 10**61)
    decision = defined.decide(a < near + Fraction(1, 10**61))
    assert decision.verdict == PROVED
    assert decision.bits > 128
    assert defined.verdict(a <= near) == REFUTED


def test_what_one_claim_needed_is_tried_for_the_next_before_algebra(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    searched: list[Claim] = []

    def prove(_: Tight, claim: Claim) -> None:
        searched.append(claim)

    monkeypatch.setattr(Tight, "prove", prove)
    near = Fraction(isqrt(2 * 10**1200), 10**600)
    ground = Ground(Session(), 64, 4096)
    ground.define(Constant("a", "a", "a", "label", sqrt(2)))
    for _ in range(3):
        near += Fraction(1, 10**600)
        assert ground.prove(a < near)[0] == PROVED
        assert {*searched} <= {a < searched[0].rhs, searched[0].rhs <= a}


def test_exact_values_decide_equalities_of_rationals() -> None:
    defined = Defined(a=Fraction(1, 3))
    assert defined.verdict(3 * a <= 1) == PROVED
    decision = defined.decide(3 * a < 1)
    assert decision.verdict == REFUTED
    assert isinstance(decision.proof, Interval)


def test_a_min_is_at_most_each_entry_and_not_less_than_the_least() -> None:
    defined = Defined(a=sqrt(2), b=sqrt(3), m=minimum(a, b))
    decision = defined.decide(m <= a)
    assert (decision.verdict, decision.method) == (PROVED, "entry")
    assert defined.verdict(2 * m <= a + a) == PROVED


def test_a_min_is_not_replaced_where_that_would_make_the_claim_easier() -> None:
    defined = Defined(a=sqrt(2), m=minimum(a, sqrt(3)))
    assert defined.verdict(m <= a) == PROVED
    assert defined.verdict(-m <= -a) != REFUTED
    assert defined.verdict(1 / a <= 1 / m) == PROVED


def test_definitions_are_unfolded_down_to_an_identity() -> None:
    defined = Defined(a=sqrt(5), b=(1 - a) / 2, n=1 - b)
    decision = defined.decide(a + 2 * b <= 1)
    assert decision.verdict == PROVED
    assert isinstance(decision.proof, Sum)
    assert defined.verdict(n <= (1 + a) / 2) == PROVED
    assert defined.verdict(n < (1 + a) / 2) == REFUTED


def test_an_undefined_side_is_never_decided() -> None:
    defined = Defined(a=sqrt(2))
    undefined = 1 / (a * a - 2)
    for claim in (undefined < 1, undefined <= undefined, Claim("<", as_term(0), undefined)):
        assert defined.verdict(claim) == UNDECIDED


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


HUGE, EXP = as_term(10**9), exp(as_term(60_000))


@pytest.mark.parametrize(
    ("claim", "expected"),
    [
        (exp(-3 * HUGE) < 1, PROVED),
        (0 < exp(-3 * HUGE), PROVED),
        (exp(-exp(as_term(12))) < Fraction(1, 10), PROVED),
        (exp(as_term(65_535)) <= exp(as_term(65_535)), PROVED),
        (2 <= exp(sqrt(HUGE**2)), UNDECIDED),
        (1 < exp(HUGE), UNDECIDED),
        (exp(HUGE - 1) < exp(HUGE), UNDECIDED),
        (0 < EXP**999, UNDECIDED),
        (0 < (EXP**999) ** 999, UNDECIDED),
        ((exp(-EXP) ** 999) ** 999 < 1, UNDECIDED),
        (sin(EXP) < 1, UNDECIDED),
    ],
)
def test_exponentials_that_are_huge_or_tiny_take_no_time(claim: Claim, expected: str) -> None:
    """Their digits fill the memory, and the checker encloses none of them."""
    before = time.process_time()
    found = prove(lemma("title", [ask("row", claim)]), work=1_000_000)
    assert found.decisions["row"].verdict == expected
    assert time.process_time() - before < 5
