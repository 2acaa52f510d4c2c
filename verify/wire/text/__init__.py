"""Pages of constants as people write them: TOML with formulas in ordinary notation.

`infix.py` reads and writes one formula; `read_page.py` reads a page and `write_page.py` writes one;
what is written is read as the same statement. `smtlib.py` and `fpcore.py` read the questions of
other programs, with `lisp.py` and `formulas.py`; `conjunctions.py` makes rows of formulas. The
package uses the language and the readers of numbers beside it. A newcomer begins with `infix.py`.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from types import MappingProxyType

from verify.language.record import TYPE_CHECKING, Record
from verify.language.statement import Choice, Context, Obligation, Statement
from verify.prover.hint import Hint

if TYPE_CHECKING:
    from verify.language.argument import Chapter

#: So many other forms of a row are tried.
OTHERS = 3
#: A row with its context.
Form = tuple[Context | None, Obligation]
NO_FORMS: Mapping[str, Iterator[Form]] = MappingProxyType({})
NO_CHOICES: Mapping[str, Choice] = MappingProxyType({})


class Page(Record):
    """A statement, hints by the names of its rows, other forms of its rows, and its argument.

    A form is a row that says the same, with its context, which has the same name. Each can
    be looked at once. The chapters of an argument have every line with what it follows from.
    Choices are those of constants whose term in the statement is a bound, by the names of these.
    """

    statement: Statement
    hints: Mapping[str, Hint]
    forms: Mapping[str, Iterator[Form]] = NO_FORMS
    chapters: tuple[Chapter, ...] = ()
    choices: Mapping[str, Choice] = NO_CHOICES

    def with_rows(self, rows: tuple[Obligation, ...]) -> Page:
        """The page with these of its rows; others that lines name are lemmas."""
        from verify.language.argument import Chapter, Line  # loaded only where they are used
        from verify.prover.arguments import facts_of

        names = {row.name for row in self.statement.obligations} - {row.name for row in rows}
        lines = {x.name: x for c in self.chapters for x in c.items if isinstance(x, Line)}
        waiting = [name for name in lines if name not in names]
        while waiting:
            for name in facts_of(lines[waiting.pop()].reason):
                if name in names:
                    names.discard(name)
                    waiting += [name] if name in lines else []
        chapters = tuple(
            Chapter(
                chapter.context,
                tuple(x for x in chapter.items if not isinstance(x, Line) or x.name not in names),
            )
            for chapter in self.chapters
        )
        statement = self.statement._replace(obligations=rows)
        hints = {name: hint for name, hint in self.hints.items() if name not in names}
        return self._replace(statement=statement, hints=hints, chapters=chapters)

    @property
    def is_argued(self) -> bool:
        """Whether a line says what it follows from, or is no row."""
        from verify.language.argument import Line, ToBeFound  # loaded only where they are used

        rows = {row.name for row in self.statement.obligations}
        lines = (item for chapter in self.chapters for item in chapter.items)
        return any(
            isinstance(x, Line) and (x.name not in rows or not isinstance(x.reason, ToBeFound))
            for x in lines
        )
