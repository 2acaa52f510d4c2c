"""Terms as functions of two (or one) parameters, enclosed and judged on whole cells."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction

from verify.prover import balls
from verify.views.plots.slopes import Side, Slope, SlopeArithmetic
from verify.prover.program import Program, UndefinedError
from verify.prover.ground import PROVED, REFUTED, UNDECIDED, Ends
from verify.language.terms import Claim, Term

Cell = tuple[Side, ...]

#: A relation, and where the two sides of a claim are kept.
Slots = tuple[str, int, int]


class Field:
    """A program over parameters that vary.

    Args:
        inputs: the parameters that vary, in the order of a cell's sides.
        definitions: a term for each further name, in order.
    """

    def __init__(self, inputs: Sequence[str], definitions: Iterable[tuple[str, Term]]) -> None:
        self._program = Program(inputs)
        self.code: dict[int, tuple[str, int, int]] = {}
        self.leaves: dict[int, Fraction] = {}
        for name, term in definitions:
            self._program.define(name, term)

    def slot(self, term: Term) -> int:
        """Where the value of a term is kept."""
        slot = self._program.add(term)
        for new, op, left, right in self._program.code[len(self.code) :]:
            self.code[new] = (op, left, right)
        self.leaves.update(self._program.leaves[len(self.leaves) :])
        return slot

    def slots(self, claims: Mapping[str, Claim]) -> dict[str, Slots]:
        """Each claim, compiled."""
        return {
            name: (claim.relation, self.slot(claim.lhs), self.slot(claim.rhs))
            for name, claim in claims.items()
        }

    def on(self, cell: Cell) -> Values:
        """The values on a cell, at the current precision."""
        return Values(self, cell)


class Values:
    """The values of a field on one cell, each computed when it is first asked for."""

    def __init__(self, field: Field, cell: Cell) -> None:
        self._arithmetic = SlopeArithmetic(cell)
        self._known: dict[int, Slope | None] = dict(enumerate(self._arithmetic.inputs))
        self._field = field

    def __getitem__(self, term: Term) -> Slope | None:
        """The value of a term; None where it is undefined somewhere, or not enclosed."""
        return self.at(self._field.slot(term))

    def at(self, slot: int) -> Slope | None:
        """The value of a slot of the program."""
        if slot not in self._known:
            self._known[slot] = self._compute(slot)
        return self._known[slot]

    def _compute(self, slot: int) -> Slope | None:
        if slot in self._field.leaves:
            return self._arithmetic.rational(self._field.leaves[slot])
        op, left, right = self._field.code[slot]
        a = self.at(left)
        b = None if right < 0 else self.at(right)
        if a is None or (b is None and right >= 0):
            return None
        return self.apply(op, a) if b is None else self.apply(op, a, b)

    def apply(self, op: str, *operands: Slope) -> Slope | None:
        """One more operation."""
        try:
            return self._arithmetic.operation(op)(*operands)
        except UndefinedError:
            return None

    def judge(self, row: Slots) -> str:
        """Whether a claim (see `Field.slots`) holds, or fails, at every point of the cell.

        The sign of the difference decides: its slopes cancel what both sides share.
        """
        relation, left, right = row
        lhs, rhs = self.at(left), self.at(right)
        difference = None if lhs is None or rhs is None else self.apply("sub", rhs, lhs)
        if difference is None:
            return UNDECIDED
        ball = difference.range
        if relation == "<":
            holds, fails = ball > 0, ball <= 0
        else:
            holds, fails = ball >= 0, ball < 0
        return PROVED if holds else REFUTED if fails else UNDECIDED

    def ratio(self, row: Slots) -> Ends | None:
        """An enclosure of lhs/rhs on the cell."""
        lhs, rhs = self.at(row[1]), self.at(row[2])
        quotient = None if lhs is None or rhs is None else self.apply("div", lhs, rhs)
        return None if quotient is None else balls.ends(quotient.range)


def bisected(cell: Cell, index: int) -> tuple[Cell, Cell]:
    """The two halves of a cell along one side."""
    low, high = cell[index]
    middle = (low + high) / 2
    halves = []
    for part in ((low, middle), (middle, high)):
        sides = list(cell)
        sides[index] = part
        halves.append(tuple(sides))
    return halves[0], halves[1]
