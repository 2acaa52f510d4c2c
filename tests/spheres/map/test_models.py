"""Taylor models contain what exact rationals give, at points of the square of parameters."""

from __future__ import annotations

import random
from collections.abc import Callable
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from verify import check_map
from verify.spheres.map.intervals import Intervals
from verify.spheres.map.models import Models, from_bounds, parameter

SIZE = 120
#: A function, and the same with exact numbers; roots are squared to be compared.
FUNCTIONS: dict[str, Callable[[Any, Any], Any]] = {
    "sum": lambda x, y: x + y - 3,
    "product": lambda x, y: x * y * 3,
    "square": lambda x, y: (x - y) ** 2,
    "quotient": lambda x, y: x / (y + 4),
    "inverse": lambda x, y: 1 / (x * y - 5),
    "mixed": lambda x, y: (x * x - y) / (4 + x * y) * y,
}


def square(seed: int) -> tuple[Intervals, Intervals]:
    rng = np.random.default_rng(seed)
    low = rng.uniform(-1, 1, (2, SIZE))
    width = 10.0 ** rng.uniform(-12, -0.5, (2, SIZE))
    return tuple(Intervals(a, a + b) for a, b in zip(low, width, strict=True))  # type: ignore[return-value]


def value(found: Models, i: int, t: Fraction, u: Fraction) -> tuple[Fraction, Fraction]:
    """The polynomial at a point, and its error."""
    c = [Fraction(float(a)) for a in found.c[:, i]]
    monomials = (Fraction(1), t, u, t * t, t * u, u * u)
    return sum((a * b for a, b in zip(c, monomials, strict=True)), Fraction(0)), Fraction(
        float(found.e[i])
    )


def points(seed: int) -> list[tuple[Fraction, Fraction]]:
    rng = random.Random(seed)
    ends = [Fraction(-1), Fraction(0), Fraction(1)]
    return [(rng.choice([*ends, Fraction(rng.uniform(-1, 1))]), rng.choice(ends)) for _ in range(6)]


def at(x: Models, place: int, i: int, share: Fraction) -> Fraction:
    return Fraction(float(x.c[0, i])) + share * Fraction(float(x.c[1 + place, i]))


@pytest.mark.parametrize("name", FUNCTIONS)
def test_the_exact_value_is_within_the_error(name: str) -> None:
    function = FUNCTIONS[name]
    sides = square(len(name))
    x, y = (parameter(k, side) for k, side in enumerate(sides))
    with np.errstate(all="ignore"):
        found = function(x, y)
    assert (found.e < 1).sum() > SIZE / 2
    for i in range(SIZE):
        for t, u in points(i):
            exact = function(at(x, 0, i, t), at(y, 1, i, u))
            near, error = value(found, i, t, u)
            assert abs(near - exact) <= error
            a, b = at(x, 0, i, t), at(y, 1, i, u)
            inside = sides[0].low[i] <= a <= sides[0].high[i]
            if inside and sides[1].low[i] <= b <= sides[1].high[i]:
                assert found.low[i] <= exact <= found.high[i]


def test_roots() -> None:
    x, y = (parameter(k, side) for k, side in enumerate(square(9)))
    with np.errstate(all="ignore"):
        inside = x * y + x + 3
        found, share = (
            inside.root(),
            (inside * from_bounds(Intervals(*(np.full((2, SIZE), 0.1))))).root_of_share(),
        )
    for i in range(SIZE):
        for t, u in points(i):
            exact = at(x, 0, i, t) * at(y, 1, i, u) + at(x, 0, i, t) + 3
            near, error = value(found, i, t, u)
            assert max(near - error, 0) ** 2 <= exact <= (near + error) ** 2
            near, error = value(share, i, t, u)
            exact *= Fraction(0.1)
            assert max(near - error, 0) ** 2 <= exact <= (near + error) ** 2


def test_a_divisor_that_may_be_0_gives_nothing() -> None:
    x = parameter(0, Intervals(np.array([-1.0]), np.array([1.0])))
    with np.errstate(all="ignore"):
        for found in (1 / x, (x - 2).root()):
            assert not found.low > -np.inf
            assert not found.high < np.inf


#: Operations of the checker, and what they mean; the root is compared by its square.
CHECKED: dict[str, tuple[Callable[..., Any], Callable[[Fraction, Fraction], Fraction]]] = {
    "sum": (lambda k, x, y: k.sub(k.add(x, y), k.neg(x)), lambda a, b: 2 * a + b),
    "product": (lambda k, x, y: k.mul(k.mul(x, y), y), lambda a, b: a * b * b),
    "square": (lambda k, x, y: k.square(k.mul(x, y)), lambda a, b: (a * b) ** 2),
    "quotient": (lambda k, x, y: k.div(x, k.add(k.one, k.mul(x, y))), lambda a, b: a / (1 + a * b)),
    "root": (lambda k, x, y: k.root(k.mul(x, y)), lambda a, b: a * b),
}


@pytest.mark.parametrize("name", CHECKED)
def test_the_models_of_the_checker(name: str) -> None:
    """The same in whole numbers."""
    rng, one = random.Random(name), check_map.ONE
    kind, (function, meaning) = check_map.MODELS, CHECKED[name]
    for _ in range(150):
        lows = [rng.randint(one // 8, 2 * one) for _ in "xy"]
        sides = [(low, low + (one >> rng.randint(4, 90))) for low in lows]
        x, y = (check_map.parameter(kind, k, side) for k, side in enumerate(sides))
        found = function(kind, x, y)
        for t, u in points(rng.randint(0, 99)):
            a, b = ((z[2] + s * z[3 + k]) / one for k, (z, s) in enumerate(((x, t), (y, u))))
            exact, c, e = meaning(a, b), found[2:8], found[8]
            near = c[0] + t * c[1] + u * c[2] + t * t * c[3] + t * u * c[4] + u * u * c[5]
            low, high = (near - e) / one, (near + e) / one
            if name == "root":
                assert max(low, 0) ** 2 <= exact <= high**2
            else:
                assert low <= exact <= high
