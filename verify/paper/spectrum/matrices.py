"""Vectors and matrices of terms. Entries that are the number 0 or 1 are not written out."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from verify.language.terms import Number, Term, as_term

Vector = tuple[Term, ...]
Matrix = tuple[Vector, ...]

ZERO = as_term(0)
ONE = as_term(1)


def vector(*entries: Number) -> Vector:
    """The vector with these entries."""
    return tuple(map(as_term, entries))


def sum_of(a: Term, b: Term) -> Term:
    """A + b."""
    if a == ZERO:
        return b
    return a if b == ZERO else a + b


def product_of(a: Term, b: Term) -> Term:
    """A b."""
    if ZERO in (a, b):
        return ZERO
    if a == ONE:
        return b
    return a if b == ONE else a * b


def difference_of(a: Term, b: Term) -> Term:
    """The difference a - b."""
    return a if b == ZERO else sum_of(a, -b)


def total(terms: Iterable[Term]) -> Term:
    """The sum."""
    result = ZERO
    for term in terms:
        result = sum_of(result, term)
    return result


def dot(u: Sequence[Term], v: Sequence[Term]) -> Term:
    """The sum of the products of entries."""
    return total(product_of(a, b) for a, b in zip(u, v, strict=True))


def apply(matrix: Matrix, v: Vector) -> Vector:
    """The image of a column."""
    return tuple(dot(row, v) for row in matrix)


def product(a: Matrix, b: Matrix) -> Matrix:
    """The matrix product a b."""
    columns = tuple(zip(*b, strict=True))
    return tuple(tuple(dot(row, column) for column in columns) for row in a)


def form(u: Vector, matrix: Matrix, v: Vector) -> Term:
    """The number u A v; two matrices are equal if it is the same for all u and v."""
    return dot(u, apply(matrix, v))


def determinant(matrix: Matrix) -> Term:
    """The determinant, expanded along the first row."""
    first, *others = matrix
    if not others:
        return first[0]
    result = ZERO
    for j, entry in enumerate(first):
        if entry == ZERO:
            continue
        minor = tuple(row[:j] + row[j + 1 :] for row in others)
        term = product_of(entry, determinant(minor))
        result = sum_of(result, -term if j % 2 else term)
    return result


def identity_minus(scalar: Term, matrix: Matrix) -> Matrix:
    """The matrix ``scalar I - A``."""
    return tuple(
        tuple(difference_of(scalar if i == j else ZERO, a) for j, a in enumerate(row))
        for i, row in enumerate(matrix)
    )
