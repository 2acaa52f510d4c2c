"""The command `classification` as scripts see it."""

from __future__ import annotations

import json
import random
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest

from tests.cli.running import check_refused, command, validator
from verify import check
from verify.cli import main
from verify.paper.commands import classification as job
from verify.paper.commands import pages
from verify.paper.source import PAPER
from verify.spheres.scene.decide import Budget, decide_scene
from verify.spheres.scene.scene_files import read_scene

COUNTS = {
    "0.072": "64",
    "0.0725": "35",
    "0.0735": "23",
    "3/40": "17",
    "8e-2": "11",
    "0.1": "7",
    "0.2": "4",
    "999/1000": "4",
    "1": "3",
}


run = command("classification")


def document(capsys: pytest.CaptureFixture[str], *words: str) -> dict[str, Any]:
    code, out, err = run(capsys, *words, "--json")
    assert (code, err) == (0, "")
    found: dict[str, Any] = json.loads(out)
    return found


def test_masses(capsys: pytest.CaptureFixture[str]) -> None:
    """The least r for which a ball between heavier ones is excluded rises as it gets lighter."""
    found = document(capsys, "--r", "0.3", "--masses", "1,2,3")
    validator("classification").validate(found)
    assert [one["collapse"] for one in found["middles"]] == ["excluded"] * 3
    light = document(capsys, "--r", "0.3", "--masses", "0.15,1,1")
    assert [one["collapse"] for one in light["middles"]] == ["not excluded", *["excluded"] * 2]
    assert not light["middles"][0]["comes_to_rest"]
    equal = document(capsys, "--r", "0.06", "--masses", "7,7,7")
    assert {(one["collapse"], one["comes_to_rest"]) for one in equal["middles"]} == {
        ("not excluded", True)
    }
    for masses in ("1,1,1", "1/1000,7,7", "5,1,1e-9", "1e12,1e-12,1"):
        elastic = document(capsys, "--r", "1", "--masses", masses)
        assert elastic["collapse"] == "excluded"
        assert [one["collapse"] for one in elastic["middles"]] == ["excluded"] * 3
    low, high = (Fraction(x) for x in equal["middles"][1]["largest_r"])
    assert (7 - low) ** 2 >= 48 >= (7 - high) ** 2


@pytest.mark.parametrize("r", ["0.3", "1/2", "0.9"])
def test_how_light_a_ball_must_be(capsys: pytest.CaptureFixture[str], r: str) -> None:
    """Between two of mass 1 it is excluded just if 2√r m > (1-√r)², at rest if r^(1/3) m > …²."""
    root = float(Fraction(r)) ** 0.5
    cube = float(Fraction(r)) ** (1 / 3)
    for most, name, value in (
        ((1 - root) ** 2 / (2 * root), "collapse", "excluded"),
        ((1 - cube) ** 2 / cube, "comes_to_rest", True),
    ):
        for factor in (0.999, 1.001):
            mass = f"{most * factor:.9f}"
            one = document(capsys, "--r", r, "--masses", f"{mass},1,1")["middles"][0]
            assert (one[name] == value) == (factor > 1)


@pytest.mark.parametrize(
    "words",
    [
        ["--r", "0.3", "--masses", "1,2"],
        ["--r", "0.3", "--masses", "1,2,0"],
        ["--r", "0.3", "--masses", "1,2,x"],
    ],
)
def test_masses_that_are_refused(capsys: pytest.CaptureFixture[str], words: list[str]) -> None:
    check_refused(run(capsys, *words), "--masses")


def collisions(share: Fraction, r: Fraction) -> int:
    """By the law of collision on a line, one after another; s_n is divided by √M if n is even."""
    before, now, count = Fraction(0), Fraction(1), 0
    while now > 0:
        factor = (1 + r) ** 2 * share if count % 2 else Fraction(1)
        before, now, count = now, factor * now - r * before, count + 1
    return count


def test_where_the_number_of_collisions_changes(capsys: pytest.CaptureFixture[str]) -> None:
    found = document(capsys, "--masses", "1,1,1")
    validator("classification").validate(found)
    told = [(one["collisions"], one["exact"]) for one in found["middles"][0]["on_a_line"]]
    assert told[:2] == [(2, "1"), (3, "3-2√2")]
    rng = random.Random(43)
    for _ in range(20):
        masses = [Fraction(rng.randint(1, 99), 10 ** rng.randint(0, 2)) for _ in range(3)]
        found = document(capsys, "--masses", ",".join(map(str, masses)))
        for about in found["middles"]:
            share, o = Fraction(about["share"]), about["ball"]
            m, one, two = masses[o], *(masses[:o] + masses[o + 1 :])
            assert share == one * two / ((m + one) * (m + two))
            for part in about["on_a_line"]:
                low, high = map(Fraction, part["least_r"])
                near = Fraction(1, 10**9)
                assert collisions(share, low * (1 - near)) == part["collisions"] + 1
                if high <= 1 / (1 + near):
                    assert collisions(share, high * (1 + near)) == part["collisions"]


def test_scenes_beside_a_threshold_have_so_many_collisions(tmp_path: Path) -> None:
    """One of mass 3 hits two at rest, of masses 2 and 1: on both sides of two thresholds."""
    about = job.on_a_line((Fraction(2), Fraction(3), Fraction(1)))[0]
    for part in about.counts[1:3]:
        low, high = part.least_r
        for r, count in (
            (high * Fraction(1001, 1000), part.collisions),
            (low * Fraction(999, 1000), part.collisions + 1),
        ):
            scene = tmp_path / "scene.toml"
            scene.write_text(
                f'r = "{r.limit_denominator(10**9)}"\nmasses = [2, 3, 1]\n'
                "positions = [[2, 0], [0, 0], [4, 0]]\nvelocities = [[0, 0], [1, 0], [0, 0]]\n"
            )
            fate = decide_scene(
                read_scene("scene", scene.read_bytes()), Budget(100, None, 128, 512)
            )
            assert fate.collisions == count


def test_every_row(capsys: pytest.CaptureFixture[str]) -> None:
    _, out, _ = run(capsys, "-v")
    for row in pages.decide("classification").statement.obligations:
        assert f"[{row.name}, {PAPER.cited(row.label)}]" in out


@pytest.mark.parametrize(("r", "count"), COUNTS.items())
def test_the_longest_run(capsys: pytest.CaptureFixture[str], r: str, count: str) -> None:
    found = document(capsys, "--r", r)
    assert (found["longest_run"], found["collapse"]) == (count, "excluded")
    low, high = map(Fraction, found["least_neg_cos"])
    value = Fraction(found["r"])
    assert 1 < low <= high
    # The bound is 4 sqrt(r)/(1+r).
    assert low**2 <= 16 * value / (1 + value) ** 2 <= high**2
    assert high - low < low * Fraction(1, 10**25)


@pytest.mark.parametrize("r", ["0.0717967697244908", "1/20", "1e-9"])
def test_below_the_threshold(capsys: pytest.CaptureFixture[str], r: str) -> None:
    found = document(capsys, "--r", r)
    assert (found["longest_run"], found["collapse"]) == ("infinite", "not excluded")
    assert Fraction(found["least_neg_cos"][0]) < 1


def test_too_much_work_is_undecided(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(job, "BUDGET", 10**4)
    code, out, err = run(capsys, "--r", "0.072", "--json")
    assert (code, err) == (3, "")
    document = json.loads(out)
    assert (document["longest_run"], document["verdict"]) == (None, "undecided")
    assert run(capsys, "--r", "0.072")[0] == 3


def test_the_count_is_that_of_the_cosine() -> None:
    # s_n is r^((n-1)/2) sin(n phi)/sin(phi), cos(phi) = (1+r)/(4 sqrt r).
    from mpmath import acos, ceil, mpf, pi, sqrt

    for k in range(72, 990, 7):
        r = Fraction(k, 1000)
        x = mpf(k) / 1000
        assert job.longest_run(r) == int(ceil(pi / acos((1 + x) / (4 * sqrt(x)))))


def test_the_files(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    code, _, err = run(capsys, "--out", str(tmp_path / "new"))
    assert (code, err) == (0, "")
    files = {"statement.json", "certificate.json", "check.py", "report.html"}
    assert {p.name for p in (tmp_path / "new").iterdir()} == files
    assert check.main([str(tmp_path / "new")]) == 0
    assert main(["check", "--statement", str(tmp_path / "new")]) == 0


@pytest.mark.parametrize("text", ["0", "1.001", "-0.1", "2", "x", "", "nan", "1/0", "0.02..0.04"])
def test_input_errors(capsys: pytest.CaptureFixture[str], text: str) -> None:
    check_refused(run(capsys, f"--r={text}"), "verify: --r: ")


@pytest.mark.parametrize("words", [["--all"], ["word"], ["--r"], ["--r", "0.1", "--r", "0.2"]])
def test_unknown_options(capsys: pytest.CaptureFixture[str], words: list[str]) -> None:
    check_refused(run(capsys, *words))
