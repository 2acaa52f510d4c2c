"""Print a row with the facts that prove it and the identity, so that it can be checked by hand."""

from __future__ import annotations

import sys

from verify.cli.graph import outcome_of
from verify.cli.options import Options, Parser
from verify.jobs.inputs import InputError, shown


def add_arguments(parser: Parser) -> None:
    """The options."""
    parser.place("row", "the name of a row or lemma, with or without its group")
    text = "a folder with a certificate (default: Theorem 1 for all parameters, and the step)"
    parser.option("--folder", text, "DIR")


def run(options: Options) -> int:
    """Print what is known of the row; return 0."""
    from verify.views.explain import explain  # loaded only where it is used

    if options.folder is not None:
        text = explain(outcome_of(options.folder), options.row)
    else:
        from verify.jobs import step

        text = explain(outcome_of(None), options.row) + explain(step.decide_step(), options.row)
    if not text:
        raise InputError(f"row: there is no row {shown(options.row)}; write a name of a report")
    sys.stdout.write("".join(f"{line}\n" for line in text))
    return 0
