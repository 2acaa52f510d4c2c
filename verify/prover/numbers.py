"""Rational numbers: FLINT's, Python's, and floats near them."""

from __future__ import annotations

import math
from fractions import Fraction

from flint import fmpq


def float_of(value: fmpq | Fraction) -> float:
    """The nearest float, or about that; an infinite one beyond the largest."""
    top, bottom = (value.p, value.q) if isinstance(value, fmpq) else value.as_integer_ratio()
    try:
        return int(top) / int(bottom)
    except OverflowError:
        return math.inf if top > 0 else -math.inf


def fmpq_of(value: Fraction | float) -> fmpq:
    """The same number for FLINT."""
    value = Fraction(value)
    return fmpq(value.numerator, value.denominator)


def fraction_of(value: fmpq) -> Fraction:
    """The same number for Python."""
    return Fraction(int(value.p), int(value.q))
