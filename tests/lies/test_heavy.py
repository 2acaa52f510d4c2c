"""Every file of at most 4 MB is answered within bounds of time and memory.

The suite takes each third of the heavy files; with ``HEAVY=all``, as in CI, all of them.
"""

from __future__ import annotations

import os
import resource
import subprocess
import sys
from pathlib import Path

import pytest

from tests.lies.heavy import HEAVY
from verify import check

SECONDS = 10
MEMORY = 300 << 20
#: What is true, and small enough to be proved.
TRUE = {
    "cosines-of-long-numbers-at-few-bits", "a-long-label", "many-contexts", "cuts-in-cuts",
    "names-of-a-deep-context-in-a-long-minimum", "very-many-cuts", "instances-with-many-givens",
    "equations-that-replace-in-a-chain", "very-many-intervals", "many-proofs-over-a-long-minimum",
    "an-enclosure-of-one-row-after-the-other",
    "a-minimum-of-long-rationals-in-each-branch", "rows-that-use-one-of-many-assumptions",
    "premises-that-are-names", "roots-in-a-deep-context", "tables-that-are-kept",
    "many-constants-each-of-two-names", "a-context-with-many-variables-and-givens",
}  # fmt: skip


CHOSEN = list(HEAVY)[:: 1 if os.environ.get("HEAVY") == "all" else 3]

Answer = subprocess.CompletedProcess[str]


def bounded() -> None:
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS))


def answer(name: str, folder: Path) -> Answer:
    """What the checker says in a process of its own."""
    for file, data in HEAVY[name]().items():
        (folder / file).parent.mkdir(parents=True, exist_ok=True)
        (folder / file).write_bytes(data)
    return subprocess.run(
        [sys.executable, "-I", check.__file__, str(folder)],
        capture_output=True,
        encoding="utf-8",
        preexec_fn=bounded,
        check=False,
    )


@pytest.mark.parametrize("name", CHOSEN)
def test_heavy(name: str, tmp_path: Path) -> None:
    done = answer(name, tmp_path / name)
    last = done.stdout.splitlines()[-1:]
    assert done.stderr == ""
    assert last
    word = last[0].partition(":")[0]
    assert (done.returncode, word) in [(0, "PROVED"), (1, "REFUSED"), (4, "MALFORMED")]
    assert (word == "PROVED") == (name in TRUE)
    assert name in TRUE or len(last[0]) < 1000
