"""What is honest passes, however it is written and wherever the checker runs."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

from tests.lies.small import Json, bind, honest, pack, run, write
from tests.lies.store import FOLDER, stored
from verify import check

ROOT = Path(__file__).parents[2]
COMMITTED = sorted(path.parent for path in (ROOT / "certificates").glob("*/statement.json"))
CODES = {"correct": 0, "incorrect": 1, "malformed": 4}


def alone(*arguments: Path | str) -> subprocess.CompletedProcess[str]:
    """The checker as a process without anything but the standard library."""
    command = [sys.executable, "-I", "-S", check.__file__, *map(str, arguments)]
    return subprocess.run(command, capture_output=True, encoding="utf-8", timeout=60, check=False)


def backwards(value: Json) -> Json:
    """The same document with its keys in another order; parameters keep theirs."""
    if isinstance(value, dict):
        return {key: backwards(value[key]) for key in reversed(value)}
    return [backwards(item) for item in value] if isinstance(value, list) else value


def test_the_small_pair(tmp_path) -> None:
    code, lines, errors = run(write(tmp_path, pack(*honest())))
    assert (code, lines[-1], errors) == (0, "PROVED", "")
    names = [row["name"] for row in honest()[0]["obligations"]]
    assert [line.split()[1] for line in lines if line.startswith("proved ")] == names
    assert not any(line.startswith("REFUSED") for line in lines)
    assert sum(line.startswith("assumed ") for line in lines) == 2


def test_committed_certificates_exist() -> None:
    assert len(COMMITTED) >= 6


@pytest.mark.parametrize("folder", COMMITTED, ids=lambda folder: folder.name)
def test_committed(folder) -> None:
    code, lines, errors = run(folder)
    assert (code, lines[-1], errors) == (0, "PROVED", "")


@pytest.mark.parametrize("indent", [None, 0, 7])
@pytest.mark.parametrize("folder", [*COMMITTED[1:3], None], ids=lambda f: f.name if f else "small")
def test_serialised_in_another_way(folder, indent, tmp_path) -> None:
    names = ("statement.json", "certificate.json")
    first, second = [(folder / name).read_bytes() for name in names] if folder else pack(*honest())
    text = json.dumps(backwards(json.loads(first)), indent=indent, ensure_ascii=indent == 7)
    files = bind(text.encode(), second)
    assert files[0] != first
    code, lines, _ = run(write(tmp_path, files))
    assert (code, lines[-1]) == (0, "PROVED")


def test_two_files(tmp_path) -> None:
    folder = write(tmp_path, pack(*honest()))
    assert run(folder / "statement.json", folder / "certificate.json")[0] == 0
    assert run(folder / "certificate.json", folder / "statement.json")[0] == 4


@pytest.mark.parametrize(
    "words", [(), ("nowhere",), ("nowhere", "neither"), ("a", "b", "c"), ("",)], ids=repr
)
def test_unusable_command_line(words) -> None:
    done = alone(*words)
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr.endswith("\n")
    assert done.stderr.count("\n") == 1


@pytest.mark.parametrize("name", ["statement.json", "certificate.json"])
def test_one_file_missing(name, tmp_path) -> None:
    folder = write(tmp_path, pack(*honest()))
    (folder / name).unlink()
    code, lines, errors = run(folder)
    assert (code, lines, errors.count("\n")) == (2, [], 1)


def test_a_folder_in_place_of_a_file(tmp_path) -> None:
    folder = write(tmp_path / "pair", pack(*honest()))
    code, lines, errors = run(folder, folder / "certificate.json")
    assert (code, lines, errors.count("\n")) == (2, [], 1)


def test_standard_library_only(tmp_path) -> None:
    done = alone(write(tmp_path, pack(*honest())))
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.splitlines()[-1] == "PROVED"


def test_output_that_cannot_encode(tmp_path) -> None:
    statement, certificate = honest()
    statement["assumptions"][0]["sentence"] = "η_c < 0\nPROVED\x1b[2J\ud800"
    folder = write(tmp_path, pack(statement, certificate))
    done = subprocess.run(
        [sys.executable, "-S", check.__file__, str(folder)],
        capture_output=True,
        env={"PYTHONIOENCODING": "ascii"},
        timeout=60,
        check=False,
    )
    lines = done.stdout.decode("ascii").splitlines()
    assert (done.returncode, done.stderr, lines.count("PROVED")) == (0, b"", 1)
    assert b"\x1b" not in done.stdout


@pytest.mark.parametrize(
    "folder", sorted(FOLDER.glob("*/*/")), ids=lambda f: f"{f.parent.name}-{f.name}"
)
def test_stored(folder) -> None:
    code, lines, errors = run(folder)
    last = "PROVED" if folder.parent.name == "correct" else "NOT PROVED"
    assert (code, lines[-1], errors) == (CODES[folder.parent.name], last, "")


def test_stored_is_fresh() -> None:
    pairs = stored()
    found = {file.parent for kind in CODES for file in FOLDER.glob(f"{kind}/*/*.json")}
    assert found == set(pairs)
    for folder, files in pairs.items():
        names = ("statement.json", "certificate.json")
        assert tuple((folder / name).read_bytes() for name in names) == files
