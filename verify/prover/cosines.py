"""Relations between cosines, from 2 cos u cos v = cos(u + v) + cos(u - v): lemmas by *angles*."""

from __future__ import annotations

from fractions import Fraction

from verify.language.terms import Term, as_term, equal
from verify.prover.clearing import Clearing
from verify.prover.rules import Angles, Interval, Sum
from verify.prover.session import Session

HALF = Fraction(1, 2)


class Relations:
    """Lemmas about cosines at one place."""

    def __init__(self, session: Session, context: str | None) -> None:
        self.session, self.context = session, context

    def exact(self, cosine: Term, value: int) -> str:
        """Cos 0 = 1, and what cos_pi is at multiples of 1/2."""
        return self.session.ensure(equal(cosine, as_term(value)), Interval(64))

    def product(self, u: Term, v: Term, total: Term, rest: Term) -> str:
        """The fact 2 cos u cos v = cos(u + v) + cos(u - v), with cosines that are given."""
        return self.session.ensure(equal(2 * (u * v), total + rest), Angles(), self.context)

    def written(self, cosine: Term, other: Term, *, same: bool) -> str:
        """Cosine = other, whose angle is the same, or the opposite one."""
        zero = Term(cosine.op, as_term(0))
        pair = (other, zero, cosine, other) if same else (zero, other, other, cosine)
        product = self.product(*pair)
        proof = Sum((), (self.exact(zero, 1),), ((product, as_term(-1)),))
        return self.session.ensure(equal(cosine, other), proof, self.context)

    def turned(self, angle: Term, other: Term, turns: int, *, same: bool) -> str:
        """The fact cos_pi(angle) = (-1)^turns cos_pi(other).

        The other angle is angle - turns (``same``), or its opposite.
        """
        cosine, found = Term("cos_pi", angle), Term("cos_pi", other)
        if turns == 0:
            return self.written(cosine, found, same=same)
        if turns % 2 == 0:
            middle = 1 - angle
            first = self.turned(angle, middle, 1, same=False)
            second = self.turned(middle, other, 1 - turns, same=not same)
            return self.session.ensure(equal(cosine, found), Sum((), (first, second)), self.context)
        half = as_term(Fraction(turns, 2))
        u, v = Term("cos_pi", angle - half), Term("cos_pi", half)
        product = self.product(*((u, v) if same else (v, u)), cosine, found)
        proof = Sum((), (self.exact(v, 0),), ((product, as_term(-1)),))
        return self.session.ensure(equal(cosine, -found), proof, self.context)


def chebyshev(cosine: Term, k: int) -> Term:
    """The polynomial in a cosine that is the cosine of k times its angle."""
    clearing = Clearing((cosine,), {})
    x = clearing.generators[cosine]
    found = [clearing.one, x]
    while len(found) <= k:
        found.append(2 * x * found[-1] - found[-2])
    return clearing.term(found[k])
