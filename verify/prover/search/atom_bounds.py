"""Bounds of roots and cosines in a claim, from those of variables: facts for other techniques."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from math import isqrt

from verify.language.terms import Claim, Term, as_term, names_of
from verify.prover.clearing import atoms_of
from verify.prover.goal import Goal
from verify.prover.search.exact import ExactRanges

BITS = 64
#: Bounds have this many digits behind the point, unless they are exact.
DIGITS = 3


def root_bounds(goal: Goal) -> Iterator[Claim]:
    """Claims `low <= atom` and `atom <= high`, where all variables of the atom are bounded."""
    box = {name: bounds.ends for name, bounds in goal.variables.items()}
    ends = {name: pair for name, pair in box.items() if pair is not None}
    terms = goal.claim.lhs, goal.claim.rhs, *goal.definitions.values()
    ranges = ExactRanges([*ends], goal.definitions, BITS)
    for atom in atoms_of(terms, {}):
        names = set(names_of(atom))
        if atom.op not in ("sqrt", "cos", "cos_pi") or not names <= ends.keys():
            continue
        found = ranges.of([*ends.values()], atom.children[0] if atom.op == "sqrt" else atom)
        if found is not None:
            yield from (_bounds if atom.op == "sqrt" else _outward)(atom, *found[0])


def _outward(atom: Term, low: Fraction, high: Fraction) -> Iterator[Claim]:
    scale = 10**DIGITS
    yield Claim("<=", as_term(Fraction(low * scale // 1, scale)), atom)
    yield Claim("<=", atom, as_term(-Fraction(-high * scale // 1, scale)))


def _bounds(root: Term, low: Fraction, high: Fraction) -> Iterator[Claim]:
    if high < 0:
        return  # the root has no value
    above = _floor(high)
    if low > 0:
        yield Claim("<=", as_term(_floor(low)), root)
    step = 0 if above**2 == high else Fraction(1, 10**DIGITS)
    yield Claim("<=", root, as_term(above + step))


def _floor(square: Fraction) -> Fraction:
    """The root, if it is rational; else a decimal below it."""
    exact = Fraction(isqrt(square.numerator), isqrt(square.denominator))
    if exact**2 == square:
        return exact
    scale = 10**DIGITS
    return Fraction(isqrt(square.numerator * scale**2 // square.denominator), scale)
