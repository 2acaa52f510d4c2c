"""Positive semidefinite matrices with given linear images, in floating point: a barrier method.

Wanted are symmetric matrices Q_j, positive semidefinite, with A(Q) = b. What is minimized is t with
S_j = Q_j + t I positive definite (Boyd, Vandenberghe: Convex Optimization, 10.3 and 11.2): a
negative t says that the matrices can be positive definite, a t near 0 that they are on the
boundary, where S tells the kernel; a positive one that there are none. All that is found is an
estimate, which `verify.prover.search.squares` rounds and checks.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import sqrt
from operator import mul

from verify.language.record import Record
from verify.prover.budget import WorkBudget

Matrix = list[list[float]]
#: The entries of a block that count: row, column, and for each equation its coefficient.
Entry = tuple[int, int, list[tuple[int, float]]]

STEPS = 80
#: What is added to a diagonal of ones where rounding makes a matrix indefinite.
RIDGES = (0.0, 1e-15, 1e-13, 1e-11)
REFINEMENTS = 2
#: A solution with a larger t is none: the matrices cannot be semidefinite.
HOPELESS = 3e-4
#: Equations whose sides differ by less hold.
EXACT = 1e-8
#: The path ends where the barrier is worth so little.
LAST = 1e-10
#: Matrices whose eigenvalues are at least this, for data of size 1, are definite enough.
DEFINITE = 1e-2


class Equations(Record):
    """Sizes of the blocks, their entries with row <= column, and the right sides of equations."""

    sizes: list[int]
    entries: list[list[Entry]]
    wanted: list[float]


class Solution(Record):
    """Matrices whose least eigenvalue is about -t, and how far their images are from the goal."""

    blocks: list[Matrix]
    t: float
    error: float


def cholesky(a: Sequence[Sequence[float]]) -> Matrix | None:
    """The lower triangular L with L L^T = a, row by row; None if a is not positive definite."""
    rows: Matrix = []
    for row in a:
        new: list[float] = []
        for j, other in enumerate(rows):
            new.append((row[j] - sum(map(mul, new, other))) / other[j])
        square = row[len(new)] - sum(map(mul, new, new))
        if not square > 0:
            return None
        new.append(sqrt(square))
        rows.append(new)
    return rows


def solved(lower: Matrix, wanted: Sequence[float]) -> list[float]:
    """The solution of L L^T x = wanted."""
    y: list[float] = []
    for row, value in zip(lower, wanted, strict=True):
        y.append((value - sum(map(mul, row, y))) / row[len(y)])
    n = len(lower)
    x = [0.0] * n
    for i in range(n - 1, -1, -1):
        x[i] = y[i] / lower[i][i]
        row, value = lower[i], x[i]
        for j in range(i):
            y[j] -= row[j] * value
    return x


def _operations(program: Equations) -> int:
    """About the number of products in one step."""
    m = len(program.wanted)
    total = m**3 // 6 + sum(2 * n**3 for n in program.sizes)
    for entries in program.entries:
        parts = sum(len(found) for _, _, found in entries)
        total += len(entries) * (3 * len(entries) + parts) + parts * m
    return total


class _System:
    """A symmetric positive definite system, scaled to have 1 on the diagonal."""

    def __init__(self, matrix: Matrix, scale: list[float], lower: Matrix) -> None:
        self.matrix, self.scale, self.lower = matrix, scale, lower

    @classmethod
    def of(cls, matrix: Matrix) -> _System | None:
        """None if the matrix is not seen to be definite, even with a little on the diagonal."""
        if any(not row[k] > 0 for k, row in enumerate(matrix)):
            return None
        scale = [1 / sqrt(row[k]) for k, row in enumerate(matrix)]
        scaled = [
            [v * r * c for v, c in zip(row, scale, strict=True)]
            for row, r in zip(matrix, scale, strict=True)
        ]
        for ridge in RIDGES:
            tilted = [[*row[:k], row[k] + ridge, *row[k + 1 :]] for k, row in enumerate(scaled)]
            lower = cholesky(tilted)
            if lower is not None:
                return cls(scaled, scale, lower)
        return None

    def solution(self, wanted: Sequence[float]) -> list[float]:
        """The solution, improved by what it leaves."""
        b = [v * c for v, c in zip(wanted, self.scale, strict=True)]
        x = solved(self.lower, b)
        for _ in range(REFINEMENTS):
            rest = [v - sum(map(mul, row, x)) for v, row in zip(b, self.matrix, strict=True)]
            x = [v + d for v, d in zip(x, solved(self.lower, rest), strict=True)]
        return [v * c for v, c in zip(x, self.scale, strict=True)]


class Solver:
    """One semidefinite programme on its central path."""

    def __init__(self, program: Equations, budget: WorkBudget) -> None:
        self.program, self.budget = program, budget
        self.scale = max(map(abs, program.wanted), default=1.0) or 1.0
        self.b = [value / self.scale for value in program.wanted]
        self.s = [[[float(i == j) for j in range(n)] for i in range(n)] for n in program.sizes]
        self.t = 1.0
        self.weight = 1.0
        self.of_one = self.image(self.s)
        self.cost = 1 + _operations(program) // 12

    def image(self, blocks: Sequence[Matrix]) -> list[float]:
        """A(blocks)."""
        found = [0.0] * len(self.b)
        for matrix, entries in zip(blocks, self.program.entries, strict=True):
            for i, j, parts in entries:
                value = matrix[i][j]
                for k, coefficient in parts:
                    found[k] += coefficient * value
        return found

    def solve(self) -> Solution:
        """Follow the path as far as rounding lets the equations hold."""
        total = sum(self.program.sizes)
        best = self.s, self.t, 1.0
        for _ in range(STEPS):
            self.budget.spend(self.cost)
            step = self.newton()
            if step is None or step[0] == 0:
                break
            length, error = step
            if error > 10 * EXACT > 10 * best[2]:
                break
            if error < max(EXACT, best[2]):
                best = self.s, self.t, error
            if error < 1e-7 and self.t < -DEFINITE:
                break
            if length > 0.7 and error < 1e-6:
                # On the path no t is less than this one by more than the size over the weight.
                if self.weight > total / LAST or self.t - 1.5 * total / self.weight > HOPELESS:
                    break
                self.weight *= 8
        blocks, t, error = best
        scaled = [
            [
                [self.scale * (v - t * (i == j)) for j, v in enumerate(row)]
                for i, row in enumerate(m)
            ]
            for m in blocks
        ]
        return Solution(scaled, t, error)

    def newton(self) -> tuple[float, float] | None:
        """One step; its length, and how far the images are from the goal after it."""
        image = self.image(self.s)
        rest = [b - a + self.t * c for a, b, c in zip(image, self.b, self.of_one, strict=True)]
        system = _System.of(self.hessian())
        if system is None:
            return None
        first = system.solution([r - a for r, a in zip(rest, image, strict=True)])
        second = system.solution(self.of_one)
        slope = sum(map(mul, self.of_one, second))
        if not slope > 0:
            return None
        dt = (-self.weight - sum(map(mul, self.of_one, first))) / slope
        nu = [x + dt * y for x, y in zip(first, second, strict=True)]
        length = self.move(self.direction(nu), dt)
        error = max((abs(r) for r in rest), default=0.0) * (1 - length)
        return length, error

    def hessian(self) -> Matrix:
        """M with M_kl = A_k(S A_l S), where sums are taken in the order of the entries."""
        import numpy as np  # loaded only where it is used

        m = len(self.b)
        found = np.zeros((m, m))
        for s, entries in zip(self.s, self.program.entries, strict=True):
            matrix = np.array(s)
            i, j = (np.array([entry[at] for entry in entries], int) for at in (0, 1))
            parts = [(e, *part) for e, (_, _, parts) in enumerate(entries) for part in parts]
            e, k = (np.array([part[at] for part in parts], int) for at in (0, 1))
            coefficients = np.array([part[2] for part in parts])
            for p, q, own in entries:
                sp, sq = matrix[p], matrix[q]
                values = sp[i] * sq[j] + sq[i] * sp[j]
                column = np.bincount(k, coefficients * values[e], m)
                for row, coefficient in own:
                    # Half of an entry off the diagonal is at either place.
                    found[row] += coefficient / 2 * column
        rows: Matrix = found.tolist()
        return rows

    def direction(self, nu: Sequence[float]) -> list[Matrix]:
        """S + S A*(nu) S for each block."""
        found = []
        for s, entries in zip(self.s, self.program.entries, strict=True):
            n = len(s)
            adjoint = [[0.0] * n for _ in range(n)]
            for i, j, parts in entries:
                value = sum(coefficient * nu[k] for k, coefficient in parts)
                if i == j:
                    adjoint[i][i] += value
                else:
                    adjoint[i][j] += value / 2
                    adjoint[j][i] += value / 2
            half = [[sum(map(mul, row, column)) for column in adjoint] for row in s]
            found.append(
                [
                    [v + sum(map(mul, row, column)) for v, column in zip(old, s, strict=True)]
                    for old, row in zip(s, half, strict=True)
                ]
            )
        return found

    def move(self, direction: Sequence[Matrix], dt: float) -> float:
        """Go as far as the matrices stay definite, at most the whole way."""
        length = 1.0
        for _ in range(40):
            new = [
                [
                    [v + length * d for v, d in zip(row, other, strict=True)]
                    for row, other in zip(s, block, strict=True)
                ]
                for s, block in zip(self.s, direction, strict=True)
            ]
            further = [
                [
                    [v + min(length * 1.2, 1.0) * d for v, d in zip(row, other, strict=True)]
                    for row, other in zip(s, block, strict=True)
                ]
                for s, block in zip(self.s, direction, strict=True)
            ]
            if all(cholesky(block) is not None for block in further):
                self.s, self.t = new, self.t + length * dt
                return length
            length *= 0.75
        return 0.0
