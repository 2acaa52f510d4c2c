"""Every small file is answered within bounds of time and memory, in words and not in a traceback.

The suite draws some pages at random; with ``BOMBS=n`` so many.
"""

from __future__ import annotations

import os
import resource
import subprocess
import sys
from pathlib import Path

import pytest

from tests.lies.bombs import PAGES, doubled, drawn

SECONDS, MEMORY = 10, 500 << 20
#: What the search may take of that.
TIME = "3"
DRAWN = int(os.environ.get("BOMBS", "12"))
#: Seeds that found something: a polynomial of 10^9 bits.
FOUND = (112,)


def bounded() -> None:
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS))


def answer(*words: object) -> tuple[int, str, str]:
    """What a command says within the bounds."""
    done = subprocess.run(
        [sys.executable, "-m", "verify", *map(str, words)],
        capture_output=True,
        encoding="utf-8",
        preexec_fn=bounded,
        check=False,
    )
    assert "Traceback" not in done.stderr
    assert done.returncode in (0, 1, 2, 3), done.stderr
    if done.returncode == 2:
        assert (done.stdout, done.stderr.count("\n")) == ("", 1)
    elif words[0] == "prove":
        assert "verdict" in done.stdout.lower()
    return done.returncode, done.stdout, done.stderr


@pytest.mark.parametrize("name", PAGES)
def test_pages(name: str, tmp_path: Path) -> None:
    path = tmp_path / "page.toml"
    path.write_text(PAGES[name]())
    assert path.stat().st_size <= 100_000
    code, _, _ = answer("prove", path, "--time", TIME)
    if name.startswith(("absolute-values", "a-bound")) and name != "absolute-values-of-tangents":
        assert code == 0


@pytest.mark.parametrize("seed", [*range(DRAWN), *FOUND])
def test_pages_that_are_drawn(seed: int, tmp_path: Path) -> None:
    path = tmp_path / "page.toml"
    path.write_text(drawn(seed))
    answer("prove", path, "--time", TIME)


@pytest.mark.parametrize("op", ["add", "mul", "min", "div"])
def test_writers_of_shared_terms(op: str, tmp_path: Path) -> None:
    """A term of 2^40 operations in 40 lines, in each form in which a statement is shown."""
    for name, data in zip(
        ("statement.json", "certificate.json"), doubled(40, op).files(), strict=True
    ):
        (tmp_path / name).write_bytes(data)
    for words in (
        ["check"],
        ["check", "--json"],
        ["check", "--latex"],
        ["check", "--markdown"],
        ["export", "coq"],
    ):
        assert answer(*words, tmp_path)[0] == 0
    assert answer("explain", tmp_path, "a")[0] == 0
    assert answer("graph", tmp_path, "--out", tmp_path / "a.dot")[0] in (0, 2)
    assert answer("export", "text", tmp_path)[0] == 2
    assert answer("export", "coq", "--readable", tmp_path)[0] == 2
    statement = tmp_path / "statement.json"
    assert answer("prove", statement, "--time", TIME)[0] in (0, 3)
    assert answer("prove", statement, "--json", "--time", TIME)[0] in (0, 3)
    assert answer("prove", statement, "--out", tmp_path / "out", "--time", TIME)[0] in (0, 3)
