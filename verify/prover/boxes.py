"""Claims on a box, by enclosures: on all of it, or on parts into which its sides are cut."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import Any

from verify.language.terms import MAX_INDEX, parts_of, symbol
from verify.prover import balls
from verify.prover.balls import Ball
from verify.prover.budget import WorkBudget
from verify.prover.goal import Bounds, Goal
from verify.prover.program import Machine, UndefinedError
from verify.prover.proof import Proof
from verify.prover.relations import holds
from verify.prover.rules import Cuts, Interval

BallEnds = tuple[Ball, Ball]

BITS = 128

#: More bits for the checker, whose intervals may be a little wider than balls; as many as ground
#: claims get at first, so that it encloses constants once.
CHECKER_BITS = 224

#: A part of the box is the result of at most this many cuts, and there are at most so many parts.
MAX_DEPTH = 16
MAX_PARTS = 2048
#: The work that one of them is.
PART = 100


class Boxes:
    """A claim `<` or `<=` on parts of its box; ``enclose`` encloses a constant by its name."""

    def __init__(
        self, goal: Goal, enclose: Callable[[str, int], Any], budget: WorkBudget | None = None
    ) -> None:
        self._relation, self.parts = goal.claim.relation, 0
        self.budget = budget or WorkBudget()
        program, self._sides = goal.program()
        with balls.precision(BITS):
            self._machine = Machine(program, EndsArithmetic())
            known = (enclose(name, BITS) for name in goal.constants)
            self._constants = [None if ball is None else (ball, ball) for ball in known]

    def holds(self, bounds: Mapping[str, Bounds]) -> bool:
        """Whether the enclosures on a box show the claim."""
        with balls.precision(BITS):
            inputs = [_interval(bound) for bound in bounds.values()]
            values = self._machine.run([*inputs, *self._constants]).values
            x, y = (values[slot] for slot in self._sides)
            return x is not None and y is not None and holds(self._relation, x[1], y[0])

    def cover(self, bounds: Mapping[str, Bounds], depth: int) -> Proof | None:
        """A proof on a box that is the result of so many cuts."""
        self.parts += 1
        self.budget.spend(PART)
        if self.holds(bounds):
            named = ((name, b.low_fact, b.high_fact) for name, b in bounds.items())
            return Interval(CHECKER_BITS, tuple(named))
        if depth == MAX_DEPTH or self.parts >= MAX_PARTS:
            return None
        name = [*bounds][depth % len(bounds)]
        old, hypothesis = bounds[name], f"@{depth + 1}"
        low, high = old.ends or (Fraction(0), Fraction(0))
        cut = (low + high) / 2
        below = {**bounds, name: old._replace(high=cut, high_fact=hypothesis)}
        above = {**bounds, name: old._replace(low=cut, low_fact=hypothesis)}
        branches = []
        for part in (below, above):
            proof = self.cover(part, depth + 1)
            if proof is None:
                return None
            branches.append(proof)
        return Cuts(symbol(name), (cut,), tuple(branches))


def _interval(bounds: Bounds) -> BallEnds:
    low, high = bounds.ends or (Fraction(0), Fraction(0))
    return ends_between(low, high)


def interval(goal: Goal, enclose: Callable[[str, int], Any]) -> Interval | None:
    """A proof by the enclosures on the whole box."""
    if (
        goal.box is None
        or goal.claim.relation == "="
        or not _is_plain(goal)
        or not Boxes(goal, enclose).holds(goal.variables)
    ):
        return None
    named = ((name, b.low_fact, b.high_fact) for name, b in goal.variables.items())
    return Interval(CHECKER_BITS, tuple(named))


def cuts(goal: Goal, enclose: Callable[[str, int], Any], budget: WorkBudget) -> Proof | None:
    """A proof by the enclosures on parts of the box."""
    if goal.box is None or not goal.box or goal.claim.relation == "=" or not _is_plain(goal):
        return None
    return Boxes(goal, enclose, budget).cover(goal.variables, 0)


def _is_plain(goal: Goal) -> bool:
    """False for a product of a term with itself, which the checker takes for one of two numbers."""
    terms = goal.claim.lhs, goal.claim.rhs, *goal.definitions.values()
    return not any(
        part.op == "mul" and part.children[0] == part.children[1] for part in parts_of(*terms)
    )


def ends_between(low: Fraction, high: Fraction) -> BallEnds:
    """The interval between two numbers, at the current precision."""
    return balls.from_fraction(low), balls.from_fraction(high)


class EndsArithmetic:
    """The arithmetic of `verify.prover.program` on intervals."""

    def rational(self, value: Fraction) -> Any:
        """The interval around an exact rational."""
        ball = balls.from_fraction(value)
        return ball, ball

    def operation(self, name: str) -> Callable[..., BallEnds]:
        """The operation of this name."""
        return _OPERATIONS.get(name) or _by_ball(name)


def _add(x: BallEnds, y: BallEnds) -> BallEnds:
    return x[0] + y[0], x[1] + y[1]


def _sub(x: BallEnds, y: BallEnds) -> BallEnds:
    return x[0] - y[1], x[1] - y[0]


def _neg(x: BallEnds) -> BallEnds:
    return -x[1], -x[0]


def _mul(x: BallEnds, y: BallEnds) -> BallEnds:
    (a, b), (c, d) = x, y
    if a >= 0 and c >= 0:
        return a * c, b * d
    if x is y:
        return _square(x)
    ends = a * c, a * d, b * c, b * d
    least = most = ends[0]
    for end in ends[1:]:
        least, most = least.min(end), most.max(end)
    return least, most


def _square(x: BallEnds) -> BallEnds:
    a, b = x[0] * x[0], x[1] * x[1]
    if x[1] <= 0:
        return b, a
    return balls.from_fraction(Fraction(0)), a.max(b)


def _div(x: BallEnds, y: BallEnds) -> BallEnds:
    if not (y[0] > 0 or y[1] < 0):
        raise UndefinedError("a division by an interval that contains 0")
    return _mul(x, (1 / y[1], 1 / y[0]))


def _sqrt(x: BallEnds) -> BallEnds:
    if not x[0] >= 0:
        raise UndefinedError("the square root of an interval that reaches below 0")
    return x[0].sqrt(), x[1].sqrt()


def _min(x: BallEnds, y: BallEnds) -> BallEnds:
    return x[0].min(y[0]), x[1].min(y[1])


def _max(x: BallEnds, y: BallEnds) -> BallEnds:
    return x[0].max(y[0]), x[1].max(y[1])


def _rising(name: str) -> Callable[..., BallEnds]:
    """A function that rises, at both ends."""
    function = balls.BallArithmetic().operation(name)
    return lambda x: (function(x[0]), function(x[1]))


def _by_ball(name: str) -> Callable[..., BallEnds]:
    """An operation on one interval, by the ball around it."""
    function = balls.BallArithmetic().operation(name)

    def enclosed(x: BallEnds) -> BallEnds:
        low, high = balls.ends(function(balls.hull(*x)))
        return ends_between(low, high)

    return enclosed


_OPERATIONS: dict[str, Callable[..., BallEnds]] = {
    "add": _add,
    "sub": _sub,
    "neg": _neg,
    "mul": _mul,
    "div": _div,
    "sqrt": _sqrt,
    "min": _min,
    "max": _max,
    "exp": _rising("exp"),
    "log": _rising("log"),
    "atan": _rising("atan"),
    **{f"root {index}": _rising(f"root {index}") for index in range(2, MAX_INDEX + 1)},
}
