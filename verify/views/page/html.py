"""The page in HTML: one file, no script, nothing from the network."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from html import escape
from typing import Any

from verify.language.scripts import LOWERED, RAISED, Pieces, Scripted, pieces
from verify.views.page.blocks import (
    Block,
    Box,
    Button,
    Cell,
    Code,
    Commands,
    Drawing,
    Facts,
    Heading,
    Inline,
    Items,
    Link,
    Math,
    Number,
    Paragraph,
    Raw,
    RefutedStep,
    RefutedSteps,
    Source,
    Strong,
    Table,
    Text,
    Verdict,
)
from verify.views.page.font import font_face
from verify.views.page.style import STYLE


def html(title: str, subtitle: str, blocks: Sequence[Block]) -> str:
    """The whole page, ending with a line feed."""
    lines = [
        "<!DOCTYPE html>",
        '<html lang="en">',
        "<head>",
        '<meta charset="utf-8">',
        '<meta name="viewport" content="width=device-width, initial-scale=1">',
        '<meta name="color-scheme" content="light dark">',
        '<link rel="icon" href="data:,">',
        f"<title>{escape(title)}</title>",
        f"<style>{font_face()}{STYLE}</style>",
        "</head>",
        '<body id="top">',
        f"<header><h1>{escape(title)}</h1><p>{prose(subtitle)}</p></header>",
        "<main>",
    ]
    headings = [block for block in blocks if isinstance(block, Heading) and block.level == 2]
    first = blocks.index(headings[0])
    for block in blocks[:first]:
        lines += _block(block)
    links = (f'<a href="#{h.name}">{prose(h.text)}</a>' for h in headings)
    lines.append(f'<nav aria-label="Sections">{" ".join(links)}</nav>')
    for block in blocks[first:]:
        lines += _block(block)
    lines += ["</main>", '<a class="top" href="#top">↑ top</a>', "</body>", "</html>"]
    return "\n".join(lines) + "\n"


_POWER_OF_TEN = re.compile(
    r"(?<![\w.])(?:([0-9]+(?:\.[0-9]+)?)e(-?[0-9]+)(?!\w)"
    r"|(?:([0-9]+(?:\.[0-9]+)?)·)?10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+))"
)
_RAISED = re.compile("[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+")
_MINUS = re.compile(
    r"(?<![^\s(\[{|·≤<=])-(?=[\w(|√])|(?<= )-(?= )|(?<=[0-9₀-₉)])-(?=[0-9]*√|[α-ωh][₀-₉_])"
)
_TAGS = re.compile("<[^>]*>")
#: So many letters in a line fit a phone.
NARROW = 36
_LOWERED = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")


def prose(text: str) -> str:
    """A sentence with its minus signs, subscripts, superscripts and powers of ten set as such."""
    return _powers(_line(pieces(_MINUS.sub("−", text))))


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


def _powers(text: str) -> str:
    """Powers of ten with raised exponents, each with the decimal that machines read."""

    def power(match: re.Match[str]) -> str:
        digits = match[1] or match[3] or "1"
        exponent = match[2] or match[4].translate(_LOWERED)
        shown = f"{'' if digits == '1' else f'{digits}·'}10<sup>{exponent.replace('-', '−')}</sup>"
        return f'<data value="{digits}e{exponent}">{shown}</data>'

    return _POWER_OF_TEN.sub(power, text)


def _raised(text: str) -> str:
    """The same inside of what is a number already."""
    return _RAISED.sub(
        lambda match: f"<sup>{match[0].translate(_LOWERED).replace('-', '−')}</sup>", text
    )


def _block(block: Block) -> Iterator[str]:
    return _WRITERS[type(block)](block)


def _heading(block: Heading) -> Iterator[str]:
    yield f'<h{block.level} id="{block.name}">{prose(block.text)}</h{block.level}>'


def _paragraph(block: Paragraph) -> Iterator[str]:
    yield f"<p>{_cell(block.content)}</p>"


def _box(block: Box) -> Iterator[str]:
    title = escape(block.title)
    yield f'<section class="theorem"><h3>{title}</h3><p>{_cell(block.content)}</p></section>'


def _facts(block: Facts) -> Iterator[str]:
    yield '<ul class="facts">'
    for word, content in block.facts:
        yield f"<li>{_verdict(word)}<span>{_cell(content)}</span></li>"
    yield "</ul>"


def _items(block: Items) -> Iterator[str]:
    yield f"<ul>{''.join(f'<li>{_cell(item)}</li>' for item in block.items)}</ul>"


def _commands(block: Commands) -> Iterator[str]:
    lines = "\n".join(block.lines)
    yield f"<pre><code>{escape(lines)}</code></pre>"


def _source(block: Source) -> Iterator[str]:
    yield f"<details><summary>{escape(block.title)}</summary>"
    yield f"<pre><code>{escape(block.text)}</code></pre></details>"


def _steps(block: RefutedSteps) -> Iterator[str]:
    yield '<div class="steps">'
    for step in block.steps:
        yield from _step(step)
    yield "</div>"


def _table(table: Table) -> Iterator[str]:
    rows = [[_cell(cell) for cell in row] for row in table.rows]
    grid = _grid(table.head, rows, table.name, table.blocks)
    if table.folded:
        yield f"<details><summary>{prose(table.title)}</summary>{grid}</details>"
    else:
        yield f"<h3>{prose(table.title)}</h3>{grid}"


def _grid(
    head: Sequence[str], rows: Iterable[Sequence[str]], name: str = "", blocks: bool = False
) -> str:
    """A table whose rows are blocks on a phone, each cell with the name of its column; or always.

    Nothing has to be scrolled sideways.
    """
    written = list(rows)
    kind = "rows" if blocks else "few" if _is_narrow(head, written) else "grid"
    marks = [f' data-of="{escape(_plain(of))}"' if kind == "grid" else "" for of in head]
    titles = "".join(f'<th scope="col">{prose(of)}</th>' for of in head)
    body = "\n".join(_table_row(row, marks) for row in written)
    key = f' id="{name}"' if name else ""
    return (
        f'<div{key} class="{kind}"><table><thead><tr>{titles}</tr></thead>'
        f"<tbody>\n{body}\n</tbody></table></div>"
    )


def _table_row(cells: Sequence[str], marks: Sequence[str]) -> str:
    written = (f"<td{mark}>{cell}</td>" for mark, cell in zip(marks, cells, strict=True))
    return f"<tr>{''.join(written)}</tr>"


def _is_narrow(head: Sequence[str], rows: Iterable[Sequence[str]]) -> bool:
    """Whether a table fits a phone as it is."""
    columns = zip(head, *rows, strict=True)
    widths = [max(len(_TAGS.sub("", cell)) for cell in column) for column in columns]
    return sum(widths) + 3 * len(widths) <= NARROW


def _plain(text: str) -> str:
    """A name with an index in letters that need no markup."""
    return text.replace("_x", "ₓ")


def _step(step: RefutedStep) -> Iterator[str]:
    yield f'<article id="{step.name}">'
    yield f"<p>{_verdict('refuted')} {_cell(step.label)}</p>"
    yield f"<p>{prose(step.says)}</p>"
    shown = f'<span class="math">{step.claim.mathml}</span>' if step.claim.mathml else ""
    yield f'<p class="claim">{shown or prose(step.claim.text)}</p>'
    if step.lhs is not None and step.rhs is not None:
        yield (
            f"<dl><div><dt>left</dt><dd>{_inline(step.lhs)}</dd></div>"
            f"<div><dt>right</dt><dd>{_inline(step.rhs)}</dd></div>"
            f"<div><dt>right − left</dt><dd>{_cell(step.margin)}</dd></div></dl>"
        )
    elif step.margin:
        yield f'<p class="witness">{_cell(step.margin)}</p>'
    if step.cause:
        yield f"<p>{_coded(step.cause)}</p>"
    yield f'<div class="repair">{_cell(step.repair)}</div>'
    yield "</article>"


def _coded(text: str) -> str:
    """A sentence in which names stand between backticks."""
    parts = text.split("`")
    return "".join(
        f"<code>{escape(part)}</code>" if index % 2 else prose(part)
        for index, part in enumerate(parts)
    )


def _drawing(block: Drawing) -> Iterator[str]:
    figure = block.figure
    yield f'<figure id="plot-{figure.name}"><h3>{prose(figure.title)}</h3>'
    if figure.moves:
        yield '<label class="hold"><input type="checkbox"> hold still</label>'
    yield '<div class="panels">'
    yield from block.panels
    yield f"</div><figcaption>{prose(figure.caption)}</figcaption>"
    if figure.rows:
        rows = [[prose(cell) for cell in row] for row in figure.rows[1:]]
        for anchor, row in zip(figure.anchors, rows, strict=False):
            row[0] = f'<a href="#{anchor}">{row[0]}</a>'
        grid = _grid(figure.rows[0], rows)
        yield f"<details><summary>The numbers, row by row</summary>{grid}</details>"
    yield "</figure>"


def _cell(content: Cell) -> str:
    return "".join(map(_inline, content))


def _inline(part: Inline) -> str:
    match part:
        case Text(text):
            return prose(text)
        case Raw(text):
            return _powers(escape(text))
        case Strong(text):
            return f"<strong>{prose(text)}</strong>"
        case Code(text):
            return f"<code>{escape(text)}</code>"
        case Math(mathml, text):
            return f'<span class="math">{mathml or prose(text)}</span>'
        case Number():
            return _number(part)
        case Verdict(word):
            return _verdict(word)
        case Link(target, text):
            return f'<a href="{escape(target)}">{prose(text)}</a>'
        case Button(target, text):
            return f'<a class="button" href="{escape(target)}">{prose(text)}</a>'


def _number(number: Number) -> str:
    low, high = number.ends
    shown = _raised(escape(number.short).replace("-", "−"))
    if low == high and "…" not in shown:
        return f'<data class="exact" value="{low}">{shown}</data>'
    value, both = (low, low) if low == high else (f"{low} {high}", f"[{low}, {high}]")
    if not number.unfolds:
        return f'<data value="{value}" title="{both}">{shown}</data>'
    return (
        f'<details class="number"><summary><data value="{value}">{shown}</data></summary>'
        f"<code>{both}</code></details>"
    )


#: What tells verdicts apart without colour.
SYMBOLS = {
    sign: f'<span aria-hidden="true">{mark}</span> '
    for sign, mark in (("proved", "✓"), ("refuted", "✗"), ("undecided", "?"))
}


def _verdict(word: str) -> str:
    kind = word.rpartition(" ")[2]
    return f'<b class="verdict {kind}">{SYMBOLS.get(kind, "")}{word}</b>'


_WRITERS: dict[type, Callable[[Any], Iterator[str]]] = {
    Heading: _heading,
    Paragraph: _paragraph,
    Box: _box,
    Facts: _facts,
    Items: _items,
    Commands: _commands,
    Table: _table,
    RefutedSteps: _steps,
    Source: _source,
    Drawing: _drawing,
}
