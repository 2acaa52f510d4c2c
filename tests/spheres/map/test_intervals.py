"""Arrays of intervals contain what exact rationals give, at every operation and rounding."""

from __future__ import annotations

import random
from collections.abc import Callable
from fractions import Fraction
from math import inf, isqrt, nextafter

import numpy as np
import pytest

from verify.spheres.map.intervals import Intervals, enclosed, square_root

#: Doubles around which rounding is special.
EDGES = (0.0, -0.0, 1.0, -1.0, 5e-324, -5e-324, 2.0**-1022, 1 + 2.0**-52, 0.1, 3.0, 1e154, 1e-160)
SIZE = 1500


def doubles(rng: random.Random) -> float:
    if rng.random() < 0.3:
        return rng.choice(EDGES)
    return rng.uniform(-1, 1) * 2.0 ** rng.randint(-60, 60)


def intervals(seed: int) -> Intervals:
    rng = random.Random(seed)
    pairs = [sorted((doubles(rng), doubles(rng))) for _ in range(SIZE // 2)]
    pairs += [[x, x] for x in (doubles(rng) for _ in range(SIZE // 2))]
    low, high = np.array(pairs).T
    return Intervals(low, high)


def holds(found: Intervals, exact: list[Fraction], *inputs: Intervals) -> int:
    count = 0
    for i, value in enumerate(exact):
        low, high = float(found.low[i]), float(found.high[i])
        if low != low or high != high:
            continue
        count += 1
        assert low == -inf or Fraction(low) <= value, inputs
        assert high == inf or value <= Fraction(high), inputs
    return count


OPERATIONS: dict[str, Callable[..., object]] = {
    "+": lambda x, y: x + y,
    "-": lambda x, y: x - y,
    "*": lambda x, y: x * y,
    "/": lambda x, y: x / y,
}


@pytest.mark.parametrize("name", OPERATIONS)
def test_the_exact_value_of_ends_lies_inside(name: str) -> None:
    operation = OPERATIONS[name]
    x, y = intervals(1), intervals(2)
    with np.errstate(all="ignore"):
        found = operation(x, y)
    assert isinstance(found, Intervals)
    ends = ((a, b) for a in (x.low, x.high) for b in (y.low, y.high))
    for a, b in ends:
        pairs = [(Fraction(float(s)), Fraction(float(t))) for s, t in zip(a, b, strict=True)]
        exact = [operation(s, t) if name != "/" or t else Fraction(0) for s, t in pairs]
        # Where the divisor may be 0 there is no interval; elsewhere there always is one.
        assert holds(found, exact) == SIZE - int(np.isnan(found.low).sum())  # type: ignore[arg-type]
    if name == "/":
        assert np.array_equal(np.isnan(found.low), (y.low <= 0) & (y.high >= 0))


def test_squares_and_roots() -> None:
    x = intervals(3)
    square = x**2
    for end in (x.low, x.high):
        holds(square, [Fraction(float(a)) ** 2 for a in end])
    assert (square.low >= 0).all()
    assert (square.low[(x.low <= 0) & (x.high >= 0)] == 0).all()
    with np.errstate(all="ignore"):
        found = square_root(x)
    assert np.isnan(found.low[x.low < 0]).all() or (found.low[x.low < 0] == 0).all()
    for i in np.flatnonzero(x.low >= 0):
        low, high = Fraction(float(found.low[i])), Fraction(float(found.high[i]))
        assert low**2 <= Fraction(float(x.low[i]))
        assert Fraction(float(x.high[i])) <= high**2


def test_a_root_of_what_may_be_negative_is_no_bound() -> None:
    with np.errstate(all="ignore"):
        found = square_root(Intervals(np.array([-1.0, -1.0]), np.array([4.0, -0.5])))
        share = Intervals(np.array([-1.0, 0.25]), np.array([4.0, 0.25])).root_of_share()
    assert not (found.low > -1).any()
    assert share.low[0] == 0
    assert share.high[0] >= 1
    assert isqrt(25) == 5
    assert share.low[1] <= 0.5 <= share.high[1]


def test_not_a_number_proves_nothing() -> None:
    nothing = Intervals(np.array([1.0]), np.array([2.0])) / Intervals(
        np.array([-1.0]), np.array([1.0])
    )
    for found in (nothing, nothing + 1, nothing * nothing, nothing**2, -nothing, 1 - nothing):
        assert not found.low > -inf
        assert not found.high < inf


def test_overflow_is_no_bound() -> None:
    with np.errstate(all="ignore"):
        huge = Intervals(np.array([1e308]), np.array([1e308])) * 10
    assert huge.low <= nextafter(inf, 0)
    assert huge.high == inf


@pytest.mark.parametrize("text", ["0", "1/3", "3/100", "0.1", "-7/9", "1e-30", "1048577/1048576"])
def test_rationals_are_enclosed(text: str) -> None:
    found = enclosed(Fraction(text))
    assert Fraction(float(found.low)) <= Fraction(text) <= Fraction(float(found.high))
    assert found.high <= nextafter(nextafter(found.low, inf), inf)
