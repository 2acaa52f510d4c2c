"""Sums, products and determinants of vectors and matrices, entry by entry.

A factor 0 or 1 of entries, and a summand that is such a product with 0, are not written out, unless
the other factor might have no value.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from verify.language.terms import Term
from verify.wire.text.matrices import ONE, ZERO, Table, Value, has_value, times_zero

#: The largest matrix whose determinant is expanded.
MAX_DETERMINANT = 5


def added(x: Value, y: Value, sign: str) -> Value:
    """The sum or the difference of two tables.

    Raises:
        ValueError: if they do not fit together.
    """
    if isinstance(x, Term) or isinstance(y, Term) or x.shape != y.shape:
        told = [v.shape if isinstance(v, Table) else "a number" for v in (x, y)]
        raise ValueError(f"{told[0]} and {told[1]} have no sum")
    joined = _sum if sign == "+" else _difference
    pairs = (zip(*two, strict=True) for two in zip(x.rows, y.rows, strict=True))
    return Table(tuple(tuple(joined(a, b) for a, b in row) for row in pairs), x.is_matrix)


def times(x: Value, y: Value) -> Value:
    """The product of two tables, or of a term and a table.

    Raises:
        ValueError: if they do not fit together.
    """
    if isinstance(x, Term):
        return x * y if isinstance(y, Term) else y.each(lambda a: _product(x, a))
    if isinstance(y, Term):
        return x.each(lambda a: _product(a, y))
    columns = tuple(zip(*y.rows, strict=True)) if y.is_matrix else y.rows
    if len(x.rows[0]) != len(columns[0]):
        raise ValueError(f"{x.shape} and {y.shape} have no product")
    found = tuple(tuple(_dot(row, column) for column in columns) for row in x.rows)
    if x.is_matrix and y.is_matrix:
        return Table(found, True)
    if x.is_matrix:
        return Table((tuple(entry for (entry,) in found),), False)
    return Table(found, False) if y.is_matrix else found[0][0]


def determinant(matrix: Value) -> Term:
    """The determinant, expanded along the first row.

    Raises:
        ValueError: for what is no square matrix, or a large one.
    """
    if not isinstance(matrix, Table) or not matrix.is_matrix:
        raise ValueError("det is of a matrix")
    if len(matrix.rows) != len(matrix.rows[0]) or len(matrix.rows) > MAX_DETERMINANT:
        most = f"{MAX_DETERMINANT} by {MAX_DETERMINANT}"
        raise ValueError(f"det is of a square matrix, at most {most}, not of {matrix.shape}")
    return _expanded(matrix.rows)


def _expanded(rows: tuple[tuple[Term, ...], ...]) -> Term:
    first, *others = rows
    if not others:
        return first[0]
    result = ZERO
    for j, entry in enumerate(first):
        if entry is not ZERO or not all(has_value(a) for row in others for a in row):
            minor = tuple(row[:j] + row[j + 1 :] for row in others)
            part = _product(entry, _expanded(minor))
            result = _sum(result, -part if j % 2 else part)
    return result


def form(u: Value, gram: Value, v: Value) -> Term:
    """The sum of all ``gram[i, j]*(u[i]*v[j])``, row by row.

    Raises:
        ValueError: if these are not a vector, a matrix and a vector that fit.
    """
    tables = [value for value in (u, gram, v) if isinstance(value, Table)]
    if [table.is_matrix for table in tables] != [False, True, False]:
        raise ValueError("form is of a vector, a matrix and a vector")
    ((x,), _), (rows, _), ((y,), _) = tables
    if len(x) != len(rows) or len(y) != len(rows[0]):
        raise ValueError(f"{', '.join(table.shape for table in tables)} do not fit together")
    return _total(
        _product(g, _product(a, b))
        for a, row in zip(x, rows, strict=True)
        for g, b in zip(row, y, strict=True)
    )


def _dot(u: Sequence[Term], v: Sequence[Term]) -> Term:
    return _total(_product(a, b) for a, b in zip(u, v, strict=True))


def _total(terms: Iterable[Term]) -> Term:
    result = ZERO
    for term in terms:
        result = _sum(result, term)
    return result


def _sum(a: Term, b: Term) -> Term:
    return b if a is ZERO else a if b is ZERO else a + b


def _difference(a: Term, b: Term) -> Term:
    return a if b is ZERO else _sum(a, -b)


def _product(a: Term, b: Term) -> Term:
    if a is ZERO or b is ZERO:
        return times_zero(b if a is ZERO else a)
    return b if a is ONE else a if b is ONE else a * b
