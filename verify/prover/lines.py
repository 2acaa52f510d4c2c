"""The lines of a page, decided one by one: by what a line names, or else by the search.

What a line describes may be no proof. So the checker is asked about each as it is written down, and
a line that it refuses is left out, with the reason.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence

from verify.language.argument import ByNegation, ByWitness, Chapter, Line, ToBeFound
from verify.language.fold import negation
from verify.language.statement import (
    NEEDED,
    PROVED,
    REFUTED,
    UNDECIDED,
    Constant,
    Context,
    Obligation,
    Statement,
)
from verify.language.terms import Claim, Term
from verify.prover.arguments import Writing, facts_of
from verify.prover.budget import WorkBudget
from verify.prover.ground import Ground
from verify.prover.hint import Hint
from verify.prover.outcome import Decision, Outcome
from verify.prover.proof import LemmaStep, ObligationStep, Proof, Step
from verify.prover.prove import (
    NO_HINTS,
    Price,
    constants_defined,
    decide_row,
    enclosures_of,
    make_known,
    names_about,
    note,
    opened,
    unused_prefix,
)
from verify.prover.rows_in_contexts import RowsInContexts
from verify.prover.session import Session
from verify.prover.techniques import find
from verify.prover.universal import Universal

HOLDS = 'it holds, although the page says verdict = "refuted"; leave that out'
NOT_REFUTED = "its negation was not shown"


def prove_lines(
    statement: Statement,
    chapters: Iterable[Chapter],
    budget: WorkBudget,
    price: Price,
    refusal: Price,
    hints: Mapping[str, Hint] = NO_HINTS,
    cited: Iterable[tuple[str, Statement]] = (),
) -> Outcome:
    """Decide every row of a page with chapters; what is not found is left undecided.

    Args:
        statement: what is claimed; lines that are no rows of it are lemmas.
        chapters: the lines, with the places where contexts open.
        budget: how much work each line may be.
        price: asked before anything is claimed that the search found.
        refusal: why the checker does not accept steps that a line describes; or nothing.
        hints: where to look for the proofs of some rows, by their names.
        cited: statements with their proved rows, and what their names begin with here.
    """
    chapters = tuple(chapters)
    names = [line.name for line in _lines(chapters)]
    universal = Universal(Ground(Session(unused_prefix(statement, names))), budget, find)
    for prefix, other in cited:
        make_known(prefix, other, universal)
    deciding = Deciding(statement, chapters, universal, price, refusal, hints)
    for chapter in chapters:
        deciding.chapter(chapter)
    return deciding.outcome()


def _lines(chapters: Iterable[Chapter]) -> Iterator[Line]:
    return (item for chapter in chapters for item in chapter.items if isinstance(item, Line))


class Deciding(Writing):
    """The steps so far; whatever the checker refuses, or nobody finds, is left out."""

    def __init__(
        self,
        statement: Statement,
        chapters: tuple[Chapter, ...],
        universal: Universal,
        price: Price,
        refusal: Price,
        hints: Mapping[str, Hint],
    ) -> None:
        super().__init__(statement, budget=universal.budget)
        self.session, self.ground = universal.session, universal.ground
        self.statement, self.universal, self.hints = statement, universal, hints
        self.price, self.refusal = price, refusal
        self.contexts = {context.name: context for context in statement.contexts}
        self.left = {line.name for line in _lines(chapters)} | self.rows.keys()
        self.unmade = constants_defined(statement, universal)
        self.spent = price(None, "", self.session.steps)

    def outcome(self) -> Outcome:
        """The decisions on all rows, with those that no line states."""
        for context in self.contexts.values():
            if context.name not in {*self.universal.contexts, *self.unmade}:
                self.opened(context, None)
                for constant in context.constants:
                    self.defined(constant, context.name)
        for row in self.statement.obligations:
            if row.name not in self.decisions:
                self.line(Line(row.name, row.claim, ToBeFound()), row.context)
        enclosures = {} if self.spent else enclosures_of(self.statement, self.ground, self.unmade)
        lemmas = (
            f"the lemma {name} is not shown: {why}"
            for name, why in self.missing.items()
            if name not in self.rows
        )
        spent = next(iter((*filter(None, [self.spent]), *self.unmade.values(), *lemmas)), "")
        steps = tuple(self.session.steps)
        return Outcome(self.statement, self.decisions, steps, enclosures, spent)

    # --- contexts and their constants -----------------------------------------------------------

    def opened(self, context: Context, premises: tuple[str, ...] | None) -> None:
        """Open a context at its point: by what it names, or by what is found."""
        context = self.contexts[context.name]  # in which givens may be completed
        unknown = [name for name in premises or () if name not in self.session.claims]
        if unknown:
            self.unmade[context.name] = _rests_on(context.name, unknown[0])
            return

        def enter(universal: Universal, context: Context) -> bool:
            return universal.enter(context, premises)

        self._made(context.name, lambda: opened(context, self.universal, self.unmade, enter))

    def defined(self, constant: Constant, context: str | None) -> None:
        """Define a constant of a context, if it is seen to have a value."""

        def failed() -> str:
            found = self.universal.define(constant, context or "")
            return "" if found else f"{constant.name} was not seen to have a value"

        def define() -> None:
            self.budget.refill()
            note(self.unmade, constant.name, [context or ""], failed, self.budget)

        self._made(constant.name, define)

    def _made(self, name: str, make: Callable[[], None]) -> None:
        """Afterwards something is made, as the checker accepts it, or it is known why not."""
        undo, first = self.universal.mark(), len(self.session.steps)
        make()
        if name not in self.unmade:
            reason = self.refusal(None, "", self.session.steps[first:])
            if not reason:
                return
            self.unmade[name] = f"{name}: {reason}"
        undo()  # the checker has not read these steps
        self.universal.contexts.pop(name, None)

    # --- lines ----------------------------------------------------------------------------------

    def line(self, line: Line, context: str | None) -> None:
        """Decide a row, or a lemma."""
        row = self.rows.get(line.name)
        if row is None and _shows_nothing(line):
            return
        asked = row or Obligation(line.name, "", "", NEEDED, "", line.claim, context=context)
        self.budget.begin(line.name, max(1, len(self.left)))
        self.left.discard(line.name)
        reason = self._missing(asked, line)
        found = _undecided(reason) if reason else self._decided(asked, line)
        if row is not None:
            self.decisions[line.name] = found
        if found.claimed == PROVED:
            self.universal.rows.add(line.name)
        else:
            self.missing[line.name] = found.reason or "it is false"

    def _missing(self, row: Obligation, line: Line | None = None) -> str:
        """What a row is about, or what its line names, that is not there."""
        gone = next((self.unmade[name] for name in names_about(row) if name in self.unmade), "")
        names = () if line is None else facts_of(line.reason)
        facts = (n for n in names if n[0] != "@" and n not in self.session.claims)
        unknown = next(facts, "")
        return self.spent or gone or (unknown and _rests_on("it", unknown))

    def _decided(self, row: Obligation, line: Line) -> Decision:
        """What is claimed of a line, whose steps the checker accepts."""
        undo, first = self.universal.mark(), len(self.session.steps)
        reason = line.reason
        is_negated = isinstance(reason, ByNegation)
        if isinstance(reason.reason if isinstance(reason, ByNegation) else reason, ToBeFound):
            found = self._searched(row)
            if is_negated and found.claimed == PROVED:
                found = _undecided(HOLDS)
        else:
            found = self._written(row, line)
            steps = self.session.steps[first:]
            if found.claimed != UNDECIDED and (
                refused := self.refusal(self._row(row), found.claimed, steps)
            ):
                found = _undecided(f"what its line says is not accepted: {refused}")
        if found.claimed == UNDECIDED:
            undo()
        return found

    def _row(self, row: Obligation) -> Obligation | None:
        """The row, if the statement has it; none for a lemma."""
        return self.rows.get(row.name)

    def _searched(self, row: Obligation) -> Decision:
        """The decision on a row, or a lemma, that the search finds."""
        if self._row(row) is not None:
            hint = self.hints.get(row.name, Hint())
            return decide_row(row, self.universal, self.price, hint)

        def price(_row: Obligation | None, claimed: str, steps: Sequence[Step]) -> str:
            return self.price(None, PROVED, _as_lemma(row, steps)) if claimed == PROVED else ""

        found = decide_row(row, self.universal, price, Hint())
        if found.claimed == REFUTED:
            return _undecided("it is false")
        steps = self.session.steps
        steps[:] = _as_lemma(row, steps)
        return found

    def _written(self, row: Obligation, line: Line) -> Decision:
        """The decision on a row, or a lemma, that its line describes."""
        try:
            self.budget.refill()
            with self.budget.alarm():
                return self._as_described(row, line)
        except (ArithmeticError, RecursionError) as error:
            return _undecided(f"the search failed: {type(error).__name__}: {error!s:.200}")

    def _as_described(self, row: Obligation, line: Line) -> Decision:
        claim, reason, place = row.claim, line.reason, row.context
        holds = not isinstance(reason, ByWitness | ByNegation)
        if isinstance(claim, Claim):
            self.universal.clears((claim.lhs, claim.rhs), place)
        if isinstance(reason, ByWitness):
            proof = self._witness(row, reason.at)
        elif isinstance(reason, ByNegation):
            other = negation(claim) if isinstance(claim, Claim) else None
            negative = None if other is None else Line(line.name, other, reason.reason)
            proof = None if negative is None else self.proof(negative, place)
        else:
            proof = self.proof(line, place)
        if proof is None:
            return _undecided(self.missing.pop(line.name, NOT_REFUTED))
        if self._row(row) is not None:
            self.session.prove_row(row, proof, holds=holds)
        elif isinstance(claim, Claim):
            self.session.lemma(claim, proof, place, row.name)
        return Decision(PROVED if holds else REFUTED, proof)

    def _witness(self, row: Obligation, at: Mapping[str, Term]) -> Proof | None:
        """A proof that a row is false at these values."""
        if not isinstance(row.claim, Claim) or row.context is None:
            return None
        goal = self.universal.goal(row.claim, row.context)
        return RowsInContexts(self.universal).witness(goal, self.contexts[row.context], at)


def _shows_nothing(line: Line) -> bool:
    """Whether a line that is no row asked for is none that others may use."""
    is_false = isinstance(line.reason, ByWitness | ByNegation)
    return is_false or not isinstance(line.claim, Claim)


def _as_lemma(row: Obligation, steps: Sequence[Step]) -> list[Step]:
    """The steps, with a lemma in place of the row of this name."""

    def turned(step: Step) -> Step:
        if not isinstance(step, ObligationStep) or step.name != row.name:
            return step
        if not isinstance(row.claim, Claim):
            raise TypeError(f"{row.name} is no comparison")
        return LemmaStep(row.name, row.context, row.claim, step.proof)

    return [turned(step) for step in steps]


def _rests_on(what: str, name: str) -> str:
    return f"{what} rests on {name}, which is not shown"


def _undecided(reason: str) -> Decision:
    return Decision(UNDECIDED, reason=reason)
