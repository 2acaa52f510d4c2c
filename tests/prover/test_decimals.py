"""Decimal texts enclose what they stand for."""

from __future__ import annotations

import re
from fractions import Fraction

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from verify.prover.decimals import (
    both_ends,
    decimal_exponent,
    decimal_text,
    exact_number,
    outward,
    round_decimal,
    short,
    told_number,
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
        left, right = map(_value, both_ends((low, high)).strip("[]").split(", "))
        assert left <= low < high <= right


def _value(text: str) -> Fraction:
    """What a decimal stands for that people wrote."""
    digits, _, power = text.rpartition("·")
    if not re.fullmatch("10[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+", power):
        return Fraction(text)
    return Fraction(digits or "1") * Fraction(10) ** int(power[2:].translate(_PLAIN))


@pytest.mark.parametrize(
    ("value", "text"), [("3/100", "0.03"), ("1/3", "1/3"), ("1e-14", "10⁻¹⁴"), ("0", "0")]
)
def test_a_rational_exactly(value: str, text: str) -> None:
    assert exact_number(Fraction(value)) == text


@pytest.mark.parametrize(
    ("value", "text"),
    [("583/500", "1.166"), ("5/6", "5/6"), ("3/100", "0.03"), ("1000003/1000007", "0.999996…")],
)
def test_a_rational_as_people_write_it(value: str, text: str) -> None:
    assert told_number(Fraction(value)) == text
