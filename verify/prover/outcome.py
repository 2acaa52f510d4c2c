"""What is claimed of a statement's rows, the steps that are to prove it, and who has judged it.

Whoever searches for a proof, or writes one down, makes claims: an outcome in which every verdict is
undecided. A `Judgement` gives a claim its verdict. Only judges make judgements: the checker (see
`verify.wire.judge`) and the decision procedures that are named with the verdict.
"""

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
from verify.prover.rules import RULES

Ends = tuple[Fraction, Fraction]

EXIT_CODES = {PROVED: 0, REFUTED: 1, UNDECIDED: 3}


class Enclosure(Record):
    """Numbers that enclose one or two values, as the checker evaluates them with ``bits`` bits."""

    bits: int
    ends: tuple[Ends, ...]


class Judgement(Record):
    """A verdict, and the judge that gives it."""

    verdict: str
    by: str


class Decision(Record):
    """What is claimed of a row, with its evidence; a refuted row has a proof of its negation.

    ``sides`` encloses both sides of a claim without variables. A row that no judge has judged is
    undecided, whatever is claimed of it; ``reason`` says why nothing is claimed, where that is
    known.
    """

    claimed: str
    proof: Proof | None = None
    sides: Enclosure | None = None
    judged: Judgement | None = None
    reason: str = ""

    @property
    def verdict(self) -> str:
        """What the judge says, or that nobody has said anything."""
        return UNDECIDED if self.judged is None else self.judged.verdict

    @property
    def judge(self) -> str | None:
        """Who gives the verdict."""
        return None if self.judged is None else self.judged.by

    @property
    def bits(self) -> int:
        """The precision with which the proof evaluates; 0 for a proof by algebra."""
        return int(getattr(self.proof, "bits", 0))

    @property
    def method(self) -> str:
        """The rule that shows it, or nothing."""
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
    def claimed(self) -> str:
        """What the verdict is if all claims are right."""
        needed = [decision for row, decision in self.rows if row.role == NEEDED]
        found = _worst(decision.claimed for decision in needed)
        return UNDECIDED if self.spent and found == PROVED else found

    @property
    def draft(self) -> Outcome:
        """The same claims, judged by nobody."""
        claims = {name: found._replace(judged=None) for name, found in self.decisions.items()}
        return self._replace(decisions=claims)

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
    return _worst(decision.verdict for decision in decisions)


def _worst(verdicts: Iterable[str]) -> str:
    found = {*verdicts}
    return next((v for v in (REFUTED, UNDECIDED, PROVED) if v in found), UNDECIDED)
