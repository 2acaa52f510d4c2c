"""A page of constants in TOML, read as a statement with hints for the search.

    title = "A contraction"

    [constants]
    q = "(3 - sqrt(5))/4"

    [contexts.ball]
    variables = ["x"]
    given = ["-q/2 <= x <= q/2"]
    point = { x = 0 }

    [rows]
    slope = "2*(q + x) <= 3*q"

Names of constants and variables are read in the order of the page: a formula knows what stands
before it. A row belongs to the context of the names in it,
or to the context below which it stands. Nothing here is trusted.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from verify.language.record import TYPE_CHECKING
from verify.language.statement import Cite, Obligation
from verify.wire.text import Page
from verify.wire.text.entries import spelled_out
from verify.wire.text.page_tables import Reader
from verify.wire.text.places import Places
from verify.wire.toml import toml_of

if TYPE_CHECKING:
    from verify.language.argument import Chapter
    from verify.wire.text.include import Opened

#: What to write where a line is not TOML, and nobody knows what was meant.
IN_QUOTES = "write formulas and Greek names in quotes"


def read_page(
    path: str,
    content: bytes,
    cited: Sequence[Cite] = (),
    opened: Opened | None = None,
    seconds: float | None = None,
) -> Page:
    """The statement that a page is, and its hints.

    ``cited`` are the statements that a page may cite; ``opened`` reads the files that it includes,
    by default from disk. At most half of the ``seconds`` goes into points of contexts.

    Raises:
        InputError: naming the file, the line, the key, and what to write instead.
    """
    table, places = _whole(path, content, opened)
    stated: dict[str, Obligation] = {}
    if "rows_of" in table:
        from verify.wire.text.include import content_of, path_beside  # only where they are used

        name, where = table.pop("rows_of"), places.where(["rows_of"])
        inner = path_beside(path, name, where)
        other = _whole(inner, content_of(inner, name, where, opened), opened)
        inside = Reader(other[1], cited, {}, seconds)
        rows = inside.page(other[0], _chapters).statement.obligations
        stated = {row.name: row for row in rows}
    return Reader(places, cited, stated, seconds).page(table, _chapters)


def _whole(path: str, content: bytes, opened: Opened | None) -> tuple[dict[str, Any], Places]:
    """The tables in a file and in those that it includes, and where they stand."""
    table, places = _read(path, content)
    if "include" not in table:
        return table, places
    from verify.wire.text.include import Included, beside  # loaded only where they are used

    return Included(_read, opened or beside).page(path, content)


def _read(path: str, content: bytes) -> tuple[dict[str, Any], Places]:
    """The tables in a file, and where they stand."""
    table, text = toml_of(path, content, IN_QUOTES)
    places = Places(path, text)
    return spelled_out(table, places), places


def _chapters(page: Reader, value: object) -> tuple[Chapter, ...]:
    if not value and isinstance(value, list):
        return ()
    from verify.wire.text.read_lines import read_chapters  # loaded only where it is used

    return read_chapters(page, value)
