"""The figures: what their captions and tables say, and how they are drawn."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET
from fractions import Fraction
from itertools import pairwise
from pathlib import Path

import pytest

from tests.views.conftest import DEPTH, NEEDS_MATPLOTLIB, TABLE
from verify.jobs import covers
from verify.jobs.everywhere import decide_printed_everywhere
from verify.jobs.thresholds import decide_thresholds
from verify.language.statement import REFUTED, UNDECIDED
from verify.language.terms import as_term
from verify.paper.everywhere.thresholds import STRIPS
from verify.paper.groups import PRINTED, REPAIRED
from verify.paper.spectrum.complex_pair import imaginary_square, r_of_m, real_part
from verify.paper.spectrum.printed import Printed
from verify.prover.outcome import Decision
from verify.prover.program import ExactArithmetic, Machine, Program
from verify.prover.relations import holds
from verify.views.plots import figures, margins, region, speed
from verify.views.plots.drawing import COLOURS, SCHEMES, Panel, merged, standalone, svg


def phi_plus_is_below(q: Fraction, s: Fraction, c: Fraction) -> bool:
    """Whether the larger root of x^2 - alpha_0 x + r is less than q, for rationals."""
    r = s**3
    alpha_0 = (1 + r) * c / 2
    return alpha_0 / 2 < q and q**2 - alpha_0 * q + r > 0


def test_cells_of_the_picture_lie_where_they_say() -> None:
    stable = covers.stability()
    program = Program(("r", "c"))
    sides = program.add(stable.lhs), program.add(stable.rhs)
    run, seen = Machine(program, ExactArithmetic()), set()
    for low, high, refuted in region.bands():
        for (left, right), (bottom, top) in list(region.cells(low, high))[::7]:
            for k in range(1, 8):
                s, c = left + (right - left) * k / 8, bottom + (top - bottom) * (k * 3 % 8) / 8
                values = run.run([s**3, c]).values
                assert holds(stable.relation, *(values[side] for side in sides))
                assert phi_plus_is_below(high, s, c)
                assert not low or not phi_plus_is_below(low, s, c)
                seen.add(refuted)
    assert seen == {0, 1, 2, None}


def test_captions_count_what_is_drawn() -> None:
    figure, outcome = region.picture(), decide_printed_everywhere()
    refuted = [found for found in outcome.decisions.values() if found.verdict == REFUTED]
    always = [found for found in refuted if not found.witness]
    assert f"Left: {len(always)} printed rows" in figure.caption
    assert len(figure.rows) == 1 + len(refuted) - len(always)
    assert len(region.certified()) == len(STRIPS)


def test_a_strip_that_is_not_proved_is_not_drawn(monkeypatch: pytest.MonkeyPatch) -> None:
    outcome = decide_thresholds()
    lost = {**outcome.decisions, "angle-absorbed.fails": Decision(UNDECIDED)}
    monkeypatch.setattr(region, "decide_thresholds", lambda: outcome._replace(decisions=lost))
    assert [refuted for *_, refuted in region.bands()] == [1, 0, None, None]


def test_margins_are_on_the_right_side() -> None:
    refuted, others = margins.printed_ratios()
    assert len(refuted) > 10
    assert all(row.verdicts.isdisjoint({REFUTED}) for row in others)
    for row in covers.ratios(REPAIRED, covers.SHARE):
        assert REFUTED not in row.verdicts
        assert all(low <= 1 for _, (low, _) in row.boxes)
    cuts = covers.intervals()
    assert all(left[1] == right[0] for left, right in pairwise(cuts))
    assert 0 < cuts[0][0] < cuts[-1][1] < covers.END


def test_the_least_entry_is_the_least() -> None:
    for group in (PRINTED, REPAIRED):
        assert {index for _, index in covers.least_entries(group, DEPTH)} <= {None, 2}


def test_the_roots_are_roots() -> None:
    """At a rational m: Q(-m^3) = 0, and Q(λ) = (λ+m^3)((λ-x)^2+w)."""
    program = Program(())
    value = as_term(Fraction(3, 7))
    program.define("m", value)
    run = Machine(program, ExactArithmetic()).run(())
    r, x, w = run[r_of_m], run[real_part], run[imaginary_square]
    q = Printed().q
    for point in (Fraction(-27, 343), Fraction(2), Fraction(-1, 3)):
        expected = (point + Fraction(27, 343)) * ((point - x) ** 2 + w)
        assert run[q(as_term(point), as_term(r))] == expected
    cell = next(c for c in covers.roots() if c.side[0] <= Fraction(3, 7) < c.side[1])
    assert cell.r[0] <= r <= cell.r[1]
    assert cell.re[0] <= x <= cell.re[1]
    assert cell.im[0] ** 2 <= w <= cell.im[1] ** 2
    assert cell.real[0] <= Fraction(-27, 343) <= cell.real[1]


def test_speed_takes_any_engines_and_skips_what_was_not_measured() -> None:
    points = speed.points(TABLE)
    assert {engine: len(runs) for engine, runs in points.items()} == {"arb": 3, "iv": 2}
    assert speed.figure({"title": "", "columns": ["bits"], "rows": [[1]]}) is None
    found = speed.figure(TABLE)
    assert found is not None
    assert "Each of the 5 points" in found.caption


def test_neighbours_are_merged_into_the_same_area() -> None:
    zero, one, two, three = map(Fraction, range(4))
    cells = [(zero, one, zero, one), (one, two, zero, one), (zero, two, one, two),
             (two, three, zero, one)]  # fmt: skip
    boxes = list(merged(cells))
    assert sum((b - a) * (d - c) for a, b, c, d in boxes) == 5
    assert len(boxes) < len(cells)


def test_both_schemes_have_all_colours() -> None:
    assert set(SCHEMES["light"]) == set(SCHEMES["dark"]) == set(COLOURS)


@NEEDS_MATPLOTLIB
def test_drawings_are_well_formed_and_take_their_colours_from_the_page(made: Path) -> None:
    page = (made / "index.html").read_text(encoding="utf-8")
    drawings = re.findall(r"<svg .*?</svg>", page, re.DOTALL)
    assert len(drawings) == sum(len(figure.panels) for figure in figures(TABLE, DEPTH))
    for text in drawings:
        ET.fromstring(text)
        assert "#0102" not in text
        assert "var(--ink)" in text
        assert "<text" in text


@NEEDS_MATPLOTLIB
def test_a_picture_that_stands_alone_brings_its_colours() -> None:
    def draw(axis: object) -> None:
        axis.plot([0, 1], [0, 1], color=COLOURS["ink"])  # type: ignore[attr-defined]

    text = standalone(svg("picture", [Panel("", draw)], "a line"))
    ET.fromstring(text)
    assert "prefers-color-scheme:dark" in text
    assert f"--ink:{SCHEMES['light']['ink']}" in text


def test_precision_is_left_as_it_was() -> None:
    from flint import ctx

    before = ctx.prec
    covers.threshold_boxes(8)
    assert ctx.prec == before
