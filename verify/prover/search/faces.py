"""Bases of squares without what must vanish: smaller matrices, that may be definite.

If p is a sum of squares times factors, each square vanishes where p does and its factor does not.
So the vector of values of its basis at such a zero is in the kernel of its matrix (facial
reduction). Kernels come from zeros that are known, and from an estimate of the matrix.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from fractions import Fraction
from functools import reduce
from itertools import pairwise
from operator import add
from typing import Any

from flint import fmpq_mat, fmpq_mpoly

from verify.language.record import Record
from verify.prover.balls import float_of, fmpq_of, fraction_of
from verify.prover.search.semidefinite import Matrix, Solution

#: Smaller pivots are those of rounding.
PIVOT = 1e-5
#: Values of bases that are smaller are 0.
SEEN = 1e-8
#: Kernels with larger denominators are not recognized.
DENOMINATOR = 200_000


class Block(Record):
    """The index of a polynomial g >= 0, and the basis of the squares that it is multiplied by."""

    factor: int
    basis: tuple[fmpq_mpoly, ...]


def faces(blocks: Sequence[Block], found: Solution) -> list[Block] | None:
    """The bases without the directions in which the matrices vanish; None if there are none."""
    result, changed = [], False
    largest = max((m[i][i] for m in found.blocks for i in range(len(m))), default=1.0)
    if not largest > 0:
        return None
    for block, matrix in zip(blocks, found.blocks, strict=True):
        kernel = _kernel(matrix, largest)
        if kernel:
            changed = True
            basis = _orthogonal(kernel, block.basis)
            block = block._replace(basis=basis)
        if block.basis:
            result.append(block)
    return result if changed else None


def _kernel(matrix: Matrix, largest: float) -> list[list[Fraction]]:
    """Vectors with simple rational entries that a matrix nearly maps to 0."""
    n = len(matrix)
    rest = [list(row) for row in matrix]
    order: list[int] = []
    pivots: list[float] = []
    left = set(range(n))
    while left:
        i = max(left, key=lambda k: rest[k][k])
        pivots.append(max(rest[i][i], 1e-18 * largest))
        order.append(i)
        left.discard(i)
        for j in left:
            ratio = rest[j][i] / pivots[-1]
            for k in left:
                rest[j][k] -= ratio * rest[i][k]
    rank = _rank(pivots, largest)
    if rank == n:
        return []
    solid, free = order[:rank], order[rank:]
    vectors = []
    for f in free:
        # The entries x_i of the vector with 1 at f solve Q_ss x = -Q_sf.
        x = gauss([[matrix[i][j] for j in solid] for i in solid], [-matrix[i][f] for i in solid])
        vector = [Fraction(0)] * n
        vector[f] = Fraction(1)
        for i, value in zip(solid, x, strict=True):
            simple = _simple(value)
            if simple is None:
                return []
            vector[i] = simple
        vectors.append(vector)
    return vectors


def _rank(pivots: Sequence[float], largest: float) -> int:
    """The number of pivots before the widest gap, if there is one among the small ones."""
    gaps = [
        (a / b, k + 1)
        for k, (a, b) in enumerate(pairwise([largest, *pivots]))
        if b < 2e-4 * largest
    ]
    if not gaps:
        return len(pivots)
    return max(gaps)[1] - 1


def gauss(a: list[list[float]], b: list[float]) -> list[float]:
    """The solution of a x = b; zeros if there is no single one."""
    n = len(b)
    rows = [[*row, value] for row, value in zip(a, b, strict=True)]
    for i in range(n):
        pivot = max(range(i, n), key=lambda k: abs(rows[k][i]))
        rows[i], rows[pivot] = rows[pivot], rows[i]
        top = rows[i]
        if top[i] == 0:
            return [0.0] * n
        for k in range(i + 1, n):
            ratio = rows[k][i] / top[i]
            if ratio:
                rows[k] = [x - ratio * y for x, y in zip(rows[k], top, strict=True)]
    x = [0.0] * n
    for i in range(n - 1, -1, -1):
        value = rows[i][n] - sum(rows[i][j] * x[j] for j in range(i + 1, n))
        x[i] = value / rows[i][i]
    return x


def _simple(value: float) -> Fraction | None:
    """The simplest rational number near a value."""
    if not abs(value) < 1e6:
        return None
    for most in (1, 2, 4, 12, 60, 1000):
        guess = Fraction(value).limit_denominator(most)
        if abs(float(guess) - value) < 2e-3 / most / most * (1 if most > 4 else 0.5):
            return guess
    return None


def null_space(matrix: Any) -> Iterator[list[Any]]:
    """Vectors that span what all rows of a matrix, over any field of FLINT, are orthogonal to."""
    reduced, rank = matrix.rref()
    columns = range(matrix.ncols())
    pivots = [next(c for c in columns if reduced[r, c] != 0) for r in range(rank)]
    for free in (c for c in columns if c not in pivots):
        entries = {pivot: -reduced[r, free] for r, pivot in enumerate(pivots)}
        yield [entries.get(c, int(c == free)) for c in columns]


def _orthogonal(
    kernel: Sequence[Sequence[Fraction]], basis: Sequence[fmpq_mpoly]
) -> tuple[fmpq_mpoly, ...]:
    """A basis of the combinations c of the basis with k . c = 0 for all k of the kernel."""
    vectors = null_space(fmpq_mat([[fmpq_of(v) for v in row] for row in kernel]))
    pairs = (zip(vector, basis, strict=True) for vector in vectors)
    return tuple(reduce(add, (x * element for x, element in row if x != 0)) for row in pairs)


def vanishing_near(block: Block, factor: fmpq_mpoly, points: Sequence[Sequence[float]]) -> Block:
    """The same for zeros in floats, if what their values span has a simple rational basis."""
    if not block.basis:
        return block
    inside = [point for point in points if value_at(factor, point) > 1e-6]
    rows = [[value_at(element, point) for element in block.basis] for point in inside]
    reduced = _reduced(rows)
    kernel = [[_rational(v) for v in row] for row in reduced]
    known = [[v for v in row if v is not None] for row in kernel]
    if not known or any(len(row) < len(block.basis) for row in known):
        return block
    return block._replace(basis=_orthogonal(known, block.basis))


def _reduced(rows: list[list[float]]) -> list[list[float]]:
    """The span of rows in reduced form."""
    found: list[tuple[int, list[float]]] = []
    left = [[v / size for v in row] for row in rows if (size := max(map(abs, row))) > SEEN]
    for column in range(len(rows[0]) if rows else 0):
        if not left or max(abs(row[column]) for row in left) < PIVOT:
            continue
        row = max(left, key=lambda r: abs(r[column]))
        left.remove(row)
        row = [v / row[column] for v in row]
        found = [(k, _without(other, row, column)) for k, other in found]
        found.append((column, row))
        left = [_without(other, row, column) for other in left]
    return [row for _, row in found]


def _without(other: list[float], row: list[float], column: int) -> list[float]:
    """A row minus so much of another that a column is 0."""
    return [v - other[column] * w for v, w in zip(other, row, strict=True)]


def _rational(value: float) -> Fraction | None:
    """The rational number with a small denominator that is very near, if there is one."""
    guess = Fraction(value).limit_denominator(DENOMINATOR)
    return guess if abs(float(guess) - value) < 1e-12 * (1 + abs(value)) else None


def value_at(polynomial: fmpq_mpoly, point: Sequence[float]) -> float:
    """The value of a polynomial at floats; no number where one is too large."""
    total = 0.0
    try:
        for exponents, c in polynomial.to_dict().items():
            term = float_of(c)
            for x, e in zip(point, exponents, strict=True):
                term *= x ** int(e)
            total += term
    except OverflowError:
        return math.nan
    return total


def vanishing(block: Block, factor: fmpq_mpoly, point: Sequence[Fraction]) -> Block:
    """The combinations of the basis that are 0 at a zero of p where the factor is positive."""
    at = [fmpq_of(value) for value in point]
    if factor(*at) <= 0:
        return block
    values = [fraction_of(element(*at)) for element in block.basis]
    return block._replace(basis=_orthogonal([values], block.basis)) if any(values) else block
