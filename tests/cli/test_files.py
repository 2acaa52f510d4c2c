"""Writing files: all of them or none, and nothing left behind."""

from __future__ import annotations

from pathlib import Path

import pytest

from verify.cli import files
from verify.jobs.inputs import InputError


def test_files_may_lie_in_folders_of_their_own(tmp_path: Path) -> None:
    contents = {"a.json": b"1", "cited/b.json": b"2"}
    files.write_all("--out", str(tmp_path / "x/y"), contents)
    found = {
        str(path.relative_to(tmp_path / "x/y")): path.read_bytes()
        for path in (tmp_path / "x/y").rglob("*")
        if path.is_file()
    }
    assert found == contents


def test_all_or_none(tmp_path: Path) -> None:
    (tmp_path / "b").mkdir()
    with pytest.raises(InputError, match="--out: "):
        files.write_all("--out", str(tmp_path), {"a": b"1", "new/c": b"2", "b": b"3"})
    assert [path.name for path in tmp_path.iterdir()] == ["b"]


def test_a_tested_folder_is_left_as_it_was(tmp_path: Path) -> None:
    (tmp_path / "a").write_text("mine")
    files.test_folder("--out", str(tmp_path), "a", "cited/b")
    files.test_folder("--out", str(tmp_path / "x/y"), "a")
    files.test_folder("--out", None, "a")
    assert [path.name for path in tmp_path.iterdir()] == ["a"]
    assert (tmp_path / "a").read_text() == "mine"
    with pytest.raises(InputError, match="cannot be written"):
        files.test_folder("--out", "y" * 300, "a")


def test_an_empty_path_is_no_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    for write in (lambda: files.test_folder("--out", "", "a"), lambda: _write_a("")):
        with pytest.raises(InputError, match="--out: '' is no folder"):
            write()
    assert not [*tmp_path.iterdir()]


def _write_a(directory: str) -> None:
    files.write_all("--out", directory, {"a": b"1"})
