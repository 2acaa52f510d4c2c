"""The command `elsewhere` as scripts see it."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tests.cli.running import command
from verify import check
from verify.paper.commands import pages
from verify.publication import ACCUSATIONS

run = command("elsewhere")


def test_every_row(capsys: pytest.CaptureFixture[str]) -> None:
    _, out, _ = run(capsys, "--verbose")
    for row in pages.decide("sections_1_to_4").statement.obligations:
        assert f"[{row.name}, " in out


def test_the_document(capsys: pytest.CaptureFixture[str]) -> None:
    code, out, _ = run(capsys, "--json")
    found = json.loads(out)
    assert (code, found["command"], found["verdict"]) == (0, "elsewhere", "proved")
    claims = {claim["name"]: claim for claim in found["claims"]}
    rows = pages.decide("sections_1_to_4").statement.obligations
    assert claims.keys() == {row.name for row in rows}
    refuted = {name for name, claim in claims.items() if claim["verdict"] == "refuted"}
    assert refuted == {row.name for row in rows if row.severity in ACCUSATIONS}
    assert {claims[claims[name]["corrected_by"]]["verdict"] for name in refuted} == {"proved"}


def test_out(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    code, _, _ = run(capsys, "--out", str(tmp_path))
    assert code == 0
    assert check.main([str(tmp_path)]) == 0
