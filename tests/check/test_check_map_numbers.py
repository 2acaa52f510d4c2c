"""The arithmetic of the checker of maps: what it says of numbers contains the exact ones.

Intervals are the narrowest ones; of models the error is not larger than what was left out.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator
from fractions import Fraction
from itertools import product
from math import ceil, floor, isqrt
from typing import Any

import pytest

from verify import check_map as m
from verify.check_map import ONE, Interval, Model, RefusedError

F = Fraction
#: The powers of the two parameters that the coefficients of a model belong to.
DEGREES = [(0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2)]


# --- intervals -----------------------------------------------------------------------------------


def intervals(seed: int, count: int) -> Iterator[Interval]:
    """Intervals of all sizes and signs, points and 0 among them."""
    rng = random.Random(seed)
    for _ in range(count):
        ends = [rng.choice((-1, 0, 1, 1)) * rng.getrandbits(rng.randint(1, 110)) for _ in "ab"]
        low, high = sorted(ends if rng.random() < 0.8 else ends[:1] * 2)
        yield low, high


def hull(*values: Fraction) -> Interval:
    """The narrowest interval around numbers of units."""
    return floor(min(values)), ceil(max(values))


def test_intervals_are_the_narrowest_ones() -> None:
    for x, y in zip(intervals(1, 3000), intervals(2, 3000), strict=True):
        assert m.add(x, y) == (x[0] + y[0], x[1] + y[1])
        assert m.sub(x, y) == (x[0] - y[1], x[1] - y[0])
        assert m.mul(x, y) == hull(*(F(a * b, ONE) for a in x for b in y))
        assert m.neg(x) == (-x[1], -x[0])
        ends = [F(a * a, ONE) for a in x]
        assert m.square(x) == hull(*ends, *([F(0)] if x[0] < 0 < x[1] else []))
        if y[0] > 0:
            assert m.div(x, y) == hull(*(F(a * ONE, b) for a in x for b in y))


def test_roots_are_narrow() -> None:
    for x in intervals(3, 1000):
        size = (min(map(abs, x)), max(map(abs, x)))
        tries = [(m.root(size), size)]
        if x[0] <= ONE:
            share = (max(x[0], 0), max(min(x[1], ONE), 0))
            tries.append((m.root_of_share(x), share))
        for found, of in tries:
            assert found[0] ** 2 <= of[0] * ONE < (found[0] + 1) ** 2
            assert (found[1] - 1) ** 2 <= of[1] * ONE < found[1] ** 2
        if x[0] < 0:
            with pytest.raises(RefusedError, match="radicand"):
                m.root(x)
    assert m.root((0, 0)) == (0, 1)


@pytest.mark.parametrize("y", [(0, 1), (-1, 1), (0, 0), (-2, -1), (1, 0), (2, -1)])
def test_no_division_by_what_may_be_0(y: Interval) -> None:
    with pytest.raises(RefusedError, match="divisor"):
        m.div((1, 1), y)
    assert m.div((5, 5), (1, 1)) == (5 * ONE, 5 * ONE)


def test_an_empty_interval_has_no_root() -> None:
    for x in ((-1, 1), (1, -1)):
        with pytest.raises(RefusedError, match="radicand"):
            m.root(x)


@pytest.mark.parametrize("value", [F(1, 3), F(-1, 3), F(0), F(-7, 2), F(10**40, 7)])
def test_what_is_around_a_rational(value: Fraction) -> None:
    assert m.around(value) == hull(value * ONE)
    assert m.number(m.INTERVALS, value) == hull(value * ONE)
    assert m.number(m.MODELS, value)[:2] == hull(value * ONE)
    assert F(m.UNIT[0], ONE) == F(m.UNIT[1], ONE) == 1


def test_numbers_no_less_than_another() -> None:
    assert m.above((-5, 5), 0) == (0, 5)
    assert m.above((1, 5), 0) == (1, 5)
    assert m.above((-5, -3), 0) == (-3, -3)
    assert m.above_model(m.flat((-5, 5)), 2) == (2, 5, 0, 0, 0, 0, 0, 0, 5)


# --- models at points ----------------------------------------------------------------------------

Point = tuple[Fraction, Fraction]


def points(rng: random.Random) -> Point:
    """Parameters in [-1, 1], often at a corner."""
    sides = (F(-1), F(1), F(-1), F(1), F(0), F(rng.randint(-99, 99), 100))
    return rng.choice(sides), rng.choice(sides)


def polynomial(c: tuple[int, ...], at: Point) -> Fraction:
    return F(sum(n * at[0] ** i * at[1] ** j for n, (i, j) in zip(c, DEGREES, strict=True)))


def random_model(rng: random.Random, at: Point, bits: int, c_0: int = 0) -> tuple[Model, Fraction]:
    """A model, and a number of units that it allows at the parameters, mostly at an end."""
    c = [rng.choice((-1, 0, 0, 1)) * rng.getrandbits(rng.randint(1, bits)) for _ in DEGREES]
    c[0] += c_0
    e = rng.choice((0, rng.getrandbits(rng.randint(1, bits))))
    value = polynomial(tuple(c), at) + rng.choice((-1, 0, 1)) * e
    room = [rng.choice((0, 1 << bits, 1 << 120)) for _ in "ab"]
    c0, c1, c2, c3, c4, c5 = c
    return (floor(value) - room[0], ceil(value) + room[1], c0, c1, c2, c3, c4, c5, e), value


def allows(x: Model, at: Point, value: Fraction) -> bool:
    """Whether a number of units is one of the model's."""
    return x[0] <= value <= x[1] and abs(value - polynomial(x[2:8], at)) <= x[8]


def tried(
    name: str, bits: tuple[int, ...] = (2, 8, 60, 96, 100), count: int = 1500, c_0: int = 0
) -> Iterator[tuple[Point, Model, Fraction, Model, Fraction]]:
    """Two models with numbers of theirs at the same parameters."""
    rng = random.Random(name)
    for _ in range(count):
        at = points(rng)
        x, a = random_model(rng, at, rng.choice(bits), c_0)
        yield at, x, a, *random_model(rng, at, rng.choice(bits), c_0)


EXACT: dict[str, tuple[Callable[..., Model], Callable[[Fraction, Fraction], Fraction]]] = {
    "sum": (m.add_models, lambda a, b: a + b),
    "difference": (m.sub_models, lambda a, b: a - b),
    "negative": (lambda x, _: m.neg_model(x), lambda a, _: -a),
    "product": (m.mul_models, lambda a, b: a * b / ONE),
    "square": (lambda x, _: m.square_model(x), lambda a, _: a * a / ONE),
    "flat": (lambda x, _: m.flat(x[:2]), lambda a, _: a),
    "times-a-number": (
        lambda x, y: m.mul_models(x, m.flat(y[:2])),
        lambda a, b: a * b / ONE,
    ),
    "a-number-times": (
        lambda x, y: m.mul_models(m.flat(y[:2]), x),
        lambda a, b: a * b / ONE,
    ),
    "above": (lambda x, _: m.above_model(x, x[0] - 1), lambda a, _: a),
    "above-itself": (lambda x, _: m.above_model(x, x[0]), lambda a, _: a),
}


@pytest.mark.parametrize("name", EXACT)
def test_models_allow_the_exact_numbers(name: str) -> None:
    function, meaning = EXACT[name]
    for at, x, a, y, b in tried(name):
        assert allows(x, at, a)
        assert allows(function(x, y), at, meaning(a, b)), (at, x, a, y, b)


@pytest.mark.parametrize("bits", [60, 88, 93, 95, 96])
def test_quotients_and_roots_allow_the_exact_numbers(bits: int) -> None:
    """The numbers are near 1, or 2, 5 and 1/16: with bounds that are further away."""
    for c_0 in (ONE, 2 * ONE, 5 * ONE, ONE >> 4):
        for at, x, a, y, b in tried(f"{bits} {c_0}", (bits,), 250, c_0):
            if y[0] > 0:
                assert allows(m.div_models(x, y), at, a * ONE / b), (at, x, a, y, b)
            if a >= 0:
                low = (max(x[0], 0), *x[1:])
                assert allows_root(m.root_model(low), at, a)  # type: ignore[arg-type]
                share = min(max(a, F(0)), F(ONE))
                if a == share:
                    assert allows_root(m.root_of_share_model(x), at, share)


def allows_root(x: Model, at: Point, square: Fraction) -> bool:
    """Whether the root of a number of units is one of the model's."""
    big = 1 << 200  # of the root so many digits are enough: its bounds are whole numbers
    return allows(x, at, F(isqrt(floor(square * ONE * big**2)), big))


def test_the_bounds_are_cut_with_the_range() -> None:
    assert m.model((-100, 100), (10, 1, -2, 3, -4, 5), 6) == (-11, 31, 10, 1, -2, 3, -4, 5, 6)
    assert m.model((0, 20), (10, 1, -2, 3, -4, 5), 6) == (0, 20, 10, 1, -2, 3, -4, 5, 6)
    assert m.flat((3, 8)) == (3, 8, 5, 0, 0, 0, 0, 0, 3)


# --- how wide models are -------------------------------------------------------------------------


def graded(x: Model) -> list[tuple[int, tuple[int, int]]]:
    """The coefficients, each with its powers."""
    return list(zip(x[2:8], DEGREES, strict=True))


def pairs_error(x: Model, y: Model) -> Fraction:
    """What a product leaves out: terms of a higher degree, and the errors of the factors."""
    rest = sum(
        abs(p * q)
        for (p, (i, j)), (q, (k, n)) in product(graded(x), graded(y))
        if i + j + k + n > 2
    )
    sizes = [sum(map(abs, z[2:8])) for z in (x, y)]
    return F(rest + sizes[0] * y[8] + sizes[1] * x[8] + x[8] * y[8], ONE)


def test_products_are_no_wider_than_what_they_leave_out() -> None:
    for _, x, _, y, _ in tried("width"):
        c, e = m.product(x, y)
        for (i, j), found in zip(DEGREES, c, strict=True):
            exact = sum(
                p * q
                for (p, (k, n)), (q, (g, h)) in product(graded(x), graded(y))
                if (k + g, n + h) == (i, j)
            )
            assert found == exact >> m.PLACES
        assert pairs_error(x, y) + 6 <= e <= pairs_error(x, y) + 7
        number = m.flat(y[:2])
        for found in (m.mul_models(x, number), m.mul_models(number, x)):
            assert pairs_error(x, number) + 6 <= found[8] <= pairs_error(x, number) + 7


@pytest.mark.parametrize("bits", [20, 60, 80, 92])
def test_quotients_and_roots_leave_out_the_third_power(bits: int) -> None:
    for _, _, _, y, _ in tried(f"third {bits}", (bits,), 300, ONE):
        y = (y[2] - (1 << bits + 3), y[2] + (1 << bits + 3), *y[2:8], 0)
        radius = F(sum(map(abs, y[3:])), ONE)
        least = F(y[2], ONE) - radius
        inverse = m._inverse(y)
        assert inverse is not None
        others = [sum(map(abs, y[3:5])), sum(map(abs, y[5:8]))]
        past = F((2 * others[0] + others[1]) * others[1], ONE**2)
        most = (radius**3 / least**4 + past / least**3) * ONE + 15
        assert inverse[8] <= most
        root = m.root_model(y)
        assert root[8] <= (radius**3 / 15 / least**2 + past / 7 / least) * ONE + 15


def test_far_from_a_number_only_bounds_are_known() -> None:
    """Where the radius is not less than c0."""
    wide = (ONE, 3 * ONE, 2 * ONE, ONE, ONE, 0, 0, 0, 0)
    assert m._inverse(wide) is None
    assert m.div_models(m.flat(m.UNIT), wide) == m.flat(m.div(m.UNIT, wide[:2]))
    assert m.root_model(wide) == m.flat(m.root(wide[:2]))
    less = (*wide[:4], ONE - 1, *wide[5:])
    assert m._inverse(less) is not None
    assert m.root_model(less) != m.flat(m.root(wide[:2]))


def test_a_parameter() -> None:
    for place in (0, 1):
        found = m.parameter(m.MODELS, place, (3, 8))
        assert found == (3, 8, 5, *(3 * (i == place) for i in range(5)), 0)
        assert m.parameter(m.INTERVALS, place, (3, 8)) == (3, 8)


def test_the_two_kinds_have_the_same_operations() -> None:
    """A name stands for the same operation in both, and for no other one."""
    x, y = (ONE // 3, ONE // 2), (ONE // 5, ONE // 4)
    for name, one, other in zip(m.Arithmetic._fields, m.INTERVALS, m.MODELS, strict=True):
        if name == "price":
            assert 1 == one < other
            continue
        if name == "one":
            assert one == other[:2] == (ONE, ONE)
            continue
        more: list[Any] = {"above": [ONE // 4]}.get(name, [])
        arguments = [x] if name in ("square", "neg", "root", "root_of_share") else [x, y]
        arguments = [x] if name == "above" else arguments
        found = one(*arguments, *more)
        bounds = other(*map(m.flat, arguments), *more)[:2]
        assert bounds == found
        assert one.__name__ == name


ONES = (-1,) * 5
FAR = (ONE << 40, 0, 0, 0, 0)


@pytest.mark.parametrize(
    ("c", "e", "f", "off"),
    [
        (ONES, ONE - 1, (0, 1, 0), (1, 0, 0)),  # everything is rounded by nearly a unit
        (FAR, 0, (0, 0, 0), (0, 1, 0)),
        (FAR, 0, (0, 0, 0), (0, 0, 1)),
    ],
)
def test_a_series_allows_for_coefficients_that_are_a_unit_larger(
    c: tuple[int, ...], e: int, f: tuple[int, int, int], off: tuple[int, int, int]
) -> None:
    """At the point where both parameters are 1."""
    found, error = m.series((0, 0, 0, *c, e), f, off, 0)
    t = F(sum(c) + e, ONE)
    exact = sum((F(a + b) * t**i for i, (a, b) in enumerate(zip(f, off, strict=True))), F(0))
    assert abs(exact - sum(found)) <= error


@pytest.mark.parametrize("size", [100, 150, 200])
@pytest.mark.parametrize("part", [0, 1, 3])
def test_roots_of_large_numbers_allow_for_rounded_coefficients(size: int, part: int) -> None:
    """Their coefficients are so small that a unit counts, times something large."""
    for c0 in ((1 << size) + 1, 5 << size, (7 << size) // 3):
        linear = 1 << size // 2
        coefficients = [0] * 5
        coefficients[part] = linear * ONE
        bounds = (c0 - linear) * ONE, (c0 + linear) * ONE
        x = (*bounds, c0 * ONE, *coefficients, 0)
        found = m.root_model(x)  # type: ignore[arg-type]
        middle, slopes, error = found[2], found[3:8], found[8]
        for a, b in product((-1, F(1, 2), 1), repeat=2):
            powers = [a, b, a * a, a * b, b * b]
            exact = (c0 + linear * powers[part]) * ONE
            told = middle + sum(c * p for c, p in zip(slopes, powers, strict=True))
            low = isqrt(floor(exact * ONE))
            assert told - error <= low + 1
            assert low <= told + error
