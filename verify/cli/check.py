"""Check a certificate with verify/check.py, and that its statement is the right one."""

from __future__ import annotations

import os
import sys
from argparse import ArgumentParser, Namespace

from verify import check
from verify.cli.files import read_bytes
from verify.cli.inputs import InputError


def add_arguments(parser: ArgumentParser) -> None:
    """The options."""
    parser.add_argument(
        "path", nargs="+", help="a folder, or its statement.json and certificate.json"
    )
    parser.add_argument(
        "--statement",
        action="store_true",
        help="also make the statement anew from its parameters, and compare it byte for byte",
    )
    parser.add_argument(
        "--latex", action="store_true", help="print the statement as LaTeX instead of checking it"
    )


def run(options: Namespace) -> int:
    """Check, and return the checker's exit code (1 if the statement is not the right one)."""
    if options.latex:
        from verify.views.latex import statement_source  # loaded only where it is used

        sys.stdout.write(statement_source(*_documents(options.path)))
        return 0
    code = int(check.main(options.path))
    if options.statement and code == 0:
        from verify.jobs.regenerate import is_right_statement  # loads flint

        statement, _ = _paths(options.path)
        right = is_right_statement(read_bytes("path", statement))
        print("STATEMENT " + ("AS GENERATED" if right else "NOT AS GENERATED"))
        return 0 if right else 1
    return code


def _paths(words: list[str]) -> tuple[str, str]:
    if len(words) == 1:
        return tuple(os.path.join(words[0], f"{n}.json") for n in ("statement", "certificate"))  # type: ignore[return-value]
    if len(words) != 2:
        raise InputError("path: write a folder, or its statement.json and certificate.json")
    return words[0], words[1]


def _documents(words: list[str]) -> tuple[bytes, bytes]:
    statement, certificate = _paths(words)
    return read_bytes("path", statement), read_bytes("path", certificate)
