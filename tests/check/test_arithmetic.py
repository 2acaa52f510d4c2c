"""Terms and their enclosures, against exact fractions and mpmath at high precision."""

from __future__ import annotations

import random
from fractions import Fraction
from itertools import product
from typing import Any

import mpmath
import pytest

from tests.check.support import term
from verify import check
from verify.check import Enclosing, Interval, Kernel

F = Fraction
BITS = [2, 8, 53, 64, 200]


def enclosing(bits: int = 64) -> Enclosing:
    return Enclosing(Kernel(), bits, None)


def enclose(text: Any, bits: int = 64) -> Interval:
    kernel = Kernel()
    return Enclosing(kernel, bits, None).enclose(kernel.read("", term(text), kernel.outermost))


def exact(value: mpmath.mpf) -> Fraction:
    """The number itself."""
    sign, man, exp, _ = value._mpf_
    return F(-int(man) if sign else int(man)) * F(2) ** int(exp)


def contains(x: Interval, value: Fraction, slack: int | Fraction = 0) -> bool:
    return x.low - slack <= value <= x.high + slack


def width(x: Interval) -> Fraction:
    return x.high - x.low


@pytest.mark.parametrize("bits", BITS)
@pytest.mark.parametrize("op", ["add", "sub", "mul"])
def test_operations_on_ends(bits: int, op: str) -> None:
    ends = [F(n, 3) for n in (-7, -2, 0, 1, 5)]
    pairs = [Interval(a, b) for a, b in product(ends, ends) if a <= b]
    scope = enclosing(bits)
    exactly = {"add": lambda a, b: a + b, "sub": lambda a, b: a - b, "mul": lambda a, b: a * b}[op]
    for x, y in product(pairs, pairs):
        values = [exactly(a, b) for a in x for b in y]
        assert getattr(scope, op)(x, y) == Interval(min(values), max(values))


def test_quotients() -> None:
    ends = [F(n, 3) for n in (-7, -2, 1, 5)]
    pairs = [Interval(a, b) for a, b in product(ends, ends) if a <= b]
    for x, y in product(pairs, pairs):
        if y.low < 0 < y.high:
            with pytest.raises(check.Refused, match="which contains 0"):
                enclosing().div(x, y)
        else:
            values = [a / b for a in x for b in y]
            assert enclosing().div(x, y) == Interval(min(values), max(values))


@pytest.mark.parametrize("ends", [(0, 1), (-1, 0), (0, 0), (-1, 1)])
def test_a_divisor_whose_end_is_0(ends: tuple[int, int]) -> None:
    with pytest.raises(check.Refused, match="which contains 0"):
        enclosing().div(check.UNIT, Interval(F(ends[0]), F(ends[1])))


@pytest.mark.parametrize("n", [1, 2, 3, 4, 5, 7, 10, 999])
@pytest.mark.parametrize("bits", [8, 200])
def test_powers(n: int, bits: int) -> None:
    ends = [F(k, 7) for k in (-9, -6, 0, 5, 8)]
    for a, b in product(ends, ends):
        if a <= b:
            x = enclosing(bits).power(Interval(a, b), n)
            values = [a**n, b**n] + [F(0)] * (n % 2 == 0 and a < 0 < b)
            assert x.low <= min(values)
            assert max(values) <= x.high
            slack = max(abs(value) for value in [*values, F(1, 10**9)])
            assert min(values) - x.low <= slack * n / 2 ** (bits - 3)
            assert x.high - max(values) <= slack * n / 2 ** (bits - 3)
            assert n % 2 or 0 <= x.low


@pytest.mark.parametrize("bits", BITS)
def test_roots(bits: int) -> None:
    for value in (F(0), F(1), F(4), F(2), F(1, 3), F(10**30, 7), F(1, 10**40), F(9, 16)):
        x = enclosing(bits).sqrt(Interval(value, value))
        assert x.low >= 0
        assert x.low**2 <= value <= x.high**2
        assert width(x) <= F(1, 2**bits)
    assert enclosing(bits).sqrt(Interval(F(4), F(9))) == (2, 3)
    x = enclosing(bits).sqrt(Interval(F(2), F(3)))
    assert x.low**2 <= 2
    assert x.high**2 >= 3
    with pytest.raises(check.Refused, match="which reaches below 0"):
        enclosing(bits).sqrt(Interval(F(-1, 10**9), F(1)))


@pytest.mark.parametrize("bits", [2, 3, 10, 64, 333, 2000])
def test_pi(bits: int) -> None:
    x = enclosing(bits).pi()
    with mpmath.workprec(bits + 100):
        value = exact(+mpmath.pi)
    assert contains(x, value)
    assert width(x) < F(1, 2**bits)
    assert not contains(x, value + F(1, 2**bits))
    assert not contains(x, value - F(1, 2**bits))


def number(text: str) -> mpmath.mpf:
    f = F(text)
    return mpmath.mpf(f.numerator) / f.denominator


@pytest.mark.parametrize("bits", [2, 20, 64, 300])
@pytest.mark.parametrize("op", ["cos", "cos_pi"])
def test_cosines_at_points(bits: int, op: str) -> None:
    values = ["0", "1", "-1", "1/2", "1/3", "2/3", "22/7", "7/5", "-7/5", "100", "-99/7", "8", "9",
              "355/113", "1000001/3", "3/2", "-1/2", "999999999999/7",
              "1/1000000000000"]  # fmt: skip
    for value in values:
        x = enclose([op, value], bits)
        with mpmath.workprec(bits + 300):
            y = number(value) * (mpmath.pi if op == "cos_pi" else 1)
            assert contains(x, exact(mpmath.cos(y)), F(1, 2 ** (bits + 200)))
        assert -1 <= x.low <= x.high <= 1
        size = 1 if op == "cos_pi" else max(1, abs(F(value)))
        assert width(x) <= F(16) * size / 2**bits


@pytest.mark.parametrize("op", ["cos", "cos_pi"])
def test_cosines_on_intervals(op: str) -> None:
    """Sampled points lie within, and the ends are the extremes of the samples, nearly."""
    rng = random.Random(1)
    for _ in range(60):
        a = F(rng.randint(-900, 900), 100)
        b = a + F(rng.choice([0, 1, 5, 20, 90, 150, 210, 350, 800]), 100)
        x = getattr(enclosing(40), op)(Interval(a, b))
        with mpmath.workprec(120):
            cosine = mpmath.cospi if op == "cos_pi" else mpmath.cos
            points = [a + (b - a) * F(i, 400) for i in range(401)]
            values = [exact(cosine(number(str(point)))) for point in points]
        assert x.low <= min(values)
        assert max(values) <= x.high
        assert min(values) - x.low <= F(1, 1000)
        assert x.high - max(values) <= F(1, 1000)


def test_cosines_at_integers_of_pi() -> None:
    scope = enclosing(64)
    for k in range(-5, 6):
        x = scope.cos_pi(Interval(F(k), F(k)))
        assert (-1) ** (k % 2) in (x.low, x.high)
        wide = scope.cos_pi(Interval(F(k) - F(1, 10), F(k) + F(1, 10)))
        assert (wide.high == 1) == (k % 2 == 0)
        assert (wide.low == -1) == (k % 2 == 1)
    assert scope.cos_pi(Interval(F(0), F(1))) == (-1, 1)
    assert scope.cos_pi(Interval(F(1, 2), F(10**9))) == (-1, 1)
    assert scope.cos(Interval(F(10**50), F(10**50))) != (0, 0)


def test_least_and_greatest() -> None:
    x, y, z = Interval(F(0), F(5)), Interval(F(1), F(2)), Interval(F(-1), F(7))
    assert enclosing().least(x, y, z) == (-1, 2)
    assert enclosing().greatest(x, y, z) == (1, 7)


@pytest.mark.parametrize("bits", BITS)
def test_shorter_ends_lie_outside(bits: int) -> None:
    rng = random.Random(2)
    for _ in range(300):
        a = F(rng.randint(-(10**60), 10**60), rng.randint(1, 10 ** rng.choice([1, 30, 90])))
        b = a + F(rng.randint(0, 10**20), rng.randint(1, 10**40))
        x = enclosing(bits).outward(Interval(a, b))
        assert x.low <= a <= b <= x.high
        for inner, outer in zip((a, b), x, strict=True):
            assert abs(inner - outer) <= abs(inner) / 2 ** (bits - 2)
            assert outer == inner or check.size(F(outer.numerator)) <= 600 + 2 * bits


def test_short_ends_stay_as_they_are() -> None:
    x = Interval(F(1, 3), F(2, 3))
    assert enclosing(64).outward(x) == x


TERMS = [
    "1/3 + 2/7 - 5*(2 - 9)/(1 + 3)", "sqrt(2) + sqrt(3)*sqrt(5)", "1/(sqrt(2) - 3/2)",
    "(sqrt(2) - 2)**3", "(sqrt(2) - 2)**4", "min(sqrt(2), 3/2)", "max(sqrt(2), 3/2, 1)",
    "cos(sqrt(2))*cos_pi(1/7)", "-(cos(3)**5)", "cos(100*sqrt(2))",
]  # fmt: skip


@pytest.mark.parametrize("text", TERMS)
def test_terms(text: str) -> None:
    names = {"sqrt": mpmath.sqrt, "min": min, "max": max, "cos": mpmath.cos}
    with mpmath.workprec(600):
        names["cos_pi"] = lambda t: mpmath.cos(mpmath.pi * t)
        import re

        source = re.sub(r"(?<![\w*])(\d+)(?!\w)", r"mpf(\1)", text)
        source = re.sub(r"\*\*mpf\((\d+)\)", r"**\1", source)
        value = exact(eval(source, {"mpf": mpmath.mpf, **names}))
    for bits in (64, 200):
        x = enclose(text, bits)
        assert contains(x, value, F(1, 2**500))
        assert width(x) < F(1, 2 ** (bits - 20))


def test_decimals_and_sizes_in_messages() -> None:
    assert check.decimal(F(0)) == "0"
    assert check.decimal(F(1)) == "100000000000000000000e-20"
    assert check.decimal(F(-1, 3)) == "-333333333333333333334e-21"
    assert check.decimal(F(10) ** 50) == "1000000000000000000000e29"
    assert check.decimal(F(-(2**5000))) == "-2^5000"
    assert check.decimal(F(1, 2**5000)) == "2^-5000"
    assert check.shown("x" * 300) == "x" * 160 + "... (300 characters)"
    assert check.shown("\n") == "'\\n'"


POLYNOMIAL = {((1, 2),): F(1, 2), ((1, 1), (2, 1)): -3, (): 1}
OTHER = {((1, 2),): F(-1, 2), ((2, 3),): 5}


def value(p: Any, x: Fraction, y: Fraction) -> Fraction:
    point = {1: x, 2: y}
    total = F(0)
    for monomial, coefficient in p.items():
        part = F(coefficient)
        for atom, exponent in monomial:
            part *= point[atom] ** exponent
        total += part
    return total


def test_polynomials() -> None:
    kernel = Kernel()
    for x, y in product([F(-2), F(1, 3), F(5)], repeat=2):
        a, b = value(POLYNOMIAL, x, y), value(OTHER, x, y)
        assert value(kernel.plus(POLYNOMIAL, OTHER, 1), x, y) == a + b
        assert value(kernel.plus(POLYNOMIAL, OTHER, -2), x, y) == a - 2 * b
        assert value(kernel.times(POLYNOMIAL, OTHER), x, y) == a * b
        assert value(kernel.power(POLYNOMIAL, 3), x, y) == a**3
    assert kernel.plus(OTHER, OTHER, -1) == {}
    assert kernel.times(OTHER, {}) == kernel.times({}, OTHER) == {}
    assert kernel.times({(): 1, ((1, 1),): 1}, {(): 1, ((1, 1),): -1}) == {(): 1, ((1, 2),): -1}


def test_terms_that_are_equal_are_stored_once() -> None:
    kernel = Kernel()

    def read(text: Any) -> int:
        return kernel.read("", term(text), kernel.outermost)

    assert read("1/2") == read("2/4") != read(["neg", "1"])
    assert read("sqrt(1 + 2)") == read("sqrt(1 + 2)") != read("sqrt(2 + 1)")
    assert read("min(1, 2)") != read("min(2, 1)") != read("max(1, 2)")
    assert read(["pow", "2", "3"]) != read(["pow", "2", "4"]) != read(["pow", "3", "3"])
    assert read("-0") == read("0")
