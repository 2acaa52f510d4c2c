"""Judge what the paper prints outside the proof of Theorem 1 and the spectrum."""

from __future__ import annotations

from verify.cli import claims
from verify.cli.files import test_folder
from verify.cli.options import Options, Usage
from verify.paper.commands.pages import accepted
from verify.paper.source import PAPER

FORMAT = "verify-elsewhere/1"
TITLE = "What the paper prints outside the proof of Theorem 1 and the spectrum"


USAGE = Usage(claims.OPTIONS)


def run(options: Options) -> int:
    """Print the rows or the document, write the files, return the exit code."""
    from verify.views.document import claims_document  # loaded only where they are used
    from verify.views.row_lists import screen
    from verify.views.words import summary

    test_folder("--out", options.out, "statement.json", "certificate.json")
    outcome = accepted("sections_1_to_4")
    claims.answer(
        outcome,
        options,
        lambda outcome: claims_document(outcome, "elsewhere", FORMAT),
        lambda outcome: [*screen(TITLE, outcome, PAPER), "", f"Verdict: {summary(outcome, PAPER)}"],
    )
    return outcome.exit_code
