"""Judge what the paper prints outside the proof of Theorem 1 and the spectrum."""

from __future__ import annotations

from verify.cli import claims
from verify.cli.files import print_document, test_folder, write_certificate
from verify.cli.options import Options, Parser
from verify.cli.terminal import show
from verify.paper.commands.elsewhere import decide_elsewhere
from verify.paper.source import PAPER


def add_arguments(parser: Parser) -> None:
    """The options."""
    claims.add_arguments(parser)


def run(options: Options) -> int:
    """Print the rows or the document, write the files, return the exit code."""
    from verify.views.elsewhere import elsewhere_document, screen

    test_folder("--out", options.out, "statement.json", "certificate.json")
    outcome = decide_elsewhere()
    if options.out is not None:
        write_certificate("--out", options.out, outcome)
    if options.json:
        print_document(elsewhere_document(outcome))
    else:
        show(claims.told(outcome, options, screen(outcome, PAPER)), options)
    return outcome.exit_code
