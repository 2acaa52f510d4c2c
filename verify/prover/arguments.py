"""An argument as the steps of a certificate: each line with the proof that its reason describes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cached_property
from types import MappingProxyType
from typing import Any

from verify.language import argument
from verify.language.argument import Argument, Chapter, Defined, Line, Opened, Reason
from verify.language.fold import negation
from verify.language.statement import (
    PROVED,
    REFUTED,
    UNDECIDED,
    Constant,
    Context,
    Obligation,
    Statement,
)
from verify.language.terms import Claim, Term, names_of
from verify.prover import rules
from verify.prover.budget import WorkBudget
from verify.prover.outcome import Decision, Enclosure, Outcome
from verify.prover.proof import LemmaStep, ObligationStep, Premise, Proof, every
from verify.prover.session import ZERO, Session

TYPE_CHECKING = False
if TYPE_CHECKING:
    from verify.prover.ground import Ground

#: Work for one sum from names; half of those of the paper take 20 000 units.
NAMED_WORK = 20_000_000
NO_SUM = (
    "no sum of products of the facts that it names was found; name more facts, or write the "
    "products"
)
NO_FACTS = "it names no facts; write by = with those from which it follows"
NOTHING: Mapping[str, Proof] = MappingProxyType({})
#: Enough for the exact values of the rational numbers at the point of the parameters.
POINT_BITS = 512
NUMBER_BITS = 64
#: Enough for both where numbers have names: some of their differences are as small as 10^-25.
CONSTANT_BITS = 256


def write_down(
    written: Argument, at_hand: Mapping[str, Proof] = NOTHING, budget: WorkBudget | None = None
) -> Outcome:
    """An argument as the steps of a certificate; whether they prove it the checker decides.

    A row for which no sum is found from the facts that it names is left undecided, and so is each
    row that rests on it.

    Args:
        written: the statement, with its lines.
        at_hand: proofs of lines by their names, which are taken where they use named facts only.
        budget: the work that finding one sum may be.
    """
    writing = Writing(written.statement, at_hand, budget)
    enclosures = writing.define(written.statement)
    for chapter in written.chapters:
        writing.chapter(chapter)
    steps = tuple(writing.session.steps)
    return Outcome(written.statement, writing.decisions, steps, enclosures)


def proofs_in(outcome: Outcome) -> dict[str, Proof]:
    """The proofs of lemmas and rows in the steps of a certificate, by their names."""
    kinds = (LemmaStep, ObligationStep)
    return {step.name: step.proof for step in outcome.steps if isinstance(step, kinds)}


class Writing:
    """The steps so far, and the decisions on obligations."""

    def __init__(
        self,
        statement: Statement,
        at_hand: Mapping[str, Proof] = NOTHING,
        budget: WorkBudget | None = None,
    ) -> None:
        self.session, self.at_hand = Session(), at_hand
        self.budget = budget or WorkBudget(NAMED_WORK)
        self.rows = {row.name: row for row in statement.obligations}
        self.constants = {
            constant.name: constant
            for context in statement.contexts
            for constant in context.constants
        }
        self.givens = {c.name: [g.claim for g in c.givens] for c in statement.contexts}
        self.has_numbers = bool(statement.constants)
        bits = (CONSTANT_BITS, CONSTANT_BITS) if self.has_numbers else (POINT_BITS, NUMBER_BITS)
        self.point_bits, self.number_bits = bits
        self.decisions: dict[str, Decision] = {}
        self.missing: dict[str, str] = {}  # why a line is not shown

    @cached_property
    def ground(self) -> Ground:
        """What decides rows without variables."""
        from verify.prover.ground import Ground  # flint is loaded only here

        return Ground(self.session)

    def define(self, statement: Statement) -> dict[str, Enclosure]:
        """Define parameters and constants that are numbers; an enclosure of each."""
        if not self.has_numbers:
            return {}
        given = [
            Constant(name, name, name, "", term) for name, term in statement.parameters.items()
        ]
        constants = (*given, *statement.constants)
        for constant in constants:
            self.ground.define(constant)
        definitions = self.ground.definitions
        found = {c.name: self.ground.enclose(definitions[c.name]) for c in constants}
        return {name: ends for name, ends in found.items() if ends is not None}

    def chapter(self, chapter: Chapter) -> None:
        """Take the items of a chapter, in order."""
        for item in chapter.items:
            if isinstance(item, Line):
                self.line(item, chapter.context)
            elif isinstance(item, Opened):
                self.opened(item.context, item.premises)
            elif isinstance(item, Defined):
                self.defined(self.constants[item.name], chapter.context)

    def opened(self, context: Context, premises: tuple[str, ...] | None) -> None:
        """Open a context at its point."""
        numeric = [self.premise(given.claim) for given in context.givens]
        if not self.has_numbers:
            numeric = [rules.Interval(self.point_bits) for _ in context.givens]
        self.session.open(context, numeric if premises is None else premises)

    def defined(self, constant: Constant, context: str | None) -> None:
        """Define a constant of a context."""
        self.session.constant(constant, rules.Define(), context)

    def line(self, line: Line, context: str | None) -> None:
        """Write down a row, or a lemma."""
        row: Obligation | None = self.rows.get(line.name)
        if row is not None and isinstance(line.reason, argument.ByWitness):
            self.refuted(row, line.reason.at)
            return
        if row is not None and isinstance(line.reason, argument.ToBeFound) and _is_ground(line):
            self.decisions[row.name] = self.ground.decide(row)
            return
        proof = self.proof(line, context)
        if proof is None:
            if row is not None:
                self.decisions[row.name] = Decision(UNDECIDED, reason=self.missing[line.name])
        elif row is not None and isinstance(line.reason, argument.ByNegation):
            self.session.prove_row(row, proof, holds=False)
            self.decisions[row.name] = Decision(REFUTED, proof)
        elif row is not None:
            self.decide(row, proof)
        elif isinstance(line.claim, Claim):
            self.session.lemma(line.claim, proof, context, line.name)

    def proof(self, line: Line, context: str | None) -> Proof | None:
        """The proof of a line; None if it rests on what is not shown, or if no sum is found."""
        unknown = next((name for name in facts_of(line.reason) if name in self.missing), None)
        if unknown is not None:
            self.missing[line.name] = f"it rests on {unknown}, which is not shown"
            return None
        if isinstance(line.reason, argument.ToBeFound):
            self.missing[line.name] = NO_FACTS
            return None
        if not _names_only(line.reason):
            return proof_of(line.reason, self.number_bits)
        at_hand = self.at_hand.get(line.name)
        found = at_hand if _fits(at_hand, line.reason) else None
        if found is None and isinstance(line.claim, Claim):
            found = self.searched(line.claim, line.reason, context)
        if found is None:
            self.missing[line.name] = NO_SUM
        return found

    def searched(self, claim: Claim, reason: Reason, context: str | None) -> Proof | None:
        """The proof that a reason describes, with the sums that it leaves to be found."""
        match reason:
            case argument.ByNames():
                return self.found(claim, reason, context)
            case argument.ByNegation():
                false = negation(claim)
                return None if false is None else self.searched(false, reason.reason, context)
            case argument.ByLeast():
                claims = self._for_entries(claim, reason)
                pairs = zip(claims, reason.branches, strict=True)
                branches = every(self.searched(c, branch, context) for c, branch in pairs)
                return branches and rules.Least(reason.side, branches, reason.equation)
        return proof_of(reason)

    def _for_entries(self, claim: Claim, reason: argument.ByLeast) -> list[Claim]:
        """The claim with each entry of its minimum or maximum in place of that."""
        left = reason.side == "lhs"
        extremum = claim.lhs if left else claim.rhs
        if reason.equation is not None:
            extremum = self.session.claims[reason.equation].rhs
        return [
            Claim(claim.relation, entry if left else claim.lhs, claim.rhs if left else entry)
            for entry in extremum.children
        ]

    def found(
        self, claim: Claim, reason: argument.ByNames, context: str | None
    ) -> rules.Sum | None:
        """A sum of products of the facts that are named, if one is found."""
        from verify.prover.search.named import Named, by_names  # flint is loaded only here

        claims = {name: self.session.claims[name] for name in facts_of(reason)}
        squares = tuple(fact for fact in reason.facts if not isinstance(fact, str))

        def is_negative(term: Term) -> bool:
            above, below = Claim("<", ZERO, term), Claim("<", ZERO, -term)
            known = self.session.known
            return known(above, context) is None and known(below, context) is not None

        self.budget.refill()
        try:
            return by_names(claim, Named(claims, squares, is_negative), self.budget)
        except ArithmeticError:  # the work is spent, or terms are too long
            return None

    def decide(self, row: Obligation, proof: Proof) -> None:
        """Write down the proof of a row."""
        self.decisions[row.name] = Decision(PROVED, proof)
        self.session.prove_row(row, proof)

    def refuted(self, row: Obligation, at: Mapping[str, Term]) -> None:
        """Write down that a row is false at a point."""
        premises = tuple(map(self.premise, self.givens[row.context or ""]))
        proof = rules.Witness(at, premises, rules.Interval(self.number_bits))
        self.session.prove_row(row, proof, holds=False)
        self.decisions[row.name] = Decision(REFUTED, proof)

    def premise(self, claim: Claim) -> Premise:
        """Why a given holds at a point: equations identically, between rational numbers."""
        return rules.Sum() if claim.relation == "=" else rules.Interval(self.point_bits)


def _names_only(reason: Reason) -> bool:
    """Whether a sum of a reason is to be found from names."""
    match reason:
        case argument.ByNegation():
            return _names_only(reason.reason)
        case argument.ByLeast():
            return any(map(_names_only, reason.branches))
    return isinstance(reason, argument.ByNames)


def _fits(proof: Proof | None, reason: Reason) -> bool:
    """Whether a proof at hand is of the kind of a reason, and uses the facts that it names."""
    match reason, proof:
        case argument.ByNegation(), _:
            return _fits(proof, reason.reason)
        case argument.ByLeast(), rules.Least():
            same = (reason.side, reason.equation) == (proof.side, proof.equation)
            same = same and len(reason.branches) == len(proof.branches)
            return same and all(map(_fits, proof.branches, reason.branches))
        case argument.ByNames(), rules.Sum():
            used = argument.BySum(proof.addends, proof.using, proof.equations)
            return {*facts_of(used)} <= {*facts_of(reason)}
        case argument.BySum(), rules.Sum():
            return proof == proof_of(reason)
    return False


def _is_ground(line: Line) -> bool:
    """Whether a line compares numbers without names."""
    claim = line.claim
    return isinstance(claim, Claim) and not any(names_of(claim.lhs, claim.rhs))


def facts_of(reason: Reason) -> Iterator[str]:
    """The names of the facts that a reason uses."""
    match reason:
        case argument.BySum():
            yield from (name for value in reason.addends for name in _facts_in(value))
            yield from (*reason.using, *(name for name, _ in reason.equations))
        case argument.ByNames():
            yield from (fact for fact in reason.facts if isinstance(fact, str))
        case argument.ByNegation():
            yield from facts_of(reason.reason)
        case argument.ByCases():
            yield from (name for branch in reason.branches for name in facts_of(branch))
        case argument.ByLeast():
            yield from (name for branch in reason.branches for name in facts_of(branch))
            yield from [reason.equation] if reason.equation else []
        case argument.ByEntry():
            yield from [reason.equation] if reason.equation else []
        case argument.ByInstance():
            yield from (reason.fact, *reason.givens)
        case argument.ByApplying():
            yield from reason.givens
        case argument.ByInduction():
            yield from (*reason.start, *reason.next)


def _facts_in(value: object) -> Iterator[str]:
    if isinstance(value, str):
        if value != "goal" and not value[0].isdigit():
            yield value
    elif isinstance(value, tuple) and value[0] in ("add", "mul"):
        yield from (name for part in value[1:] for name in _facts_in(part))
    elif isinstance(value, tuple) and value[0] == "pow":
        yield from _facts_in(value[1])


#: The rules that take just what a reason has.
_SAME: dict[Any, Any] = {
    argument.BySum: rules.Sum,
    argument.ByInstance: rules.Instance,
    argument.ByApplying: rules.Applying,
    argument.ByRoot: rules.Root,
    argument.ByInduction: rules.Induction,
}


def proof_of(reason: Reason, bits: int = NUMBER_BITS) -> Proof:
    """The proof by the rule of the same name; intervals have so many bits."""
    match reason:
        case argument.ByLeast():
            branches = tuple(map(proof_of, reason.branches))
            return rules.Least(reason.side, branches, reason.equation)
        case argument.ByNegation():
            return proof_of(reason.reason)
        case argument.ByCases():
            return rules.Cases(reason.of, tuple(map(proof_of, reason.branches)))
        case argument.ByEntry():
            return rules.Entry(reason.side, reason.equation)
        case argument.ByInterval():
            return rules.Interval(bits)
        case argument.ToBeFound() | argument.ByWitness() | argument.ByNames():
            raise TypeError("this proof has to be found")
    found: Proof = _SAME[type(reason)](*reason)
    return found
