"""Claims on a box by a tree of bisections, each leaf by the enclosures of the two sides.

A node is cut where the two halves gain most. Floats guide, and say nothing for certain: the
checker's own arithmetic decides each leaf, at once where floats are too near to each other to tell,
and for the others when the tree is complete.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from fractions import Fraction
from functools import cached_property

from verify.language.fold import holds
from verify.language.record import Record
from verify.language.terms import Claim, Term, symbol
from verify.prover.balls import float_of
from verify.prover.budget import WorkBudget
from verify.prover.clearing import inner_first, through
from verify.prover.goal import Bounds
from verify.prover.proof import Proof, every
from verify.prover.rules import Cuts, Interval
from verify.prover.search.compiled import Ranges, range_function
from verify.prover.search.exact import ExactRanges
from verify.prover.search.question import Question

#: So many parts of a box are tried.
LEAVES = 300
#: Bits of the checker in leaves: few, as its cosines take time in proportion.
BITS = 48
#: So many nested cuts leave room for the brackets around them.
MAX_DEPTH = 40
#: What leaves may cost the checker, in its units.
MAX_UNITS = 4_500_000
#: Differences below this part of the sides are left to exact arithmetic.
NEAR = 1e-9
TINY = 1e-15
#: And so are differences that rounding may have made positive.
UNSURE = 1e-6

Ends = tuple[Fraction, Fraction]
#: The two parts of a box, each with its gap.
Halves = list[tuple[tuple[Ends, ...], float]]


def by_tree(question: Question) -> Proof | None:
    """Enclosures on at most so many parts of the box."""
    goal = question.goal
    if goal.box is None or not goal.variables:
        return None
    tree = Tree(goal.claim, goal.variables, goal.definitions, question.budget)
    proof = tree.prove(LEAVES)
    if proof is None and tree.left is not None:
        question.known.left = dict(zip(goal.variables, tree.left.ends, strict=True))
    return proof


class Piece(Record):
    """The ends of each variable, the facts that say so, and how many cuts led here."""

    ends: tuple[Ends, ...]
    facts: tuple[tuple[str, str], ...]
    depth: int


class Tree:
    """One claim `<` or `<=` on boxes.

    Args:
        claim: over the variables and names that are defined.
        variables: with their bounds by numbers, both.
        definitions: what other names stand for.
        hypotheses: how many there are before the first cut.
    """

    bits, most_cuts, units = BITS, MAX_DEPTH, MAX_UNITS

    def __init__(
        self,
        claim: Claim,
        variables: Mapping[str, Bounds],
        definitions: Mapping[str, Term],
        budget: WorkBudget,
        hypotheses: int = 0,
    ) -> None:
        self.claim, self.names, self.budget = claim, tuple(variables), budget
        self.hypotheses = hypotheses
        self.sides = claim.lhs, claim.rhs
        self.definitions = definitions
        self.exact = ExactRanges(self.names, definitions, self.bits)
        self.cost = cost_of(self.sides, definitions, self.bits)
        self.root = Piece(
            tuple(bounds.ends or (Fraction(0), Fraction(0)) for bounds in variables.values()),
            tuple((bounds.low_fact, bounds.high_fact) for bounds in variables.values()),
            0,
        )
        self.leaves = 0
        self.most = 0
        self.left: Piece | None = None  # where the search gave up
        self.guessed: list[tuple[Ends, ...]] = []
        self.decided: dict[tuple[Ends, ...], bool] = {}

    @cached_property
    def ranges(self) -> Ranges:
        """The ends of both sides on a box, in floats."""
        return range_function(self.names, self.sides, self.definitions)

    def prove(self, leaves: int) -> Proof | None:
        """A proof with at most so many leaves."""
        self.leaves, self.most = 0, min(leaves, self.units // self.cost)
        self.guessed = []
        proof = self._cover(self.root, self.gap(self.root.ends))
        return proof if proof is not None and all(map(self.holds, self.guessed)) else None

    def gap(self, ends: Sequence[Ends]) -> float:
        """A lower bound of rhs - lhs on a box; minus infinity where none is known."""
        self.budget.spend(1 + self.cost // 25)
        try:
            low, high, other, top = self.ranges(*(float_of(end) for pair in ends for end in pair))
        except (ArithmeticError, ValueError):
            return -math.inf
        gap = other - high
        size = abs(other) + abs(high)
        if gap != gap:
            return -math.inf
        if -NEAR * size - TINY <= gap <= UNSURE * (size + UNSURE):
            return 0.0 if self.holds(ends) else -NEAR * size - TINY
        del low, top
        return gap

    def holds(self, ends: Sequence[Ends]) -> bool:
        """Whether the checker will see that the claim holds on a box."""
        box = tuple(ends)
        if box not in self.decided:
            self.budget.spend(self.cost)
            self.decided[box] = self.is_shown(box)
        return self.decided[box]

    def is_shown(self, ends: Sequence[Ends]) -> bool:
        """The same, of a box that is looked at for the first time; this is not counted as work."""
        found = self.exact.of(ends, *self.sides)
        if found is None:
            return False
        (_, high), (low, _) = found
        return holds(self.claim.relation, high, low)

    def _cover(self, box: Piece, gap: float) -> Proof | None:
        if gap >= 0:
            self.leaves += 1
            return self.leaf(box)
        if box.depth >= self.most_cuts or self.leaves >= self.most or not self._may_hold(box):
            self.left = box
            return None
        index, halves = self.best(box)
        hypothesis = f"@{self.hypotheses + box.depth + 1}"
        low_fact, high_fact = box.facts[index]
        sides = zip(halves, ((low_fact, hypothesis), (hypothesis, high_fact)), strict=True)
        parts = (
            (Piece(ends, (*box.facts[:index], facts, *box.facts[index + 1 :]), box.depth + 1), part)
            for (ends, part), facts in sides
        )
        branches = every(self._cover(*part) for part in parts)
        cut = halves[0][0][index][1]
        return None if branches is None else Cuts(symbol(self.names[index]), (cut,), branches)

    def leaf(self, box: Piece) -> Proof:
        """The proof on a box on which the claim seems to hold."""
        self.guessed.append(box.ends)
        return Interval(self.bits, self.bounds(box))

    def bounds(self, box: Piece) -> tuple[tuple[str, str, str], ...]:
        """Each variable with the names of the facts that bound it on a box."""
        named = zip(self.names, box.facts, strict=True)
        return tuple((name, *facts) for name, facts in named if any(facts))

    def _may_hold(self, box: Piece) -> bool:
        """Whether the claim is true at the centre, as far as floats tell."""
        centre = [float_of((low + high) / 2) for low, high in box.ends]
        try:
            low, _, _, top = self.ranges(*(x for x in centre for _ in "lh"))
        except (ArithmeticError, ValueError):
            return True
        return top - low >= -NEAR * (abs(top) + abs(low))

    def best(self, box: Piece) -> tuple[int, Halves]:
        """The variable whose bisection helps most, and its two halves with their gaps."""
        best: tuple[float, Fraction] | None = None
        chosen: tuple[int, Halves] = 0, []
        widest = max(high - low for low, high in box.ends)
        for index, (low, high) in enumerate(box.ends):
            if (high - low) * 4096 < widest and len(box.ends) > 1:
                continue
            halves = self.halves(box, index, _middle(low, high))
            gaps = [min(gap, 0.0) for _, gap in halves]
            score = (sum(gaps) if sum(gaps) > -math.inf else -math.inf, high - low)
            if best is None or score > best:
                best, chosen = score, (index, halves)
        return chosen

    def halves(self, box: Piece, index: int, middle: Fraction) -> Halves:
        """The parts of a box below and above a number in one of its sides."""
        low, high = box.ends[index]
        both = ((low, middle), (middle, high))
        parts = ((*box.ends[:index], side, *box.ends[index + 1 :]) for side in both)
        return [(ends, self.gap(ends)) for ends in parts]


def _middle(low: Fraction, high: Fraction) -> Fraction:
    """A number near the middle: a short one, if both ends are long."""
    middle = (low + high) / 2
    if middle.denominator.bit_length() < 30:
        return middle
    width = high - low
    digits = max(0, 3 - _binary_exponent(width)) if width else 0
    short = Fraction(round(middle * 2**digits), 2**digits)
    return short if low < short < high else middle


def _binary_exponent(value: Fraction) -> int:
    """The integer e with 2^e <= value < 2^(e + 1), for a positive number."""
    found = value.numerator.bit_length() - value.denominator.bit_length()
    return found if value >= Fraction(2) ** found else found - 1


def cost_of(terms: Sequence[Term], definitions: Mapping[str, Term], bits: int) -> int:
    """About the checker's units of work for one evaluation."""
    series = bits // 2
    prices = {
        "rational": 0,
        "symbol": 14,
        **dict.fromkeys(("cos", "cos_pi", "sin"), 8 * (series + 11)),
        **dict.fromkeys(("exp", "log", "atan", "root"), 16 * (series + 18)),
    }
    parts = inner_first(terms, through(definitions))
    powers = sum(14 * part.exponent.bit_length() - 3 for part in parts if part.op == "pow")
    return 30 + powers + sum(prices.get(part.op, 13) for part in parts)
