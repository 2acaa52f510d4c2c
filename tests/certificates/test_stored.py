"""The folders for other checkers are answered as their place says."""

import subprocess
import sys
from pathlib import Path

import pytest

from tests.certificates.store import HERE, stored
from verify import check

CODES = {"correct": 0, "incorrect": 1, "malformed": 4}
FOLDERS = sorted(path for kind in CODES for path in (HERE / kind).iterdir())


@pytest.mark.parametrize("folder", FOLDERS, ids=lambda path: path.name)
def test_stored(folder: Path) -> None:
    assert check.check_folders(check.read_folders([str(folder)]))[0] == CODES[folder.parent.name]


def test_nothing_is_stale() -> None:
    files = {
        path: tuple((path / name).read_bytes() for name in ("statement.json", "certificate.json"))
        for path in FOLDERS
    }
    assert files == stored()


def test_the_honest_one_on_the_command_line() -> None:
    command = [sys.executable, "-I", check.__file__, str(HERE / "correct" / "honest")]
    assert subprocess.run(command, capture_output=True).returncode == 0
