"""The runner of mutants: what it changes, and that a change is noticed where a test looks at it."""

from __future__ import annotations

from argparse import Namespace
from pathlib import Path
from typing import Any

import pytest

from tests import mutation
from tests.mutation import TESTS, excused, mutants

ALL = Namespace(sample=None, seed=1, jobs=1, match="", seconds=600.0)
SOURCE = b'''"""A file."""

def least(x: int, y: int = 3) -> int:  # a comment
    """The least."""
    if x < 0 and y:
        raise ValueError(f"found {x + 1}")
    need(x != 1, "a text")
    return min(x, y) + step(x, y)
'''
NAMES = """
least: def least(x: int, y: int = {3 => (4)}) -> int:
least: def least(x: int, y: int = {3 => (2)}) -> int:
least: if {x < 0 and y => True}:
least: if {x < 0 and y => False}:
least: if {x < 0 and y => (x < 0 or y)}:
least: if {x < 0 and y => (y)}:
least: if {x < 0 and y => (x < 0)}:
least: if {x < 0 => (x <= 0)} and y:
least: if {x < 0 => (x > 0)} and y:
least: if x < {0 => (1)} and y:
least: if x < {0 => (-1)} and y:
least: {raise ValueError(f"found {x + 1}") => pass}
least: {need(x != 1, "a text") => pass}
least: need({x != 1 => (x == 1)}, "a text")
least: need(x != {1 => (2)}, "a text")
least: need(x != {1 => (0)}, "a text")
least: return {min(x, y) + step(x, y) => (min(x, y) - step(x, y))}
least: return {min(x, y) => (max(x, y))} + step(x, y)
least: return {min(x, y) => (x)} + step(x, y)
least: return {min(x, y) => (y)} + step(x, y)
least: return min(x, y) + {step(x, y) => (step(y, x))}
"""


def test_all_mutants_of_a_function() -> None:
    found = mutants(SOURCE)
    assert [mutant.name for mutant in found] == NAMES.split("\n")[1:-1]
    for mutant in found:
        changed = SOURCE[: mutant.start] + mutant.text.encode() + SOURCE[mutant.end :]
        compile(changed, "mutant", "exec")


@pytest.mark.parametrize("file", TESTS)
def test_each_excused_mutant_is_one_and_has_a_reason(file: str) -> None:
    names = [mutant.name for mutant in mutants((mutation.ROOT / file).read_bytes())]
    assert len({*names}) == len(names) > 2000
    assert all(excused(file, names).values())


def test_the_lines_of_a_mutant() -> None:
    """Those of its statement, and those in the body of the outermost function around it."""
    source = (
        b"A = 1\nif (\n    A\n    < 2):\n    def f(x):\n        def g(y):\n            return -y\n"
    )
    source += b"        return g(\n            x + 1\n        )\n"
    found = {mutant.name: mutant for mutant in mutants(source)}

    def lines(name: str) -> list[list[int]]:
        sets = (found[name].lines, found[name].function)
        return [[i for i in range(20) if bits >> i & 1] for bits in sets]

    assert lines(": A = {1 => (2)}") == [[1], []]
    assert lines(": < {2 => (3)}):") == [[2, 3, 4], []]
    assert lines("f.g: return {-y => (y)}") == [[7], [6, 7, 8, 9, 10]]
    assert lines("f: {x + 1 => (x - 1)}") == [[8, 9, 10], [6, 7, 8, 9, 10]]
    assert found["f.g: return {-y => (y)}"].where == "f.g"


def test_a_marked_file_does_the_same_and_notes_its_lines() -> None:
    source = b"""from __future__ import annotations
class A:
    \"\"\"Text.\"\"\"
    x: int = 1
def f(n: Unknown):
    for i in range(n):
        if i == 1:
            return i
        elif i > 1:
            pass
        else:
            i += 1
    else:
        n = -1
    try:
        return A.x
    finally:
        n = 2
"""
    names: dict[str, Any] = {"__name__": "marked"}
    exec(mutation.marked(source), names)
    assert [i for i, is_run in enumerate(names["LINES"]) if is_run] == [1, 2, 3, 4, 5]
    names["LINES"][:] = bytes(len(names["LINES"]))
    assert names["f"](2) == 1
    assert [i for i, is_run in enumerate(names["LINES"]) if is_run] == [6, 7, 8, 9, 12]
    assert names["f"](0) == 1
    found = [i for i, is_run in enumerate(names["LINES"]) if is_run]
    assert found == [6, 7, 8, 9, 12, 14, 15, 16, 18]


SMALL = """
LEAST = 2
def f(x):
    return x - 1
def g(x):
    -x
def h(x):
    if x > LEAST:
        while x != 5:
            x += 1
    return x
def at_once(x):
    return x + 4
if __name__ == "__main__":
    print(f(3) + h(6 - 1))
"""
TEST = """
import subprocess, sys
from pathlib import Path
from verify import small
FIVE = small.at_once(1)
def test_f():
    assert small.f(3) == 2
def test_g():
    small.g(1)
def test_h():
    assert [small.h(i) for i in (2, 3, 4)] == [2, 5, 5]
def test_at_once():
    assert FIVE == 5
def test_alone():
    command = [sys.executable, "-I", small.__file__]
    assert subprocess.run(command, capture_output=True).stdout == b"7\\n"
"""


@pytest.fixture
def a_tree(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> str:
    """A tree with a file, of which most functions are tested."""
    for folder in ("verify", "tests/excused"):
        (tmp_path / folder).mkdir(parents=True)
    (tmp_path / "verify/__init__.py").write_text("")
    (tmp_path / "verify/small.py").write_text(SMALL)
    (tmp_path / "tests/test_small.py").write_text(TEST)
    monkeypatch.setattr(mutation, "ROOT", tmp_path)
    monkeypatch.setattr(mutation, "EXCUSED", tmp_path / "tests/excused")
    monkeypatch.setattr(mutation, "PATIENCE", 1)
    monkeypatch.setitem(TESTS, "verify/small.py", ["tests/test_small.py"])
    return "verify/small.py"


UNNOTICED = [
    ': if {__name__ == "__main__" => True}:',
    "g: {-x => (x)}",
    "g: {-x => pass}",
]


def test_what_is_noticed(a_tree: str, capsys: pytest.CaptureFixture[str]) -> None:
    """Also what only a process of its own shows, and what is run while tests are collected."""
    left_out = mutation.EXCUSED / "small.txt"
    left_out.write_text("")
    share = mutation.examine(a_tree, ALL)
    said = capsys.readouterr().out.splitlines()
    assert sorted(said[:-1]) == UNNOTICED
    count = len(mutants(SMALL.encode()))
    assert said[-1].startswith(
        f"verify/small.py: {count - 3} of {count} mutants are noticed ({share:.1f} %), "
        "0 not tried; 0 more are excused"
    )
    left_out.write_text("# Nobody\n# asks for it.\n" + "\n".join(UNNOTICED))
    assert mutation.examine(a_tree, ALL) == 100


def test_a_file_that_does_not_pass(a_tree: str) -> None:
    (mutation.EXCUSED / "small.txt").write_text("")
    (mutation.ROOT / a_tree).write_text("def f(x):\n    return x\n")
    with pytest.raises(SystemExit, match="as it stands does not pass"):
        mutation.examine(a_tree, ALL)


def test_what_is_excused(a_tree: str) -> None:
    left_out = mutation.EXCUSED / "small.txt"
    left_out.write_text("# Nobody\n# asks for it.\n" + "\n".join(UNNOTICED[1:3]))
    assert excused(a_tree, UNNOTICED) == dict.fromkeys(UNNOTICED[1:3], "Nobody asks for it.")
    left_out.write_text("# Why.\n~ g: .*=> pass}\n")
    assert excused(a_tree, UNNOTICED) == {UNNOTICED[2]: "Why."}
    left_out.write_text("# Why.\nno mutant\n")
    with pytest.raises(SystemExit, match="no mutant"):
        mutation.examine(a_tree, ALL)
