"""Sums of squares times facts: why a polynomial is not negative where the facts hold.

For polynomials g_0 = 1, g_1, … that are >= 0 because of facts, and bases of polynomials, wanted are
positive semidefinite matrices with

    p = sum_j g_j v_j^T Q_j v_j.

They are estimated by a semidefinite programme. Where p has zeros the matrices are singular: their
kernels are read off the estimate, rounded, and divided out, so that what is left may be definite.
Then the entries are rounded, the equations solved exactly again, and Q_j = L D L^T gives squares
(Peyrl, Parrilo: Computing sum of squares decompositions with rational coefficients).
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise
from math import frexp

from flint import fmpq, fmpq_mat, fmpq_mpoly

from verify.language.record import Record
from verify.prover.budget import WorkBudget
from verify.prover.search.domain import Domain
from verify.prover.search.semidefinite import HOPELESS, Entry, Equations, Matrix, Solution, Solver

#: Programmes with larger matrices, or more equations, are not tried.
MAX_SIZE = 36
MAX_EQUATIONS = 320
#: How often zeros are divided out.
ROUNDS = 5
#: Entries are rounded to so many binary digits, at first to few.
DIGITS = (6, 12, 24, 40)


class Block(Record):
    """The index of a polynomial g >= 0, and the basis of the squares that it is multiplied by."""

    factor: int
    basis: tuple[fmpq_mpoly, ...]


class Summand(Record):
    """weight * g * square^2, with weight > 0."""

    weight: Fraction
    factor: int
    square: fmpq_mpoly


def decompose(
    p: fmpq_mpoly,
    domain: Domain,
    factors: Sequence[fmpq_mpoly],
    blocks: Sequence[Block],
    budget: WorkBudget,
) -> list[Summand] | None:
    """Terms that add up to p, reduced, or None if none are found."""
    blocks = [block for block in blocks if block.basis]
    for _ in range(ROUNDS):
        if not blocks or max(len(block.basis) for block in blocks) > MAX_SIZE:
            return None
        system = _System(p, domain, factors, blocks)
        if not system.consistent or len(system.rows) > MAX_EQUATIONS:
            return None
        found = Solver(system.program(), budget).solve()
        if found.t > HOPELESS or found.error > 1e-4:
            return None
        terms = system.rounded(found) if found.t < 1e-4 else None
        if terms is not None:
            return terms
        smaller = _faces(blocks, found)
        if smaller is None:
            return None
        blocks = smaller
    return None


class _System:
    """The linear equations for the entries of the matrices: one for each monomial."""

    def __init__(
        self,
        p: fmpq_mpoly,
        domain: Domain,
        factors: Sequence[fmpq_mpoly],
        blocks: Sequence[Block],
    ) -> None:
        self.blocks = blocks
        wanted = p.to_dict()
        self.rows: dict[tuple[int, ...], int] = {}
        self.entries: list[list[tuple[int, int, list[tuple[int, fmpq]]]]] = []
        for block in blocks:
            entries = []
            for i, first in enumerate(block.basis):
                part = factors[block.factor] * first
                for j in range(i, len(block.basis)):
                    product = domain.reduced(part * block.basis[j])
                    if i != j:
                        product *= 2
                    items = product.to_dict().items()
                    pairs = [(self.rows.setdefault(m, len(self.rows)), c) for m, c in items]
                    entries.append((i, j, pairs))
            self.entries.append(entries)
        self.consistent = all(m in self.rows for m in wanted)
        self.wanted = [fmpq(0)] * len(self.rows)
        for monomial, value in wanted.items():
            if monomial in self.rows:
                self.wanted[self.rows[monomial]] = value

    def program(self) -> Equations:
        """The same in floating point, with equations of size 1."""
        largest = [1e-300] * len(self.rows)
        for entries in self.entries:
            for _, _, pairs in entries:
                for k, c in pairs:
                    largest[k] = max(largest[k], abs(_float(c)))
        floats: list[list[Entry]] = [
            [(i, j, [(k, _float(c) / largest[k]) for k, c in pairs]) for i, j, pairs in entries]
            for entries in self.entries
        ]
        wanted = [_float(c) / size for c, size in zip(self.wanted, largest, strict=True)]
        return Equations([len(block.basis) for block in self.blocks], floats, wanted)

    def rounded(self, found: Solution) -> list[Summand] | None:
        """Exact terms near a solution."""
        size = max((abs(v) for m in found.blocks for row in m for v in row), default=1.0)
        for digits in DIGITS:
            unit = _power_of_two(size, digits)
            values = [
                [[fmpq(round(v / unit)) * _exact(unit) for v in row] for row in matrix]
                for matrix in found.blocks
            ]
            if self._correct(values):
                terms = self._terms(values)
                if terms is not None:
                    return terms
        return None

    def _correct(self, values: list[list[list[fmpq]]]) -> bool:
        """Change the entries as little as possible so that the equations hold."""
        rest = self._missing(values)
        if not any(rest):
            return True
        nu = _solve(self._gram(), rest)
        if nu is None:
            return False
        for matrix, entries in zip(values, self.entries, strict=True):
            for i, j, pairs in entries:
                matrix[i][j] += sum((c * nu[k] for k, c in pairs), fmpq(0))
                matrix[j][i] = matrix[i][j]
        return True

    def _missing(self, values: list[list[list[fmpq]]]) -> list[fmpq]:
        """What the left sides of the equations lack."""
        rest = list(self.wanted)
        for matrix, entries in zip(values, self.entries, strict=True):
            for i, j, pairs in entries:
                for k, c in pairs:
                    rest[k] -= c * matrix[i][j]
        return rest

    def _gram(self) -> list[list[fmpq]]:
        """The products of the equations' coefficients."""
        gram = [[fmpq(0)] * len(self.rows) for _ in self.rows]
        for entries in self.entries:
            for _, _, pairs in entries:
                for k, c in pairs:
                    row = gram[k]
                    for other, d in pairs:
                        row[other] += c * d
        return gram

    def _terms(self, values: list[list[list[fmpq]]]) -> list[Summand] | None:
        """The squares of L D L^T; None if a matrix is not positive semidefinite."""
        terms = []
        for matrix, block in zip(values, self.blocks, strict=True):
            rest = [list(row) for row in matrix]
            basis = list(block.basis)
            for i, row in enumerate(rest):
                pivot = row[i]
                if pivot < 0 or (pivot == 0 and any(row[i:])):
                    return None
                if pivot == 0:
                    continue
                square = basis[i]
                for j in range(i + 1, len(basis)):
                    ratio = row[j] / pivot
                    if ratio:
                        square += ratio * basis[j]
                        other = rest[j]
                        for k in range(j, len(basis)):
                            other[k] -= ratio * row[k]
                for j in range(i + 1, len(basis)):
                    for k in range(i + 1, j):
                        rest[j][k] = rest[k][j]
                terms.append(Summand(_fraction(pivot), block.factor, square))
        return terms


def _solve(gram: list[list[fmpq]], wanted: list[fmpq]) -> list[fmpq] | None:
    """A solution of a symmetric system, which may be dependent."""
    m = len(wanted)
    diagonal = all(not value for i, row in enumerate(gram) for j, value in enumerate(row) if i != j)
    if diagonal:
        if any(w and not gram[k][k] for k, w in enumerate(wanted)):
            return None
        return [w / gram[k][k] if w else fmpq(0) for k, w in enumerate(wanted)]
    try:
        solution = fmpq_mat(gram).solve(fmpq_mat([[w] for w in wanted]))
        return [solution[k, 0] for k in range(m)]
    except ZeroDivisionError:
        pass
    reduced, rank = fmpq_mat([[*row, w] for row, w in zip(gram, wanted, strict=True)]).rref()
    result = [fmpq(0)] * m
    for r in range(rank):
        pivot = next(c for c in range(m + 1) if reduced[r, c])
        if pivot == m:
            return None
        result[pivot] = reduced[r, m]
    return result


# --- zeros ---------------------------------------------------------------------------------------


def _faces(blocks: Sequence[Block], found: Solution) -> list[Block] | None:
    """The bases without the directions in which the matrices vanish; None if there are none."""
    result, changed = [], False
    largest = max((m[i][i] for m in found.blocks for i in range(len(m))), default=1.0)
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
        x = _gauss([[matrix[i][j] for j in solid] for i in solid], [-matrix[i][f] for i in solid])
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


def _gauss(a: list[list[float]], b: list[float]) -> list[float]:
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


def _orthogonal(
    kernel: Sequence[Sequence[Fraction]], basis: Sequence[fmpq_mpoly]
) -> tuple[fmpq_mpoly, ...]:
    """A basis of the combinations c of the basis with k . c = 0 for all k of the kernel."""
    n = len(basis)
    reduced, rank = fmpq_mat([[_exact(v) for v in row] for row in kernel]).rref()
    pivots = [next(c for c in range(n) if reduced[r, c]) for r in range(rank)]
    result = []
    for free in (c for c in range(n) if c not in pivots):
        element = basis[free]
        for r, pivot in enumerate(pivots):
            if reduced[r, free]:
                element -= reduced[r, free] * basis[pivot]
        result.append(element)
    return tuple(result)


def _float(value: fmpq) -> float:
    return int(value.p) / int(value.q)


def _exact(value: Fraction | float) -> fmpq:
    value = Fraction(value)
    return fmpq(value.numerator, value.denominator)


def _fraction(value: fmpq) -> Fraction:
    return Fraction(int(value.p), int(value.q))


def _power_of_two(size: float, digits: int) -> float:
    return 2.0 ** (frexp(size)[1] - digits)


def vanishing(block: Block, factor: fmpq_mpoly, point: Sequence[Fraction]) -> Block:
    """The combinations of the basis that are 0 at a zero of p where the factor is positive."""
    at = [_exact(value) for value in point]
    if factor(*at) <= 0:
        return block
    values = [_fraction(element(*at)) for element in block.basis]
    return block._replace(basis=_orthogonal([values], block.basis)) if any(values) else block
