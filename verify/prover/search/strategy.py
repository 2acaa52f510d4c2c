"""The order in which the techniques are tried on a claim."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from flint import fmpq

from verify.language.record import TYPE_CHECKING
from verify.language.terms import Claim
from verify.prover.goal import Goal
from verify.prover.points import failure_test
from verify.prover.proof import Proof
from verify.prover.search.domain import Domain
from verify.prover.search.minimum import Minima, simple_points
from verify.prover.search.positive import by_squares
from verify.prover.search.tree import Tree

if TYPE_CHECKING:
    from verify.prover.universal import Universal

#: An estimate below this may be a zero.
NEAR_ZERO = 1e-6
MAX_ZEROS = 12


class Strategy:
    """Techniques for one claim, with what is known in its context."""

    def __init__(self, goal: Goal, universal: Universal) -> None:
        self.goal, self.universal, self.budget = goal, universal, universal.budget
        self.minima = Minima(goal, {}, self.budget).found() if not goal.constants else []

    def proofs(self) -> Iterator[Proof | None]:
        """What each technique finds."""
        if self.minima and self.minima[0][0] < -NEAR_ZERO * self._size():
            return  # it is false
        yield from self.trees(300)
        yield self.squares()
        yield from self.trees(20_000)

    def trees(self, leaves: int) -> Iterator[Proof | None]:
        """Enclosures on parts of the box."""
        goal = self.goal
        if goal.box is None or not goal.variables or goal.constants:
            return
        yield Tree(goal.claim, goal.variables, goal.definitions, self.budget).prove(leaves)

    def _size(self) -> float:
        return 1.0

    def squares(self) -> Proof | None:
        """Squares times facts, for polynomials."""
        domain = Domain(self.goal, self._facts())
        if any(atom.op != "symbol" for atom in domain.atoms):
            return None
        return by_squares(domain, self._zeros(domain), self.budget, tuple(self.goal.definitions))

    def _facts(self) -> dict[str, Claim]:
        """The bounds of the variables."""
        session = self.universal.session
        names = {
            name for b in self.goal.variables.values() for name in (b.low_fact, b.high_fact) if name
        }
        found = {name: session.claims[name] for name in sorted(names)}
        return {name: claim for name, claim in found.items() if claim.relation in ("<", "<=")}

    def _zeros(self, domain: Domain) -> list[list[Fraction]]:
        """Points with simple coordinates where p is 0."""
        found = []
        bounds = [(b.low, b.high) for b in self.goal.variables.values()]
        for value, point in self.minima[:MAX_ZEROS]:
            if value > NEAR_ZERO:
                break
            for values in simple_points(point, bounds, inside=False):
                scaled = domain.point(dict(zip(self.goal.variables, values, strict=True)))
                if scaled is None:
                    return []
                if not domain.p(*(fmpq(v.numerator, v.denominator) for v in scaled)):
                    found.append(scaled)
                    break
        return found


def refuting_minimum(goal: Goal, universal: Universal) -> dict[str, Fraction] | None:
    """A simple point inside all bounds, near a local minimum, where the claim is false."""
    if goal.claim.relation == "=" or goal.constants:
        return None
    at_fault = failure_test(goal, universal.enclosed)
    bounds = [(b.low, b.high) for b in goal.variables.values()]
    for value, point in Minima(goal, {}, universal.budget).found():
        if value > NEAR_ZERO:
            break
        for values in simple_points(point, bounds):
            if at_fault(values):
                return dict(zip(goal.variables, values, strict=True))
    return None
