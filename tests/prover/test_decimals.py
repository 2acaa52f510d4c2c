"""Decimal texts enclose what they stand for."""

from __future__ import annotations

import re
from fractions import Fraction

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from verify.prover.decimals import (
    as_one_or_two,
    both_ends,
    decimal_exponent,
    decimal_text,
    exact_number,
    near_decimal,
    outward,
    round_decimal,
    rounded_inwards,
    short,
    told_apart,
)

settings.register_profile("deterministic", derandomize=True, deadline=None, max_examples=200)
settings.load_profile("deterministic")

fractions = st.builds(
    lambda n, d, e: Fraction(n, d) * Fraction(10) ** e,
    st.integers(-(10**30), 10**30),
    st.integers(1, 10**30),
    st.integers(-400, 400),
)

#: Superscripts, each as the sign that it is.
_PLAIN = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")


@given(fractions, fractions, st.integers(1, 40))
def test_outward_encloses_and_is_tight(a: Fraction, b: Fraction, digits: int) -> None:
    low, high = min(a, b), max(a, b)
    texts = outward((low, high), digits)
    ends = list(map(Fraction, texts))
    assert ends[0] <= low <= high <= ends[1]
    for end, exact in zip(ends, (low, high), strict=True):
        if exact:
            assert abs(end - exact) < Fraction(10) ** (decimal_exponent(exact) - digits + 1)


@given(st.integers(-(10**12), 10**12), st.integers(-40, 40))
def test_a_decimal_text_is_the_number(mantissa: int, exponent: int) -> None:
    assert Fraction(decimal_text(mantissa, exponent)) == mantissa * Fraction(10) ** exponent


@given(fractions.filter(bool))
def test_the_decimal_exponent(value: Fraction) -> None:
    exponent = decimal_exponent(value)
    assert Fraction(10) ** exponent <= abs(value) < Fraction(10) ** (exponent + 1)


@given(fractions)
def test_an_exact_decimal_is_not_changed(value: Fraction) -> None:
    mantissa, exponent = round_decimal(value, 10, up=True)
    rounded = mantissa * Fraction(10) ** exponent
    assert round_decimal(rounded, 10, up=False) == (mantissa, exponent)


@pytest.mark.parametrize(
    ("low", "high", "text"),
    [
        ("1/3", "1/3", "0.33333333…"),
        ("1/4", "1/4", "0.25"),
        ("0.123456789", "0.123456799", "0.1234567…"),
        ("-0.123456799", "-0.123456789", "-0.1234567…"),
        ("-1", "1", "[-1, 1]"),
        ("0", "0", "0"),
        ("0", "1e-9", "[0, 10⁻⁹]"),
        ("0.99", "1.01", "[0.99, 1.01]"),
        ("1", "2", "[1, 2]"),
        ("59e-6", "59e-6", "5.9·10⁻⁵"),
        ("1e-12", "1e-12", "10⁻¹²"),
        ("29573337e-19", "29573338e-19", "2.957333…·10⁻¹²"),
        ("0.1234", "0.1867", "[0.1234, 0.1867]"),
        ("0.12345", "0.1299999", "[0.12345, 0.13]"),
        ("0.999999999", "1.000000001", "[0.999999999, 1.000000001]"),
    ],
)
def test_short_texts_show_only_common_digits(low: str, high: str, text: str) -> None:
    assert short((Fraction(low), Fraction(high))) == text


@given(fractions, fractions)
def test_both_ends_enclose(a: Fraction, b: Fraction) -> None:
    low, high = min(a, b), max(a, b)
    if low < high:
        left, right = shown(both_ends((low, high)))
        assert left <= low < high <= right


def value_of(text: str) -> Fraction:
    """What a decimal stands for that people wrote."""
    digits, _, power = text.rpartition("·")
    if not re.fullmatch("-?10[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+", power):
        return Fraction(text)
    if not digits and text.startswith("-"):
        digits, power = "-1", power[1:]
    return Fraction(digits or "1") * Fraction(10) ** int(power[2:].translate(_PLAIN))


@pytest.mark.parametrize(
    ("value", "text"), [("3/100", "0.03"), ("1/3", "1/3"), ("1e-14", "10⁻¹⁴"), ("0", "0")]
)
def test_a_rational_exactly(value: str, text: str) -> None:
    assert exact_number(Fraction(value)) == text


@given(fractions, st.integers(1, 40))
def test_an_exact_number_is_the_number(value: Fraction, digits: int) -> None:
    text = exact_number(value, digits)
    assert (Fraction(text) if "/" in text else value_of(text)) == value


#: Intervals that are narrow, and intervals that are wide.
intervals = st.builds(
    lambda a, b, n: (min(a, a + b / 10**n), max(a, a + b / 10**n)),
    fractions,
    fractions.filter(bool),
    st.integers(0, 60),
)


@given(intervals, st.integers(1, 12))
def test_what_is_rounded_inwards_is_never_empty_and_says_something(
    ends: tuple[Fraction, Fraction], digits: int
) -> None:
    low, high = map(value_of, rounded_inwards(ends, digits))
    assert ends[0] <= low < high <= ends[1]
    assert high - low >= (ends[1] - ends[0]) * Fraction(9, 10)


def test_no_more_digits_inwards_than_it_takes() -> None:
    third = Fraction(1, 3 * 10**6)
    assert rounded_inwards((1 + third, 1 + 2 * third), 6) == ["1.00000034", "1.00000066"]
    assert rounded_inwards((Fraction("1.083"), Fraction("1.166")), 6) == ["1.083", "1.166"]


def shown(text: str) -> tuple[Fraction, Fraction]:
    """Between which numbers one lies that is shown so."""
    if text.startswith("["):
        low, high = map(value_of, text.strip("[]").split(", "))
        return low, high
    if "±" in text:
        middle, most = map(value_of, text.split(" ± "))
        return middle - most, middle + most
    value = value_of(text.replace("…", ""))
    if "…" not in text:
        return value, value
    digits = text.partition("…")[0]
    power = value / Fraction(digits) if value else Fraction(1)
    unit = power / 10 ** len(digits.partition(".")[2])
    return (value, value + unit) if value >= 0 else (value - unit, value)


#: Enclosures as narrow as those that the program makes, of numbers that may be next to each other.
narrow = st.builds(
    lambda a, b, n, w: tuple(sorted(a * (1 + Fraction(b, 10**n)) * (1 + e) for e in (-w, w))),
    st.sampled_from([Fraction(1), Fraction(-1, 3), Fraction(8, 13), Fraction(99999, 100)]),
    st.integers(-9, 9),
    st.integers(1, 20),
    st.sampled_from([Fraction(0), Fraction(1, 10**27)]),
).filter(lambda ends: ends[0] * ends[1] > 0)


@given(narrow, narrow, st.integers(3, 8))
def test_two_numbers_are_told_apart_where_they_differ(
    a: tuple[Fraction, Fraction], b: tuple[Fraction, Fraction], digits: int
) -> None:
    both = [shown(text) for text in told_apart(a, b, digits)]
    for (low, high), ends in zip(both, (a, b), strict=True):
        assert low <= ends[0] <= ends[1] <= high
    if a[1] < b[0]:
        assert both[0][1] <= both[1][0]
    elif b[1] < a[0]:
        assert both[1][1] <= both[0][0]


@given(narrow, st.integers(-3, 3), st.sampled_from((0, 20, 60)), st.integers(3, 8))
def test_of_numbers_that_look_equal_the_distance_is_said(
    a: tuple[Fraction, Fraction], steps: int, power: int, digits: int
) -> None:
    shift = steps * (a[1] - a[0]) + steps * Fraction(1, 10**power)
    b = a[0] + shift, a[1] + shift
    texts = as_one_or_two(a, b, digits)
    left, right = told_apart(a, b, digits)
    if left == right and left.endswith("…"):
        assert len(texts) == 1
    if len(texts) == 2:
        assert texts == (left, right)
        return
    one = texts[0]
    common, *said = re.split(r", at least | and at most |, at most | apart|, exactly equal", one)
    low, high = shown(common)
    assert low <= min(a[0], b[0]) <= max(a[1], b[1]) <= high
    bounds = [value_of(text) for text in said if text]
    near, far = max(b[0] - a[1], a[0] - b[1], 0), max(b[1] - a[0], a[1] - b[0])
    assert bounds[:-1] == [] or 0 < bounds[0] <= near
    assert far <= (bounds[-1] if bounds else 0) <= 2 * far


@pytest.mark.parametrize(
    ("left", "right", "text"),
    [
        (("0.00111", "0.00111"), ("0.00111", "0.00111"), ""),
        (("1/3", "1/3"), ("1/3", "1/3"), "0.33333333…, exactly equal"),
        (
            ("0.001109999999999999999999999999", "0.001110000000000000000000000001"),
            ("0.00111", "0.00111"),
            "0.00111 ± 10⁻³⁰, at most 10⁻³⁰ apart",
        ),
        (("0.1", "0.3"), ("0.2", "0.4"), ""),
        (("0.1", "0.2"), ("0.3", "0.4"), ""),
        (
            (f"0.3{'1' * 60}", f"0.3{'1' * 60}"),
            (f"0.3{'1' * 59}2", f"0.3{'1' * 59}2"),
            "0.31111111…, at least 10⁻⁶¹ and at most 10⁻⁶¹ apart",
        ),
    ],
)
def test_where_no_digits_tell(left: tuple[str, str], right: tuple[str, str], text: str) -> None:
    numbers = tuple(map(Fraction, left)), tuple(map(Fraction, right))
    assert as_one_or_two(*numbers) == ((text,) if text else told_apart(*numbers))


def test_digits_are_added_until_a_difference_is_seen() -> None:
    one, more = Fraction(1), 1 + Fraction(1, 10**11)
    assert told_apart((one, one), (more, more)) == ("1", "1.00000000001")
    c, bound = Fraction(8, 13), Fraction(8, 13) + Fraction(1, 10**15)
    assert told_apart((c, c), (bound, bound)) == ("0.615384615384615…", "0.615384615384616…")


@pytest.mark.parametrize(
    ("low", "high", "near", "text"),
    [
        ("0.0999999999999999999999999999", "0.1000000000000000000000000001", "0.1", "0.1 ± 10⁻²⁸"),
        ("-2.5000000000000000000000000001", "-2.5", "-2.5", "-2.5000000…"),
        ("0.09999", "0.10001", None, "[0.09999, 0.10001]"),
        ("0.1", "0.1", None, "0.1"),
        ("-1e-30", "1e-30", None, "[-10⁻³⁰, 10⁻³⁰]"),
    ],
)
def test_a_short_decimal_is_no_interval(low: str, high: str, near: str | None, text: str) -> None:
    ends = Fraction(low), Fraction(high)
    assert near_decimal(ends) == (None if near is None else Fraction(near))
    assert short(ends) == text


SHORT = st.builds(
    lambda n, e: n * Fraction(10) ** e, st.integers(-(10**12), 10**12), st.integers(-30, 20)
)


@given(SHORT | fractions, st.integers(20, 30), st.integers(0, 9), st.integers(0, 9))
def test_a_near_decimal_is_found(number: Fraction, places: int, down: int, up: int) -> None:
    """All decimals of twelve digits beside an enclosure are tried."""
    width = abs(number) / 10**places
    low, high = number - down * width, number + up * width
    size = max(abs(low), abs(high))
    found = []
    if 0 < (high - low) * 10**24 <= size:
        unit = Fraction(10) ** (decimal_exponent(size) - 11)
        least = low // unit
        found = [n * unit for n in range(least, least + 3) if low <= n * unit <= high]
    assert near_decimal((low, high)) == (found[0] if found else None)
    assert len(found) <= 1
