"""Plots of certified enclosures: every band and box is drawn from balls over a whole cell."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from verify.jobs.covers import DEPTH
from verify.views.plots import margins, minimum, region, roots, speed
from verify.views.plots.figure import Figure

#: How many figures there are, with measurements.
NUMBER = 5


def figures(precision: Mapping[str, Any] | None, depth: int = DEPTH) -> list[Figure]:
    """Every figure of the report; the first one is also the picture of the README.

    ``precision`` is the table of that name of the committed measurements, if there is one;
    ``depth`` says how often a side of the plane is halved.
    """
    found = [
        region.picture(),
        margins.figure(),
        minimum.figure(depth - 1),
        roots.figure(),
    ]
    last = None if precision is None else speed.figure(precision)
    return found if last is None else [*found, last]
