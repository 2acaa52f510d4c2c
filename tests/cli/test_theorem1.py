"""The command `theorem1` as scripts see it."""

from __future__ import annotations

import csv
import json
import os
import signal
import subprocess
import sys
import time
from fractions import Fraction
from hashlib import sha256
from math import isqrt
from pathlib import Path
from typing import Any

import pytest

from tests.citing import cited_in
from tests.cli.running import check_refused, command, parsed
from tests.paper.changed_page import with_changes
from verify import check
from verify.cli import main
from verify.language.terms import cos_pi
from verify.paper import theorem1
from verify.prover.outcome import Outcome
from verify.spheres.parameters import angle
from verify.wire import write

FILES = ("statement.json", "certificate.json")
ROOT = Path(__file__).resolve().parents[2]


run = command("theorem1")


def document(capsys: pytest.CaptureFixture[str], *words: str) -> tuple[int, dict[str, Any]]:
    code, out, err = run(capsys, *words, "--json")
    assert err == ""
    return code, parsed(out)


def test_the_screen_is_short_and_ends_like_the_table(capsys: pytest.CaptureFixture[str]) -> None:
    short = run(capsys, "--r", "0.03")[1].splitlines()
    full = run(capsys, "--r", "0.03", "--verbose")[1].splitlines()
    assert len(short) <= 30
    assert short[-1] == full[-1]
    assert any(line.startswith("    zeta-x-bound  ") for line in short)


def test_many_points(capsys: pytest.CaptureFixture[str]) -> None:
    code, found = document(capsys, "--r", "0.01..0.05", "--steps", "5")
    assert (code, found["verdict"], found["points"]) == (0, "proved", {"proved": 5})
    assert sum(item["points"] for item in found["ranges"]) == 5


def test_many_points_as_a_table(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    table = tmp_path / "sweep.csv"
    words = ("--r", "0.01..0.06", "--steps", "6", "--csv", str(table))
    assert run(capsys, *words)[0] == 1
    rows = list(csv.DictReader(table.read_text().splitlines()))
    assert [row["r"] for row in rows] == [f"0.0{n}" for n in range(1, 7)]
    assert [row["verdict"] for row in rows] == ["proved"] * 5 + ["refuted"]
    assert "hypotheses.r-below-stabi" in rows[-1]["refuted"].split()
    code, out, err = run(capsys, "--r", "0.01", "--csv", str(table))
    assert (code, out) == (2, "")
    assert "--steps" in err


def test_many_points_by_several_processes_are_the_same(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    found = []
    for jobs in ("1", "2", "3"):
        table = tmp_path / f"{jobs}.csv"
        words = ("--r", "0.0001..0.0601", "--steps", "241", "--neg-cos", "99/100")
        said = run(capsys, *words, "--csv", str(table), "--jobs", jobs)
        found.append((said, table.read_bytes()))
    assert found[0][0][0] == 1
    assert found[0] == found[1] == found[2]


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        (("--r", "0.02..0.04", "--neg-cos", "0.97..1"), (0, "proved")),
        (("--r", "0.06..0.08"), (1, "refuted")),
        (("--r", "0.03", "--neg-cos", "0.5..1"), (3, "undecided")),
    ],
)
def test_boxes(
    words: tuple[str, ...],
    expected: tuple[int, str],
    capsys: pytest.CaptureFixture[str],
    tmp_path: Path,
) -> None:
    folder = tmp_path / "box"
    code, found = document(capsys, *words)
    assert (code, found["verdict"]) == expected
    assert found["parameters"]["delta_theta"] == "1/10"
    code, out, err = run(capsys, *words, "-v", "--out", str(folder))
    last = out.splitlines()[-1]
    assert (code, last.startswith(f"Verdict: {expected[1]}: ")) == (expected[0], True)
    assert folder.exists() == (expected[0] != 3)
    if expected[0] == 3:
        assert err.count("\n") == 1
        part = next(line for line in out.splitlines() if line.startswith("  verify theorem1 "))
        assert run(capsys, *part.split()[2:])[0] == 0


@pytest.mark.parametrize(
    "words",
    [
        ("--r", "0.04..0.02"),
        ("--r", "nan..1"),
        ("--r", ".."),
        ("--r", "0..1/2"),
        ("--r", "0.02..0.03..0.04"),
        ("--r", "0.03", "--neg-cos", "1..0.9"),
        ("--r", "0.03", "--neg-cos", "0.9..1.1"),
        ("--r", "0.02..0.03", "--theta0", "pi"),
        ("--r", "0.02..0.03", "--constants", "printed"),
        ("--r", "0.02..0.03", "--delta-theta", "0"),
    ],
)
def test_unusable_boxes(words: tuple[str, ...], capsys: pytest.CaptureFixture[str]) -> None:
    check_refused(run(capsys, *words))


def test_an_angle_or_a_table_for_a_box_has_another_option(
    capsys: pytest.CaptureFixture[str],
) -> None:
    """To leave them out would be about another angle, or without a table."""
    check_refused(run(capsys, "--r", "0.02..0.03", "--theta0", "5pi/6"), "write --neg-cos")
    check_refused(run(capsys, "--r", "0.02..0.03", "--csv", "x.csv"), "add --steps N")


@pytest.mark.parametrize(
    "words",
    [
        ("--r", "0.03", "--steps", "5"),
        ("--r", "0.06..0.01", "--steps", "5"),
        ("--r", "0.01..0.06", "--steps", "1"),
        ("--r", "0.01..0.06", "--steps", "5", "--out", "x"),
        ("--r", "0.01..0.06", "--steps", "5", "--jobs", "0"),
        ("--r", "0.01..0.06", "--steps", "5", "--jobs", "two"),
        ("--r", "0.01..0.06", "--jobs", "2"),
        ("--r", "0.03", "--jobs", "2"),
        ("--all", "--jobs", "2"),
    ],
)
def test_unusable_grids(words: tuple[str, ...], capsys: pytest.CaptureFixture[str]) -> None:
    check_refused(run(capsys, *words))


def test_the_document_has_the_promised_shape(capsys: pytest.CaptureFixture[str]) -> None:
    code, doc = document(capsys, "--r", "0.03")
    assert code == 0
    assert (doc["format"], doc["command"]) == ("verify-theorem1/1", "theorem1")
    assert (doc["verdict"], doc["headline"]) == ("proved", "proved")
    assert doc["theorem"].startswith("Given the assumptions: let r = 0.03, θ₀ = π (-cos")
    assert doc["theorem"].endswith("-cos θ differs from -cos θ₀ by at most δ_θ = 0.1.")
    (cite,) = doc["cites"]
    step = (ROOT / "certificates/step/statement.json").read_bytes()
    assert cite == {
        "name": "step",
        "theorem": "step",
        "statement_sha256": sha256(step).hexdigest(),
    }
    listed = [a["statement"] for a in doc["assumptions"]]
    assert listed == [a["sentence"] for a in json.loads(step)["assumptions"]]
    names = {a["name"] for a in doc["assumptions_of_printed_rows"]}
    rows = [*doc["hypotheses"], *(r for s in doc["sets"].values() for r in s["obligations"])]
    assert names == {name for row in rows for name in row["uses"]}
    assert not any(row["uses"] for row in rows if row["role"] == "needed")
    assert doc["parameters"] == {
        "r": "3/100",
        "neg_cos_theta0": "1",
        "delta_theta": "1/10",
        "V_0": "1",
    }
    assert set(doc["constants"]) == {
        "alpha_0", "phi_minus", "phi_plus", "delta_1", "delta_2", "delta_3", "delta_4", "delta_5",
        "C_eta", "h_4", "h_5", "V_0", "V_1",
    }  # fmt: skip
    assert [doc["sets"][name]["verdict"] for name in ("printed", "repaired")] == [
        "refuted",
        "proved",
    ]
    for name, one_set in doc["sets"].items():
        assert {
            "delta_x", "delta_y", "x_0", "Delta_theta", "eta_bar", "zeta_bar", "d_bar",
        } <= set(one_set["constants"])  # fmt: skip
        assert len(one_set["obligations"]) >= 60
        for row in one_set["obligations"]:
            assert row["role"] == ("printed" if name == "printed" else "needed")
            assert row["group"] == name
            assert row["label"]
            assert row["statement"].startswith(row["says"])
            assert row["claim"]
            if row["name"] != "collapse":
                check_pair(row["lhs"])
                check_pair(row["rhs"])
            assert (row["verdict"] != "proved") == ("corrected_by" in row)
        for pair in one_set["constants"].values():
            check_pair(pair)


def test_entries_of_a_minimum_are_counted_from_1(capsys: pytest.CaptureFixture[str]) -> None:
    _, doc = document(capsys, "--r", "0.03")
    for minimum in doc["sets"]["printed"]["minima"].values():
        least = minimum["minimum"]
        for pair in minimum["entries"]:
            check_pair(pair)
            assert Fraction(minimum["entries"][least - 1][0]) <= Fraction(pair[1])
    assert doc["sets"]["printed"]["minima"]["eta_bar"]["minimum"] == 3
    table = run(capsys, "--r", "0.03", "-v")[1].splitlines()
    start = next(i for i, line in enumerate(table) if line.startswith("  η̄ "))
    assert table[start + 3].startswith("           entry 3: ")
    assert table[start + 3].endswith("<- the minimum")


def check_pair(pair: list[str]) -> None:
    """Outward rounded, and to a relative width of at most 1e-25."""
    low, high = map(Fraction, pair)
    assert low <= high
    assert high - low <= max(abs(low), abs(high)) / 10**25


def test_more_precision_earns_more_digits(capsys: pytest.CaptureFixture[str]) -> None:
    _, doc = document(capsys, "--r", "0.03", "--precision", "1000")
    _, usual = document(capsys, "--r", "0.03")
    low, high = map(Fraction, doc["constants"]["phi_minus"])
    first, last = map(Fraction, usual["constants"]["phi_minus"])
    assert 0 < high - low < Fraction(1, 10**290)
    assert first <= low < high <= last
    rows = zip(doc["sets"]["repaired"]["obligations"], usual["sets"]["repaired"]["obligations"],
               strict=True)  # fmt: skip
    for one, two in rows:
        assert one["verdict"] == two["verdict"]
        assert ("lhs" in one) == (one["name"] != "collapse")
        for side in ("lhs", "rhs") if "lhs" in one else ():
            low, high = map(Fraction, one[side])
            first, last = map(Fraction, two[side])
            assert first <= low <= high <= last
            assert high - low <= max(abs(low), abs(high)) / 10**290


@pytest.mark.parametrize("text", ["0.03", "3/100", "3e-2", "+0.03", "300e-4", ".03", "6/200"])
def test_every_way_to_write_a_number(capsys: pytest.CaptureFixture[str], text: str) -> None:
    code, doc = document(capsys, "--r", text, "--constants", "repaired")
    assert (code, doc["parameters"]["r"]) == (0, "3/100")
    assert list(doc["sets"]) == ["repaired"]


@pytest.mark.parametrize(
    ("theta", "expected"),
    [
        ("pi", "1"),
        ("1*pi/1", "1"),
        ("2*pi/3", "1/2"),
        ("4*pi/6", "1/2"),
        ("π", "1"),
        ("2pi/3", "1/2"),
        ("120deg", "1/2"),
        ("5*pi/6", None),
        ("2.9", None),
    ],
)
def test_angles(capsys: pytest.CaptureFixture[str], theta: str, expected: str | None) -> None:
    _, doc = document(capsys, "--r", "1/1000", "--theta0", theta)
    value = doc["parameters"]["neg_cos_theta0"]
    if expected is None:
        check_pair(value)
    else:
        assert value == expected


@pytest.mark.parametrize(
    ("words", "code"),
    [
        (["--r", "0.03", "--constants", "printed"], 1),
        (["--r", "0.03", "--constants", "repaired"], 0),
        (["--r", "1/1000"], 0),
        (["--r", "1/100"], 0),
        (["--r", "1/20"], 0),
        (["--r", "11/200"], 0),
        (["--r", "1e-6", "--neg-cos", "1/20"], 0),
        (["--r", "1e-300"], 0),
        (["--r", "0.0557280900008412143633053250"], 0),
        (["--r", "0.06"], 1),
        (["--r", "1/64", "--neg-cos", "8/13"], 1),
        (["--r", "1/64", "--neg-cos", "0." + "615384" * 80, "--precision", "9",
          "--max-precision", "64"], 1),
        (["--r", "0.03", "--precision", "2"], 0),
    ],
)  # fmt: skip
def test_exit_codes(capsys: pytest.CaptureFixture[str], words: list[str], code: int) -> None:
    assert run(capsys, *words)[0] == code


def test_where_a_hypothesis_is_false_there_are_no_constants(
    capsys: pytest.CaptureFixture[str],
) -> None:
    code, doc = document(capsys, "--r", "1/2")
    assert (code, doc["verdict"], doc["sets"]) == (1, "does not apply", {})
    assert set(doc["constants"]) == {"V_0"}


BAD = [
    (["--r", "0"], "--r"),
    (["--r", "1"], "--r"),
    (["--r", "-0.1"], "--r"),
    (["--r", "1.5"], "--r"),
    (["--r", "nan"], "--r"),
    (["--r", "inf"], "--r"),
    (["--r", "0,03"], "--r"),
    (["--r", "1_0"], "--r"),
    (["--r", "٠.٠٣"], "--r"),
    (["--r", "½"], "--r"),
    (["--r", ""], "--r"),
    (["--r", "."], "--r"),
    (["--r", "1/0"], "--r"),
    (["--r", "3/-100"], "--r"),
    (["--r", "0." + "3" * 5000], "--r"),
    (["--r", "1e99999999"], "--r"),
    (["--r", "1e-99999999"], "--r"),
    (["--r", "1e" + "9" * 3000], "--r"),
    (["--r", " 0.03"], "--r"),
    (["--r", "0x1"], "--r"),
    ([], "--r"),
    (["--r", "0.03", "--theta0", "pi/2"], "--theta0"),
    (["--r", "0.03", "--theta0", "3*pi/2"], "--theta0"),
    (["--r", "0.03", "--theta0", "pi/0"], "--theta0"),
    (["--r", "0.03", "--theta0", "pi*pi"], "--theta0"),
    (["--r", "0.03", "--theta0", "1/0pi"], "--theta0"),
    (["--r", "0.03", "--theta0", "90deg"], "--theta0"),
    (["--r", "0.03", "--theta0", "181°"], "--theta0"),
    (["--r", "0.03", "--theta0", "3.15"], "--theta0"),
    (["--r", "0.03", "--theta0", "1.57"], "--theta0"),
    (["--r", "0.03", "--theta0", "-2"], "--theta0"),
    (["--r", "0.03", "--theta0", "3.1415926535897932384626433832795028842"], "--theta0"),
    (["--r", "0.03", "--neg-cos", "0"], "--neg-cos"),
    (["--r", "0.03", "--neg-cos", "1.0001"], "--neg-cos"),
    (["--r", "0.03", "--neg-cos", "1", "--theta0", "pi"], "--theta0"),
    (["--r", "0.03", "--V0", "0"], "--V0"),
    (["--r", "0.03", "--V0", "-1"], "--V0"),
    (["--r", "0.03", "--delta-theta", "0"], "--delta-theta"),
    (["--r", "0.03", "--delta-theta", "x"], "--delta-theta"),
    (["--r", "0.03", "--constants", "both"], "--constants"),
    (["--r", "0.03", "--precision", "1"], "--precision"),
    (["--r", "0.03", "--precision", "1e3"], "--precision"),
    (["--r", "0.03", "--precision", "256", "--max-precision", "128"], "--max-precision"),
    (["--r", "0.03", "--prec", "128"], "--prec"),
    (["--r", "0.03", "surplus"], "surplus"),
    (["--r", "0.03", "two\nlines"], "two"),
    (["--r", "0.03", "--r", "0.04"], "--r"),
    (["--r", "0.03", "--delta-theta", "-1/10"], "--delta-theta"),
    (["--r", "0.03", "--theta0", "-pi"], "--theta0"),
    (["--r", "0.03", "--theta0", "½π"], "5pi/6"),
    (["--r", "0.03", "--color", "red"], "--color"),
    (["--r", "0." + "1" * 3900 + "e-4000"], "--r"),
    (["--r", "0.03", "--out", "a/" * 3000], "--out"),
    (["--r", "0.03", "--out", "/proc/nowhere"], "--out"),
    (["--r", "0.03", "--out", "a\0b"], "--out"),
]


@pytest.mark.parametrize(("words", "option"), BAD)
def test_bad_input_is_one_line_that_names_the_option(
    capsys: pytest.CaptureFixture[str], words: list[str], option: str
) -> None:
    found = run(capsys, *words)
    check_refused(found, option)
    assert len(found[2]) < 300


@pytest.mark.parametrize(
    ("words", "meant"),
    [
        (["--r", "0,03"], "write 0.03"),
        (["--r", " 3/100"], "write 3/100"),
        (["--r", "0.03", "--delta-theta", "\ufeff0.1"], "write 0.1"),
        (["--r", "0.03", "--V0", "1e−3"], "write 1e-3"),
        (["--r", "0,0,3"], "write it like 0.03"),
        (["--r", "0.03", "--theta0", "150"], "write 150deg"),
    ],
)
def test_a_near_miss_is_told_what_was_meant(
    capsys: pytest.CaptureFixture[str], words: list[str], meant: str
) -> None:
    assert main(["theorem1", *words]) == 2
    assert meant in capsys.readouterr().err


def test_an_unknown_command_and_no_command(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["theorem2"]) == 2
    assert "theorem1" in capsys.readouterr().err
    assert main([]) == 2
    assert capsys.readouterr().err.count("\n") == 1
    assert main(["x" * 100000]) == 2
    assert len(capsys.readouterr().err) < 300
    assert main(["--help"]) == 0
    assert main(["--version"]) == main(["-V"]) == main(["help"]) == 0


def test_500_digits_are_read_exactly(capsys: pytest.CaptureFixture[str]) -> None:
    text = "0.03" + "0" * 490 + "1234567"
    code, doc = document(capsys, "--r", text)
    assert code == 0
    assert Fraction(doc["parameters"]["r"]) == Fraction(text)


def test_files_are_written_only_on_request_and_are_the_same_each_time(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    assert run(capsys, "--r", "0.03")[0] == 0
    assert list(tmp_path.iterdir()) == []
    for name in ("one", "two/deep"):
        assert run(capsys, "--r", "0.03", "--out", name)[0] == 0
        assert sorted(p.name for p in (tmp_path / name).iterdir()) == [
            *("certificate.json", "check.py", "cited", "report.html", "statement.json"),
        ]
    for file in ("certificate.json", "statement.json"):
        assert (tmp_path / "one" / file).read_bytes() == (tmp_path / "two/deep" / file).read_bytes()
    assert run(capsys, "--r", "0.03", "--precision", "300", "--out", "three")[0] == 0
    statement = "statement.json"
    assert (tmp_path / "one" / statement).read_bytes() == (
        tmp_path / "three" / statement
    ).read_bytes()


def test_an_undecided_needed_row_writes_nothing(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    near = "0.61538461538461538461538461538461538461538462"
    words = ["--r", "1/64", "--neg-cos", near, "--precision", "20", "--max-precision", "60"]
    code, out, err = run(capsys, *words, "--out", str(tmp_path / "x"))
    assert code == 3
    assert err == "verify: a needed row is undecided; no certificate was written\n"
    assert out.splitlines()[-1].startswith("Verdict: undecided: ")
    assert "2 undecided" in out.splitlines()[-1]  # a row, and so that the step applies
    assert not (tmp_path / "x").exists()


def test_an_undecided_printed_row_is_kept_and_counted(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    """With few bits a coincidence of two printed sides stays undecided; the rest is proved."""
    words = ["--r", "1/11000", "--neg-cos", "348/3667", "--max-precision", "128"]
    code, out, _ = run(capsys, *words, "--out", str(tmp_path / "x"))
    statement = json.loads((tmp_path / "x/statement.json").read_bytes())
    undecided = [row for row in statement["obligations"] if row["verdict"] == "undecided"]
    assert code == 0
    assert {row["role"] for row in undecided} <= {"printed"}
    last = out.splitlines()[-1]
    assert (f"{len(undecided)} undecided" in last) == bool(undecided)


@pytest.mark.parametrize(
    ("words", "verdict"),
    [
        (["--r", "0.5"], "does not apply"),
        (["--r", "0.03", "--neg-cos", "1/2"], "does not apply"),
        (["--r", "0.03", "--constants", "printed"], "refuted"),
    ],
)
def test_a_refuted_run_writes_a_certificate_of_its_refutation(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, words: list[str], verdict: str
) -> None:
    code, out, err = run(capsys, *words, "--out", str(tmp_path / "x"))
    assert (code, err) == (1, "")
    assert out.splitlines()[-1].startswith(f"Verdict: {verdict}: ")
    files = [(tmp_path / "x" / name).read_bytes() for name in FILES]
    report = check.check(*files, {})
    assert report.verdict == "REFUTED"


def test_fixed_points_may_exist_where_stability_fails(capsys: pytest.CaptureFixture[str]) -> None:
    code, doc = document(capsys, "--r", "0.03", "--neg-cos", "0.7")
    verdicts = {row["name"].rpartition(".")[2]: row["verdict"] for row in doc["hypotheses"]}
    assert (code, verdicts["existence"], verdicts["stability"]) == (1, "proved", "refuted")


IN_CI = pytest.mark.skipif("CI" not in os.environ, reason="takes twenty seconds")


def cut(digits: int) -> str:
    """9 - 4 sqrt 5, the next smaller decimal with so many digits."""
    return "0." + str(9 * 10**digits - isqrt(80 * 10 ** (2 * digits)) - 1).rjust(digits, "0")


@pytest.mark.parametrize(
    "words",
    [
        ["--r", cut(200)],
        ["--r", "0.03", "--delta-theta", "1e-4000", "--V0", "1e-1000"],
        pytest.param(
            ["--r", cut(3000)], marks=pytest.mark.skipif("CI" not in os.environ, reason="slow")
        ),
    ],
)
def test_a_long_parameter_is_checked_or_refused_with_one_line(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, words: list[str]
) -> None:
    folder = tmp_path / "x"
    code, out, err = run(capsys, *words, "--out", str(folder))
    if code == 0:
        files = [(folder / name).read_bytes() for name in FILES]
        assert check.check(*files, cited_in(folder)).verdict == "PROVED"
    else:
        assert (code, err.count("\n")) == (2, 1)
        assert "Verdict: " in out
        assert "digits" in err
        assert len(err) < 300
        assert not folder.exists()


@pytest.mark.parametrize(("r", "expected"), [("0.03", 5), (cut(320), 2)])
def test_work_that_the_checker_does_not_do(
    capsys: pytest.CaptureFixture[str],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    r: str,
    expected: int,
) -> None:
    """It is an error of the input only where that has very long numbers."""
    monkeypatch.setattr(check, "MAX_WORK", 1000)
    code, out, err = run(capsys, "--r", r, "--out", str(tmp_path / "x"))
    assert (code, err.count("\n")) == (expected, 1)
    assert ("Verdict: proved" in out) == (expected == 2)
    assert not (tmp_path / "x").exists()


def test_what_the_checker_does_not_accept_is_our_own_error(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    honest = write.write

    def broken(outcome: Outcome) -> dict[str, bytes]:
        files = honest(outcome)
        old = files["certificate.json"]
        assert b'"bits": 224' in old
        return files | {"certificate.json": old.replace(b'"bits": 224', b'"bits": 4', 1)}

    monkeypatch.setattr(write, "write", broken)
    code, out, err = run(capsys, "--r", "0.03", "--out", str(tmp_path / "x"))
    assert (code, out, err.count("\n")) == (5, "", 1)
    assert "our own checker does not accept" in err
    assert not (tmp_path / "x").exists()


def test_out_is_tested_before_the_work(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def never(*_: object) -> None:
        raise AssertionError("the work was done first")

    monkeypatch.setattr("verify.cli.theorem1.decide_point", never)
    (tmp_path / "file").write_text("mine")
    code, _, err = run(capsys, "--r", "0.03", "--out", str(tmp_path / "file"))
    assert (code, err.count("\n")) == (2, 1)


def test_a_refused_folder_is_left_as_it_was(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    (tmp_path / "certificate.json").mkdir()
    (tmp_path / "statement.json").write_text("mine")
    code, _, err = run(capsys, "--r", "0.03", "--out", str(tmp_path))
    assert (code, err.count("\n")) == (2, 1)
    assert (tmp_path / "statement.json").read_text() == "mine"
    assert len(list(tmp_path.iterdir())) == 2


def python(*words: str, **environment: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, *words],
        cwd=ROOT,
        env=os.environ | environment,
        capture_output=True,
        text=True,
        check=False,
        timeout=60,
    )


@pytest.mark.parametrize(
    "environment",
    [
        {"PYTHONIOENCODING": "ascii"},
        {"LC_ALL": "C", "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0"},
        {"PYTHONINTMAXSTRDIGITS": "640"},
        {"PYTHONOPTIMIZE": "2"},
    ],
)
def test_any_environment(environment: dict[str, str]) -> None:
    result = python("-m", "verify", "theorem1", "--r", "0.03", **environment)
    assert (result.returncode, result.stderr) == (0, "")
    assert "δ_θ" in result.stdout


def shell(command: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        ["bash", "-c", command.replace("verify", f"{sys.executable} -m verify")],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
        timeout=60,
    )


@pytest.mark.parametrize(
    ("command", "code"),
    [
        ("verify theorem1 --r 0.03 >/dev/full", 2),
        ("verify theorem1 --r 0.03 --json >&-", 2),
        ("verify --help >/dev/full", 2),
        ("verify theorem1 --help >/dev/full", 2),
        ("verify theorem1 --r 0.06 | true; exit ${PIPESTATUS[0]}", 141),
        ("verify theorem1 --r nan 2>&-", 2),
    ],
)
def test_output_that_cannot_be_written(command: str, code: int) -> None:
    result = shell(command)
    assert "Traceback" not in result.stderr
    assert result.stderr.count("\n") <= 1
    if "| true" not in command or result.returncode == 141:
        assert result.returncode == code
        assert result.stdout == ""


def test_a_process_that_is_interrupted_says_so_in_one_line() -> None:
    process = subprocess.Popen(
        [sys.executable, "-m", "verify", "theorem1", "--r", "0.02..0.04", "--steps", "99999"],
        cwd=ROOT,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
        text=True,
    )
    time.sleep(1)
    process.send_signal(signal.SIGINT)
    _, err = process.communicate(timeout=30)
    assert (process.returncode, err) == (130, "verify: interrupted\n")


def test_nothing_heavy_is_imported() -> None:
    code = (
        "import sys\n"
        "from verify.cli import main\n"
        "assert main(['theorem1', '--r', '0.03']) == 0\n"
        "print(sorted(m for m in ('sympy', 'mpmath', 'pytest', 'numpy', 'tempfile',"
        " 'json', 'matplotlib', 'hypothesis', 'multiprocessing') if m in sys.modules))\n"
    )
    assert python("-c", code).stdout.splitlines()[-1] == "[]"


def test_the_process_exits_with_the_verdict_when_a_bound_breaks(tmp_path: Path) -> None:
    """What CI relies on: with a bound broken on purpose the main job exits 1."""
    text = Path(theorem1.PAGE).read_text(encoding="utf-8")
    entries = "repaired.zeta_bar: min(zeta_entries)"
    page = tmp_path / "theorem1.toml"
    page.write_text(with_changes(text, (entries, entries.replace("min(", "2*min("))))
    code = (
        "import sys\n"
        "from verify.paper import theorem1\n"
        f"theorem1.PAGE = {str(page)!r}\n"
        "from verify.cli import main\n"
        "sys.exit(main(['theorem1', '--r', '0.03']))\n"
    )
    result = python("-c", code)
    assert result.returncode == 1
    assert result.stdout.splitlines()[-1].startswith("Verdict: refuted: ")


def test_a_reader_who_leaves_early_sees_no_traceback() -> None:
    result = subprocess.run(
        f"{sys.executable} -m verify theorem1 --r 0.03 | head -n 1",
        shell=True,
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
        timeout=60,
    )
    assert result.stderr == ""


def test_the_citation_closes_with_the_certificate_beside_it_or_with_the_folder_of_the_step(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    """What a point leaves to the step is proved where both are checked in one run."""
    folder = tmp_path / "x"
    assert run(capsys, "--r", "0.03", "--out", str(folder))[0] == 0
    for others, opened in (((), 0), ((), 1), ((str(ROOT / "certificates/step"),), 0)):
        if opened:
            next((folder / "cited").glob("*.certificate.json")).unlink()
        assert main(["check", str(folder), *others]) == 3 * opened
        words = ("PROVED:", "UNDECIDED:")
        last = [line for line in capsys.readouterr().out.splitlines() if line.startswith(words)]
        assert len(last) == 1 + len(others)
        assert sum("not proved here" in line for line in last) == opened


@pytest.mark.parametrize("same", ["5pi/6", "5π/6", "5/6*pi", "150deg", "150°", "150.0 degrees"])
def test_one_angle_written_in_many_ways(same: str) -> None:
    assert angle("--theta0", same) == angle("--theta0", "5*pi/6") == -cos_pi(Fraction(5, 6))
    assert angle("--theta0", "0.9*pi") == angle("--theta0", "162°") == -cos_pi(Fraction(9, 10))


def test_nothing_is_written_where_the_row_that_is_asked_for_is_not_there(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    out = tmp_path / "out"
    code, text, complaint = run(capsys, "--r", "0.03", "--rows", "nope", "--out", str(out))
    assert (code, text) == (2, "")
    assert "there is no row 'nope'" in complaint
    assert not [*out.glob("*")]


@pytest.mark.parametrize("written", [False, True])
def test_the_judge_with_and_without_a_certificate(
    written: bool, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """The checker has judged each row of a certificate that it has accepted."""
    words = [
        "theorem1",
        "--r",
        "0.03",
        "--json",
        *(["--out", str(tmp_path / "out")] if written else []),
    ]
    assert main(words) == 0
    judges: set[str] = set()

    def visit(item: object) -> None:
        if isinstance(item, dict):
            if "judged_by" in item:
                judges.add(item["judged_by"])
            for part in item.values():
                visit(part)
        elif isinstance(item, list):
            for part in item:
                visit(part)

    visit(json.loads(capsys.readouterr().out))
    assert ("the checker" in judges) == written
    assert ("FLINT at a point" in judges) != written
