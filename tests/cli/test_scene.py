"""The command `scene` as people and scripts see it."""

from __future__ import annotations

import csv
import json
import math
import re
import subprocess
import sys
from collections import Counter
from collections.abc import Callable
from fractions import Fraction
from itertools import pairwise
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import jsonschema
import pytest

from tests.cli.running import check_refused, command, parsed, validator
from verify import check
from verify.cli import scene_folder
from verify.cli.scene_folder import decide_file
from verify.cli.unfinished import NAME
from verify.views.plots import distributions
from verify.views.plots.approach import counted

ROOT = Path(__file__).resolve().parents[2]
SCENES = ROOT / "certificates" / "scenes"
VALID = validator("scene")
GOOD = """r = 0.03
positions = [[0, 0], ["501/500", 0], [-1.006, 8e-2]]
velocities = [[0, 0], [-1.4, 0], ["7/10", "-0.1"]]
"""


run = command("scene")


def written(folder: Path, text: str) -> Path:
    path = folder / "scene.toml"
    path.write_text(text)
    return path


@pytest.mark.parametrize("path", sorted(SCENES.glob("*.toml")), ids=lambda path: path.stem)
def test_the_examples(path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    code, out, err = run(capsys, path, "--json")
    assert err == ""
    document = parsed(out)
    VALID.validate(document)
    behaviour = path.read_text().split(maxsplit=2)[1].strip(":,").lower()
    assert document["verdict"] == behaviour
    assert code == (3 if behaviour == "undecided" else 0)
    is_equal = "masses" not in path.read_text()
    collapse = "sharper" if is_equal else "three-balls"
    last = {"collapses": [collapse], "finite": ["classification"], "disperses": []}.get(behaviour)
    flow = "flow" if is_equal else "flow-of-balls"
    assert document["cites"] == ([] if last is None else [flow, *last])
    assert document["judged_by"] == (None if last is None else "FLINT at a point")


def test_a_cutoff(capsys: pytest.CaptureFixture[str]) -> None:
    code, out, err = run(capsys, SCENES / "bead.toml", "--cutoff", "1e-10", "--json")
    document = json.loads(out)
    assert (code, err, document["cutoff"]["time"]) == (0, "", "1/10000000000")
    VALID.validate(document)
    assert (
        str(document["cutoff"]["collisions"][1])
        in run(capsys, SCENES / "bead.toml", "--cutoff", "1e-10")[1]
    )
    assert "no collapse" in run(capsys, SCENES / "passing.toml", "--cutoff", "1")[1]
    for words in (["--cutoff", "0"], ["--cutoff", "x"]):
        assert run(capsys, SCENES / "bead.toml", *words)[0] == 2
    assert run(capsys, SCENES, "--cutoff", "1")[0] == 2


def test_numbers_are_read_exactly(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    code, out, _ = run(capsys, written(tmp_path, GOOD))
    assert (code, out) == run(capsys, SCENES / "nearly-aligned.toml")[:2]


def test_lengths_may_be_in_a_unit_of_their_own(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    text = """r = 0.03
diameter = "0.02"
positions = [[0, 0], ["0.02004", 0], [-0.02012, "0.0016"]]
velocities = [[0, 0], [-0.028, 0], ["0.014", "-0.002"]]
"""
    assert run(capsys, written(tmp_path, text)) == run(capsys, SCENES / "nearly-aligned.toml")
    assert run(capsys, written(tmp_path, text.replace("0.02004", "0.019")))[0] == 2


BAD = {
    "overlap": (GOOD.replace("501/500", "1/2"), "0 and 1 overlap by about 0.5: their distance"),
    "overlap-of-1e-74": (GOOD.replace("501/500", "0." + "9" * 74), "overlap by about 1E-74"),
    "overlap-of-2": (GOOD.replace("-1.006", "0.2"), "0 and 2 overlap by about 0.785:"),
    "r": (GOOD.replace("0.03", "1.5"), "r: '3/2' is not in (0, 1]"),
    "no-number": (
        GOOD.replace("-1.006", '"one"'),
        "positions of particle 2: 'one' is not an exact",
    ),
    "infinite": (GOOD.replace("-1.006", "inf"), "'inf' is not an exact number"),
    "a-truth": (GOOD.replace("-1.006", "true"), "'True' is not a number"),
    "two-particles": (GOOD.replace(', ["501/500", 0]', ""), "positions: write three lists"),
    "dimensions": (
        GOOD.replace("8e-2", "8e-2, 1").replace('"-0.1"', "0, 0, 0"),
        "coordinates: the position of particle 2 has 3, the velocity of particle 2 has 4; write 2 ",
    ),
    "two-dimensions": (
        "r = 0.1\npositions = [[0], [2], [4]]\nvelocities = [[0, 0], [2, 0], [4, 0]]\n",
        "the position of particle 2 has 1, the velocity of particle 0 has 2, the velocity",
    ),
    "no-dimension": (
        "r = 0.1\npositions = [[], [], []]\nvelocities = [[], [], []]\n",
        "the vectors have 0 coordinates",
    ),
    "missing": ("r = 0.1\n", "'positions' is missing"),
    "unknown": (GOOD + "mass = 2\n", "'mass' is not known (do you mean masses?)"),
    "unknown-e": (GOOD.replace("r =", "e ="), "'e' is not known (do you mean r?)"),
    "unlike-any": (GOOD + "xyz = 2\n", "'xyz' is not known; a parameter"),
    "comma": (GOOD.replace("0.03", "0,05"), "; write r = 0.05"),
    "comma-in-a-list": (GOOD.replace("-1.006", "-1,006"), "-1.006"),
    "no-quotes": (GOOD + "time_unit = s\n", '; write time_unit = "s"'),
    "unit": (GOOD + "diameter = 0.02m # x\n", "; write diameter = 0.02"),
    "interval": (GOOD.replace("0.03", "0.01..0.09"), '; write r = "0.01..0.09"'),
    "parameter": (GOOD.replace("-1.006", "h"), '"h"'),
    "term": (GOOD.replace("-1.006", "1, -2*h"), '"-2*h"'),
    "not-odd": (GOOD.replace("-1.006", "1e1") + "[a] x\n", "; write r, positions, velocities"),
    "family": (GOOD.replace("0.03", '"0.01..0.09"'), "is a family of scenes; add --sample N, or "),
    "walls": (GOOD + "walls = 2\n", "walls: write walls = [{normal = [0, 1], level = 0, "),
    "gravity": (GOOD + "gravity = 9.81\n", "gravity: write a number for each coordinate"),
    "friction": (GOOD + "friction = 1\n", "'friction' is not part of the model: smooth spheres"),
    "rotation": (GOOD + "rotation = [0, 1, 0]\n", "'rotation' is not part of the model"),
    "metres": (
        GOOD.replace("501/500", "1/2"),
        "has to be at least 1, in diameters; if your lengths are in metres, write diameter = 0.02",
    ),
    "percent": (GOOD.replace("0.03", "5%"), "; write r = 0.05"),
    "percent-text": (
        GOOD.replace("0.03", '"2.5 %"'),
        "'2.5 %' is not an exact number; write 0.025",
    ),
    "a-unit": (
        GOOD.replace("-1.006", '"2 cm"'),
        "positions of particle 2: '2 cm' has a unit; write 2: all lengths are in one unit",
    ),
    "speed": (
        GOOD.replace("-1.4", '"-1.4 m/s"'),
        "'-1.4 m/s' has a unit; write -1.4: all lengths are in one unit",
    ),
    "diameter-unit": (
        GOOD + 'diameter = "2mm"\n',
        "'2mm' has a unit; write 2: all lengths are in one unit",
    ),
    "radii-unit": (
        GOOD + 'radii = ["1 m", 1, 1]\n',
        "'1 m' has a unit; write 1: all lengths are in one unit",
    ),
    "mass-unit": (
        GOOD + 'masses = ["1 kg", 1, 1]\n',
        "'1 kg' has a unit; write 1: all lengths are in one unit",
    ),
    "angle": (GOOD.replace("-1.006", '"-1.5*cos(30°)"'), "write coordinates, not angles"),
    "diameter": (GOOD + 'diameter = "0"\n', "diameter: '0' is not positive"),
    "no-toml": ("r = = 1\n", "is not valid TOML"),
    "twice": (GOOD + "r = 0.04\n", "a name stands there twice"),
    "twice-inside": (GOOD + "[parameters]\nh = {a = 1, a = 2}\n", "a key stands there twice"),
    "like-another": (GOOD + '"r\u0301" = 0.04\n', "do you mean r?"),
    "wide": (GOOD + '"\uff52" = 0.04\n', "'\uff52' is not known"),
    "grouped": (GOOD.replace("-1.006", '"-1_006"'), "'-1_006' is not an exact number"),
    "hexadecimal": (GOOD.replace("-1.006", '"0x10"'), "'0x10' is not an exact number"),
    "true": (GOOD.replace("-1.006", "true"), "'True' is not a number"),
    "date": (GOOD.replace("-1.006", "1979-05-27"), "'1979-05-27' is not a number"),
    "nested": (GOOD.replace("-1.006", "[-1.006]"), "is not a number"),
    "remark": (GOOD.replace("-1.006", '"-1.006 # left"'), "is not an exact number"),
    "large": (GOOD.replace("0.03", "1e-99999"), "the exponent of '1e-99999' is too large"),
}


@pytest.mark.parametrize("name", BAD)
def test_unusable_input_is_one_line(
    name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    text, why = BAD[name]
    check_refused(run(capsys, written(tmp_path, text)), why)


@pytest.mark.parametrize(
    "words",
    [
        ["no-such-file.toml"],
        [SCENES / "tie.toml", "--digits", "0"],
        [SCENES / "tie.toml", "--jobs", "2"],
        [SCENES / "tie.toml", "--plot", "scene.png"],
        [SCENES / "tie.toml", "--precision", "256", "--max-precision", "128"],
        [SCENES, "--plot", "scene.svg"],
        [ROOT / "verify"],
    ],
)
def test_unusable_options(words: list[object], capsys: pytest.CaptureFixture[str]) -> None:
    check_refused(run(capsys, *words))


EXTREME = """r = "0.03"
positions = [["0", "0"], ["PLACE", "0"], ["-1.006", "0.08"]]
velocities = [["0", "0"], ["-1.4SCALE", "0"], ["0.7SCALE", "-0.1SCALE"]]
"""


@pytest.mark.parametrize("kind", ["svg", "html"])
def test_numbers_beyond_a_drawing_are_one_line(
    kind: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "fast.toml"
    path.write_text(EXTREME.replace("PLACE", "1.002").replace("SCALE", "e320"))
    check_refused(run(capsys, path, "--plot", tmp_path / f"scene.{kind}"))
    assert run(capsys, path)[0] == 0


@pytest.mark.parametrize("place", ["1e200", "1e1000"])
def test_a_particle_far_away_is_no_trouble(
    place: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "far.toml"
    path.write_text(EXTREME.replace("PLACE", place).replace("SCALE", "e0"))
    assert run(capsys, path)[0] in (0, 3)


def test_a_table_leaves_open_what_nobody_could_read(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Where all collisions are one on a ray for ever, ζ is a quotient of numbers near 0."""
    path = tmp_path / "ray.toml"
    path.write_text(
        'r = "4/95"\npositions = [[0, 0], [1, 0], [-2, 0]]\n'
        'velocities = [[0, 0], ["8/19", 0], [1, 0]]\n'
    )
    code, out, _ = run(capsys, path, "--collisions", "300", "-v")
    assert code == 3
    assert "  ?" in out


def test_the_table_has_a_line_for_each_collision(capsys: pytest.CaptureFixture[str]) -> None:
    _, out, _ = run(capsys, SCENES / "nearly-aligned.toml", "--digits", "3", "-v")
    lines = out.splitlines()
    heads = ["n", "pair", "time", "since", "speed", "η", "ζ", "q", "-cos", "θ"]
    assert lines[0].split() == heads
    pairs = [line.split()[1] for line in lines[1:] if line[:1].isdigit()]
    assert pairs == ["01", "02"] * (len(pairs) // 2) + ["01"] * (len(pairs) % 2)


def test_the_columns_of_the_table_never_run_together(capsys: pytest.CaptureFixture[str]) -> None:
    _, out, _ = run(capsys, SCENES / "nearly-aligned.toml", "--digits", "12", "-v")
    lines = [line for line in out.splitlines() if line[:1].isdigit()]
    assert len(lines) > 10
    assert {len(line.split()) for line in lines} == {9}


def test_the_time_between_two_collisions_is_seen_near_a_collapse(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    text = (SCENES / "in-space.toml").read_text()
    path = written(tmp_path, f'time_unit = "ms"\n{text}')
    _, out, _ = run(capsys, path, "--digits", "12", "-v")
    rows = [line.split() for line in out.splitlines() if line[:1].isdigit()]
    assert out.startswith("n  pair time (ms) since ")
    assert (rows[-1][2], rows[-2][2]) == ("0.3157…", "0.3157…")
    assert (rows[0][3], rows[-1][3]) == (rows[0][2], "5.971…·10⁻¹³")


def test_a_certificate_is_accepted(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    code, out, err = run(capsys, SCENES / "parting.toml", "--out", tmp_path / "out")
    assert (code, err) == (0, "")
    assert out.endswith("given certificates/flow; judged by the checker\n")
    code, lines = check.check_folders(check.read_folders([str(tmp_path / "out")]))
    assert code == 0
    assert lines[-1].startswith("PROVED: disperses: after 4 collisions")


def test_nothing_is_written_where_it_is_undecided(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    code, _, err = run(capsys, SCENES / "tie.toml", "--out", tmp_path / "out")
    assert code == 3
    assert "no certificate was written" in err
    assert not (tmp_path / "out").exists()


def folder(tmp_path: Path) -> Path:
    made = tmp_path / "scenes"
    made.mkdir()
    for name in ("nearly-aligned", "passing", "tie"):
        (made / f"{name}.toml").write_bytes((SCENES / f"{name}.toml").read_bytes())
    return made


def test_a_folder_gives_the_same_with_more_processes(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    made = folder(tmp_path)
    alone = run(capsys, made)
    assert alone == run(capsys, made, "--jobs", 2)
    code, out, _ = alone
    assert code == 3
    assert [line.split(":")[0] for line in out.splitlines()] == [
        "nearly-aligned.toml", "passing.toml", "tie.toml",
    ]  # fmt: skip
    (made / "hard.toml").write_text(GOOD.replace("0.03", "0.0558"))
    assert run(capsys, made, "--collisions", 0)[0] == 3
    (made / "hard.toml").unlink()
    (made / "bad.toml").write_text(BAD["overlap"][0])
    code, out, _ = run(capsys, made, "--json")
    document: dict[str, Any] = json.loads(out)
    assert code == 2
    VALID.validate(document)
    verdicts = [item["verdict"] for item in document["scenes"]]
    assert verdicts == ["unusable", "collapses", "disperses", "undecided"]


def test_a_folder_is_decided_anew(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """What was written before is not believed."""
    made, out = folder(tmp_path), tmp_path / "out"
    first = run(capsys, made, "--out", out)
    assert (out / "passing" / "certificate.json").exists()
    assert not (out / "tie" / "certificate.json").exists()
    result = out / "passing" / "scene.json"
    honest = result.read_text()
    result.write_text(honest.replace("disperses", "collapses"))
    assert run(capsys, made, "--out", out) == first
    assert result.read_text() == honest
    (made / "passing.toml").write_text(GOOD)
    assert "passing.toml: collapses" in run(capsys, made, "--out", out)[1]


def all_bytes(folder: Path) -> dict[str, bytes]:
    return {str(p.relative_to(folder)): p.read_bytes() for p in folder.rglob("*") if p.is_file()}


class Interrupted:
    """Decides so many scenes, and is interrupted then."""

    def __init__(self, count: int) -> None:
        self.names, self._count = list[str](), count

    def __call__(self, *words: Any) -> dict[str, Any]:
        if len(self.names) == self._count:
            raise KeyboardInterrupt
        self.names.append(words[-1])
        return decide_file(*words)


def go_on(
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
    *more: object,
    between: Callable[[Path, Path], object] = lambda _, __: None,
) -> list[str]:
    """What a run decides after one that ended after two of four scenes; its files are right."""
    made, out, table = folder(tmp_path), tmp_path / "out", tmp_path / "t.csv"
    (made / "bad.toml").write_text(BAD["overlap"][0])
    words = (made, "--csv", table)
    monkeypatch.setattr(scene_folder, "decide_file", Interrupted(3))
    assert run(capsys, *words, "--out", out)[0] == 130
    assert not table.exists()
    assert {path.name for path in out.iterdir()} == {"nearly-aligned", "passing", NAME}
    between(made, out)
    monkeypatch.setattr(scene_folder, "decide_file", again := Interrupted(9))
    found = run(capsys, *words, "--out", out, *more)
    monkeypatch.undo()
    rows, files = table.read_text(), all_bytes(out)
    assert found[:2] == run(capsys, *words, "--out", tmp_path / "whole", *more)[:2]
    assert (rows, files) == (table.read_text(), all_bytes(tmp_path / "whole"))
    return again.names


def test_an_interrupted_folder_goes_on(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    assert go_on(tmp_path, capsys, monkeypatch) == ["bad.toml", "tie.toml"]


def test_an_interrupted_folder_goes_on_in_json(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    assert go_on(tmp_path, capsys, monkeypatch, "--json") == ["bad.toml", "tie.toml"]


def test_other_limits_begin_anew(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    assert len(go_on(tmp_path, capsys, monkeypatch, "--digits", 9)) == 4


NO_FILE = {key: ["x"] for key in ("file", "code", "lines", "document", "row")}


def line_of(result: object) -> str:
    return json.dumps({"scene": "", "limits": [], "written": "", "result": result})


CHANGES: dict[str, Callable[[Path, Path], object]] = {
    "another scene": lambda made, _: (made / "passing.toml").write_text(GOOD),
    "another result": lambda _, out: (out / "passing" / "scene.json").write_text("{}"),
    "a certificate that is gone": lambda _, out: (out / "passing" / "certificate.json").unlink(),
    "another one cited": lambda _, out: [p.write_text("{}") for p in out.glob("passing/cited/*")],
    "half a line": lambda _, out: (out / NAME).write_bytes((out / NAME).read_bytes()[:-9]),
    "no line": lambda _, out: (out / NAME).write_text("[]\n{}\n7\nx"),
    "no file": lambda _, out: (out / NAME).write_text(f"{line_of('x')}\n{line_of(NO_FILE)}\n"),
}


@pytest.mark.parametrize("change", CHANGES)
def test_what_is_not_whole_is_decided_anew(
    change: str,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    again = go_on(tmp_path, capsys, monkeypatch, between=CHANGES[change])
    kept = [] if change in ("no line", "no file") else ["nearly-aligned.toml"]
    every = ["bad.toml", "nearly-aligned.toml", "passing.toml", "tie.toml"]
    assert again == [name for name in every if name not in kept]


def test_a_name_that_is_no_text(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """It is shown with a backslash in all files, and kept as well."""
    made, out, table = tmp_path / "made", tmp_path / "out", tmp_path / "t.csv"
    made.mkdir()
    for name in ("a\udcff.toml", "b.toml"):
        (made / name).write_text(GOOD)
    monkeypatch.setattr(scene_folder, "decide_file", Interrupted(1))
    assert run(capsys, made, "--out", out)[0] == 130
    monkeypatch.setattr(scene_folder, "decide_file", again := Interrupted(9))
    assert run(capsys, made, "--out", out, "--csv", table)[0] == 0
    assert again.names == ["b.toml"]
    assert [line.partition(",")[0] for line in table.read_text().splitlines()] == [
        "file", "a\\udcff.toml", "b.toml",
    ]  # fmt: skip
    (found,) = (path for path in out.glob("a*/scene.json"))
    assert json.loads(found.read_text())["file"] == "a\udcff.toml"


def test_a_file_among_certificates_that_has_no_text_as_its_name(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    made, out = tmp_path / "made", tmp_path / "out"
    made.mkdir()
    (made / "b.toml").write_text(GOOD)
    assert run(capsys, made, "--out", out)[0] == 0
    (out / "b" / "\udcff").touch()
    assert run(capsys, made, "--out", out)[0] in (0, 2)  # 2 if the folder has to be written anew


def test_the_drawing_is_whole(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for name in ("nearly-aligned", "in-space", "passing", "tie"):
        code, _, _ = run(capsys, SCENES / f"{name}.toml", "--plot", tmp_path / "scene.svg")
        assert code == (3 if name == "tie" else 0)
        root = ElementTree.parse(tmp_path / "scene.svg").getroot()
        circles = [item for item in root.iter() if item.tag.endswith("ellipse")]
        assert len(circles) == 6  # at the start and at the end
        text = (tmp_path / "scene.svg").read_text()
        assert "nan" not in text


ON_A_LINE = """
r = "0.04"
diameter = "0.02"
positions = [["0"], ["0.025"], ["-0.024"]]
velocities = [["0"], ["-0.3"], ["0.2"]]
"""


@pytest.mark.parametrize("kind", ["svg", "html"])
def test_a_scene_on_a_line_is_drawn(
    kind: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "line.toml"
    path.write_text(ON_A_LINE)
    code, out, err = run(capsys, path, "--plot", tmp_path / f"line.{kind}")
    assert (code, err) == (0, "")
    assert "collapses" in out
    assert "collapses" in (tmp_path / f"line.{kind}").read_text()


def test_the_bar_of_lengths_fits_into_the_drawing(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    text = ON_A_LINE.replace('diameter = "0.02"', 'radii = ["0.01", "0.01", "0.011"]')
    path = tmp_path / "metres.toml"
    path.write_text('length_unit = "m"\n' + text)
    run(capsys, path, "--plot", tmp_path / "metres.svg")
    drawing = (tmp_path / "metres.svg").read_text()
    assert ">0.02 m</text>" in drawing
    bar = re.search(
        r'd="M([\d.]+) [\d.]+L([\d.]+) [\d.]+" fill="none" stroke="var\(--ink\)"', drawing
    )
    assert bar is not None
    assert 100 < float(bar[2]) - float(bar[1]) < 200


def test_many_collisions_are_drawn_with_few_marks_of_three_shapes(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Lines are told apart in grey, and numbers are round."""
    run(capsys, SCENES / "on-a-line.toml", "--plot", tmp_path / "line.svg")
    drawing = ElementTree.parse(tmp_path / "line.svg").getroot()
    words = {"".join(item.itertext()) for item in drawing.iter() if item.tag.endswith("text")}
    assert {"20", "40", "60"} <= words
    marks = Counter(path.attrib["d"] for path in drawing.iterfind(".//{*}path[@transform]"))
    assert len(marks) == 2
    assert all(20 < count <= 60 for count in marks.values())
    assert counted(5e5, "km") == "500000 km"
    assert counted(2e-6, "diameter") == "2·10⁻⁶ diameters"


def test_the_animation_needs_nothing_from_outside(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    run(capsys, SCENES / "in-space.toml", "--plot", tmp_path / "scene.html")
    text = (tmp_path / "scene.html").read_text()
    assert "http" not in text
    assert "src=" not in text
    data = text.split("const scene = ")[1].split(";\n")[0]
    legs = json.loads(data)["legs"]
    assert [leg["pair"] for leg in legs] == ["", "01", "12"]
    assert all(len(place) == 2 for leg in legs for place in leg["places"])


def test_a_process_is_quick_to_start() -> None:
    """Nothing is loaded that the verdict does not need."""
    program = (
        "import sys; from verify.cli import main; "
        f"main(['scene', {str(SCENES / 'nearly-aligned.toml')!r}]); "
        "print(*sys.modules)"
    )
    words = [sys.executable, "-c", program]
    out = subprocess.run(words, capture_output=True, text=True, check=True, cwd=ROOT).stdout
    loaded = set(out.split())
    assert not loaded & {"matplotlib", "json", "hashlib", "argparse", "verify.check"}
    assert not loaded & {"verify.wire.write", "verify.wire.read", "verify.wire.judge"}


def test_too_many_collisions_for_a_certificate(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    text = (SCENES / "on-a-line.toml").read_text().replace("0.0717968", "0.07181")
    path = written(tmp_path, text)
    code, out, _ = run(capsys, path)
    assert code == 0
    assert int(out.removeprefix("disperses: after ").split()[0]) > 200
    without = out
    code, out, err = run(capsys, path, "--out", tmp_path / "out")
    assert (code, out) == (0, without)
    assert err.count("\n") == 1
    assert "more than the checker is willing to follow; no certificate was written" in err
    assert not (tmp_path / "out").exists()


def test_too_few_bits_at_first_are_no_reason_to_give_up(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """515 collisions: with 80 bits the checker runs out of work, with 512 it does not."""
    text = """r = "0.06588"
positions = [["0", "0"], ["1.59", "0"], ["-1.4", "0"]]
velocities = [["-0.11", "1e-60"], ["-0.29", "0"], ["1.85", "0"]]
"""
    code, out, err = run(capsys, written(tmp_path, text), "--out", tmp_path / "out")
    assert code == 0
    assert "no certificate" not in err
    assert "disperses: after 515 collisions" in out
    assert (tmp_path / "out" / "certificate.json").exists()


def test_a_folder_keeps_the_verdict_without_a_certificate(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    text = (SCENES / "on-a-line.toml").read_text().replace("0.0717968", "0.07181")
    (tmp_path / "scenes").mkdir()
    written(tmp_path / "scenes", text)
    code, out, _ = run(capsys, tmp_path / "scenes", "--out", tmp_path / "out", "--json")
    document = json.loads(out)
    VALID.validate(document)
    (found,) = document["scenes"]
    assert (code, found["verdict"], found["reason"]) == (0, "disperses", "apart")
    assert found["judged_by"] == "FLINT at a point"
    assert "more than the checker is willing to follow" in found["no_certificate"]
    assert [path.name for path in (tmp_path / "out" / "scene").iterdir()] == ["scene.json"]


def test_a_folder_becomes_a_table(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    made = folder(tmp_path)
    (made / "bad, really.toml").write_text(BAD["overlap"][0])
    table = tmp_path / "out" / "table.csv"
    code, out, err = run(capsys, made, "--csv", table)
    assert (code, err) == (2, "")
    with table.open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert [(row["file"], row["verdict"], row["reason"]) for row in rows] == [
        ("bad, really.toml", "unusable", "unusable"),
        ("nearly-aligned.toml", "collapses", "sharper"),
        ("passing.toml", "disperses", "apart"),
        ("tie.toml", "undecided", "triple-contact"),
    ]
    assert rows[1]["central"] == "0"
    assert 0 < float(rows[1]["time_low"]) < float(rows[1]["time_high"])
    assert (rows[2]["collisions_certain"], rows[2]["energy_lost_high"]) == ("0", "0")
    totals = {"collapses": "inf", "undecided": "", "unusable": ""}
    for row in rows:
        assert row["collisions_total"] == totals.get(row["verdict"], row["collisions_certain"])
    assert rows[3]["event_time_low"] == rows[3]["event_time_high"] == "1"
    assert out.split()[-2:] == ["all", "4"]
    assert run(capsys, made, "--csv", tmp_path / "again.csv", "--jobs", 2)[:2] == (code, out)
    assert (tmp_path / "again.csv").read_bytes() == table.read_bytes()


def test_a_scene_becomes_tables(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path, table, way = SCENES / "in-space.toml", tmp_path / "a.csv", tmp_path / "b.csv"
    code, out, _ = run(capsys, path, "--csv", table, "--trajectory", way)
    assert (code, out) == run(capsys, path)[:2]
    assert len(table.read_text().splitlines()) == 2
    with way.open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert [(row["collision"], row["pair"], row["particle"]) for row in rows] == [
        (str(n), pair, str(i)) for n, pair in enumerate(("", "01", "12")) for i in range(3)
    ]
    assert float(rows[0]["v1_low"]) == 1
    assert run(capsys, folder(tmp_path), "--trajectory", way)[0] == 2


FAMILY = """r = "0.01..0.1"
positions = [[0, 0], ["501/500", 0], [-1.006, "h"]]
velocities = [[0, 0], [-1.4, 0], ["7/10", "v - h"]]
[parameters]
h = "0..0.1"
v = "-0.1..0.1"
"""


def test_a_sample_has_the_digits_that_are_asked_for(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path, table = written(tmp_path, FAMILY), tmp_path / "sample.csv"
    assert run(capsys, path, "--sample", 12, "--digits", 8, "--csv", table)[0] == 0
    with table.open(newline="") as file:
        rows = [row for row in csv.DictReader(file) if row["time_low"]]
    assert rows
    for row in rows:
        low, high = (Fraction(row[f"time_{end}"]) for end in ("low", "high"))
        assert high - low < low / 10**7


def test_a_sample_says_how_likely_a_collapse_is(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path, table = written(tmp_path, FAMILY), tmp_path / "sample.csv"
    words = (path, "--sample", 60, "--seed", 5)
    code, out, err = run(capsys, *words, "--csv", table)
    assert (code, err) == (0, "")
    sides = ["  h in [0, 0.1]", "  r in [0.01, 0.1]", "  v in [-0.1, 0.1]"]
    assert out.splitlines()[:4] == ["60 random points, seed 5; uniform and independent are", *sides]
    assert "verdict    reason                 scenes      share" in out
    assert "where what is undecided counts as both:\n  infinitely many collisions: [" in out
    assert run(capsys, *words, "--jobs", 2)[1] == out
    code, text, _ = run(capsys, *words, "--json", "--confidence", "99%")
    document = parsed(text)
    schema = json.loads((ROOT / "certificates/schema/sample.schema.json").read_text())
    jsonschema.validate(document, schema)
    counts = Counter[str]()
    for one in document["counts"]:
        counts[one["verdict"]] += one["count"]
    assert sum(counts.values()) == document["sample"] == 60
    low, high = map(float, document["shares"]["infinitely_many"])
    assert 0 < low < counts["collapses"] / 60 < high < 1
    with table.open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert [row["verdict"] for row in rows].count("collapses") == counts["collapses"]
    first = rows[0]
    point = ",".join(f"{name}={first[name]}" for name in ("h", "r", "v"))
    found = json.loads(run(capsys, path, "--at", point, "--json")[1])
    assert (found["verdict"], found["reason"]) == (first["verdict"], first["reason"])


def test_a_grid_is_a_table_of_evenly_spaced_points(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path, table = written(tmp_path, FAMILY), tmp_path / "grid.csv"
    words = (path, "--grid", "r=0.01..0.1:4,h=0..1/30:2", "--at", "v=1/20")
    code, out, err = run(capsys, *words, "--csv", table)
    assert (code, err) == (0, "")
    assert out.splitlines()[-1].split() == ["all", "8"]
    with table.open(newline="") as file:
        rows = list(csv.DictReader(file))
    found = [(row["r"], row["h"], row["v"]) for row in rows]
    assert found == [
        (f"{r}", h, "1/20") for r in ("1/100", "1/25", "7/100", "1/10") for h in ("0", "1/30")
    ]
    assert rows[1]["h_decimal"] == "0.033333333333333333"
    lines = run(capsys, *words, "--jobs", 2)[1].splitlines()
    assert [line.partition(":")[0] for line in lines][:2] == ["r=0.01,h=0", "r=0.01,h=1/30"]
    for row, line in zip(rows, lines, strict=True):
        assert line.partition(": ")[2].startswith(row["verdict"])
        point, one = f"r={row['r']},h={row['h']},v={row['v']}", tmp_path / "one.csv"
        assert run(capsys, path, "--at", point, "--csv", one)[0] == 0
        with one.open(newline="") as file:
            assert [*csv.DictReader(file)] == [row]


def test_points_of_a_grid_where_particles_overlap_or_work_is_spent(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = written(tmp_path, FAMILY.replace('"501/500"', '"1 - h"'))
    words = (path, "--grid", "h=0..0.1:2", "--at", "v=0,r=0.01", "--collisions", "0")
    code, out, _ = run(capsys, *words)
    assert code == 3
    assert out.splitlines()[0].startswith("h=0: undecided: budget: ")
    assert out.splitlines()[1] == "h=0.1: particles overlap"


def test_a_sample_of_some_parameters(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path, table = written(tmp_path, FAMILY), tmp_path / "sample.csv"
    code, out, _ = run(capsys, path, "--sample", 9, "--at", "h=1/20", "--csv", table)
    assert code == 0
    assert out.splitlines()[1:4] == ["  h = 0.05", "  r in [0.01, 0.1]", "  v in [-0.1, 0.1]"]
    with table.open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert {row["h"] for row in rows} == {"1/20"}
    assert len({row["r"] for row in rows}) == 9


@pytest.mark.parametrize(
    ("words", "why"),
    [
        ((), "is a family of scenes; add --sample N, or --at"),
        (("--grid", "r=0.01..0.1:4", "--at", "h=0"), "--grid: v has no value; add --at v=A"),
        (
            ("--grid", "r=0.01..0.1"),
            "'r=0.01..0.1': write r=0.01..0.1:5 for 5 values, once for some of h, r, v",
        ),
        (("--grid", "r=0.01..0.2:4"), "--grid: r=0.2 is not in 0.01..0.1"),
        (("--grid", "q=0.01..0.2:4"), "write NAME=A..B:N, once for some of h, r, v"),
        (("--grid", "r=0.01..0.02:1"), "--grid: "),
        (("--grid", "r=0.01..0.1:1000,h=0..0.1:1001"), "more than 1000000 points"),
        (("--grid", "r=0.01..0.1:2", "--at", "r=0.02"), "for some of h, v"),
        (("--grid", "r=0.01..0.1:2", "--out", "x"), "--out: leave it out with --grid"),
        (("--sample", "3", "--grid", "r=0.01..0.1:2"), "--grid: leave it out with --sample"),
        (("--sample", "3", "--at", "r=0.1,h=0,v=0"), "--at names all parameters"),
        ((), "verify map draws it"),
        (("--at", "0.04"), "--at: '0.04': write NAME=A for each of h, r, v"),
        (
            ("--at", "h=0,001,v=0,3"),
            "write h=0.001,v=0.3\n",
        ),
        (("--at", "h=1,r=0.03,v=0"), "--at: h=1 is not in 0..0.1, its interval in "),
        (("--at", "h=1"), "--at: r is missing"),
        (("--at", "h=1,h=2"), "write NAME=A once for each of h, r, v"),
        (("--at", "q=1"), "write NAME=A once for each of h, r, v"),
        (("--at", "h=0,r=0.03,v=0", "--grid", "r=0.01..0.1:2"), "has no parameter without a value"),
        (("--sample", "0"), "--sample: "),
        (("--sample", "5", "--confidence", "100%"), "--confidence: '100%' is not in (0, 1)"),
        (("--sample", "5", "--confidence", "100"), "is not in (0, 1); write for example 99%"),
        (
            ("--sample", "5", "--plot", "a.html"),
            "'a.html': a sample is drawn as .svg; write FILE.svg",
        ),
        (
            ("--sample", "5", "--plot", "a.png"),
            "'a.png': a sample is drawn as .svg; write FILE.svg",
        ),
    ],
)
def test_a_family_needs_a_point_or_a_sample(
    words: tuple[str, ...], why: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    check_refused(run(capsys, written(tmp_path, FAMILY), *words), why)


def drawn(path: Path) -> tuple[str, list[tuple[list[str], list[str]]]]:
    """What stands above the histograms of a sample; their words, and those at their bars."""
    root = ElementTree.parse(path).getroot()

    def words(item: ElementTree.Element) -> list[str]:
        return ["".join(one.itertext()) for one in item if one.tag.endswith("text")]

    panels = []
    for panel in (item for item in root if "transform" in item.attrib):
        counts = [one.text for one in panel if "paint-order" in one.attrib]
        panels.append((words(panel), [text or "" for text in counts]))
    return " ".join(words(root)), panels


def test_a_sample_is_drawn_as_histograms(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """The number at each bar is that of the scenes in the table."""
    text = FAMILY.replace("0.01..0.1", "0.04..0.06") + 'h_2 = "-0.3..0.3"\n'
    text = 'title = "A & B"\ntime_unit = "ms"\n' + text.replace('-1.006, "h"', '-1.006, "h_2"')
    path, table, plot = written(tmp_path, text), tmp_path / "a.csv", tmp_path / "a.svg"
    command = (path, "--sample", 60, "--collisions", 30)
    assert run(capsys, *command, "--csv", table, "--plot", plot)[0] == 0
    assert run(capsys, *command, "--jobs", 2, "--plot", tmp_path / "b.svg")[0] == 0
    assert (tmp_path / "b.svg").read_bytes() == plot.read_bytes()
    with table.open(newline="") as file:
        rows = list(csv.DictReader(file))
    of = {
        verdict: [row for row in rows if row["verdict"] == verdict]
        for verdict in ("collapses", "disperses", "finite", "undecided")
    }
    assert all(of.values())
    share = json.loads(run(capsys, *command, "--json")[1])["shares"]["infinitely_many"]
    heading, panels = drawn(plot)
    assert heading.startswith("A & B 60 random points, seed 1; ")
    count = len(of["collapses"])
    assert f"collapses: {count} of 60, {count / 0.6:.3f} % infinitely many" in heading
    assert f"infinitely many collisions: [{', '.join(share)}], share of the family" in heading
    missing = f"{len(of['undecided'])} undecided, {len(of['finite'])} with finitely many collisions"
    assert f"not drawn: {missing}, not counted times and angles are" in heading
    (words, counts), times, angles = panels
    assert {"number of collisions", "disperses: all its collisions"} <= set(words)
    assert "collapses: collisions until it is certain" in words
    bars = [word.split("–") for word in words if re.fullmatch("[0-9]+–[0-9]+", word)]
    assert bars
    known = [
        sum(int(low) <= int(row["collisions_certain"]) <= int(high) for row in of[verdict])
        for verdict in ("collapses", "disperses")
        for low, high in bars
    ]
    assert counts == [str(n) for n in known if n]
    assert sum(known) == len(of["collapses"]) + len(of["disperses"])
    assert "collapse time (ms)" in times[0]
    assert "final angle θ (degrees)" in angles[0]

    def angle(row: dict[str, str], end: str) -> float:
        return math.degrees(math.acos(-min(float(row[f"neg_cos_{end}"]), 1)))

    middles = (
        [(float(row["time_low"]) + float(row["time_high"])) / 2 for row in of["collapses"]],
        [(angle(row, "low") + angle(row, "high")) / 2 for row in of["collapses"]],
    )
    for values, (words, counts) in zip(middles, (times, angles), strict=True):
        # Each second edge has a mark; those of the other axis follow, and begin at 0.
        first, second, *_ = map(float, words[: words.index("0")])
        found = Counter(math.floor(2 * (value - first) / (second - first)) for value in values)
        assert counts == [str(found[k]) for k in sorted(found)]


def test_histograms_of_hardly_anything(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    text = FAMILY.replace("0.01..0.1", "0.01..0.03")
    path, plot = written(tmp_path, text), tmp_path / "a.svg"

    def histograms(*more: object) -> tuple[str, list[tuple[list[str], list[str]]]]:
        assert run(capsys, path, "--plot", plot, *more)[0] == 0
        return drawn(plot)

    one = histograms("--sample", 1, "--digits", 3)[1]
    assert [counts for _, counts in one] == [["1"]] * 3
    assert [len(words[: words.index("0")]) for words, _ in one] == [1] * 3
    assert "collapses: collisions until its time has 3 digits" in one[0][0]
    heading, panels = histograms("--sample", 7, "--collisions", 0)
    assert "not drawn: 7 undecided" in heading
    title = "number of scenes, by number of collisions"
    assert panels == [([title, "no scene to draw"], ["no scene to draw"])]


def test_histograms_without_a_collapse(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    text = FAMILY.replace("0.01..0.1", "0.2..0.3").replace("[-1.4, 0]", "[1.4, 0]")
    path, plot = written(tmp_path, text), tmp_path / "a.svg"
    assert run(capsys, path, "--sample", 7, "--plot", plot)[0] == 0
    heading, [(words, counts)] = drawn(plot)
    assert "collapses: 0 of 7, 0.000 % " in heading
    assert heading.endswith(" all are drawn: none is undecided")
    assert sum(map(int, counts)) == 7
    assert "disperses: all its collisions" in words


def test_edges_of_histograms() -> None:
    def edges(low: str, high: str, *, is_whole: bool = False) -> list[Fraction]:
        return distributions.edges(Fraction(low), Fraction(high), is_whole=is_whole)

    assert edges("0.011", "0.1054") == [Fraction(k, 100) for k in range(1, 12)]
    assert edges("0", "3", is_whole=True) == [0, 1, 2, 3]
    assert edges("0", "120", is_whole=True) == [0, 1, 2, 5, 10, 20, 50, 100, 200]
    assert edges("3", "41", is_whole=True) == [*range(0, 50, 5)]
    tiny = edges("2e-400", "1e-398")  # too small for floats
    assert tiny == [Fraction(k, 10**399) for k in range(11)]
    assert edges("3", "3e9") == [10**power for power in (0, 2, 4, 6, 8, 10)]
    assert edges("180", "180") == [180, 180]
    values, ends = ([*map(Fraction, given)] for given in ((0, 1, 4, 5), (0, 1, 5)))
    assert distributions.counts_between(values, ends) == [1, 3]


@pytest.mark.parametrize("words", [("--at", "r=0.03"), ("--grid", "r=0.01..0.1:2")])
def test_a_scene_without_parameters_says_how_to_write_one(
    words: tuple[str, ...], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    code, _, err = run(capsys, written(tmp_path, GOOD), *words)
    assert (code, 'write an interval there, like r = "0.02..0.06"' in err) == (2, True)


def test_an_angle_is_written_without_a_cosine(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    for term, is_angle in (("cos(h)", True), ("h//2", False)):
        path = written(tmp_path, FAMILY.replace('"h"', f'"{term}"'))
        code, _, err = run(capsys, path, "--sample", 1)
        assert (code, "the tangent of a/2: its cosine is (1 - t**2)/(1 + t**2)" in err) == (
            2,
            is_angle,
        )


def test_the_time_of_an_event_next_to_a_short_decimal_is_told_with_few_digits(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    text = """r = 0.05
positions = [[0, 0], ["20.5", 1], ["-20.6", 0]]
velocities = [[0, 0], [-500, 0], [400, 20]]
"""
    _, out, _ = run(capsys, written(tmp_path, text))
    found = re.search(r"grazing: .* at the time 0\.041 ± 10⁻³?[0-9⁰-⁹]+;", " ".join(out.split()))
    assert found is not None, out


def test_a_row_of_the_table_of_collisions_is_one_line(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    text = 'time_unit = "microseconds of the experiment"\n' + GOOD
    _, out, _ = run(capsys, written(tmp_path, text), "-v", "--digits", 8)
    rows = out.partition("\n\n")[0].splitlines()
    assert len(rows[0]) > 80
    assert [row.split()[0] for row in rows] == ["n", *map(str, range(1, len(rows)))]


def test_a_line_of_a_grid_does_not_repeat_what_the_file_says(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    text = 'title = "Steel"\ndiameter = 1\nlength_unit = "mm"\n' + FAMILY
    grid = ("--grid", "r=0.01..0.1:2", "--at", "h=0,v=0")
    assert run(capsys, written(tmp_path, text), *grid) == run(
        capsys, written(tmp_path, FAMILY), *grid
    )


def test_a_collapse_is_drawn_from_collision_to_collision(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Far more collisions are drawn than the verdict needs, and their number is on an axis."""
    path = tmp_path / "scene.svg"
    run(capsys, SCENES / "nearly-aligned.toml", "--plot", path)
    root = ElementTree.parse(path).getroot()
    words = ["".join(item.itertext()) for item in root.iter() if item.tag.endswith("text")]
    assert {"number of the collision", "1 diameter", "14", "10⁻¹⁰"} <= set(words)
    assert [word for word in words if word.startswith(("normal speed", "gap of", "time to"))]
    assert "from collision 3 on 01, 02, 01, … for ever;" in words[0]
    lines = [
        [float(place.split(" ")[1]) for place in item.attrib["d"][1:].split("L")]
        for item in root.iter()
        if item.tag.endswith("path") and item.attrib["d"].count("L") > 10
    ][-3:]
    assert [len(line) >= 15 for line in lines] == [True] * 3
    for line in lines:
        # In the end each falls by the same factor, from one collision to the next.
        steps = [b - a for a, b in pairwise(line)][-6:]
        assert max(steps) < 1.2 * min(steps)


def test_a_unit_cannot_end_the_script(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    text = (SCENES / "in-space.toml").read_text()
    path = written(tmp_path, f'time_unit = "</script><b>s"\n{text}')
    assert run(capsys, path, "--plot", tmp_path / "s.html")[0] == 0
    page = (tmp_path / "s.html").read_text()
    assert page.count("</script>") == page.count("<script>") == 1


def test_a_long_seed_is_a_seed(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    words = (written(tmp_path, FAMILY), "--sample", 2, "--seed")
    found = [run(capsys, *words, seed)[0] for seed in (2**64 - 2, 2**64 - 1, 2**65)]
    assert found == [0, 0, 2]


def test_numbers_that_no_drawing_has(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = written(
        tmp_path,
        'r = "0.01..0.08"\npositions = [["0", "0"], ["1.1", "0"], ["-1.1", "h"]]\n'
        'velocities = [["0", "0"], ["-1e-320", "0"], ["1e-320", "v*1e-320"]]\n'
        '[parameters]\nh = "0..0.1"\nv = "-1..1"\n',
    )
    code, _, err = run(capsys, path, "--sample", 20, "--plot", tmp_path / "a.svg")
    assert code == 2
    assert "too large or too small to draw" in err
    assert not (tmp_path / "a.svg").exists()
