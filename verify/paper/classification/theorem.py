"""The four theorems as one statement, with its argument in the order in which it is proved."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache

from verify.language.argument import Argument, Chapter, Line, argue
from verify.language.statement import Obligation
from verify.paper.classification import (
    angle,
    collision,
    comparison,
    endless,
    flight,
    image,
    impulse,
    run,
    scenes,
    triangle,
)
from verify.paper.classification.assumptions import ASSUMPTIONS

NAME = "classification"
TITLE = (
    "Which collapses three balls have: no triangular one, at least a certain final angle, bounded "
    "total impulse, and when there are finitely many collisions; for every state"
)

CONE = "the cone of the text"

#: The modules in the order of the proof, with the heading of their rows.
SECTIONS = {
    "lemma: flight": flight,
    "lemma: collision": collision,
    "lemma: the angle": angle,
    "I: no triangular collapse": triangle,
    "II: the recursion of closing speeds": comparison,
    "II: runs of collisions": run,
    "III: total impulse": impulse,
    "IV: finite or infinite time": endless,
    "criteria for scenes": scenes,
    CONE: image,
}

#: What is concluded in words, at the rows from which it is.
CONCLUDES = {
    "acute-keeps": ("hard-spheres", "glue-lemma"),
    "cosine-2-positive": ("hard-spheres", "finite-length", "glue-classification"),
    "fall-positive": ("glue-run",),
    "run-always": ("glue-run",),
    "bound-above-one": ("glue-run", "smooth-images", "glue-null"),
    "total-impulse": ("hard-spheres", "bounded-monotone", "glue-impulse"),
    "spin-length": ("glue-impulse",),
    "impulse-times": ("finite-length", "glue-endless"),
    "scene-miss": ("glue-scenes",),
    "scene-outward": ("glue-scenes",),
    "scene-deadline": ("glue-scenes",),
}


@cache
def classification() -> Argument:
    """The statement with its argument, built once per process."""
    written = argue(NAME, TITLE, _chapters(), ASSUMPTIONS)
    headings = {
        item.name: heading
        for heading, section in SECTIONS.items()
        for chapter in section.chapters()
        for item in chapter.items
        if isinstance(item, Line)
    }
    rows = tuple(_placed(row, headings[row.name]) for row in written.statement.obligations)
    rows = (*rows, image.stated_row(CONE))
    return written._replace(statement=written.statement._replace(obligations=rows))


def _chapters() -> Iterator[Chapter]:
    for section in SECTIONS.values():
        yield from section.chapters()


def _placed(row: Obligation, heading: str) -> Obligation:
    more = (name for name in CONCLUDES.get(row.name, ()) if name not in row.uses)
    return row._replace(group=heading, uses=(*row.uses, *more))
