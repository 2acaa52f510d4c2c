"""Enclosures over cells contain the values at their points, and their verdicts are true there."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from random import Random

import pytest

from tests.prover.judged import JudgedBox, cover
from verify.language.statement import PROVED, REFUTED, UNDECIDED
from verify.language.terms import Claim, Term, as_term, equal, maximum, minimum, sqrt, symbol
from verify.paper.commands.covers import (
    FIXED,
    PLANE,
    SHARE,
    WHOLE,
    WIDTH,
    at_point,
    field_definitions,
    formulas,
    plane,
    sorted_rows,
    stability,
    threshold_boxes,
)
from verify.paper.parameters import PRINTED, REPAIRED
from verify.prover import balls
from verify.prover.cover import Field, Values, parts, refined
from verify.prover.ground import Ground
from verify.prover.slopes import BITS


def judged_plane(group: str, share: Fraction, wanted: Iterable[str], depth: int) -> list[JudgedBox]:
    """The plane, cut until every wanted row of a set is decided on each cell."""
    claims = sorted_rows(group, share).claims
    return cover(plane(group, share), PLANE, depth, stability(), claims, wanted)


def ground(group: str, share: Fraction, s: Fraction, c: Fraction) -> Ground:
    return at_point(group, share, FIXED | {"r": as_term(s**3), "c": as_term(c)})


def verdict(ground: Ground, claim: Claim) -> str:
    return ground.prove(claim)[0]


def inside(judged: JudgedBox, random: Random) -> tuple[Fraction, Fraction]:
    """A point of a cell, now and then a corner."""
    point = [low + (high - low) * Fraction(random.choice([0, 1, 3, 7, 8]), 8)
             for low, high in judged.box]  # fmt: skip
    return point[0], point[1]


@pytest.mark.parametrize(("group", "share"), [(PRINTED, WHOLE), (REPAIRED, SHARE)])
def test_constants_lie_in_their_enclosures(group: str, share: Fraction) -> None:
    random = Random(1)
    field, seen = plane(group, share), 0
    for judged in random.sample(judged_plane(group, share, (), 5), 12):
        if judged.condition != PROVED:
            continue
        s, c = inside(judged, random)
        exact = ground(group, share, s, c)
        with balls.precision(BITS):
            values = field.on(judged.box)
            for constant in formulas(group, share):
                letter = symbol(constant.name)
                ends, found = values.ends(letter), exact.enclose(letter)
                if ends is not None and found is not None:
                    assert ends[0] <= found.ends[0][1], constant.name
                    assert found.ends[0][0] <= ends[1], constant.name
                    seen += 1
    assert seen > 100


@pytest.mark.parametrize(("group", "share"), [(PRINTED, WHOLE), (REPAIRED, SHARE)])
def test_verdicts_on_cells_hold_at_their_points(group: str, share: Fraction) -> None:
    random = Random(2)
    claims = sorted_rows(group, share).claims
    cells = [j for j in judged_plane(group, share, claims, 4) if j.condition == PROVED]
    decided = {PROVED: 0, REFUTED: 0}
    for judged in random.sample(cells, 6):
        s, c = inside(judged, random)
        exact = ground(group, share, s, c)
        for name, claim in claims.items():
            if judged.verdicts[name] != UNDECIDED:
                assert verdict(exact, claim) == judged.verdicts[name], (name, judged.box)
                decided[judged.verdicts[name]] += 1
    assert decided[PROVED] > 100
    assert (decided[REFUTED] > 10) == (group == PRINTED)


def test_algebraic_rows_hold_elsewhere_too() -> None:
    for group, share in ((PRINTED, WHOLE), (REPAIRED, SHARE)):
        exact = ground(group, share, Fraction(1, 5), Fraction(9, 10))
        for row in sorted_rows(group, share).algebraic:
            assert verdict(exact, row.claim) == PROVED, row.name


def on(cell: tuple[tuple[Fraction, Fraction], ...]) -> Values:
    return Field(("x", "y")[: len(cell)], ()).on(cell)


def ends(values: Values, term: Term) -> tuple[Fraction, Fraction]:
    found = values.ends(term)
    assert found is not None
    return found


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
    curves = threshold_boxes(64)

    def height(name: str, s: Fraction) -> tuple[Fraction, Fraction]:
        return next(box for (left, right), box in curves[name] if left <= s < right)

    low, high = height("stability", Fraction(1, 4))  # r = 1/64, c = 8/13
    assert low <= Fraction(8, 13) <= high
    low, high = height("existence", Fraction(1, 4))  # 4 √r/(1+r) = 32/65
    assert low <= Fraction(32, 65) <= high
    assert curves["stability"][-1][0][1] == WIDTH


def test_the_formula_of_phi_plus_is_the_larger_root() -> None:
    exact = ground(PRINTED, WHOLE, Fraction(1, 4), Fraction(9, 10))
    known = dict(field_definitions(formulas(PRINTED, WHOLE)))
    assert verdict(exact, equal(known["phi_plus"], symbol("phi_plus"))) == PROVED


def test_an_equation_is_refuted_and_proved_by_the_sign_of_the_difference() -> None:
    x = symbol("x")
    field = Field(("x",), ())
    slots = field.slots(
        {"same": equal(as_term(1), 1), "other": equal(x, x + 1), "some": equal(x, 1)}
    )
    with balls.precision(BITS):
        values = field.on(((Fraction(1), Fraction(2)),))
        assert [values.judge(slots[n]) for n in ("same", "other", "some")] == [
            PROVED, REFUTED, UNDECIDED
        ]  # fmt: skip


def area(box: tuple[tuple[Fraction, Fraction], ...]) -> Fraction:
    (a, b), (c, d) = box
    return (b - a) * (d - c)


SQUARE = ((Fraction(0), Fraction(1)), (Fraction(0), Fraction(1)))


def test_the_boxes_of_a_cover_are_the_whole_box() -> None:
    field = Field(("x", "y"), ())
    found = refined(field, SQUARE, 3, None, lambda values, _: (None, False))
    assert len(found) == 64
    assert sum(area(box) for box, _, _ in found) == 1
    assert sum(area(part) for part in parts(SQUARE)) == 1


def test_a_cover_leaves_out_only_where_the_condition_fails() -> None:
    x, y = symbol("x"), symbol("y")
    disc, claims = x * x + y * y < 1, {"inside": x < 1, "half": x < Fraction(1, 2)}
    found = cover(Field(("x", "y"), ()), SQUARE, 5, disc, claims, claims)
    for judged in found:
        (left, right), (low, high) = judged.box
        assert left**2 + low**2 < 1
        if judged.condition == PROVED:
            assert right**2 + high**2 < 1
            assert judged.verdicts["inside"] == PROVED
        if judged.verdicts.get("half") == PROVED:
            assert right < Fraction(1, 2)
    decided = sum(area(j.box) for j in found if j.condition == PROVED)
    assert Fraction(7, 10) < decided < Fraction(315, 400)
    assert sum(judged.weight for judged in found) <= 4**5
