"""The script that completes commands and options: a shell reads it, and completes with it."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest

from verify.cli import COMMANDS, main

BASH = shutil.which("bash")


@pytest.mark.skipif(BASH is None, reason="bash is not installed")
@pytest.mark.parametrize(
    ("words", "expected"),
    [
        (["sep"], ["separatrix"]),
        (["theorem1", "--delta"], ["--delta-theta"]),
        (["theorem1", "--constants", "p"], ["printed"]),
        (["theorem1", "--out", "fol"], ["folder"]),
        (["check", "fol"], ["folder"]),
    ],
)
def test_bash_completes(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, words: list[str], expected: list[str]
) -> None:
    assert main(["completion", "bash"]) == 0
    (tmp_path / "script").write_text(capsys.readouterr().out)
    (tmp_path / "folder").mkdir()
    line = ["verify", *words]
    ask = f"COMP_WORDS=({' '.join(line)}) COMP_CWORD={len(words)}"
    command = f'. ./script; {ask}; _shtab_verify; printf "%s\\n" "${{COMPREPLY[@]}}"'
    done = subprocess.run(
        [str(BASH), "-c", command], cwd=tmp_path, capture_output=True, text=True, check=True
    )
    assert (done.stdout.split(), done.stderr) == (expected, "")


@pytest.mark.parametrize("shell", ["bash", "zsh", "tcsh"])
def test_every_command_is_in_the_script(capsys: pytest.CaptureFixture[str], shell: str) -> None:
    assert main(["completion", shell]) == 0
    text = capsys.readouterr().out
    assert all(name in text for name in COMMANDS)


def test_a_shell_that_is_not_known(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["completion", "fish"]) == 2
    assert "write bash or zsh or tcsh" in capsys.readouterr().err
