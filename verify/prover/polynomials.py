"""Polynomials in one variable, read from terms, and their Bernstein coefficients."""

from __future__ import annotations

from fractions import Fraction
from math import comb

from verify.language.terms import Term

#: Coefficients from the constant one upwards, without zeros at the end.
Coefficients = list[Fraction]


class NotPolynomialError(ArithmeticError):
    """A term is not a polynomial with rational coefficients in the given variable."""


def coefficients(term: Term, name: str) -> Coefficients:
    """The coefficients of a term that is a polynomial in one symbol, over the rationals.

    Raises:
        NotPolynomialError: for any other term.
    """
    op = term.op
    if op == "rational":
        return _trimmed([term.value])
    if op == "symbol":
        if term.name != name:
            raise NotPolynomialError(f"{term.name} is not {name}")
        return [Fraction(0), Fraction(1)]
    parts = [coefficients(child, name) for child in term.children]
    if op == "neg":
        return [-a for a in parts[0]]
    if op == "pow":
        result = parts[0]
        for _ in range(term.exponent - 1):
            result = _product(result, parts[0])
        return result
    if op == "mul":
        return _product(*parts)
    if op == "div" and len(parts[1]) == 1:
        return [a / parts[1][0] for a in parts[0]]
    if op in ("add", "sub"):
        return _sum(parts[0], parts[1], 1 if op == "add" else -1)
    raise NotPolynomialError(f"{op} is not an operation of polynomials")


def formal_degree(term: Term) -> int:
    """A bound on the degree of a polynomial: its degree before any terms cancel."""
    parts = [formal_degree(child) for child in term.children]
    match term.op:
        case "symbol":
            return 1
        case "pow":
            return parts[0] * term.exponent
        case "mul":
            return sum(parts)
    return max(parts, default=0)


def bernstein(
    polynomial: Coefficients, lower: Fraction, upper: Fraction, degree: int
) -> Coefficients:
    """The Bernstein coefficients on [lower, upper], for a degree that is not too small.

    With t = (x - lower)/(upper - lower) and p(x) = sum c_k t^k, they are
    b_j = sum_k c_k binomial(j, k) / binomial(degree, k); p is their convex combination.
    """
    c = _shifted(polynomial, lower, upper - lower)
    scaled = [value / comb(degree, k) for k, value in enumerate(c)]
    return [
        sum((value * comb(j, k) for k, value in enumerate(scaled[: j + 1])), Fraction(0))
        for j in range(degree + 1)
    ]


def _shifted(polynomial: Coefficients, start: Fraction, scale: Fraction) -> Coefficients:
    result: Coefficients = []
    for value in reversed(polynomial):
        result = _sum(_product(result, _trimmed([start, scale])), _trimmed([value]), 1)
    return result


def _sum(a: Coefficients, b: Coefficients, sign: int) -> Coefficients:
    size = max(len(a), len(b))
    zero = Fraction(0)
    return _trimmed(
        [
            (a[k] if k < len(a) else zero) + sign * (b[k] if k < len(b) else zero)
            for k in range(size)
        ]
    )


def _product(a: Coefficients, b: Coefficients) -> Coefficients:
    if not a or not b:
        return []
    result = [Fraction(0)] * (len(a) + len(b) - 1)
    for i, x in enumerate(a):
        for j, y in enumerate(b):
            result[i + j] += x * y
    return result


def _trimmed(values: Coefficients) -> Coefficients:
    while values and values[-1] == 0:
        values.pop()
    return values
