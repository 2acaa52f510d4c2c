"""Scenes of many particles, as people write them and as scripts read them."""

from __future__ import annotations

import csv
import json
from fractions import Fraction
from pathlib import Path
from random import Random
from typing import Any

import pytest

from tests.cli.running import check_refused, command, validator
from tests.cli.test_documents import document
from verify import check

BEADS = """
r = "0.03"
positions = [[0], ["1.2"], ["2.5"], [4], ["5.3"]]
velocities = [[1], ["0.3"], [0], ["-0.2"], [-1]]
"""
FLOOR = """
r = "0.9"
gravity = [0, -1]
walls = [{normal = [0, 2], level = 0, r = "1/2"}]
positions = [[0, "2.5"], [3, "0.9"]]
velocities = [[0, 0], [0, 0]]
"""
#: Two pairs that meet at the same time, far from each other.
TWO_PAIRS = """
r = "0.5"
positions = [[0], [2], [10], [12]]
velocities = [[1], [-1], [1], [-1]]
"""
#: One in the middle that two others meet at once.
TRIPLE = """
r = "0.5"
positions = [[0], [2], [4], [40]]
velocities = [[1], [0], [-1], [0]]
"""


def written(folder: Path, text: str) -> str:
    path = folder / "many.toml"
    path.write_text(text)
    return str(path)


run = command("scene")


def found_of(capsys: pytest.CaptureFixture[str], *words: str) -> dict[str, Any]:
    found = document(capsys, ["scene", *words])
    validator("many").validate(found)
    return found


def test_five_beads_and_the_three_that_collapse(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path, out = written(tmp_path, BEADS), tmp_path / "out"
    found = found_of(capsys, path, "--out", str(out))
    assert found["verdict"] == "collapses"
    assert found["members"] == [1, 2, 0]
    assert [one["pair"] for one in found["impacts"]] == ["0-1", "3-4", "1-2"]
    assert Fraction(found["impacts"][1]["time"][0]) == Fraction(3, 8)
    assert found["certified"]["certificate"] == str(out / "three")
    assert check.check_folders(check.read_folders([str(out / "three")]))[0] == 0
    since, (low, high) = Fraction(found["certified"]["since"]), map(Fraction, found["time"])
    three = document(capsys, ["scene", str(out / "three.toml")])
    assert (three["verdict"], three["central"]) == ("collapses", 0)
    assert low <= since + Fraction(three["time"][1])
    assert since + Fraction(three["time"][0]) <= high


def test_a_folder_that_cannot_be_written_is_named_before_any_file_is(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "out" / "three").mkdir(parents=True)
    (tmp_path / "out" / "three" / "mine").touch()
    code, out, err = run(capsys, written(tmp_path, BEADS), "--out", str(tmp_path / "out"))
    assert (code, out, err.count("\n")) == (2, "", 1)
    assert [path.name for path in (tmp_path / "out").iterdir()] == ["three"]


def test_where_nothing_ever_meets_no_larger_budget_is_proposed(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = written(
        tmp_path, 'r = "0.1"\nbox = [9]\npositions = [[0], [3]]\nvelocities = [[1], [1]]\n'
    )
    for words, remedy in (([], "--until T"), (["--until", "9999"], "a smaller --until")):
        code, out, _ = run(capsys, path, *words)
        assert (code, f"write {remedy}" in out) == (3, True)


def test_the_pair_that_has_a_coefficient_of_its_own_is_not_sought_among_all(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    rows = BEADS.replace('r = "0.03"', 'restitution = {"others" = "0.9", "PAIR" = "0.5"}')
    for pair in ("1-0", "0-5", "00-1", "0-0", "0", "0-1-2", "-1", "٠-1", "0-" + "1" * 99):
        code, _, err = run(capsys, written(tmp_path, rows.replace("PAIR", pair)))
        assert (code, "is no pair" in err) == (2, True), pair


def test_a_table_of_collisions(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    table = tmp_path / "events.csv"
    code, out, _ = run(capsys, written(tmp_path, BEADS), "--until", "3/8", "--csv", str(table))
    assert (code, "followed" in out) == (0, True)
    rows = list(csv.DictReader(table.read_text().splitlines()))
    assert [row["pair"] for row in rows] == ["0-1", "3-4"]  # the second one is at that time
    for row, speed in zip(rows, (Fraction(7, 10), Fraction(4, 5)), strict=True):
        assert Fraction(row["normal_speed_low"]) <= speed <= Fraction(row["normal_speed_high"])


def test_a_budget_is_undecided(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = written(tmp_path, BEADS)
    code, out, _ = run(capsys, path, "--collisions", "1")
    assert code == 3
    assert "certain: 1 collision, the last at the time 0.28571428" in " ".join(out.split())
    assert "certain: 0 collisions\n" in run(capsys, path, "--collisions", "0")[1]
    found = found_of(capsys, path, "--collisions", "1")
    assert (found["verdict"], found["reason"]) == ("undecided", "budget")


def test_two_pairs_at_once_and_three_at_once(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    found = found_of(capsys, written(tmp_path, TWO_PAIRS))
    assert (found["verdict"], found["collisions"]) == ("disperses", 3)
    assert {one["pair"] for one in found["impacts"][:2]} == {"0-1", "2-3"}
    assert found["impacts"][2]["pair"] == "1-2"
    path = written(tmp_path, TRIPLE)
    found = found_of(capsys, path)
    assert (found["verdict"], found["reason"]) == ("undecided", "triple-contact")
    assert found["event_time"] == ["1", "1"]
    code, out, _ = run(capsys, path)
    assert code == 3
    assert "0-1 and 1-2 touch at once" in " ".join(out.split())


def test_bounces_accumulate(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A ball falls 2/5 to the floor and bounces with half its speed: it rests after √(4/5)·3."""
    found = found_of(capsys, written(tmp_path, FLOOR))
    assert (found["verdict"], found["members"], found["wall"]) == ("rests", [1], 0)
    low, high = map(Fraction, found["time"])
    assert low**2 <= Fraction(4, 5) * 9 <= high**2
    assert high - low < Fraction(1, 10**30)
    (left, right), (below, above) = (map(Fraction, ends) for ends in found["place"])
    assert left <= 3 <= right
    assert below <= Fraction(1, 2) <= above


def test_a_ball_that_comes_near_prevents_it(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    text = FLOOR.replace('"2.5"', '"1.45"').replace("[3,", '["0.99",').replace("[[0, 0]", "[[1, 0]")
    path = written(tmp_path, text)
    found = found_of(capsys, path, "--until", "3/2")
    assert found["verdict"] != "rests" or "0-1" in {one["pair"] for one in found["impacts"]}
    assert found["impacts"][0]["pair"] == "0-1"


def test_elastic_walls_and_pairs(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The balls go on for ever: on an elastic floor none comes to rest."""
    found = found_of(capsys, written(tmp_path, FLOOR.replace('"1/2"', "1")), "--collisions", "9")
    assert (found["verdict"], found["collisions"]) == ("undecided", 9)
    path = written(tmp_path, BEADS.replace("0.03", "1"))
    found = found_of(capsys, path)
    assert (found["verdict"], found["collisions"] >= 4) == ("disperses", True)


def discs(r: str, rows: int, seed: int) -> str:
    rng = Random(seed)

    def number(low: int, high: int) -> str:
        return f'"{Fraction(rng.randint(low, high), 1000)}"'

    places = ", ".join(f"[{number(1500 * k, 1500 * k + 300)}, {number(1500 * n, 1500 * n + 300)}]"
                       for k in range(rows) for n in range(rows))  # fmt: skip
    speeds = ", ".join(f"[{number(-1000, 1000)}, {number(-1000, 1000)}]" for _ in range(rows**2))
    side = Fraction(3 * rows, 2)
    return (
        f'r = "{r}"\nbox = ["{side}", "{side}"]\npositions = [{places}]\nvelocities = [{speeds}]\n'
    )


def test_a_hundred_discs_in_a_box(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path, out = written(tmp_path, discs("0.05", 10, 1)), tmp_path / "out"
    found = found_of(capsys, path, "--out", str(out))
    assert found["verdict"] == "collapses"
    assert check.check_folders(check.read_folders([str(out / "three")]))[0] == 0
    assert found_of(capsys, path, "--until", "1/10")["verdict"] == "followed"


BAD = {
    "no-list": (BEADS.replace("[[0],", "[0,"), "positions: write 5 lists of numbers"),
    "short": (BEADS.replace(", [-1]]", "]"), "velocities: write 5 lists"),
    "dimension": (BEADS.replace("[[1],", "[[1, 0],"), "the velocity of particle 0 has 2"),
    "masses": (BEADS + "masses = [1, 1, 1]\n", "masses: write one for each particle, 5 in all"),
    "unknown": (BEADS + "radius = 1\n", "'radius' is not known; did you mean radii?"),
    "overlap": (BEADS.replace('"1.2"', '"0.9"'), "the particles 0 and 1 overlap"),
    "pair": (BEADS.replace('r = "0.03"', 'restitution = {"01" = "0.1"}'), "'01' is no pair"),
    "pairs": (BEADS.replace('r = "0.03"', 'restitution = {"0-1" = "0.1"}'), '"others" = "0.9"'),
    "r": (BEADS.replace("0.03", "1.5"), "r: '1.5' is not in (0, 1]"),
    "both": (BEADS + "restitution = 0.1\n", "the file has an r too"),
    "gravity": (BEADS + "gravity = 9.81\n", "gravity: write a number for each coordinate"),
    "gravity-dimension": (BEADS + "gravity = [0, 1]\n", "the gravity of particle 0 has 2"),
    "wall": (BEADS + "walls = [{normal = [1], level = -1}]\n", "wall 0: has not exactly"),
    "no-wall": (BEADS + "walls = [{normal = [0], level = -1, r = 0.5}]\n", "its normal is 0"),
    "in-a-wall": (
        BEADS + "walls = [{normal = [1], level = 0, r = 0.5}]\n",
        "the particle 0 overlaps wall 0",
    ),
    "wall-dimension": (
        BEADS + "walls = [{normal = [1, 0], level = -1, r = 0.5}]\n",
        "the normal of wall 0 of particle 0 has 2",
    ),
    "box": (BEADS + "box = [2]\n", "box: 2 is too short"),
    "box-and-walls": (BEADS + "box = [20]\nwalls = []\n", "the file has walls too"),
    "box-overlap": (BEADS + "box = [6]\n", "the particles 0 and 4 overlap"),
    "size": (BEADS + "box = [1e70]\n", "a number is beyond 10^60"),
}


@pytest.mark.parametrize("name", BAD)
def test_unusable_input_is_one_line(
    name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    text, why = BAD[name]
    check_refused(run(capsys, written(tmp_path, text)), why)


@pytest.mark.parametrize("name", ["a.csv", "a.xyz", "a.dump"])
def test_a_table_of_particles_is_no_scene(
    name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """The remedy is right: what it says is a scene file."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / name).write_text("x,y,vx,vy\n0,0,0,0\n2,0,-1,0\n5,0,0,0\n8,0,0,0\n")
    code, _, err = run(capsys, name)
    assert (code, err.count("\n")) == (2, 1)
    if name.endswith(".csv"):
        lines = err.partition("with the lines ")[2].strip().split(" and ")
        assert run(capsys, written(tmp_path, "\n".join(lines)))[0] == 0


def test_options_for_three_are_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = written(tmp_path, BEADS)
    for words in (["--digits", "3"], ["--cutoff", "1"], ["--plot", "a.svg"], ["--sample", "3"],
                  ["--trajectory", "t.csv"], ["--at", "a=1"], ["--until", "-1"]):  # fmt: skip
        check_refused(run(capsys, path, *words))


def test_a_folder_says_which_files_are_decided_alone(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    written(tmp_path, BEADS)
    code, out, _ = run(capsys, str(tmp_path), "--json")
    (found,) = json.loads(out)["scenes"]
    assert (code, found["verdict"]) == (2, "unusable")
    assert "verify scene FILE" in found["says"]
