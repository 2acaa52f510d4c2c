"""Claims on a box by a tree of bisections, with leaves by the mean value theorem.

On a box rhs - lhs is its value at a point, and for each variable a slope times its change. A
variable in which it rises or falls has its point at the end where it is least. Slopes change little
on small boxes, so that far fewer of them are needed than by the enclosures of the two sides, in
which what occurs twice is not seen to be the same.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from fractions import Fraction

from verify.language.terms import Claim, Term, names_of, substitute
from verify.prover.balls import float_of
from verify.prover.budget import WorkBudget
from verify.prover.goal import Bounds
from verify.prover.proof import Proof
from verify.prover.rules import MeanValue
from verify.prover.search.compiled import estimates, range_function
from verify.prover.search.derivatives import derivative
from verify.prover.search.exact import ExactRanges
from verify.prover.search.nested import Nested
from verify.prover.search.question import Question
from verify.prover.search.tree import Ends, Piece, Tree, cost_of

#: Bits of the checker: its series take time in proportion.
BITS = 32
#: Differences below this part of the sides are none for these bits.
NEAR = 1e-7
#: A point divides the range of its variable into parts whose lengths are whole numbers of these.
PARTS = 64
#: So many parts of a box are tried.
LEAVES = 20_000
#: What leaves may cost the checker, in its units: most of what a certificate may.
MAX_UNITS = 5_400_000


def by_mean_values(question: Question) -> Proof | None:
    """Slopes on at most so many parts of the box, for the claim in its nested form."""
    goal = question.goal
    if goal.box is None or not goal.variables:
        return None
    nested = Nested(question)
    slopes = Slopes.of(nested.claim, tuple(goal.variables), goal.definitions)
    if slopes is None:
        return None
    tree = MeanTree(nested.claim, goal.variables, goal.definitions, question.budget, slopes)
    proof = tree.prove(LEAVES)
    if proof is None:
        if tree.left is not None:
            question.known.left = dict(zip(goal.variables, tree.left.ends, strict=True))
        return None
    return proof if nested.claim == goal.claim else nested.proof(proof)


class Slopes:
    """The difference of the sides of a claim with its derivatives, by those variables in it."""

    def __init__(self, difference: Term, slopes: Mapping[str, Term]) -> None:
        self.difference, self.names = difference, tuple(slopes)
        self.slopes = tuple(slopes.values())
        self.terms = (difference, *self.slopes)

    @classmethod
    def of(
        cls, claim: Claim, names: Sequence[str], definitions: Mapping[str, Term]
    ) -> Slopes | None:
        """None where there is a minimum or maximum, which has no derivative."""
        plain: dict[str, Term] = {}
        for name, term in definitions.items():
            plain[name] = substitute(term, plain)
        difference = substitute(claim.rhs - claim.lhs, plain)
        found = {}
        for name in names:
            if name in names_of(difference):
                slope = derivative(difference, name)
                if slope is None:
                    return None
                found[name] = slope
        return cls(difference, found) if found else None


class MeanTree(Tree):
    """The same tree, with leaves of both kinds."""

    units = MAX_UNITS

    def __init__(
        self,
        claim: Claim,
        variables: Mapping[str, Bounds],
        definitions: Mapping[str, Term],
        budget: WorkBudget,
        slopes: Slopes,
    ) -> None:
        super().__init__(claim, variables, definitions, budget)
        self.slopes = slopes
        self.moving = [self.names.index(name) for name in slopes.names]
        self.all_ranges = range_function(self.names, slopes.terms, {})
        self.value = estimates(self.names, (slopes.difference,), {})
        self.means = ExactRanges(self.names, {}, BITS)
        box, centre = cost_of(slopes.terms, {}, BITS), cost_of(slopes.terms[:1], {}, BITS)
        self.cost = box + centre
        self.chosen: list[tuple[tuple[Ends, ...], tuple[Fraction, ...]]] = []

    def prove(self, leaves: int) -> Proof | None:
        """A proof with at most so many leaves."""
        self.chosen = []
        proof = super().prove(leaves)
        good = proof is not None and all(self.holds_at(*leaf) for leaf in self.chosen)
        return proof if good else None

    def gap(self, ends: Sequence[Ends]) -> float:
        """The better one of both lower bounds."""
        gap = super().gap(ends)
        return gap if gap >= 0 else max(gap, self.mean_gap(ends)[0])

    def mean_gap(self, ends: Sequence[Ends]) -> tuple[float, list[float]]:
        """A lower bound of rhs - lhs by slopes, and where each point divides its range."""
        self.budget.spend(2 + self.cost // 25)
        numbers = [(float_of(low), float_of(high)) for low, high in ends]
        try:
            _, _, *slopes = self.all_ranges(*(end for pair in numbers for end in pair))
        except (ArithmeticError, ValueError):
            return -math.inf, []
        least, parts = 0.0, []
        point = [low for low, _ in numbers]
        for index, falls, rises in zip(self.moving, slopes[::2], slopes[1::2], strict=True):
            low, high = numbers[index]
            part = _divided(falls, rises)
            below, above = part * (high - low), (1 - part) * (high - low)
            point[index] = low + below
            least += min(min(falls * above, 0.0) if above else 0.0, -rises * below if below else 0)
            parts.append(part)
        try:
            (value,) = self.value(*point)
        except (ArithmeticError, ValueError):
            return -math.inf, []
        gap = value + least - NEAR * (abs(value) - least)
        return (gap, parts) if gap == gap else (-math.inf, [])

    def leaf(self, box: Piece) -> Proof:
        """By enclosures where these do."""
        if super().gap(box.ends) >= 0:
            return super().leaf(box)
        _, parts = self.mean_gap(box.ends)
        points = []
        for index, part in zip(self.moving, parts, strict=True):
            low, high = box.ends[index]
            points.append(low + (high - low) * Fraction(round(part * PARTS), PARTS))
        self.chosen.append((box.ends, tuple(points)))
        at = dict(zip(self.slopes.names, points, strict=True))
        return MeanValue(BITS, self.bounds(box), at)

    def holds_at(self, ends: Sequence[Ends], points: Sequence[Fraction]) -> bool:
        """Whether the checker will accept a leaf by slopes."""
        self.budget.spend(self.cost)
        thin = list(ends)
        for index, c in zip(self.moving, points, strict=True):
            thin[index] = (c, c)
        found = self.means.of(ends, *self.slopes.terms)
        centre = self.means.of(thin, self.slopes.difference)
        if found is None or centre is None:
            return False
        ((least, _),) = centre
        for index, c, slope in zip(self.moving, points, found[1:], strict=True):
            low, high = ends[index]
            change = self.means.product(slope, (low - c, high - c))
            least = self.means.below(least + change[0])
        return least > 0 if self.claim.relation == "<" else least >= 0


def _divided(falls: float, rises: float) -> float:
    """Where the bound is best for a slope between these, from 0 at the low end to 1."""
    if falls >= 0:
        return 0.0
    if rises <= 0:
        return 1.0
    if math.inf in (-falls, rises):
        return 0.5
    return round(-falls / (rises - falls) * PARTS) / PARTS
