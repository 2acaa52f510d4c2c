"""Write a certificate as a file for the proof assistant Coq, which checks it once more."""

from __future__ import annotations

import sys

from verify.cli.check import folders_at
from verify.cli.options import Options, Parser
from verify.wire.inputs import InputError, shown

SYSTEMS = ("coq",)


def add_arguments(parser: Parser) -> None:
    """The options."""
    parser.place("system", "coq")
    parser.place("folder", "a folder with a statement and its certificate")
    text = "also every constant as a definition, and every row as a lemma in ordinary notation"
    parser.flag("--readable", text=text)


def run(options: Options) -> int:
    """Print the file; return 0."""
    if options.system not in SYSTEMS:
        raise InputError(f"system: {shown(options.system)} is not known; write coq")
    from verify.wire.coq.export import export  # loaded only where it is used
    from verify.wire.coq.reading import NotAcceptedError

    (folder,) = folders_at([options.folder])
    try:
        text = export(folder, ordinary=options.readable)
    except NotAcceptedError as error:
        what = "cannot be exported"
        reason = " ".join(str(error).split())[:300]
        raise InputError(f"folder: {shown(options.folder)} {what} ({reason})") from error
    sys.stdout.write(text)
    return 0
