"""No lie passes, and each is answered by a line that says why."""

from __future__ import annotations

import resource
import subprocess
import sys

import pytest

from tests.lies.lies import LIES, row
from tests.lies.small import SECONDS, honest, pack, run, write
from verify import check

HEAVY = [
    name
    for name in LIES
    if name.startswith(("nesting", "squares-of", "more-work", "an-expansion", "a-tower"))
    or name.endswith("mb")
]
MEMORY = 1 << 30
SLOW = "more-work-than-the-checker-does"  # takes the whole budget of the checker


def judge(name: str, code: int, lines: list[str], errors: str) -> None:
    """The exit code, the last line, and a line with a reason."""
    assert (code, lines[-1:], errors) == (LIES[name].code, ["NOT PROVED"], "")
    start = "REFUSED" if code == 1 else "malformed: "
    reasons = [line for line in lines if line.startswith(start)]
    assert any(LIES[name].word in line and line.partition(": ")[2] for line in reasons), lines
    assert not any("Traceback" in line for line in lines)
    assert all(len(line) < 2000 for line in lines)


def test_enough_lies() -> None:
    assert len(LIES) >= 70
    assert len({lie.files() for lie in LIES.values()}) == len(LIES)


@pytest.mark.parametrize("name", [name for name in LIES if name != SLOW])
def test_lie(name, tmp_path) -> None:
    judge(name, *run(write(tmp_path, LIES[name].files())))


@pytest.mark.parametrize("name", HEAVY)
def test_heavy_lie_in_bounded_memory(name, tmp_path) -> None:
    folder = write(tmp_path, LIES[name].files())
    done = subprocess.run(
        [sys.executable, "-I", check.__file__, str(folder)],
        capture_output=True,
        encoding="utf-8",
        timeout=SECONDS * (3 if name == SLOW else 1),
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY)),
        check=False,
    )
    judge(name, done.returncode, done.stdout.splitlines(), done.stderr)


@pytest.mark.parametrize("name", ["interval", "cuts", "bernstein", "max"])
def test_strict_turned_weak_stays_true(name, tmp_path) -> None:
    statement, certificate = honest()
    row(statement, name)["claim"][0] = "<="
    code, lines, _ = run(write(tmp_path, pack(statement, certificate)))
    assert (code, lines[-1]) == (0, "PROVED")
