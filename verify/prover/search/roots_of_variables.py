"""Quotients of polynomials in a variable and a root of it, between bounds of the variable.

With s for the root of index n they are polynomials in s, as x = s^n, and s has bounds as x has.
"""

from __future__ import annotations

from fractions import Fraction
from math import comb

from flint import fmpq_mpoly

from verify.language.terms import Claim, Term, as_term
from verify.prover.balls import fraction_of
from verify.prover.clearing import ROOTS, Clearing, index_of
from verify.prover.goal import Bounds
from verify.prover.proof import Proof, Value, power_of, product_of, sum_of
from verify.prover.rules import Have, Sum
from verify.prover.search.laws import between

#: A root of a bound is a fraction with this denominator, if it is no simpler one.
FINE = 10**6
#: Degrees are raised so often, in Bernstein's form.
MAX_RAISED, MAX_DEGREE = 6, 60


def in_root(
    claim: Claim, x: Term, bounds: Bounds, clearing: Clearing, p: fmpq_mpoly, hypotheses: int
) -> Proof | None:
    """A proof, where p is the difference of the sides, and so many hypotheses are known."""
    root = next((atom for atom in clearing.atoms if atom.op in ROOTS), None)
    if root is None or {*clearing.atoms} != {x, root} or root.children[0] != x:
        return None
    numbers = _in_powers(p, clearing, x, root)
    if not numbers or len(numbers) > MAX_DEGREE:
        return None
    lowest = next(i for i, number in enumerate(numbers) if number)
    low = _low(bounds.low, index_of(root))
    high = None if bounds.high is None else _high(bounds.high, index_of(root))
    numbers, is_strict = numbers[lowest:], claim.relation == "<"
    if is_strict and lowest:
        return None
    least, greatest = f"@{hypotheses + 1}", f"@{hypotheses + 2}"
    if high is None:
        values = _above(numbers, low, least, is_strict=is_strict)
    else:
        values = _between_ends(numbers, (low, high), (least, greatest), is_strict=is_strict)
    if values is None:
        return None
    power = [power_of(("root", root), lowest)] if lowest else []
    proof: Proof = Sum(("goal", product_of(*power, sum_of(*values))))
    if high is not None:
        proof = Have(Claim("<=", root, as_term(high)), (_upper(root, high, bounds), proof))
    return Have(Claim("<=", as_term(low), root), (_lower(root, low, bounds), proof))


def _in_powers(p: fmpq_mpoly, clearing: Clearing, x: Term, root: Term) -> list[Fraction]:
    """The coefficients of a polynomial in x and its root, in powers of the root."""
    found: dict[int, Fraction] = {}
    i, j = clearing.atoms.index(x), clearing.atoms.index(root)
    for powers, value in p.to_dict().items():
        degree = int(powers[i]) * index_of(root) + int(powers[j])
        found[degree] = found.get(degree, Fraction(0)) + fraction_of(value)
    found = {degree: value for degree, value in found.items() if value}
    return [found.get(k, Fraction(0)) for k in range(max(found, default=-1) + 1)]


def _low(number: Fraction | None, index: int) -> Fraction:
    """A number whose power is at most this one, and 0 at least."""
    if number is None or number <= 0:
        return Fraction(0)
    near = Fraction(float(number) ** (1 / index)).limit_denominator(100)
    if near**index == number:
        return near
    return max(Fraction(0), Fraction(int(float(number) ** (1 / index) * FINE) - 2, FINE))


def _high(number: Fraction, index: int) -> Fraction:
    """A number whose power is at least this one, which is not negative."""
    value = float(max(number, Fraction(0))) ** (1 / index)
    near = Fraction(value).limit_denominator(100)
    return near if near**index == number else Fraction(int(value * FINE) + 2, FINE)


def _lower(root: Term, low: Fraction, bounds: Bounds) -> Sum:
    """The proof that a root is at least a number, as its power is at least the power."""
    if low == 0 or bounds.low is None:
        return Sum(("goal", ("root", root)))
    index = index_of(root)
    rest = str(bounds.low - low**index)
    return Sum((*between(index, ("root", root)), bounds.low_fact, rest))


def _upper(root: Term, high: Fraction, bounds: Bounds) -> Sum:
    """The proof that a root is at most a number."""
    index = index_of(root)
    rest = str(high**index - (bounds.high or Fraction(0)))
    return Sum((*between(index, str(high)), bounds.high_fact, rest))


def _above(
    numbers: list[Fraction], low: Fraction, fact: str, *, is_strict: bool
) -> list[Value] | None:
    """A polynomial whose coefficients around a number are not negative."""
    shifted = [
        sum((c * comb(k, j) * low ** (k - j) for k, c in enumerate(numbers) if k >= j), Fraction(0))
        for j in range(len(numbers))
    ]
    if any(value < 0 for value in shifted) or (is_strict and not shifted[0]):
        return None
    return [
        product_of(str(value), power_of(fact, j)) if j else str(value)
        for j, value in enumerate(shifted)
        if value
    ]


def _to(last: int, length: int) -> range:
    return range(min(last + 1, length))


def _between_ends(
    numbers: list[Fraction],
    ends: tuple[Fraction, Fraction],
    facts: tuple[str, str],
    *,
    is_strict: bool,
) -> list[Value] | None:
    """A polynomial whose Bernstein coefficients are not negative."""
    low, high = ends
    if low >= high:
        return None
    width = high - low
    around = [
        sum((c * comb(k, j) * low ** (k - j) for k, c in enumerate(numbers) if k >= j), Fraction(0))
        * width**j
        for j in range(len(numbers))
    ]
    for degree in range(len(numbers) - 1, len(numbers) + MAX_RAISED):
        found = [
            sum(
                (
                    Fraction(comb(i, j), comb(degree, j)) * around[j]
                    for j in range(min(i, len(around) - 1) + 1)
                ),
                Fraction(0),
            )
            for i in range(degree + 1)
        ]
        least = min(found)
        if least < 0 or (is_strict and least == 0):
            continue
        constant = [str(least)] if is_strict else []
        values: list[Value] = [*constant]
        for i, number in enumerate(found):
            rest = number - least if is_strict else number
            if rest:
                scale = str(rest * comb(degree, i) / width**degree)
                parts = [power_of(facts[0], i)] if i else []
                parts += [power_of(facts[1], degree - i)] if i < degree else []
                values.append(product_of(scale, *parts))
        return values
    return None
