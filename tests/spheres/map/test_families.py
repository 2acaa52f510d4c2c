"""Maps of families: r and any other number as an axis, one parameter alone, scenes on a line."""

from __future__ import annotations

import json
import random
from fractions import Fraction
from pathlib import Path
from typing import Any

import jsonschema
import numpy as np
import pytest

from tests.check.test_check_map import sealed
from verify import check_map
from verify.cli import main
from verify.spheres.map import boxes as boxes_module
from verify.spheres.map.axes import axis_in, plane_in
from verify.spheres.map.boxes import verdicts
from verify.spheres.map.grow import Target, decide_chunks, grow
from verify.spheres.map.log import Progress, all_keys, plane_document
from verify.spheres.map.planes import Scenes
from verify.spheres.map.workers import workers
from verify.spheres.scene.decide import decide_scene
from verify.spheres.scene.families import read_family

ROOT = Path(__file__).resolve().parents[3]
SCHEMA = ROOT / "certificates/schema/map.schema.json"
LINE = "certificates/scenes/on-a-line.toml"
#: r against the angle, by the tangent t of its half: sphere 1 parts slowly, sphere 2 comes.
DIAGRAM = """
r = "0.01..0.08"
positions = [[0, 0], [-1, 0], ["1.5*(1-t**2)/(1+t**2)", "3*t/(1+t**2)"]]
velocities = [[0, 0], ["-0.01", 0], ["-(1-t**2)/(1+t**2)", "-2*t/(1+t**2)"]]
[parameters]
t = "0..1"
"""
#: Up to r = 0.05195 collapses; from 0.05198 on up to 205 collisions.
WEDGE = """
r = "0.05..0.056"
positions = [[0, 0], ["1.01", 0], ["-1.1", "0.2"]]
velocities = [[0, 0], [-1, "0.3"], [1, "-0.15"]]
"""
#: Two parameters of which one is left over.
TWO = """
r = "0.03"
positions = [[0, 0], ["1.1", 0], ["-1.1", "h"]]
velocities = [[0, 0], [-1, "vy"], [1, "vy/2 - h"]]
[parameters]
h = "0..0.1"
vy = "0..1"
"""


def plane_of(text: str, *axes: str, **fixed: str) -> Scenes:
    found = [axis_in(f"--{name}", axis) for name, axis in zip("xy", axes, strict=False)]
    return plane_in("f", text.encode(), found, {k: Fraction(x) for k, x in fixed.items()})


def log_of(plane: Scenes, boxes: int, jobs: int = 1, dask: str | None = None) -> list[bytes]:
    progress = Progress(plane)
    lines = [progress.header]
    with workers(jobs, dask) as staff:
        for _ in grow(progress, Target(Fraction(1, 1000), boxes, 14), staff, lines.append):
            pass
    return lines


@pytest.fixture(scope="module")
def diagram() -> list[bytes]:
    return log_of(plane_of(DIAGRAM, "r", "t"), 1500)


def test_points_of_the_diagram_are_what_its_boxes_say(diagram: list[bytes]) -> None:
    """By the flow in balls, which shares no verdict with the boxes."""
    family, rng, seen = read_family("f", DIAGRAM.encode()), random.Random(3), {"c": 0, "d": 0}
    boxes = [
        (key, letter)
        for line in map(json.loads, diagram[1:])
        for key, letter in zip(line["keys"].split(), line["verdicts"], strict=True)
        if letter in "cdo"
    ]
    for key, letter in rng.sample(boxes, 60):
        column, row = check_map.corner(key)
        size = 2 ** len(key)
        share = [Fraction(place * 997 + rng.randint(0, 997), size * 997) for place in (column, row)]
        sides = [family.sides[name] for name in "rt"]
        r, t = (a + (b - a) * x for (a, b), x in zip(sides, share, strict=True))
        found = decide_scene(family.at({"r": r, "t": t})).verdict
        assert found[0] == letter.replace("o", "d"), (key, r, t)
        seen[found[0]] += 1
    assert min(seen.values()) >= 5


def test_the_checker_accepts_the_diagram(diagram: list[bytes]) -> None:
    plane, areas = check_map.check_log(iter(diagram), None)
    assert isinstance(plane, check_map.Family)
    assert areas.collapses > Fraction(1, 6)
    assert areas.disperses > Fraction(1, 5)
    assert areas.undecided < Fraction(1, 5)
    assert "r in [1/100, 2/25], t in [0, 1]" in check_map.says(plane, areas)


def test_beside_the_border_boxes_disperse_by_the_theorem_outside() -> None:
    """No such box has a scene that collapses: neither in its middle, nor at its ends."""
    plane, family = plane_of(WEDGE, "r"), read_family("f", WEDGE.encode())
    lines = log_of(plane, 70)
    _, areas = check_map.check_log(iter(lines), None)
    assert areas.is_outside
    assert areas.undecided < Fraction(1, 20)
    boxes = [
        key
        for line in map(json.loads, lines[1:])
        for key, letter in zip(line["keys"].split(), line["verdicts"], strict=True)
        if letter == "o"
    ]
    assert sum(Fraction(1, 2 ** len(key)) for key in boxes) > Fraction(2, 5)
    low, width = plane.x[0], plane.x[1] - plane.x[0]
    for key in boxes:
        for share in (0, Fraction(1, 2), 1):
            r = low + width * (int(key, 2) + share) / 2 ** len(key)
            assert decide_scene(family.at({"r": r})).verdict == "disperses", r
    progress = Progress(plane)
    assert progress.resume(iter(lines)) == sum(map(len, lines))
    assert {letter for _, letter, _ in progress.decided()} == {"c", "d"}
    assert progress.undecided == areas.undecided


def test_two_processes_write_the_same_diagram(diagram: list[bytes]) -> None:
    assert log_of(plane_of(DIAGRAM, "r", "t"), 1500, 2) == diagram


def test_dask_writes_the_same_diagram(diagram: list[bytes]) -> None:
    distributed = pytest.importorskip("distributed")
    with distributed.LocalCluster(
        n_workers=1, threads_per_worker=1, processes=False, dashboard_address=None
    ) as cluster:
        assert log_of(plane_of(DIAGRAM, "r", "t"), 1500, 1, cluster.scheduler_address) == diagram


@pytest.mark.parametrize("letters", ["cd", "dc", "cf", "df", "uc", "ud", "uf"])
def test_another_verdict_of_the_diagram(diagram: list[bytes], letters: str) -> None:
    old, new = letters
    content = [json.loads(line) for line in diagram]
    numbers = next(x for line in content[1:] for x in line["numbers"])
    record = next(line for line in content[1:] if old in line["verdicts"])
    place = record["verdicts"].index(old)
    before = record["verdicts"][:place].count("c")
    if old == "c":
        del record["numbers"][before]
    if new == "c":
        record["numbers"].insert(before, numbers)
    record["verdicts"] = record["verdicts"][:place] + new + record["verdicts"][place + 1 :]
    with pytest.raises((check_map.RefusedError, check_map.LogError)):
        check_map.check_log(iter(sealed(content)), None)


PLANES: dict[str, Any] = {
    "an unknown operation": ("r", ["^", "x", "1/2"]),
    "three arguments": ("r", ["+", "x", "x", "x"]),
    "a term that is a number": ("r", 1),
    "a letter that is no parameter": ("r", "z"),
    "r too large": ("r", "1"),
    "one axis too few": ("axes", ["r"]),
    "an axis twice": ("axes", ["r", "r"]),
    "a name with a blank": ("axes", ["r", "a b"]),
    "a name that is none": ("axes", ["r", 1]),
    "axes that are no list": ("axes", "rt"),
    "an interval that is none": ("y", ["1", "1"]),
    "two positions": ("positions", [["0"], ["1"]]),
    "vectors of two lengths": ("velocities", [["0", "0"], ["0"], ["0", "0"]]),
    "a position that is no list": ("positions", ["0", "0", "0"]),
}


@pytest.mark.parametrize("name", PLANES)
def test_malformed_families(diagram: list[bytes], name: str) -> None:
    key, value = PLANES[name]
    header = json.loads(diagram[0])
    header["plane"][key] = value
    with pytest.raises(check_map.LogError, match="expected"):
        check_map.check_log(iter(sealed([header])), None)


def test_terms_are_not_deep_and_not_long(diagram: list[bytes]) -> None:
    header = json.loads(diagram[0])
    for depth, fine in ((61, True), (62, False)):
        term: Any = "x"
        for _ in range(depth):
            term = ["+", term, "0"]
        header["plane"]["r"] = term
        if fine:
            check_map.check_log(iter(sealed([header])), None)
        else:
            with pytest.raises(check_map.LogError, match="not deep"):
                check_map.check_log(iter(sealed([header])), None)
    row = ["x"] * 2
    for _ in range(9):
        row = [["*", row[0], row[0]]] * 2
    header["plane"] |= {"r": "1/2", "positions": [row, row, row]}
    with pytest.raises(check_map.LogError, match="at most 1000 operations"):
        check_map.check_log(iter(sealed([header])), None)


def test_r_is_less_than_1_on_each_box() -> None:
    plane = plane_of(DIAGRAM.replace("0.01..0.08", "0.5..2"), "r", "t")
    assert set(verdicts(plane, ["1", "3"]).letters) == {"u"}
    law = check_map.law_in(check_map.plane_of(json.loads(Progress(plane).header)["plane"]))
    with pytest.raises(check_map.RefusedError, match="r may not be in"):
        check_map.on_box(law, "1")


# --- one parameter -------------------------------------------------------------------------------


def test_the_critical_r_on_a_line(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """McNamara and Young: 7 - 4√3, where r² - 14 r + 1 = 0."""
    command = ["map", LINE, "--x", "r=0.05..0.08", "--undecided", "0.01%", "--json"]
    assert main([*command, "--out", str(tmp_path)]) == 0
    document = json.loads(capsys.readouterr().out)
    schema = json.loads(SCHEMA.read_text(encoding="utf-8"))
    jsonschema.Draft202012Validator(schema).validate(document)
    ((low, high),) = (map(Fraction, ends) for ends in document["borders"])
    assert low**2 - 14 * low + 1 > 0 > high**2 - 14 * high + 1
    assert high - low < Fraction(1, 10**5)
    assert [part["verdict"] for part in document["intervals"]] == ["collapses", "finite"]
    assert document["cites"] == ["flow", "sharper", "line", "classification"]
    assert check_map.main([str(tmp_path / "map.jsonl")]) == 0
    assert "collapses in [1/20, " in capsys.readouterr().out
    assert main(command[:-1]) == 0
    assert "a critical r lies in [" in capsys.readouterr().out
    drawing = (tmp_path / "map.svg").read_text(encoding="utf-8")
    assert drawing.count("</svg>") == 1
    assert "r = x" not in drawing


def test_a_line_may_have_any_rational_direction(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Positions and velocities along (3, 4); a little beside the line it is another theorem."""
    turned = """r = 0.06
positions = [[1, 1], ["1 + 3*0.4", "1 + 4*0.4"], ["1 - 3*0.5", "1 - 4*0.5"]]
velocities = [[5, 0], ["5 - 3*s", "-4*s"], ["5 + 3", "4 + BESIDE"]]
parameters = {s = "1..1.01"}
"""
    for beside, letter in (("0", "c"), ("1/1000000", "f")):
        file, out = tmp_path / "turned.toml", tmp_path / f"out-{letter}"
        file.write_text(turned.replace("BESIDE", beside), encoding="utf-8")
        assert main(["map", str(file), "--x", "s", "--boxes", "64", "--out", str(out)]) in (0, 3)
        assert check_map.main([str(out / "map.jsonl")]) == 0
        first = (out / "map.jsonl").read_text(encoding="utf-8").splitlines()[1]
        assert {*json.loads(first)["verdicts"]} == {letter}
        told = capsys.readouterr().out
        assert ("certificates/line" in told) == (letter == "c")


def test_a_collapse_on_a_line_is_not_taken_elsewhere() -> None:
    """Without six numbers a box collapses on a line only."""
    lines = [
        json.loads(line) for line in log_of(plane_of(Path(LINE).read_text(), "r=0.05..0.06"), 16)
    ]
    assert lines[1]["verdicts"] == "c" * 16
    assert lines[1]["numbers"] == [[]] * 16
    check_map.check_log(iter(sealed(lines)))
    header = lines[0] | {"plane": lines[0]["plane"] | {"r": "2/25", "axes": ["vx"]}}
    with pytest.raises(check_map.RefusedError):
        check_map.check_log(iter(sealed([header, lines[1]])))
    for row in lines[0]["plane"]["velocities"]:
        row[1] = "x"
    check_map.check_log(iter(sealed(lines)))  # all drift sideways alike, and stay on a line
    lines[0]["plane"]["velocities"][2][1] = "0"
    with pytest.raises(check_map.LogError, match="six numbers"):
        check_map.check_log(iter(sealed(lines)))


def test_finitely_many_collisions_need_a_large_r() -> None:
    text = Path(LINE).read_text(encoding="utf-8")
    lines = [json.loads(line) for line in log_of(plane_of(text, "r=0.0718..0.09"), 16)]
    assert set(lines[1]["verdicts"]) <= {"d", "f"}
    assert "f" in lines[1]["verdicts"]
    check_map.check_log(iter(sealed(lines)))
    lines[0]["plane"]["x"] = ["717/10000", "9/100"]
    with pytest.raises(check_map.RefusedError, match="7 - 4√3"):
        check_map.check_log(iter(sealed(lines)))


def test_parameters_of_a_file(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "two.toml"
    path.write_text(TWO, encoding="utf-8")
    command = ["map", str(path), "--undecided", "20%"]
    assert main([*command, "--x", "vy", "--at", "h=0.01"]) == 0
    assert "vy in [0, 1]" in capsys.readouterr().out
    assert main([*command, "--x", "vy=0.2..0.4", "--y", "h"]) == 0
    assert "vy in [1/5, 2/5], h in [0, 1/10]" in capsys.readouterr().out
    wrong = {
        "--x: is missing": [],
        "--at: h is neither an axis nor fixed": ["--x", "vy"],
        "--at: vy is no parameter that is left": ["--x", "vy", "--at", "vy=1,h=0"],
        "--x: 'w' is no parameter": ["--x", "w=0..1", "--at", "vy=1,h=0"],
        "--x: r has no interval": ["--x", "r", "--at", "vy=1,h=0"],
        "--y: is the number that --x varies": ["--x", "vy", "--y", "vy"],
        "--x: 'vy=1' is no interval": ["--x", "vy=1"],
        "--x: positions[2][2] is not in": ["--x", "positions[2][2]=0..1", "--at", "vy=1,h=0"],
    }
    for said, words in wrong.items():
        assert main([*command, *words]) == 2
        err = capsys.readouterr().err
        assert err.startswith(f"verify: {said.partition(':')[0]}: "), err
        assert err.count("\n") == 1


def test_an_axis_is_in_the_unit_of_the_file() -> None:
    text = 'r = "0.03"\ndiameter = 2\npositions = [[0], [3], [-3]]\nvelocities = [[0], [-1], [1]]'
    plane = plane_of(text, "positions[1][0]=3..4", "velocities[1][0]=-1..-0.5")
    assert plane.coordinates.x[1] == [("/", "x", Fraction(2))]
    assert plane.coordinates.x[2] == [Fraction(-3, 2)]


NEAR_A_LINE = """r = "0.05..0.06"
positions  = [[0, 0], ["1.01", 0], ["-1.05", "0.001"]]
velocities = [[0, 0], [-1, 0], [1, 0]]
"""
#: The two others as far from the line on the same side.
WITHOUT_MOMENTUM = NEAR_A_LINE.replace('"1.01", 0', '"1.01", "0.001"')


def test_what_the_checker_does_not_follow_is_undecided() -> None:
    """So many collisions are certain in doubles, and not in the numbers of the checker."""
    for text, key, letter in (
        (NEAR_A_LINE, "10101011000", "f"),
        (WITHOUT_MOMENTUM, "10101000111", "u"),
    ):
        plane, keys = plane_of(text, "r"), [key, "1" * 11]
        assert verdicts(plane, keys).letters == "dd"
        ((chunk, _),) = decide_chunks(plane, [keys])
        assert chunk.letters == f"{letter}d"
        checked = check_map.plane_of(plane_document(plane))
        law = check_map.law_in(checked)
        begin = check_map.beginning(law, checked)
        with pytest.raises(check_map.RefusedError, match=r"which collision is the next|in contact"):
            check_map.prove_box(law, begin, key, "d", [])
        check_map.prove_box(law, begin, keys[1], "d", [])


#: r across 9 - 4√5 and 7 - 4√3; without speed across, the spheres stay on a line.
ACROSS = """r = "0.05..0.09"
positions  = [[0, 0], ["1.01", 0], ["-1.05", 0]]
velocities = [[0, 0], [-1, "w"], [1, "-w/2"]]
parameters = {w = "-0.3..0.3"}
"""


def test_between_the_thresholds_angular_momentum_decides(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """No point of such a box collapses; most of them are followed to the end."""
    plane = plane_of(ACROSS, "r", "w")
    lines = log_of(plane, 1500)
    _, areas = check_map.check_log(iter(lines), None)
    assert areas.undecided < Fraction(2, 100)
    assert areas.finite > Fraction(1, 4)
    family, rng, ended = read_family("f", ACROSS.encode()), random.Random(5), 0
    boxes = [
        key
        for line in map(json.loads, lines[1:])
        for key, letter in zip(line["keys"].split(), line["verdicts"], strict=True)
        if letter == "f"
    ]
    for key in rng.sample(boxes, 40):
        share = [
            Fraction(place * 997 + rng.randint(0, 997), 2 ** len(key) * 997)
            for place in check_map.corner(key)
        ]
        sides = [family.sides[name] for name in "rw"]
        r, w = (a + (b - a) * x for (a, b), x in zip(sides, share, strict=True))
        found = decide_scene(family.at({"r": r, "w": w})).verdict
        assert found != "collapses", (key, r, w)
        ended += found == "disperses"
    assert ended > 35
    monkeypatch.setattr(boxes_module, "turning", lambda *_: np.zeros(1, bool))
    _, without = check_map.check_log(iter(log_of(plane, 1500)), None)
    assert without.undecided > 5 * areas.undecided


def test_angular_momentum_in_boxes_and_in_the_checker() -> None:
    """Where boxes say so, the checker does; on the line itself nobody does."""
    plane = plane_of(ACROSS, "r", "w")
    keys = list(all_keys(4))
    found = boxes_module.turning(plane, keys)
    checked = check_map.plane_of(plane_document(plane))
    assert found.tolist() == [check_map.turns(checked, key) for key in keys]
    touching = [check_map.corner(key)[1] in (7, 8) for key in keys]
    assert [not x for x in found.tolist()] == touching
