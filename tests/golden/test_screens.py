"""Each command prints what its file shows; ``python -m tests.golden --accept`` writes it anew."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.golden import files, screen, sessions

SCREENS = [(path, command) for path in files() for command in sessions(path)]


@pytest.mark.parametrize(("path", "command"), SCREENS, ids=[command for _, command in SCREENS])
def test_screen(path: Path, command: str) -> None:
    assert screen(command) == sessions(path)[command]


def test_screens_are_files_of_commands() -> None:
    assert len(SCREENS) > 50
    assert all(path.read_text(encoding="utf-8").startswith("$ verify ") for path in files())
