"""What a file says of itself in Markdown is its words, and no part of the report."""

from __future__ import annotations

import json
import re
from hashlib import sha256
from pathlib import Path

import pytest

from verify.cli import main

PAGE = """title = "T"
[assumptions]
A = "It is so."
[contexts.c]
variables = ["x"]
given = ["0 <= x <= 1"]
[rows]
r = { claim = "x <= 1", says = "see <!--", uses = ["A"], label = "</b>", group = "<u" }
"""


def test_a_file_adds_nothing_to_its_report_and_hides_nothing(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "p.toml").write_text(PAGE)
    folder = tmp_path / "p"
    assert main(["prove", str(tmp_path / "p.toml"), "--out", str(folder)]) == 0
    statement = json.loads((folder / "statement.json").read_bytes())
    statement["title"] = "T\n\n## All is well\n\nNothing is taken on trust.\n\n<!-- x"
    statement["assumptions"][0]["sentence"] = "a\n\n# Heading \u202e\n"
    statement["contexts"][0]["variables"][0]["letter"] = "<!--"
    statement["contexts"][0]["says"] = "c\n\n| a | b |\n<details>"
    content = json.dumps(statement).encode()
    (folder / "statement.json").write_bytes(content)
    certificate = json.loads((folder / "certificate.json").read_bytes())
    certificate["statement_sha256"] = sha256(content).hexdigest()
    (folder / "certificate.json").write_text(json.dumps(certificate))
    capsys.readouterr()
    assert main(["check", "--markdown", str(folder)]) == 0
    lines = capsys.readouterr().out.splitlines()
    headings = [line for line in lines if line.startswith("#")]
    assert headings[0].startswith("# T ## All is well")
    assert headings[1:] == ["## Context `c`", "## All rows: \\<u", "## Taken on trust"]
    assert not any(re.search(r"(?<!\\)<[!/du]|\u202e", line) for line in lines)
