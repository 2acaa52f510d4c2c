"""A figure of the report: what it shows, said in words, and how it is drawn."""

from __future__ import annotations

from collections.abc import Sequence

from verify.language.record import Record
from verify.views.plots.shapes import Panel


class Figure(Record):
    """Panels with one caption.

    ``caption`` has every number that the reader is told, ``rows`` a small table below it (its
    first row is the head). Both come from the enclosures alone: they are the same whatever draws.
    """

    name: str
    title: str
    caption: str
    panels: Sequence[Panel]
    rows: Sequence[Sequence[str]] = ()
    #: For each row below the head the anchor of its curve.
    anchors: Sequence[str] = ()
    #: Whether something in it moves.
    moves: bool = False
