"""Pictures of certified enclosures: every band and box is drawn from balls over a whole cell."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from verify.language.record import Record
from verify.views.findings import CertifiedMap, CertifiedStrip, Plotted, Story
from verify.views.plots import map_figure, margins, region, roots, speed
from verify.views.plots.collapse import figure as collapse_figure
from verify.views.plots.shapes import Figure


class Pictures(Record):
    """Every figure of the report; the first plot is also the picture of the README."""

    plots: Sequence[Figure]
    proof: Figure
    letters: Figure
    collapses: Sequence[Figure]
    maps: Sequence[Figure]
    curves: Sequence[Figure]

    @property
    def all(self) -> list[Figure]:
        """One after the other."""
        return [*self.plots, self.proof, self.letters, *self.collapses, *self.maps, *self.curves]


def figures(plotted: Plotted, precision: Mapping[str, Any] | None) -> list[Figure]:
    """The plots.

    ``precision`` is the table of that name of the committed measurements, if there is one.
    """
    found = [
        margins.broken_steps(plotted.margins),
        region.picture(plotted.region),
        margins.figure(plotted.margins),
        roots.figure(plotted.roots),
    ]
    last = None if precision is None else speed.figure(precision)
    return found if last is None else [*found, last]


def collapses(stories: Mapping[str, Story]) -> list[Figure]:
    """A figure for each scene that collapses; ``stories`` has their names."""
    return [
        collapse_figure(story, name, f"A collapse: the scene {name}")
        for name, story in stories.items()
    ]


def maps(logs: Iterable[CertifiedMap], strips: Sequence[CertifiedStrip]) -> list[Figure]:
    """A figure for each map, with the strip that encloses its border, if there is one."""
    found = []
    for number, log in enumerate(logs, 1):
        plane = log.progress.plane
        own = [strip for strip in strips if map_figure.is_border_of(strip.plane, plane)]
        found.append(map_figure.figure(log, own[0] if own else None, f"map-{number}"))
    return found
