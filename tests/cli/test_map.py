"""`verify map`: the areas, the files, and one line about what cannot be used."""

from __future__ import annotations

import json
import os
import re
import resource
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from fractions import Fraction
from itertools import combinations
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import pytest

from tests.check.test_check_map import sealed
from tests.cli.running import validator
from verify import check_map
from verify.cli import main

ROOT = Path(__file__).resolve().parents[2]
PLANE = ["map", "phi", "--r", "0.03"]
#: What cannot be used, and the option that is named.
WRONG = {
    "--r": ["map", "phi", "--r", "1"],
    "--x, --y": [*PLANE, "--x", "-1..1"],
    "plane": ["map", "psi", "--r", "0.03"],
    "--neg-cos": [*PLANE, "--neg-cos", "1.1"],
    "--x": [*PLANE, "--x", "1..0"],
    "--y": [*PLANE, "--y", "0.1"],
    "--speed": [*PLANE, "--speed", "0"],
    "--tangential": [*PLANE, "--tangential", "1"],
    "--undecided": [*PLANE, "--undecided", "200%"],
    "--boxes": [*PLANE, "--boxes", "0"],
    "--strip": [*PLANE, "--strip", "1"],
    "--level": [*PLANE, "--level", "99"],
    "--jobs": [*PLANE, "--jobs", "0"],
    "--dask": [*PLANE, "--dask", "tcp://127.0.0.1:1"],
}


@pytest.mark.parametrize("option", WRONG)
def test_one_line_about_unusable_input(option: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(WRONG[option]) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert err.startswith(f"verify: {option}: ")
    assert err.count("\n") == 1


def test_the_document(capsys: pytest.CaptureFixture[str]) -> None:
    assert main([*PLANE, "--undecided", "5%", "--json"]) == 0
    document = json.loads(capsys.readouterr().out)
    validator("map").validate(document)
    areas = {name: Fraction(share) for name, share in document["areas"].items()}
    assert sum(areas.values()) == 1
    assert 0 < areas["undecided"] <= Fraction(1, 20)
    assert min(areas.values()) > 0
    assert document["judged_by"] == "verify/check_map.py"
    assert document["cites"] == ["flow", "sharper"]


def test_a_plane_through_a_scene(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    scene = str(ROOT / "certificates/scenes/nearly-aligned.toml")
    command = ["map", scene, "--x", "velocities[2][0]=-1.5..0", "--y", "velocities[2][1]=-1..1"]
    assert main([*command, "--undecided", "5%", "--out", str(tmp_path), "--json"]) == 0
    document = json.loads(capsys.readouterr().out)
    validator("map").validate(document)
    assert check_map.main([str(tmp_path / "map.jsonl")]) == 0
    wrong = {
        "--x": [*command[:3], "velocities[2][2]=0..1", *command[4:]],
        "--y": [*command[:5], command[3]],
        "--r": [*command, "--r", "0.03"],
        "plane": ["map", "certificates"],
    }
    capsys.readouterr()
    for option, words in wrong.items():
        assert main(words) == 2
        assert capsys.readouterr().err.startswith(f"verify: {option}: ")


def test_a_strip(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("verify.cli.map.STRIP_LEVEL", 3)
    monkeypatch.setattr("verify.cli.map.BANDS_BELOW", 3)
    command = [*PLANE, "--x", "0.1..0.11", "--strip", "1e-3", "--json", "--out", str(tmp_path)]
    assert main([*command, "--show-boxes"]) == 0
    no_words_meet(ElementTree.parse(tmp_path / "map.svg").getroot())
    document = json.loads(capsys.readouterr().out)
    validator("map").validate(document)
    assert document["strip"] == {"delta": "1/1000", "from": "1/10", "to": "11/100"}
    assert document["areas"]["undecided"] == "1/125"
    assert check_map.main([str(tmp_path / "map.jsonl")]) == 0
    assert "every such state with 0 < φ2 <= f - δ collapses" in capsys.readouterr().out
    # A budget that is spent leaves no strip, and no border is no curve.
    assert main([*command[:-5], "--strip", "1e-7", "--boxes", "9", "--json"]) == 3
    assert json.loads(capsys.readouterr().out)["strip"] is None
    assert main([*PLANE, "--x", "0.1..0.11", "--y", "0..1/100", "--strip", "1e-4"]) == 2
    assert capsys.readouterr().err.startswith("verify: --strip: no border")


@pytest.mark.parametrize(("r", "where"), [("0.05", "1/100..0.332"), ("0.07", "another")])
def test_a_strip_where_there_is_no_border(
    r: str, where: str, capsys: pytest.CaptureFixture[str]
) -> None:
    """Above 9-4√5 there is none at all; below it, an interval is proposed."""
    assert main(["map", "phi", "--r", r, "--strip", "1e-4"]) == 2
    assert f"; write --x {where}" in capsys.readouterr().err.replace(
        "write another", "write --x another"
    )


def test_a_spent_budget(capsys: pytest.CaptureFixture[str]) -> None:
    assert main([*PLANE, "--undecided", "0.1%", "--boxes", "300"]) == 3
    printed = capsys.readouterr().out
    assert "undecided" in printed
    assert "a saddle at φ1 = 0.082666739669" in printed


def place_of(text: ElementTree.Element) -> tuple[tuple[float, float], tuple[float, float]]:
    """About where a text of the picture stands, from left to right and from top to bottom."""
    x, y, length = (
        float(text.attrib["x"]),
        float(text.attrib["y"]),
        7.5 * len("".join(text.itertext())),
    )
    x -= {"start": 0.0, "middle": length / 2, "end": length}[text.get("text-anchor", "start")]
    return (x - 2, x + length + 2), (y - 10, y + 3)


def no_words_meet(image: ElementTree.Element) -> None:
    """All words of a picture stand within it, and none on another one."""
    width = float(image.attrib["viewBox"].split()[2])
    for part in (image, *image.iterfind("{*}g")):  # the words above, and the panels
        left = float(re.split(r"[( ]", part.get("transform", "translate(0 0)"))[1])
        texts = [text for text in part.iterfind("{*}text") if "x" in text.attrib]
        assert texts
        for one, other in combinations(map(place_of, texts), 2):
            assert any(b <= c or d <= a for (a, b), (c, d) in zip(one, other, strict=True))
        for text in texts:
            (begin, end), _ = place_of(text)
            assert left + begin >= 0
            assert left + end - 8 <= width, "".join(text.itertext())


def test_the_files(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    command = [*PLANE, "--undecided", "4%", "--out", str(tmp_path / "new")]
    assert main(command) == 0
    printed = capsys.readouterr().out
    files = {path.name: path.read_bytes() for path in (tmp_path / "new").iterdir()}
    assert {*files} == {"map.jsonl", "map.json", "map.svg", "map.png", "times.csv"}
    assert check_map.main([str(tmp_path / "new/map.jsonl")]) == 0
    assert capsys.readouterr().out.startswith("PROVED")
    image = ElementTree.fromstring(files["map.svg"])
    assert image.tag.endswith("svg")
    assert files["map.png"].startswith(b"\x89PNG")
    # A run that stopped and went on draws the same picture, in which no CPU time is seen.
    assert main([*PLANE, "--undecided", "30%", "--out", str(tmp_path / "other")]) == 0
    assert main([*PLANE, "--undecided", "4%", "--out", str(tmp_path / "other")]) == 0
    for name in ("map.jsonl", "map.json", "map.svg", "map.png"):
        assert (tmp_path / "other" / name).read_bytes() == files[name]
    words = ["".join(item.itertext()) for item in image.iter() if item.tag.endswith("text")]
    assert {"0", "0.1", "0.5", "0.05"} <= set(words)
    assert "boxes looked at" not in words  # which is for those who look at boxes
    no_words_meet(image)
    capsys.readouterr()
    # Once more changes nothing, and a smaller share goes on.
    assert main(command) == 0
    assert capsys.readouterr().out == printed
    assert {p.name: p.read_bytes() for p in (tmp_path / "new").iterdir()} == files
    command[command.index("4%")] = "3%"
    assert main([*command, "--show-boxes"]) == 0
    assert (tmp_path / "new/map.jsonl").read_bytes().startswith(files["map.jsonl"])
    with_boxes = (tmp_path / "new/map.svg").read_text(encoding="utf-8")
    assert with_boxes.count("M") > 300
    assert "boxes looked at" in with_boxes
    assert ">10²<" in with_boxes
    no_words_meet(ElementTree.fromstring(with_boxes))
    assert re.search("η<tspan [^>]*>c</tspan><tspan [^>]*>²", with_boxes)
    assert ">slope −1<" in with_boxes
    # Nor is the log of another map overwritten.
    assert main(["map", "phi", "--r", "0.04", "--out", str(tmp_path / "new")]) == 2
    assert "no log of this map" in capsys.readouterr().err


def refuse(*_: object, **__: object) -> None:
    raise check_map.RefusedError("nothing is decided")


def areas_of_nothing(*_: object, **__: object) -> tuple[None, check_map.Areas]:
    return None, check_map.Areas(256, 0, Fraction(0), Fraction(0))


@pytest.mark.parametrize(("judge", "code"), [(refuse, 5), (areas_of_nothing, 3)])
@pytest.mark.parametrize("kind", ["", "--out", "--json", "--strip"])
def test_a_judge_that_decides_nothing(
    judge: Callable[..., Any],
    code: int,
    kind: str,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """There is no verdict then, on the screen or in a file."""
    monkeypatch.setattr(check_map, "check_log", judge)
    monkeypatch.setattr("verify.cli.map.STRIP_LEVEL", 3)
    monkeypatch.setattr("verify.cli.map.BANDS_BELOW", 3)
    more = {"--out": [str(tmp_path / "out")], "--strip": ["1e-3", "--x", "0.1..0.11"]}
    command = [*PLANE, "--undecided", "10%"][: 4 if kind == "--strip" else 6]
    assert main([*command, *([kind] if kind else []), *more.get(kind, [])]) == code
    printed = capsys.readouterr().out
    written = [p.read_text(encoding="utf-8") for p in tmp_path.rglob("map.json")]
    for text in (printed, *written):
        found = json.loads(text).get("areas", {}) if text.startswith("{") else {}
        assert {found.pop(name, "0") for name in ("collapses", "disperses")} == {"0"}
        assert text.startswith("{") or not re.search("collapse|disperse|no two spheres", text)


def test_a_log_whose_verdicts_were_changed(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Also if its digests fit."""
    command = [*PLANE, "--undecided", "4%", "--out", str(tmp_path)]
    assert main(command) == 0
    log = tmp_path / "map.jsonl"
    content = [json.loads(line) for line in log.read_bytes().splitlines()]
    for line in content[1:]:
        line["verdicts"], line["numbers"] = line["verdicts"].replace("c", "d"), []
    log.write_bytes(b"".join(sealed(content)))
    before = {path.name: path.read_bytes() for path in tmp_path.iterdir()}
    capsys.readouterr()
    for words in (command, [*command, "--boxes", "1"]):
        assert main(words) == 2
        out, err = capsys.readouterr()
        assert out == ""
        assert "is refused by verify/check_map.py (box" in err
        assert err.count("\n") == 1
    after = {path.name: path.read_bytes() for path in tmp_path.iterdir()}
    assert {name for name in after if after[name] != before[name]} <= {"map.jsonl"}


BROKEN: dict[str, Callable[[dict[str, Any]], object]] = {
    "no-verdict": lambda c: c.update(verdicts=c["verdicts"].replace("c", "q")),
    "a-list": lambda c: c.update(verdicts=list(c["verdicts"])),
    "numbers": lambda c: c.update(numbers=[]),
    "no-numbers": lambda c: c.update(numbers=5),
    "another-key": lambda c: c.update(keys="1" * 50 + c["keys"][4:]),
    "one-key-more": lambda c: c.update(keys=c["keys"] + " 00", verdicts=c["verdicts"] + "u"),
}


@pytest.mark.parametrize("name", BROKEN)
def test_a_log_with_a_line_that_is_none(
    name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    command = [*PLANE, "--undecided", "10%", "--out", str(tmp_path)]
    assert main(command) == 0
    log = tmp_path / "map.jsonl"
    content = [json.loads(line) for line in log.read_bytes().splitlines()]
    BROKEN[name](content[1])
    log.write_bytes(b"".join(sealed(content)))
    capsys.readouterr()
    assert main(command) == 2
    assert "is no log of this map (a line" in capsys.readouterr().err


def test_a_folder_that_cannot_be_written(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "file").write_text("")
    assert main([*PLANE, "--out", str(tmp_path / "file")]) == 2
    assert "--out" in capsys.readouterr().err


EXTREME = {
    "phi": [*PLANE, "--tangential", "1e39,1e-39"],
    "r": ["--x", "r=1e-39..1", "--y", "h=-1e39..1e39", "--at", "w=1e39"],
    "r above 1": ["--x", "h=-2..0", "--y", "r=11/12..3", "--at", "w=1"],
    "h": ["--x", "h=-1e39..1e39", "--y", "w=1e-39..1e-38", "--at", "r=1e-20"],
}


@pytest.mark.parametrize("name", EXTREME)
def test_numbers_of_which_the_checker_knows_less_than_doubles(name: str, tmp_path: Path) -> None:
    """A box that only doubles decide is undecided, and no error of our own."""
    path, words = tmp_path / "f.toml", EXTREME[name]
    path.write_text(
        'r = "1e-39..3"\npositions = [[0, 0], ["1.01", 0], ["-1.02", "h"]]\n'
        'velocities = [[0, 0], [-1, "w"], [1, "-w/2"]]\n'
        '[parameters]\nh = "-1e39..1e39"\nw = "-1e39..1e39"\n'
    )
    words = words if name == "phi" else ["map", str(path), *words]
    assert main([*words, "--boxes", "50"]) in (0, 3)


@pytest.mark.parametrize(
    ("words", "option"),
    {
        "--x h=0..2": "--x",
        "--x r=0.02..0.03 --at h=1.01": "--at",
        "--x h=0..1 --y r=0.001..0.03": "--y",
    }.items(),
)
def test_no_map_leaves_the_intervals_of_its_file(
    words: str, option: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "f.toml"
    path.write_text(
        'r = "0.01..0.05"\nparameters = { h = "0..1" }\n'
        'positions = [[0, 0], [1.1, 0], [-1.1, "h"]]\n'
        "velocities = [[0, 0], [-1, 0], [1, 0]]\n"
    )
    assert main(["map", str(path), *words.split(), "--boxes", "1"]) == 2
    assert capsys.readouterr().err.startswith(f"verify: {option}: ")
    assert main(["map", str(path), "--x", "h=0..1/2", "--at", "r=0.02", "--boxes", "1"]) != 2


@pytest.mark.parametrize("most", [1, 100, 1000, 5000])
def test_a_full_disk_is_told_and_leaves_whole_lines(most: int, tmp_path: Path) -> None:
    """A file may have so many bytes: what does not fit is not there, and not called the output."""
    done = subprocess.run(
        [sys.executable, "-m", "verify", *PLANE, "--out", str(tmp_path / "out")],
        capture_output=True,
        text=True,
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (most, most)),
        check=False,
    )
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr.startswith("verify: --out: ")
    log = tmp_path / "out" / "map.jsonl"
    assert log.read_bytes().endswith(b"\n") if most >= 1000 else not log.parent.exists()


def test_ctrl_c_keeps_what_was_proved(tmp_path: Path) -> None:
    command = [sys.executable, "-m", "verify", *PLANE, "--undecided", "0.01%", "--jobs", "2"]
    log = tmp_path / "out" / "map.jsonl"
    with subprocess.Popen(
        [*command, "--out", str(tmp_path / "out")],
        cwd=ROOT,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        start_new_session=True,
    ) as process:
        limit = time.monotonic() + 60
        while not log.exists() or log.read_bytes().count(b"\n") < 8:
            assert time.monotonic() < limit
            time.sleep(0.02)
        os.killpg(process.pid, signal.SIGINT)
        out, err = process.communicate(timeout=60)
    assert (process.returncode, out, err) == (130, b"", b"verify: interrupted\n")
    assert log.read_bytes().count(b"\n") >= 8
    assert log.read_bytes().endswith(b"\n")
    with log.open("rb") as file:
        assert check_map.check_log(line for line, _ in zip(file, range(6), strict=False))


def test_of_two_runs_with_one_folder_the_second_is_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Both wrote into one log, which was then refused; after a kill another run goes on."""
    command = [*PLANE, "--jobs", "2", "--out", str(tmp_path / "out")]
    log = tmp_path / "out" / "map.jsonl"
    with subprocess.Popen(
        [sys.executable, "-m", "verify", *command, "--undecided", "0.01%"], cwd=ROOT
    ) as process:
        limit = time.monotonic() + 60
        while not log.exists() or log.read_bytes().count(b"\n") < 8:
            assert time.monotonic() < limit
            time.sleep(0.02)
        assert main([*command, "--undecided", "10%"]) == 2
        assert "another process is writing it" in capsys.readouterr().err
        process.kill()
    assert main([*command, "--undecided", "10%"]) == 0
    with log.open("rb") as file:
        assert check_map.check_log(iter(file))


def test_a_log_that_is_a_pipe_is_named(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The line says why; it said None."""
    os.mkfifo(tmp_path / "map.jsonl")
    code = main(["map", "phi", "--r", "0.03", "--undecided", "30%", "--out", str(tmp_path)])
    captured = capsys.readouterr()
    assert (code, captured.out) == (2, "")
    assert "cannot be written" in captured.err
    assert "None" not in captured.err


def test_times_that_are_none_are_left_out(tmp_path: Path) -> None:
    words = [*PLANE, "--boxes", "300", "--undecided", "0", "--out", str(tmp_path / "m")]
    code = main(words)
    assert code in (0, 3)
    with (tmp_path / "m/times.csv").open("a") as file:
        file.write("256,1/0,3\n")
    assert main(words) == code


def test_a_log_that_is_a_device_is_not_read(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "map.jsonl").symlink_to("/dev/zero")
    assert main([*PLANE, "--boxes", "300", "--out", str(tmp_path)]) == 2
    assert "it is a device" in capsys.readouterr().err
