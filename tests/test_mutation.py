"""The runner of mutants: what it changes, and that a change is noticed where a test looks at it."""

from __future__ import annotations

from argparse import Namespace
from pathlib import Path

import pytest

from tests import mutation
from tests.mutation import STAGES, excused, mutants

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


@pytest.mark.parametrize("file", STAGES)
def test_each_excused_mutant_is_one_and_has_a_reason(file: str) -> None:
    names = [mutant.name for mutant in mutants((mutation.ROOT / file).read_bytes())]
    assert len({*names}) == len(names) > 2000
    assert all(excused(file, names).values())


@pytest.fixture
def a_tree(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> str:
    """A tree with a file, of which one function is tested."""
    for folder in ("verify", "tests/excused"):
        (tmp_path / folder).mkdir(parents=True)
    (tmp_path / "verify/__init__.py").write_text("")
    (tmp_path / "verify/small.py").write_text("def f(x):\n    return x - 1\ndef g(x):\n    -x\n")
    test = "from verify import small\ndef test_f():\n    assert small.f(3) == 2\n"
    (tmp_path / "tests/test_small.py").write_text(test)
    monkeypatch.setattr(mutation, "ROOT", tmp_path)
    monkeypatch.setattr(mutation, "EXCUSED", tmp_path / "tests/excused")
    monkeypatch.setitem(STAGES, "verify/small.py", (("tests/test_small.py",),))
    monkeypatch.setitem(mutation.IGNORED, "verify/small.py", [])
    return "verify/small.py"


def test_what_is_noticed(a_tree: str, capsys: pytest.CaptureFixture[str]) -> None:
    left_out = mutation.EXCUSED / "small.txt"
    left_out.write_text("")
    assert mutation.examine(a_tree, ALL) == 60
    said = capsys.readouterr().out.splitlines()
    assert said[:2] == ["g: {-x => pass}", "g: {-x => (x)}"]
    assert said[2].startswith(
        "verify/small.py: 3 of 5 mutants are noticed (60.0 %), 0 not tried; 0 "
    )
    left_out.write_text("# Nobody\n# asks for it.\n" + "\n".join(said[:2]))
    assert mutation.examine(a_tree, ALL) == 100
    assert excused(a_tree, said) == dict.fromkeys(said[:2], "Nobody asks for it.")
    left_out.write_text("# Why.\n~ g: .*=> pass}\n")
    assert excused(a_tree, said) == {said[0]: "Why."}
    left_out.write_text("# Why.\nno mutant\n")
    with pytest.raises(SystemExit, match="no mutant"):
        mutation.examine(a_tree, ALL)
    left_out.write_text("")
    (mutation.ROOT / a_tree).write_text("def f(x):\n    return x\n")
    with pytest.raises(SystemExit, match="as it stands does not pass"):
        mutation.examine(a_tree, ALL)
