"""The rows of contexts, decided: claims, applications of a context, inductions."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from verify.language.fold import MEANINGS, negation
from verify.language.statement import (
    PROVED,
    REFUTED,
    UNDECIDED,
    Always,
    Applies,
    Context,
    Obligation,
)
from verify.language.terms import Claim, Term, as_term, substitute_claim
from verify.language.typeset import Typesetter
from verify.prover.goal import Goal
from verify.prover.outcome import Decision
from verify.prover.points import failure_test, refuting_point
from verify.prover.proof import Proof
from verify.prover.rules import Applying, Induction, Witness
from verify.prover.search.question import Question, refuting_minimum
from verify.prover.universal import Universal, with_constants


class RowsInContexts:
    """Decides rows with what is known in their contexts, and writes their proofs down."""

    def __init__(self, universal: Universal) -> None:
        self.known = universal

    def decide(self, row: Obligation) -> Decision:
        """Decide a row of an open context and write its proof down, or leave it undecided."""
        claim = row.claim
        if isinstance(claim, Applies):
            return self._apply(row, claim)
        if isinstance(claim, Always):
            return self._always(row, claim)
        if isinstance(claim, Claim) and self.known.home(claim, row.context) is None:
            return self._numbers(row, claim)
        if not isinstance(claim, Claim) or row.context not in self.known.contexts:
            return Decision(UNDECIDED)
        goal, context = self.known.goal(claim, row.context), self.known.contexts[row.context]
        is_false = self._is_false_at_point(goal, context)
        witness = self._refute(goal, context, there=True) if is_false else None
        proof = None if witness else self.known.prove(goal)
        if proof is None and not is_false:
            witness = self._refute(goal, context, there=False)
        verdict, proof = (PROVED, proof) if witness is None else (REFUTED, witness)
        if proof is None:
            return Decision(UNDECIDED)
        self.known.session.prove_row(row, proof, holds=verdict == PROVED)
        self.known.rows.add(row.name)
        return Decision(verdict, proof)

    def _numbers(self, row: Obligation, claim: Claim) -> Decision:
        """Decide a row without variables that enclosures leave open, such as one with equality."""
        sides = self.known.ground.enclose(claim.lhs, claim.rhs)
        for verdict, wanted in ((PROVED, claim), (REFUTED, negation(claim))):
            if sides is None or wanted is None:
                continue
            proof = self.known.prove(self.known.goal(wanted, None))
            if proof is not None:
                self.known.session.prove_row(row, proof, holds=verdict == PROVED)
                return Decision(verdict, proof, sides)
        return _undecided(f"a side {self.known.ground.no_value}" if sides is None else "")

    def _apply(self, row: Obligation, claim: Applies) -> Decision:
        """Show that the givens of another context hold at the values of a claim."""
        context = self.known.contexts.get(claim.context)
        reached = row.context is None or row.context in self.known.contexts
        if (
            context is None
            or not reached
            or context.parent not in self.known.session.chain(row.context)
        ):
            return _undecided(f"the context {claim.context} is not open here")
        premises = self.known.premises(context, claim.at, row.context)
        if premises is None:
            return _undecided(self._unshown(claim.context, "at these values", row.context))
        proof = Applying(premises)
        self.known.session.prove_row(row, proof)
        return Decision(PROVED, proof)

    def _always(self, row: Obligation, claim: Always) -> Decision:
        """Show that the carried givens hold at the start, and at the next state."""
        context = self.known.contexts.get(claim.context)
        if context is None or context.parent != row.context:
            why = f"the context {claim.context} is not one inside that of the row"
            place = context and (context.parent or "no context, under [rows]")
            return _undecided(f"{why}; ask it in {place}" if place else why)
        plain = next((given.name for given in context.givens if given.kind == "plain"), None)
        if plain is not None:
            return _undecided(f"its given {plain} is neither carried nor standing; make it carried")
        carried = context._replace(givens=tuple(g for g in context.givens if g.kind == "carried"))
        start = self.known.premises(carried, claim.start, row.context)
        following = (
            None if start is None else self.known.premises(carried, claim.next, context.name)
        )
        if start is None or following is None:
            first = start is None
            where, place = (
                ("at the start", row.context) if first else ("at the next state", context.name)
            )
            return _undecided(self._unshown(claim.context, where, place))
        proof = Induction(start, following)
        self.known.session.prove_row(row, proof)
        return Decision(PROVED, proof)

    def _unshown(self, context: str, where: str, place: str | None) -> str:
        """Which given was not shown, and the claim to ask before."""
        given = self.known.failed
        if given is None:
            return f"the values for {context} were not seen to be defined {where}"
        inside = "" if place is None else f" in {place}"
        claim = Typesetter({}).claim(given.claim)
        return (
            f"its given {given.name} was not shown {where}; ask it as a row before{inside}: {claim}"
        )

    def _refute(self, goal: Goal, context: Context, *, there: bool) -> Witness | None:
        """Values for the variables at which the claim is false.

        ``there`` says whether that is soon seen at the context's point.
        """
        for at in self._false_points(goal, context, there=there):
            undo = self.known.mark()
            found = self.witness(goal, context, at)
            if found is not None:
                return found
            undo()
        return None

    def _false_points(
        self, goal: Goal, context: Context, *, there: bool
    ) -> Iterator[Mapping[str, Term]]:
        """Values at which the claim may be false, those that are found soon first."""
        simple = refuting_point(goal, self.known.enclosed)
        if simple is None and there:
            yield context.point
        for point in (simple, None if simple else refuting_minimum(goal, self.known)):
            if point is not None:
                found = {name: as_term(value) for name, value in point.items()}
                own = {name: found[name] for name in found if name in context.point}
                yield {**context.point, **own}
        yield context.point
        from verify.prover.search.witnesses import false_points  # loaded only where it is used

        yield from false_points(Question(goal, self.known), context)

    def _is_false_at_point(self, goal: Goal, context: Context) -> bool:
        """Whether the claim is soon seen to be false at the point of its context."""
        if goal.claim.relation not in MEANINGS:
            return False
        values = [context.point.get(name) for name in goal.variables]
        numbers = [term.value for term in values if term is not None and term.op == "rational"]
        if len(numbers) == len(values):
            return failure_test(goal, self.known.enclosed)(numbers)
        there = substitute_claim(goal.claim, with_constants(context, context.point))
        ground = self.known.ground
        is_number = self.known.home(there, context.parent) is None
        return is_number and ground.compare(there, ground.start_bits) == REFUTED

    def witness(self, goal: Goal, context: Context, at: Mapping[str, Term]) -> Witness | None:
        """A proof that the givens hold at some values, and the claim does not."""
        premises = self.known.premises(context, at, context.parent)
        if premises is None:
            return None
        false = substitute_claim(goal.claim, with_constants(context, at))
        negative = self._negation(false, context.parent)
        return None if negative is None else Witness(at, premises, negative)

    def _negation(self, claim: Claim, context: str | None) -> Proof | None:
        """A proof that a claim is false, for all values in a context."""
        if self.known.home(claim, context) is None:
            verdict, proof = self.known.ground.prove(claim)
            if verdict != UNDECIDED:
                return proof if verdict == REFUTED else None
        other = negation(claim)
        return None if other is None else self.known.prove(self.known.goal(other, context))


def _undecided(reason: str) -> Decision:
    return Decision(UNDECIDED, reason=reason)
