"""What was found: a statement with its decided rows, and the steps that prove them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from fractions import Fraction

from verify.language.record import Record
from verify.language.statement import (
    NEEDED,
    PRINTED,
    PROVED,
    REFUTED,
    UNDECIDED,
    Assumption,
    Obligation,
    Statement,
)
from verify.language.terms import Term
from verify.prover.proof import Proof, Step

Ends = tuple[Fraction, Fraction]

EXIT_CODES = {PROVED: 0, REFUTED: 1, UNDECIDED: 3}


class Enclosure(Record):
    """Numbers that enclose one or two values, as the checker evaluates them with ``bits`` bits."""

    bits: int
    ends: tuple[Ends, ...]


class Decision(Record):
    """A verdict with its evidence; a refuted row has a proof of its negation.

    ``sides`` encloses both sides of a claim without variables.
    """

    verdict: str
    proof: Proof | None = None
    sides: Enclosure | None = None

    @property
    def bits(self) -> int:
        """The precision with which the proof evaluates; 0 for a proof by algebra."""
        return int(getattr(self.proof, "bits", 0))

    @property
    def method(self) -> str:
        """The rule that shows it, or nothing."""
        from verify.prover.rules.table import RULES  # loaded only where it is used

        return "" if self.proof is None else RULES[type(self.proof)][0]

    @property
    def witness(self) -> Mapping[str, Term]:
        """Values at which a refuted claim about all values is false."""
        return getattr(self.proof, "at", {}) if self.method == "witness" else {}


class Outcome(Record):
    """A statement in which every obligation has a decision.

    ``steps`` are those of the certificate, in order; ``enclosures`` has each parameter and each
    constant without variables; ``spent`` says what precision or work did not suffice for.
    """

    statement: Statement
    decisions: Mapping[str, Decision]
    steps: tuple[Step, ...]
    enclosures: Mapping[str, Enclosure]
    spent: str = ""

    @property
    def rows(self) -> list[tuple[Obligation, Decision]]:
        """Each obligation with its decision, in the statement's order."""
        return [(row, self.decisions[row.name]) for row in self.statement.obligations]

    def of_group(self, *groups: str) -> list[tuple[Obligation, Decision]]:
        """The rows of some groups."""
        return [(row, found) for row, found in self.rows if row.group in groups]

    @property
    def verdict(self) -> str:
        """The verdict on the needed rows; without any, or with something missing, undecided."""
        found = conjunction(decision for row, decision in self.rows if row.role == NEEDED)
        return UNDECIDED if self.spent and found == PROVED else found

    @property
    def exit_code(self) -> int:
        """0 proved, 1 refuted, 3 undecided."""
        return EXIT_CODES[self.verdict]

    @property
    def own_assumptions(self) -> tuple[Assumption, ...]:
        """The assumptions that needed rows, or standing givens, use."""
        used = self._used_by(NEEDED)
        used |= {given.assumption or "" for c in self.statement.contexts for given in c.givens}
        return tuple(a for a in self.statement.assumptions if a.name in used)

    @property
    def assumptions(self) -> tuple[Assumption, ...]:
        """What the verdict takes on trust, here and in what is cited."""
        cited = (assumption for cite in self.statement.cites for assumption in cite.trusted)
        return tuple(dict.fromkeys((*self.own_assumptions, *cited)))

    @property
    def printed_assumptions(self) -> tuple[Assumption, ...]:
        """The other assumptions: those that only printed rows use."""
        used, others = self._used_by(PRINTED), self.own_assumptions
        return tuple(a for a in self.statement.assumptions if a.name in used and a not in others)

    def _used_by(self, role: str) -> set[str]:
        rows = self.statement.obligations
        return {name for row in rows if row.role == role for name in row.uses}


def conjunction(decisions: Iterable[Decision]) -> str:
    """``refuted`` if one is, else ``undecided`` if one is (or there is none), else ``proved``."""
    verdicts = {decision.verdict for decision in decisions}
    for verdict in (REFUTED, UNDECIDED):
        if verdict in verdicts:
            return verdict
    return PROVED if verdicts else UNDECIDED
