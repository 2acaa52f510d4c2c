"""Claims for all values of the variables in scope: identities, signs, enclosures, polynomials.

Nothing here is trusted. What is found is written down as the steps of a certificate.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from fractions import Fraction
from typing import Any

from verify.language.fold import MEANINGS
from verify.language.statement import PROVED, UNDECIDED, Constant, Context, Given
from verify.language.terms import Claim, Term, names_of, parts_of, substitute, substitute_claim
from verify.prover.budget import WorkBudget
from verify.prover.clearing import divisors, has_value
from verify.prover.goal import Bounds, Goal, bounds_of, definitions_below, narrowed
from verify.prover.ground import Ground
from verify.prover.hint import Hint
from verify.prover.lengths import Lengths
from verify.prover.proof import Proof
from verify.prover.rules import Define, Sum
from verify.prover.session import ZERO


class Universal:
    """Proves claims in contexts, with the facts that are known there.

    Args:
        ground: decides what has no variables; its session takes the steps.
        budget: the work that each row may be.
        find: looks for the proof of a goal.
    """

    def __init__(
        self, ground: Ground, budget: WorkBudget, find: Callable[[Goal, Universal], Proof | None]
    ) -> None:
        self.ground, self.session, self.budget, self._find = ground, ground.session, budget, find
        self.reasons: dict[str, None] = {}  # why nothing is found
        self.tried: dict[str, None] = {}  # the techniques
        self.found_by = ""  # the technique that found the last proof
        self.refused: set[str] = set()  # techniques whose proof the checker cannot afford
        self.left: dict[str, tuple[Fraction, Fraction]] = {}  # the part of a box that is open
        self.hints: dict[Claim, Hint] = {}  # where to look for the proof of a claim
        self.lengths = Lengths()
        self.contexts: dict[str, Context] = {}
        self.failed: Given | None = None  # at the values at which it was not shown
        self.undefined: Given | None = None  # which was not seen to be defined by others
        self.valueless: set[Term] = set()  # quotients, roots and logarithms not seen to have one
        self.depth = 0  # of lemmas that lemmas need
        self.rows: set[str] = set()  # that are proved, so that later ones may use them
        self.hidden: frozenset[str] = frozenset()  # givens and rows that are not to be used now
        self.is_restricted = False  # whether it is decided what is hidden
        self.bounds: dict[str, Bounds] = {}
        self.ranged: set[str | None] = set()  # contexts in which more bounds were looked for
        self._homes: dict[str, str] = {}
        self._local: dict[str, Term] = {}
        self._clear: set[tuple[str | None, Term]] = set()

    def mark(self) -> Callable[[], None]:
        """What undoes all that is found from now on, but for contexts and constants."""
        undo_steps, undo_decided = self.session.mark(), self.ground.mark()
        clear, rows, depth = {*self._clear}, {*self.rows}, self.depth
        bounds, ranged = dict(self.bounds), {*self.ranged}

        def undo() -> None:
            undo_steps()
            undo_decided()
            self._clear, self.rows, self.depth = {*clear}, {*rows}, depth
            self.bounds, self.ranged = dict(bounds), {*ranged}

        return undo

    # --- contexts -------------------------------------------------------------------------------

    def open(self, context: Context) -> bool:
        """Open a context and define its constants; False if that is not found."""
        return self.enter(context) and all(
            self.define(constant, context.name) for constant in context.constants
        )

    def enter(self, context: Context, premises: tuple[str, ...] | None = None) -> bool:
        """Show that the givens hold at the context's point; False if that is not found.

        ``premises`` has the names of facts that say so; without it they are looked for.
        """
        if context.parent is not None and context.parent not in self.contexts:
            return False
        if not self._are_defined(context):
            return False
        if premises is None:
            premises = self.premises(context, context.point, context.parent)
        if premises is None:
            return False
        self.contexts[context.name] = context
        self.session.open(context, premises)
        self.bounds |= bounds_of(context, self._between_numbers(context))
        self._homes |= {variable.name: context.name for variable in context.variables}
        return True

    def _between_numbers(self, context: Context) -> Iterator[Given]:
        """Bounds by rational numbers, for variables that givens bound by other constants."""
        names = {variable.name for variable in context.variables}
        for given in context.givens:
            relation, lhs, rhs = given.claim.key
            for variable, bound, up in ((lhs, rhs, True), (rhs, lhs, False)):
                if relation == "=" or variable.op != "symbol" or variable.name not in names:
                    continue
                if bound.op == "rational" or not self.clears_as_number(bound):
                    continue
                if [*divisors(bound)]:  # the sum below would have to be multiplied by the divisor
                    continue
                number = self.ground.short_bound(bound, up=up)
                near = Claim("<=", *((bound, number) if up else (number, bound)))
                lemma = None if number is None else self.ground.lemma(near)
                if lemma is not None:
                    sides = (variable, number) if up else (number, variable)
                    claim = Claim(relation, *sides)
                    proof = Sum(("goal", given.name, lemma))
                    yield Given(self.session.lemma(claim, proof, context.name), claim)

    @property
    def usable_rows(self) -> set[str]:
        """The proved rows that may be used now."""
        return (self.rows & self.session.claims.keys()) - self.hidden

    def is_at_home(self, name: str, context: str | None) -> bool:
        """Whether a variable is one of this context, not of one around it."""
        return self._homes.get(name) == context

    def narrow(self, name: str, given: Given) -> None:
        """Add a bound by a number that is a fact of the variable's own context."""
        self.bounds[name] = narrowed(self.bounds[name], name, given)

    def clears_as_number(self, term: Term) -> bool:
        """Whether a term without variables can be cleared; afterwards its parts have facts."""
        names = names_of(term)
        return all(name in self.ground.definitions for name in names) and self.clears((term,), None)

    def _are_defined(self, context: Context) -> bool:
        """Whether givens before, or facts around, say the sign of what the givens divide by."""
        earlier: set[Claim] = set()
        variables = {variable.name for variable in context.variables}

        def is_fact(claim: Claim) -> bool:
            if claim in earlier or variables & {*names_of(claim.rhs)}:
                return claim in earlier
            return self.fact(claim, context.parent) is not None

        for given in context.givens:
            parts = parts_of(given.claim.lhs, given.claim.rhs)
            if not all(has_value(part, is_fact) for part in parts):
                self.undefined = given
                return False
            earlier.add(given.claim)
        return True

    def is_cleared(self, claim: Claim, context: str | None) -> bool:
        """Whether each divisor and radicand in a claim has the fact that it needs by now."""
        is_fact = lambda wanted: self.session.known(wanted, context) is not None  # noqa: E731
        return all(has_value(part, is_fact) for part in parts_of(claim.lhs, claim.rhs))

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
        self.failed = None
        if not self.clears(at.values(), place):
            return None
        values, names = with_constants(context, at), []
        for given in context.givens:
            claim = substitute_claim(given.claim, values)
            name = self.fact(claim, place)
            if name is None:
                self.failed = given._replace(claim=claim)
                return None
            names.append(name)
        return tuple(names)

    def goal(self, claim: Claim, context: str | None, others: Iterable[str] = ()) -> Goal:
        """The claim with what is known of the names in it, and of others."""
        own = {*names_of(claim.lhs, claim.rhs), *others}
        definitions = definitions_below(own, self._local)
        names = sorted(own.union(names_of(*definitions.values())))
        variables = {name: self.bounds[name] for name in names if name in self.bounds}
        constants = (name for name in names if name not in variables and name not in definitions)
        return Goal(claim, context, variables, tuple(constants), definitions)

    def variables_in(self, names: Iterable[str]) -> set[str]:
        """The variables among names, and in the definitions of names."""
        found = set(names)
        definitions = definitions_below(found, self._local)
        return found.union(names_of(*definitions.values())) & self.bounds.keys()

    @property
    def every_definition(self) -> Mapping[str, Term]:
        """What the names of constants stand for, also those of contexts."""
        return {**self.ground.definitions, **self._local}

    # --- facts ----------------------------------------------------------------------------------

    def fact(self, claim: Claim, context: str | None) -> str | None:
        """The name of a fact, which is proved now if it is not known; None if that fails."""
        known = self.session.known(claim, context)
        if known is not None:
            return known
        home = self.home(claim, context)
        if home is None:
            return self._ground_fact(claim)
        proof = self.prove(self.goal(claim, home))
        return None if proof is None else self.session.lemma(claim, proof, home)

    def _ground_fact(self, claim: Claim) -> str | None:
        verdict, proof = self.ground.prove(claim)
        if verdict == UNDECIDED and claim.relation != "<":
            verdict, proof = PROVED, self.prove(self.goal(claim, None))
        return self.session.lemma(claim, proof) if verdict == PROVED and proof else None

    def home(self, claim: Claim, context: str | None) -> str | None:
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
        if not has_value(term, lambda claim: self.fact(claim, context) is not None):
            self.valueless.add(term)
            return False
        self.valueless.discard(term)
        self._clear.add((context, term))
        return True

    def turned(self, claim: Claim, context: str | None) -> Claim:
        """The same claim, with -a/-b for a/b where b is known to be negative.

        The checker clears both to the same quotient, so that a sum for one is one for the other;
        the quotients of the search are those of the latter. Atoms stay as they are.
        """
        known: dict[Term, Term] = {}  # terms share their parts: each is turned once

        def turn(part: Term) -> Term:
            if part.op not in ("add", "sub", "mul", "neg", "pow", "div"):
                return part
            if part not in known:
                children = tuple(map(turn, part.children))
                if part.op == "div" and self.is_negative(part.children[1], context):
                    known[part] = -children[0] / -children[1]
                else:
                    known[part] = Term(part.op, *children, *part.args[len(children) :])
            return known[part]

        return Claim(claim.relation, turn(claim.lhs), turn(claim.rhs))

    def is_negative(self, term: Term, context: str | None) -> bool:
        """Whether this is how a divisor is cleared."""
        known = (self.session.known(Claim("<", ZERO, t), context) for t in (term, -term))
        return term.op != "rational" and [*map(bool, known)] == [False, True]

    # --- proofs ---------------------------------------------------------------------------------

    def prove(self, goal: Goal) -> Proof | None:
        """A proof of the first kind that is found; the lemmas that it needs are written down.

        Raises:
            ValueError: for an unknown relation.
        """
        if goal.claim.relation not in MEANINGS:
            raise ValueError(f"{goal.claim.relation!r} is not a relation")
        return self._find(goal, self)

    def enclosed(self, name: str, bits: int) -> Any:
        """A constant without variables, enclosed; None for any other."""
        if name not in self.ground.definitions:
            return None
        return self.ground.ball(Term("symbol", name), bits)


def with_constants(context: Context, at: Mapping[str, Term]) -> dict[str, Term]:
    """The values of the variables of a context, and those of its constants."""
    values = dict(at)
    for constant in context.constants:
        values[constant.name] = substitute(constant.term, values)
    return values
