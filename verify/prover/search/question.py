"""One claim that is to be shown, with what is known where it stands: what techniques are given."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from fractions import Fraction
from functools import cached_property

from flint import fmpq, fmpq_mpoly

from verify.language.record import TYPE_CHECKING
from verify.language.statement import Given
from verify.language.terms import Claim, Term, names_of, symbol
from verify.prover.clearing import Clearing, inner_first, through
from verify.prover.goal import Goal, definitions_below
from verify.prover.points import failure_test, refuting_point, simple_points
from verify.prover.proof import Proof, Value
from verify.prover.rules import Entry
from verify.prover.search.domain import Domain
from verify.prover.session import ZERO
from verify.prover.universal import Universal

if TYPE_CHECKING:
    from verify.prover.search.local_minima import Minima

#: An estimate below this may be a zero.
NEAR_ZERO = 1e-6
MAX_ZEROS = 12
#: Lemmas inside lemmas.
MAX_DEPTH = 9
#: More givens are not used.
MAX_FACTS = 16


class Question:
    """A goal, what is known in its context, and what estimates say of it.

    ``plain`` is the goal as it was asked; in ``goal`` constants are names that are defined.
    """

    def __init__(self, goal: Goal, known: Universal) -> None:
        self.known, self.budget, self.session = known, known.budget, known.session
        self.plain, self.goal = goal, unfolded(goal, known)
        self.using = tuple(self.goal.definitions)

    # --- estimates ------------------------------------------------------------------------------

    @cached_property
    def estimates(self) -> Minima:
        """The difference of the sides, where the givens hold."""
        from verify.prover.search.local_minima import Minima  # loaded only where it is used

        return Minima(self.goal, self.budget, [*self.given.values()])

    @cached_property
    def minima(self) -> list[tuple[float, tuple[float, ...]]]:
        """Where the claim is most nearly false: searched for once, and only where it is used."""
        return self.estimates.found()

    @property
    def is_near(self) -> bool:
        """Whether the sides nearly meet somewhere."""
        return bool(self.minima) and self.minima[0][0] < NEAR_ZERO

    def may_be_equal(self) -> bool:
        """Whether the sides of an equation are equal, as far as estimates tell.

        At most points they are not, if they are not everywhere: minima are looked for after those.
        Where equations are known estimates do not tell.
        """
        if self.equations:
            return True
        return all(map(_is_near_zero, self.estimates.at_starts())) and all(
            map(_is_near_zero, self.minima)
        )

    def is_refuted(self) -> bool:
        """Whether there is a point where the claim is false; a few are tried before any minimum."""
        if self._are_false(self.estimates.at_starts()):
            return True
        if not self.given and refuting_point(self.goal, self.known.enclosed) is not None:
            return True
        least = self.minima[0][0] if self.minima else math.inf
        if least > NEAR_ZERO or (least >= 0 and self.goal.claim.relation == "<="):
            return False  # where sides meet, < is false, and a descent may end next to that point
        return self._are_false(self.minima) or self.false_at() is not None

    def _are_false(self, found: Iterable[tuple[float, tuple[float, ...]]]) -> bool:
        """Whether an estimate is clearly negative, and enclosures at its point agree."""
        low = [point for value, point in found if value < -NEAR_ZERO]
        if not low:
            return False
        at_fault = failure_test(self.goal, self.known.enclosed)
        return any(at_fault([*map(Fraction, point)]) for point in low)

    def false_at(self) -> dict[str, Fraction] | None:
        """A simple point inside all bounds, near a local minimum, where the claim is false."""
        at_fault = failure_test(self.plain, self.known.enclosed)
        tests = [
            failure_test(self.plain._replace(claim=claim), self.known.enclosed)
            for claim in self.given.values()
            if self.plain.variables.keys() >= {*names_of(claim.lhs, claim.rhs)}
        ]
        for value, point in self.minima:
            if value > NEAR_ZERO:
                break
            for values in simple_points(point, self._bounds):
                if at_fault(values) and not any(fails(values) for fails in tests):
                    return dict(zip(self.goal.variables, values, strict=True))
        return None

    @cached_property
    def simple_zeros(self) -> list[dict[str, Fraction]]:
        """Simple points near those where the claim is nearly false."""
        found = []
        for point in self._near_zeros():
            for values in simple_points(point, self._bounds, inside=False):
                if all(abs(float(a) - b) < 1e-6 for a, b in zip(values, point, strict=True)):
                    found.append(dict(zip(self.goal.variables, values, strict=True)))
                    break
        return found

    def zeros(self, domain: Domain) -> list[list[Fraction]]:
        """Points with simple coordinates where p is 0."""
        found = []
        for point in self._near_zeros():
            for values in simple_points(point, self._bounds, inside=False):
                scaled = domain.point(dict(zip(self.goal.variables, values, strict=True)))
                if scaled is None:
                    return []
                if domain.is_zero(scaled):
                    found.append(scaled)
                    break
        return found

    @property
    def _bounds(self) -> list[tuple[Fraction | None, Fraction | None]]:
        return [(b.low, b.high) for b in self.goal.variables.values()]

    def _near_zeros(self) -> Iterator[tuple[float, ...]]:
        """Where the claim is nearly false."""
        return (point for value, point in self.minima[:MAX_ZEROS] if value <= NEAR_ZERO)

    # --- polynomials ----------------------------------------------------------------------------

    @cached_property
    def clearing(self) -> Clearing:
        """The ring of the claim's atoms; long definitions are expanded in it once."""
        replaced = {symbol(name): term for name, term in self.goal.definitions.items()}
        return Clearing((self.goal.claim.lhs, self.goal.claim.rhs), replaced, self.is_negative)

    def is_negative(self, divisor: Term) -> bool:
        """Whether a divisor, also one in a fact, is cleared as a negative one."""
        return self.known.is_negative(divisor, self.goal.context)

    def clears(self) -> bool:
        """Afterwards the definitions that a proof may use have the facts that they need."""
        return self.known.clears(self.goal.definitions.values(), self.goal.context)

    # --- facts ----------------------------------------------------------------------------------

    @cached_property
    def given(self) -> dict[str, Claim]:
        """What is given here of the names in the claim, but for bounds by numbers."""
        return {g.name: g.claim for g in self.givens() if self._is_near(g.name, g.claim)}

    @cached_property
    def equations(self) -> dict[str, Claim]:
        """The equations among givens and proved rows about these names."""
        known = self.known
        rows = sorted(known.usable_rows)
        names = (*(given.name for given in self.givens()), *rows)
        found = {name: self.session.claims[name] for name in names}
        return {
            name: claim
            for name, claim in found.items()
            if claim.relation == "="
            and self._is_here(name, claim)
            and known.is_cleared(claim, self.goal.context)
        }

    def givens(self) -> Iterator[Given]:
        """All that is given here."""
        for place in self.session.chain(self.goal.context):
            if place is not None:
                givens = self.known.contexts[place].givens
                yield from (given for given in givens if given.name not in self.known.hidden)

    @cached_property
    def extrema(self) -> list[Term]:
        """The minima and maxima in the claim, each after those inside it."""
        return self._extrema(self.goal.claim.lhs, self.goal.claim.rhs)

    @cached_property
    def given_extrema(self) -> list[Term]:
        """Those in what is given of the names in the claim, and not in the claim."""
        sides = (side for claim in self.given.values() for side in (claim.lhs, claim.rhs))
        return [term for term in self._extrema(*sides) if term not in self.extrema]

    def _extrema(self, *terms: Term) -> list[Term]:
        parts = inner_first(terms, through(self.goal.definitions))
        return [part for part in parts if part.op in ("min", "max")]

    @cached_property
    def facts(self) -> dict[str, Claim]:
        """The bounds of the variables, givens, rows, and what minima say of their entries."""
        session, found = self.session, dict[str, Claim]()
        for bounds in self.goal.variables.values():
            for name in (bounds.low_fact, bounds.high_fact):
                if name and session.claims[name].relation != "=":
                    found[name] = session.claims[name]
        found |= dict([*self.given.items()][: max(0, MAX_FACTS - len(found))])
        rows = {name: session.claims[name] for name in self.known.usable_rows}
        found |= {name: rows[name] for name in sorted(rows) if self.is_usable(name, rows[name])}
        for term in self.extrema:
            for entry in term.children:
                known = self.entry(term, entry)
                if known is not None:
                    found[known] = session.claims[known]
        return found

    def entry(self, term: Term, entry: Term) -> str | None:
        """The fact that a minimum is at most its entry, or a maximum at least."""
        place = self.goal.context
        sides = (term, entry) if term.op == "min" else (entry, term)
        known = self.session.known(claim := Claim("<=", *sides), place)
        if known is None and self.known.clears(sides, place):
            proof = Entry("lhs" if term.op == "min" else "rhs")
            known = self.session.lemma(claim, proof, place)
        return known

    def fact(self, claim: Claim) -> str | None:
        """The name of a fact that is proved now; None if that fails, or lemmas are too deep.

        Sums may use it: its divisors and radicands have the facts that they need, although
        enclosures prove it without them.
        """
        known, depth = self.known, self.known.depth
        if depth > MAX_DEPTH:
            known.reasons["lemmas inside lemmas are too deep"] = None
            return None
        known.depth += 1
        try:
            found = known.fact(claim, self.goal.context)
            cleared = found is not None and known.clears((claim.lhs, claim.rhs), self.goal.context)
            return found if cleared else None
        finally:
            known.depth = depth

    def from_fact(self, claim: Claim, fact: str | None, using: Iterable[str] = ()) -> Proof | None:
        """A proof of a claim from a fact of which it is a positive multiple; else None."""
        from verify.prover.multiple import from_fact  # loaded only where it is used

        return from_fact(self.session, claim, fact, (*using,), self.is_negative)

    def lemma(self, relation: str, polynomial: fmpq_mpoly, term: Term) -> Value | None:
        """The value of a fact 0 < p or 0 <= p, where the polynomial p is written as a term."""
        if polynomial.is_constant():
            number = polynomial.leading_coefficient() if polynomial.to_dict() else fmpq(0)
            good = number > 0 or (number == 0 and relation == "<=")
            return str(number) if good else None
        return self.fact(Claim(relation, ZERO, term))

    def widened(self) -> Question | None:
        """The question with all that is linked to its names; None if that is nothing new.

        What is known of a name may have other names in it, of which something may be known, too.
        """
        goal, known = self.plain, self.known
        found = {*names_of(goal.claim.lhs, goal.claim.rhs), *goal.variables, *goal.definitions}
        found |= set(goal.constants)
        facts = {given.name for given in self.givens()} | known.usable_rows
        facts = {name for name in facts if self.session.homes[name] in self._places}
        left = {name: {*names_of(*self.session.claims[name].key[1:])} for name in sorted(facts)}
        while near := [name for name, own in left.items() if own & known.variables_in(found)]:
            found.update(*map(left.pop, near))
        wider = known.goal(goal.claim, goal.context, found)
        return None if wider == goal else Question(wider, known)

    @property
    def _places(self) -> list[str | None]:
        return [*self.session.chain(self.goal.context)]

    def _is_near(self, name: str, claim: Claim) -> bool:
        """Whether a fact may help: an inequality here, no bound by a number, all in these names."""
        if claim.relation == "=" or not self._is_here(name, claim):
            return False
        is_bound = {claim.lhs.op, claim.rhs.op} == {"symbol", "rational"}
        return not is_bound

    def _is_here(self, name: str, claim: Claim) -> bool:
        """Whether a fact is usable, and about these names."""
        if self.session.homes[name] not in self.session.chain(self.goal.context):
            return False
        return {*names_of(claim.lhs, claim.rhs)} <= {*self.goal.variables, *self.using}

    def is_usable(self, name: str, row: Claim) -> bool:
        """Whether a row that is proved may help, and the checker can clear it.

        Enclosures prove a row without the facts that its divisors and radicands need in a sum.
        """
        return self._is_near(name, row) and self.known.is_cleared(row, self.goal.context)


def _is_near_zero(found: tuple[float, tuple[float, ...]]) -> bool:
    value, point = found
    return abs(value) < NEAR_ZERO * (1 + max(map(abs, point), default=0))


def unfolded(goal: Goal, known: Universal) -> Goal:
    """The goal with constants as names that are defined."""
    terms = definitions_below(goal.constants, known.ground.definitions) if goal.constants else {}
    return goal._replace(constants=(), definitions={**terms, **goal.definitions})


def refuting_minimum(goal: Goal, known: Universal) -> dict[str, Fraction] | None:
    """A simple point inside all bounds, near a local minimum, where the claim is false."""
    return None if goal.claim.relation == "=" else Question(goal, known).false_at()
