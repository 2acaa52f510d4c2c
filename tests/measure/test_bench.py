"""The measurements have the promised shape; their times are not judged here."""

from __future__ import annotations

import json
import subprocess
from fractions import Fraction
from pathlib import Path

import pytest

from tests.measure.benchmarks import instructions
from tests.measure.benchmarks.ratios import CERTIFICATE, certificate_ratio, committed, grown
from verify.cli import main, report
from verify.cli.made import Made
from verify.cli.options import Options
from verify.measure import scenes
from verify.measure.bench import (
    MAIN_JOB,
    TABLES,
    _cpu,
    out_of_date,
    relative_width,
    scientific,
)

COMMITTED = Path(__file__).parents[2] / "certificates" / "data" / "bench.json"


def test_the_quick_form(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["bench", "--quick", "--json"]) == 0
    document = json.loads(capsys.readouterr().out)
    tables = document["tables"]
    assert tables.keys() == {*TABLES}
    assert out_of_date(tables) == ["the table precision has other rows"]
    for table in tables.values():
        assert all(len(row) == len(table["columns"]) for row in table["rows"])
    widths = [float(row[2]) for row in tables["precision"]["rows"]]
    assert widths == sorted(widths, reverse=True)
    assert all(float(row[3]) <= float(row[2]) for row in tables["equal_width"]["rows"])
    assert any(row[2] > 0 for row in tables["double_verdicts"]["rows"])


def test_measurements_of_an_earlier_program_are_told() -> None:
    tables = json.loads(COMMITTED.read_text(encoding="utf-8"))["tables"]
    assert out_of_date(tables) == []
    rows = [row for row in tables["processes"]["rows"] if row[0] != MAIN_JOB]
    older = tables | {"older": {}, "processes": {"rows": rows}}
    del older["maps"]
    assert out_of_date(older) == [
        "has a table older, which is not made now",
        "has no table maps",
        "the table processes has other rows",
    ]


def test_the_report_compares_what_was_measured(capsys: pytest.CaptureFixture[str]) -> None:
    tables = json.loads(COMMITTED.read_text(encoding="utf-8"))["tables"]
    told = Made("report", Options(json=False, compare=True))
    assert not report._stale("there", {"bench": tables}, told)
    assert not report._stale("there", {}, told)
    assert capsys.readouterr().out == ""
    del tables["slack"]
    assert report._stale("there", {"bench": tables}, told)
    assert capsys.readouterr().out == (
        "STALE    there/data/bench.json: has no table slack; write it anew with "
        "verify bench --out there/data\n"
    )


def test_widths_are_rounded_up() -> None:
    assert relative_width((Fraction(1), Fraction(1))) == 0
    assert relative_width((Fraction(2), Fraction(3))) == Fraction(1, 2)
    assert relative_width((Fraction(-1), Fraction(1))) == 1
    assert Fraction(scientific(Fraction(1, 3))) >= Fraction(1, 3)


def test_a_command_that_fails_is_not_measured() -> None:
    assert _cpu(["-c", "pass"]) > 0
    with pytest.raises(subprocess.CalledProcessError):
        _cpu(["-c", "raise SystemExit(2)"])


def test_the_process_of_a_scene_decides_it() -> None:
    """It fails where the command does, and it takes longer than the import alone."""
    assert scenes.process_ratio(_cpu, 1) > 1


def test_a_certificate_is_compared_with_its_verdict() -> None:
    """One scene of each kind; it fails where one of them does."""
    assert CERTIFICATE in committed()
    assert certificate_ratio(1, 1) > 1


def test_a_command_that_takes_half_as_much_again_is_named() -> None:
    figures = committed()
    assert len(figures) > 5
    assert grown({name: 1.4 * figure for name, figure in figures.items()}, figures) == []
    name = "verify spectrum"
    (line,) = grown(figures | {name: 1.6 * figures[name]}, figures)
    assert line.startswith(f"{name}: ")
    (line,) = grown({other: figures[other] for other in figures if other != name}, figures)
    assert line == f"{name}: not in both"


def test_a_twentieth_more_instructions_is_seen(tmp_path: Path) -> None:
    version, figures = instructions.committed()
    name, figure = next(iter(figures.items()))
    assert grown(figures | {name: 1.04 * figure}, figures, instructions.TOLERANCE) == []
    assert grown(figures | {name: 1.06 * figure}, figures, instructions.TOLERANCE)
    if version == instructions.version():  # and the first one is counted
        found = instructions.instructions(name.removeprefix("verify "), str(tmp_path))
        assert abs(found - figure) < 0.05 * figure
