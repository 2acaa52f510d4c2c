"""Pages of constants as people write them: TOML with formulas in ordinary notation.

`infix.py` reads and writes one formula; `read_page.py` reads a page and `write_page.py` writes one;
what is written is read as the same statement. `smtlib.py` and `fpcore.py` read the questions of
other programs. The room uses the language and the readers of numbers beside it. A newcomer begins
with `infix.py`.
"""

from __future__ import annotations

from collections.abc import Mapping

from verify.language.argument import Chapter
from verify.language.record import Record
from verify.language.statement import Statement
from verify.prover.hint import Hint


class Page(Record):
    """A statement, hints by the names of its rows, and the chapters of its argument, if any."""

    statement: Statement
    hints: Mapping[str, Hint]
    chapters: tuple[Chapter, ...] = ()
