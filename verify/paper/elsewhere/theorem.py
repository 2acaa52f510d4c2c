"""The statement of the rest of the text, with its argument and the points of its misprints."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache

from verify.language.argument import Argument, Chapter, Line, argue
from verify.language.statement import NEEDED, Obligation
from verify.paper.elsewhere import (
    aligned,
    changes,
    estimates,
    generic,
    mapping,
    nearly,
    outer,
    pair,
    quoted,
    sums,
)
from verify.paper.elsewhere.assumptions import ASSUMPTIONS, CONCLUDES, VECTORS
from verify.paper.elsewhere.subject import Refuted

NAME = "elsewhere"
TITLE = (
    "What the paper prints outside the proof of Theorem 1 and the spectrum: laws, estimates and "
    "claims of Sections 1 to 4.1, for every state"
)

#: The modules in the order of the text, with the heading of their rows.
SECTIONS = {
    "conditions and counts": quoted,
    "2.1 the law of a collision": pair,
    "2.2 the mapping": mapping,
    "2.2 the next collision": outer,
    "3.2 times, flights and sums": sums,
    "3.3 times and distances": estimates,
    "3.3 what one collision changes": changes,
    "3.3 large relative velocities": generic,
    "3.3 a collapse on a line": aligned,
    "4.1 the nearly-linear collapse": nearly,
}


@cache
def elsewhere() -> Argument:
    """The statement with its argument, built once per process."""
    written = argue(NAME, TITLE, _chapters(), ASSUMPTIONS)
    headings = {
        item.name: heading
        for heading, section in SECTIONS.items()
        for chapter in section.chapters()
        for item in chapter.items
        if isinstance(item, Line)
    }
    headings |= {
        found.row.name: heading
        for heading, section in SECTIONS.items()
        for found in section.misprints()
    }
    rows = (*written.statement.obligations, *(found.row for found in refutations()))
    placed = tuple(_placed(row, headings) for row in rows)
    return written._replace(statement=written.statement._replace(obligations=placed))


def refutations() -> tuple[Refuted, ...]:
    """What is false, in the order of the text, each with a point at which it is."""
    return tuple(found for section in SECTIONS.values() for found in section.misprints())


def _chapters() -> Iterator[Chapter]:
    for section in SECTIONS.values():
        yield from section.chapters()


def _placed(row: Obligation, headings: dict[str, str]) -> Obligation:
    uses = ["cauchy-schwarz"] if row.context in VECTORS and row.role == NEEDED else []
    if row.name in CONCLUDES:
        uses.append(CONCLUDES[row.name])
    return row._replace(group=headings[row.name], uses=tuple(uses))
