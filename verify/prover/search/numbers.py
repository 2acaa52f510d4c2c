"""Rational numbers: FLINT's, Python's, and floats near them."""

from __future__ import annotations

from fractions import Fraction

from flint import fmpq


def float_of(value: fmpq) -> float:
    """The nearest float, or about that."""
    return int(value.p) / int(value.q)


def fmpq_of(value: Fraction | float) -> fmpq:
    """The same number for FLINT."""
    value = Fraction(value)
    return fmpq(value.numerator, value.denominator)


def fraction_of(value: fmpq) -> Fraction:
    """The same number for Python."""
    return Fraction(int(value.p), int(value.q))
