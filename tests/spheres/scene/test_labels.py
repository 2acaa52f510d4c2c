"""A title and units in scene files: told in text, JSON, CSV and drawings."""

from __future__ import annotations

import csv
import json
from pathlib import Path

import jsonschema
import pytest

from verify.cli import main

SCHEMA = Path(__file__).resolve().parents[3] / "certificates/schema/scene.schema.json"
SCENE = """
r = "0.03"
diameter = "0.5"
positions = [[0, 0], ["0.6", 0], ["-0.7", "0.01"]]
velocities = [[0, 0], [-1, 0], [1, 0]]
"""
LABELS = 'title = "Steel, run 12"\ntime_unit = "ms"\nlength_unit = "mm"\n'


@pytest.fixture
def path(tmp_path: Path) -> Path:
    file = tmp_path / "steel.toml"
    file.write_text(LABELS + SCENE, encoding="utf-8")
    return file


def test_all_outputs_tell_them(
    path: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    table, drawing = tmp_path / "t.csv", tmp_path / "d.svg"
    assert main(["scene", str(path), "--csv", str(table), "--plot", str(drawing)]) == 0
    out = capsys.readouterr().out
    assert out.startswith("Steel, run 12\ncollapses: ")
    assert "] ms; final" in out
    assert "lengths are in diameters, each 0.5 mm\n" in out
    (row,) = csv.DictReader(table.read_text(encoding="utf-8").splitlines())
    assert (row["title"], row["time_unit"], row["length_unit"]) == ("Steel, run 12", "ms", "0.5 mm")
    assert {"Steel, run 12", "0.5 mm"} <= {
        word for word in ("Steel, run 12", "0.5 mm") if word in drawing.read_text(encoding="utf-8")
    }
    assert main(["scene", str(path), "--json"]) == 0
    document = json.loads(capsys.readouterr().out)
    jsonschema.Draft202012Validator(json.loads(SCHEMA.read_text(encoding="utf-8"))).validate(
        document
    )
    assert document["time_unit"] == "ms"


def test_the_statement_of_a_certificate_tells_them_apart(path: Path, tmp_path: Path) -> None:
    assert main(["scene", str(path), "--out", str(tmp_path / "proof")]) == 0
    title = json.loads((tmp_path / "proof/statement.json").read_text(encoding="utf-8"))["title"]
    assert title.startswith("Steel, run 12: collapses: particle")
    assert title.endswith("]; lengths are in diameters, each 0.5 mm")


def test_the_verdict_is_that_of_the_scene_without_them(
    path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["scene", str(path), "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    path.write_text(SCENE, encoding="utf-8")
    assert main(["scene", str(path), "--json"]) == 0
    plain = json.loads(capsys.readouterr().out)
    assert told.keys() - plain.keys() == {"title", "time_unit", "length_unit"}
    assert {name: told[name] for name in plain} == plain


def test_a_family_keeps_them(path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    text = LABELS + SCENE.replace('"0.03"', '"0.02..0.04"')
    path.write_text(text, encoding="utf-8")
    assert main(["scene", str(path), "--at", "r=0.03"]) == 0
    assert capsys.readouterr().out.startswith("Steel, run 12\n")


@pytest.mark.parametrize("line", ["title = 1", 'time_unit = "a\\nb"', f'title = "{"x" * 81}"'])
def test_what_is_no_label(path: Path, line: str, capsys: pytest.CaptureFixture[str]) -> None:
    path.write_text(f"{line}\n{SCENE}", encoding="utf-8")
    assert main(["scene", str(path)]) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert f"{line.partition(' ')[0]}: " in err
    assert err.count("\n") == 1


def test_a_family_tells_its_diameter_as_a_decimal(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "family.toml"
    family = LABELS + SCENE.replace('"0.01"', '"h"') + '[parameters]\nh = "0..0.01"\n'
    path.write_text(family, encoding="utf-8")
    assert main(["scene", str(path), "--at", "h=0.01"]) == 0
    assert "lengths are in diameters, each 0.5 mm\n" in capsys.readouterr().out
