"""The job `map`: one file, whoever decides its chunks and however often it is interrupted."""

from __future__ import annotations

import os
import re
import signal
import subprocess
import sys
from collections.abc import Callable, Iterator
from concurrent.futures import ProcessPoolExecutor
from contextlib import contextmanager
from fractions import Fraction
from pathlib import Path

import pytest

from verify.spheres.map import grow as map_grow
from verify.spheres.map import log as map_log
from verify.spheres.map.grow import Target, grow, open_log, write_line
from verify.spheres.map.log import Chunk, LogMismatchError, Progress
from verify.spheres.map.planes import Phi, Plane
from verify.spheres.map.strip import BorderStrip
from verify.spheres.map.workers import Workers, workers
from verify.wire.inputs import InputError

ROOT = Path(__file__).parents[3]
PLANE = Phi(Fraction(3, 100), Fraction(1))
TARGET = Target(Fraction(1, 25), 10**6, 20)


@pytest.fixture(autouse=True)
def small_chunks(monkeypatch: pytest.MonkeyPatch) -> None:
    shorten(monkeypatch)


def shorten(patch: pytest.MonkeyPatch) -> None:
    patch.setattr(map_log, "CHUNK", 96)
    patch.setattr(map_grow, "CHUNK", 96)


def made(path: Path, staff: Workers, target: Target = TARGET, stop: int = 10**9) -> Progress:
    """The map in a file; it is interrupted after so many chunks."""
    progress = Progress(PLANE)
    with staff, open_log(str(path), progress) as file:
        for count, _ in enumerate(grow(progress, target, staff, lambda x: write_line(file, x)), 1):
            if count == stop:
                break
    return progress


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> bytes:
    path = tmp_path_factory.mktemp("map") / "log"
    with pytest.MonkeyPatch.context() as patch:
        shorten(patch)
        progress = made(path, workers(1, None))
    assert progress.undecided <= TARGET.undecided
    return path.read_bytes()


def test_two_processes_write_the_same_file(whole: bytes, tmp_path: Path) -> None:
    made(tmp_path / "log", workers(2, None))
    assert (tmp_path / "log").read_bytes() == whole


def test_chunks_decided_one_by_one_write_the_same_file(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    target = TARGET._replace(undecided=Fraction(1, 100))
    sizes, decide = [], map_grow.decide_chunks

    def spy(plane: Plane | BorderStrip, chunks: list[list[str]]) -> list[tuple[Chunk, float]]:
        sizes.append(len(chunks))
        return decide(plane, chunks)

    monkeypatch.setattr(map_grow, "decide_chunks", spy)
    made(tmp_path / "several", workers(1, None), target)
    assert max(sizes) > 1
    monkeypatch.setattr(map_grow, "MOST_CHUNKS", 1)
    sizes.clear()
    made(tmp_path / "one", workers(1, None), target)
    assert max(sizes) == 1
    assert (tmp_path / "one").read_bytes() == (tmp_path / "several").read_bytes()


@pytest.mark.parametrize("cut", [0, 1, 70])
def test_an_interrupted_map_goes_on(whole: bytes, tmp_path: Path, cut: int) -> None:
    """Also if its last line was cut short."""
    path = tmp_path / "log"
    assert made(path, workers(1, None), stop=3).boxes < made(path, workers(1, None), stop=4).boxes
    with path.open("r+b") as file:
        file.truncate(path.stat().st_size - cut)
    made(path, workers(1, None))
    assert path.read_bytes() == whole


def test_a_smaller_target_goes_on_with_the_log(whole: bytes, tmp_path: Path) -> None:
    path = tmp_path / "log"
    made(path, workers(1, None), Target(Fraction(1, 12), 10**6, 20))
    assert whole.startswith(path.read_bytes())
    made(path, workers(1, None))
    assert path.read_bytes() == whole
    before = path.stat().st_size
    made(path, workers(1, None), Target(Fraction(1, 12), 10**6, 20))
    assert path.stat().st_size == before


@pytest.mark.parametrize("target", [Target(Fraction(0), 300, 20), Target(Fraction(0), 10**6, 5)])
def test_budgets_end_a_map(tmp_path: Path, target: Target) -> None:
    progress = made(tmp_path / "log", workers(1, None), target)
    assert 256 <= progress.boxes < 600
    assert progress.undecided > 0


def test_the_log_of_another_map_is_not_touched(whole: bytes, tmp_path: Path) -> None:
    path = tmp_path / "log"
    path.write_bytes(whole)
    for plane in (Phi(Fraction(1, 20), Fraction(1)), PLANE._replace(y=(Fraction(0), Fraction(1)))):
        with pytest.raises(LogMismatchError):
            open_log(str(path), Progress(plane))
    path.write_bytes(whole.replace(b"uu", b"ud", 1))
    with pytest.raises(LogMismatchError):
        open_log(str(path), Progress(PLANE))


def test_the_areas_add_up(whole: bytes) -> None:
    progress = Progress(PLANE)
    assert progress.resume(iter(whole.splitlines(keepends=True))) == len(whole)
    size = {"c": Fraction(0), "d": Fraction(0)}
    for key, letter, _ in progress.decided():
        size[letter] += Fraction(1, 4 ** len(key))
    assert size == {letter: progress.share(letter) for letter in "cd"}
    assert progress.undecided == 1 - sum(size.values())


def killed(count: int) -> Callable[[], ProcessPoolExecutor]:
    """Executors whose first ones lose a worker as soon as it works."""
    made: list[ProcessPoolExecutor] = []

    def make() -> ProcessPoolExecutor:
        made.append(ProcessPoolExecutor(1))
        if len(made) <= count:
            pid = made[-1].submit(os.getpid).result()
            os.kill(pid, signal.SIGKILL)
        return made[-1]

    return make


def test_a_worker_that_dies_loses_nothing(whole: bytes, tmp_path: Path) -> None:
    made(tmp_path / "log", Workers(killed(2), 3))
    assert (tmp_path / "log").read_bytes() == whole


def test_workers_that_always_die(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="lost"):
        made(tmp_path / "log", Workers(killed(100), 3))


def test_ctrl_c_keeps_what_is_finished() -> None:
    """What was begun before still comes; nothing else does."""
    begun: list[int] = []

    def work(task: int) -> int:
        begun.append(task)
        if task == 2:
            raise KeyboardInterrupt
        return task

    results = workers(1, None).in_order(work, range(5))
    assert [next(results), next(results)] == [0, 1]
    with pytest.raises(KeyboardInterrupt):
        next(results)
    assert begun == [0, 1, 2]


def test_dask_writes_the_same_file(whole: bytes, tmp_path: Path) -> None:
    """Although one of its workers is killed."""
    distributed = pytest.importorskip("distributed")
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as c:
        with distributed.Client(c) as client:
            pids = client.run(os.getpid)
        progress, staff = Progress(PLANE), workers(1, c.scheduler_address)
        with staff, open_log(str(tmp_path / "log"), progress) as file:
            for _ in grow(progress, TARGET, staff, lambda line: write_line(file, line)):
                if pids:
                    os.kill(pids.popitem()[1], signal.SIGKILL)
                    pids.clear()
    assert (tmp_path / "log").read_bytes() == whole


@contextmanager
def dask_processes() -> Iterator[tuple[subprocess.Popen[str], str]]:
    """A scheduler with a worker, each a process of its own, and its address."""
    module, options = "distributed.cli.dask_", {"text": True, "cwd": ROOT}
    paths = os.environ | {"PYTHONPATH": str(ROOT)}
    command = [sys.executable, "-m", f"{module}scheduler", "--port", "0", "--no-dashboard"]
    with subprocess.Popen(command, stderr=subprocess.PIPE, env=paths, **options) as first:  # type: ignore[call-overload]
        said = iter(first.stderr.readline, "")
        address = next(found[0] for line in said if (found := re.search(r"tcp://[\d.:]+", line)))
        command = [sys.executable, "-m", f"{module}worker", address, "--nthreads", "1"]
        with subprocess.Popen(command, stderr=subprocess.DEVNULL, env=paths, **options) as second:  # type: ignore[call-overload]
            try:
                yield first, address
            finally:
                second.kill(), first.kill()


def test_a_scheduler_that_dies_loses_nothing(
    whole: bytes, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    """The map ends with one line; what was proved is in the log, and another run goes on."""
    pytest.importorskip("distributed")
    path, progress = tmp_path / "log", Progress(PLANE)
    with dask_processes() as (scheduler, address):
        staff = workers(1, address)
        with staff, open_log(str(path), progress) as file:
            results = grow(progress, TARGET, staff, lambda line: write_line(file, line))
            for _ in range(3):
                next(results)
            scheduler.kill()
            with pytest.raises(InputError, match="the log has what was proved"):
                list(results)
    assert capfd.readouterr().err == ""
    kept = path.read_bytes()
    assert whole.startswith(kept)
    assert 4 <= kept.count(b"\n") < whole.count(b"\n")
    made(path, workers(1, None))
    assert path.read_bytes() == whole


def test_no_dask_is_said_in_a_line() -> None:
    with pytest.raises(InputError, match="--dask"):
        workers(1, "tcp://127.0.0.1:1")
