"""An outcome whose enclosures are as narrow as somebody asks."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction

from verify.language.terms import Claim, Term
from verify.prover import balls
from verify.prover.decimals import outward
from verify.prover.outcome import Enclosure, Ends, Outcome
from verify.prover.program import Machine, Program, Run
from verify.views.words import definitions_of

#: Bits beyond those asked for; what cancels in the formulas takes some of them.
GUARD_BITS = 64


def sharpened(outcome: Outcome, bits: int) -> Outcome:
    """The same outcome with enclosures from at least ``bits`` bits; no decision changes.

    An enclosure that would not be narrower stays.
    """
    program = Program(())
    for name, term in definitions_of(outcome).items():
        program.define(name, term)
    with balls.precision(bits + GUARD_BITS):
        run = Machine(program, balls.BallArithmetic()).run(())
        known = definitions_of(outcome)
        enclosures = {
            name: _narrower(run, old, (known[name],), bits)
            for name, old in outcome.enclosures.items()
        }
        decisions = dict(outcome.decisions)
        for row, found in outcome.rows:
            if found.sides is not None and isinstance(row.claim, Claim):
                sides = _narrower(run, found.sides, (row.claim.lhs, row.claim.rhs), bits)
                decisions[row.name] = found._replace(sides=sides)
    return outcome._replace(enclosures=enclosures, decisions=decisions)


def _narrower(run: Run, old: Enclosure, terms: Iterable[Term], bits: int) -> Enclosure:
    ends = (_ends(run, before, term, bits) for before, term in zip(old.ends, terms, strict=True))
    return old._replace(ends=tuple(ends))


def _ends(run: Run, old: Ends, term: Term, bits: int) -> Ends:
    ball = run[term]
    if ball is None:
        return old
    low, high = map(Fraction, outward(balls.ends(ball), int(bits * 0.30103) + 3))
    return (low, high) if high - low < old[1] - old[0] else old
