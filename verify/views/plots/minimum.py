"""Which entry of the min that bounds eta_bar is the least, over the region."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence

from verify.language.statement import PRINTED, REPAIRED, UNDECIDED
from verify.views.material import Rectangle, Region
from verify.views.plots.figure import Figure
from verify.views.plots.region import C, curves, scale
from verify.views.plots.shapes import Areas, Panel, Shape, merged

#: The colour of each entry; the third one is the usual answer.
SHADES = ("series-2", "series-4", "proved-area", "series-1", "series-6", "series-7", "series-5")

Cells = Sequence[tuple[Rectangle, int | None]]


def figure(least: Mapping[str, Cells], region: Region) -> Figure:
    """Both sets side by side."""
    captions = []
    for group in (PRINTED, REPAIRED):
        counts = Counter(index for _, index in least[group])
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
            _map("As printed", least[PRINTED], region),
            _map("Repaired", least[REPAIRED], region),
        ),
    )


def _map(title: str, cells: Cells, region: Region) -> Panel:
    present = sorted({i for _, i in cells if i is not None})

    def shapes() -> Iterator[Shape]:
        for index in [None, *present]:
            part = merged((*box[0], *box[1]) for box, entry in cells if entry == index)
            colour = "undecided" if index is None else SHADES[index]
            yield Areas(part, colour, name=UNDECIDED if index is None else f"entry {index + 1}")
        yield from curves(region)

    names = " and ".join(f"entry {index + 1}" for index in present)
    told = f"Above the curve of stability all decided cells have {names} as the smallest."
    return Panel(title, scale(region), C, shapes, told, 420, 380)
