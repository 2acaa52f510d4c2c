"""Measured tables: in columns for a terminal, as one JSON document for scripts and files."""

from __future__ import annotations

import json
from typing import Any

from verify.cli.files import print_document, write_all
from verify.cli.options import Options, Parser


def add_arguments(parser: Parser, name: str) -> None:
    """The options of a command that measures."""
    parser.flag("--quick", text="a short form, for CI")
    parser.flag("--json", text="one JSON document on stdout")
    parser.option("--out", f"write {name}.json there", "DIR")


def publish(name: str, tables: dict[str, Any], options: Options) -> None:
    """Write and print what a command measured, as its options ask."""
    document = {"format": f"verify-{name}/1", "command": name, "tables": tables}
    if options.out is not None:
        text = json.dumps(document, ensure_ascii=False, indent=1, sort_keys=True) + "\n"
        write_all("--out", options.out, {f"{name}.json": text.encode()})
    if options.json:
        print_document(document)
    else:
        for table in tables.values():
            _print_table(table)


def _print_table(table: dict[str, Any]) -> None:
    rows = [table["columns"], *[[str(cell) for cell in row] for row in table["rows"]]]
    widths = [max(len(row[i]) for row in rows) for i in range(len(table["columns"]))]
    print(f"\n{table['title']}")
    for row in rows:
        print("  " + "  ".join(c.ljust(w) for c, w in zip(row, widths, strict=True)).rstrip())
