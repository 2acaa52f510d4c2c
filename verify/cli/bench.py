"""Measure speed against error; times are medians, errors are exact."""

from __future__ import annotations

import json
import sys
from argparse import ArgumentParser, Namespace

from verify.files import print_document, write_all
from verify.inputs import InputError
from verify.views.columns import print_tables


def add_arguments(parser: ArgumentParser) -> None:
    """The options."""
    parser.add_argument("--quick", action="store_true", help="fewer precisions and repetitions")
    parser.add_argument("--json", action="store_true", help="one JSON document on stdout")
    parser.add_argument("--out", metavar="DIR", help="write bench.json there")


def run(options: Namespace) -> int:
    """Measure, print the tables, and return 0."""
    try:
        from verify import bench
        from verify.engines import MpmathEngine

        MpmathEngine()
    except ImportError as error:
        raise InputError(
            f"bench needs {error.name}; install the extra: pip install -e '.[bench]'"
        ) from error

    def progress(text: str) -> None:
        if sys.stderr.isatty():
            print(f"{text} …", file=sys.stderr)

    document = {"command": "bench", "tables": bench.run(options.quick, progress)}
    if options.out is not None:
        text = json.dumps(document, ensure_ascii=False, indent=1, sort_keys=True) + "\n"
        write_all("--out", options.out, {"bench.json": text.encode()})
    if options.json:
        print_document(document)
    else:
        print_tables(document)
    return 0
