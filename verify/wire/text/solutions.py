"""Where the sides of a claim are equal, as exact values of one variable, and numbers between."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import pairwise
from math import isqrt

from verify.language.fold import BOUNDED, MissingOperationError, fold
from verify.language.terms import Claim, Term, as_term, nth_root, sqrt, substitute, symbol
from verify.wire.text.estimates import estimate, simplest

#: Roots of a larger index are no candidates.
MOST_INDEX = 20


def equal(name: str, claims: Sequence[Claim], found: Mapping[str, Term]) -> Iterator[Term]:
    """The values of a variable at which the sides of one of the claims are equal."""
    for claim in claims:
        yield from _solutions(name, claim, found)


def _solutions(name: str, claim: Claim, found: Mapping[str, Term]) -> Iterator[Term]:
    """The values of a variable at which the sides are equal, if they differ by a square or less.

    And the root if that is a multiple of a power of the variable and a number.
    """
    gap = substitute(claim.lhs - claim.rhs, found)

    def at(value: int) -> Fraction:
        return fold(gap, BOUNDED, {symbol(name): Fraction(value)})

    try:
        zero, one, two, three = map(at, range(4))
    except (ArithmeticError, MissingOperationError):
        return
    a = (two - 2 * one + zero) / 2
    b = one - zero - a
    if three - 3 * two + 3 * one - zero:
        yield from _roots(zero, one - zero, two - zero, three - zero)
        return
    if not a:
        if b:
            yield as_term(-zero / b)
    elif b * b >= 4 * a * zero:
        middle, square = -b / (2 * a), (b * b - 4 * a * zero) / (4 * a * a)
        roots = (isqrt(square.numerator), isqrt(square.denominator))
        is_square = Fraction(*roots) ** 2 == square
        distance = as_term(Fraction(*roots)) if is_square else sqrt(square)
        for root in (distance, -distance):
            yield as_term(middle) + root if middle else root


def _roots(number: Fraction, *gaps: Fraction) -> Iterator[Term]:
    """Where a x^n + number is 0 for an n > 2, if that is what a x^n is at 1, 2 and 3."""
    a, two, three = gaps
    n = next((n for n in range(3, MOST_INDEX) if (two, three) == (a * 2**n, a * 3**n)), 0)
    if a and number and n:
        root = nth_root(as_term(abs(number / a)), n)
        if number / a < 0:
            yield root
        if (number / a > 0) == bool(n % 2):
            yield -root


def between(name: str, claims: Sequence[Claim], found: Mapping[str, Term]) -> Iterator[Term]:
    """Numbers between the values at which the sides of inequalities are equal, and beyond them."""
    ends = {estimate(end, {}) for end in equal(name, claims, found)}
    ordered = sorted(filter(math.isfinite, ends))
    if ordered:
        yield as_term(math.ceil(ordered[-1]) + 1)
        yield as_term(math.floor(ordered[0]) - 1)
        yield from (as_term(simplest(*pair)) for pair in pairwise(ordered))
