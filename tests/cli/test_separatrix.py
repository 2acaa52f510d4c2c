"""`verify separatrix`: what it prints, its exit codes, and that nothing else becomes slower."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from fractions import Fraction
from itertools import combinations, pairwise
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import pytest

from verify.cli import main
from verify.paper.commands import separatrix

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(autouse=True)
def wide(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("COLUMNS", "999")


def run(capsys: pytest.CaptureFixture[str], words: str) -> tuple[int, str]:
    code = main(["separatrix", *words.split()])
    out, err = capsys.readouterr()
    assert err == ""
    return code, out


def test_one_value_to_many_digits(capsys: pytest.CaptureFixture[str]) -> None:
    _, short = run(capsys, "--r 3/100 --at 1/10 --digits 12 --ratio 2/3")
    code, long = run(capsys, "--r 3/100 --at 1/10 --digits 40 --ratio 2/3")
    assert code == 0
    (line,) = (line for line in long.splitlines() if line.startswith("  0.1 "))
    assert len(line.split()[1]) == len("0.0…") + 40
    assert "\n  0.1  0.0643680809005…  " in short
    assert line.split()[1].startswith("0.0643680809005")


def test_where_there_is_none(capsys: pytest.CaptureFixture[str]) -> None:
    found = document(capsys, "--r 0.08 --at 1/10")
    assert found["exists"] == {"answer": False, "judge": "exact rational arithmetic"}
    assert found["f"] == {"u": ["0", "0"], "phi_2": ["0", "0"]}


def test_other_masses_and_radii(capsys: pytest.CaptureFixture[str]) -> None:
    words = "--r 3/100 --at 1/10 --masses 1,5,0.5 --radii 0.5,1,0.25"
    found = document(capsys, words)
    assert found["verdict"] == "proved"
    assert found["parameters"]["masses"] == ["1", "5", "1/2"]
    assert found["parameters"]["radii"] == ["1/2", "1", "1/4"]
    code, out = run(capsys, words)
    assert code == 0
    assert "masses 1, 5, 0.5, radii 0.5, 1, 0.25: proved" in out
    assert "q is 1.5811388… times φ₁" in out


@pytest.mark.parametrize("words", ["--masses 1,2", "--masses 1,0,2", "--radii 1,2,x", "--radii 1"])
def test_balls_that_are_none(words: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["separatrix", "--r", "0.03", *words.split()]) == 2
    assert words.split()[0] in capsys.readouterr().err


def test_a_budget_that_does_not_suffice(capsys: pytest.CaptureFixture[str]) -> None:
    known = document(capsys, "--r 0.05 --at 1/100")
    found = document(capsys, "--r 0.05 --at 1/100 --budget 100")
    assert (known["verdict"], found["verdict"]) == ("proved", "undecided")
    (low, high), (least, most) = (map(Fraction, d["f"]["u"]) for d in (known, found))
    assert 0 < least < low < high < most


def document(capsys: pytest.CaptureFixture[str], words: str) -> dict[str, Any]:
    _, out = run(capsys, f"{words} --json")
    found: dict[str, Any] = json.loads(out)
    return found


def test_the_paper_s_letter(capsys: pytest.CaptureFixture[str]) -> None:
    """φ₂ is u (2-u) / 2; ends are rounded outward."""
    found = document(capsys, "--r 3/100")
    for row in found["table"]:
        (low, high), ends = (map(Fraction, row["f"][name]) for name in ("u", "phi_2"))
        for u, phi in zip((low, high), ends, strict=True):
            assert abs(u * (2 - u) / 2 - phi) < Fraction(1, 10**15)


def test_a_certificate_says_what_it_means(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    code, _ = run(capsys, f"--r 3/100 --at 1/10 --digits 5 --out {tmp_path}/f")
    assert code == 0
    assert main(["check", f"{tmp_path}/f", "--statement"]) == 0
    assert "f(0.1) lies between 0.05177856 and 0.05177857: " in capsys.readouterr().out


def test_without_a_verdict_there_is_no_certificate(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    words = f"separatrix --r 0.05 --at 1/100 --budget 100 --out {tmp_path}/f"
    assert main(words.split()) == 3
    assert capsys.readouterr().err.count("\n") == 1
    assert not (tmp_path / "f").exists()


def test_the_picture_of_the_page_is_the_one_that_is_drawn(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    code, _ = run(capsys, f"--r 3/100 --plot {tmp_path}/strip.svg")
    assert code == 0
    page = ROOT / "docs/explanation/separatrix.svg"
    assert (tmp_path / "strip.svg").read_bytes() == page.read_bytes()
    for words in ("φ₁", "saddle", "φ⁻", "φ⁺", "prefers-color-scheme:dark"):
        assert words in page.read_text(encoding="utf-8")
    texts = ["".join(text.itertext()) for text in ElementTree.parse(page).iterfind("{*}g/{*}text")]
    assert "φ₂ |Wc|²" in texts
    assert re.search('W<tspan dy="[0-9]" [^>]*>c</tspan>', page.read_text(encoding="utf-8"))


@pytest.mark.parametrize("r", ["0.0001", "0.055"])
def test_words_in_the_picture_stand_beside_each_other(
    r: str, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    """And beside the marks; where the saddle is next to φ⁻, and φ⁻ next to the vertical axis."""
    run(capsys, f"--r {r} --plot {tmp_path}/strip.svg")
    panel = ElementTree.parse(tmp_path / "strip.svg").getroot().find("{*}g")
    assert panel is not None
    places = []
    for text in panel.iterfind("{*}text[@x]"):
        x, y, words = float(text.attrib["x"]), float(text.attrib["y"]), "".join(text.itertext())
        x -= (
            8 * len(words) * {"start": 0, "middle": 0.5, "end": 1}[text.get("text-anchor", "start")]
        )
        rim = 2 if "stroke" in text.attrib else 0
        places.append((words, x - rim, x + 8 * len(words) + rim, y - 10 - rim, y + rim))
    for path in panel.iterfind(".//{*}path[@transform]"):
        x, y = map(float, path.attrib["transform"][len("translate(") : -1].split())
        places.append(("a mark", x - 4, x + 4, y - 4, y + 4))
    assert {"φ⁻", "φ⁺", "saddle", "a mark"} <= {words for words, *_ in places}
    for (one, a, b, c, d), (other, e, f, g, h) in combinations(places, 2):
        marks = one == other == "a mark"
        assert marks or b <= e or f <= a or d <= g or h <= c, (one, other)


def test_curves_for_several_r(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    code, _ = run(capsys, f"--r 0.03..0.09 --steps 3 --plot {tmp_path}/curves.svg")
    assert code == 0
    text = (tmp_path / "curves.svg").read_text(encoding="utf-8")
    assert "r = 0.03<" in text
    assert "no curve at r = 0.06, 0.09<" in text
    run(capsys, f"--r 0.01..0.055 --steps 9 --plot {tmp_path}/nine.svg")
    text = (tmp_path / "nine.svg").read_text(encoding="utf-8")
    assert "r = 0.015625<" in text  # exact, not shortened
    assert "no curve" not in text
    strokes = re.findall(r'<path d="[^"]+" fill="none" (stroke="[^>]+)/>', text)
    assert len(set(strokes)) == 9 + 1  # and the axes
    dashes = [
        re.sub('.*dasharray="|".*', "", s) if "dash" in s else "" for s in strokes if "1.4" in s
    ]
    assert all(one != next_one for one, next_one in pairwise(dashes))  # also without colours
    run(capsys, f"--r 0.01..0.05 --plot {tmp_path}/five.svg")
    text = (tmp_path / "five.svg").read_text(encoding="utf-8")
    places = re.findall(r'x="([\d.]+)" y="([\d.]+)"[^>]*>r = 0.0\d<', text)
    assert len(places) == 5
    for (x, y), (u, v) in combinations([tuple(map(float, place)) for place in places], 2):
        assert abs(x - u) > 80 or abs(y - v) > 15  # no name stands on another one


def test_what_is_too_long_for_the_checker_is_not_written(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """The verdict stands, and why there is no certificate."""
    monkeypatch.setattr(separatrix, "MAX_ROWS", 9)
    words = f"separatrix --r 0.03 --at 1/10 --out {tmp_path / 'x'}"
    assert main(words.split()) == 0
    out, err = capsys.readouterr()
    assert "Verdict: proved: f is enclosed to 12 digits" in out
    assert "no certificate was written: the orbits" in err
    assert "fewer --digits, and write --r and the other numbers with fewer" in err
    assert list(tmp_path.iterdir()) == []


def test_a_point_run_loads_nothing_of_it() -> None:
    """Of the spheres it has their parameters only."""
    code = (
        "import sys; from verify.cli import main; main(['theorem1', '--r', '0.03']); "
        "print([name for name in sys.modules if 'spheres' in name])"
    )
    done = subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True)
    assert done.stdout.endswith("\n['verify.spheres', 'verify.spheres.parameters']\n")


def test_many_unlike_balls_have_a_certificate(tmp_path: Path) -> None:
    words = "separatrix --r 9/10 --masses 1/812500,29/49,7/200 --radii 8/3,8600,31/500000"
    folder = str(tmp_path / "out")
    assert main([*words.split(), *f"--at 19992901/20000000 --digits 8 --out {folder}".split()]) == 0
    assert main(["check", "--statement", folder]) == 0
