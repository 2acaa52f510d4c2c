"""Maps, collapses and the graph of the proof are drawn as they are."""

from __future__ import annotations

import json
import math
import re
from fractions import Fraction
from hashlib import sha256
from itertools import pairwise
from pathlib import Path

import pytest

from tests.check.test_check_map import sealed
from tests.views.conftest import few_boxes
from verify.paper.commands import pages
from verify.paper.commands.regenerate import is_right_when_accepted
from verify.paper.commands.report import NAMES
from verify.paper.commands.report_files import CertificateError
from verify.paper.commands.report_maps import log_names, read_map, read_strip, story
from verify.prover.outcome import Outcome
from verify.spheres.scene import scene_files
from verify.spheres.scene.scene import Scene
from verify.views.findings import CertifiedMap
from verify.views.page.blueprint import direct, edges_between_labels, levels, lowered
from verify.views.plots import collapse, map_figure
from verify.views.plots.shapes import merged, round_marks
from verify.views.typesetting import prose
from verify.wire.judge import read_judged as read
from verify.wire.write import write

HERE = Path(__file__).parents[2] / "certificates"


# --- maps ----------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def log(tmp_path_factory: pytest.TempPathFactory) -> Path:
    directory = tmp_path_factory.mktemp("logs")
    (directory / "map").mkdir()
    content = few_boxes((HERE / "map" / "map.jsonl").read_bytes())
    (directory / "map" / "map.jsonl").write_bytes(content)
    return directory


@pytest.fixture(scope="module")
def found(log: Path) -> CertifiedMap:
    (name,) = log_names(str(log))
    return read_map(str(log), name)


def test_a_log_is_shown_only_if_its_checker_accepts_it(log: Path, tmp_path: Path) -> None:
    (tmp_path / "map").mkdir()
    text = (log / "map" / "map.jsonl").read_text(encoding="utf-8")
    (tmp_path / "map" / "map.jsonl").write_text(text.replace('"verdicts":"c', '"verdicts":"d'))
    with pytest.raises(CertificateError):
        read_map(str(tmp_path), "map/map.jsonl")


def test_drawn_areas_are_those_of_the_log(found: CertifiedMap) -> None:
    progress = found.progress
    for letter in "cd":
        boxes = merged(map_figure.squares(progress, letter))
        area = sum((b - a) * (d - c) for a, b, c, d in boxes)
        assert area == pytest.approx(float(progress.share(letter)))
    law = map_figure.work(progress)
    assert law[-1] == (progress.boxes, progress.undecided)
    assert all(a < b and u > v for (a, u), (b, v) in pairwise(law))
    a, b, c, d = map_figure.window(progress)
    decided = [*map_figure.squares(progress, "c"), *map_figure.squares(progress, "d")]
    inside = [(max(a, e), min(b, f), max(c, g), min(d, h)) for e, f, g, h in decided]
    covered = sum((f - e) * (h - g) for e, f, g, h in inside if e < f and g < h)
    assert 0 < covered < (b - a) * (d - c)


def test_the_curve_of_the_strip_lies_in_no_decided_box(found: CertifiedMap) -> None:
    """Two logs, made in different ways, agree on the border."""
    strip = read_strip(str(HERE), "map/strip/map.jsonl")
    plane = found.progress.plane
    assert map_figure.is_border_of(strip.plane, plane)
    decided = [*map_figure.squares(found.progress, "c"), *map_figure.squares(found.progress, "d")]
    points = list(map_figure.border(strip.plane))
    assert len(points) > 50
    for x, y in points:
        u = (x - float(plane.x[0])) / float(plane.x[1] - plane.x[0])
        v = (y - float(plane.y[0])) / float(plane.y[1] - plane.y[0])
        assert not any(a < u < b and c < v < d for a, b, c, d in decided)


def test_a_strip_with_an_open_tile_is_not_shown(tmp_path: Path) -> None:
    text = (HERE / "map" / "strip" / "map.jsonl").read_text(encoding="utf-8")
    for broken in (text.replace('"verdicts":"c', '"verdicts":"u'), text.splitlines()[0], "{}"):
        (tmp_path / "map.jsonl").write_text(broken)
        with pytest.raises(CertificateError):
            read_strip(str(tmp_path), "map.jsonl")


def test_a_strip_is_shown_only_if_its_checker_accepts_it(tmp_path: Path) -> None:
    """With other numbers, and digests that fit."""
    log = (HERE / "map" / "strip" / "map.jsonl").read_bytes()
    lines = [json.loads(line) for line in log.splitlines()]
    first = next(line for line in lines if line.get("numbers"))
    first["numbers"][0] = [0] * len(first["numbers"][0])
    (tmp_path / "map.jsonl").write_bytes(b"".join(sealed(lines)))
    with pytest.raises(CertificateError, match="does not accept"):
        read_strip(str(tmp_path), "map.jsonl")


def test_marks_are_short_and_lie_within() -> None:
    for low, high in (("0", "1/2"), ("1/8", "5/32"), ("-3/2", "0"), ("1/1000", "2/1000")):
        marks = round_marks(Fraction(low), Fraction(high))
        assert 3 <= len(marks) <= 6
        assert all(float(Fraction(low)) <= at <= float(Fraction(high)) for at, _ in marks)
        assert all(len(text) <= 6 and float(text) == at for at, text in marks)


# --- collapses -----------------------------------------------------------------------------------


def scene(name: str) -> Scene:
    path = HERE / "scenes" / f"{name}.toml"
    return scene_files.read_scene(str(path), path.read_bytes())


@pytest.fixture(scope="module", params=["nearly-aligned", "in-space"])
def shown(request: pytest.FixtureRequest) -> collapse.Film:
    made = story(scene(request.param))
    assert made is not None
    return collapse.film(made)


def test_only_a_collapse_has_a_story() -> None:
    assert story(scene("parting")) is None
    assert story(scene("on-a-line")) is None


def test_bounds_are_nested_and_after_each_collision(shown: collapse.Film) -> None:
    bounds = [one.collapse for one in shown.instants if one.collapse is not None]
    assert len(bounds) > 3
    for (a, b), (c, d) in pairwise(bounds):
        assert a < c < d < b
    assert all(one.time[1] < bounds[-1][1] for one in shown.instants)


def test_spheres_touch_where_they_collide(shown: collapse.Film) -> None:
    """At the end of each flight the pair that collides then is at the distance of two radii."""
    for k in range(len(shown.path) - 1):
        frame = collapse._frame(shown, k, 1.0)
        (other,) = {*map(int, shown.path[k + 1].pair)} - {shown.middle}
        assert math.hypot(*frame[other]) == pytest.approx(2 * collapse.RADIUS, abs=0.05)
        (third,) = frame.keys() - {other}
        assert math.hypot(*frame[third]) > 2 * collapse.RADIUS + 10


def test_an_animation_is_the_same_again_and_brings_no_script(shown: collapse.Film) -> None:
    text = collapse.animation(shown, "x")
    assert text == collapse.animation(shown, "x")
    assert "script" not in text
    assert text.count('opacity="0"') == len(shown.instants)  # one text stands still
    named = set(re.findall(r"@keyframes ([\w-]+)", text))
    assert named == set(re.findall(r"animation:([\w-]+)", text))
    assert {f' id="{name}"' in text for name in named} == {True}


# --- the drawing of the proof, statements, sentences ----------------------------------------------


def test_lines_that_are_left_out_follow_from_others() -> None:
    edges = edges_between_labels(pages.decide("all_parameters"))
    level = lowered(levels(edges), edges)
    kept = direct(edges, level)
    above: dict[str, set[str]] = {}
    for label in sorted(kept, key=lambda label: level[label]):
        above[label] = kept[label].union(*(above[source] for source in kept[label]))
    for label, sources in edges.items():
        down = {source for source in sources if level[source] < level[label]}
        assert down <= above[label]
    assert sum(map(len, kept.values())) < sum(map(len, edges.values())) / 2


def test_each_fact_is_below_what_it_rests_on_whatever_comes_first() -> None:
    edges = {"last": {"a", "b"}, "a": {"first"}, "b": {"a"}, "first": set(), "apart": set()}
    assert levels(edges) == {"last": 3, "a": 1, "b": 2, "first": 0, "apart": 0}
    circle = levels({"x": {"y"}, "y": {"x", "z"}, "z": set()})
    assert circle == {"x": 2, "y": 1, "z": 0}


def test_the_theorem_is_the_last_of_the_formulas_that_it_rests_on() -> None:
    outcome = pages.decide("all_parameters")
    edges = edges_between_labels(outcome)
    level = lowered(levels(edges), edges)
    last = outcome.rows[-1][0].label
    assert [label for label in level if level[label] >= level[last]] == [last]
    assert all(level[label] < level[last] for label in edges[last])
    for label in set().union(*edges.values()):
        assert any(label in edges[user] and level[user] == level[label] + 1 for user in edges)


def _folder_of(made: Path, folder: str) -> Outcome:
    contents = {
        sha256(path.read_bytes()).hexdigest(): path.read_bytes() for path in made.rglob("*.json")
    }
    files = ((made / folder / name).read_bytes() for name in NAMES)
    return read(*files, contents)


@pytest.mark.parametrize("folder", ["theorem1-all", "spectrum"])
def test_a_statement_that_says_less_is_not_the_program_s(made: Path, folder: str) -> None:
    outcome = _folder_of(made, folder)
    assert is_right_when_accepted(write(outcome)["statement.json"], outcome)
    rows = outcome.statement.obligations
    for some in (rows[:-1], rows[1:]):
        less = outcome._replace(statement=outcome.statement._replace(obligations=some))
        assert not is_right_when_accepted(write(less)["statement.json"], less)


def test_minus_signs_are_no_hyphens() -> None:
    assert prose("0 < -cos x, (-a) - b, |-c|") == "0 &lt; −cos x, (−a) − b, |−c|"
    assert prose("9-4√5, (1-h₅/4)") == "9−4√5, (1−h₅/4)"
    assert prose("Cauchy-Schwarz, 0-1, verify map --out") == "Cauchy-Schwarz, 0-1, verify map --out"
