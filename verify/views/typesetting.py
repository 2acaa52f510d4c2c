"""How pages are set: sentences with minus signs, indices and powers of ten; templates."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import cache, lru_cache, partial
from html import escape, unescape
from typing import Any

import markupsafe
from jinja2 import Environment, FileSystemLoader, StrictUndefined, Template
from markupsafe import Markup

from verify.language.scripts import LOWERED, RAISED, Pieces, Scripted, pieces
from verify.views.words import in_letters

TEMPLATES = os.path.join(os.path.dirname(__file__), "templates")
#: So many letters in a line fit a phone.
NARROW = 36

_POWER_OF_TEN = re.compile(
    r"(?<![\w.])(?:([0-9]+(?:\.[0-9]+)?)e(-?[0-9]+)(?!\w)"
    r"|(?:([0-9]+(?:\.[0-9]+)?)·)?10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+))"
)
_RAISED = re.compile("[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+")
_MINUS = re.compile(
    r"(?<![^\s(\[{|·≤<=])-(?=[\w(|√])|(?<= )-(?= )|(?<=[0-9₀-₉)])-(?=[0-9]*√|[α-ωh][₀-₉_])"
)
_LOWERED = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")


@lru_cache(1 << 12)  # the cells of a table repeat each other
def prose(text: str) -> str:
    """A sentence with its minus signs, subscripts, superscripts and powers of ten set as such."""
    return powers(_line(pieces(_MINUS.sub("−", text))))


def _line(found: Pieces) -> str:
    return "".join(
        _scripted(piece) if isinstance(piece, Scripted) else escape(piece, quote=False)
        for piece in found
    )


def _scripted(piece: Scripted) -> str:
    """A letter with what is below and above it; digits are small signs of their own."""
    text = escape(piece.base) + ("\u0304" if piece.bar else "")
    for tag, content, small in (("sub", piece.lower, LOWERED), ("sup", piece.upper, RAISED)):
        signs = {sign: mark for mark, sign in small.items()} | {"′": "′"}
        inner = "".join(part for part in content if isinstance(part, str))
        if content == (inner,) and signs.keys() >= {*inner} - {"n"} and "n" not in inner:
            text += "".join(signs[sign] for sign in inner)
        elif content:
            text += f"<{tag}>{_line(content)}</{tag}>"
    return text


def powers(text: str) -> str:
    """Powers of ten with raised exponents, each with the decimal that machines read."""

    def power(match: re.Match[str]) -> str:
        digits = match[1] or match[3] or "1"
        exponent = match[2] or match[4].translate(_LOWERED)
        shown = f"{'' if digits == '1' else f'{digits}·'}10<sup>{exponent.replace('-', '−')}</sup>"
        return f'<data value="{digits}e{exponent}">{shown}</data>'

    return _POWER_OF_TEN.sub(power, text)


def raised(text: str) -> str:
    """A number whose exponent is raised, inside of what is marked as one already."""
    text = escape(text).replace("-", "−")
    return _RAISED.sub(
        lambda match: f"<sup>{match[0].translate(_LOWERED).replace('-', '−')}</sup>", text
    )


#: Tags, and elements whose text is set already.
_TAGS = re.compile(r"(<(?:code|data|math)[ >].*?</(?:code|data|math)>|<[^>]*>)", re.DOTALL)


def in_a_line(text: str) -> str:
    """A text without the line breaks and the indentation with which it is written."""
    return re.sub("[ \n]+", " ", printable(text)).strip(" ")


def printable(text: str) -> str:
    """A text in which control signs, and signs that nobody sees, are told by their numbers."""
    return text if text.isprintable() else "".join(map(_seen, text))


def _seen(sign: str) -> str:
    if sign.isprintable() or sign in "\n\u00a0":
        return sign
    return " " if sign.isspace() else ascii(sign)[1:-1]


#: In Markdown a backslash, and what begins a tag or a picture.
_IN_MARKDOWN = re.compile(r"\\|<(?=[A-Za-z/!?])|(?<=!)\[")
#: And what begins, at the start of a line, something else than a paragraph.
_BEGINS = re.compile(r"(?=[-#>+*=~`|_\[])|[0-9]+(?=[.)])")


def in_markdown(text: str) -> str:
    """Somebody's words in a line of Markdown, where they can make no line and no element."""
    return _IN_MARKDOWN.sub(lambda match: f"\\{match[0]}", in_a_line(text))


def prose_between(markup: str) -> str:
    """Markup in a line, with each text between its tags set as a sentence."""
    parts = _TAGS.split(in_a_line(markup))
    return "".join(
        part if number % 2 else prose(unescape(part)) for number, part in enumerate(parts)
    )


# --- templates -----------------------------------------------------------------------------------

Filters = Iterable[Callable[..., Any]]


def in_html(name: str, content: Mapping[str, Any], filters: Filters = ()) -> str:
    """What a template says, in HTML, where everything is escaped."""
    return _for_html(*filters).get_template(name).render(content).lstrip()


@cache
def markdown_template(name: str) -> Template:
    """A template in Markdown; what is no macro of a template is somebody's words."""
    found = _environment((), _cells_in_markdown, _words_in_markdown)
    found.filters |= {"paragraph": _paragraph_in_markdown, "literal": _code_in_markdown}
    return found.get_template(name)


def apart(text: str) -> str:
    """A text that does not begin with an empty line, and has no two in a row."""
    return re.sub("\n{3,}", "\n\n", text).lstrip("\n")


@cache  # so that each template is compiled once
def _for_html(*filters: Callable[..., Any]) -> Environment:
    found = _environment(filters, _cells_in_html, _words_in_html)
    found.filters |= {
        "set": _line_in_html,
        "is_narrow": is_narrow,
        "headings": partial(re.findall, '<h2 id="([^"]*)">(.*?)</h2>'),
        "prose": lambda text: Markup(prose(text)),  # noqa: S704  these three are escaped
        "raised": lambda text: Markup(raised(text)),  # noqa: S704
    }
    return found


def _environment(
    filters: Filters, cells: Callable[..., Any], said: Callable[[Any], Any]
) -> Environment:
    found = Environment(
        autoescape=True,
        finalize=said,
        loader=FileSystemLoader(TEMPLATES),
        undefined=StrictUndefined,
        extensions=["jinja2.ext.do"],
        trim_blocks=True,
        lstrip_blocks=True,
    )
    found.filters |= {"letters": in_letters, "cells": cells}
    found.filters |= {one.__name__: one for one in filters}
    return found


def _words_in_html(found: object) -> object:
    """What is put into a page: what is markup stays, and the rest will be escaped."""
    return printable(found) if type(found) is str else found


def _words_in_markdown(found: object) -> Markup:
    return found if isinstance(found, Markup) else Markup(in_markdown(str(found)))  # noqa: S704


def _code_in_markdown(text: str) -> Markup:
    """Words between backticks, where only a backtick means something else."""
    return Markup(in_a_line(text).replace("`", "'"))  # noqa: S704


def _paragraph_in_markdown(text: str) -> Markup:
    """Words that stand at the start of a line, and begin nothing there but a paragraph."""
    line = in_markdown(text)
    begins = _BEGINS.match(line)
    at = begins.end() if begins else 0
    return Markup(f"{line[:at]}\\{line[at:]}" if begins else line)  # noqa: S704


def _line_in_html(content: object) -> Markup:
    """A line, with each text between its tags set as a sentence."""
    return Markup(prose_between(str(markupsafe.escape(content))))  # noqa: S704  it is escaped


def _cells_in_html(rows: Iterable[Iterable[object]], raw: bool = False) -> list[list[Markup]]:
    """The cells of a table; in what somebody else wrote underscores are no subscripts."""
    if not raw:
        return [[_line_in_html(cell) for cell in row] for row in rows]
    return [[_cell_of_words(cell) for cell in row] for row in rows]


def _cell_of_words(cell: object) -> Markup:
    if isinstance(cell, Markup):
        return cell
    return Markup(powers(escape(printable(str(cell)))))  # noqa: S704  it is escaped


def _cells_in_markdown(rows: Iterable[Iterable[object]]) -> list[list[Markup]]:
    """The cells of a table; bars inside of one are escaped."""
    cells = [[_words_in_markdown(cell) for cell in row] for row in rows]
    return [[Markup(str(cell).replace("|", "\\|")) for cell in row] for row in cells]  # noqa: S704


def is_narrow(cells: Sequence[Sequence[str]], head: Sequence[str]) -> bool:
    """Whether a table in HTML fits a phone as it is."""
    columns = zip(head, *cells, strict=True)
    widths = [max(len(re.sub("<[^>]*>", "", cell)) for cell in column) for column in columns]
    return sum(widths) + 3 * len(widths) <= NARROW
