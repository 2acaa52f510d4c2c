"""The figures: what their captions and tables say, and how they are drawn."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET
import zlib
from fractions import Fraction
from itertools import pairwise
from types import SimpleNamespace

import pytest

from tests.paper.spectrum.page import terms
from tests.views.conftest import TABLE
from verify.language.fold import holds
from verify.language.statement import REFUTED, UNDECIDED
from verify.language.terms import Claim, as_term
from verify.paper.commands import curves, pages
from verify.paper.commands.pages import accepted
from verify.paper.commands.report import plotted
from verify.paper.commands.spectrum import roots_of_q
from verify.paper.commands.thresholds import STRIPS, bands, certified
from verify.paper.parameters import PRINTED, REPAIRED
from verify.paper.theorem1 import theorem
from verify.prover.outcome import Decision
from verify.prover.program import ExactArithmetic, Machine, Program
from verify.publication import ACCUSATIONS
from verify.views.plots import figures, margins, region, speed
from verify.views.plots.drawing import HATCHED, standalone, svg
from verify.views.plots.map_picture import png_map
from verify.views.plots.shapes import Curve, Panel, Rule, Scale, Words, marks, merged, powers
from verify.views.style import SCHEMES


def phi_plus_is_below(q: Fraction, s: Fraction, c: Fraction) -> bool:
    """Whether the larger root of x^2 - alpha_0 x + r is less than q, for rationals."""
    r = s**3
    alpha_0 = (1 + r) * c / 2
    return alpha_0 / 2 < q and q**2 - alpha_0 * q + r > 0


def test_cells_of_the_picture_lie_where_they_say() -> None:
    stable = next(
        row.claim
        for row in theorem().parts["hypotheses"].obligations
        if row.name == "hypotheses.stability"
    )
    assert isinstance(stable, Claim)
    program = Program(("r", "c"))
    sides = program.add(stable.lhs), program.add(stable.rhs)
    run, seen = Machine(program, ExactArithmetic()), set()
    for low, high, refuted in bands(accepted("thresholds")):
        inside = region.cells(curves.WIDTH, low, high)
        for (left, right), (bottom, top) in list(inside)[::7]:
            for k in range(1, 8):
                s, c = left + (right - left) * k / 8, bottom + (top - bottom) * (k * 3 % 8) / 8
                values = run.run([s**3, c]).values
                assert holds(stable.relation, *(values[side] for side in sides))
                assert phi_plus_is_below(high, s, c)
                assert not low or not phi_plus_is_below(low, s, c)
                seen.add(refuted)
    assert seen == {0, 1, 2, None}


def test_captions_count_what_is_drawn() -> None:
    found = plotted(pages.decide("all_parameters"))
    figure, outcome = region.picture(found.region), pages.decide("printed_rows")
    refuted = [
        found
        for row, found in outcome.rows
        if found.verdict == REFUTED and row.severity in ACCUSATIONS
    ]
    always = [found for found in refuted if not found.witness]
    assert f"Left: {len(always)} printed rows" in figure.caption
    assert len(figure.rows) == 1 + len(refuted) - len(always)
    assert len(certified(accepted("thresholds"))) == len(STRIPS)


def test_a_strip_that_is_not_proved_is_not_drawn() -> None:
    outcome = accepted("thresholds")
    lost = {**outcome.decisions, "angle-absorbed.fails": Decision(UNDECIDED)}
    found = bands(outcome._replace(decisions=lost))
    assert [refuted for *_, refuted in found] == [1, 0, None, None]


def test_margins_are_on_the_right_side() -> None:
    refuted, others = margins.printed_ratios(curves.ratios(PRINTED, curves.WHOLE))
    assert len(refuted) > 10
    assert all(row.verdicts.isdisjoint({REFUTED}) for row in others)
    for row in curves.ratios(REPAIRED, curves.SHARE):
        assert REFUTED not in row.verdicts
        assert all(low <= 1 for _, (low, _) in row.boxes)
    cuts = curves.intervals()
    assert all(left[1] == right[0] for left, right in pairwise(cuts))
    assert 0 < cuts[0][0] < cuts[-1][1] < curves.END


POINTS = (Fraction(-27, 343), Fraction(2), Fraction(-1, 3))


def test_the_roots_are_roots() -> None:
    """At a rational m: Q(-m^3) = 0, and Q(λ) = (λ+m^3)((λ-x)^2+w)."""
    program = Program(())
    value = as_term(Fraction(3, 7))
    program.define("m", value)
    run = Machine(program, ExactArithmetic()).run(())
    r, x, w = (run[term] for term in roots_of_q())
    for point, q in zip(POINTS, terms(*(f"Q({point}, r_of(m))" for point in POINTS)), strict=True):
        assert run[q] == (point + Fraction(27, 343)) * ((point - x) ** 2 + w)
    cell = next(c for c in curves.roots() if c.side[0] <= Fraction(3, 7) < c.side[1])
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
    assert set(SCHEMES["light"]) == set(SCHEMES["dark"])


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_verdicts_differ_in_grey(scheme: str) -> None:
    """By lightness where areas meet, and by hatching; words by contrast with the paper."""
    colours = SCHEMES[scheme]
    assert contrast(colours["proved-area"], colours["refuted-area"]) > 3
    assert set(HATCHED) == {"refuted-area"}
    assert contrast(colours["refuted-area"], colours["refuted-line"]) > 3
    assert contrast(colours["proved-area"], colours["undecided"]) > 3
    for name in ("ink", "faint", "proved", "refuted"):
        assert contrast(colours[name], colours["paper"]) > 4.4, name


def contrast(one: str, other: str) -> float:
    """The ratio of lightnesses that the guidelines for accessible pages define."""
    dark, light = sorted((lightness(one), lightness(other)))
    return (light + 0.05) / (dark + 0.05)


def lightness(colour: str) -> float:
    parts = [int(colour[i : i + 2], 16) / 255 for i in (1, 3, 5)]
    linear = [p / 12.92 if p <= 0.04045 else ((p + 0.055) / 1.055) ** 2.4 for p in parts]
    return sum(share * p for share, p in zip((0.2126, 0.7152, 0.0722), linear, strict=True))


def test_drawings_are_well_formed_and_take_their_colours_from_the_page(page: str) -> None:
    drawings = re.findall(r"<svg .*?</svg>", page, re.DOTALL)
    plots = sum(
        len(figure.panels) for figure in figures(plotted(pages.decide("all_parameters")), TABLE)
    )
    collapses, map_panels = 2 * 2, 3
    assert len(drawings) == plots + 3 + collapses + map_panels  # letters, the proof, the curve
    for text in drawings:
        root = ET.fromstring(text)
        assert len(root.attrib["aria-label"]) > 60
        assert not re.findall("#[0-9a-f]{6}", text)
        assert set(re.findall(r"var\(--([a-z0-9-]+)\)", text)) <= set(SCHEMES["light"])
        assert "<text" in text


def test_letters_in_figures_are_large_enough_on_a_phone(page: str) -> None:
    """A drawing is at least 300 pixels wide on a screen of 390: ten pixels for each letter."""
    for text in re.findall(r"<svg .*?</svg>", page, re.DOTALL):
        width = float(re.search(r'viewBox="0 0 ([0-9]+)', text)[1])  # type: ignore[index]
        sizes = [float(size) for size in re.findall(r'font-size="([0-9.]+)"', text)]
        assert min(sizes) * 354 / width >= 8.8
        assert max(sizes) * 354 / width >= 10


def test_every_refuted_formula_of_the_proof_leads_to_its_card(page: str) -> None:
    drawing = page[page.index('id="plot-proof"') :].partition("</svg>")[0]
    targets = re.findall(r'<a href="([^"]+)"', drawing)
    assert len(targets) > 20
    assert sum(target.startswith("printed.html#printed.") for target in targets) >= 8


def test_a_picture_that_stands_alone_brings_its_colours() -> None:
    unit = Scale("x", 0, 1, marks("0", "1"))
    shapes = [Curve([(0, 0), (1, 1)], "series-1", 0, "a line"), Rule(0.5), Words((0, 0), "<zero>")]
    text = standalone(svg("picture", [Panel("", unit, unit, lambda: shapes)], "a line"))
    assert "&lt;zero&gt;" in text
    ET.fromstring(text)
    assert "prefers-color-scheme:dark" in text
    assert f"--ink:{SCHEMES['light']['ink']}" in text


def test_precision_is_left_as_it_was() -> None:
    from flint import ctx

    before = ctx.prec
    curves.threshold_boxes(8)
    assert ctx.prec == before


def test_scales() -> None:
    linear, logarithmic = Scale("", 1, 3, ()), Scale("", 1, 100, (), logarithmic=True)
    assert [linear.share(x) for x in (1, 2, 3)] == [0, 0.5, 1]
    assert [logarithmic.share(x) for x in (1, 10, 100)] == [0, 0.5, 1]
    assert powers(-2, 0) == [(0.01, "10⁻²"), (0.1, "10⁻¹"), (1.0, "10⁰")]


def test_a_dot_is_undecided_only_where_something_in_it_is() -> None:
    """Boxes smaller than a dot count together: the first dot is filled, the second half filled."""
    first, second, rest = "0" * 10, "0" * 9 + "1", ["0" * n + "1" for n in range(9)]
    letters = {first + "0": "c", first + "10": "c", first + "11": "c", second + "0": "c"}
    letters |= dict.fromkeys(rest, "d")
    shares = {"collapses": Fraction(3, 2048), "disperses": Fraction(511, 512), "finite": 0}
    progress = SimpleNamespace(
        document={"name": "family", "axes": ["r"], "r": "x"},
        digits="01",
        level=12,
        decided=lambda: ((key, letter, ()) for key, letter in letters.items()),
        areas=SimpleNamespace(**shares, undecided=Fraction(1, 2048)),
    )
    png = png_map(progress)
    start = png.index(b"IDAT") + 4
    row = zlib.decompress(png[start : start + int.from_bytes(png[start - 8 : start - 4])])[-1024:]
    assert row == b"\1\0" + b"\2" * 1022
