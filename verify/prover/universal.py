"""Claims for all values of the variables in scope: identities, signs, enclosures, polynomials.

Nothing here is trusted. What is found is written down as the steps of a certificate.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from itertools import chain
from typing import Any

from verify.language.statement import (
    PROVED,
    REFUTED,
    UNDECIDED,
    Always,
    Applies,
    Constant,
    Context,
    Given,
    Obligation,
)
from verify.language.terms import (
    Claim,
    Term,
    as_term,
    names_of,
    parts_of,
    substitute,
    substitute_claim,
)
from verify.prover import boxes
from verify.prover.bernstein import bernstein
from verify.prover.budget import WorkBudget
from verify.prover.clearing import Clearing, TooLongError
from verify.prover.goal import Bounds, Goal, bounds_of
from verify.prover.ground import Ground
from verify.prover.outcome import Decision
from verify.prover.points import refuting_point
from verify.prover.proof import Proof
from verify.prover.relations import MEANINGS, negation
from verify.prover.rules import (
    Antisymmetry,
    Applying,
    Define,
    Entry,
    Induction,
    Least,
    Root,
    Sum,
    Witness,
)
from verify.prover.search.cosine_bounds import by_cosines
from verify.prover.search.multiple_angles import by_multiple_angles
from verify.prover.search.strategy import Strategy, refuting_minimum
from verify.prover.session import ZERO
from verify.prover.signs import signs

#: With more variables than these a goal is not tried again with those that givens link to its own.
MAX_LINKED = 5


class Universal:
    """Proves claims in contexts, with the facts that are known there.

    Args:
        ground: decides what has no variables; its session takes the steps.
        budget: the work that each row may be.
    """

    def __init__(self, ground: Ground, budget: WorkBudget) -> None:
        self.ground, self.session, self.budget = ground, ground.session, budget
        self.contexts: dict[str, Context] = {}
        self.depth = 0  # of lemmas that lemmas need
        self.rows: set[str] = set()  # that are proved, so that later ones may use them
        self.bounds: dict[str, Bounds] = {}
        self._homes: dict[str, str] = {}
        self._local: dict[str, Term] = {}
        self._clear: set[tuple[str | None, Term]] = set()

    # --- contexts -------------------------------------------------------------------------------

    def open(self, context: Context) -> bool:
        """Show that the givens hold at the context's point; False if that is not found."""
        if context.parent is not None and context.parent not in self.contexts:
            return False
        if not self._are_defined(context):
            return False
        premises = self.premises(context, context.point, context.parent)
        if premises is None:
            return False
        self.contexts[context.name] = context
        self.session.open(context, premises)
        self.bounds |= bounds_of(context)
        self._homes |= {variable.name: context.name for variable in context.variables}
        return all(self.define(constant, context.name) for constant in context.constants)

    def _are_defined(self, context: Context) -> bool:
        """Whether givens before, or facts around, say the sign of what the givens divide by."""
        earlier: set[Claim] = set()
        variables = {variable.name for variable in context.variables}

        def is_known(relation: str, term: Term) -> bool:
            claim = Claim(relation, ZERO, term)
            if claim in earlier or variables & {*names_of(term)}:
                return claim in earlier
            return self.fact(claim, context.parent) is not None

        def is_defined(part: Term) -> bool:
            if part.op == "div":
                divisor = part.children[1]
                if divisor.op == "rational":
                    return bool(divisor.value != 0)
                return is_known("<", divisor) or is_known("<", -divisor)
            if part.op == "sqrt":
                radicand = part.children[0]
                if radicand.op == "rational":
                    return bool(radicand.value >= 0)
                return is_known("<", radicand) or is_known("<=", radicand)
            return True

        for given in context.givens:
            if not all(map(is_defined, parts_of(given.claim.lhs, given.claim.rhs))):
                return False
            earlier.add(given.claim)
        return True

    def define(self, constant: Constant, context: str) -> bool:
        """Add a constant of a context; False if its value is not seen to be defined."""
        if not self.clears((constant.term,), context):
            return False
        self.session.constant(constant, Define(), context)
        self._homes[constant.name] = context
        self._local[constant.name] = constant.term
        return True

    def premises(
        self, context: Context, at: Mapping[str, Term], place: str | None
    ) -> tuple[str, ...] | None:
        """Facts of a place which say that the givens of a context hold at these values."""
        if not self.clears(at.values(), place):
            return None
        values, names = _unfolded(context, at), []
        for given in context.givens:
            name = self.fact(substitute_claim(given.claim, values), place)
            if name is None:
                return None
            names.append(name)
        return tuple(names)

    def goal(self, claim: Claim, context: str | None) -> Goal:
        """The claim with what is known of the names in it."""
        definitions = self._definitions_in(claim)
        names = sorted(names_of(claim.lhs, claim.rhs, *definitions.values()))
        variables = {name: self.bounds[name] for name in names if name in self.bounds}
        constants = (name for name in names if name not in variables and name not in definitions)
        return Goal(claim, context, variables, tuple(constants), definitions)

    def _definitions_in(self, claim: Claim) -> dict[str, Term]:
        """The constants of contexts in a claim, in the order in which they were defined."""
        found = {name for name in names_of(claim.lhs, claim.rhs) if name in self._local}
        for name in reversed(self._local):
            if name in found:
                found |= {other for other in names_of(self._local[name]) if other in self._local}
        return {name: term for name, term in self._local.items() if name in found}

    # --- facts ----------------------------------------------------------------------------------

    def fact(self, claim: Claim, context: str | None) -> str | None:
        """The name of a fact, which is proved now if it is not known; None if that fails."""
        known = self.session.known(claim, context)
        if known is not None:
            return known
        home = self._home(claim, context)
        if home is None:
            return self._ground_fact(claim)
        proof = self.prove(self.goal(claim, home))
        return None if proof is None else self.session.lemma(claim, proof, home)

    def _ground_fact(self, claim: Claim) -> str | None:
        verdict, proof = self.ground.prove(claim)
        return self.session.lemma(claim, proof) if verdict == PROVED and proof else None

    def _home(self, claim: Claim, context: str | None) -> str | None:
        """The outermost context in which the names of a claim are in scope."""
        homes = {self._homes.get(name) for name in names_of(claim.lhs, claim.rhs)}
        return next((place for place in self.session.chain(context) if place in homes), None)

    def clears(self, terms: Iterable[Term], context: str | None) -> bool:
        """Afterwards each divisor and radicand has the fact that it needs; or False."""
        return all(self._clears(term, context) for term in terms)

    def _clears(self, term: Term, context: str | None) -> bool:
        if (context, term) in self._clear:
            return True
        if not self.clears(term.children, context):
            return False
        if term.op == "div" and not self._divisor(term.children[1], context):
            return False
        if term.op == "sqrt" and not self._radicand(term.children[0], context):
            return False
        self._clear.add((context, term))
        return True

    def _divisor(self, term: Term, context: str | None) -> bool:
        if term.op == "rational":
            return term.value != 0
        return any(self.fact(Claim("<", ZERO, t), context) for t in (term, -term))

    def _turned(self, term: Term, context: str | None) -> Term:
        """The same number, with -a/-b for a/b where b is known to be negative.

        The checker clears both to the same quotient, so that a sum for one is one for the other;
        the quotients of the search are those of the latter. Atoms stay as they are.
        """
        if term.op not in ("add", "sub", "mul", "neg", "pow", "div"):
            return term
        children = tuple(self._turned(child, context) for child in term.children)
        if term.op == "div" and self.is_negative(term.children[1], context):
            return -children[0] / -children[1]
        return Term(term.op, *children, *term.args[len(children) :])

    def is_negative(self, term: Term, context: str | None) -> bool:
        """Whether this is how a divisor is cleared."""
        known = (self.session.known(Claim("<", ZERO, t), context) for t in (term, -term))
        return term.op != "rational" and [*map(bool, known)] == [False, True]

    def _radicand(self, term: Term, context: str | None) -> bool:
        if term.op == "rational":
            return term.value >= 0
        return any(self.fact(Claim(relation, ZERO, term), context) for relation in ("<", "<="))

    # --- proofs ---------------------------------------------------------------------------------

    def prove(self, goal: Goal) -> Proof | None:
        """A proof of the first kind that is found; the lemmas that it needs are written down.

        Raises:
            ValueError: for an unknown relation.
        """
        if goal.claim.relation not in MEANINGS:
            raise ValueError(f"{goal.claim.relation!r} is not a relation")
        try:
            return next((proof for proof in self._proofs(goal) if proof is not None), None)
        except TooLongError:
            return None

    def _proofs(self, goal: Goal) -> Iterator[Proof | None]:
        sides = goal.claim.lhs, goal.claim.rhs
        yield self._identity(goal)
        if goal.claim.relation == "=":
            yield self._equation(goal)
            return
        yield boxes.interval(goal, self.enclosed)
        if not self.clears(sides, goal.context):
            return
        turned = Claim(goal.claim.relation, *(self._turned(t, goal.context) for t in sides))
        if turned != goal.claim:
            goal, sides = goal._replace(claim=turned), (turned.lhs, turned.rhs)
            if not self.clears(sides, goal.context):
                return
        if goal.claim.key == ("<", ZERO, goal.claim.rhs) and goal.claim.rhs.op == "sqrt":
            yield self._root(goal)
        if any(side.op in ("min", "max") for side in sides):
            yield Strategy(goal, self).plain_squares()
        yield self._extremum(goal)
        yield signs(goal, lambda claim: self.session.known(claim, goal.context))
        yield bernstein(goal)
        yield boxes.cuts(goal, self.enclosed, self.budget)
        yield from Strategy(goal, self).proofs()
        wider = self._with_neighbours(goal)
        if wider is not None:
            yield from Strategy(wider, self).proofs()

    def _with_neighbours(self, goal: Goal) -> Goal | None:
        """The goal with the variables that givens link to its own; None if there are none."""
        found = {*goal.variables}
        names = [{*names_of(given.claim.lhs, given.claim.rhs)} for given in self._givens(goal)]
        for _ in range(MAX_LINKED):
            linked = [near & self.bounds.keys() for near in names if near & found]
            found |= {*chain(*linked)}
        if len(found) == len(goal.variables) or len(found) > MAX_LINKED:
            return None
        return goal._replace(variables={name: self.bounds[name] for name in sorted(found)})

    def _givens(self, goal: Goal) -> Iterator[Given]:
        """The givens of the contexts around a goal."""
        for place in self.session.chain(goal.context):
            yield from () if place is None else self.contexts[place].givens

    def _identity(self, goal: Goal) -> Proof | None:
        claim, known = goal.claim, self.session.definitions
        if claim.relation == "<":
            return None
        definitions = self._definitions((*goal.constants, *goal.definitions))
        for using in {(): None, definitions: None}:
            clearing = Clearing((claim.lhs, claim.rhs), self.session.replaced(using))
            difference = clearing.difference(claim.lhs, claim.rhs)
            if not clearing.reduce(difference).to_dict():
                terms = claim.lhs, claim.rhs, *(known[name] for name in using)
                if not self.clears(terms, goal.context):
                    return None
                return Sum(() if claim.relation == "=" else ("goal",), using)
        return None

    def _equation(self, goal: Goal) -> Proof | None:
        """By cosines of multiples of an angle, or because each side is at most the other."""
        if not self.clears((goal.claim.lhs, goal.claim.rhs), goal.context):
            return None
        strategy = Strategy(goal, self)
        if not strategy.may_be_equal():
            return None
        proof = next(filter(None, by_cosines(strategy.goal, self, strategy.using)), None)
        proof = proof or by_multiple_angles(strategy)
        if proof is not None:
            return proof
        orders = []
        for sides in ((goal.claim.lhs, goal.claim.rhs), (goal.claim.rhs, goal.claim.lhs)):
            order = self.prove(goal._replace(claim=Claim("<=", *sides)))
            if order is None:
                return None
            orders.append(order)
        return Antisymmetry((orders[0], orders[1]))

    def _definitions(self, names: Iterable[str]) -> tuple[str, ...]:
        """The names that have definitions, and those in their definitions."""
        found: dict[str, None] = {}
        waiting = [*names]
        while waiting:
            name = waiting.pop()
            if name in self.session.definitions and name not in found:
                found[name] = None
                waiting += names_of(self.session.definitions[name])
        return tuple(sorted(found))

    def _root(self, goal: Goal) -> Proof | None:
        radicand = goal.claim.rhs.children[0]
        return Root() if self.fact(Claim("<", ZERO, radicand), goal.context) else None

    def _extremum(self, goal: Goal) -> Proof | None:
        """A minimum is at most its entries; what is less than all of them is less than it."""
        lhs, rhs, relation = goal.claim.lhs, goal.claim.rhs, goal.claim.relation
        for side, term, other, small in (("lhs", lhs, rhs, "min"), ("rhs", rhs, lhs, "max")):
            if term.op == small and other in term.children and relation == "<=":
                return Entry(side)
            if term.op in ("min", "max") and term.op != small:
                sides = ((e, other) if side == "lhs" else (other, e) for e in term.children)
                claims = [Claim(relation, *pair) for pair in sides]
                proofs = [self.prove(self.goal(claim, goal.context)) for claim in claims]
                found = tuple(proof for proof in proofs if proof is not None)
                return Least(side, found) if len(found) == len(proofs) else None
        return None

    def enclosed(self, name: str, bits: int) -> Any:
        """A constant without variables, enclosed; None for any other."""
        if name not in self.ground.definitions:
            return None
        return self.ground.ball(Term("symbol", name), bits)

    # --- decisions ------------------------------------------------------------------------------

    def decide(self, row: Obligation) -> Decision:
        """Decide a row of an open context and write its proof down, or leave it undecided."""
        claim = row.claim
        if isinstance(claim, Applies):
            return self._apply(row, claim)
        if isinstance(claim, Always):
            return self._always(row, claim)
        if isinstance(claim, Claim) and self._home(claim, row.context) is None:
            return self._numbers(row, claim)
        if not isinstance(claim, Claim) or row.context not in self.contexts:
            return Decision(UNDECIDED)
        goal = self.goal(claim, row.context)
        verdict, proof = PROVED, self.prove(goal)
        if proof is None:
            verdict, proof = REFUTED, self._refute(goal, self.contexts[row.context])
        if proof is None:
            return Decision(UNDECIDED)
        self.session.prove_row(row, proof, holds=verdict == PROVED)
        self.rows.add(row.name)
        return Decision(verdict, proof)

    def _numbers(self, row: Obligation, claim: Claim) -> Decision:
        """Decide a row without variables that enclosures leave open, such as one with equality."""
        other = negation(claim)
        if other is None:
            return Decision(UNDECIDED)
        sides = self.ground.enclose(claim.lhs, claim.rhs)
        for verdict, wanted in ((PROVED, claim), (REFUTED, other)):
            proof = None if sides is None else self.prove(self.goal(wanted, None))
            if proof is not None:
                self.session.prove_row(row, proof, holds=verdict == PROVED)
                return Decision(verdict, proof, sides)
        return Decision(UNDECIDED)

    def _apply(self, row: Obligation, claim: Applies) -> Decision:
        """Show that the givens of another context hold at the values of a claim."""
        context = self.contexts.get(claim.context)
        reached = row.context is None or row.context in self.contexts
        if context is None or not reached or context.parent not in self.session.chain(row.context):
            return Decision(UNDECIDED)
        premises = self.premises(context, claim.at, row.context)
        if premises is None:
            return Decision(UNDECIDED)
        proof = Applying(premises)
        self.session.prove_row(row, proof)
        return Decision(PROVED, proof)

    def _always(self, row: Obligation, claim: Always) -> Decision:
        """Show that the carried givens hold at the start, and at the next state."""
        context = self.contexts.get(claim.context)
        if context is None or context.parent != row.context:
            return Decision(UNDECIDED)
        if any(given.kind == "plain" for given in context.givens):
            return Decision(UNDECIDED)
        carried = context._replace(givens=tuple(g for g in context.givens if g.kind == "carried"))
        start = self.premises(carried, claim.start, row.context)
        following = None if start is None else self.premises(carried, claim.next, context.name)
        if start is None or following is None:
            return Decision(UNDECIDED)
        proof = Induction(start, following)
        self.session.prove_row(row, proof)
        return Decision(PROVED, proof)

    def _refute(self, goal: Goal, context: Context) -> Witness | None:
        """Values for the variables of the context at which the claim is false."""
        point = refuting_point(goal, self.enclosed) or refuting_minimum(goal, self)
        if point is None:
            return None
        found = {name: as_term(value) for name, value in point.items()}
        at = {**context.point, **{name: found[name] for name in found if name in context.point}}
        premises = self.premises(context, at, context.parent)
        false = substitute_claim(goal.claim, _unfolded(context, at))
        negative = self._negation(false, context.parent)
        if premises is None or negative is None:
            return None
        return Witness(at, premises, negative)

    def _negation(self, claim: Claim, context: str | None) -> Proof | None:
        """A proof that a claim is false, for all values in a context."""
        if self._home(claim, context) is None:
            verdict, proof = self.ground.prove(claim)
            return proof if verdict == REFUTED else None
        other = negation(claim)
        return None if other is None else self.prove(self.goal(other, context))


def _unfolded(context: Context, at: Mapping[str, Term]) -> dict[str, Term]:
    """The values of the variables of a context, and those of its constants."""
    values = dict(at)
    for constant in context.constants:
        values[constant.name] = substitute(constant.term, values)
    return values
