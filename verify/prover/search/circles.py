"""Claims about sines and cosines that are sharp where these are no rational numbers.

In one angle a polynomial is P + s B, where s is its sine, and P and B have only the cosine c. With
N = -P - s B, which the negation of the claim says is > 0,

    N^2 + 2 N P + P^2 - B^2 (1 - c^2) = 0,

so that the claim follows from P >= 0 and B^2 (1 - c^2) <= P^2, which may be rational where s is
not. The same holds with sine and cosine exchanged.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

from flint import fmpq_mpoly

from verify.language.terms import Claim, Term, as_term, cos, names_of, parts_of, sin
from verify.prover.balls import fraction_of
from verify.prover.clearing import Clearing, TooLongError, coefficients
from verify.prover.proof import Proof, Value, product_of
from verify.prover.rules import InRange, Sum
from verify.prover.search.elementary import Normal, without_squares
from verify.prover.search.positive import squares
from verify.prover.search.question import Question

#: Higher powers are not squared.
MAX_DEGREE = 12


def by_circles(question: Question) -> Proof | None:
    """A proof by the square of what is linear in one sine or cosine."""
    claim = question.plain.claim
    parts = parts_of(claim.lhs, claim.rhs)
    if claim.relation == "=" or not any(p.op in ("sin", "cos") and [*names_of(p)] for p in parts):
        return None
    try:
        return _Circles(question).proof()
    except TooLongError:
        return None


class _Circles:
    """One claim in the normal form of its sines and cosines."""

    def __init__(self, question: Question) -> None:
        self.question, self.claim = question, question.plain.claim
        self.normal = normal = Normal(question, self.claim.key[1:])
        self.laws = {angle: normal.facts.squares(angle) for angle in normal.generators}
        atoms = [f(angle) for angle in normal.generators for f in (sin, cos)]
        self.clearing = Clearing((*self.claim.key[1:], *atoms), normal.replaced)
        self.p = self.clearing.reduce(self.clearing.difference(self.claim.rhs, self.claim.lhs))

    def proof(self) -> Proof | None:
        """The first that is found."""
        if not self.question.known.clears(self.claim.key[1:], self.question.goal.context):
            return None
        atoms = {f(angle) for angle in self.laws for f in (sin, cos)}
        others = [a for a in self.clearing.atoms if [*names_of(a)] and a not in atoms]
        if int(self.p.total_degree()) > MAX_DEGREE or any(map(self._occurs, others)):
            return None
        alone = self._without_lone_functions()
        if alone is not None or len(self.laws) != 1:
            return alone
        (angle,) = self.laws
        pairs = [pair for pair in ((sin, cos), (cos, sin)) if self._occurs(pair[0](angle))]
        if len(pairs) == 1 and not self.normal.used:
            return squares(self.question)
        return next(filter(None, (self._by_square(angle, *pair) for pair in pairs)), None)

    def _without_lone_functions(self) -> Proof | None:
        """With 1 or -1 in place of functions of angles that occur nowhere else."""
        rest, addends = self.p, list[Value](["goal"])
        for angle in self.laws if len(self.laws) > 1 else ():
            own = [f(angle) for f in (sin, cos) if self._occurs(f(angle))]
            parts = coefficients(rest, self.clearing.atoms.index(own[0])) if len(own) == 1 else {}
            if parts.keys() - {0, 1} or 1 not in parts or not parts[1].is_constant():
                continue
            number = fraction_of(parts[1].leading_coefficient())
            end = (
                Claim("<=", as_term(-1), own[0]) if number > 0 else Claim("<=", own[0], as_term(1))
            )
            fact = self.normal.facts.lemma(end, InRange())
            addends.append(product_of(str(abs(number)), fact))
            rest = rest - parts[1] * self.clearing.generators[own[0]]
            rest = rest - self.clearing.constant(abs(number))
        if len(addends) == 1:
            return None
        name = self._fact(self.claim.relation, rest)
        return None if name is None else Sum((*addends, name), (*self.normal.used,))

    def _by_square(
        self, angle: Term, f: Callable[[Term], Term], g: Callable[[Term], Term]
    ) -> Proof | None:
        """A proof where f of the angle is linear, after the squares of f are replaced."""
        clearing, relation = self.clearing, self.claim.relation
        linear, other = clearing.generators[f(angle)], clearing.generators[g(angle)]
        rest, factor = without_squares(self.p, clearing, f(angle), g(angle))
        parts = coefficients(rest, clearing.atoms.index(f(angle)))
        plain, scale = (parts.get(power, clearing.constant(Fraction(0))) for power in (0, 1))
        used, law = (*self.normal.used,), self.laws[angle]
        if scale.is_zero():
            name = self._fact(relation, plain)
            equations = () if factor.is_zero() else ((law, clearing.term(factor)),)
            return None if name is None else Sum(("goal", name), used, equations)
        square = clearing.reduce(plain**2 - scale**2 * (clearing.one - other**2))
        positive = self.question.lemma("<=", plain, clearing.term(plain))
        last = None if positive is None else self._fact(relation, square)
        if positive is None or last is None:
            return None
        whole = clearing.reduce(self.p**2 - 2 * self.p * plain + square)
        cofactor = whole / (clearing.one - linear**2 - other**2)
        addends = (("pow", "goal", 2), product_of("2", "goal", positive), last)
        return Sum(addends, used, ((law, clearing.term(cofactor)),))

    def _fact(self, relation: str, polynomial: fmpq_mpoly) -> Value | None:
        term = self.clearing.term(polynomial)
        return self.question.lemma(relation, polynomial, term)

    def _occurs(self, atom: Term) -> bool:
        return int(self.p.degrees()[self.clearing.atoms.index(atom)]) > 0
