"""Make the committed certificates anew, or compare them with what the program makes now."""

from __future__ import annotations

import os
from collections.abc import Mapping

from verify.cli.files import MAX_BYTES, test_folder, write_folder
from verify.cli.made import DIFFERS, SAME, WRITTEN, Made
from verify.cli.options import JSON, Options, Usage
from verify.cli.steps import Steps
from verify.prover.outcome import Outcome
from verify.wire.inputs import InputError, regular_file, shown
from verify.wire.judge import accept

USAGE = Usage(
    {
        "--directory DIR": "where the folders are (default certificates)",
        "--compare": "write nothing; exit 1 if a file would change",
        **JSON,
    },
    {"directory": "certificates"},
)


def run(options: Options) -> int:
    """Write or compare every file; return 0, or 1 if a compared file differs."""
    if not options.compare:
        test_folder("--directory", options.directory, "statement.json")
    elif not os.path.isdir(options.directory):
        raise InputError(
            f"--directory: {shown(options.directory)} is not a folder; name the certificates"
        )
    from verify.paper.commands.certificates import all_folders, number_of_folders  # loads flint

    progress = Steps(number_of_folders(options.directory))
    told, differing = Made("certify", options), 0
    for folder, outcome in all_folders(options.directory):
        path = os.path.join(options.directory, folder)
        progress(path)
        contents = folder_files(outcome)
        if options.compare:
            differing += _compare(path, contents, told)
            continue
        accept(contents, outcome.claimed)
        write_folder("--directory", path, contents)
        told(WRITTEN, path)
    return told.end(1 if differing else 0)


def folder_files(outcome: Outcome) -> dict[str, bytes]:
    """The files of a folder: statement, certificate, what is cited, and a report for people."""
    from verify.paper.source import PAPER  # loaded only where they are used
    from verify.views.markdown import report
    from verify.wire.write import write

    return write(outcome) | {"report.md": report(outcome, PAPER).encode()}


def _compare(path: str, contents: Mapping[str, bytes], told: Made) -> int:
    """Say of each file whether it is the same; return how many are not."""
    differing = 0
    for name, content in contents.items():
        file = os.path.join(path, name)
        same = _read(file) == content
        differing += not same
        told(SAME if same else DIFFERS, file)
    return differing


def _read(path: str) -> bytes | None:
    try:
        return regular_file(path, MAX_BYTES)
    except (OSError, ValueError):
        return None
