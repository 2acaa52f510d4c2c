"""What is claimed of a statement's rows, the steps that are to prove it, and who has judged it.

Whoever searches for a proof, or writes one down, makes claims: an outcome in which every verdict is
undecided. A `Judgement` gives a claim its verdict, and holds that claim: an outcome drops one about
another claim. Only judges make judgements: the checker (see `verify.wire.judge`) and the decision
procedures that are named with the verdict.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from fractions import Fraction
from operator import attrgetter

from verify.language.record import TYPE_CHECKING, Any, Record
from verify.language.statement import (
    NEEDED,
    PRINTED,
    PROVED,
    REFUTED,
    UNDECIDED,
    Always,
    Applies,
    Assumption,
    Obligation,
    Statement,
)
from verify.language.terms import Claim, Term
from verify.prover.proof import Proof, Step
from verify.prover.rules import rule_of

Ends = tuple[Fraction, Fraction]

#: The judge of written proofs: see `verify.wire.judge`.
CHECKER = "the checker"

EXIT_CODES = {PROVED: 0, REFUTED: 1, UNDECIDED: 3}


class Enclosure(Record):
    """Numbers that enclose one or two values, as the checker evaluates them with ``bits`` bits."""

    bits: int
    ends: tuple[Ends, ...]


class Judgement(Record):
    """A verdict, the judge that gives it, and the claim about which it is given.

    ``names`` has what the names in the claim stood for, as in `names_in`.
    """

    verdict: str
    by: str
    claim: Claim | Applies | Always
    context: str | None
    names: Mapping[str, Any]


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
        """The verdict of the judge; undecided before there is one."""
        return UNDECIDED if self.judged is None else self.judged.verdict

    @property
    def judge(self) -> str | None:
        """The name of the judge, or None before there is a verdict."""
        return None if self.judged is None else self.judged.by

    @property
    def bits(self) -> int:
        """The precision with which the proof evaluates; 0 for a proof by algebra."""
        return int(getattr(self.proof, "bits", 0))

    @property
    def method(self) -> str:
        """The rule that shows it, or nothing."""
        return "" if self.proof is None else rule_of(self.proof)

    @property
    def witness(self) -> Mapping[str, Term]:
        """Values at which a refuted claim about all values is false."""
        return getattr(self.proof, "at", {}) if self.method == "witness" else {}


def names_in(statement: Statement) -> dict[str, Any]:
    """What the names in a statement stand for: terms, contexts, and the files that it cites."""
    names: dict[str, Any] = dict(statement.parameters)
    names.update((constant.name, constant.term) for constant in statement.constants)
    names.update((context.name, context) for context in statement.contexts)
    names.update((cite.name, cite.content) for cite in statement.cites)
    return names


def _about(statement: Statement, decisions: Mapping[str, Decision]) -> Mapping[str, Decision]:
    """The decisions, without the judgements of other claims than those of the statement's rows."""
    rows, now = {row.name: row for row in statement.obligations}, names_in(statement)
    same: dict[int, bool] = {}  # by the tables of names that judges share

    def is_about(judged: Judgement, row: Obligation | None) -> bool:
        names = judged.names
        if id(names) not in same:
            same[id(names)] = all(names.get(name, what) == what for name, what in now.items())
        return (
            row is not None
            and (judged.claim is row.claim or judged.claim == row.claim)
            and judged.context == row.context
            and same[id(names)]
        )

    others = {
        name: found._replace(judged=None)
        for name, found in decisions.items()
        if found.judged is not None and not is_about(found.judged, rows.get(name))
    }
    return {**decisions, **others} if others else decisions


class Outcome(Record):
    """A statement in which every obligation has a decision.

    What was judged of another claim than the row's is judged by nobody. ``steps`` are those of the
    certificate, in order; ``enclosures`` has parameters and constants without variables, for
    readers; ``spent`` says what precision or work did not suffice for.
    """

    statement: Statement
    decisions: Mapping[str, Decision]
    steps: tuple[Step, ...]
    enclosures: Mapping[str, Enclosure]
    spent: str = ""

    @property
    def rows(self) -> list[tuple[Obligation, Decision]]:
        """Each obligation with its decision, in the statement's order."""
        rows = self.statement.obligations
        found = map(self.decisions.__getitem__, map(attrgetter("name"), rows))
        return [*zip(rows, found, strict=True)]

    def of_group(self, *groups: str) -> list[tuple[Obligation, Decision]]:
        """The rows of some groups."""
        return [pair for pair in self.rows if pair[0].group in groups]

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
        """The same claims without the judge's verdicts."""
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


if not TYPE_CHECKING:  # which takes a record for a NamedTuple, and those may not have this

    def _tied(cls, *values, **named):
        """An outcome in which each judgement is about the row of its name."""
        statement, decisions, *others = Record.__new__(cls, *values, **named)
        return Record.__new__(cls, statement, _about(statement, decisions), *others)

    Outcome.__new__ = _tied


def conjunction(decisions: Iterable[Decision]) -> str:
    """``refuted`` if one is, else ``undecided`` if one is (or there is none), else ``proved``."""
    return _worst(decision.verdict for decision in decisions)


def _worst(verdicts: Iterable[str]) -> str:
    found = {*verdicts}
    return next((v for v in (REFUTED, UNDECIDED, PROVED) if v in found), UNDECIDED)
