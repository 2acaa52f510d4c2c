"""The engine stands alone: language, prover and wire, in a copy without the rest of the program."""

from __future__ import annotations

import ast
import shutil
import subprocess
import sys
from functools import cache
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
#: What is copied of the program, and of the tests.
ENGINE = ("__init__.py", "check.py", "language", "library.py", "prover", "py.typed", "wire")
ROOMS = ("language", "prover", "wire")
#: What tests of the engine may import: the engine, and each other.
OURS = {"verify", *(f"verify.{Path(name).stem}" for name in ENGINE)}

DATA = (".toml", ".json")

PAGE = """
title = "A contraction"
[constants]
q = "(3 - sqrt(5))/4"
delta = "min(q/2, 0.1)"
h = "1 - 2*(q + delta)"
[contexts.near]
variables = ["x"]
given = ["-delta <= x <= delta"]
[rows]
positive = "0 < h"
slope = "2*(q + x) <= 1 - h"
rounded = "q <= 0.19"
"""

PROGRAM = """
import pkgutil, sys
from importlib import import_module
import verify
for module in pkgutil.walk_packages(verify.__path__, "verify."):
    import_module(module.name)
from verify.prover.budget import WORK, WorkBudget
from verify.wire.questions import decide_page, read_page_of
page = read_page_of("page.toml", sys.stdin.buffer.read(), {})
print(*(found.verdict for _, found in decide_page(page, WorkBudget(WORK)).rows))
"""


@cache
def imported(path: Path) -> frozenset[str]:
    """The names of modules in the import statements of a file, wherever they stand."""
    nodes = [*ast.walk(ast.parse(path.read_text(encoding="utf-8")))]
    names = {alias.name for node in nodes if isinstance(node, ast.Import) for alias in node.names}
    for node in nodes:
        if isinstance(node, ast.ImportFrom) and node.module:
            names |= {node.module, *(f"{node.module}.{alias.name}" for alias in node.names)}
    return frozenset(name for name in names if name.split(".")[0] in ("verify", "tests"))


def of_engine(path: Path) -> bool:
    """Whether a file of tests imports the engine and tests of the engine only."""
    for name in imported(path):
        parts = name.split(".")
        if parts[0] == "verify":
            room = ROOT.joinpath(*parts[:2])
            exists = room.is_dir() or room.with_suffix(".py").exists()
            if exists and ".".join(parts[:2]) not in OURS:
                return False
            continue
        file = ROOT.joinpath(*parts).with_suffix(".py")
        if file.exists() and not (parts[1] in ROOMS and of_engine(file)):
            return False
    return True


TESTS = [p for room in ROOMS for p in sorted((ROOT / "tests" / room).glob("*.py")) if of_engine(p)]


@pytest.fixture(scope="module")
def copy(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the engine and its tests."""
    folder = tmp_path_factory.mktemp("engine")
    skipped = shutil.ignore_patterns("__pycache__")
    for name in ENGINE:
        source, target = ROOT / "verify" / name, folder / "verify" / name
        target.parent.mkdir(exist_ok=True)
        if source.is_dir():
            shutil.copytree(source, target, ignore=skipped)
        else:
            shutil.copy(source, target)
    (folder / "verify" / "data").mkdir()
    (folder / "verify" / "data" / "packaged.txt").touch()  # nothing comes with it
    beside = [p for room in ROOMS for p in (ROOT / "tests" / room).rglob("*.*") if p.suffix in DATA]
    shared = [ROOT / "tests" / name for name in ("__init__.py", "conftest.py", "slow.txt")]
    for path in (*shared, *beside, *TESTS):
        target = folder / path.relative_to(ROOT)
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(path, target)
    return folder


def alone(folder: Path, *words: str, given: str = "") -> subprocess.CompletedProcess[str]:
    """What a program says in the copy; the installed program is not on its path."""
    start = f"import sys; sys.path[:0] = [{str(folder)!r}]; sys.dont_write_bytecode = True\n"
    words = (sys.executable, "-c", start + words[0], *words[1:])
    return subprocess.run(words, input=given, capture_output=True, text=True, cwd=folder)


def test_every_module_is_loaded_and_a_page_is_decided(copy: Path) -> None:
    done = alone(copy, PROGRAM, given=PAGE)
    assert done.returncode == 0, done.stderr
    assert done.stdout.split() == ["proved", "proved", "refuted"]


def test_the_tests_of_the_engine_pass(copy: Path) -> None:
    program = f"""
import verify, pytest
assert verify.__file__.startswith({str(copy)!r})
sys.exit(pytest.main(["-q", "-x", "--import-mode=importlib", "-m", "not slow", *sys.argv[1:]]))
"""
    clocks = ["-k", "not end_in_time"]  # a clock says nothing of what is missing
    assert len(TESTS) > 20
    done = alone(copy, program, *clocks, *[str(path.relative_to(ROOT)) for path in TESTS])
    assert done.returncode == 0, done.stdout[-3000:]
