"""A map as a table, and the scenes in the middle of its boxes, in the table and in pictures."""

from __future__ import annotations

import csv
import json
import re
from collections import Counter
from fractions import Fraction
from itertools import pairwise
from pathlib import Path
from xml.etree import ElementTree

import pytest

from verify.cli import main
from verify.cli.map_boxes import with_unit
from verify.spheres.map.grow import Target, grow
from verify.spheres.map.log import Progress
from verify.spheres.map.middles import Box, Middle, boxes
from verify.spheres.map.planes import Phi
from verify.spheres.map.workers import workers
from verify.views.plots.map_colours import (
    BALLS,
    COLOURINGS,
    RAMP,
    Ramp,
    between,
    coloured,
    widths_lines,
)
from verify.views.plots.map_picture import COLOURS
from verify.views.plots.shapes import axis_of

SCENES = """r = "0.04..0.07"
diameter = "0.5"
positions = [[0, 0], ["0.505", 0], ["-0.51", "h"]]
velocities = [[0, 0], [-1, "0.1"], [1, 0]]
length_unit = "mm"
time_unit = "ms"
parameters = {h = "0..0.3"}
"""
LETTERS = {
    "collapses": {"collapses"},
    "disperses": {"disperses"},
    "finite": {"finite", "disperses"},
}


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A map with its table and its pictures."""
    place = tmp_path_factory.mktemp("middles")
    (place / "scenes.toml").write_text(SCENES, encoding="utf-8")
    command = ["map", str(place / "scenes.toml"), "--x", "r", "--y", "h", "--boxes", "400"]
    more = ["--middles", "--csv", str(place / "map.csv"), "--out", str(place / "out")]
    assert main([*command, *more]) in (0, 3)
    return place


def rows_of(path: Path) -> list[dict[str, str]]:
    """The lines of a table."""
    with path.open(encoding="utf-8") as file:
        return [*csv.DictReader(file)]


def area(row: dict[str, str]) -> Fraction:
    """The area of a box."""
    sides = (Fraction(row[f"{name}_high"]) - Fraction(row[f"{name}_low"]) for name in ("r", "h"))
    a, b = sides
    return a * b


def test_the_boxes_of_the_table_are_the_areas_of_the_map(folder: Path) -> None:
    shares: Counter[str] = Counter()
    whole = Fraction("0.03") * Fraction("0.3")
    for row in rows_of(folder / "map.csv"):
        shares[row["verdict"]] += area(row) / whole  # type: ignore[assignment]
    document = json.loads((folder / "out" / "map.json").read_text(encoding="utf-8"))
    told = {name: Fraction(share) for name, share in document["areas"].items() if share != "0"}
    assert dict(shares) == told
    assert sum(shares.values()) == 1


def test_the_middle_of_a_box_has_its_verdict(folder: Path) -> None:
    seen = set()
    for row in rows_of(folder / "map.csv"):
        seen.add((row["verdict"], row["middle_verdict"]))
        assert row["middle_verdict"] in LETTERS.get(row["verdict"], row["middle_verdict"])
        assert (
            bool(row["time_low"]) == (row["middle_verdict"] == "collapses") == bool(row["central"])
        )
    assert {("collapses", "collapses"), ("disperses", "disperses")} <= seen
    assert {one for one, _ in seen} >= {"undecided"}


def test_times_of_middles_are_narrower_than_any_colour(folder: Path) -> None:
    ends = [
        (Fraction(row["time_low"]), Fraction(row["time_high"]))
        for row in rows_of(folder / "map.csv")
        if row["time_low"]
    ]
    assert len(ends) > 10
    assert all(high - low < low / 10**5 for low, high in ends)


def test_boxes_fill_the_plane_wherever_a_map_was_left() -> None:
    progress = Progress(Phi(Fraction(3, 100), Fraction(1)))
    with workers(1, None) as staff:
        for _ in grow(progress, Target(Fraction(0), 1, 20), staff, lambda _: None):
            found = list(boxes(progress))
            x = [(a.x[1] - a.x[0]) * (a.y[1] - a.y[0]) for a in found if a.y is not None]
            assert sum(x) == Fraction(1, 8)
            assert sum(box.letter == "u" for box in found) > 0
    assert len(list(boxes(Progress(Phi(Fraction(3, 100), Fraction(1)))))) == 64


@pytest.mark.parametrize("name", [one.name for one in COLOURINGS])
def test_each_picture_has_a_key_and_its_units(folder: Path, name: str) -> None:
    text = (folder / "out" / f"map-{name}.svg").read_text(encoding="utf-8")
    ElementTree.fromstring(text)
    assert "undecided</text>" in text
    assert ("ball 2</text>" in text) == (name == "central")
    assert (">time (ms)</text>" in text) == (name == "time")
    assert len({part.split('"')[0] for part in text.split('fill="#')}) > 3


def test_axes_that_are_places_have_the_units_of_the_file(tmp_path: Path) -> None:
    scene = tmp_path / "one.toml"
    scene.write_text(SCENES.replace('"h"', "0.05").replace('"0.04..0.07"', "0.03")
                     .partition("parameters")[0], encoding="utf-8")  # fmt: skip
    axes = ["--x", "positions[2][1]=0..0.1", "--y", "velocities[2][1]=0..0.2"]
    out = ["--middles", "--boxes", "64", "--out", str(tmp_path / "out")]
    assert main(["map", str(scene), *axes, *out]) in (0, 3)
    text = (tmp_path / "out" / "map-time.svg").read_text(encoding="utf-8")
    assert "positions[2][1] (mm)</text>" in text
    assert "velocities[2][1] (mm/ms)</text>" in text


def test_pictures_have_title_and_units_of_the_file_and_round_marks(tmp_path: Path) -> None:
    """A parameter has a unit where it is added to places alone."""
    scenes = tmp_path / "scenes.toml"
    scenes.write_text(f'title = "Three beads, h varies"\n{SCENES}', encoding="utf-8")
    command = ["map", str(scenes), "--x", "r=0.04..0.07", "--y", "h=0.013..0.3", "--boxes", "64"]
    assert main([*command, "--middles", "--out", str(tmp_path / "out")]) in (0, 3)
    pictures = sorted((tmp_path / "out").glob("*.svg"))
    assert len(pictures) == 4
    for picture in pictures:
        text = picture.read_text(encoding="utf-8")
        assert "Three beads, h varies</text>" in text
        assert "h (mm)</text>" in text
        assert ">0.05</text>" in text
        assert "0.08475" not in text
    table = {"positions": [["h", "k/2"]], "velocities": [["v - 1", "k"]], "r": "r"}
    table |= {"length_unit": "mm", "time_unit": "ms"}
    names = [with_unit(name, table) for name in ("h", "k", "v", "r", "")]
    assert names == ["h (mm)", "k", "v (mm/ms)", "r", ""]


def test_pictures_say_what_is_the_same_in_all_of_them(tmp_path: Path) -> None:
    """And a title of 80 letters has room."""
    scenes, title = tmp_path / "scenes.toml", ("nine long words, and one more " * 3)[:80]
    scenes.write_text(f'title = "{title}"\n{SCENES}', encoding="utf-8")
    command = ["map", str(scenes), "--x", "h", "--at", "r=1/20", "--boxes", "16", "--middles"]
    assert main([*command, "--out", str(tmp_path / "out")]) in (0, 3)
    for picture in (tmp_path / "out").glob("*.svg"):
        root = ElementTree.parse(picture).getroot()
        width = float(root.attrib["viewBox"].split()[2])
        texts = root.iterfind(".//{*}text")
        lines = [text.text or "" for text in texts if float(text.get("x", 0)) == 8]
        assert "r = 0.05" in lines
        assert " ".join(lines).startswith(title)
        letter = 0.55 * float(root.attrib["font-size"])
        assert max(map(len, lines)) * letter + 8 < width


def test_marks_of_tiny_and_of_huge_intervals_are_short() -> None:
    """The label of the axis then says what they stand for."""
    found = axis_of("h (mm)", Fraction(1, 10), Fraction(1, 10) + Fraction(3, 10**10))
    assert found[0] == "h (mm) = 0.1 + mark × 10⁻¹⁰"
    assert [text for _, text in found[1]] == ["0", "0.5", "1", "1.5", "2", "2.5", "3"]
    assert [share for share, _ in found[1]] == pytest.approx([k / 6 for k in range(7)])
    name, marks = axis_of("w", Fraction(-(10**7)), Fraction(10**7))
    assert (name, [text for _, text in marks]) == (
        "w = mark × 10⁷",
        ["-1", "-0.5", "0", "0.5", "1"],
    )
    assert axis_of("r", Fraction("0.04"), Fraction("0.07"))[0] == "r"


def test_numbers_of_collisions_are_whole_and_white_has_one_meaning(folder: Path) -> None:
    text = (folder / "out" / "map-collisions.svg").read_text(encoding="utf-8")
    bar = re.findall(r'x="520"[^>]*>([^<]+)</text>', text)
    assert len(bar) > 2
    assert all(number.isdigit() for number in bar)
    assert {number.rstrip("0") for number in bar} <= {"1", "2", "5"}
    for says, pattern in (
        ("infinitely many", "#fff"),
        ("finitely many, not counted", "url(#some)"),
        ("undecided", "url(#open)"),
    ):
        assert re.search(rf'fill="{re.escape(pattern)}" [^>]*/>\n<text [^>]*>{says}<', text)


def test_an_interval_of_scenes_is_a_table_too(tmp_path: Path) -> None:
    path, scenes = tmp_path / "map.csv", tmp_path / "scenes.toml"
    scenes.write_text(SCENES, encoding="utf-8")
    command = ["map", str(scenes), "--x", "r", "--at", "h=0.05", "--boxes", "40"]
    assert main([*command, "--csv", str(path)]) in (0, 3)
    rows = rows_of(path)
    assert [*rows[0]] == ["verdict", "r_low", "r_high"]
    ends = [(Fraction(row["r_low"]), Fraction(row["r_high"])) for row in rows]
    assert sorted(ends)[0][0] == Fraction("0.04")
    assert sum(high - low for low, high in ends) == Fraction("0.03")


def test_colours_get_lighter_so_that_they_are_told_apart_in_grey() -> None:
    def grey(colour: str) -> float:
        red, green, blue = bytes.fromhex(colour[1:])
        return 0.299 * red + 0.587 * green + 0.114 * blue

    greys = [grey(between(k / 40)) for k in range(41)]
    assert greys == sorted(greys)
    assert between(0) == RAMP[0]
    assert between(1) == RAMP[-1]
    assert min(b - a for a, b in pairwise(greys)) > 1
    assert [grey(colour) for colour in BALLS] == sorted(grey(colour) for colour in BALLS)
    assert grey(BALLS[2]) < 235, "lighter would be taken for white"
    areas = sorted(grey(colour) for colour in COLOURS.values())
    assert min(b - a for a, b in pairwise(areas)) > 40


@pytest.mark.parametrize("values", [[2.0, 5.0], [0.001, 70.0], [3.0], []])
def test_a_ramp_goes_from_the_least_to_the_largest(values: list[float]) -> None:
    ramp = Ramp(values)
    for value in values:
        assert 0 <= ramp.share(value) <= 1
    if len(values) > 1:
        assert [ramp.share(value) for value in values] == [0, 1]
        marks = ramp.marks()
        assert 4 <= len(marks) <= 12
        assert all(values[0] <= float(text) == at <= values[1] for at, text in marks)
        assert all(len(text.replace(".", "").strip("0")) <= 2 for _, text in marks)


def test_a_picture_says_how_wide_the_enclosures_of_its_times_are(folder: Path) -> None:
    text = (folder / "out" / "map-time.svg").read_text(encoding="utf-8")
    ends = [
        (Fraction(row["time_low"]), Fraction(row["time_high"]))
        for row in rows_of(folder / "map.csv")
        if row["time_low"]
    ]
    told = re.search(r"which is at most ([\d.]+)·10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+) ms wide;", text)
    assert told is not None
    power = told[2].translate(str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789"))
    widest = Fraction(told[1]) * Fraction(10) ** int(power)
    assert max(high - low for low, high in ends) / 2 < widest < ends[0][0] / 10**5
    assert f">0 of the {len(ends)} enclosures are wider than 1/64 of the bar" in text
    ramp, half = Ramp([1.0, 2.0]), Fraction(1, 130)
    wide = [(1 - half, 1 + half), (2 - half, 2 + 2 * half)]
    lines = widths_lines(ramp, wide, "")
    assert "is at most 0.024 wide;" in lines[0]
    assert lines[1].startswith("1 of the 2 enclosures are wider")
    assert widths_lines(ramp, [], "") == ()


def test_one_value_has_no_bar_and_no_value_nothing() -> None:
    sides = Fraction(0), Fraction(1)
    box = Box("d", sides, sides)
    none = Middle("finite", "restitution", None, 5, None)
    for known, told in ((Middle("disperses", "apart", None, 7, None), True), (none, False)):
        text = coloured(COLOURINGS[1], [("x", *sides), ("y", *sides)], [(box, known)], [], "")
        assert (">7</text>" in text) == told
        assert (">collisions</text>" in text) == told
        assert text.count("<rect") == 1 + 1 + 3 + told  # the box, its frame, and the keys


@pytest.mark.parametrize(
    ("more", "words"),
    [
        (
            ["phi", "--r", "0.03", "--middles", "--csv", "x"],
            "--middles: is for the file of a scene",
        ),
        (["phi", "--r", "0.03", "--strip", "1e-6", "--csv", "x"], "--csv: the tiles of a strip"),
        (
            ["certificates/scenes/on-a-line.toml", "--x", "r=0.01..0.02", "--middles"],
            "--middles: add",
        ),
    ],
)
def test_what_cannot_be_written_is_refused(
    more: list[str], words: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["map", *more]) == 2
    error = capsys.readouterr().err
    assert words in error
    assert error.count("\n") == 1


def _files(place: Path, folder: Path, *more: str) -> dict[str, bytes]:
    """All files of the same map, made anew, except for its times."""
    scenes = str(folder / "scenes.toml")
    command = ["map", scenes, "--x", "r", "--y", "h", "--boxes", "400", "--middles"]
    assert main(
        [*command, "--csv", str(place / "map.csv"), "--out", str(place / "out"), *more]
    ) in (
        0,
        3,
    )
    return _bytes_below(place)


def _bytes_below(place: Path) -> dict[str, bytes]:
    paths = (place / "map.csv", *(place / "out").iterdir())
    return {path.name: path.read_bytes() for path in paths if path.name != "times.csv"}


def test_two_processes_write_the_same_pictures(folder: Path, tmp_path: Path) -> None:
    found = _files(tmp_path, folder, "--jobs", "2")
    assert {"map.jsonl", "map.svg", "map.png", "map-time.svg", "map.csv"} <= found.keys()
    assert found == _bytes_below(folder)


def test_dask_writes_the_same_pictures(folder: Path, tmp_path: Path) -> None:
    distributed = pytest.importorskip("distributed")
    with distributed.LocalCluster(
        n_workers=2, threads_per_worker=1, processes=False, dashboard_address=None
    ) as cluster:
        found = _files(tmp_path, folder, "--dask", cluster.scheduler_address)
    assert found == _bytes_below(folder)


@pytest.mark.parametrize(
    ("axis", "term", "share"),
    [
        ("r=-1..1", "-3, 1", Fraction(1, 2)),  # r is no coefficient of restitution
        ("r=0..2", "-3, 1", Fraction(1, 2)),
        ("r=2..3", "-3, 1", Fraction(1)),
        ("h=-1..15", '-3, "1/h"', Fraction(1, 8)),  # a term divides by zero
        ("h=-4..4", '"h", 0', Fraction(1, 4)),  # particles overlap
    ],
)
def test_a_middle_may_be_no_scene(axis: str, term: str, share: Fraction, tmp_path: Path) -> None:
    path, table = tmp_path / "f.toml", tmp_path / "map.csv"
    path.write_text(
        f'r = "3/100"\npositions = [[0, 0], [11, 0], [{term}]]\n'
        'velocities = [[0, 0], [-1, 0], [1, "h"]]\nparameters = { h = "-8..16" }\n'
    )
    fixed = ["--at", "h=1"] if axis[0] == "r" else []
    words = ["map", str(path), "--x", axis, *fixed, "--level", "3", "--boxes", "1", "--middles"]
    assert main([*words, "--csv", str(table), "--out", str(tmp_path / "out")]) in (0, 3)
    rows = rows_of(table)
    assert [row["middle_reason"] for row in rows].count("no-scene") == share * len(rows)
