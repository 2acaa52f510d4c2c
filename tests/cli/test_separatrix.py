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
from verify.views.separatrix import BELIEVED, NOT_DECIDED

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(autouse=True)
def wide(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("COLUMNS", "999")


def run(capsys: pytest.CaptureFixture[str], words: str) -> tuple[int, str]:
    code = main(["separatrix", *words.split()])
    out, err = capsys.readouterr()
    assert err == ""
    return code, out


def test_a_table(capsys: pytest.CaptureFixture[str]) -> None:
    code, out = run(capsys, "--r 3/100")
    assert code == 0
    assert "There is a separatrix: s + s² < a, where s³ = r and a = 0.515." in out
    assert "\n  0.1   0.0517785627618…    0.0504380529810…\n" in out
    assert "\n  0.45  0                   0\n" in out
    assert "q = 0.0669580098770… (a sink for two collisions), q = 0.448041990122…\n" in out
    assert "q = 0.0826667396695…, u = 0.0602643260923… (judge: interval Newton in balls)" in out
    last = out.splitlines()[-1]
    assert last.startswith("Verdict: proved: f is enclosed to 12 digits at 10 values of q (judge: ")
    assert "balls along monotone orbits" in last


def test_one_value_to_many_digits(capsys: pytest.CaptureFixture[str]) -> None:
    _, short = run(capsys, "--r 3/100 --at 1/10 --digits 12 --ratio 2/3")
    code, long = run(capsys, "--r 3/100 --at 1/10 --digits 40 --ratio 2/3")
    assert code == 0
    (line,) = (line for line in long.splitlines() if line.startswith("  0.1 "))
    assert len(line.split()[1]) == len("0.0…") + 40
    assert "\n  0.1  0.0643680809005…  " in short
    assert line.split()[1].startswith("0.0643680809005")


def test_where_there_is_none(capsys: pytest.CaptureFixture[str]) -> None:
    code, out = run(capsys, "--r 0.08")
    assert code == 0
    assert "There is no separatrix: a ≤ s + s², where s³ = r and a = 0.54. No orbit" in out
    assert "Verdict: proved: no orbit goes on for ever (judge: exact rational arithmetic)\n" in out
    found = document(capsys, "--r 0.08 --at 1/10")
    assert found["exists"] == {"answer": False, "judge": "exact rational arithmetic"}
    assert found["f"] == {"u": ["0", "0"], "phi_2": ["0", "0"]}


def test_a_budget_that_does_not_suffice(capsys: pytest.CaptureFixture[str]) -> None:
    code, out = run(capsys, "--r 0.05 --at 1/100 --budget 100")
    assert code == 3
    assert "\nVerdict: undecided: f is not known to 12 digits within the budget" in out
    assert "proved:" not in out
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


def test_what_is_not_decided_is_said(capsys: pytest.CaptureFixture[str]) -> None:
    for words in ("--r 3/100", "--r 0.08", "--r 0.03 --budget 9"):
        _, out = run(capsys, words)
        for number, text in enumerate(NOT_DECIDED, 1):
            assert f"\n  {number}. {text}\n" in out
        for number, text in enumerate(BELIEVED, 1):
            assert f"\n  {number}. {text}\n" in out
        assert document(capsys, words)["not_decided"] == list(NOT_DECIDED)
    assert any("the full dynamics" in text for text in NOT_DECIDED)
    assert any("verify/coq/Separatrix.v" in text for text in BELIEVED)


def test_the_theorem_for_all_parameters(capsys: pytest.CaptureFixture[str]) -> None:
    code, out = run(capsys, "--all")
    assert code == 0
    assert "Rows proved, of those needed: Separatrix 42/42." in out
    assert "\nCoq proves this without glue, and also that f is continuous" in out
    assert "\nVerdict: proved: Whatever lies below a state of the limit map" in out


def test_a_certificate_says_what_it_means(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    code, out = run(capsys, f"--r 3/100 --at 1/10 --digits 5 --out {tmp_path}/f")
    assert code == 0
    assert "Certificate (accepted by verify/check.py): The separatrix of the limit map at r" in out
    assert main(["check", f"{tmp_path}/f", "--statement"]) == 0
    checked = capsys.readouterr().out
    assert "ratio 1: f(0.1) lies between 0.05177856 and 0.05177857: " in checked
    assert "STATEMENT: it is the one that the program makes" in checked


def test_without_a_verdict_there_is_no_certificate(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    words = f"separatrix --r 0.05 --at 1/100 --budget 100 --out {tmp_path}/f"
    assert main(words.split()) == 3
    assert capsys.readouterr().err == "verify: f is undecided; no certificate was written\n"
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
    code, out = run(capsys, f"--r 0.03..0.09 --steps 3 --plot {tmp_path}/curves.svg")
    assert code == 0
    assert "\n  0.06  no curve\n" in out
    assert "\n  0.09  no curve\n" in out
    assert "Verdict: proved: 3 of 3 values of r (judges: " in out
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


@pytest.mark.parametrize(
    ("words", "says"),
    [
        ("--r 0.03..0.02", "--r: the interval '0.03..0.02' is not A < B; write the smaller end"),
        ("--r 0.01..0.02..0.03", "--r: '0.01..0.02..0.03' is no interval"),
        ("--r 0.01..2", "--r: '2' is not in ]0,1["),
        ("--r 0.01..0.02 --at 1/10", "--at: takes a single r"),
        ("--r 0.01..0.02 --out x", "--out: takes a single r"),
        ("--r 0.03 --out x", "--out: certifies f at one q; write for example --at 1/10"),
        ("--r 0.03 --steps 3", "--steps: has a meaning with --r A..B only"),
        ("--r 0.03 --at -1/10", "--at: '-1/10' is negative"),
        ("--r 0.03 --plot x.png", "--plot: 'x.png' does not end in .svg"),
        ("--r 0.08 --plot x.svg", "--plot: no curve is known there"),
        ("--r 0.07..0.08 --plot x.svg", "--plot: no curve is known there"),
        ("--r 0.03 --rows up", "--rows: has a meaning with --all only"),
        ("--r 0.03 -v", "--verbose: has a meaning with --all only"),
        ("--all --r 0.03", "--r: leave it out with --all"),
        ("--all --digits 3", "--digits: leave it out with --all"),
        ("", "--r: is missing; write for example --r 0.03, or --all"),
    ],
)
def test_one_line_says_what_to_write(
    words: str, says: str, capsys: pytest.CaptureFixture[str], tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:  # fmt: skip
    monkeypatch.chdir(tmp_path)
    assert main(["separatrix", *words.split()]) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert err.startswith(f"verify: {says}")
    assert err.count("\n") == 1
    assert list(tmp_path.iterdir()) == []


def test_what_is_too_long_for_the_checker_is_not_written(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    words = f"separatrix --r 0.03 --at 1/10 --digits 400 --out {tmp_path / 'x'}"
    assert main(words.split()) == 2
    assert capsys.readouterr().err.startswith("verify: --out: the orbits next to f are too long")
    assert list(tmp_path.iterdir()) == []


def test_a_point_run_loads_nothing_of_it() -> None:
    code = (
        "import sys; from verify.cli import main; main(['theorem1', '--r', '0.03']); "
        "print([name for name in sys.modules if 'spheres' in name])"
    )
    done = subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True)
    assert done.stdout.endswith("\n[]\n")
