"""The printed set for all parameters: every row decided, in agreement with single points."""

from __future__ import annotations

from fractions import Fraction

import pytest

from verify import check
from verify.language.statement import PROVED, REFUTED
from verify.language.terms import as_term
from verify.paper.commands import pages
from verify.paper.commands.theorem1 import decide_point
from verify.paper.commands.thresholds import STRIPS
from verify.paper.parameters import PRINTED
from verify.wire.read import read
from verify.wire.write import write

POINTS = [("3/100", "1", "1", "1/10"), ("1/1000", "3/10", "7", "1/1000")]


def test_every_row_is_decided() -> None:
    outcome = pages.decide("printed_rows")
    files = write(outcome)
    report = check.check(files["statement.json"], files["certificate.json"], {})
    assert report.verdict == "PROVED"
    assert {found.verdict for found in outcome.decisions.values()} == {PROVED, REFUTED}
    assert sum(map(len, files.values())) < 400_000
    assert read(files["statement.json"], files["certificate.json"], {}) == outcome.draft


@pytest.mark.parametrize("point", POINTS)
def test_a_point_agrees(point: tuple[str, ...]) -> None:
    names = ("r", "c", "V_0", "delta_theta")
    values = {name: as_term(Fraction(x)) for name, x in zip(names, point, strict=True)}
    there = decide_point(values, "printed").decisions
    for name, found in pages.decide("printed_rows").decisions.items():
        if found.method != "witness":
            assert there[name].verdict == found.verdict, name


def test_the_rows_that_depend_on_the_parameters_have_thresholds() -> None:
    found = pages.decide("printed_rows").decisions
    depending = {name for name, decision in found.items() if decision.witness}
    assert depending == {f"{PRINTED}.{strip.row}" for strip in STRIPS}
    assert [decision.verdict for decision in found.values()].count(REFUTED) == 28
    as_printed = found["hypotheses.angle-as-printed"]
    assert (as_printed.verdict, as_printed.method) == (REFUTED, "sum")  # for all of them


def test_the_state_of_the_display_is_where_it_has_to_be() -> None:
    """The row itself, at single points: refuted there, too, by enclosures."""
    for point in (*POINTS, ("55/1000", "1", "1/1000000", "1/10"), ("1/1000000", "1/20", "9", "1")):
        names = ("r", "c", "V_0", "delta_theta")
        values = {n: as_term(Fraction(x)) for n, x in zip(names, point, strict=True)}
        assert decide_point(values, "printed").decisions["printed.angle-sign"].verdict == REFUTED


def test_the_final_angle_depends_on_the_parameters() -> None:
    found = pages.decide("printed_rows").decisions["printed.final-angle"]
    assert (found.verdict, found.method) == (REFUTED, "witness")
    names = ("r", "c", "V_0", "delta_theta")
    values = {n: as_term(Fraction(x)) for n, x in zip(names, POINTS[0], strict=True)}
    assert decide_point(values, "printed").decisions["printed.final-angle"].verdict == PROVED
