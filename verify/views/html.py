"""The blocks of pages in HTML, made of what is set already: a table, a verdict, the whole page."""

from __future__ import annotations

import re
from collections.abc import Sequence
from html import escape

from verify.views.typesetting import Marked, prose

#: So many letters in a line fit a phone.
NARROW = 36
#: What tells verdicts apart without colour.
SYMBOLS = {"proved": "✓", "refuted": "✗", "undecided": "?"}


def verdict(word: str) -> Marked:
    """A verdict, which has a colour and a sign."""
    kind = word.split(" ")[-1]
    sign = f'<span aria-hidden="true">{SYMBOLS[kind]}</span> ' if kind in SYMBOLS else ""
    return Marked(f'<b class="verdict {kind}">{sign}{escape(word)}</b>')


def grid(
    head: Sequence[str], cells: Sequence[Sequence[str]], name: str = "", blocks: bool = False
) -> Marked:
    """A table whose rows are blocks on a phone, each cell with the name of its column; or always.

    Nothing has to be scrolled sideways.
    """
    kind = "rows" if blocks else "few" if is_narrow(cells, head) else "grid"
    columns = [f' data-of="{escape(of).replace("_x", "ₓ")}"' * (kind == "grid") for of in head]
    starts = [f"<td{column}>" for column in columns]
    lines = "".join(
        f"<tr>{''.join([f'{td}{cell}</td>' for td, cell in zip(starts, row, strict=True)])}</tr>\n"
        for row in cells
    )
    heads = "".join(f'<th scope="col">{prose(of)}</th>' for of in head)
    place = f' id="{escape(name)}"' if name else ""
    return Marked(
        f'<div{place} class="{kind}"><table>'
        f"<thead><tr>{heads}</tr></thead><tbody>\n{lines}</tbody></table></div>"
    )


def is_narrow(cells: Sequence[Sequence[str]], head: Sequence[str]) -> bool:
    """Whether a table in HTML fits a phone as it is."""
    columns = zip(head, *cells, strict=True)
    widths = [max(len(re.sub("<[^>]*>", "", cell)) for cell in column) for column in columns]
    return sum(widths) + 3 * len(widths) <= NARROW


def page(title: str, style: str, content: str, contents: str = "") -> Marked:
    """A whole page, of a style sheet or a link to one; its ``contents`` stand beside it."""
    return Marked(f"""\
<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<link rel="icon" href="data:,">
{style}
<title>{title}</title>
</head>
<body id="top">
{contents}<main>
{content}</main>
<a class="top" href="#top">↑ top</a>
</body>
</html>
""")
