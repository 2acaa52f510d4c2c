"""The order in which the techniques are tried on a claim."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from functools import cached_property

from flint import fmpq, fmpq_mpoly

from verify.language.record import TYPE_CHECKING
from verify.language.statement import Given
from verify.language.terms import Claim, Term, names_of, symbol
from verify.prover.clearing import Clearing, atoms_of
from verify.prover.goal import Goal
from verify.prover.points import failure_test
from verify.prover.proof import Proof, Value
from verify.prover.rules import Entry
from verify.prover.search.atom_bounds import root_bounds
from verify.prover.search.bernstein_boxes import by_bernstein
from verify.prover.search.cosine_bounds import by_cosines
from verify.prover.search.domain import Domain
from verify.prover.search.ends_of_variables import Polynomials
from verify.prover.search.extrema import by_entries, extrema_of, split
from verify.prover.search.local_minima import Minima, simple_points
from verify.prover.search.multiple_angles import by_multiple_angles
from verify.prover.search.positive import by_squares
from verify.prover.search.squaring import by_squaring
from verify.prover.search.subterms import by_subterms
from verify.prover.search.tree import Tree
from verify.prover.session import ZERO

if TYPE_CHECKING:
    from verify.prover.universal import Universal

#: An estimate below this may be a zero.
NEAR_ZERO = 1e-6
MAX_ZEROS = 12
#: Lemmas inside lemmas.
MAX_DEPTH = 9
#: More givens are not used.
MAX_FACTS = 16
FEW_LEAVES, MANY_LEAVES = 300, 20_000
FEW_PARTS, MANY_PARTS = 100, 2000
FEW_ATTEMPTS, MANY_ATTEMPTS = 4, 100


class Strategy:
    """Techniques for one claim, with what is known in its context."""

    def __init__(self, goal: Goal, universal: Universal) -> None:
        self.universal, self.budget = universal, universal.budget
        self.goal = unfolded(goal, universal)
        self.using = tuple(self.goal.definitions)
        self.given = dict(self.givens())

    @cached_property
    def estimates(self) -> Minima:
        """The difference of the sides, where the givens hold."""
        return Minima(self.goal, self.budget, [*self.given.values()])

    @cached_property
    def minima(self) -> list[tuple[float, tuple[float, ...]]]:
        """Where the claim is most nearly false: searched for once, and only where it is used."""
        return self.estimates.found()

    @cached_property
    def clearing(self) -> Clearing:
        """The ring of the claim's atoms; long definitions are expanded in it once."""
        replaced = {symbol(name): term for name, term in self.goal.definitions.items()}
        return Clearing((self.goal.claim.lhs, self.goal.claim.rhs), replaced, self.is_negative)

    def is_negative(self, divisor: Term) -> bool:
        """Whether a divisor, also one in a fact, is cleared as a negative one."""
        return self.universal.is_negative(divisor, self.goal.context)

    def clears(self) -> bool:
        """Afterwards the definitions that a proof may use have the facts that they need."""
        return self.universal.clears(self.goal.definitions.values(), self.goal.context)

    def proofs(self) -> Iterator[Proof | None]:
        """What each technique finds."""
        if not self.clears():
            return
        if self.minima and self.minima[0][0] < 0 and self.is_refuted():
            return
        is_near = bool(self.minima) and self.minima[0][0] < NEAR_ZERO
        if is_near:
            yield from by_cosines(self.goal, self.universal, self.using)
        yield self.tree(FEW_LEAVES)
        if not is_near:
            yield from by_cosines(self.goal, self.universal, self.using)
        yield by_multiple_angles(self)
        zeros = self.simple_zeros()
        yield by_bernstein(self, zeros, FEW_PARTS)
        if len(self.goal.variables) > 2 and self.goal.box is not None:
            polynomials = Polynomials(self)
            if polynomials.is_plain:
                yield polynomials.by_ends()
        yield by_squaring(self)
        facts = self.facts()
        if extrema_of((self.goal.claim.lhs, self.goal.claim.rhs), self.goal.definitions):
            yield self.squares(self.goal, facts, attempts=FEW_ATTEMPTS)
            yield by_entries(self, facts)
            yield split(self, facts)
        yield self.squares(self.goal, facts)
        bounds = self.root_facts()
        if bounds:
            yield self.squares(self.goal, facts | bounds)
        yield by_bernstein(self, zeros, MANY_PARTS)
        yield by_subterms(self)
        yield self.tree(MANY_LEAVES)
        yield self.wider_squares(facts)

    def may_be_equal(self) -> bool:
        """Whether the sides of an equation are equal, as far as estimates tell.

        At most points they are not, if they are not everywhere: minima are looked for after those.
        """
        return all(map(_is_near_zero, self.estimates.at_starts())) and all(
            map(_is_near_zero, self.minima)
        )

    def is_refuted(self) -> bool:
        """Whether there is a point where the claim is false."""
        return self.minima[0][0] < -NEAR_ZERO or (
            false_at(self.goal, self.minima, self.universal) is not None
        )

    def tree(self, leaves: int) -> Proof | None:
        """Enclosures on parts of the box."""
        goal = self.goal
        if goal.box is None or not goal.variables:
            return None
        return Tree(goal.claim, goal.variables, goal.definitions, self.budget).prove(leaves)

    def plain_squares(self) -> Proof | None:
        """Squares alone, for claims in which minima or maxima cancel."""
        domain = Domain(self.goal, {}, None, self.is_negative)
        if (
            not self.clears()
            or not domain.is_plain
            or any(domain.atoms[i].op in ("min", "max") for i in domain.used)
        ):
            return None
        return by_squares(domain, [], self.budget, self.using)

    def squares(
        self, goal: Goal, facts: dict[str, Claim], attempts: int = MANY_ATTEMPTS
    ) -> Proof | None:
        """Squares times facts."""
        domain = Domain(goal, facts, None, self.is_negative)
        if not domain.is_plain:
            return None
        zeros = self.zeros(domain) if goal is self.goal else []
        return by_squares(domain, zeros, self.budget, self.using, attempts)

    def wider_squares(self, facts: dict[str, Claim]) -> Proof | None:
        """Squares times facts, with givens that have other variables too."""
        universal, names = self.universal, {*self.goal.variables}
        wider = dict(facts)
        for given in self.all_givens():
            own = {*names_of(given.claim.lhs, given.claim.rhs)}
            if own & names and own <= universal.bounds.keys() and given.claim.relation != "=":
                names |= own
                wider[given.name] = given.claim
        if len(wider) == len(facts) or len(wider) > MAX_FACTS:
            return None
        variables = {name: universal.bounds[name] for name in sorted(names)}
        return self.squares(self.goal._replace(variables=variables), wider)

    def facts(self) -> dict[str, Claim]:
        """The bounds of the variables, and that a maximum is at least its entries."""
        session, found = self.universal.session, {}
        for bounds in self.goal.variables.values():
            for name in (bounds.low_fact, bounds.high_fact):
                if name and session.claims[name].relation != "=":
                    found[name] = session.claims[name]
        found |= dict([*self.given.items()][: max(0, MAX_FACTS - len(found))])
        rows = {name: session.claims[name] for name in self.universal.rows & session.claims.keys()}
        found |= {name: rows[name] for name in sorted(rows) if self._is_usable(name, rows[name])}
        for term in extrema_of((self.goal.claim.lhs, self.goal.claim.rhs), self.goal.definitions):
            for entry in term.children:
                known = self.entry(term, entry)
                if known is not None:
                    found[known] = session.claims[known]
        return found

    def entry(self, term: Term, entry: Term) -> str | None:
        """The fact that a minimum is at most its entry, or a maximum at least."""
        universal, place = self.universal, self.goal.context
        sides = (term, entry) if term.op == "min" else (entry, term)
        known = universal.session.known(claim := Claim("<=", *sides), place)
        if known is None and universal.clears(sides, place):
            proof = Entry("lhs" if term.op == "min" else "rhs")
            known = universal.session.lemma(claim, proof, place)
        return known

    def givens(self) -> Iterator[tuple[str, Claim]]:
        """What is given here of the names in the claim, but for bounds by numbers."""
        for given in self.all_givens():
            if self._is_near(given.name, given.claim):
                yield given.name, given.claim

    def all_givens(self) -> Iterator[Given]:
        """What is given here."""
        session, contexts = self.universal.session, self.universal.contexts
        for place in session.chain(self.goal.context):
            if place is not None:
                yield from contexts[place].givens

    def fact(self, claim: Claim) -> str | None:
        """The name of a fact that is proved now; None if that fails, or lemmas are too deep."""
        universal = self.universal
        depth = universal.depth
        if depth > MAX_DEPTH:
            return None
        universal.depth += 1
        try:
            return universal.fact(claim, self.goal.context)
        finally:
            universal.depth = depth

    def lemma(self, relation: str, polynomial: fmpq_mpoly, term: Term) -> Value | None:
        """The value of a fact 0 < p or 0 <= p, where the polynomial p is written as a term."""
        if polynomial.is_constant():
            number = polynomial.leading_coefficient() if polynomial.to_dict() else fmpq(0)
            good = number > 0 or (number == 0 and relation == "<=")
            return f"{number.p}/{number.q}" if good else None
        return self.fact(Claim(relation, ZERO, term))

    def root_facts(self) -> dict[str, Claim]:
        """The bounds of roots, which are proved now."""
        found = {}
        for claim in root_bounds(self):
            known = self.universal.fact(claim, self.goal.context)
            if known is not None:
                found[known] = claim
        return found

    def _is_near(self, name: str, claim: Claim) -> bool:
        """Whether a fact may help: an inequality here, no bound by a number, all in these names."""
        session = self.universal.session
        if claim.relation == "=" or session.homes[name] not in session.chain(self.goal.context):
            return False
        names = {*names_of(claim.lhs, claim.rhs)}
        is_bound = {claim.lhs.op, claim.rhs.op} == {"symbol", "rational"}
        return not is_bound and names <= {*self.goal.variables, *self.using}

    def _is_usable(self, name: str, row: Claim) -> bool:
        """Whether a row that is proved may help, and the checker can clear it.

        Enclosures prove a row without the facts that its divisors and radicands need in a sum.
        """
        return self._is_near(name, row) and self.universal.is_cleared(row, self.goal.context)

    def simple_zeros(self) -> list[dict[str, Fraction]]:
        """Simple points near those where the claim is nearly false."""
        bounds = [(b.low, b.high) for b in self.goal.variables.values()]
        found = []
        for value, point in self.minima[:MAX_ZEROS]:
            if value > NEAR_ZERO:
                break
            for values in simple_points(point, bounds, inside=False):
                if all(abs(float(a) - b) < 1e-6 for a, b in zip(values, point, strict=True)):
                    found.append(dict(zip(self.goal.variables, values, strict=True)))
                    break
        return found

    def zeros(self, domain: Domain) -> list[list[Fraction]]:
        """Points with simple coordinates where p is 0."""
        found = []
        names = [*self.goal.variables]
        bounds = [(b.low, b.high) for b in self.goal.variables.values()]
        for value, point in self.minima[:MAX_ZEROS]:
            if value > NEAR_ZERO:
                break
            for values in simple_points(point, bounds, inside=False):
                scaled = domain.point(dict(zip(names, values, strict=True)))
                if scaled is None:
                    return []
                if domain.is_zero(scaled):
                    found.append(scaled)
                    break
        return found


def _is_near_zero(found: tuple[float, tuple[float, ...]]) -> bool:
    value, point = found
    return abs(value) < NEAR_ZERO * (1 + max(map(abs, point), default=0))


def unfolded(goal: Goal, universal: Universal) -> Goal:
    """The goal with constants as names that are defined."""
    known: dict[str, Term] = {}
    if goal.constants:
        wanted = set(goal.constants)
        ground = universal.ground.definitions
        for name in reversed(ground):
            if name in wanted:
                wanted |= {
                    atom.name for atom in atoms_of((ground[name],), {}) if atom.op == "symbol"
                }
        known = {name: term for name, term in ground.items() if name in wanted}
    return goal._replace(constants=(), definitions={**known, **goal.definitions})


def refuting_minimum(goal: Goal, universal: Universal) -> dict[str, Fraction] | None:
    """A simple point inside all bounds, near a local minimum, where the claim is false."""
    if goal.claim.relation == "=":
        return None
    return false_at(goal, Strategy(goal, universal).minima, universal)


def false_at(
    goal: Goal, minima: list[tuple[float, tuple[float, ...]]], universal: Universal
) -> dict[str, Fraction] | None:
    """The first simple point near one of these where the claim is false."""
    at_fault = failure_test(goal, universal.enclosed)
    bounds = [(b.low, b.high) for b in goal.variables.values()]
    for value, point in minima:
        if value > NEAR_ZERO:
            break
        for values in simple_points(point, bounds):
            if at_fault(values):
                return dict(zip(goal.variables, values, strict=True))
    return None
