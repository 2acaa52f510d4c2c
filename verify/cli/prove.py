"""Decide a statement of your own, and write a certificate for what is decided."""

from __future__ import annotations

import os
import re
import sys
from hashlib import sha256

from verify import check
from verify.cli.files import PAGES, example, print_document, read_bytes, read_cited, test_folder
from verify.cli.options import CERTIFICATE, COLOR, JSON, Options, Usage
from verify.cli.steps import Steps
from verify.cli.terminal import show
from verify.language.statement import NEEDED, PRINTED, Obligation, Statement
from verify.prover.budget import WORK, WorkBudget
from verify.prover.outcome import Outcome
from verify.publication import NOBODYS, Publication
from verify.views.prove import decided_document, decided_lines
from verify.wire.inputs import InputError, TooDeepError, integer, nearest, rational, shown
from verify.wire.questions import all_cites, decide_page, read_page_of

#: The exit code of what was interrupted, as of any command.
INTERRUPTED = 130


USAGE = Usage(
    {
        "STATEMENT": "a page of constants (.toml), a statement.json of questions, or an "
        f"example: {', '.join(PAGES)}; - is standard input",
        "--rows NAME,NAME": "decide only these rows, and leave the others out",
        **CERTIFICATE,
        "--work N": f"units of work for each row (default {WORK})",
        "--time S": "share S seconds among the rows; what they leave is undecided",
        "-v, --verbose": "also the numbers of each row",
        **JSON,
        **COLOR,
    },
    example="agm",
)


def run(options: Options) -> int:
    """Print a line for each row or the document, write the files, return the exit code."""
    options.STATEMENT = example(options.STATEMENT)
    work = WORK if options.work is None else integer("--work", options.work, 1, 999_999_999)
    seconds = _seconds(options.time)
    budget = WorkBudget(work, seconds, catches=True)  # its time has begun
    if options.STATEMENT == "-":
        from verify.cli.piped import piped  # loaded only where it is used

        options.STATEMENT, content = piped()
    else:
        content = read_bytes("STATEMENT", options.STATEMENT)
    cited = _cited(options.STATEMENT)
    test_folder("--out", options.out, "statement.json", "certificate.json")
    try:
        page = read_page_of(options.STATEMENT, content, cited, seconds)
    except RecursionError as error:
        raise _too_deep(options.STATEMENT) from error
    statement = _chosen(page.statement, options.rows)
    if options.rows is not None:
        page = page.with_rows(statement.obligations)
    if options.rows is not None and options.out is not None:
        from verify.cli.prove_folder import keep_more  # loaded only where it is used

        keep_more(options.out, statement)
    budget.watch = Steps(len(statement.obligations))
    try:
        outcome = decide_page(page, budget)
    except (TooDeepError, RecursionError) as error:
        # The checker counts brackets of the statement that is made of a page.
        raise _too_deep(options.STATEMENT) from error
    if options.out is not None:
        from verify.cli.prove_folder import write  # loaded only where it is used

        write(options.out, outcome)
    outcome = _with_line(_but_for_citations(outcome), options.STATEMENT, content)
    if options.json:
        print_document(decided_document(outcome))
    else:
        show(decided_lines(outcome, _publication(outcome), numbers=options.verbose), options)
    if budget.interrupted:
        print("verify: interrupted", file=sys.stderr)
        return INTERRUPTED
    return outcome.exit_code


def _too_deep(path: str) -> InputError:
    is_smtlib = path.endswith(".smt2")
    remedy = "declare a constant for a part, and assert that it is equal" if is_smtlib else ""
    return InputError(f"{shown(path)}: a term nests too deeply; {remedy or 'name its parts'}")


def _publication(outcome: Outcome) -> Publication:
    """The paper, which has a name for some labels and citations; nobody's where there is none."""
    statement = outcome.statement
    labels = [row.label for row in statement.obligations]
    labels += [assumption.label for assumption in statement.assumptions]
    if not statement.cites and not any(labels):
        return NOBODYS
    from verify.paper.source import PAPER  # loaded only where it is used

    return PAPER


def _with_line(outcome: Outcome, path: str, content: bytes) -> Outcome:
    """The outcome; where a constant of a page has no value, it says in which line that stands."""
    name, found, why = outcome.spent.partition(" has no value")
    if not found or not path.endswith(".toml"):
        return outcome
    from verify.wire.text.places import Places  # loaded only where it is used

    places = Places(path, content.decode("utf-8-sig"))
    keys = ["constants", name]
    if places.known(keys) < len(keys):
        return outcome
    return outcome._replace(spent=f"{places.told(keys)}{found}{why}")


def _chosen(statement: Statement, names: str | None) -> Statement:
    """The statement with the rows that are asked for, in its own order.

    Raises:
        InputError: for a name of no row.
    """
    if names is None:
        return statement
    wanted = {name.strip() for name in names.split(",")}
    chosen = {row.name: wanted & _names_of(row) for row in statement.obligations}
    rows = tuple(row for row in statement.obligations if chosen[row.name])
    unknown = sorted(wanted.difference(*chosen.values()))
    if unknown:
        instead = nearest(unknown[0], [row.name for row in statement.obligations])
        raise InputError(f"--rows: there is no row {shown(unknown[0])}; {instead}")
    if all(row.role == PRINTED for row in rows):
        rows = tuple(row._replace(role=NEEDED) for row in rows)
    return statement._replace(obligations=rows)


def _names_of(row: Obligation) -> set[str]:
    """What a row is called: its name, and without the number that it has in a chain."""
    return {row.name, re.sub(r"\.[0-9]+$", "", row.name)}


def _seconds(text: str | None) -> float | None:
    if text is None:
        return None
    try:
        seconds = rational("--time", text)
    except InputError:
        from verify.wire.meant import in_seconds  # loaded only where it is needed

        meant = in_seconds(text.strip())
        if not meant:
            raise
        told = f"--time: {shown(text)} has a unit; write {meant}, the number of seconds"
        raise InputError(told) from None
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
        f"beside its statement, as verify prove --out cited/NAME does, or as "
        f"cited/NAME{check.CERTIFIED}"
    )
