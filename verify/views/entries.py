"""The entries of the constants that are minima, enclosed for the views that show them."""

from __future__ import annotations

from fractions import Fraction

from verify.language.record import Record
from verify.language.statement import Constant
from verify.language.terms import names_of
from verify.prover.decimals import outward
from verify.prover.outcome import Ends, Outcome
from verify.views.words import SHOWN_BITS, ends_of

#: Digits of the entries of minima, as many as enclosures of constants have.
SHOWN_DIGITS = 27


class Minimum(Record):
    """The entries of a min, and the number (from 1) of the one that is shown to be the least."""

    entries: list[Ends | None]
    least: int | None


def minimum_of(outcome: Outcome, constant: Constant) -> Minimum:
    """The entries of a constant's min, enclosed from the enclosures of the constants in them."""
    from verify.prover import balls  # flint is loaded only where it is used
    from verify.prover.program import Machine, Program

    entries = constant.term.children
    names = sorted({name for entry in entries for name in names_of(entry)})
    with balls.precision(SHOWN_BITS):
        machine = Machine(Program(names), balls.BallArithmetic())
        known = [ends_of(outcome, name) for name in names]
        inputs = [None if k is None else balls.hull(*map(balls.from_fraction, k)) for k in known]
        run = machine.run(inputs)
        values = [run[entry] for entry in entries]
        ends = [None if value is None else _rounded(balls.ends(value)) for value in values]
    return Minimum(ends, _least(ends))


def _rounded(ends: Ends) -> Ends:
    low, high = map(Fraction, outward(ends, SHOWN_DIGITS))
    return low, high


def _least(entries: list[Ends | None]) -> int | None:
    known = [pair for pair in entries if pair is not None]
    for number, (_, high) in enumerate(known, 1):
        others = known[: number - 1] + known[number:]
        if len(known) == len(entries) and all(high <= low for low, _ in others):
            return number
    return None
