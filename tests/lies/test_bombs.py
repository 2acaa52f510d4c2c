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

from tests.check.support import Pair
from tests.lies.bombs import PAGES, doubled, drawn, lettered, nested_powers

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


def write(pair: Pair, folder: Path) -> None:
    for name, data in zip(("statement.json", "certificate.json"), pair.files(), strict=True):
        (folder / name).write_bytes(data)


@pytest.mark.parametrize("op", ["add", "mul", "min", "div"])
def test_writers_of_shared_terms(op: str, tmp_path: Path) -> None:
    """A term of 2^40 operations in 40 lines, in each form in which a statement is shown."""
    write(doubled(40, op), tmp_path)
    for words in (
        ["check"],
        ["check", "--json"],
        ["check", "--latex"],
        ["check", "--markdown"],
        ["export", "coq"],
    ):
        assert answer(*words, tmp_path)[0] == 0
    assert answer("explain", tmp_path, "a")[0] == 0
    assert answer("export", "text", tmp_path)[0] == 2
    assert answer("export", "coq", "--readable", tmp_path)[0] == 2
    statement = tmp_path / "statement.json"
    assert answer("prove", statement, "--time", TIME)[0] in (0, 3)
    assert answer("prove", statement, "--json", "--time", TIME)[0] in (0, 3)
    assert answer("prove", statement, "--out", tmp_path / "out", "--time", TIME)[0] in (0, 3)


@pytest.mark.parametrize(
    ("letter", "tex"), [("x" * 50_000, "k"), ("k", r"\alpha" * 10_000), ("k", "k")]
)
def test_writers_of_long_letters_and_deep_terms(letter: str, tex: str, tmp_path: Path) -> None:
    """A letter is as long as a file likes, and stands in a term as deep as the checker reads."""
    write(lettered(letter, tex), tmp_path)
    for words in (
        ["check", "-v"],
        ["check", "--json"],
        ["check", "--latex", "--full"],
        ["check", "--markdown"],
    ):
        assert answer(*words, tmp_path)[0] == 0
    assert answer("explain", tmp_path, "a")[0] == 0
    assert answer("explain", "-v", tmp_path, "a")[0] == 0


def test_a_map_of_nested_powers(tmp_path: Path) -> None:
    """Powers are products in a log: written out, 14 levels of them are 10^18 operations."""
    path = tmp_path / "family.toml"
    path.write_text(nested_powers(14))
    code, _, err = answer("map", path, "--x", "a", "--y", "b", "--boxes", "20")
    assert (code, "operations" in err) == (2, True)


def test_half_an_escaped_letter(tmp_path: Path) -> None:
    """What no file can have in UTF-8 is refused before anything is proved of it."""
    pair = doubled(1)
    pair.statement["title"] = "half of it: \ud800"
    write(pair, tmp_path)
    assert answer("prove", tmp_path / "statement.json")[0] == 2
    pair.statement["title"] = "all of it: \U0001d4d0"
    write(pair, tmp_path)
    assert answer("prove", tmp_path / "statement.json")[0] == 0
