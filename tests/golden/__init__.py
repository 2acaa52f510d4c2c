"""Screens: files of commands with what each prints, in a terminal of 100 columns.

Each `*.txt` here has commands, each in a line that begins with ``$ verify``, followed by what it
prints. To add a command, write its line; then ``python -m tests.golden --accept`` runs every
command and writes what it prints. Look at the difference before you commit it.
"""

from __future__ import annotations

import os
import shlex
from contextlib import redirect_stderr, redirect_stdout
from io import StringIO
from pathlib import Path

from verify.cli import main

FOLDER = Path(__file__).parent
ROOT = FOLDER.parents[1]
PROMPT = "$ verify "


def files() -> list[Path]:
    """All files of screens."""
    return sorted(FOLDER.glob("*.txt"))


def sessions(path: Path) -> dict[str, str]:
    """The commands of a file, each with its screen."""
    found: dict[str, str] = {}
    for part in ("\n" + path.read_text(encoding="utf-8")).split(f"\n{PROMPT}")[1:]:
        command, _, shown = part.partition("\n")
        if command in found:
            raise ValueError(f"{path.name}: {command} is there twice")
        found[command] = shown.strip("\n")
    return found


def screen(command: str) -> str:
    """What a command prints, and its exit code unless that is 0."""
    out, before = StringIO(), (Path.cwd(), os.environ.get("COLUMNS"))
    os.chdir(ROOT)
    os.environ["COLUMNS"] = "100"
    try:
        with redirect_stdout(out), redirect_stderr(out):
            code = main(shlex.split(command))
    finally:
        os.chdir(before[0])
        os.environ.pop("COLUMNS")
        os.environ |= {} if before[1] is None else {"COLUMNS": before[1]}
    return out.getvalue().strip("\n") + (f"\n[exit code {code}]" if code else "")
