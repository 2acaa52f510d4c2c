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

import math
from collections.abc import Sequence
from fractions import Fraction

from flint import fmpq, fmpq_mat, fmpq_mpoly

from verify.language.record import Record
from verify.prover.balls import float_of, fmpq_of, fraction_of
from verify.prover.budget import WorkBudget
from verify.prover.search.domain import Domain
from verify.prover.search.faces import Block, faces
from verify.prover.search.semidefinite import HOPELESS, Entry, Equations, Solution, Solver

#: Programmes with larger matrices, or more equations, are not tried.
MAX_SIZE = 36
MAX_EQUATIONS = 320
#: How often zeros are divided out.
ROUNDS = 5
#: Entries are rounded to so many binary digits, at first to few.
DIGITS = (6, 12, 24, 40)
#: Longer numbers are no proof that anybody could check.
MAX_BITS = 4000


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
        system = _System(p, domain, factors, blocks, budget)
        if not system.consistent or len(system.rows) > MAX_EQUATIONS:
            return None
        program = system.program()
        if program is None:
            return None
        found = Solver(program, budget).solve()
        if found.t > HOPELESS or found.error > 1e-4:
            return None
        terms = system.rounded(found, budget) if found.t < 1e-4 else None
        if terms is not None:
            return terms
        smaller = faces(blocks, found)
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
        budget: WorkBudget,
    ) -> None:
        self.blocks = blocks
        wanted = p.to_dict()
        self.rows: dict[tuple[int, ...], int] = {}
        self.entries: list[list[tuple[int, int, list[tuple[int, fmpq]]]]] = []
        for block in blocks:
            entries = []
            for i, first in enumerate(block.basis):
                budget.spend(20 * (len(block.basis) - i))
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

    def program(self) -> Equations | None:
        """The same in floating point, with equations of size 1; None if a number is too large."""
        largest = [1e-300] * len(self.rows)
        for entries in self.entries:
            for _, _, pairs in entries:
                for k, c in pairs:
                    largest[k] = max(largest[k], abs(float_of(c)))
        floats: list[list[Entry]] = [
            [(i, j, [(k, float_of(c) / largest[k]) for k, c in pairs]) for i, j, pairs in entries]
            for entries in self.entries
        ]
        wanted = [float_of(c) / size for c, size in zip(self.wanted, largest, strict=True)]
        if not all(map(math.isfinite, (*largest, *wanted))):
            return None
        return Equations([len(block.basis) for block in self.blocks], floats, wanted)

    def rounded(self, found: Solution, budget: WorkBudget) -> list[Summand] | None:
        """Exact terms near a solution."""
        cost = len(self.rows) ** 3 // 10 + sum(len(block.basis) ** 3 for block in self.blocks)
        size = max((abs(v) for m in found.blocks for row in m for v in row), default=1.0)
        for digits in DIGITS:
            budget.spend(cost)
            unit = _power_of_two(size, digits)
            values = [
                [[fmpq(round(v / unit)) * fmpq_of(unit) for v in row] for row in matrix]
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
        """The squares of all matrices; None if one is not positive semidefinite."""
        terms = []
        for matrix, block in zip(values, self.blocks, strict=True):
            squares = _diagonal(matrix, block.basis)
            if squares is None:
                return None
            terms += [Summand(fraction_of(w), block.factor, square) for w, square in squares]
        return terms


def _diagonal(
    matrix: Sequence[Sequence[fmpq]], basis: Sequence[fmpq_mpoly]
) -> list[tuple[fmpq, fmpq_mpoly]] | None:
    """The squares of L D L^T with their weights; None if the matrix is not semidefinite."""
    rest, found = [list(row) for row in matrix], []
    for i, row in enumerate(rest):
        pivot = row[i]
        if pivot < 0 or (pivot == 0 and any(row[i:])) or pivot.height_bits() > MAX_BITS:
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
        found.append((pivot, square))
    return found


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


def _power_of_two(size: float, digits: int) -> float:
    return 2.0 ** (math.frexp(size)[1] - digits)
