"""A certificate as one page that needs nothing else: style, font and formulas are in it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from hashlib import sha256
from html import escape

from verify import __version__
from verify.language.record import TYPE_CHECKING
from verify.views import html
from verify.views.markdown import Report
from verify.views.page.rows import Math, Writer
from verify.views.style import style
from verify.views.typesetting import Marked, in_a_line, numbers, printable, prose, unset

if TYPE_CHECKING:
    from verify.language.statement import Always, Applies
    from verify.language.terms import Claim, Term
    from verify.prover.outcome import Outcome
    from verify.publication import Publication


def single_page(outcome: Outcome, paper: Publication, files: Mapping[str, bytes]) -> str:
    """The report as a page; it names the other ``files`` of its folder, with their digests."""
    css = f"<style>{style()}body{{display:block}}</style>"
    title = escape(printable(outcome.statement.title))
    return html.page(title, css, "\n".join(_Page(outcome, paper, files).blocks()))


class _Page(Report):
    """The same in HTML, with formulas as MathML where that can be read."""

    def __init__(self, outcome: Outcome, paper: Publication, files: Mapping[str, bytes]) -> None:
        self._writer, self._files = Writer(outcome, paper), files
        super().__init__(outcome, paper, self._writer.typesetter, is_sent=True)

    def _words(self, text: str) -> str:
        """Words as a sentence; as they are where they are somebody else's."""
        return prose(in_a_line(text)) if self._about else unset(in_a_line(text))

    def _numbers(self, text: str) -> Marked:
        """What has no letters has no indices, either."""
        return Marked(numbers(text) if self._about else unset(text))

    def _code(self, text: str) -> Marked:
        return Marked(f"<code>{escape(in_a_line(text))}</code>")

    def _in(self, tag: str, text: str) -> Marked:
        return Marked(f"<{tag}>{self._line(text)}</{tag}>")

    def _verdict(self, word: str) -> Marked:
        return html.verdict(word)

    def _claim(self, claim: Claim | Applies | Always) -> Marked:
        return self._math(self._writer.claim(claim))

    def _term(self, term: Term, before: str = "") -> Marked:
        return self._math(self._writer.term(term, before))

    def _math(self, formula: Math) -> Marked:
        return Marked(f'<span class="math">{formula.mathml or self._words(formula.text)}</span>')

    def _heading(self, name: str, *parts: str, level: int = 2) -> str:
        return f'<h{level} id="{escape(name)}">{self._line(*parts)}</h{level}>'

    def _paragraph(self, *parts: str) -> str:
        return f"<p>{self._line(*parts)}</p>"

    def _items(self, lines: Iterable[str]) -> str:
        found = "".join(f"<li>{line}</li>" for line in lines)
        return f"<ul>{found}</ul>" if found else ""

    def _grid(
        self, head: Sequence[str], rows: Iterable[Iterable[str]], blocks: bool = False
    ) -> str:
        cells = [[c if type(c) is Marked else self._line(c) for c in row] for row in rows]
        return html.grid(head, cells, "", blocks) if cells else ""

    def _trust(self) -> Iterator[str]:
        yield from super()._trust()
        yield self._heading("files", "The files of this folder")
        yield self._paragraph(
            "Whoever does not trust the sender takes check.py from elsewhere: verify-collapse "
            f"{__version__} has it as ",
            self._code("verify/check.py"),
            ". SHA-256:",
        )
        rows = ((name, sha256(data).hexdigest()) for name, data in self._files.items())
        yield self._grid(["File", "SHA-256"], [map(self._code, row) for row in rows])
