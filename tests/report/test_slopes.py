"""Enclosures over cells contain the values at their points, and their verdicts are true there."""

from __future__ import annotations

from fractions import Fraction
from random import Random

import pytest

from verify.prover import balls
from verify.views.plots.constructions import FIXED, as_formulas, definitions, rows
from verify.views.plots.field import Field, Values
from verify.views.plots.plane import CUBE, INPUTS, WIDTH, Judged, judge, thresholds
from verify.views.plots.slopes import BITS
from verify.prover.ground import PROVED, REFUTED, UNDECIDED, Prover
from verify.language.statement import PRINTED, REPAIRED
from verify.language.terms import as_term, maximum, minimum, sqrt, symbol

HALF = Fraction(1, 2)


def prover(group: str, share: Fraction, s: Fraction, c: Fraction) -> Prover:
    return Prover(as_formulas(group, share), FIXED | {"r": as_term(s**3), "c": as_term(c)})


def inside(judged: Judged, random: Random) -> tuple[Fraction, Fraction]:
    """A point of a cell, now and then a corner."""
    point = [low + (high - low) * Fraction(random.choice([0, 1, 3, 7, 8]), 8)
             for low, high in judged.cell]  # fmt: skip
    return point[0], point[1]


@pytest.mark.parametrize(("group", "share"), [(PRINTED, Fraction(1)), (REPAIRED, HALF)])
def test_constants_lie_in_their_enclosures(group: str, share: Fraction) -> None:
    random = Random(1)
    statement = as_formulas(group, share)
    field = Field(INPUTS, (CUBE, *definitions(statement)))
    seen = 0
    for judged in random.sample(judge(group, share, {}, (), 5), 12):
        if judged.admissible != PROVED:
            continue
        s, c = inside(judged, random)
        exact = prover(group, share, s, c)
        with balls.precision(BITS):
            values = field.on(judged.cell)
            for constant in statement.constants:
                slope, ends = values[symbol(constant.name)], exact.enclose(symbol(constant.name))
                if slope is not None and ends is not None:
                    low, high = balls.ends(slope.range)
                    assert low <= ends[1], constant.name
                    assert ends[0] <= high, constant.name
                    seen += 1
    assert seen > 100


@pytest.mark.parametrize(("group", "share"), [(PRINTED, Fraction(1)), (REPAIRED, HALF)])
def test_verdicts_on_cells_hold_at_their_points(group: str, share: Fraction) -> None:
    random = Random(2)
    claims = {row.name: row.claim for row in rows(group, share).open}
    cells = [j for j in judge(group, share, claims, claims, 4) if j.admissible == PROVED]
    decided = {PROVED: 0, REFUTED: 0}
    for judged in random.sample(cells, 6):
        s, c = inside(judged, random)
        exact = prover(group, share, s, c)
        for name, claim in claims.items():
            if judged.verdicts[name] != UNDECIDED:
                assert exact.decide(claim).verdict == judged.verdicts[name], (name, judged.cell)
                decided[judged.verdicts[name]] += 1
    assert decided[PROVED] > 100
    assert (decided[REFUTED] > 10) == (group == PRINTED)


def test_algebraic_rows_hold_elsewhere_too() -> None:
    for group, share in ((PRINTED, Fraction(1)), (REPAIRED, HALF)):
        exact = prover(group, share, Fraction(1, 5), Fraction(9, 10))
        for row in rows(group, share).algebraic:
            assert exact.decide(row.claim).verdict == PROVED, row.name


def on(cell: tuple[tuple[Fraction, Fraction], ...]) -> Values:
    return Field(("x", "y")[: len(cell)], ()).on(cell)


def ends(values: Values, term: object) -> tuple[Fraction, Fraction]:
    slope = values[term]  # type: ignore[index]
    assert slope is not None
    return balls.ends(slope.range)


def test_slopes_beat_plain_balls_and_stay_right() -> None:
    x = symbol("x")
    with balls.precision(BITS):
        values = on(((Fraction(9, 10), Fraction(11, 10)),))
        low, high = ends(values, x * x - 2 * x + 1)  # (x-1)^2, in [0, 1/100]
        assert low <= 0 < Fraction(1, 100) <= high
        assert high - low < Fraction(1, 10)  # plain balls give 4/5
        low, high = ends(values, x - x)
        assert low <= 0 <= high < Fraction(1, 10**15)


def test_kinks_are_enclosed() -> None:
    x = symbol("x")
    with balls.precision(BITS):
        values = on(((Fraction(0), Fraction(2)),))
        low, high = ends(values, minimum(x, 2 - x))  # 0 at both ends, 1 between
        assert low <= 0 < 1 <= high
        low, high = ends(values, maximum(x, 2 - x))
        assert low <= 1 < 2 <= high
        low, high = ends(on(((Fraction(1, 100), Fraction(2)),)), sqrt(x))
        assert low <= Fraction(1, 10) < Fraction(7, 5) < high


def test_what_is_undefined_somewhere_has_no_value() -> None:
    x = symbol("x")
    with balls.precision(BITS):
        values = on(((Fraction(-1), Fraction(1)),))
        assert values[1 / x] is None
        assert values[sqrt(x)] is None
        assert values[sqrt(x) + 1] is None
        slots = Field(("x",), ()).slots({"a": 0 < 1 / x})
        assert Field(("x",), ()).on(((Fraction(-1), Fraction(1)),)) is not None
        assert slots


@pytest.mark.parametrize(
    ("text", "verdict"), [("0.1249999", UNDECIDED), ("0.1250001", PROVED), ("0.0624", REFUTED)]
)
def test_near_misses(text: str, verdict: str) -> None:
    """x/16 < bound on [1, 2]: true above 1/8, false below 1/16, neither in between."""
    field = Field(("x",), ())
    slot = field.slots({"row": symbol("x") / 16 < as_term(Fraction(text))})["row"]
    with balls.precision(BITS):
        assert field.on(((Fraction(1), Fraction(2)),)).judge(slot) == verdict


def test_an_equality_on_a_cell_is_never_decided() -> None:
    field = Field(("x",), ())
    x = symbol("x")
    slots = field.slots({"<": x < x, "<=": 2 * x <= x + x})
    with balls.precision(BITS):
        values = field.on(((Fraction(1), Fraction(2)),))
        assert values.judge(slots["<"]) != PROVED
        assert values.judge(slots["<="]) != REFUTED


def test_zero_is_not_below_zero() -> None:
    field = Field(("x",), ())
    zero = as_term(0)
    slots = field.slots({"<": zero < zero, "<=": zero <= zero})
    with balls.precision(BITS):
        values = field.on(((Fraction(1), Fraction(2)),))
        assert values.judge(slots["<"]) == REFUTED
        assert values.judge(slots["<="]) == PROVED


def test_thresholds_contain_the_exact_points() -> None:
    curves = thresholds(64)

    def height(name: str, s: Fraction) -> tuple[Fraction, Fraction]:
        return next(box for (left, right), box in curves[name] if left <= s < right)

    low, high = height("stability", Fraction(1, 4))  # r = 1/64, c = 8/13
    assert low <= Fraction(8, 13) <= high
    low, high = height("existence", Fraction(1, 4))  # 4 √r/(1+r) = 32/65
    assert low <= Fraction(32, 65) <= high
    assert curves["stability"][-1][0][1] == WIDTH


def test_the_formula_of_phi_plus_is_the_larger_root() -> None:
    statement = as_formulas(PRINTED, Fraction(1))
    exact = prover(PRINTED, Fraction(1), Fraction(1, 4), Fraction(9, 10))
    known = dict(definitions(statement))
    assert exact.decide(known["phi_plus"] <= symbol("phi_plus")).verdict != REFUTED
    assert exact.decide(symbol("phi_plus") <= known["phi_plus"]).verdict != REFUTED
