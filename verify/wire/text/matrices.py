"""Vectors and matrices in formulas, written entry by entry, and functions that a page defines.

    [let]
    v = ["1", "x"]
    "A(r)" = [["0", "-r"], ["1", "(1 + r)/2"]]
    "Q(y, r)" = "det(y*[[1, 0], [0, 1]] - A(r))"

Sums, differences and products are those of linear algebra: ``u*v`` is the sum of the products of
the entries of two vectors, ``A*v`` the image of a column, and ``u*A`` that of a row. ``A[1, 2]`` is
an entry, ``det(A)`` is expanded along the first row, and ``form(u, G, v)`` is the sum of all
``G[i, j]*(u[i]*v[j])``. A factor 0 or 1 of entries, and a summand that is such a product with 0,
are not written out, unless the other factor might have no value.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cache
from math import prod

from verify.language.record import Record
from verify.language.terms import Term, as_term

ZERO, ONE = as_term(0), as_term(1)
#: A table has at most so many rows, and so many columns.
MAX_SIDE = 8
#: So many signs of functions and products of entries are read at most for a page.
MAX_WORK = 2_000_000


class Table(Record):
    """A matrix by its rows, or a vector, which is one row."""

    rows: tuple[tuple[Term, ...], ...]
    is_matrix: bool

    @property
    def shape(self) -> str:
        """What it is, in words."""
        rows, columns = len(self.rows), len(self.rows[0])
        return f"a matrix of {rows} by {columns}" if self.is_matrix else f"a vector of {columns}"

    def entry(self, at: Sequence[int]) -> Value:
        """The entry at a place, counted from 1; at one number, the row of a matrix.

        Raises:
            ValueError: if there is none.
        """
        row, column = (*at, 1)[:2] if self.is_matrix else (1, *at)[:2]
        fits = 1 <= len(at) <= 1 + self.is_matrix
        if not (fits and 1 <= row <= len(self.rows) and 1 <= column <= len(self.rows[0])):
            raise ValueError(f"{self.shape} has no entry [{', '.join(map(str, at))}]")
        if self.is_matrix and len(at) == 1:
            return Table((self.rows[row - 1],), False)
        return self.rows[row - 1][column - 1]

    def each(self, changed: Callable[[Term], Term]) -> Table:
        """The table of the entries after a change."""
        return Table(tuple(tuple(map(changed, row)) for row in self.rows), self.is_matrix)


#: What a formula, or a part of it, stands for.
Value = Term | Table


class Spent:
    """What the functions and tables of a page have cost so far, and which functions were used."""

    def __init__(self) -> None:
        self.work = 0
        self.used: set[str] = set()

    def spend(self, work: int) -> None:
        """Count some work.

        Raises:
            ValueError: if it is too much for one page.
        """
        self.work += work
        if self.work > MAX_WORK:
            raise ValueError("its functions and tables are too much work; name their parts")


def entries_of(value: Value) -> list[Term]:
    """The entries of a table, or the term."""
    return [value] if isinstance(value, Term) else [entry for row in value.rows for entry in row]


def size_of(*values: Value) -> int:
    """The product of the numbers of entries, which bounds the work on some tables."""
    return prod(len(v.rows) * len(v.rows[0]) for v in values if isinstance(v, Table))


def table_of(rows: Sequence[Sequence[Term]], is_matrix: bool) -> Table:
    """The vector or matrix with these rows.

    Raises:
        ValueError: if rows differ in length, are empty, or are too many or too long.
    """
    lengths = {len(row) for row in rows}
    if not lengths or 0 in lengths:
        raise ValueError("it has no entry")
    if len(lengths) > 1:
        raise ValueError("its rows have different lengths")
    if max(len(rows), *lengths) > MAX_SIDE:
        raise ValueError(f"it has more than {MAX_SIDE} rows or columns")
    return Table(tuple(map(tuple, rows)), is_matrix)


@cache
def has_value(term: Term) -> bool:
    """True only if the term has a value whatever the names in it stand for."""
    from verify.prover import clearing  # loaded only where it is used

    return clearing.has_value(term, lambda _: False) and all(map(has_value, term.children))


def times_zero(term: Term) -> Term:
    """0 times a term: 0, or written out where the term might have no value."""
    return ZERO if has_value(term) else ZERO * term


def negative(x: Value) -> Value:
    """Minus a term, or a table."""
    return -x if isinstance(x, Term) else x.each(lambda a: a if a is ZERO else -a)


def over(x: Value, y: Value) -> Value:
    """The quotient by a number.

    Raises:
        ValueError: if the divisor is a table.
    """
    if isinstance(y, Table):
        raise ValueError(f"{y.shape} is no divisor")
    return (
        x / y
        if isinstance(x, Term)
        else x.each(lambda a: a if a is ZERO and y.op == "rational" and y.value else a / y)
    )
