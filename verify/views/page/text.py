"""The page in Markdown: the same words and numbers, without the drawings."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import Any

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


def markdown(title: str, blocks: Iterable[Block]) -> str:
    """The whole page, ending with a line feed."""
    parts = [f"# {title}", *("\n".join(_block(block)) for block in blocks)]
    return "\n\n".join(part for part in parts if part) + "\n"


def _block(block: Block) -> Iterator[str]:
    return _WRITERS[type(block)](block)


def _heading(block: Heading) -> Iterator[str]:
    yield f"{'#' * block.level} {block.text}"


def _paragraph(block: Paragraph) -> Iterator[str]:
    yield _cell(block.content)


def _box(block: Box) -> Iterator[str]:
    yield f"> **{block.title}.** {_cell(block.content)}"


def _facts(block: Facts) -> Iterator[str]:
    yield from (f"- **{word}**: {_cell(content)}" for word, content in block.facts)


def _items(block: Items) -> Iterator[str]:
    yield from (f"- {_cell(item)}" for item in block.items)


def _commands(block: Commands) -> Iterator[str]:
    yield from ("```sh", *block.lines, "```")


def _titled_table(block: Table) -> Iterator[str]:
    yield f"### {block.title}"
    yield ""
    yield from _table(block.head, [[_cell(cell) for cell in row] for row in block.rows])


def _steps(block: RefutedSteps) -> Iterator[str]:
    yield from _table(_STEP_HEAD, [_step(step) for step in block.steps])


def _source(block: Source) -> Iterator[str]:
    yield from (f"### {block.title}", "", "```latex", *block.text.splitlines(), "```")


def _drawing(block: Drawing) -> Iterator[str]:
    figure = block.figure
    yield f"### {figure.title}"
    yield ""
    yield f"{figure.caption} (The drawing is in `index.html`.)"
    if figure.rows:
        yield ""
        yield from _table(figure.rows[0], figure.rows[1:])


_STEP_HEAD = (
    "Label",
    "Step as printed",
    "Claim",
    "Left",
    "Right",
    "Right - left",
    "What is wrong",
    "Repair",
)


def _step(step: RefutedStep) -> list[str]:
    return [
        _cell(step.label),
        step.says,
        step.claim.text,
        "" if step.lhs is None else step.lhs.short,
        "" if step.rhs is None else step.rhs.short,
        _cell(step.margin),
        step.cause,
        _cell(step.repair),
    ]


def _table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> Iterator[str]:
    yield f"| {' | '.join(head)} |"
    yield f"|{'---|' * len(head)}"
    for row in rows:
        cells = (cell.replace("|", "\\|").replace("\n", " ") for cell in row)
        yield f"| {' | '.join(cells)} |"


def _cell(content: Cell) -> str:
    return "".join(map(_inline, content))


def _inline(part: Inline) -> str:
    match part:
        case Text(text) | Raw(text):
            return text
        case Strong(text):
            return f"**{text.rstrip()}**{' ' if text.endswith(' ') else ''}"
        case Code(text):
            return f"`{text}`"
        case Math(_, text):
            return text
        case Number(short):
            return short
        case Verdict(word):
            return word
        case Link(target, text) | Button(target, text):
            return f"[{text}]({target})" if not target.startswith("#") else text


_WRITERS: dict[type, Callable[[Any], Iterator[str]]] = {
    Heading: _heading,
    Paragraph: _paragraph,
    Box: _box,
    Facts: _facts,
    Items: _items,
    Commands: _commands,
    Table: _titled_table,
    RefutedSteps: _steps,
    Source: _source,
    Drawing: _drawing,
}
