"""Where a claim is most nearly false: local minima of the difference of its sides, estimated."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from operator import gt

from verify.language.terms import Claim, Term, names_of, parts_of
from verify.prover.balls import float_of
from verify.prover.budget import WorkBudget
from verify.prover.goal import Bounds, Goal, definitions_below
from verify.prover.search.compiled import estimates

#: How many starts there are, and how many steps from each.
STARTS = 24
STEPS = 400
#: So many operations on floats take a microsecond.
OPERATIONS = 8
#: A variable without a bound is looked for at first within this distance.
FAR = 4.0

#: How far from 0 variables without bounds are looked for where givens are violated least.
DISTANCES = (4.0, 100.0)
#: What is violated by nothing, but has to be strict.
TINY = 1e-9


class Minima:
    """Points where rhs - lhs is small, the smallest first, among those that satisfy givens."""

    def __init__(
        self,
        goal: Goal,
        budget: WorkBudget,
        givens: Sequence[Claim] = (),
        far: float = FAR,
    ) -> None:
        self.far = far
        names = [*goal.variables]
        terms = [term for claim in (goal.claim, *givens) for term in (claim.lhs, claim.rhs)]
        sides = estimates(names, terms, goal.definitions)
        self.bounds = [_ends(b.low, b.high) for b in goal.variables.values()]
        self.budget, self.cost = budget, _cost(terms, goal.definitions)

        def function(x: Sequence[float]) -> float:
            try:
                a, b, *others = sides(*x)
                if others and any(map(gt, others[::2], others[1::2])):
                    return math.inf
            except (ArithmeticError, ValueError):
                return math.inf
            return b - a if math.isfinite(b - a) else math.inf

        self.function = function

    def found(self) -> list[tuple[float, tuple[float, ...]]]:
        """The local minima, each once."""
        result: list[tuple[float, tuple[float, ...]]] = []
        for start in self._starts():
            value, point = self._descend(start)
            if not (value < math.inf and all(map(math.isfinite, point))):
                continue
            if not any(_near(point, other) for _, other in result):
                result.append((value, point))
        return sorted(result)

    def at_starts(self) -> Iterator[tuple[float, tuple[float, ...]]]:
        """The values where the search starts, with these points, but for those without a value."""
        for start in self._starts():
            value = self.function(start)
            if value < math.inf:
                yield value, tuple(start)

    def _starts(self) -> Iterator[list[float]]:
        """The centre, then points that fill the box."""
        n = len(self.bounds)
        yield [_at(low, high, 0.5, self.far) for low, high in self.bounds]
        for k in range(1, STARTS):
            shares = [(k * _share(i)) % 1.0 for i in range(n)]
            yield [
                _at(*ends, share, self.far) for ends, share in zip(self.bounds, shares, strict=True)
            ]

    def _descend(self, start: list[float]) -> tuple[float, tuple[float, ...]]:
        """Steps along the axes and along what they added up to, shorter and shorter."""
        x, best = list(start), self.function(start)
        steps = [
            (high - low) / 8 if high - low < math.inf else self.far / 8 for low, high in self.bounds
        ]
        small = [step * 1e-9 for step in steps]
        for _ in range(STEPS):
            self.budget.spend(self.cost * len(x))
            before = list(x)
            value = self._around(x, best, steps)
            if value < best:
                best = value
                jump = [
                    self._clip(i, 2 * new - old)
                    for i, (new, old) in enumerate(zip(x, before, strict=True))
                ]
                further = self.function(jump)
                if further < best:
                    x, best = jump, further
            else:
                steps = [step * 0.4 for step in steps]
                if all(step < least for step, least in zip(steps, small, strict=True)):
                    break
        return best, tuple(x)

    def _around(self, x: list[float], best: float, steps: Sequence[float]) -> float:
        """The best of neighbours along the axes, to which x goes."""
        for i, step in enumerate(steps):
            old = x[i]
            for new in (self._clip(i, old + step), self._clip(i, old - step)):
                x[i] = new
                value = self.function(x)
                if value < best:
                    best, old = value, new
                    break
            x[i] = old
        return best

    def _clip(self, i: int, value: float) -> float:
        low, high = self.bounds[i]
        return min(max(value, low), high)


class Violations(Minima):
    """By how much claims are violated: 0 where all of them hold."""

    def __init__(
        self,
        variables: Mapping[str, Bounds],
        claims: Sequence[Claim],
        definitions: Mapping[str, Term],
        budget: WorkBudget,
        far: float,
    ) -> None:
        super().__init__(Goal(claims[0], None, variables, (), definitions), budget, far=far)
        terms = [term for claim in claims for term in (claim.lhs, claim.rhs)]
        sides = estimates([*variables], terms, definitions)
        self.cost = _cost(terms, definitions)
        relations = [claim.relation for claim in claims]

        def function(x: Sequence[float]) -> float:
            try:
                values = sides(*x)
            except (ArithmeticError, ValueError):
                return math.inf
            total = 0.0
            for a, b, relation in zip(values[::2], values[1::2], relations, strict=True):
                if a > b or (relation == "<" and a == b):
                    total += a - b + TINY
                elif not a <= b:
                    return math.inf
                elif relation == "=":
                    total += b - a
            return total

        self.function = function


def _cost(terms: Sequence[Term], definitions: Mapping[str, Term]) -> int:
    """The work of two values of terms: about a microsecond, and one for each few operations."""
    names = definitions_below(names_of(*terms), definitions)
    return 4 + sum(1 for _ in parts_of(*terms, *names.values())) // OPERATIONS


def _ends(low: Fraction | None, high: Fraction | None) -> tuple[float, float]:
    return (
        -math.inf if low is None else float_of(low),
        math.inf if high is None else float_of(high),
    )


def _at(low: float, high: float, share: float, far: float) -> float:
    if high - low < math.inf:
        return low + (high - low) * share
    if low > -math.inf:
        return low + far * share
    return high - far * share if high < math.inf else far * (share - 0.5)


def _share(i: int) -> float:
    """A number whose multiples fill the unit interval: the part of a root behind the point."""
    return math.sqrt((2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37)[i % 12] + i // 12) % 1.0


def _near(a: Sequence[float], b: Sequence[float]) -> bool:
    return all(abs(x - y) <= 1e-5 * (1 + abs(x)) for x, y in zip(a, b, strict=True))
