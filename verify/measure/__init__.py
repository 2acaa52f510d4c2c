"""Measurements: `bench` and `stress`. It may use every other package but the command line."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from time import process_time
from typing import Any, TypeVar

#: What a command that measures shows and writes: a title, columns, rows.
Table = dict[str, Any]
Found = TypeVar("Found")


def table(title: str, columns: Sequence[str], rows: Sequence[Sequence[Any]], **more: Any) -> Table:
    """A table; ``more`` are entries of it that are written to files and not shown."""
    return {"title": title, "columns": list(columns), "rows": list(rows), **more}


def timed(work: Callable[[], Found], rounds: int = 1) -> tuple[float, Found]:
    """The CPU seconds of the fastest of some runs, and what the last one found."""
    seconds = []
    for _ in range(rounds):
        start = process_time()
        found = work()
        seconds.append(process_time() - start)
    return min(seconds), found
