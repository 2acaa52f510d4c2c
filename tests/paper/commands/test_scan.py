"""Many points in one process have the verdicts of the single points."""

from __future__ import annotations

from fractions import Fraction

import pytest

from verify.language.statement import REFUTED
from verify.language.terms import as_term, symbol
from verify.paper.commands import scan
from verify.paper.commands.scan import Grid, Scan, _job
from verify.paper.commands.theorem1 import decide_point
from verify.paper.theorem1 import theorem
from verify.views.words import fair
from verify.wire.compiled import Kept

PARAMETERS = {
    "r": Fraction(1),
    "c": Fraction(1),
    "V_0": Fraction(1),
    "delta_theta": Fraction(1, 10),
}


def single(parameters) -> tuple[str, dict[str, str]]:
    outcome = decide_point({name: as_term(value) for name, value in parameters.items()})
    return outcome.verdict, {row.name: fair(outcome, row, found) for row, found in outcome.rows}


@pytest.mark.parametrize("c", ["1", "97/100", "1/2"])
def test_grid(c) -> None:
    parameters = PARAMETERS | {"c": Fraction(c)}
    grid = Grid(Fraction(1, 1000), Fraction(6, 100), 13, parameters)
    for r, point in (pair for places in grid.parts(5) for pair in grid.part(places)):
        here = parameters | {"r": r}
        assert (point.verdict, dict(point.rows)) == single(here)


def test_points_far_apart() -> None:
    job = Scan()
    for r, v, deviation in (("3/100", 1, "1/10"), ("1e-9", 10**20, "1/1000"), ("1/50", "1/7", 3)):
        here = PARAMETERS | {
            "r": Fraction(r),
            "V_0": Fraction(v),
            "delta_theta": Fraction(deviation),
        }
        point = job.at(here)
        assert (point.verdict, dict(point.rows)) == single(here)


def test_most_points_need_no_single_run(monkeypatch) -> None:
    calls = []
    monkeypatch.setattr(
        "verify.paper.commands.scan.decide_point",
        lambda parameters: calls.append(1) or decide_point(parameters),
    )
    _job.cache_clear()
    points = Grid(Fraction(1, 1000), Fraction(55, 1000), 200, PARAMETERS).part(range(200))
    assert len(points) == 200
    assert len(calls) <= 5
    assert {point.verdict for _, point in points} == {"proved"}


def test_only_claims_that_balls_show_are_built_on(monkeypatch) -> None:
    """Whoever says that a row is refuted where r is above 1 is not believed where it is below."""
    here, found = PARAMETERS | {"r": Fraction(3, 100)}, theorem()
    for need, believed in ((as_term(1) < symbol("r"), False), (symbol("r") < as_term(1), True)):
        lies = {claim: Kept(REFUTED, (need,)) for claim in found.kept}
        monkeypatch.setattr(scan, "theorem", lambda: found._replace(kept=lies))  # noqa: B023
        point = Scan().at(here)
        assert (point.verdict == REFUTED) is believed
        assert believed or (point.verdict, dict(point.rows)) == single(here)


def test_a_grid_has_its_ends_and_equal_distances() -> None:
    grid = Grid(Fraction(1, 100), Fraction(1, 20), 9, PARAMETERS)
    places = [i for part in grid.parts(4) for i in part]
    assert places == [*range(9)]
    assert [*map(grid.value, places)] == [Fraction(2 + i, 200) for i in places]
