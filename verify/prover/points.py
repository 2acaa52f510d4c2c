"""Points with simple values at which a claim about all values is false."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from itertools import islice, product
from typing import Any

from verify.language.fold import fails
from verify.prover import balls
from verify.prover.goal import Bounds, Goal
from verify.prover.program import ExactArithmetic, Machine

BITS = 128

#: Denominators that a point is tried at first.
MOST = (1, 2, 3, 4, 6, 10, 12, 60, 100, 1000, 10**4, 10**6, 10**9, 10**12, 10**15, 10**18, 10**22)

#: How many points are tried that mix the candidates, and then how many corners.
MAX_POINTS = 64
#: Longer rational numbers are enclosed.
MAX_EXACT_BITS = 1 << 16
MAX_CORNERS = 64

_FRACTIONS = tuple(map(Fraction, ("1/2", "1/4", "3/4", "1/5", "2/3", "1/7", "9/10", "1/100")))
_POSITIVE = tuple(map(Fraction, ("1", "2", "1/2", "3", "10", "1/10", "7")))
_NUMBERS = tuple(map(Fraction, ("0", "1", "-1", "2", "-3", "10", "-10", "5", "-7", "1/3", "-100")))

Test = Callable[[Sequence[Fraction]], bool]


def refuting_point(goal: Goal, enclose: Callable[[str, int], Any]) -> dict[str, Fraction] | None:
    """A point inside all bounds where enclosures or exact values refute the claim."""
    at_fault = failure_test(goal, enclose)
    candidates = [_candidates(bounds) for bounds in goal.variables.values()]
    for values in _points(candidates):
        if at_fault(values):
            simple = _simplified(values, candidates, at_fault)
            return dict(zip(goal.variables, simple, strict=True))
    return None


def _candidates(bounds: Bounds) -> tuple[Fraction, ...]:
    inside, ends = _inside(bounds), []
    if bounds.low is not None and bounds.low_relation != "<":
        ends.append(bounds.low)
    if bounds.high is not None and bounds.high_relation != "<":
        ends.append(bounds.high)
    return (*ends, *inside)


def _inside(bounds: Bounds) -> tuple[Fraction, ...]:
    low, high = bounds.low, bounds.high
    if low is not None and high is not None:
        return tuple(low + (high - low) * part for part in _FRACTIONS)
    if low is not None:
        return tuple(low + step for step in _POSITIVE)
    if high is not None:
        return tuple(high - step for step in _POSITIVE)
    return _NUMBERS


def _points(candidates: Sequence[Sequence[Fraction]]) -> Iterator[list[Fraction]]:
    """Points that mix the candidates of the variables in many ways, always the same ones.

    Then corners: a claim with < may fail at one of them alone, where it is an equality.
    """
    for attempt in range(MAX_POINTS):
        yield [values[attempt * (i + 1) % len(values)] for i, values in enumerate(candidates)]
    yield from map(list, islice(product(*(values[:2] for values in candidates)), MAX_CORNERS))


def _simplified(
    values: list[Fraction], candidates: Sequence[Sequence[Fraction]], at_fault: Test
) -> list[Fraction]:
    """A point where each value is the first candidate that can take its place."""
    for i, simple in enumerate(candidates):
        for value in simple:
            if value == values[i]:
                break
            simpler = [*values[:i], value, *values[i + 1 :]]
            if at_fault(simpler):
                values = simpler
                break
    return values


def failure_test(goal: Goal, enclose: Callable[[str, int], Any]) -> Test:
    """Whether the claim is false at a point: by exact values, or else by enclosures."""
    relation = goal.claim.relation
    program, sides = goal.program()
    exact = Machine(program, ExactArithmetic(MAX_EXACT_BITS))
    with balls.precision(BITS):
        enclosed = Machine(program, balls.BallArithmetic())
        constants = [enclose(name, BITS) for name in goal.constants]
    unknown = [None] * len(constants)

    def at_fault(values: Sequence[Fraction]) -> bool:
        found = exact.run([*values, *unknown]).values
        a, b = (found[slot] for slot in sides)
        if a is not None and b is not None:
            return fails(relation, a, b)
        with balls.precision(BITS):
            found = enclosed.run([*map(balls.from_fraction, values), *constants]).values
            x, y = (found[slot] for slot in sides)
            return x is not None and y is not None and fails(relation, x, y)

    return at_fault


def simple_points(
    point: Sequence[float],
    bounds: Sequence[tuple[Fraction | None, Fraction | None]],
    *,
    inside: bool = True,
) -> Iterator[list[Fraction]]:
    """Rational points near a point, the simplest first; strictly inside the bounds if asked for."""
    for most in MOST:
        near = [Fraction(x).limit_denominator(most) for x in point]
        if inside:
            near = [_at_end(x, *ends) for x, ends in zip(near, bounds, strict=True)]
            near = [_between(x, *ends, most) for x, ends in zip(near, bounds, strict=True)]
        yield near


def _at_end(value: Fraction, low: Fraction | None, high: Fraction | None) -> Fraction:
    """A bound that the number is next to, or the number."""
    for end in (low, high):
        if end is not None and abs(value - end) * 10**9 <= 1 + abs(end):
            return end
    return value


def _between(value: Fraction, low: Fraction | None, high: Fraction | None, most: int) -> Fraction:
    """The number, or one between the bounds that is not farther from it than need be."""
    width = Fraction(1) if low is None or high is None else high - low
    width = min(width, Fraction(1))
    if low is not None and value <= low:
        return low + width / (2 * most + 1)
    if high is not None and value >= high:
        return high - width / (2 * most + 1)
    return value
