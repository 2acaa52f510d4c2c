"""Linear programmes in exact arithmetic: numbers >= 0 with given linear images.

Wanted are x >= 0 and free y with A x + B y = b. The free numbers are eliminated; then artificial
variables, one for each row, are driven out by the simplex method. The column of the largest gain
enters, and after many steps without a gain the first one, so that no circle goes on (Bland's rule).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from flint import fmpq

from verify.prover.budget import WorkBudget

Column = Mapping[int, fmpq]
Row = dict[int, fmpq]

#: After so many steps without a gain the first column enters.
PATIENCE = 12
MAX_STEPS = 2000
#: Longer numbers are no proof that anybody could check.
MAX_BITS = 4000
#: The work of one entry of a row.
ENTRY = 1

RIGHT = -1
ZERO = fmpq(0)


def solution(
    columns: Sequence[Column],
    free: Sequence[Column],
    wanted: Column,
    budget: WorkBudget,
    costs: Sequence[fmpq] = (),
) -> tuple[list[fmpq], list[fmpq]] | None:
    """Numbers x >= 0 and y whose columns add up to what is wanted; None if none are found.

    If there are ``costs``, one for each number, the sum of them is as small as it can be.
    """
    rows: dict[int, Row] = {}
    for k, column in enumerate((*columns, *free)):
        for row, value in column.items():
            rows.setdefault(row, {})[k] = value
    for row, value in wanted.items():
        rows.setdefault(row, {})[RIGHT] = value
    programme = _Programme([*rows.values()], len(columns), budget)
    return programme.solved(len(free), {k: cost for k, cost in enumerate(costs) if cost})


class _Programme:
    """Rows of equations, each with its right side; the columns from ``n`` on are free."""

    def __init__(self, rows: list[Row], n: int, budget: WorkBudget) -> None:
        self.rows, self.n, self.budget = rows, n, budget
        self.bases: list[int] = []

    def solved(self, free: int, costs: Row) -> tuple[list[fmpq], list[fmpq]] | None:
        """The numbers, of both kinds."""
        fixed = self._eliminated(free, costs)
        if not self._feasible() or (costs and not self._cheapest(costs)):
            return None
        values = [ZERO] * (self.n + free)
        for row, basis in zip(self.rows, self.bases, strict=True):
            if 0 <= basis < self.n:
                values[basis] = row.get(RIGHT, ZERO)
        for column, row in reversed(fixed):
            rest = row.get(RIGHT, ZERO)
            for k, value in row.items():
                if k not in (column, RIGHT):
                    rest -= value * values[k]
            values[column] = rest
        if any(value.height_bits() > MAX_BITS for value in values):
            return None
        return values[: self.n], values[self.n :]

    def _eliminated(self, free: int, costs: Row) -> list[tuple[int, Row]]:
        """The rows that say what the free numbers are, taken out of the programme."""
        fixed = []
        for column in range(self.n, self.n + free):
            having = [row for row in self.rows if column in row]
            if not having:
                continue
            pivot = min(having, key=len)
            self.rows = [row for row in self.rows if row is not pivot]
            self._divide(pivot, pivot[column])
            for row in having:
                if row is not pivot:
                    self._subtract(row, pivot, row[column])
            if column in costs:
                self._subtract(costs, pivot, costs[column])
            fixed.append((column, pivot))
        return fixed

    def _feasible(self) -> bool:
        """Afterwards each row has a basis; False if an artificial variable cannot be left out."""
        for row in self.rows:
            if row.get(RIGHT, ZERO) < 0:
                for k in row:
                    row[k] = -row[k]
        self.rows = [row for row in self.rows if row]
        self.bases = [-2 - i for i in range(len(self.rows))]
        cost: Row = {}
        for row in self.rows:
            self._subtract(cost, row, fmpq(-1))
        idle = 0
        for _ in range(MAX_STEPS):
            left = cost.get(RIGHT, ZERO)
            if not left:
                return self._only_zeros()
            column = self._entering(cost, idle >= PATIENCE)
            index = None if column is None else self._leaving(column)
            if column is None or index is None:
                return False
            self._pivot(index, column, cost)
            idle = idle + 1 if cost.get(RIGHT, ZERO) == left else 0
        return False

    def _cheapest(self, costs: Row) -> bool:
        """Afterwards the costs are as small as they can be; False if that is not reached."""
        for i, basis in enumerate(self.bases):
            if basis < 0:
                column = next((k for k in sorted(self.rows[i]) if k != RIGHT), None)
                if column is not None:
                    self._pivot(i, column, costs)
        for row, basis in zip(self.rows, self.bases, strict=True):
            if basis in costs:
                self._subtract(costs, row, costs[basis])
        for step in range(MAX_STEPS):
            column = self._entering({k: -c for k, c in costs.items()}, step >= PATIENCE)
            if column is None:
                return not any(k >= self.n for k in costs)
            index = self._leaving(column)
            if index is None:
                return False
            self._pivot(index, column, costs)
        return False

    def _only_zeros(self) -> bool:
        """What artificial variables are left is 0."""
        return all(
            basis >= 0 or not row.get(RIGHT, ZERO)
            for row, basis in zip(self.rows, self.bases, strict=True)
        )

    @staticmethod
    def _entering(cost: Row, first: bool) -> int | None:
        gains = [(k, value) for k, value in cost.items() if k != RIGHT and value > 0]
        if not gains:
            return None
        return min(gains)[0] if first else max(gains, key=lambda pair: (pair[1], -pair[0]))[0]

    def _leaving(self, column: int) -> int | None:
        best: tuple[fmpq, int] | None = None
        chosen = None
        for i, row in enumerate(self.rows):
            value = row.get(column, ZERO)
            if value > 0:
                ratio = row.get(RIGHT, ZERO) / value, self.bases[i]
                if best is None or ratio < best:
                    best, chosen = ratio, i
        return chosen

    def _pivot(self, index: int, column: int, cost: Row) -> None:
        pivot = self.rows[index]
        self._divide(pivot, pivot[column])
        for row in (*self.rows, cost):
            if row is not pivot and column in row:
                self._subtract(row, pivot, row[column])
        self.bases[index] = column

    def _divide(self, row: Row, number: fmpq) -> None:
        for k in row:
            row[k] /= number

    def _subtract(self, row: Row, other: Row, number: fmpq) -> None:
        self.budget.spend(ENTRY * len(other))
        for k, value in other.items():
            new = row.get(k, ZERO) - number * value
            if new:
                row[k] = new
            else:
                row.pop(k, None)
