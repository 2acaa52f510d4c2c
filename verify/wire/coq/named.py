"""A certificate for the theorems in Coq that use it: in ordinary notation, the rows that they name.

    python -m verify.wire.coq.named FILE FOLDER          # prints FILE.v for this folder
    python -m verify.wire.coq.named FILE FOLDER FIRST    # as a statement that cites FIRST, too

A row is exported if a file of `verify/coq` calls it FILE.row: to read back all of them would take
Coq several times as long. If none is called, the statement is exported with its proof alone.
"""

from __future__ import annotations

import re
import sys
from pathlib import Path

from verify import check
from verify.wire.coq.export import export
from verify.wire.coq.readable import Readable
from verify.wire.coq.reading import Reading
from verify.wire.coq.second_citation import beside

#: The theorems.
SOURCES = Path(__file__).resolve().parents[2] / "coq"
#: What each exported file has, in ordinary notation or not.
ALWAYS = {"the_statement", "proved"}


def called(file: str) -> set[str]:
    """What is called by its name after that of a file."""
    pattern = re.compile(rf"\b{re.escape(file)}\.(\w+)")
    return {name for path in SOURCES.glob("*.v") for name in pattern.findall(path.read_text())}


def rows(reading: Reading, words: set[str]) -> list[str]:
    """The rows of which some words are the names in Coq."""
    notation = Readable(reading).notation
    own = {row.name: notation.name(row.name) for row in reading.statement.rows.values()}
    # A row that has the name of a variable has a _ after it.
    return [
        row
        for row, name in own.items()
        if words & {name, f"{name}_", f"row_of_{name}", f"row_of_{name}_is"}
    ]


def named(file: str, folder: check.Folder) -> str:
    """The text of the file."""
    words = called(file) - ALWAYS
    return export(folder, ordinary=bool(words), rows=lambda reading: rows(reading, words))


if __name__ == "__main__":
    (read,) = check.read_folders([sys.argv[2]])
    second = beside(Path(sys.argv[2]), Path(sys.argv[3])) if sys.argv[3:] else read
    sys.stdout.write(named(sys.argv[1], second))
