"""A certificate as one page that needs nothing else: style, font and formulas are in it."""

from __future__ import annotations

from collections.abc import Mapping
from hashlib import sha256

from markupsafe import Markup

from verify import __version__
from verify.language.statement import Constant, Variable
from verify.language.terms import symbol
from verify.prover.outcome import Outcome
from verify.publication import Publication
from verify.views.markdown import content
from verify.views.page.rows import Math, Writer
from verify.views.page.style import style
from verify.views.typesetting import in_html


class _Formulas(Writer):
    """Formulas as MathML, where that can be read."""

    blocks = "html.j2"

    def letter(self, one: Constant | Variable) -> Math:
        """The letter of a constant or a variable."""
        return self.term(symbol(one.name))


def single_page(outcome: Outcome, paper: Publication, files: Mapping[str, bytes]) -> str:
    """The report as a page; it names the other ``files`` of its folder, with their digests."""
    digests = {name: sha256(data).hexdigest() for name, data in files.items()}
    found = content(outcome, paper, _Formulas(outcome, paper))
    found |= {"files": digests, "version": __version__, "contents": (), "is_sent": True}
    return in_html("single.j2", found | {"css": Markup(style())})  # noqa: S704
