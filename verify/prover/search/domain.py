"""A claim as a polynomial in scaled variables, with the polynomials that facts say are >= 0.

Where lhs < rhs or lhs <= rhs is to be shown, p is the polynomial whose sign is that of rhs - lhs.
A variable x is replaced by the u in [-1, 1] with x = m + h u if it lies between two numbers, and by
its distance from a bound if it has only one.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction

from flint import fmpq, fmpq_mpoly

from verify.language.record import Record
from verify.language.terms import Claim, Term, symbol
from verify.prover.clearing import Clearing, expanded
from verify.prover.goal import Bounds, Goal
from verify.prover.proof import Value


class Factor(Record):
    """A polynomial in the scaled variables that is >= 0, or > 0 if strict, and its value."""

    polynomial: fmpq_mpoly
    value: Value
    strict: bool


class Scale(Record):
    """An atom is m + h u, where h is not 0."""

    m: Fraction
    h: Fraction


class Domain:
    """The atoms of a claim and of facts about them, scaled; ``facts`` are inequalities by name."""

    def __init__(self, goal: Goal, facts: Mapping[str, Claim]) -> None:
        claim = goal.claim
        sides = [term for fact in facts.values() for term in (fact.lhs, fact.rhs)]
        replaced = {symbol(name): term for name, term in goal.definitions.items()}
        self.clearing = Clearing((claim.lhs, claim.rhs, *sides), replaced)
        self.atoms: Sequence[Term] = self.clearing.atoms
        self.context = self.clearing.context
        self.gens = self.context.gens()
        self.scales = [self._scale(atom, goal.variables) for atom in self.atoms]
        self._inward = [
            self.number(s.m) + self.number(s.h) * u
            for s, u in zip(self.scales, self.gens, strict=True)
        ]
        self._outward = [
            (x - self.number(s.m)) * self.number(1 / s.h)
            for s, x in zip(self.scales, self.gens, strict=True)
        ]
        self.p = self.scaled(self.clearing.difference(claim.rhs, claim.lhs))
        self.strict = claim.relation == "<"
        self.facts = {name: self._factor(name, fact) for name, fact in facts.items()}

    @staticmethod
    def _scale(atom: Term, variables: Mapping[str, Bounds]) -> Scale:
        bounds = variables.get(atom.name) if atom.op == "symbol" else None
        low, high = (None, None) if bounds is None else (bounds.low, bounds.high)
        if low is not None and high is not None and low < high:
            return Scale((low + high) / 2, (high - low) / 2)
        if low is not None:
            return Scale(low, Fraction(1))
        return Scale(Fraction(0), Fraction(1)) if high is None else Scale(high, Fraction(-1))

    def number(self, value: Fraction | int) -> fmpq_mpoly:
        """A number as a polynomial."""
        value = Fraction(value)
        return self.context.constant(fmpq(value.numerator, value.denominator))

    def scaled(self, polynomial: fmpq_mpoly) -> fmpq_mpoly:
        """A polynomial in the atoms, reduced, as one in the scaled variables."""
        reduced = self.clearing.reduce(polynomial)
        return reduced.compose(*self._inward) if self.atoms else reduced

    def term(self, polynomial: fmpq_mpoly) -> Term:
        """A polynomial in the scaled variables as a term."""
        unscaled = polynomial.compose(*self._outward) if self.atoms else polynomial
        return expanded(unscaled, self.atoms)

    def point(self, values: Mapping[str, Fraction]) -> list[Fraction] | None:
        """The scaled coordinates of a point; None unless all atoms are variables."""
        if not all(atom.op == "symbol" and atom.name in values for atom in self.atoms):
            return None
        return [
            (values[atom.name] - s.m) / s.h for atom, s in zip(self.atoms, self.scales, strict=True)
        ]

    def _factor(self, name: str, fact: Claim) -> Factor:
        """The difference of the sides, divided by its largest coefficient."""
        polynomial = self.scaled(self.clearing.difference(fact.rhs, fact.lhs))
        size = max((abs(c) for c in polynomial.coeffs()), default=fmpq(1))
        value: Value = name
        if size != 1:
            polynomial = polynomial / size
            value = ("mul", str(Fraction(int(size.q), int(size.p))), name)
        return Factor(polynomial, value, fact.relation == "<")


def product(a: Factor, b: Factor) -> Factor:
    """The product of two."""
    return Factor(a.polynomial * b.polynomial, ("mul", a.value, b.value), a.strict and b.strict)
