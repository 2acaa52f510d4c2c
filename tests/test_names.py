"""A module's name is that of its subject: two modules share one only where they have one subject.

A folder inside a package has a language of its own; at most one module of a name lies outside of
such. The two checkers import nothing of the program and are left out.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path

ROOM = Path(__file__).parent.parent / "verify"

#: A subject has one name in every package: its command, its job, its views, its part of the paper.
SUBJECTS = {
    *("bench", "check", "everywhere", "explain", "report", "spectrum", "stress"),
    *("theorem1", "parameters", "box", "scene", "sharper", "slack", "classification", "numbering"),
    *("thresholds", "elsewhere", "map", "prove", "separatrix"),
}


def modules() -> Iterator[Path]:
    for path in sorted(ROOM.rglob("*.py")):
        if path not in (ROOM / "check.py", ROOM / "check_map.py"):
            yield path


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
