"""Speed against error of maps: what a smaller undecided share costs, and what the check of it."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from verify.measure import Table, table

#: How maps of one plane end: at an undecided share, or at a strip of this height.
ENDS = ("--undecided 3%", "--undecided 1%", "--undecided 0.3%", "--undecided 0.1%", "--strip 1e-5")
QUICK = 1
#: `verify.check_map` as its users start it, from its .pyc.
CHECK = "import sys; from verify import check_map; sys.exit(check_map.main(sys.argv[1:]))"


def maps_table(quick: bool, rounds: int, cpu: Callable[[list[str]], float]) -> Table:
    """For each end: boxes, CPU milliseconds of the map with its log and of the check, their ratio.

    ``cpu`` measures Python with some words after it.
    """
    rows: list[list[Any]] = []
    for end in ENDS[:QUICK] if quick else ENDS:
        pairs = []
        for _ in range(rounds):
            with TemporaryDirectory() as folder:
                made = ["map", "phi", "--r", "0.03", *end.split(), "--out", f"{folder}/map"]
                log = f"{folder}/map/map.jsonl"
                pairs.append((cpu(["-m", "verify", *made]), cpu(["-c", CHECK, log])))
                told = json.loads(Path(folder, "map", "map.json").read_text(encoding="utf-8"))
        whole, check = map(min, zip(*pairs, strict=True))
        boxes = told["boxes"]
        times = [f"{1000 * seconds:.0f}" for seconds in (whole, check)]
        rows.append([end, boxes, *times, f"{check / whole:.2f}"])
    columns = ["end", "boxes", "ms", "check: ms", "check / map"]
    return table("Maps at r = 3/100: CPU time of whole processes", columns, rows)
