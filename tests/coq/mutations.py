"""Mutations of the checker in Coq: without its reason, no rule has a proof.

    python -m tests.coq.mutations          # compiles each; exit code 1 if one has still a proof

Each mutation changes one line on which soundness rests. The files that come after it must then
fail to compile.
"""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import NamedTuple

SOURCES = Path(__file__).resolve().parents[2] / "verify/coq"


class Mutation(NamedTuple):
    """A line of a file, and what takes its place."""

    rule: str
    file: str
    line: str
    other: str


def mutations() -> list[Mutation]:
    """Those in ``mutations.txt``: rule and file, the lines with ``-``, those with ``+`` instead."""
    found = []
    for block in (SOURCES.parents[1] / "tests/coq/mutations.txt").read_text().strip().split("\n\n"):
        head, *lines = block.split("\n")
        sides = ["\n".join(text[2:] for text in lines if text[0] == sign) for sign in "-+"]
        found.append(Mutation(*head.split(), *sides))
    return found


def order() -> list[str]:
    """The files of the checker and its proof in the order in which they are compiled."""
    names = re.findall(r"^(\w+)\.v$", (SOURCES / "_CoqProject").read_text(), re.MULTILINE)
    return names[: names.index("Accepted") + 1]


def compiled(directory: Path, names: list[str]) -> str:
    """The first file that does not compile; empty if all do."""
    for name in names:
        command = ["coqc", "-q", "-R", ".", "Verify", f"{name}.v"]
        done = subprocess.run(command, cwd=directory, capture_output=True, timeout=300)
        if done.returncode:
            return name
    return ""


def main() -> int:
    """Try each mutation on a copy."""
    survived = 0
    with tempfile.TemporaryDirectory() as path:
        honest, changed = Path(path, "honest"), Path(path, "changed")
        honest.mkdir()
        for source in SOURCES.glob("*.v"):
            shutil.copy(source, honest)
        names = order()
        assert not compiled(honest, names)
        for rule, file, line, other in mutations():
            shutil.rmtree(changed, ignore_errors=True)
            shutil.copytree(honest, changed)
            text = (changed / f"{file}.v").read_text()
            assert text.count(line) == 1, (file, line, text.count(line))
            (changed / f"{file}.v").write_text(text.replace(line, other))
            failed = compiled(changed, names[names.index(file) :])
            survived += not failed
            print(
                f"{rule:<11} {'no proof of ' + failed if failed else 'SURVIVED'}: {line!r}",
                flush=True,
            )
    print(f"{len(mutations())} mutations, {survived} with a proof")
    return bool(survived)


if __name__ == "__main__":
    sys.exit(main())
