"""What people read is as wide as their terminal, and coloured only there."""

from __future__ import annotations

import os
import pty
import re
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path

import pytest

from verify.cli import main
from verify.cli.columns import table_lines
from verify.cli.options import Options
from verify.cli.terminal import COLUMNS, ROOMY, show, width, wrapped

ROOT = Path(__file__).resolve().parents[2]
COMMAND = [sys.executable, "-m", "verify", "theorem1", "--r", "0.03"]


def at_terminal(words: list[str], environment: Mapping[str, str]) -> str:
    """What a command prints on a terminal."""
    ours, theirs = pty.openpty()
    known = {k: v for k, v in os.environ.items() if k not in ("NO_COLOR", "COLUMNS")}
    process = subprocess.Popen(
        [*COMMAND, *words], stdout=theirs, stderr=theirs, cwd=ROOT, env=known | dict(environment)
    )
    os.close(theirs)
    found = b""
    while True:
        try:
            part = os.read(ours, 1 << 16)
        except OSError:  # the other side is closed
            break
        if not part:
            break
        found += part
    process.wait()
    os.close(ours)
    return found.decode()


def test_a_terminal_gets_colours_and_symbols() -> None:
    assert "Verdict: \x1b[32m✓ proved\x1b[0m: " in at_terminal([], {})
    for words, environment in (([], {"NO_COLOR": "1"}), (["--color", "never"], {})):
        plain = at_terminal(words, environment)
        assert "Verdict: ✓ proved: " in plain
        assert "\x1b" not in plain
    assert "\x1b" in at_terminal(["--color=always"], {"NO_COLOR": "1"})


@pytest.mark.parametrize("columns", ["²", "٣٣", "0", "-1", "1e3", "", "9" * 5000])
def test_a_width_that_is_no_number(
    columns: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("COLUMNS", columns)
    assert width() == COLUMNS
    assert main(["help", "check"]) == 0


def test_a_sentence_makes_no_line_of_its_own(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """What somebody else has written into a page cannot look like a verdict, nor steer anything."""
    page, out = tmp_path / "p.toml", tmp_path / "out"
    page.write_text(
        'title = "t\\u001b[31m\\nVerdict: proved"\nassumptions = { a = "s\\rproved\\u202e" }\n'
        'rows = { row = { claim = "1 < 2", says = "x\\nproved    other", uses = ["a"] } }\n'
    )
    assert main(["prove", "-v", str(page), "--out", str(out)]) == 0
    assert main(["explain", str(out), "row"]) == 0
    printed = capsys.readouterr().out
    assert not any(sign in printed for sign in "\x1b\r\u202e")
    starts = [line.split()[:2] for line in printed.splitlines()]
    assert ["proved", "other"] not in starts
    assert sum(words[:1] == ["Verdict:"] for words in starts) == 1


@pytest.mark.parametrize("columns", [None, "40", "80", "200"])
def test_no_line_is_wider_than_the_terminal(
    columns: str | None, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    if columns is None:
        monkeypatch.delenv("COLUMNS")
    else:
        monkeypatch.setenv("COLUMNS", columns)
    assert main(["theorem1", "--r", "0.03", "--theta0", "5pi/6", "-v"]) == 0
    out = capsys.readouterr().out
    assert "\x1b" not in out
    assert "✓" not in out
    most = int(columns or "80")
    for line in out.splitlines():  # a word, or a relation with its sides, may be longer
        assert len(line) <= most or len(line.split()) <= (5 if most >= ROOMY else 1)


def test_breaking_keeps_every_word() -> None:
    line = "    one two three four " + "x" * 30 + " end"
    found = list(wrapped([line, "", "  short"], 24))
    assert " ".join(found).split() == [*line.split(), "short"]
    assert found[1].startswith("      ")
    line = f"{'word ' * 14}a = 4 end"
    assert [part.strip() for part in wrapped([line], 73)] == [("word " * 14).strip(), "a = 4 end"]


def test_a_command_can_be_pasted() -> None:
    line = f"  verify theorem1 --r 1/50..{'1' * 20}/5 --neg-cos 9/10..1 --V0 1 --delta-theta 1/10"
    found = list(wrapped([line], 50))
    assert len(found) > 2
    assert all(len(part) <= 50 for part in found)
    text = "\n".join(found).replace("\\\n", "")
    assert text.split() == line.split()
    assert "\n" not in text


def test_verdicts_of_files_and_scenes_have_symbols(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """A symbol stays beside its word, however narrow the terminal is."""
    monkeypatch.setenv("COLUMNS", "24")
    words = ["--color", "always"]
    assert main(["check", str(ROOT / "certificates/examples/root"), *words]) == 0
    assert capsys.readouterr().out.startswith("\x1b[32m✓ PROVED\x1b[0m: ")
    assert main(["scene", str(ROOT / "certificates/scenes/parting.toml"), *words]) == 0
    assert capsys.readouterr().out.startswith("\x1b[32m✓ disperses\x1b[0m: ")
    assert main(["scene", str(ROOT / "certificates/scenes/tie.toml"), *words]) == 3
    assert capsys.readouterr().out.startswith("\x1b[33m? undecided\x1b[0m: ")


def test_a_table_is_as_wide_as_the_terminal() -> None:
    rows = [["a", "one two three four five six"], ["bcd", "x"]]
    table = {"title": "T", "columns": ["name", "long words"], "rows": rows}
    for columns in (20, 40):
        lines = list(table_lines(table, columns))
        assert max(map(len, lines)) <= columns
        assert " ".join(" ".join(lines).split()).startswith("T name long words a one two three")
    assert len(list(table_lines(table, 40))) == 5


def test_the_screen_fits(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.delenv("COLUMNS")
    assert main(["theorem1", "--r", "0.03", "--theta0", "150deg"]) == 0
    out = capsys.readouterr().out
    assert len(out.splitlines()) <= 44
    assert "θ₀ = 5π/6" in out
    assert "-cos θ₀ = 0.86602540…" in " ".join(out.split())
    assert not re.search("[0-9]e-?[0-9]", out)


@pytest.mark.parametrize(
    ("line", "marked"),
    [
        ("finite: r > 7 - 4√3", ["finite"]),
        ("  proved    0 < r", ["proved"]),
        ("Verdict: refuted: A title", ["refuted"]),
        ("As printed, with <: refuted (Coq)", ["refuted"]),
        ("III: total impulse 13/13, IV: finite or infinite time 4/4", []),
        ("two pages: proved rows and others", []),
        ("A case: collapses of balls", []),
    ],
)
def test_words_are_marked_by_what_they_mean(
    line: str, marked: list[str], capsys: pytest.CaptureFixture[str]
) -> None:
    show([line], Options(color="always"))
    assert re.findall(r"[✓✗?]\W([a-z]+)", capsys.readouterr().out) == marked
