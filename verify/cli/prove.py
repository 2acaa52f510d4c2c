"""Decide a statement of your own, and write a certificate for what is decided."""

from __future__ import annotations

import os
import sys
from hashlib import sha256

from verify import check
from verify.cli.files import (
    print_document,
    read_bytes,
    read_cited,
    test_folder,
    write_certificate,
)
from verify.cli.options import Options, Parser
from verify.cli.terminal import add_color, show
from verify.language.statement import PRINTED, UNDECIDED
from verify.language.terms import Claim
from verify.paper.source import PAPER
from verify.prover.budget import WORK, WorkBudget
from verify.prover.outcome import Outcome
from verify.views.prove import decided_document, decided_lines
from verify.wire.inputs import InputError, integer, rational, shown
from verify.wire.questions import all_cites, decide_statement

MAX_JOBS = 256


def add_arguments(parser: Parser) -> None:
    """The options."""
    parser.place("STATEMENT", "a statement.json whose rows are questions")
    parser.option("--out", "write the decided statement and a certificate of it", "DIR")
    parser.option("--work", f"units of work for each row (default {WORK})", "N")
    parser.option("--time", "leave undecided what is not decided after S seconds", "S")
    parser.option(
        "--jobs",
        "processes at most; rows build on earlier ones, so that one is used",
        "N",
        default="1",
    )
    parser.flag("--json", text="one JSON document on stdout")
    add_color(parser)


def run(options: Options) -> int:
    """Print a line for each row or the document, write the files, return the exit code."""
    work = WORK if options.work is None else integer("--work", options.work, 1, 999_999_999)
    integer("--jobs", options.jobs, 1, MAX_JOBS)
    content, cited = read_bytes("STATEMENT", options.STATEMENT), _cited(options.STATEMENT)
    test_folder("--out", options.out, "statement.json", "certificate.json")
    outcome = decide_statement(content, cited, WorkBudget(work, _seconds(options.time)))
    if options.out is not None:
        _write(options.out, outcome)
    outcome = _but_for_citations(outcome)
    if options.json:
        print_document(decided_document(outcome))
    else:
        show(decided_lines(outcome, PAPER), options)
    return outcome.exit_code


def _write(directory: str, outcome: Outcome) -> None:
    """Write a certificate, if there is a form for what is undecided."""
    unwritten = [
        row.name
        for row, found in outcome.rows
        if found.claimed == UNDECIDED and row.role == PRINTED and not isinstance(row.claim, Claim)
    ]
    if unwritten:
        where = f"{unwritten[0]}, which is about a context, is undecided"
        print(f"verify: the row {where}; no certificate was written", file=sys.stderr)
    else:
        write_certificate("--out", directory, outcome)


def _seconds(text: str | None) -> float | None:
    if text is None:
        return None
    seconds = rational("--time", text)
    if not 0 < seconds < 10**9:
        raise InputError(f"--time: {shown(text)} is no time to wait; write seconds such as 60")
    return float(seconds)


def _cited(path: str) -> dict[str, bytes]:
    """What lies in the folder `cited` beside a statement, by the digests; certificates, too.

    Raises:
        InputError: if the checker does not accept a certificate there.
    """
    files = read_cited("STATEMENT", os.path.dirname(path))
    found = {sha256(content).hexdigest(): content for content in files.values()}
    work = check.MAX_WORK
    for name, certificate in files.items():
        if name.endswith(check.CERTIFIED):
            statement = files.get(f"{name.removesuffix(check.CERTIFIED)}.json", b"")
            report = check.examined(statement, certificate, found, work)
            if report.verdict != "PROVED":
                reason = next((s for s in report.lines if s.startswith("REFUSED")), report.summary)
                raise InputError(
                    f"STATEMENT: the checker does not accept cited/{shown(name)} ({reason:.200}); "
                    "mend it, or take it away"
                )
            work -= report.work
    return found


def _but_for_citations(outcome: Outcome) -> Outcome:
    """The outcome, undecided where something cited is not proved."""
    opened = [c for c in all_cites(outcome.statement.cites) if not c.certificate]
    if outcome.spent or not opened:
        return outcome
    return outcome._replace(
        spent=f"{opened[0].theorem}, which is cited, is not proved here; put its certificate "
        f"beside its statement, as cited/NAME{check.CERTIFIED}"
    )
