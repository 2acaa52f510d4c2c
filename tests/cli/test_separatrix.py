"""`verify separatrix`: what it prints, its exit codes, and that nothing else becomes slower."""

from __future__ import annotations

import json
import subprocess
import sys
from fractions import Fraction
from pathlib import Path
from typing import Any

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


def test_a_point_run_loads_nothing_of_it() -> None:
    code = (
        "import sys; from verify.cli import main; main(['theorem1', '--r', '0.03']); "
        "print([name for name in sys.modules if 'spheres' in name])"
    )
    done = subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True)
    assert done.stdout.endswith("\n[]\n")
