"""What plots show of Theorem 1, against exact decisions at points of each interval."""

from __future__ import annotations

from fractions import Fraction
from random import Random

import pytest

from verify.language.statement import PROVED, REFUTED, UNDECIDED
from verify.language.terms import Claim, as_term, equal, maximum, minimum, sqrt, symbol
from verify.paper.commands.curves import (
    FIXED,
    PARTS,
    SHARE,
    WHOLE,
    WIDTH,
    Curves,
    at_point,
    formulas,
    hull,
    intervals,
    ratio,
    set_over_r,
    sorted_rows,
    threshold_boxes,
    verdict,
)
from verify.paper.parameters import PRINTED, REPAIRED
from verify.prover.ground import Ground
from verify.prover.outcome import Ends

SETS = [(PRINTED, WHOLE), (REPAIRED, SHARE)]


def ground(group: str, share: Fraction, r: Fraction, c: Fraction = Fraction(1)) -> Ground:
    return at_point(group, share, FIXED | {"r": as_term(r), "c": as_term(c)})


def points(count: int, seed: int) -> list[tuple[Ends, Fraction]]:
    """Intervals of r, each with a point of it, now and then an end."""
    random = Random(seed)
    chosen = random.sample(intervals(), count)
    return [
        ((low, high), low + (high - low) * random.choice([0, 1, 3, 7, 8]) / 8)
        for low, high in chosen
    ]


@pytest.mark.parametrize(("group", "share"), SETS)
def test_constants_lie_in_their_enclosures(group: str, share: Fraction) -> None:
    curves, seen = set_over_r(group, share), 0
    letters = [symbol(constant.name) for constant in formulas(group, share)]
    for side, r in points(6, 1):
        exact = ground(group, share, r)
        for letter, values in zip(letters, curves.on(side, letters), strict=True):
            ends, found = hull(values), exact.enclose(letter)
            if ends is not None and found is not None:
                assert ends[0] <= found.ends[0][1], letter
                assert found.ends[0][0] <= ends[1], letter
                seen += 1
    assert seen > 100


@pytest.mark.parametrize(("group", "share"), SETS)
def test_verdicts_and_ratios_hold_at_points_of_the_interval(group: str, share: Fraction) -> None:
    claims, curves = sorted_rows(group, share).claims, set_over_r(group, share)
    decided, enclosed = {PROVED: 0, REFUTED: 0}, 0
    for side, r in points(4, 2):
        exact = ground(group, share, r)
        for name, claim in claims.items():
            left, right = curves.on(side, (claim.lhs, claim.rhs))
            said = verdict(claim.relation, left, right)
            if said != UNDECIDED:
                assert exact.prove(claim)[0] == said, (name, side)
                decided[said] += 1
            ends = ratio(left, right)
            if ends is not None:
                assert exact.prove(claim.lhs <= ends[1] * claim.rhs)[0] == PROVED, (name, side)
                assert exact.prove(ends[0] * claim.rhs <= claim.lhs)[0] == PROVED, (name, side)
                enclosed += 1
    assert decided[PROVED] > 100
    assert (decided[REFUTED] > 10) == (group == PRINTED)
    assert enclosed > 100


def test_algebraic_rows_hold_elsewhere_too() -> None:
    for group, share in SETS:
        exact = ground(group, share, Fraction(1, 125), Fraction(9, 10))
        for row in sorted_rows(group, share).algebraic:
            assert exact.prove(row.claim)[0] == PROVED, row.name


def bounds(low: str, high: str, term: object) -> Ends | None:
    return hull(Curves("x").on((Fraction(low), Fraction(high)), (as_term(term),))[0])


def test_terms_are_enclosed_on_intervals() -> None:
    x = symbol("x")
    low, high = bounds("0", "2", minimum(x, 2 - x)) or (1, 0)  # 0 at both ends, 1 between
    assert low <= 0 < 1 <= high < 1 + Fraction(2, PARTS)
    low, high = bounds("0", "2", maximum(x, 2 - x)) or (1, 0)
    assert low <= 1 < 2 <= high
    low, high = bounds("0.01", "2", sqrt(x)) or (1, 0)
    assert low <= Fraction(1, 10) < Fraction(7, 5) < high < Fraction(3, 2)


def test_what_is_undefined_somewhere_has_no_value() -> None:
    x = symbol("x")
    assert bounds("-1", "1", x) is not None
    for term in (1 / x, sqrt(x), sqrt(x) + 1):
        assert bounds("-1", "1", term) is None
    values = Curves("x").on((Fraction(-1), Fraction(1)), (1 / x, x))
    assert verdict("<", *values) == UNDECIDED
    assert ratio(*values) is None


@pytest.mark.parametrize(
    ("claim", "expected"),
    [
        (symbol("x") / 16 < as_term(Fraction("0.1249999")), UNDECIDED),
        (symbol("x") / 16 < as_term(Fraction("0.1250001")), PROVED),
        (symbol("x") / 16 < as_term(Fraction("0.0624")), REFUTED),
        (symbol("x") < symbol("x"), UNDECIDED),
        (as_term(0) < as_term(0), REFUTED),
        (as_term(0) <= as_term(0), PROVED),
        (equal(as_term(1), 1), PROVED),
        (equal(symbol("x"), symbol("x") + 2), REFUTED),
        (equal(symbol("x"), 1), UNDECIDED),
        (symbol("x") < as_term(Fraction(3, 2)), UNDECIDED),  # true on half of it
    ],
)
def test_near_misses(claim: Claim, expected: str) -> None:
    """On [1, 2]."""
    sides = Curves("x").on((Fraction(1), Fraction(2)), (claim.lhs, claim.rhs))
    assert verdict(claim.relation, *sides) == expected


def test_a_ratio_is_that_of_positive_numbers() -> None:
    x, side = symbol("x"), (Fraction(1), Fraction(2))
    assert ratio(*Curves("x").on(side, (-x, x))) is None
    assert ratio(*Curves("x").on(side, (x - 1, x))) is None
    low, high = ratio(*Curves("x").on(side, (2 * x, x * x))) or (0, 0)
    assert low <= 1 < 2 <= high < Fraction(5, 2)


def test_thresholds_contain_the_exact_points() -> None:
    curves = threshold_boxes(64)

    def height(name: str, s: Fraction) -> Ends:
        return next(box for (left, right), box in curves[name] if left <= s < right)

    low, high = height("stability", Fraction(1, 4))  # r = 1/64, c = 8/13
    assert low <= Fraction(8, 13) <= high
    low, high = height("existence", Fraction(1, 4))  # 4 √r/(1+r) = 32/65
    assert low <= Fraction(32, 65) <= high
    assert curves["stability"][-1][0][1] == WIDTH
