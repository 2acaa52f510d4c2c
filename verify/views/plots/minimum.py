"""Which entry of the min that bounds eta_bar is the least, over the region."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from verify.language.statement import UNDECIDED
from verify.paper.commands.covers import least_entries
from verify.paper.groups import PRINTED, REPAIRED
from verify.prover.cover import Box
from verify.views.plots.figure import Figure
from verify.views.plots.region import C, S, curves
from verify.views.plots.shapes import Areas, Panel, Shape, merged

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
            _map("As printed", least_entries(PRINTED, depth)),
            _map("Repaired", least_entries(REPAIRED, depth)),
        ),
    )


def _map(title: str, cells: Cells) -> Panel:
    present = sorted({i for _, i in cells if i is not None})

    def shapes() -> Iterator[Shape]:
        for index in [None, *present]:
            part = merged((*box[0], *box[1]) for box, least in cells if least == index)
            colour = "undecided" if index is None else SHADES[index]
            yield Areas(part, colour, name=UNDECIDED if index is None else f"entry {index + 1}")
        yield from curves()

    names = " and ".join(f"entry {index + 1}" for index in present)
    told = f"Above the curve of stability all decided cells have {names} as the smallest."
    return Panel(title, S, C, shapes, told, 420, 380)
