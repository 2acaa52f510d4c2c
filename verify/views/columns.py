"""Measured tables in columns, for a terminal."""

from __future__ import annotations

from typing import Any


def print_tables(document: dict[str, Any]) -> None:
    """Print every table of a document in columns."""
    for table in document["tables"].values():
        rows = [table["columns"], *[[str(cell) for cell in row] for row in table["rows"]]]
        widths = [max(len(row[i]) for row in rows) for i in range(len(table["columns"]))]
        print(f"\n{table['title']}")
        for row in rows:
            print("  " + "  ".join(c.ljust(w) for c, w in zip(row, widths, strict=True)).rstrip())
