"""Claims with cosines that hold with equality somewhere: polynomial bounds by the rule *cosine*.

With lhs - rhs = a + sum of b_i C_i, linear in cosines C_i, each C_i is replaced by a polynomial in
its angle, above it or below as the sign of b_i requires. What is left is a claim on polynomials: on
the whole domain, which other techniques prove; or, in one variable, on parts of an interval, by
Bernstein coefficients, beside parts where enclosures decide.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import floor

from verify.language.record import Record
from verify.language.terms import Claim, Term, as_term
from verify.prover.balls import fmpq_of
from verify.prover.clearing import Polynomial
from verify.prover.cosines import HALF
from verify.prover.goal import Bounds
from verify.prover.proof import Proof, Value
from verify.prover.rules import Cosine, Sum
from verify.prover.search.angles import Linear
from verify.prover.search.question import Question
from verify.prover.session import ZERO

#: Rational bounds of pi.
PI = (Fraction(3141592653589793, 10**15), Fraction(3141592653589794, 10**15))
#: Where a polynomial is tried first, as shares of the ranges of variables.
SHARES = [Fraction(k, 47) for k in range(48)]
#: Of what is left to other techniques.
MAX_DEGREE = 8


class Bounding(Record):
    """A polynomial above a cosine or below it: where its angle is 0, and what shows it."""

    centre: Fraction  # a multiple of 1/2, of the angle
    sign: int  # of the powers of the distance from the centre, for odd ones
    length: int
    is_above: bool
    polynomial: Polynomial


def series(op: str, length: int, first: int, *, is_above: bool) -> list[Fraction]:
    """Coefficients of a bound of cos u, or cos(pi u), in u^2; with ``first`` = 1 of sin(pi u)."""
    found, factorial = [], 1
    for k in range(length):
        n = 2 * k + first
        factorial *= max(1, n * (n - 1)) if k else 1
        upward = (k % 2 == 0) == is_above
        scale = Fraction(1) if op == "cos" else PI[upward] ** n
        exact = Fraction((-1) ** k * scale, factorial)
        if exact.denominator > 10**20 and op == "cos_pi":
            exact = Fraction(floor(exact * 10**20) + is_above, 10**20)
        found.append(exact)
    return found


class CosineBounds:
    """Proofs of one claim that is linear in cosines."""

    def __init__(self, question: Question, linear: Linear) -> None:
        self.question, self.goal, self.linear = question, question.goal, linear
        self.relations, self.clearing = linear.relations, linear.clearing
        self.ring, self.one = self.clearing.context, self.clearing.one
        self.constant = linear.parts.get(None, 0 * self.one)
        self.parts = {c: p for c, p in linear.parts.items() if c is not None and p.to_dict()}
        self.facts: dict[tuple[object, ...], str | None] = {}

    # --- bounds ---------------------------------------------------------------------------------

    def bound(
        self, cosine: Term, centre: Fraction, sign: int, length: int, above: bool
    ) -> Bounding:
        """The polynomial with about so many terms, around a centre."""
        turns, odd = self.turns(centre, sign)
        is_above = above != bool(turns % 2)
        length += (length % 2 == 0) == is_above
        u = (self.linear.angle(cosine) - self.clearing.constant(centre)) * sign
        numbers = series(cosine.op, length, int(odd), is_above=is_above)
        total = 0 * self.one
        for k, number in enumerate(numbers):
            total += self.clearing.constant(number) * u ** (2 * k + odd)
        return Bounding(centre, sign, length, above, total * (-1) ** (turns % 2))

    def turns(self, centre: Fraction, sign: int) -> tuple[int, bool]:
        """How often pi is subtracted so that a cosine, or a sine, remains."""
        if centre.denominator == 1:
            return int(centre), False
        return int(centre - HALF if sign < 0 else centre + HALF), True

    def fact(self, cosine: Term, bound: Bounding) -> str | None:
        """The name of the fact that a bound is one."""
        key = cosine, bound.centre, bound.sign, bound.length, bound.is_above
        if key not in self.facts:
            self.facts[key] = self._fact(cosine, bound)
        return self.facts[key]

    def _fact(self, cosine: Term, bound: Bounding) -> str | None:
        (angle,) = cosine.children
        turns, odd = self.turns(bound.centre, bound.sign)
        u = angle if not bound.centre else angle - as_term(bound.centre)
        if bound.sign < 0:
            u = as_term(bound.centre) - angle
        if odd and self.question.fact(Claim("<=", ZERO, u)) is None:
            return None
        is_above = bound.is_above != bool(turns % 2)
        length = bound.length
        numbers = series(cosine.op, length, int(odd), is_above=is_above)
        side = as_term(numbers[-1])
        for number in reversed(numbers[:-1]):
            side = as_term(number) + u**2 * side
        side = u * side if odd else side
        other = HALF - u if odd else u
        found = Term(cosine.op, as_term(HALF) - u if odd else other)
        sides = (found, side) if is_above else (side, found)
        name = self.relations.session.ensure(Claim("<=", *sides), Cosine(), self.goal.context)
        if found == cosine:
            return name
        equation = self.relations.turned(
            angle, found.children[0], turns, same=not odd or bound.sign < 0
        )
        mine = -side if turns % 2 else side
        sides = (cosine, mine) if bound.is_above else (mine, cosine)
        proof = Sum(("goal", name), (equation,))
        return self.relations.session.ensure(Claim("<=", *sides), proof, self.goal.context)

    def least(self, cosine: Term) -> str:
        """The name of the fact -1 <= cosine."""
        (angle,) = cosine.children
        half = Term(cosine.op, angle / 2)
        zero = Term(cosine.op, ZERO)
        product = self.relations.product(half, half, cosine, zero)
        proof = Sum(
            ("goal", ("mul", "2", ("square", half))),
            (self.relations.exact(zero, 1),),
            ((product, as_term(-1)),),
        )
        return self.relations.session.ensure(
            Claim("<=", as_term(-1), cosine), proof, self.goal.context
        )

    # --- the whole domain -----------------------------------------------------------------------

    def whole(self, length: int) -> Proof | None:
        """Bounds around 0, or -1 and 1, everywhere."""
        addends: list[Value] = []
        rest = -self.constant
        for cosine, b in self.parts.items():
            if not b.is_constant():
                return None
            above = self.clearing.term(b).value > 0
            number = str(abs(self.clearing.term(b).value))
            bound = self.bound(cosine, Fraction(0), 1, length, above)
            polynomial = bound.polynomial
            fact = None
            if length == 1 and not above:
                polynomial = -self.one
                fact = self.least(cosine)
            rest -= b * polynomial
            addends.append(("mul", number, fact or self.fact(cosine, bound) or ""))
        if rest.total_degree() > MAX_DEGREE or not self._is_in_symbols(rest):
            return None
        if self._fails(rest):
            return None
        claim = Claim(self.goal.claim.relation, ZERO, self.clearing.term(rest))
        if self.is_false(claim):
            return None
        name = self.question.fact(claim)
        if name is None:
            return None
        return self.sum([*addends, name])

    def _is_in_symbols(self, p: Polynomial) -> bool:
        degrees = zip(self.linear.atoms, p.degrees(), strict=True)
        return all(atom.op == "symbol" for atom, degree in degrees if degree > 0)

    def _fails(self, p: Polynomial) -> bool:
        """Whether a polynomial is negative at one of some points that cost little."""
        for share in SHARES:
            values = []
            for atom in self.linear.atoms:
                bounds = self.goal.variables.get(atom.name) if atom.op == "symbol" else None
                low, high = _near(bounds or Bounds())
                value = low + (high - low) * share
                values.append(fmpq_of(value))
                share = share * 7 % 1  # another one for each variable
            if p(*values) < 0:
                return True
        return False

    def is_false(self, claim: Claim) -> bool:
        """Whether some point shows at once that a claim is false."""
        known = self.question.known
        minima = Question(known.goal(claim, self.goal.context), known).minima
        return bool(minima) and minima[0][0] < -1e-9

    def sum(self, addends: Sequence[Value]) -> Proof:
        """The goal, what is added to it, and what replaces the products of cosines."""
        return Sum(("goal", *addends), tuple(self.linear.using), self.linear.cofactors(-1))


def _near(bounds: Bounds) -> tuple[Fraction, Fraction]:
    """Both ends, or a number beside the one that there is."""
    low, high = bounds.low, bounds.high
    if low is None:
        low = Fraction(-8) if high is None else high - 16
    return low, low + 16 if high is None else high
