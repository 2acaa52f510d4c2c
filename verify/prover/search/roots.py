"""Bounds of the roots in a claim, from the bounds of the variables: facts for other techniques."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from math import isqrt

from verify.language.record import TYPE_CHECKING
from verify.language.terms import Claim, Term, as_term
from verify.prover.clearing import atoms_of
from verify.prover.search.exact import ExactRanges

if TYPE_CHECKING:
    from verify.prover.search.strategy import Strategy

BITS = 64
#: Bounds have this many digits behind the point, unless they are exact.
DIGITS = 3


def root_bounds(strategy: Strategy) -> Iterator[Claim]:
    """Claims `low <= root` and `root <= high`, where the radicand lies in an interval."""
    goal = strategy.goal
    box = goal.box
    if box is None:
        return
    terms = goal.claim.lhs, goal.claim.rhs, *goal.definitions.values()
    ranges = ExactRanges([*box], goal.definitions, BITS)
    for atom in atoms_of(terms, {}):
        if atom.op == "sqrt":
            found = ranges.of([*box.values()], atom.children[0])
            if found is not None:
                yield from _bounds(atom, *found[0])


def _bounds(root: Term, low: Fraction, high: Fraction) -> Iterator[Claim]:
    below, above = _floor(low), _floor(high)
    if low > 0:
        yield Claim("<=", as_term(below), root)
    step = 0 if above**2 == high else Fraction(1, 10**DIGITS)
    yield Claim("<=", root, as_term(above + step))


def _floor(square: Fraction) -> Fraction:
    """The root, if it is rational; else a decimal below it."""
    exact = Fraction(isqrt(square.numerator), isqrt(square.denominator))
    if exact**2 == square:
        return exact
    scale = 10**DIGITS
    return Fraction(isqrt(square.numerator * scale**2 // square.denominator), scale)
