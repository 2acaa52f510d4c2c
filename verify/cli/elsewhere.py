"""Judge what the paper prints outside the proof of Theorem 1 and the spectrum."""

from __future__ import annotations

import sys

from verify.cli.files import print_document, test_folder, write_certificate
from verify.cli.options import Options, Parser
from verify.jobs.elsewhere import decide_elsewhere


def add_arguments(parser: Parser) -> None:
    """The options."""
    parser.flag("-v", "--verbose", text="print every row")
    parser.flag("--json", text="one JSON document on stdout")
    parser.option("--out", "write statement.json and certificate.json", "DIR")


def run(options: Options) -> int:
    """Print the rows or the document, write the files, return the exit code."""
    from verify.views.classification import claim_rows  # loaded only where they are used
    from verify.views.elsewhere import elsewhere_document, screen

    test_folder("--out", options.out, "statement.json", "certificate.json")
    outcome = decide_elsewhere()
    if options.out is not None:
        write_certificate("--out", options.out, outcome)
    if options.json:
        print_document(elsewhere_document(outcome))
    else:
        text = [*claim_rows(outcome)] if options.verbose else []
        text += screen(outcome)
        sys.stdout.write("".join(f"{line}\n" for line in text))
    return outcome.exit_code
