"""A claim as a polynomial in scaled variables, with the polynomials that facts say are >= 0.

Where lhs < rhs or lhs <= rhs is to be shown, p is the polynomial whose sign is that of rhs - lhs.
A variable x is replaced by the u in [-1, 1] with x = m + h u if it lies between two numbers, and by
its distance from a bound if it has only one.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from math import prod

from flint import fmpq, fmpq_mpoly

from verify.language.record import Record
from verify.language.terms import Claim, Term, symbol
from verify.prover.balls import fmpq_of, fraction_of
from verify.prover.clearing import BITS, Clearing, TooLongError, coefficients, expanded
from verify.prover.goal import Bounds, Goal
from verify.prover.proof import Value

#: Monomials, in scaled variables, of a polynomial that is looked at.
MAX_MONOMIALS = 200_000


class Factor(Record):
    """A polynomial in the scaled variables that is >= 0, or > 0 if strict, and its value.

    ``parts`` are the polynomials, not scaled, that the checker multiplies for it.
    """

    polynomial: fmpq_mpoly
    value: Value
    strict: bool
    parts: tuple[fmpq_mpoly, ...]


class Affine(Record):
    """An atom is m + h u, where h is not 0."""

    m: Fraction
    h: Fraction


class Domain:
    """The atoms of a claim and of facts about them, scaled.

    ``facts`` are inequalities by name, ``equations`` what replaces atoms. Roots are atoms, which
    are >= 0, with the squares of them replaced.
    """

    def __init__(
        self,
        goal: Goal,
        facts: Mapping[str, Claim],
        equations: Mapping[Term, Term] | None = None,
        is_negative: Callable[[Term], bool] | None = None,
    ) -> None:
        claim = goal.claim
        sides = [term for fact in facts.values() for term in (fact.lhs, fact.rhs)]
        replaced = {symbol(name): term for name, term in goal.definitions.items()}
        replaced |= equations or {}
        self.clearing = Clearing((claim.lhs, claim.rhs, *sides), replaced, is_negative)
        self.atoms: Sequence[Term] = self.clearing.atoms
        self.context = self.clearing.context
        self.gens = self.context.gens()
        scaled = [
            _scaled(goal.variables.get(a.name) if a.op == "symbol" else None) for a in self.atoms
        ]
        self.scales = [scale for scale, _ in scaled]
        #: Between which numbers each scaled variable is, if there are any.
        self.ends = [ends for _, ends in scaled]
        self._inward = [
            self.number(s.m) + self.number(s.h) * u
            for s, u in zip(self.scales, self.gens, strict=True)
        ]
        self._outward = [
            (x - self.number(s.m)) * self.number(1 / s.h)
            for s, x in zip(self.scales, self.gens, strict=True)
        ]
        one = self.clearing.one
        clear = self.clearing.clear
        self.has_denominators = any(clear(t)[1] != one for t in (claim.lhs, claim.rhs, *sides))
        roots = [(i, clear(a.children[0])) for i, a in enumerate(self.atoms) if a.op == "sqrt"]
        #: The squares of roots, the latest first; a root of a quotient makes a domain not plain.
        self.squares = [(i, n.compose(*self._inward)) for i, (n, d) in reversed(roots) if d == one]
        self.is_plain = len(self.squares) == len(roots)
        self.p = self.reduced(self.scaled(self.clearing.difference(claim.rhs, claim.lhs)))
        self.strict = claim.relation == "<"
        self.whole = self.p  # with the squares that p may have lost
        #: Its value with the other sign, which is > 0 (>= 0 if strict) if the claim fails.
        self.goal: Value = "goal"
        self.facts = {name: self._factor(name, fact) for name, fact in facts.items()}
        for i, _ in roots:
            value: Value = ("root", self.atoms[i])
            self.facts[f"root {i}"] = Factor(self.gens[i], value, False, (self.gens[i],))

    def number(self, value: Fraction | int) -> fmpq_mpoly:
        """A number as a polynomial."""
        value = Fraction(value)
        return self.context.constant(fmpq_of(value))

    def scaled(self, polynomial: fmpq_mpoly) -> fmpq_mpoly:
        """A polynomial in the atoms as one in the scaled variables.

        Raises:
            TooLongError: if that has too many monomials, each with a number of as many bits as its
                degree.
        """
        shifted = [i for i, scale in enumerate(self.scales) if scale.m]
        length = sum(prod(int(powers[i]) + 1 for i in shifted) for powers in polynomial.monoms())
        if length * (1 + int(polynomial.total_degree()) // BITS) > MAX_MONOMIALS:
            raise TooLongError
        return polynomial.compose(*self._inward) if self.atoms else polynomial

    def reduced(self, polynomial: fmpq_mpoly) -> fmpq_mpoly:
        """A polynomial in the scaled variables without squares of roots."""
        for index, square in self.squares:
            if polynomial.degrees()[index] > 1:
                total = self.number(0)
                for power, part in coefficients(polynomial, index).items():
                    half, odd = divmod(power, 2)
                    total += part * self.gens[index] ** odd * square**half
                polynomial = total
        return polynomial

    def term(self, polynomial: fmpq_mpoly) -> Term:
        """A polynomial in the scaled variables as a term."""
        return expanded(self.unscaled(polynomial), self.atoms)

    def unscaled(self, polynomial: fmpq_mpoly) -> fmpq_mpoly:
        """A polynomial in the scaled variables as one in the atoms."""
        return polynomial.compose(*self._outward) if self.atoms else polynomial

    @property
    def used(self) -> list[int]:
        """The indices of the atoms in p."""
        return [i for i, degree in enumerate(self.p.degrees()) if degree > 0]

    def is_zero(self, point: Sequence[Fraction]) -> bool:
        """Whether p is 0, and all facts hold, at a point in scaled coordinates."""
        at = [fmpq_of(v) for v in point]
        return not self.p(*at) and all(f.polynomial(*at) >= 0 for f in self.facts.values())

    def divide_by_squares(self) -> Term | None:
        """Leave out of p the largest square that divides it; that, unless it is a constant."""
        if self.squares or self.p.is_zero():
            return None
        outer = self.number(1)
        for part, exponent in self.p.factor()[1]:
            outer *= part ** (int(exponent) // 2)
        if outer.is_constant():
            return None
        self.p = divmod(self.p, outer * outer)[0]
        return self.term(outer)

    def point(self, values: Mapping[str, Fraction]) -> list[Fraction] | None:
        """The scaled coordinates of a point; None unless all atoms are variables."""
        if not all(atom.op == "symbol" and atom.name in values for atom in self.atoms):
            return None
        return [
            (values[atom.name] - s.m) / s.h for atom, s in zip(self.atoms, self.scales, strict=True)
        ]

    def _factor(self, name: str, fact: Claim) -> Factor:
        """The difference of the sides, divided by its largest coefficient."""
        plain = self.clearing.difference(fact.rhs, fact.lhs)
        polynomial = self.reduced(self.scaled(plain))
        size = max((abs(c) for c in polynomial.coeffs()), default=fmpq(1))
        value: Value = name
        if size != 1:
            polynomial = polynomial / size
            value = ("mul", str(1 / fraction_of(size)), name)
        return Factor(polynomial, value, fact.relation == "<", (plain,))


def _scaled(bounds: Bounds | None) -> tuple[Affine, tuple[Fraction | None, Fraction | None]]:
    """How an atom with these bounds is scaled, and the ends of the scaled one."""
    zero, one = Fraction(0), Fraction(1)
    low, high = (None, None) if bounds is None else (bounds.low, bounds.high)
    if low is not None and high is not None and low < high:
        return Affine((low + high) / 2, (high - low) / 2), (-one, one)
    if low is not None:
        return Affine(low, one), (zero, None)
    return (Affine(zero, one), (None, None)) if high is None else (Affine(high, -one), (zero, None))


def multiplied(a: Factor, b: Factor) -> Factor:
    """The product of two."""
    value: Value = ("mul", a.value, b.value)
    parts = (*a.parts, *b.parts)
    return Factor(a.polynomial * b.polynomial, value, a.strict and b.strict, parts)
