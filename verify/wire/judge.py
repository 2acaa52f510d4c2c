"""The checker as a judge: what the prover claims gets its verdicts here, and nowhere else.

`judged` is for what the program itself has made: a row that the checker refuses is our own error.
To judge claims that may be refused, such as those of one row after another, ask `report_on`, whose
``rows`` say *refused* of each row that is not shown (its ``lines`` that begin with REFUSED say
why), and give `with_verdicts` that report: what is refused stays undecided.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache

from verify import check
from verify.language.errors import OwnError, UnreadError
from verify.language.statement import (
    NEEDED,
    PROVED,
    REFUTED,
    UNDECIDED,
    Constant,
    Obligation,
    Statement,
)
from verify.prover.outcome import CHECKER, Decision, Judgement, Outcome, names_in
from verify.wire.write import write

#: Who judges what comes with the program: the checker has, before, and the digests are compared.
SHIPPED = "the checker, before these files were shipped (their digests are compared)"


def accept(files: Mapping[str, bytes], verdict: str) -> check.Report:
    """What the checker says of a folder that it accepts with this verdict, and with `cited`.

    Raises:
        OwnError: if it does not.
        UnreadError: if it does not get to the end; what lies in a folder shares one limit of work.
    """
    report = _report(files, check.MAX_WORK - _work(_cited(files)))
    if report.verdict != {PROVED: "PROVED", REFUTED: "REFUTED"}[verdict]:
        raise _refused(report, f"{report.verdict}, expected {verdict}")
    return report


def judged(outcome: Outcome) -> Outcome:
    """The outcome with the checker's verdict on each row of which something is claimed.

    Raises:
        OwnError: if the checker refuses anything, with the name of what it refuses.
    """
    if all(found.claimed == UNDECIDED for found in outcome.decisions.values()):
        return outcome.draft
    report = report_on(outcome)
    found = with_verdicts(outcome, report)
    for name, decision in found.decisions.items():
        if decision.verdict != decision.claimed:
            why = f"{report.rows[name]}, expected {decision.claimed}"
            raise _refused(report, why, name)
    if report.verdict == "REFUSED":
        raise _refused(report, report.summary)
    return found


def report_on(outcome: Outcome) -> check.Report:
    """What the checker says of the claims of an outcome; of the other rows it is not asked.

    Raises:
        UnreadError: if it does not get to the end: too large, too deep, or too much work.
    """
    rows = tuple(row for row, found in outcome.rows if found.claimed != UNDECIDED)
    if outcome.claimed == UNDECIDED:
        rows = tuple(row._replace(role=NEEDED) for row in rows)
    return _report(write(_restricted(outcome, rows)))


def _restricted(outcome: Outcome, rows: tuple[Obligation, ...]) -> Outcome:
    """The same with these rows only, and without constants and contexts that have no step."""
    statement = outcome.statement._replace(obligations=rows)
    if outcome.spent:
        made = {step.name for step in outcome.steps}

        def defined(constants: tuple[Constant, ...]) -> tuple[Constant, ...]:
            return tuple(one for one in constants if one.name in made)

        contexts = (one for one in statement.contexts if one.name in made)
        statement = statement._replace(
            constants=defined(statement.constants),
            contexts=tuple(c._replace(constants=defined(c.constants)) for c in contexts),
        )
    return outcome._replace(statement=statement)


def with_verdicts(outcome: Outcome, report: check.Report) -> Outcome:
    """The outcome with the verdicts in a report on its certificate, and with no others."""
    return _with(outcome, report.rows)


def _with(outcome: Outcome, verdicts: Mapping[str, str], judge: str = CHECKER) -> Outcome:
    names = names_in(outcome.statement)

    def decided(row: Obligation, found: Decision) -> Decision:
        verdict = verdicts.get(row.name, UNDECIDED)
        shown = verdict == found.claimed != UNDECIDED
        judgement = Judgement(verdict, judge, row.claim, row.context, names)
        return found._replace(judged=judgement if shown else None)

    decisions = {row.name: decided(row, found) for row, found in outcome.rows}
    return outcome._replace(decisions=decisions)


def packaged(name: str, *, anew: bool = False) -> Outcome:
    """The outcome that comes with the program, with the verdicts that the checker has given.

    With `anew` its certificate is checked again, and every verdict is the checker's of this run.

    Raises:
        OwnError: if its files are not those that it has accepted, or the checker refuses them.
    """
    from verify.wire.packaged import cited_digests, packaged_files, packaged_statements
    from verify.wire.read import read  # loaded only where they are used

    statement, certificate = packaged_files(name)
    cited = packaged_statements(cited_digests(statement))
    outcome = read(statement, certificate, cited)
    if anew:
        files = {f"cited/{digest}.json": content for digest, content in cited.items()}
        report = _report({"statement.json": statement, "certificate.json": certificate, **files})
        if report.verdict == "REFUSED":
            raise _refused(report, report.summary)
        return with_verdicts(outcome, report)
    verdicts = {row: found.claimed for row, found in outcome.decisions.items()}
    return _with(outcome, verdicts, SHIPPED)


def known(name: str, statement: Statement, *, anew: bool = False) -> Outcome | None:
    """The outcome of a statement, if it comes with the program under this name; else None.

    It is compared with the statement that the checker has accepted: after any change to what the
    paper's pages say, they differ, and whoever asks has to prove it anew.

    Raises:
        OwnError: if the files that came with the program were changed, or the checker refuses them.
    """
    outcome = packaged(name, anew=anew)
    return outcome if outcome.statement == statement else None


def read_judged(statement: bytes, certificate: bytes, cited: Mapping[str, bytes]) -> Outcome:
    """The outcome that two files stand for, each row with the checker's verdict.

    Raises:
        WireError: for files that are not in the format.
        check.Malformed: if the checker cannot read them.
        check.Refused: if it refuses anything.
    """
    from verify.wire.read import read  # loaded only where it is used

    outcome, report = (
        read(statement, certificate, cited),
        check.check(statement, certificate, cited),
    )
    if report.verdict == "REFUSED":
        raise check.Refused(report.summary)
    return with_verdicts(outcome, report)


def _cited(files: Mapping[str, bytes]) -> tuple[tuple[str, bytes], ...]:
    return tuple((name, data) for name, data in files.items() if name.startswith("cited/"))


@lru_cache(maxsize=8)
def _work(cited: tuple[tuple[str, bytes], ...]) -> int:
    """What the checker counts for the certificates among these files, all of which it accepts."""
    from verify.wire.packaged import packaged_work  # loaded only where it is used

    work = 0
    for name, certificate in cited:
        if name.endswith(check.CERTIFIED):
            statement = dict(cited)[f"{name.removesuffix(check.CERTIFIED)}.json"]
            counted = packaged_work(statement, certificate)
            if counted is None:
                cites_others = any(
                    other[len("cited/") :][:64].encode() in statement for other, _ in cited
                )
                files = cited if cites_others else ()
                counted = _work_of(name, statement, certificate, files)
            work += counted
    return work


@lru_cache(maxsize=8)
def _work_of(
    name: str, statement: bytes, certificate: bytes, cited: tuple[tuple[str, bytes], ...]
) -> int:
    """The same of one of them, beside what it may cite."""
    files = {"statement.json": statement, "certificate.json": certificate}
    report = _report({**dict(cited), **files})
    if report.verdict != "PROVED":
        raise _refused(report, f"{name}: {report.verdict}, expected PROVED")
    return report.work


def _report(files: Mapping[str, bytes], work: int | None = None) -> check.Report:
    named = {name.removeprefix("cited/").removesuffix(".json"): x for name, x in _cited(files)}
    cited = {name: content for name, content in named.items() if "." not in name}
    try:
        return check.check(files["statement.json"], files["certificate.json"], cited, work)
    except (check.Malformed, RecursionError) as error:
        raise UnreadError(_not_accepted(f"MALFORMED: {error}")) from error


def _refused(report: check.Report, otherwise: str, row: str = "") -> OwnError:
    complaints = (line for line in report.lines if line.startswith("REFUSED"))
    where = f"row {row}: " if row else ""
    return OwnError(_not_accepted(where + next(complaints, otherwise)))


def _not_accepted(why: str) -> str:
    return f"our own checker does not accept the certificate ({why:.200}); nothing was written"
