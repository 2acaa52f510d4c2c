"""The page in Markdown: the same words and numbers, without the drawings."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from verify.views.page.blocks import (
    Block,
    Box,
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
    Source,
    Step,
    Steps,
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
    match block:
        case Heading(_, text):
            yield f"## {text}"
        case Paragraph(content):
            yield _cell(content)
        case Box(title, content):
            yield f"> **{title}.** {_cell(content)}"
        case Facts(facts):
            yield from (f"- **{word}**: {_cell(content)}" for word, content in facts)
        case Items(items):
            yield from (f"- {_cell(item)}" for item in items)
        case Commands(lines):
            yield from ("```sh", *lines, "```")
        case Table(title, head, rows, _):
            yield f"### {title}"
            yield ""
            yield from _table(head, [[_cell(cell) for cell in row] for row in rows])
        case Steps(steps):
            yield from _table(_STEP_HEAD, [_step(step) for step in steps])
        case Source(title, text):
            yield from (f"### {title}", "", "```latex", *text.splitlines(), "```")
        case Drawing(figure, _):
            yield f"### {figure.title}"
            yield ""
            yield f"{figure.caption} (The drawing is in `index.html`.)"
            if figure.rows:
                yield ""
                yield from _table(figure.rows[0], figure.rows[1:])


_STEP_HEAD = ("Label", "Step as printed", "Claim", "Left", "Right", "Margin", "Repair")


def _step(step: Step) -> list[str]:
    return [
        f"`{step.label}`",
        step.says,
        step.claim.text,
        "" if step.lhs is None else step.lhs.short,
        "" if step.rhs is None else step.rhs.short,
        _cell(step.margin),
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
        case Text(text):
            return text
        case Strong(text):
            return f"**{text}**"
        case Code(text):
            return f"`{text}`"
        case Math(_, text):
            return text
        case Number(short, _):
            return short
        case Verdict(word):
            return word
        case Link(target, text):
            return f"[{text}]({target})" if not target.startswith("#") else text
