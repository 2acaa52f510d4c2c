"""Write a certificate as a file for the proof assistant Coq, which checks it once more."""

from __future__ import annotations

import sys
from argparse import ArgumentParser, Namespace

from verify.cli.check import folders_at
from verify.jobs.inputs import InputError, shown


def add_arguments(parser: ArgumentParser) -> None:
    """The options."""
    parser.add_argument("system", choices=["coq"], help="the proof assistant")
    parser.add_argument("folder", help="a folder with a statement and its certificate")


def run(options: Namespace) -> int:
    """Print the file; return 0."""
    from verify.views import coq  # loaded only where it is used

    (folder,) = folders_at([options.folder])
    try:
        text = coq.export(folder)
    except coq.NotAcceptedError as error:
        reason = " ".join(str(error).split())[:300]
        raise InputError(
            f"folder: {shown(options.folder)} has no certificate that proves its statement ({reason})"
        ) from error
    sys.stdout.write(text)
    return 0
