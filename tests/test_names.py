"""No two modules, functions or classes of one name for different things.

The same name in two places is an interface: what is listed here means the same thing wherever it
stands. A folder inside a room has a language of its own: the letters of a part of the paper, the
words of a page or of a proof assistant; at most one module of that name lies outside of such. The
two checkers are left out: they import nothing of the package, and say by the names of the language
and of the rules that they mean the same by them.
"""

from __future__ import annotations

import ast
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path

ROOM = Path(__file__).parent.parent / "verify"

#: Public names that several modules share: what each of them is there, and in which rooms.
SHARED = {
    "run": ("what a command does, or the program", ("cli", "__main__.py")),
    "screen": ("what a terminal shows of an outcome", ("views",)),
    "figure": ("the figure that a module of plots draws", ("views",)),
    "statement": ("the statement of a part of the paper", ("paper", "spheres")),
    "chapters": ("the chapters of a part", ("paper", "spheres")),
    "context": ("the context of a chapter", ("paper", "spheres")),
    "following": ("the state after a collision", ("paper", "spheres")),
    "definitions": ("what the constants of a context are", ("paper", "spheres")),
    "givens": ("what a context is given", ("paper", "spheres")),
    "conditions": ("what a theorem asks, or the givens of a context", ("paper", "spheres")),
    "closes": ("that the sharper theorem applies, in one arithmetic", ("spheres",)),
    "parameter": ("a parameter of a map, in one arithmetic", ("spheres",)),
    "lines": ("the lines of a chapter, in its context", ("paper", "spheres")),
    "ground_lines": ("the lines of a chapter that have no variables", ("paper",)),
    "premises": ("the facts which say that the givens hold", ("paper", "spheres")),
    "main": ("what runs where a module is the program", ("cli", "paper")),
    "prove": ("decides a statement", ("library.py", "prover")),
    "rows": ("the rows of a section of the paper", ("paper",)),
    "misprints": ("what a section of the text prints and is false", ("paper",)),
}

#: A subject has one name in every room: its command, its job, its views, its part of the paper.
SUBJECTS = {
    *("bench", "check", "everywhere", "explain", "report", "spectrum", "stress"),
    *("theorem1", "parameters", "box", "scene", "sharper", "slack", "classification", "numbering"),
    *("thresholds", "elsewhere", "map", "prove", "separatrix"),
}


def modules() -> Iterator[Path]:
    for path in sorted(ROOM.rglob("*.py")):
        if path not in (ROOM / "check.py", ROOM / "check_map.py"):
            yield path


def definitions(path: Path) -> Iterator[str]:
    for node in ast.parse(path.read_text(encoding="utf-8")).body:
        if isinstance(node, ast.FunctionDef | ast.ClassDef) and not node.name.startswith("_"):
            yield node.name


def places() -> dict[str, list[str]]:
    found: dict[str, list[str]] = defaultdict(list)
    for path in modules():
        for name in definitions(path):
            found[name].append(path.relative_to(ROOM).as_posix())
    return found


def test_a_name_in_two_places_means_one_thing() -> None:
    strange = {}
    for name, where in places().items():
        rooms = {path.split("/")[0] for path in where}
        shared = name in SHARED and rooms <= set(SHARED[name][1])
        folders = [path.rpartition("/")[0] for path in where]
        own = len(set(folders)) == len(folders) and sum("/" not in f for f in folders) <= 1
        if len(where) > 1 and not (shared or own):
            strange[name] = where
    assert not strange


def test_modules_of_one_name_have_one_subject() -> None:
    found: dict[str, list[str]] = defaultdict(list)
    for path in modules():
        if path.stem not in ("__init__", "__main__"):
            found[path.stem].append(path.relative_to(ROOM).parent.as_posix())
    strange = {}
    for name, folders in found.items():
        one_a_folder = len(set(folders)) == len(folders)
        fine = one_a_folder and (name in SUBJECTS or sum("/" not in f for f in folders) <= 1)
        if not fine:
            strange[name] = folders
    assert not strange
