"""What a page is made of, before it is HTML or Markdown.

The same blocks are written twice, so that the two pages cannot say different things.
"""

from __future__ import annotations

from collections.abc import Sequence

from verify.language.record import Record
from verify.views.plots.figure import Figure


class Text(Record):
    """A sentence, in the plain letters in which the paper's files have it."""

    text: str


class Raw(Record):
    """What somebody else wrote: its underscores are no subscripts."""

    text: str


class Strong(Record):
    """Words that matter."""

    text: str


class Code(Record):
    """A label, a name or a command."""

    text: str


class Math(Record):
    """A formula as MathML and as text."""

    mathml: str
    text: str


class Number(Record):
    """An enclosure: its short form, and both ends as they stand in the certificate."""

    short: str
    ends: tuple[str, str]
    unfolds: bool = False


class Verdict(Record):
    """``proved``, ``refuted`` or ``undecided``."""

    word: str


class Link(Record):
    """A reference to a place on the page, or to a file beside it."""

    target: str
    text: str


class Button(Record):
    """A reference that is meant to be followed first."""

    target: str
    text: str


Inline = Text | Raw | Strong | Code | Math | Number | Verdict | Link | Button
Cell = Sequence[Inline]


class Heading(Record):
    """The start of a section, or with level 3 of a part of one."""

    name: str
    text: str
    level: int = 2


class Paragraph(Record):
    """Some words."""

    content: Cell


class Box(Record):
    """A paragraph set apart: a theorem."""

    title: str
    content: Cell


class Facts(Record):
    """The result in a few lines, each with a verdict."""

    facts: Sequence[tuple[str, Cell]]


class Items(Record):
    """A list."""

    items: Sequence[Cell]


class Commands(Record):
    """Lines to type."""

    lines: Sequence[str]


class Table(Record):
    """A table; a long one is folded away behind its title.

    ``name`` is its anchor; ``blocks`` says that a row is too wide for one line, even on a screen.
    """

    title: str
    head: Sequence[str]
    rows: Sequence[Sequence[Cell]]
    folded: bool = False
    name: str = ""
    blocks: bool = False


class RefutedStep(Record):
    """One refuted step of the printed proof, with its repair."""

    name: str
    label: Cell
    says: str
    claim: Math
    lhs: Number | None
    rhs: Number | None
    margin: Cell
    cause: str
    repair: Cell


class RefutedSteps(Record):
    """Refuted steps."""

    steps: Sequence[RefutedStep]


class Source(Record):
    """A text to copy, folded away behind its title."""

    title: str
    text: str


class Drawing(Record):
    """A figure, with its panels drawn if something could draw them."""

    figure: Figure
    panels: Sequence[str]


Block = (
    Heading | Paragraph | Box | Facts | Items | Commands | Table | RefutedSteps | Source | Drawing
)
