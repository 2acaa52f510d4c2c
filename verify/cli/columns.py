"""Measured tables: in columns for a terminal, as one JSON document for scripts and files."""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator, Sequence
from itertools import zip_longest
from operator import gt
from textwrap import wrap
from typing import Any

from verify.cli.files import print_document, write_all
from verify.cli.options import JSON, Options
from verify.cli.terminal import width

#: The options of a command that measures.
OPTIONS = {"--quick": "a short form, for CI", "-v, --verbose": "all columns of the tables", **JSON}


def publish(
    name: str, tables: dict[str, Any], options: Options, details: Sequence[str] = ()
) -> None:
    """Write and print what a command measured, as its options ask.

    At a terminal the columns ``details`` are shown with ``-v`` only.
    """
    document = {"format": f"verify-{name}/1", "command": name, "tables": tables}
    if options.out is not None:
        text = json.dumps(document, ensure_ascii=False, indent=1, sort_keys=True) + "\n"
        write_all("--out", options.out, {f"{name}.json": text.encode()})
    if options.json:
        print_document(document)
    else:
        left_out = () if options.verbose else details
        for table in tables.values():
            lines = table_lines(_without(table, left_out), width())
            sys.stdout.write("".join(f"{line}\n" for line in lines))


def _without(table: dict[str, Any], left_out: Sequence[str]) -> dict[str, Any]:
    kept = [i for i, name in enumerate(table["columns"]) if name not in left_out]
    rows = [table["columns"], *table["rows"]]
    columns, *cells = [[row[i] for i in kept] for row in rows]
    return {**table, "columns": columns, "rows": cells}


def table_lines(table: dict[str, Any], columns: int) -> Iterator[str]:
    """A table, no wider than so many columns if that can be: cells are broken at spaces."""
    rows = [table["columns"], *[[str(cell) for cell in row] for row in table["rows"]]]
    sizes = [max(len(row[i]) for row in rows) for i in range(len(table["columns"]))]
    least = [max(max(map(len, row[i].split() or [""])) for row in rows) for i in range(len(sizes))]
    while sum(sizes) + 2 * len(sizes) > columns and any(map(gt, sizes, least)):
        # The widest one that can be narrower.
        widest = max((size, i) for i, size in enumerate(sizes) if size > least[i])[1]
        sizes[widest] -= 1
    yield ""
    yield table["title"]
    for row in rows:
        cells = [
            wrap(cell, size or 1, break_on_hyphens=False)
            for cell, size in zip(row, sizes, strict=True)
        ]
        for parts in zip_longest(*cells, fillvalue=""):
            line = "  ".join(part.ljust(size) for part, size in zip(parts, sizes, strict=True))
            yield f"  {line}".rstrip()
