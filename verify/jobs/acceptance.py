"""What the prover has found, asked of the checker before anybody sees it."""

from __future__ import annotations

from collections.abc import Mapping
from hashlib import sha256

from verify import check
from verify.jobs.errors import OwnError, UnreadError
from verify.language.statement import NEEDED, PRINTED, PROVED, REFUTED, UNDECIDED, Obligation
from verify.prover.outcome import Outcome
from verify.wire.write import write


def accept(files: Mapping[str, bytes], verdict: str) -> None:
    """Afterwards the checker accepts a certificate, with this verdict.

    Raises:
        OwnError: if it does not.
    """
    others = (content for name, content in files.items() if name.startswith("cited/"))
    cited = {sha256(content).hexdigest(): content for content in others}
    try:
        report = check.check(files["statement.json"], files["certificate.json"], cited)
    except (check.Malformed, RecursionError) as error:
        raise UnreadError(_not_accepted(f"MALFORMED: {error}")) from error
    if report.verdict != {PROVED: "PROVED", REFUTED: "REFUTED"}[verdict]:
        refused = [line for line in report.lines if line.startswith("REFUSED")]
        found = refused[0] if refused else f"{report.verdict}, expected {verdict}"
        raise OwnError(_not_accepted(found))


def accept_decided(outcome: Outcome) -> None:
    """Afterwards the checker accepts the proofs of all rows that are decided; nothing is written.

    Raises:
        OwnError: if it does not.
    """

    def asked(row: Obligation) -> Obligation:
        undecided = outcome.decisions[row.name].verdict == UNDECIDED
        return row._replace(role=PRINTED) if undecided else row

    rows = tuple(map(asked, outcome.statement.obligations))
    if not outcome.spent and any(row.role == NEEDED for row in rows):
        decided = outcome._replace(statement=outcome.statement._replace(obligations=rows))
        accept(write(decided), decided.verdict)


def _not_accepted(why: str) -> str:
    return f"our own checker does not accept the certificate ({why:.200}); nothing was written"
