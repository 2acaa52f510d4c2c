"""What a file with questions says: a statement, and hints for the search."""

from __future__ import annotations

from collections.abc import Mapping

from verify.language.record import Record
from verify.language.statement import Statement
from verify.prover.hint import Hint


class Page(Record):
    """A statement, and hints by the names of its rows."""

    statement: Statement
    hints: Mapping[str, Hint]
