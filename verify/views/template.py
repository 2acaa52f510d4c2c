"""Pages that a template says: what is put into one is escaped, and set where the template asks."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterable, Mapping
from functools import cache, partial
from html import unescape
from typing import Any

import markupsafe
from jinja2 import Environment, FileSystemLoader, StrictUndefined
from markupsafe import Markup

from verify.views import html
from verify.views.typesetting import Marked, in_a_line, printable, prose, raised, unset
from verify.views.words import in_letters

Filters = Iterable[Callable[..., Any]]


def in_html(name: str, content: Mapping[str, Any], filters: Filters = ()) -> str:
    """What a template says, in HTML, where everything is escaped."""
    return _environment(*filters).get_template(name).render(content).lstrip()


@cache  # so that each template is compiled once
def _environment(*filters: Callable[..., Any]) -> Environment:
    found = Environment(
        autoescape=True,
        finalize=lambda found: printable(found) if type(found) is str else found,
        loader=FileSystemLoader(os.path.join(os.path.dirname(__file__), "templates")),
        undefined=StrictUndefined,
        extensions=["jinja2.ext.do"],
        trim_blocks=True,
        lstrip_blocks=True,
    )
    found.filters |= {
        "letters": in_letters,
        "set": _line,
        "headings": partial(re.findall, '<h2 id="([^"]*)">(.*?)</h2>'),
        "prose": lambda text: Marked(prose(text)),
        "raised": lambda text: Marked(raised(text)),
    }
    found.filters |= {one.__name__: one for one in filters}
    found.globals |= {"grid": _grid, "verdict": html.verdict, "whole": html.page}
    return found


#: Tags, and elements whose text is set already.
_TAGS = re.compile(r"(<(?:code|data|math)[ >].*?</(?:code|data|math)>|<[^>]*>)", re.DOTALL)


def _line(content: object) -> Marked:
    """A line, with each text between its tags set as a sentence."""
    parts = _TAGS.split(in_a_line(str(markupsafe.escape(content))).strip(" "))
    set_ = (part if i % 2 else prose(unescape(part)) for i, part in enumerate(parts))
    return Marked("".join(set_))


def _grid(
    head: Iterable[str],
    rows: Iterable[Iterable[object]],
    name: str = "",
    blocks: bool = False,
    raw: bool = False,
) -> Marked:
    """A table; in what somebody else wrote underscores are no subscripts."""
    put = _cell_of_words if raw else _line
    return html.grid([*head], [[put(cell) for cell in row] for row in rows], name, blocks)


def _cell_of_words(cell: object) -> str:
    return cell if isinstance(cell, Markup | Marked) else unset(str(cell))
