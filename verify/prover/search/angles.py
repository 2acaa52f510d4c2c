"""A claim with cosines as one that is linear in them, by the relations between them.

A claim that is polynomial in cosines becomes linear in them: products are replaced by sums, and
each angle is written in one way, up to its sign.
"""

from __future__ import annotations

from fractions import Fraction
from math import ceil

from verify.language.terms import Term, as_term, names_of, symbol
from verify.prover.balls import fraction_of
from verify.prover.clearing import Clearing, Polynomial
from verify.prover.cosines import HALF, Relations
from verify.prover.goal import Goal
from verify.prover.proof import Proof
from verify.prover.rules import Sum
from verify.prover.session import Session

COSINES = ("cos", "cos_pi")
#: Products of more cosines are left alone.
MAX_FACTORS = 8
MAX_PARTS = 200


class Linear:
    """The difference of the sides of a claim as a sum of cosines times polynomials.

    ``parts`` has the polynomials, by the cosines, or None; lhs - rhs is their sum and that of the
    ``equations``, which have cofactors, if what ``using`` names is replaced.
    """

    def __init__(self, goal: Goal, session: Session, using: tuple[str, ...]) -> None:
        self.relations = Relations(session, goal.context)
        claim, replaced = goal.claim, {symbol(n): t for n, t in goal.definitions.items()}
        self.clearing = Clearing((claim.lhs, claim.rhs), replaced)
        self.atoms = self.clearing.atoms
        self.cosines = [i for i, atom in enumerate(self.atoms) if atom.op in COSINES]
        self.using, self.equations = dict.fromkeys(using), dict[str, Term]()
        self.parts: dict[Term | None, Polynomial] = {}
        self.is_plain = bool(self.cosines) and all(
            self._is_simple(self.atoms[i], set(goal.definitions)) for i in self.cosines
        )
        if self.is_plain:
            self._collect(self.clearing.difference(claim.lhs, claim.rhs))

    def _is_simple(self, cosine: Term, defined: set[str]) -> bool:
        """The angle is a polynomial in names without definitions."""
        angle = cosine.children[0]
        n, d = self.clearing.clear(angle)
        inner = [i for i, degree in enumerate(n.degrees()) if degree > 0]
        return (
            d == self.clearing.one
            and not defined & {*names_of(angle)}
            and all(self.atoms[i].op == "symbol" for i in inner)
        )

    def angle(self, cosine: Term) -> Polynomial:
        """The angle as a polynomial."""
        return self.clearing.clear(cosine.children[0])[0]

    def at(self, op: str, angle: Polynomial) -> tuple[Term, bool]:
        """The cosine with this angle or its opposite, and whether it is the former."""
        terms = angle.to_dict()
        same = not terms or terms[max(terms)] > 0
        return Term(op, self.clearing.term(angle if same else -angle)), same

    def _collect(self, p: Polynomial) -> None:
        waiting: list[tuple[list[Term], Polynomial]] = []
        for monomial, value in p.to_dict().items():
            factors = [self.atoms[i] for i in self.cosines for _ in range(int(monomial[i]))]
            rest = tuple(0 if i in self.cosines else e for i, e in enumerate(monomial))
            if len(factors) > MAX_FACTORS:
                self.is_plain = False
                return
            coefficient = self.clearing.context.from_dict({rest: value})
            waiting.append(self._canonical(factors, coefficient))
        while waiting:
            factors, coefficient = waiting.pop()
            if len(waiting) > MAX_PARTS:
                self.is_plain = False
                return
            if len(factors) < 2 or len({factor.op for factor in factors[:2]}) > 1:
                self.is_plain &= len(factors) < 2
                key = factors[0] if factors else None
                self.parts[key] = self.parts.get(key, 0 * coefficient) + coefficient
                continue
            waiting += self._split(factors, coefficient)

    def _canonical(
        self, cosines: list[Term], coefficient: Polynomial
    ) -> tuple[list[Term], Polynomial]:
        """The same product, with each angle written in one way."""
        found = []
        for cosine in cosines:
            other, turns, same = self._turned(cosine)
            if turns:
                angle = cosine.children[0], other.children[0]
                self.using[self.relations.turned(*angle, turns, same=same)] = None
            elif other != cosine:
                self.using[self.relations.written(cosine, other, same=same)] = None
            coefficient = coefficient * (-1) ** (turns % 2)
            if other in (Term(other.op, as_term(0)), Term("cos_pi", as_term(HALF))):
                value = int(other.children[0] == as_term(0))
                self.using[self.relations.exact(other, value)] = None
                coefficient = coefficient * value
            else:
                found.append(other)
        return found, coefficient

    def _turned(self, cosine: Term) -> tuple[Term, int, bool]:
        """The cosine of an angle near 0, how many turns by pi that is, and whether not opposite."""
        angle = self.angle(cosine)
        if cosine.op == "cos":
            other, same = self.at("cos", angle)
            return other, 0, same
        sign = 1 if self.at("cos_pi", angle)[1] else -1
        number = (angle * sign).to_dict().get((0,) * len(self.atoms))
        turns = ceil(fraction_of(number) - HALF) if number is not None else 0
        other, same = self.at("cos_pi", angle * sign - self.clearing.constant(Fraction(turns)))
        return other, turns * sign, same == (sign == 1)

    def _split(
        self, factors: list[Term], coefficient: Polynomial
    ) -> list[tuple[list[Term], Polynomial]]:
        """The first two factors are half the sum of two other cosines."""
        first, second, *rest = factors
        u, v = (self.clearing.clear(factor.children[0])[0] for factor in (first, second))
        if not self.at(first.op, u - v)[1]:
            first, second, u, v = second, first, v, u
        sums = [self.at(first.op, angle)[0] for angle in (u + v, u - v)]
        name = self.relations.product(first, second, *sums)
        half = self.clearing.constant(HALF) * coefficient
        cofactor = self.clearing.term(half)
        for factor in rest:
            cofactor = cofactor * factor
        known = self.equations.get(name)
        self.equations[name] = cofactor if known is None else known + cofactor
        found = [self._canonical([cosine], half) for cosine in sums]
        return [([*cosines, *rest], number) for cosines, number in found]

    def identity(self, relation: str) -> Proof | None:
        """A proof if the sides are the same."""
        if not self.is_plain or relation == "<" or any(p.to_dict() for p in self.parts.values()):
            return None
        addends = () if relation == "=" else ("goal",)
        return Sum(addends, tuple(self.using), self.cofactors(1 if relation == "=" else -1))

    def cofactors(self, sign: int) -> tuple[tuple[str, Term], ...]:
        """The equations with their cofactors, or the opposite ones."""
        return tuple((n, t if sign == 1 else -t) for n, t in self.equations.items())
