"""Inequalities between polynomials in one variable between two bounds, by Bernstein coefficients.

With n not too small, (b-a)^n p(x) is the sum of B_k binomial(n, k) (x-a)^k (b-x)^(n-k), where the
numbers B_k are the Bernstein coefficients of p on [a, b]. If none is negative, neither is p.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import comb

from verify.language.terms import symbol
from verify.prover.clearing import Clearing, Polynomial
from verify.prover.goal import Bounds, Goal
from verify.prover.proof import Value
from verify.prover.rules import Sum

#: A Bernstein degree is at most this much larger than the degree of the polynomial.
MAX_ELEVATION = 40


def bernstein(goal: Goal) -> Sum | None:
    """A proof for which the divisors in the claim need their facts; None if none is found."""
    lhs, rhs, relation = goal.claim.lhs, goal.claim.rhs, goal.claim.relation
    if relation not in ("<", "<=") or goal.constants or len(goal.variables) != 1:
        return None
    ((name, bounds),) = goal.variables.items()
    clearing = Clearing((lhs, rhs), {symbol(n): term for n, term in goal.definitions.items()})
    if bounds.interval is None or [atom.args for atom in clearing.atoms] != [(name,)]:
        return None
    polynomial = _coefficients(clearing.difference(rhs, lhs))
    values = _degree(polynomial, bounds, strict=relation == "<")
    return None if values is None else _sum(values, bounds, tuple(goal.definitions))


def _coefficients(polynomial: Polynomial) -> list[Fraction]:
    """From the constant one upwards."""
    found: dict[int, Fraction] = {}
    for (power,), value in polynomial.to_dict().items():
        found[int(power)] = Fraction(int(value.p), int(value.q))
    return [found.get(k, Fraction(0)) for k in range(max(found, default=0) + 1)]


def _degree(
    polynomial: Sequence[Fraction], bounds: Bounds, *, strict: bool
) -> list[Fraction] | None:
    """Coefficients that show the claim, for the least degree that has such."""
    low, high = bounds.ends or (Fraction(0), Fraction(1))
    shifted = shift(polynomial, low, high - low)
    least = len(polynomial) - 1
    for degree in range(least, least + MAX_ELEVATION + 1):
        values = coefficients(shifted, degree)
        if min(values) >= 0 and (not strict or _is_strict(values, bounds)):
            return values
    return None


def _is_strict(values: Sequence[Fraction], bounds: Bounds) -> bool:
    """Whether some coefficient, and its powers of x-a and b-x, are positive."""
    first = 0 if bounds.high_relation == "<" else len(values) - 1
    last = len(values) - 1 if bounds.low_relation == "<" else 0
    return any(values[first : last + 1])


def coefficients(polynomial: Sequence[Fraction], degree: int) -> list[Fraction]:
    """The Bernstein coefficients on [0, 1], for a degree that is not too small.

    For p(t) = sum c_k t^k they are b_j = sum_k c_k binomial(j, k) / binomial(degree, k).
    """
    scaled = [value / comb(degree, k) for k, value in enumerate(polynomial)]
    return [
        sum((value * comb(j, k) for k, value in enumerate(scaled[: j + 1])), Fraction(0))
        for j in range(degree + 1)
    ]


def shift(polynomial: Sequence[Fraction], start: Fraction, scale: Fraction) -> list[Fraction]:
    """The coefficients of p(start + scale t)."""
    result: list[Fraction] = []
    for value in reversed(polynomial):
        rising = [Fraction(0), *(scale * c for c in result)]
        result = [start * c + d for c, d in zip([*result, Fraction(0)], rising, strict=True)]
        result[0] += value
    while len(result) > 1 and not result[-1]:
        result.pop()
    return result


def _sum(values: Sequence[Fraction], bounds: Bounds, using: tuple[str, ...]) -> Sum:
    """The goal, times (b-a)^n, and the sum that is the same number with the other sign."""
    n = len(values) - 1
    low, high = bounds.ends or (Fraction(0), Fraction(1))
    addends: list[Value] = [_product((high - low) ** n, ["goal"])]
    for k, value in enumerate(values):
        if value:
            powers = [_power(bounds.low_fact, k), _power(bounds.high_fact, n - k)]
            addends.append(_product(value * comb(n, k), [p for p in powers if p]))
    return Sum(tuple(addends), using)


def _power(fact: str, exponent: int) -> Value:
    return fact if exponent == 1 else ("pow", fact, exponent) if exponent else ""


def _product(number: Fraction, values: Sequence[Value]) -> Value:
    factors = [*values] if number == 1 and values else [str(number), *values]
    return factors[0] if len(factors) == 1 else ("mul", *factors)
