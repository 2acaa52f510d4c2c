"""Values of an expression at sampled inputs, by balls: no number is too large or small for one."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from typing import Any

from verify.language.statement import Constant
from verify.language.terms import Claim, Term, symbol
from verify.prover import balls
from verify.prover.program import Machine, Program
from verify.wire.inputs import MAX_EXPONENT

#: Bits of the bounds of inputs, which are rounded inwards, and of what is computed with them.
BITS_OF_ENDS, BITS = 64, 256
#: Values are written with at most about so many bits before the point, or after it.
MOST_BITS = MAX_EXPONENT * 3322 // 1000
#: A value of which fewer bits are known counts with both of its ends.
FEW_BITS = 40
#: What is nearer to zero counts as zero.
TINY = balls.as_ball(balls.ratio(1, 1 << MOST_BITS))

#: Balls that are exact numbers.
Ends = tuple[Any, Any]


class NoValueError(ArithmeticError):
    """At an input that was sampled no value was found, or one that is too long to be written."""


class Samples:
    """An expression with the claims that say what its inputs are."""

    def __init__(
        self, variables: Sequence[str], claims: Sequence[Claim], constants: Sequence[Constant]
    ) -> None:
        self.variables, self.claims = [*variables], [*claims]
        self._constants = constants

    def range(self, name: str) -> tuple[Fraction | None, Fraction | None]:
        """The numbers between which the claims put an input: both are inputs, or are near one."""
        with balls.precision(BITS_OF_ENDS):
            run = self._machine().run([None] * len(self.variables))
            lows = [run[c.lhs] for c in self.claims if c.rhs == symbol(name)]
            highs = [run[c.rhs] for c in self.claims if c.lhs == symbol(name)]
            below = [balls.ends(ball)[1] for ball in lows if ball is not None]
            above = [balls.ends(ball)[0] for ball in highs if ball is not None]
        return max(below, default=None), min(above, default=None)

    def values(self, term: Term, points: Iterable[Sequence[Any]]) -> Iterator[Ends]:
        """Numbers between which the values of a term are at those of the points that are inputs.

        The numbers of a point are rational ones of FLINT.

        Raises:
            NoValueError: where there is none at an input.
        """
        with balls.precision(BITS):
            machine = self._machine()
            add = machine.program.add
            place = add(term)
            sides = [(add(c.lhs), add(c.rhs), c.relation) for c in self.claims]
            for point in points:
                found = machine.run(map(balls.as_ball, point)).values
                where = self._where([(found[a], found[b], how) for a, b, how in sides])
                if where == "outside":
                    continue
                ball = found[place]
                if ball is not None and balls.magnitude_bits(ball) <= MOST_BITS:
                    yield _ends(ball)
                elif where == "inside":
                    raise NoValueError

    def _machine(self) -> Machine:
        program = Program(self.variables)
        for constant in self._constants:
            program.define(constant.name, constant.term)
        return Machine(program, balls.BallArithmetic())

    def _where(self, sides: Sequence[tuple[Any, Any, str]]) -> str:
        """Whether a point satisfies the claims, with an equation read as an inequality.

        A point at which sides that have to differ are equal is at the edge, and no input itself.
        """
        if any(a is None or b is None or balls.less(b, a) for a, b, _ in sides):
            return "outside"
        at_edge = any(how == "<" and not balls.less(a, b) for a, b, how in sides)
        return "edge" if at_edge else "inside"


def _ends(ball: Any) -> Ends:
    """The middle of a ball twice, or the ends of one that is not known well."""
    if -TINY < ball < TINY:
        ball = balls.as_ball(0)
    if balls.accuracy_bits(ball) >= FEW_BITS:
        return (balls.middle(ball),) * 2
    return balls.exact_ends(ball)
