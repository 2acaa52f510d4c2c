"""Writing files: all of them or none, and nothing left behind."""

from __future__ import annotations

import json
import os
import random
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import pytest

from verify.cli import files
from verify.spheres.scene import scene_files
from verify.wire.inputs import InputError

ROOT = Path(__file__).resolve().parents[2]
NAMES = ("statement.json", "certificate.json", f"cited/{'0' * 64}.json")


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


def test_what_is_no_regular_file_is_left_as_it_is(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")  # and a device such as /dev/null, where one may write into /dev
    (tmp_path / "link").symlink_to("pipe")
    for name in ("pipe", "link"):
        for write in (
            lambda name=name: files.test_folder("--csv", str(tmp_path), name),
            lambda name=name: files.write_file("--csv", str(tmp_path / name), "new"),
        ):
            with pytest.raises(InputError, match=f"--csv: '.*{name}' is no regular file; name"):
                write()
    assert (tmp_path / "pipe").is_fifo()
    assert sorted(path.name for path in tmp_path.iterdir()) == ["link", "pipe"]


def test_a_link_stays_and_its_file_is_written(tmp_path: Path) -> None:
    (tmp_path / "old").write_text("old")
    (tmp_path / "link").symlink_to("old")  # /dev/stdout, say, whose output goes into a file
    files.write_file("--csv", str(tmp_path / "link"), "new")
    assert (tmp_path / "link").is_symlink()
    assert (tmp_path / "old").read_text() == "new"


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


# --- a certificate's folder is one run's ----------------------------------------------------------


def contents(run: str, theorem: str = "t") -> dict[str, bytes]:
    """The files of a run; two of them and what is cited have to fit together."""
    text = json.dumps({"theorem": theorem, "run": run, "long": "x" * 20_000}).encode()
    cited = {} if run.endswith("0") else {NAMES[2]: text}
    return {NAMES[0]: text, NAMES[1]: text} | cited


def run_of(folder: Path) -> str | None:
    """Whose files a folder has, each of them; None if there is no folder."""
    if not folder.exists():
        return None
    found = {str(path.relative_to(folder)): path for path in folder.rglob("*") if path.is_file()}
    runs = {json.loads(path.read_bytes())["run"] for path in found.values()}
    assert len(runs) == 1, runs
    (run,) = runs
    assert found.keys() == contents(run).keys()
    return str(run)


def test_of_two_writers_at_once_one_is_whole(tmp_path: Path) -> None:
    folder, rounds, errors = tmp_path / "new", 150, []
    barrier = threading.Barrier(4, timeout=30)

    def write(name: str) -> None:
        try:
            for number in range(rounds):
                barrier.wait()
                files.write_folder("--out", str(folder), contents(f"{name}{number}"))
                barrier.wait()
                if name == "a":
                    assert str(run_of(folder))[1:] == str(number)
        except BaseException as error:
            errors.append(error)
            barrier.abort()

    threads = [threading.Thread(target=write, args=(name,)) for name in "abcd"]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert errors == []
    assert [path.name for path in tmp_path.iterdir()] == ["new"]


#: Writes one run after the other until it is killed.
WRITER = """
import sys
from itertools import count
from tests.cli.test_files import contents
from verify.cli.files import write_folder
for number in count():
    write_folder("--out", sys.argv[1], contents(f"{sys.argv[2]}{number}"))
    if number == 3:
        print("ready", flush=True)
"""


@pytest.mark.parametrize("sign", [signal.SIGINT, signal.SIGKILL])
def test_a_folder_is_whole_whenever_its_writers_are_killed(
    tmp_path: Path, sign: signal.Signals
) -> None:
    choose, folder, found = random.Random(7), tmp_path / "new", 0
    for _ in range(8):
        command = [sys.executable, "-c", WRITER, str(folder)]
        writers = [
            subprocess.Popen([*command, name], cwd=ROOT, stdout=-1, stderr=subprocess.DEVNULL)
            for name in "ab"
        ]
        for writer in writers:
            assert writer.stdout is not None
            assert writer.stdout.readline() == b"ready\n"
        time.sleep(choose.uniform(0, 0.02))
        for writer in writers:
            writer.send_signal(sign)
        for writer in writers:
            writer.communicate(timeout=30)
        found += run_of(folder) is not None
    assert found


#: Certifies; each time that a file is moved somebody asks it to end.
ASKED = """
import os, sys
from verify.__main__ import run
sign = int(sys.argv.pop(1))
def asked(name, real):
    def move(*places):
        os.kill(os.getpid(), sign)
        return real(*places)
    setattr(os, name, move)
for name in ("mkdir", "rename", "replace"):
    asked(name, getattr(os, name))
run()
"""


@pytest.mark.parametrize("sign", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP])
@pytest.mark.parametrize("option", [["--out", "new"], ["--out", "old"], ["--csv", "new"]])
def test_what_is_being_written_is_finished(
    option: list[str], sign: signal.Signals, tmp_path: Path
) -> None:
    scene = str(ROOT / "certificates/scenes/on-a-line.toml")
    command = [sys.executable, "-c", ASKED, str(int(sign)), "scene", scene, *option]
    environment = os.environ | {"PYTHONPATH": str(ROOT)}
    files.write_folder("--out", str(tmp_path / "old"), {"report.md": b"old"})
    done = subprocess.run(command, cwd=tmp_path, env=environment, capture_output=True, check=False)
    assert done.returncode == {signal.SIGINT: 130, signal.SIGTERM: 143}.get(sign, -sign)
    assert b"Traceback" not in done.stderr
    left = {"old", "new"} if (tmp_path / "new").exists() else {"old"}
    assert {path.name for path in tmp_path.iterdir()} == left
    assert any((tmp_path / "old").iterdir())


def test_files_of_somebody_else_are_kept(tmp_path: Path) -> None:
    for name in ("notes.txt", "cited/mine.json", "certificate.json/x"):
        folder = tmp_path / name.replace("/", "-")
        (folder / name).parent.mkdir(parents=True)
        (folder / name).write_text("mine")
        with pytest.raises(InputError, match=r"has other files .*name a new folder"):
            files.test_folder("--out", str(folder), *NAMES[:2])
        with pytest.raises(InputError, match=r"has other files .*name a new folder"):
            files.write_folder("--out", str(folder), contents("a1"))
        assert [p for p in folder.rglob("*") if p.is_file()] == [folder / name]


def test_the_certificate_of_another_theorem_is_kept(tmp_path: Path) -> None:
    folder = tmp_path / "new"
    files.write_folder("--out", str(folder), contents("a1"))
    with pytest.raises(InputError, match="has a certificate of 't'; name another folder"):
        files.write_folder("--out", str(folder), contents("b2", "other"))
    assert run_of(folder) == "a1"
    files.write_folder("--out", str(folder), contents("b2"))
    assert run_of(folder) == "b2"
    with pytest.raises(InputError, match="Not a directory"):
        files.write_folder("--out", str(folder / "statement.json"), contents("b3"))
    assert run_of(folder) == "b2"
    (folder / "statement.json").write_text("mine")
    with pytest.raises(InputError, match="is no statement"):
        files.test_folder("--out", str(folder), *NAMES[:2])
    assert [path.name for path in tmp_path.iterdir()] == ["new"]


def test_the_folder_that_one_is_in_stays(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "x").mkdir()
    monkeypatch.chdir(tmp_path / "x")
    for name in (".", "..", str(tmp_path / "x"), "/"):
        with pytest.raises(InputError, match="has to stay where it is"):
            files.write_folder("--out", name, contents("a1"))
    files.write_folder("--out", "y", contents("a1"))
    assert run_of(tmp_path / "x/y") == "a1"


# --- what has no end is not read ------------------------------------------------------------------


def test_a_folder_of_cited_files_has_an_end(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert files.read_cited("STATEMENT", str(tmp_path)) == {}
    (tmp_path / "cited").mkdir()
    for name in "abc":
        (tmp_path / "cited" / name).write_bytes(name.encode() * 10)
    assert files.read_cited("STATEMENT", str(tmp_path)) == {s: s.encode() * 10 for s in "abc"}
    monkeypatch.setattr(files, "MAX_CITED", 29)
    with pytest.raises(InputError, match=r"STATEMENT: .*more than 29 bytes"):
        files.read_cited("STATEMENT", str(tmp_path))
    monkeypatch.setattr(files, "MAX_CITED", 30)
    os.mkfifo(tmp_path / "cited" / "d")
    with pytest.raises(InputError, match="no regular file"):
        files.read_cited("STATEMENT", str(tmp_path))


@pytest.mark.parametrize(
    ("name", "words", "code"),
    [
        ("a.toml", ["scene", "."], 2),
        ("a.toml", ["scene", "a.toml"], 2),
        ("a.json", ["prove", "a.json"], 2),
        ("statement.json", ["explain", ".", "x"], 2),
        ("statement.json", ["check", "."], 2),
        ("index.html", ["report", "--compare", "--directory", "."], 2),
    ],
)
def test_nobody_waits_at_a_pipe(tmp_path: Path, name: str, words: list[str], code: int) -> None:
    os.mkfifo(tmp_path / name)
    command = [sys.executable, "-m", "verify", *words]
    environment = os.environ | {"PYTHONPATH": str(ROOT)}
    done = subprocess.run(
        command,
        cwd=tmp_path,
        env=environment,
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
    )
    assert done.returncode == code
    assert "Traceback" not in done.stderr
    assert name in done.stdout + done.stderr
    with pytest.raises(InputError, match="cannot be read"):
        scene_files.scene_bytes(str(tmp_path / name))
