"""The job `spectrum`: decide all spectral claims, for every r in ]0,1[."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from verify.prover.forall import Finding, decide_row
from verify.paper.spectrum.printed import Printed
from verify.paper.spectrum.theorem import theorem
from verify.prover.ground import PROVED, REFUTED, UNDECIDED
from verify.language.statement import Assumption, Obligation, Statement

Rows = Sequence[tuple[Obligation, Finding]]


class Outcome(NamedTuple):
    """All rows with what was found."""

    statement: Statement
    rows: Rows

    @property
    def verdict(self) -> str:
        """The verdict on the needed rows; an empty list of them proves nothing."""
        verdicts = {finding.verdict for row, finding in self.rows if row.role == "needed"}
        for verdict in (REFUTED, UNDECIDED):
            if verdict in verdicts:
                return verdict
        return PROVED if verdicts else UNDECIDED

    @property
    def assumptions(self) -> tuple[Assumption, ...]:
        """The sentences that the rows take on trust."""
        used = {name for row, _ in self.rows for name in row.uses}
        return tuple(a for a in self.statement.assumptions if a.name in used)

    @property
    def undecided(self) -> bool:
        """Whether a row of any role is left undecided."""
        return any(finding.verdict == UNDECIDED for _, finding in self.rows)

    @property
    def exit_code(self) -> int:
        """0 proved, 1 refuted, 3 undecided."""
        return {PROVED: 0, REFUTED: 1, UNDECIDED: 3}[self.verdict]


def decide(paper: Printed | None = None) -> Outcome:
    """Decide every row, for the printed matrix and polynomial or for altered ones."""
    statement = theorem(paper)
    return Outcome(statement, [(row, decide_row(row)) for row in statement.obligations])
