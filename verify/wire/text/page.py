"""What a file with questions says: a statement, and hints for the search."""

from __future__ import annotations

from collections.abc import Mapping

from verify.language.record import Record
from verify.language.statement import Statement


class Hint(Record):
    """Where the search is to look for the proof of a row: the ways, and the facts."""

    by: tuple[str, ...] = ()
    using: tuple[str, ...] = ()


class Page(Record):
    """A statement, and hints by the names of its rows."""

    statement: Statement
    hints: Mapping[str, Hint]
