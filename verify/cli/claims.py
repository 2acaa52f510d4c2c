"""What the commands about all values have in common: their options, and the rows they print."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable, Mapping
from typing import Any

from verify.cli.options import CERTIFICATE, COLOR, JSON, ROWS, VERBOSE, Options
from verify.cli.terminal import show
from verify.prover.outcome import Outcome
from verify.wire.inputs import InputError, shown

#: The options.
OPTIONS = {**VERBOSE, **ROWS, **JSON, **COLOR, **CERTIFICATE}


def answer(
    outcome: Outcome,
    options: Options,
    document: Callable[[Outcome], Mapping[str, Any]],
    screen: Callable[[Outcome], Iterable[str]],
    *,
    has_rows: bool = False,
) -> None:
    """Write the certificate that is asked for, and print the document or the screen.

    Both are of the outcome that the checker has judged, if a certificate of it was written.
    With ``--rows`` only those rows of it are printed, with ``-v`` every row: before the screen, if
    it does not have them.

    Raises:
        InputError: if there is no row of this name, or a file cannot be written; after the verdict
            is printed, if the checker would not read to the end of its certificate.
    """
    from verify.cli.files import UncheckableError, print_document, write_certificate  # when used

    if options.rows is not None:
        named(outcome, options.rows)  # before anything is written
    missing: UncheckableError | None = None
    try:
        if options.out is not None:
            outcome = write_certificate("--out", options.out, outcome)
    except UncheckableError as error:  # the verdict is known all the same
        missing = error
    if options.json:
        found = document(outcome)
        print_document(found if options.rows is None else only(outcome, options.rows, found))
    else:
        show(told(outcome, options, screen(outcome), has_rows=has_rows), options)
    if missing is not None:
        sys.stdout.flush()
        raise missing


def only(outcome: Outcome, name: str, document: Mapping[str, Any]) -> dict[str, Any]:
    """A document with no other rows than those of a name, a label or a printed number.

    Raises:
        InputError: if there is no such row.
    """
    names = named(outcome, name)
    return {key: _without_others(value, names) for key, value in document.items()}


def named(outcome: Outcome, name: str) -> set[str]:
    """The rows of a name, a label or a printed number.

    Raises:
        InputError: if there is no such row.
    """
    from verify.paper.source import PAPER  # loaded only where they are used
    from verify.views.words import is_called

    names = {row.name for row, _ in outcome.rows if is_called(row, name, PAPER)}
    if not names:
        raise no_row(outcome, name)
    return names


def _without_others(value: Any, names: set[str]) -> Any:
    if isinstance(value, dict):
        return {key: _without_others(inner, names) for key, inner in value.items()}
    if isinstance(value, list):
        return [item for item in value if not _is_row(item) or item["name"] in names]
    return value


def _is_row(item: Any) -> bool:
    """Whether this part of a document has the shape of a row."""
    return isinstance(item, dict) and {"name", "role", "claim"} <= item.keys()


def told(outcome: Outcome, options: Options, screen: Iterable[str], *, has_rows: bool) -> list[str]:
    """What fits on a screen; with ``-v`` after every row and what is taken on trust.

    With ``--rows`` the rows of that name, and of the screen the last line, which has the verdict.

    Raises:
        InputError: if there is no row of this name.
    """
    *lines, verdict = screen
    if options.rows is None and (has_rows or not options.verbose):
        return [*lines, verdict]
    from verify.paper.source import PAPER  # loaded only where they are used
    from verify.views.row_lists import all_rows, rows_called
    from verify.views.words import taken_on_trust

    if options.rows is not None:
        found = rows_called(outcome, options.rows, PAPER)
        if not found:
            raise no_row(outcome, options.rows)
        return [*found, "", verdict]
    return [*all_rows(outcome, PAPER), *taken_on_trust(outcome, PAPER), "", *lines, verdict]


def no_row(outcome: Outcome, word: str) -> InputError:
    """The message about a name that no row has, with what to write instead."""
    from difflib import get_close_matches

    from verify.views.words import short_name

    known = {name for row, _ in outcome.rows for name in (row.name, short_name(row))}
    near = get_close_matches(word, sorted(known), 3, 0.6)
    what = f"is it {', '.join(near)}?" if near else "write a name that -v prints"
    return InputError(f"--rows: there is no row {shown(word)}; {what}")
