"""The command lines of the README are found, and a wrong end of one is seen."""

from __future__ import annotations

from tests.readme_commands import Command, commands, commands_of, complaint, to_run
from verify.cli import COMMANDS


def test_every_command_is_in_the_readme_and_is_found() -> None:
    found = [command.line for command in commands()]
    assert {line.split()[1] for line in found if line.startswith("verify ")} == COMMANDS.keys()
    assert len([line for line in found if line.startswith("python3 -I verify/check")]) >= 3
    assert Command("verify theorem1 --r 0.03 --constants printed", 1) in commands()


def test_a_line_is_what_a_shell_can_run() -> None:
    page = "```sh\nverify map phi --out DIR  # x\nverify/coq/build /tmp\n$ verify check DIR\n```\n"
    first, second = commands_of(page)
    assert to_run(first, "/tmp/a b") == "verify map phi --out '/tmp/a b'"
    assert to_run(second, "x") == "verify check certificates/theorem1-r-3-100"
    assert not any(word in to_run(c, "x") for c in commands() for word in ("DIR", "STATEMENT"))


def test_a_wrong_end_is_seen() -> None:
    command = Command("verify theorem1 --r 0.03 --constants printed", 1)
    assert complaint(command, 1, "") == ""
    assert "exit code 0" in complaint(command, 0, "")
    assert complaint(command, 1, "Traceback (most recent call last):\n") == "a traceback"
