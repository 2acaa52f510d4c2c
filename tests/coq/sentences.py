"""The sentences that Coq proves, each beside what Coq proves: `sentences.txt`.

    python -m tests.coq.sentences            # writes the file

A sentence is that of a committed statement; below it stand the commands of the pinned files with
the theorems that `verify.paper.in_coq` names. Who changes one of the two changes this file, and
sees the other one: read both before it is written again.
"""

from __future__ import annotations

import json
import re
from functools import cache
from pathlib import Path
from textwrap import fill

from verify.paper.in_coq import IN_COQ

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
PINNED = HERE / "sentences.txt"
SOURCES = ("Sentences", "BeyondSentences", "SeparatrixProof", "PinnedSeparatrix", "Separatrix")
_COMMAND = re.compile(r"^(?:Check|Theorem|Definition|Record) .*?\.$", re.MULTILINE | re.DOTALL)


@cache
def commands() -> tuple[str, ...]:
    """What the pinned files say, command by command."""
    texts = [(ROOT / f"verify/coq/{name}.v").read_text(encoding="utf-8") for name in SOURCES]
    return tuple(found for text in texts for found in _COMMAND.findall(text))


def proved(theorem: str) -> list[str]:
    """The commands that say what a theorem is, or what a definition says."""
    file, _, name = theorem.partition(".")
    short = name if file.startswith("Separatrix") else theorem
    return [text for text in commands() if re.search(rf"(?<![\w.]){re.escape(short)}\b", text)]


def sentences() -> dict[tuple[str, str], str]:
    """The sentences of the committed statements that Coq has, by theorem and name."""
    paths = sorted((ROOT / "certificates").glob("*/statement.json"))
    statements = [json.loads(path.read_bytes()) for path in paths]
    said = {one["theorem"]: one["assumptions"] for one in statements}
    return {
        (theorem, one["name"]): one["sentence"]
        for theorem, found in IN_COQ.items()
        for one in said[theorem]
        if one["name"] in found
    }


def pinned() -> str:
    """The file: a sentence, and what Coq proves in its place."""
    parts = []
    for (theorem, name), sentence in sentences().items():
        found = dict.fromkeys(text for one in IN_COQ[theorem][name] for text in proved(one))
        parts.append("\n".join([f"== {theorem}: {name}", fill(sentence, 100), "", *found, ""]))
    return "\n".join(parts)


if __name__ == "__main__":
    PINNED.write_text(pinned(), encoding="utf-8")
