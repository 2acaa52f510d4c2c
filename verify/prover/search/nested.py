"""Claims with their polynomials in nested brackets, which intervals enclose more closely.

x (x - y + 3) has fewer variables than x^2 - x y + 3 x. What stands in a product stays a factor, and
constants are unfolded.
"""

from __future__ import annotations

from fractions import Fraction

from verify.language.fold import TERMS
from verify.language.terms import Claim, Term, as_term, equal, symbol
from verify.prover.balls import fraction_of
from verify.prover.clearing import (
    Clearing,
    Polynomial,
    TooLongError,
    coefficients,
    inner_first,
    through,
)
from verify.prover.proof import Proof
from verify.prover.rules import Monotony, Sum
from verify.prover.search.question import Question
from verify.prover.search.rising import EQUATED

ZERO = Fraction(0)


class Nested:
    """A claim about a box, its nested form, and why that is the same."""

    def __init__(self, question: Question) -> None:
        self.question, self.definitions = question, question.plain.definitions
        self.named = {symbol(name): term for name, term in self.definitions.items()}
        self.forms: dict[Term, Term] = {}
        relation, lhs, rhs = question.goal.claim.key
        self.claim = Claim(relation, self.form(lhs), self.form(rhs))

    def form(self, term: Term) -> Term:
        """The nested form of a term."""
        if term not in self.forms:
            nested = self._polynomial(term)
            self.forms[term] = self._parts(term) if nested is None else nested
        return self.forms[term]

    def _parts(self, term: Term) -> Term:
        if term.op == "symbol":
            definition = self.definitions.get(term.name)
            return term if definition is None else self.form(definition)
        children = term.children
        if not children or term.op in ("min", "max"):  # no rule says that these stay the same
            return term
        return TERMS[term.op](*map(self.form, children), *term.args[len(children) :])

    def _polynomial(self, term: Term) -> Term | None:
        """The nested form of a sum that is a polynomial in variables."""
        if term.op not in ("add", "sub", "neg"):
            return None
        try:
            clearing = Clearing((term,), self.named)
            above, below = clearing.clear(term)
        except TooLongError:
            return None
        if any(atom.op != "symbol" for atom in clearing.atoms) or not below.is_constant():
            return None
        return _nested(clearing, above / below.leading_coefficient())

    def proof(self, proof: Proof) -> Proof | None:
        """A proof of the claim from one of its nested form."""
        question, place = self.question, self.question.goal.context
        if not question.known.clears((self.claim.lhs, self.claim.rhs), place):
            return None
        equations = self.equations()
        if equations is None:
            return None
        fact = question.session.lemma(self.claim, proof, place)
        return question.from_fact(question.goal.claim, fact, (*equations, *question.using))

    def equations(self) -> list[str] | None:
        """Facts that functions in the claim are those in its nested form; None if one fails."""
        found: dict[Term, str] = {}
        sides = self.question.goal.claim.lhs, self.question.goal.claim.rhs
        for atom in inner_first(sides, through(self.definitions)):
            if atom.op in EQUATED and self.form(atom) is not atom:
                name = self._equation(atom, [*found.values()])
                if name is None:
                    return None
                found[atom] = name
        return [*found.values()]

    def _equation(self, atom: Term, inner: list[str]) -> str | None:
        known, session = self.question.known, self.question.session
        place = self.question.goal.context
        claim, below = (equal(t, self.form(t)) for t in (atom, atom.children[0]))
        if not known.clears((atom, claim.rhs), place):
            return None
        premise = session.lemma(below, Sum((), (*inner, *self.question.using)), place)
        return session.lemma(claim, Monotony(premise), place)


def _nested(clearing: Clearing, polynomial: Polynomial) -> Term:
    """The sum x p + y q + ..., where x is in most monomials, y in most of the others, and so on."""
    if polynomial.is_zero():
        return as_term(0)
    if polynomial.is_constant():
        return as_term(fraction_of(polynomial.leading_coefficient()))
    counts = [0] * len(clearing.atoms)
    for monomial in polynomial.to_dict():
        for index, exponent in enumerate(monomial):
            counts[index] += exponent > 0
    index = counts.index(max(counts))
    x, inside, rest = (
        clearing.context.gens()[index],
        clearing.constant(ZERO),
        clearing.constant(ZERO),
    )
    for power, part in coefficients(polynomial, index).items():
        if power:
            inside += part * x ** (power - 1)
        else:
            rest = part
    factor, atom = _nested(clearing, inside), clearing.atoms[index]
    product = atom if factor is as_term(1) else factor * atom
    return product if rest.is_zero() else product + _nested(clearing, rest)
