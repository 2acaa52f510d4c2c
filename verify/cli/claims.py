"""What the commands about all values have in common: their options, and the rows they print."""

from __future__ import annotations

from collections.abc import Iterable

from verify.cli.options import Options, Parser
from verify.cli.terminal import add_color
from verify.prover.outcome import Outcome
from verify.wire.inputs import InputError, shown


def add_arguments(parser: Parser) -> None:
    """The options."""
    parser.flag("-v", "--verbose", text="print every row, and every sentence taken on trust")
    parser.option("--rows", "print the rows of this name, label or (4.47) only", "NAME")
    parser.flag("--json", text="one JSON document on stdout")
    add_color(parser)
    parser.option("--out", "write statement.json and certificate.json", "DIR")


def told(outcome: Outcome, options: Options, screen: Iterable[str]) -> list[str]:
    """What fits on a screen; with ``-v`` after every row and what is taken on trust.

    With ``--rows`` the rows of that name, and of the screen the last line, which has the verdict.

    Raises:
        InputError: if there is no row of this name.
    """
    from verify.paper.source import PAPER  # loaded only where they are used
    from verify.views.row_lists import all_rows, rows_called
    from verify.views.words import taken_on_trust

    *lines, verdict = screen
    if options.rows is not None:
        found = rows_called(outcome, options.rows, PAPER)
        if not found:
            word = shown(options.rows)
            raise InputError(f"--rows: there is no row {word}; {instead(outcome, options.rows)}")
        return [*found, "", verdict]
    if options.verbose:
        lines = [*all_rows(outcome, PAPER), *taken_on_trust(outcome, PAPER), "", *lines]
    return [*lines, verdict]


def instead(outcome: Outcome, word: str) -> str:
    """What to write instead of a name that no row has."""
    from difflib import get_close_matches

    from verify.views.words import short_name

    known = {name for row, _ in outcome.rows for name in (row.name, short_name(row))}
    near = get_close_matches(word, sorted(known), 3, 0.6)
    return f"is it {', '.join(near)}?" if near else "write a name that -v prints"
