"""Decimal texts enclose what they stand for."""

from __future__ import annotations

from fractions import Fraction

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from verify.prover.decimals import decimal_exponent, decimal_text, outward, round_decimal, short

settings.register_profile("deterministic", derandomize=True, deadline=None, max_examples=200)
settings.load_profile("deterministic")

fractions = st.builds(
    lambda n, d, e: Fraction(n, d) * Fraction(10) ** e,
    st.integers(-(10**30), 10**30),
    st.integers(1, 10**30),
    st.integers(-400, 400),
)


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
        ("0", "1e-9", "[0, 1e-9]"),
        ("0.99", "1.01", "[0.99, 1.01]"),
        ("1", "2", "[1, 2]"),
    ],
)
def test_short_texts_show_only_common_digits(low: str, high: str, text: str) -> None:
    assert short((Fraction(low), Fraction(high))) == text
