"""Covers: terms over a few parameters, judged on whole boxes, which are cut where that is needed.

A verdict on a box holds at every point of it; the boxes of a cover together are the box that was
asked for, except those that were left out by name. Nothing here is trusted, and no certificate is
written: these are rigorous enclosures by balls, for maps of what holds where.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from fractions import Fraction
from typing import TypeVar

from verify.language.statement import PROVED, REFUTED, UNDECIDED
from verify.language.terms import Claim, Term
from verify.prover import balls
from verify.prover.outcome import Ends
from verify.prover.program import Program, UndefinedError
from verify.prover.relations import fails, holds
from verify.prover.slopes import BITS, Side, Slope, SlopeArithmetic

Box = tuple[Side, ...]

#: A relation, and where the two sides of a claim are kept.
Slots = tuple[str, int, int]

Known = TypeVar("Known")


class Field:
    """A program over parameters that vary.

    Args:
        inputs: the parameters that vary, in the order of a box's sides.
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

    def on(self, box: Box) -> Values:
        """The values on a box, at the current precision."""
        return Values(self, box)


class Values:
    """The values of a field on one box, each computed when it is first asked for."""

    def __init__(self, field: Field, box: Box) -> None:
        self._arithmetic = SlopeArithmetic(box)
        self._known: dict[int, Slope | None] = dict(enumerate(self._arithmetic.inputs))
        self._field = field
        self._zero = balls.from_fraction(Fraction(0))

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

    def ends(self, term: Term) -> Ends | None:
        """An enclosure of a term on the box."""
        slope = self[term]
        return None if slope is None else balls.ends(slope.range)

    def judge(self, row: Slots) -> str:
        """Whether a claim (see `Field.slots`) holds, or fails, at every point of the box.

        The sign of the difference decides: its slopes cancel what both sides share.
        """
        relation, left, right = row
        lhs, rhs = self.at(left), self.at(right)
        difference = None if lhs is None or rhs is None else self.apply("sub", rhs, lhs)
        if difference is None:
            return UNDECIDED
        if holds(relation, self._zero, difference.range):
            return PROVED
        return REFUTED if fails(relation, self._zero, difference.range) else UNDECIDED

    def positive(self, slot: int) -> bool:
        """True only if the value of a slot is positive at every point of the box."""
        value = self.at(slot)
        return value is not None and balls.strict_sign(value.range) > 0

    def ratio(self, row: Slots) -> Ends | None:
        """An enclosure of lhs/rhs on the box."""
        lhs, rhs = self.at(row[1]), self.at(row[2])
        quotient = None if lhs is None or rhs is None else self.apply("div", lhs, rhs)
        return None if quotient is None else balls.ends(quotient.range)

    def least(self, slots: Sequence[int]) -> int | None:
        """The index of a value that is at most each other one at every point of the box.

        Where two may be equal there is none.
        """
        entries = [entry for slot in slots if (entry := self.at(slot)) is not None]
        if len(entries) < len(slots):
            return None
        index = min(range(len(entries)), key=lambda i: float(balls.middle(entries[i].centre)))
        for other, entry in enumerate(entries):
            difference = self.apply("sub", entry, entries[index])
            if other != index and (difference is None or balls.sign(difference.range) != 1):
                return None
        return index


def refined(
    field: Field,
    start: Box,
    depth: int,
    first: Known,
    judge: Callable[[Values, Known], tuple[Known, bool] | None],
) -> list[tuple[Box, int, Known]]:
    """The boxes of a cover of ``start``, each with its weight and what is known on it.

    Args:
        field: what is evaluated.
        start: the whole box.
        depth: how many times each side is halved at most.
        first: what is known on the whole box before it is looked at.
        judge: what is known on a box, given what is known on a larger one, and whether that is
            enough; None leaves the box out.
    """
    found: list[tuple[Box, int, Known]] = []
    todo = [(start, 1 << len(start) * depth, first)]
    with balls.precision(BITS):
        while todo:
            box, weight, before = todo.pop()
            result = judge(field.on(box), before)
            if result is None:
                continue
            known, enough = result
            if enough or weight == 1:
                found.append((box, weight, known))
            else:
                todo += [(part, weight >> len(box), known) for part in parts(box)]
    return sorted(found, key=lambda item: item[0])


def parts(box: Box) -> list[Box]:
    """The parts of a box after halving each side."""
    found: list[Box] = [()]
    for low, high in box:
        middle = (low + high) / 2
        found = [(*part, side) for part in found for side in ((low, middle), (middle, high))]
    return found
