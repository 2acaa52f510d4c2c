"""The command `elsewhere` as scripts see it."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from verify import check
from verify.cli import main
from verify.language.statement import ACCUSATIONS, REFUTED
from verify.paper.commands.elsewhere import decide_elsewhere


def run(capsys: pytest.CaptureFixture[str], *words: str) -> tuple[int, str, str]:
    code = main(["elsewhere", *words])
    captured = capsys.readouterr()
    return code, captured.out, captured.err


def test_the_screen_has_every_misprint(capsys: pytest.CaptureFixture[str]) -> None:
    code, out, err = run(capsys)
    assert (code, err) == (0, "")
    assert out.splitlines()[-1].startswith("Verdict: proved")
    told = " ".join(out.split())
    for row, decision in decide_elsewhere().rows:
        line = " ".join(("", row.name, row.corrected_by or "", ""))
        assert (line in told) == (decision.verdict == REFUTED)


def test_every_row(capsys: pytest.CaptureFixture[str]) -> None:
    _, out, _ = run(capsys, "--verbose")
    for row in decide_elsewhere().statement.obligations:
        assert f"[{row.name}, " in out
        if row.severity in ACCUSATIONS:
            assert f"{row.severity}; corrected by {row.corrected_by}" in out
    assert "proved; not by the printed argument" in out
    assert "proved by quoted-existence" in out
    assert "  remark " in out
    assert "see outer-apart" in out


def test_the_document(capsys: pytest.CaptureFixture[str]) -> None:
    code, out, _ = run(capsys, "--json")
    found = json.loads(out)
    assert (code, found["command"], found["verdict"]) == (0, "elsewhere", "proved")
    assert len(found["claims"]) == len(decide_elsewhere().statement.obligations)


def test_out(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    code, _, _ = run(capsys, "--out", str(tmp_path))
    assert code == 0
    assert check.main([str(tmp_path)]) == 0
