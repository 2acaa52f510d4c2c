"""Intervals contain the results for the numbers in them: exact or high-precision values."""

from __future__ import annotations

from fractions import Fraction
from math import isqrt

import mpmath
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from verify.check import MAX_SIZE, OPERATIONS, Interval, Refused, Scope, Terms

derandomised = settings(derandomize=True, max_examples=150, deadline=None, database=None)

exponents = st.one_of(
    st.integers(-40, 40), st.sampled_from([-13300, -4000, -1000, 1000, 4000, 13300])
)
numbers = st.builds(
    lambda n, d, e: Fraction(n, d) * Fraction(2) ** e,
    st.one_of(st.integers(-(10**6), 10**6), st.integers(-(2**200), 2**200)),
    st.integers(1, 10**6),
    exponents,
)
parts = st.one_of(st.sampled_from([Fraction(0), Fraction(1)]), st.fractions(0, 1))
precisions = st.sampled_from([2, 3, 24, 64, 128, 300])


@st.composite
def points_in_intervals(draw: st.DrawFn, values: st.SearchStrategy = numbers) -> tuple:
    """An interval, perhaps of zero width, and a number in it."""
    low = draw(values)
    high = low if draw(st.booleans()) else draw(values)
    low, high = min(low, high), max(low, high)
    return low + (high - low) * draw(parts), (low, high)


def scope(bits: int) -> Scope:
    return Terms().scope(bits, {})


def result(bits: int, op: str, *args: Interval | int) -> Interval:
    """An operation as `Scope.enclose` does it: rounded outward."""
    here = scope(bits)
    return here.outward(OPERATIONS[op](here, *args))


EXACT = {
    "add": lambda a, b: a + b,
    "sub": lambda a, b: a - b,
    "mul": lambda a, b: a * b,
    "min": min,
    "max": max,
}


@pytest.mark.parametrize("op", EXACT)
@derandomised
@given(points_in_intervals(), points_in_intervals(), precisions)
def test_two_arguments(op: str, first: tuple, second: tuple, bits: int) -> None:
    (a, x), (b, y) = first, second
    low, high = result(bits, op, x, y)
    assert low <= EXACT[op](a, b) <= high


@derandomised
@given(points_in_intervals(), points_in_intervals(), precisions)
def test_division(first: tuple, second: tuple, bits: int) -> None:
    (a, x), (b, y) = first, second
    if y[0] <= 0 <= y[1]:
        with pytest.raises(Refused, match="which contains 0"):
            result(bits, "div", x, y)
    else:
        low, high = result(bits, "div", x, y)
        assert low <= a / b <= high


@pytest.mark.parametrize(
    ("low", "high"), [(0, 0), (0, 1), (-1, 0), (-1, 1), (0, Fraction(1, 10**4000))]
)
def test_division_by_zero_is_an_error(low: Fraction, high: Fraction) -> None:
    with pytest.raises(Refused):
        result(64, "div", (Fraction(1), Fraction(1)), (Fraction(low), Fraction(high)))


@derandomised
@given(points_in_intervals(), precisions)
def test_negation(first: tuple, bits: int) -> None:
    a, x = first
    low, high = result(bits, "neg", x)
    assert low <= -a <= high


@derandomised
@given(points_in_intervals(), st.integers(1, 12), precisions)
def test_powers(first: tuple, n: int, bits: int) -> None:
    a, x = first
    low, high = result(bits, "pow", x, n)
    assert low <= a**n <= high
    if n % 2 == 0:
        assert low >= 0


@derandomised
@given(points_in_intervals(numbers.map(abs)), precisions)
def test_square_roots(first: tuple, bits: int) -> None:
    a, x = first
    low, high = result(bits, "sqrt", x)
    assert 0 <= low
    assert low * low <= a <= high * high


@derandomised
@given(numbers.map(abs), precisions)
def test_square_roots_are_close(a: Fraction, bits: int) -> None:
    low, high = result(bits, "sqrt", (a, a))
    assert (high - low) * Fraction(2) ** (bits - 3) <= high


@derandomised
@given(st.fractions(0, 10**9))
def test_square_roots_of_squares_are_exact(a: Fraction) -> None:
    assert scope(64).sqrt((a * a, a * a)) == (a, a)


@pytest.mark.parametrize("low", [-1, Fraction(-1, 10**4000)])
def test_square_root_of_a_negative_number_is_an_error(low: Fraction) -> None:
    with pytest.raises(Refused, match="below 0"):
        result(64, "sqrt", (Fraction(low), Fraction(1)))


def precise(value: Fraction) -> mpmath.mpf:
    return mpmath.mpf(value.numerator) / value.denominator


def encloses(ends: Interval, value: mpmath.mpf) -> bool:
    error = mpmath.mpf(10) ** -200
    return precise(ends[0]) - error <= value <= precise(ends[1]) + error


@pytest.mark.parametrize("bits", [2, 30, 64, 128, 400])
@pytest.mark.parametrize(
    "text",
    ["0", "1", "-1", "29/10", "2.9", "3.14159265358979", "22/7", "1e-300", "7.999", "-8", "8"],
)
def test_cosine(text: str, bits: int) -> None:
    a = Fraction(text)
    low, high = result(bits, "cos", (a, a))
    with mpmath.workdps(230):
        assert encloses((low, high), mpmath.cos(precise(a)))
    assert -1 <= low <= high <= 1
    assert (high - low) * Fraction(2) ** (bits - 8) <= 1


@derandomised
@given(points_in_intervals(st.fractions(-8, 8)), precisions)
def test_cosine_of_intervals(first: tuple, bits: int) -> None:
    a, x = first
    with mpmath.workdps(230):
        assert encloses(result(bits, "cos", x), mpmath.cos(precise(a)))


@pytest.mark.parametrize("text", ["8.0001", "-8.0001", "100", "1e4000"])
def test_cosine_of_a_large_argument_is_an_error(text: str) -> None:
    for ends in ((text, text), (min(text, "0"), max(text, "0"))):
        with pytest.raises(Refused, match=r"^found a cosine of .*, which reaches beyond 8"):
            result(64, "cos", (Fraction(ends[0]), Fraction(ends[1])))


@pytest.mark.parametrize("bits", [2, 30, 64, 128, 400])
@pytest.mark.parametrize(
    "text",
    ["0", "1", "1/2", "-1/2", "5/6", "2/3", "7/4", "2", "-1", "-7/3", "1000001/3", "1e-300", "3/2"],
)
def test_cosine_of_multiples_of_pi(text: str, bits: int) -> None:
    a = Fraction(text)
    low, high = result(bits, "cos_pi", (a, a))
    with mpmath.workdps(230):
        assert encloses((low, high), mpmath.cospi(precise(a)))
    assert -1 <= low <= high <= 1
    assert (high - low) * Fraction(2) ** (bits - 8) <= 1


@pytest.mark.parametrize("bits", [2, 10, 64, 1000])
def test_pi(bits: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Scope, "cos", lambda _, x: x)
    low, high = scope(bits).cos_pi((Fraction(1), Fraction(1)))
    with mpmath.workdps(400):
        assert precise(low) < mpmath.pi < precise(high)
    assert (high - low) * Fraction(2) ** (bits + 16) <= 1
    assert scope(bits).cos_pi((Fraction(7), Fraction(7))) == (low, high)


@derandomised
@given(points_in_intervals(st.fractions(-50, 50)), precisions)
def test_cosine_of_multiples_of_intervals(first: tuple, bits: int) -> None:
    a, x = first
    try:
        ends = result(bits, "cos_pi", x)
    except Refused:
        assert (x[1] - x[0]) > Fraction(1, 2)
        return
    with mpmath.workdps(230):
        assert encloses(ends, mpmath.cospi(precise(a)))


@derandomised
@given(points_in_intervals(), precisions, st.sampled_from([0, 32]))
def test_rounding_is_outward_and_close(first: tuple, bits: int, more: int) -> None:
    _, (low, high) = first
    down, up = scope(bits).outward((low, high), more)
    assert down <= low <= high <= up
    assert (low - down) * 2 ** (bits + more - 1) <= abs(low)
    assert (up - high) * 2 ** (bits + more - 1) <= abs(high)


@derandomised
@given(numbers, precisions)
def test_rounded_numbers_are_short(a: Fraction, bits: int) -> None:
    for end in scope(bits).outward((a, a)):
        odd = end.numerator // (end.numerator & -end.numerator or 1)
        assert end == a or odd.bit_length() <= bits + 1


def test_short_numbers_are_not_rounded() -> None:
    a = Fraction(2**63 - 1, 2**63 + 1)
    assert scope(64).outward((a, a)) == (a, a)
    a = Fraction(2**64 - 1, 2**63 + 1)
    assert scope(64).outward((a, a)) == (a, a)
    b = Fraction(2**64 + 1, 2**64 - 1)
    assert scope(64).outward((b, b)) != (b, b)


def test_numbers_of_too_many_bits_are_an_error() -> None:
    for a in (Fraction(1, 1 << MAX_SIZE), Fraction(1 << MAX_SIZE)):
        with pytest.raises(Refused):
            scope(64).outward((a, a))
    a = Fraction(1 << (MAX_SIZE - 2))
    assert scope(64).outward((a, a)) == (a, a)


def test_a_power_cannot_grow_without_end() -> None:
    a = Fraction(2) ** 20000
    with pytest.raises(Refused):
        result(64, "pow", (a, a), 999)


def test_isqrt_is_a_floor() -> None:
    assert [isqrt(n) for n in (0, 1, 3, 4, 8)] == [0, 1, 1, 2, 2]
