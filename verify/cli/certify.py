"""Make the committed certificates anew, or compare them with what the program makes now."""

from __future__ import annotations

import os
from argparse import ArgumentParser, Namespace

from verify.jobs.certificates import all_folders
from verify.cli.files import progress, write_all


def add_arguments(parser: ArgumentParser) -> None:
    """The options."""
    parser.add_argument(
        "--directory", default="certificates", help="where the folders are (default certificates)"
    )
    parser.add_argument(
        "--compare", action="store_true", help="write nothing; exit 1 if a file would change"
    )


def run(options: Namespace) -> int:
    """Write or compare every file; return 0, or 1 if a compared file differs."""
    differing = 0
    for folder, contents in all_folders():
        path = os.path.join(options.directory, folder)
        progress(path)
        if not options.compare:
            write_all("--directory", path, contents)
            print(f"written  {path}")
            continue
        for name, content in contents.items():
            file = os.path.join(path, name)
            same = _read(file) == content
            differing += not same
            print(f"{'same' if same else 'DIFFERS':<8} {file}")
    return 1 if differing else 0


def _read(path: str) -> bytes | None:
    try:
        with open(path, "rb") as file:
            return file.read()
    except OSError:
        return None
