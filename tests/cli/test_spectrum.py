"""The command `spectrum` as scripts see it."""

from __future__ import annotations

import os
import subprocess
import sys
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest

from tests.cli.running import check_refused, command, parsed
from tests.paper.spectrum.page import with_a_broken_entry
from verify import check
from verify.paper.commands import spectrum

ROOT = Path(__file__).resolve().parents[2]
CLAIM_KEYS = {
    "name", "group", "label", "role", "severity", "says", "claim", "statement", "verdict",
    "method", "bits", "uses",
}  # fmt: skip


run = command("spectrum")


def document(capsys: pytest.CaptureFixture[str], *words: str) -> dict[str, Any]:
    code, out, err = run(capsys, *words, "--json")
    assert (code, err) == (0, "")
    found: dict[str, Any] = parsed(out)
    return found


def test_every_row(capsys: pytest.CaptureFixture[str]) -> None:
    _, out, _ = run(capsys, "-v")
    for row in spectrum.cite_spectrum().statement.obligations:
        assert f"[{row.name}, " in out


def test_the_document(capsys: pytest.CaptureFixture[str]) -> None:
    found = document(capsys)
    about = {"format", "command", "verdict", "headline", "theorem", "assumptions", "claims"}
    assert set(found) == about
    assert (found["format"], found["command"]) == ("verify-spectrum/1", "spectrum")
    assert (found["verdict"], found["headline"]) == ("proved", "proved")
    names = {claim["name"]: claim for claim in found["claims"]}
    for claim in found["claims"]:
        assert set(claim) >= CLAIM_KEYS
        assert claim["role"] in ("printed", "needed")
        assert claim["verdict"] in ("proved", "refuted", "remark")
        if claim["verdict"] != "proved":
            assert set(claim) - {"lhs", "rhs"} == {
                *CLAIM_KEYS,
                "judged_by",
                "witness",
                "corrected_by",
            }
            assert {str(Fraction(value)) for value in claim["witness"].values()}
            correction = names[claim["corrected_by"]]
            assert (correction["role"], correction["verdict"]) == ("needed", "proved")


def test_the_document_at_one_r(capsys: pytest.CaptureFixture[str]) -> None:
    found = document(capsys, "--r", "1/20")
    assert found["r"] == "1/20"
    values = found["eigenvalues"]
    assert [Fraction(end) for end in values["lambda_0"]] == [Fraction(-1, 125)] * 2
    assert values["lambda_0_exact"] == "-1/125"
    assert set(values["lambda_plus"]) == {"re", "im", "abs", "arg"}
    for low, high in values["lambda_plus"].values():
        assert Fraction(high) - Fraction(low) <= abs(Fraction(low)) * Fraction(1, 10**25)
    # At r = 1/20 the modulus is exactly 1/8.
    low, high = map(Fraction, values["lambda_plus"]["abs"])
    assert low <= Fraction(1, 8) <= high
    assert set(found["eigenvectors"]) == {"1", "lambda_0", "lambda_plus"}
    assert {len(vector) for vector in found["eigenvectors"].values()} == {4}


@pytest.mark.parametrize("r", ["1e-50", "0.9999999999999999999999999999990", "0.03", "0.0718"])
def test_widths_at_the_default_precision(capsys: pytest.CaptureFixture[str], r: str) -> None:
    found = document(capsys, "--r", r)
    pairs = [found["eigenvalues"]["lambda_0"], *found["eigenvalues"]["lambda_plus"].values()]
    for low, high in pairs:
        assert Fraction(low) <= Fraction(high)
        assert Fraction(high) - Fraction(low) <= abs(Fraction(low)) * Fraction(1, 10**25)


def test_the_document_on_an_interval(capsys: pytest.CaptureFixture[str]) -> None:
    found = document(capsys, "--r", "0.02..0.04")
    assert found["r"] == ["1/50", "1/25"]
    low, high = map(Fraction, found["eigenvalues"]["lambda_0"])
    at_3 = document(capsys, "--r", "0.03")["eigenvalues"]["lambda_0"]
    assert low < Fraction(at_3[0]) <= Fraction(at_3[1]) < high < 0


def test_more_bits_give_more_digits(capsys: pytest.CaptureFixture[str]) -> None:
    low, high = document(capsys, "--r", "0.03", "--precision", "1000")["eigenvalues"]["lambda_0"]
    assert Fraction(high) - Fraction(low) < Fraction(1, 10**290)


@pytest.mark.parametrize(
    "text",
    ["0", "1", "-0.1", "2", "1e400", "0.04..0.02", "0.03..0.03", "..", "0.1..", "..0.1", "0..0.1",
     "0.1..1", "x", "", "nan", "1/0", "0.1...5..2", "0,1", "1_0/20"],
)  # fmt: skip
def test_input_errors(capsys: pytest.CaptureFixture[str], text: str) -> None:
    check_refused(run(capsys, f"--r={text}"), "verify: --r: ")


@pytest.mark.parametrize("bits", ["0", "1", "-5", "x", "1e9", "99999999"])
def test_precision_errors(capsys: pytest.CaptureFixture[str], bits: str) -> None:
    check_refused(run(capsys, "--r", "0.1", f"--precision={bits}"))


@pytest.mark.parametrize("r", ["1/20", "0.001..0.9"])
def test_few_bits_are_enough(capsys: pytest.CaptureFixture[str], r: str) -> None:
    code, _, err = run(capsys, "--r", r, "--precision", "2")
    assert (code, err) == (0, "")


def test_files_are_the_same_to_the_byte(tmp_path: Path) -> None:
    contents = []
    for name, seed in (("a", "1"), ("b", "2")):
        folder = tmp_path / name
        command = [sys.executable, "-m", "verify", "spectrum", "--out", str(folder)]
        environment = os.environ | {"PYTHONHASHSEED": seed}
        subprocess.run(
            command, cwd=ROOT, env=environment, check=True, stdout=subprocess.DEVNULL, timeout=60
        )
        files = [file for file in folder.rglob("*") if file.is_file()]
        contents.append({file.name: file.read_bytes() for file in files})
    assert {"statement.json", "certificate.json"} <= set(contents[0])
    assert contents[0] == contents[1]


def test_the_run_imports_neither_sympy_nor_mpmath() -> None:
    code = (
        "import sys; from verify.cli import main; main(['spectrum', '--r', '0.03', '--json']);"
        "sys.exit('sympy' in sys.modules or 'mpmath' in sys.modules)"
    )
    run_ = subprocess.run(
        [sys.executable, "-c", code], cwd=ROOT, stdout=subprocess.DEVNULL, timeout=60
    )
    assert run_.returncode == 0


def test_a_broken_matrix_fails_the_command(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    outcome = with_a_broken_entry()
    monkeypatch.setattr("verify.cli.spectrum.cite_spectrum", lambda: outcome)
    code, out, _ = run(capsys)
    assert code == 1
    assert out.splitlines()[-1].startswith("Verdict: refuted: ")
    assert "\n    entry-1-1 " in out
    code, _, err = run(capsys, "--out", str(tmp_path / "x"))
    assert (code, err) == (1, "")
    assert check.main([str(tmp_path / "x")]) == 1
