"""What the pages tell a reader to do is found, is done, and a wrong page is seen."""

from __future__ import annotations

import os
import sys
from pathlib import Path

import pytest

from tests.readme_commands import (
    ROOT,
    Command,
    File,
    complaint,
    followed,
    is_shown,
    pages,
    steps_of,
    steps_of_cell,
    steps_on,
    to_run,
)
from verify.cli import COMMANDS


def steps() -> list[Command | File]:
    return [step for page in pages() for step in steps_on(page)]


#: What `.ci/run` does itself.
IN_CI = {"certify", "report"}


def test_every_command_is_run_on_some_page() -> None:
    lines = [step.line for step in steps() if isinstance(step, Command)]
    run = {line.split()[1] for line in lines if line.startswith("verify ")}
    assert COMMANDS.keys() - IN_CI <= run
    assert len([line for line in lines if line.startswith("python3 -I verify/check")]) >= 3
    assert any(isinstance(step, File) for step in steps())


def test_a_line_is_what_a_shell_can_run() -> None:
    page = "```sh\nverify map phi --out DIR  # x\nverify/coq/build /tmp\nverify check DIR\n```\n"
    first, second = steps_of(page)
    assert to_run(first, "/tmp/a b") == "verify map phi --out '/tmp/a b'"
    assert to_run(second, "x") == "verify check certificates/theorem1-r-3-100"


def test_a_session_has_files_outputs_and_exit_codes() -> None:
    page = (
        "```{code-block} toml\n:caption: a.toml\n\nr = 1\n```\n"
        "```console\n$ verify scene a.toml\none\ntwo\n$ echo $?\n3\n$ ls\n```\n"
    )
    file, first, second = steps_of(page)
    assert file == File("a.toml", "r = 1\n")
    assert first == Command("verify scene a.toml", 3, "one\ntwo\n")
    assert second == Command("ls", 0, "")


def test_a_notebook_has_files_commands_pictures_and_programs() -> None:
    assert list(steps_of_cell("%%writefile a.toml\nr = 1", "", "c.py")) == [File("a.toml", "r = 1")]
    assert list(steps_of_cell("!ls", "a\n", "c.py")) == [Command("ls", 0, "a\n")]
    assert list(steps_of_cell('SVG("a.svg")', "", "c.py")) == [Command("test -s a.svg")]
    program = [File("c.py", "print(1)"), Command("python c.py", 0, "1\n")]
    assert list(steps_of_cell("print(1)", "1\n", "c.py")) == program


@pytest.mark.parametrize(
    ("shown", "printed", "same"),
    [
        ("a\nb\n", "a\nb\n", True),
        ("a\n", "a\nb\n", False),
        ("a\n...\nd\n", "a\nb\nc\nd\n", True),
        ("a\n...\n", "a\nb\n", True),
        ("...\nb\n", "a\nb\n", True),
        ("...\nb\n", "a\nc\n", False),
        ("in 0... s\n", "in 0.5 s\n", True),
        ("a.b\n", "axb\n", False),
        ("", "", True),
        ("\n", "a\n", False),
    ],
)
def test_what_a_page_leaves_out(shown: str, printed: str, same: bool) -> None:
    assert is_shown(shown, printed) is same


def test_a_wrong_end_is_seen() -> None:
    command = Command("verify theorem1 --r 0.03 --constants printed", 1)
    assert complaint(command, 1, "") == ""
    assert "exit code 0" in complaint(command, 0, "")
    assert complaint(command, 1, "Traceback (most recent call last):\n") == "a traceback"
    assert complaint(command._replace(shown="a\n"), 1, "b\n") == "something else is shown"


@pytest.mark.parametrize(
    "page", sorted((ROOT / "docs/tutorials").glob("*.[mi]*")), ids=lambda p: p.name
)
def test_a_tutorial_shows_what_happens(page: Path, tmp_path: Path) -> None:
    path = f"{Path(sys.executable).parent}:{os.environ['PATH']}"
    assert not list(followed(page, tmp_path, {**os.environ, "PATH": path}))
