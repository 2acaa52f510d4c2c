"""Which entry of the min that bounds eta_bar is the least, over the region."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from typing import Any

from verify.jobs.covers import least_entries
from verify.language.statement import UNDECIDED
from verify.paper.groups import PRINTED, REPAIRED
from verify.prover.cover import Box
from verify.views.plots.drawing import COLOURS, Panel, boxes, merged
from verify.views.plots.figure import Figure
from verify.views.plots.region import frame

#: The colour of each entry; the third one is the usual answer.
SHADES = ("series-2", "series-4", "proved-area", "series-1", "series-6", "series-7", "series-5")

Cells = list[tuple[Box, int | None]]


def figure(depth: int) -> Figure:
    """Both sets side by side."""
    captions = []
    for group in (PRINTED, REPAIRED):
        cells = least_entries(group, depth)
        counts = Counter(index for _, index in cells)
        parts = ", ".join(
            f"entry {index + 1} on {counts[index]} cells"
            for index in sorted(i for i in counts if i is not None)
        )
        captions.append(f"{group}: {parts}, undecided on {counts[None]}")
    return Figure(
        "minimum",
        "Which entry of η̄ is the smallest",
        "On each coloured cell one entry of the min that defines or bounds η̄ is at most each other "
        f"one at every point of the cell ({'; '.join(captions)}). Grey: two entries cross there, "
        "or the cell is too wide to tell.",
        (
            Panel("As printed", _map(least_entries(PRINTED, depth)), 400, 330),
            Panel("Repaired", _map(least_entries(REPAIRED, depth)), 400, 330),
        ),
    )


def _map(cells: Cells) -> Callable[[Any], None]:
    def draw(axis: Any) -> None:
        for index in [None, *sorted({i for _, i in cells if i is not None})]:
            part = merged((*box[0], *box[1]) for box, least in cells if least == index)
            if index is None:
                boxes(axis, part, "undecided", name=UNDECIDED)
            else:
                boxes(axis, part, SHADES[index], name=f"entry {index + 1}")
        frame(axis, labels=False)
        axis.legend(loc="lower right", labelcolor=COLOURS["ink"])

    return draw
