"""Claims with a root that is of degree 1 in them: by what they say about its square.

For p = P + Q r, where r is the root of N/D and D > 0, the claim p >= 0 follows

    from P >= 0 or Q^2 N - P^2 D >= 0            where Q >= 0
    from P >= 0 and P^2 D - Q^2 N >= 0           where Q <= 0.

With G = -p, which the negation of the claim says is > 0, that is because of

    D G^2 + 2 D G Q r + Q^2 N - P^2 D = 0        and        D G^2 + 2 D G P + P^2 D - Q^2 N = 0.

What is needed of P, Q and D is shown as lemmas: they have one root less.
"""

from __future__ import annotations

from collections.abc import Iterator

from flint import fmpq_mpoly

from verify.language.record import Record
from verify.language.terms import Claim, Term, maximum
from verify.prover.balls import float_of
from verify.prover.clearing import atoms_of, coefficients
from verify.prover.proof import Proof, Value
from verify.prover.rules import Cases, Sum
from verify.prover.search.local_minima import Minima
from verify.prover.search.question import Question
from verify.prover.session import ZERO

#: Estimates above this may be zeros.
SLACK = -1e-7
MAX_MONOMIALS = 200


class Isolated(Record):
    """The root, P and Q, and the square N/D of the root."""

    root: Term
    rest: fmpq_mpoly
    factor: fmpq_mpoly
    numerator: fmpq_mpoly
    denominator: fmpq_mpoly


def by_squaring(question: Question) -> Proof | None:
    """A proof by the square of one root, the others being left to the lemmas."""
    squaring = Squaring(question)
    return next(filter(None, map(squaring.proof, squaring.isolated())), None)


class Squaring:
    """One claim, cleared."""

    def __init__(self, question: Question) -> None:
        self.question, self.goal = question, question.goal
        claim = self.goal.claim
        self.clearing = question.clearing
        self.p = self.clearing.difference(claim.rhs, claim.lhs)
        roots = [atom for atom in self.clearing.atoms if atom.op == "sqrt"]
        self.squares = {root: self.clearing.clear(root.children[0]) for root in roots}
        self.is_plain = all(d == self.clearing.one for _, d in self.squares.values())

    def isolated(self) -> Iterator[Isolated]:
        """The roots inside no other atom, of degree 1 after squares are replaced."""
        p = self.reduced(self.p)
        atoms = [a for a, d in zip(self.clearing.atoms, p.degrees(), strict=True) if d > 0]
        inside = {a for atom in atoms for child in atom.children for a in atoms_of((child,), {})}
        for index, atom in enumerate(self.clearing.atoms):
            if atom.op == "sqrt" and atom not in inside and p.degrees()[index] == 1:
                parts = coefficients(p, index)
                rest = parts.get(0, self.clearing.one - self.clearing.one)
                yield Isolated(atom, rest, parts[1], *self.squares[atom])

    def reduced(self, polynomial: fmpq_mpoly) -> fmpq_mpoly:
        """The same without squares of roots, if all roots are of polynomials."""
        return self.clearing.reduce(polynomial) if self.is_plain else polynomial

    def proof(self, isolated: Isolated) -> Proof | None:
        """A proof by one root, whichever sign its factor has."""
        _, rest, factor, n, d = isolated
        if self.may_be(factor):
            return self.above(isolated, self.reduced(factor**2 * n - rest**2 * d))
        if self.may_be(-factor) and self.may_be(rest):
            return self.below(isolated, self.reduced(rest**2 * d - factor**2 * n))
        return None

    def above(self, isolated: Isolated, square: fmpq_mpoly) -> Proof | None:
        """Where Q >= 0."""
        _, rest, factor, _, d = isolated
        relation = self.goal.claim.relation
        if self.may_be(square):
            values = [self.lemma("<=", factor), self.lemma("<", d), self.lemma(relation, square)]
            return self.squared(isolated, values) if None not in values else None
        term = maximum(self.clearing.term(rest), self.clearing.term(square))
        values = [self.lemma("<=", factor), self.lemma("<", d)]
        fact = None if None in values else self.question.fact(Claim(relation, ZERO, term))
        if fact is None:
            return None
        root: Value = ("root", isolated.root)
        first = Sum(("goal", fact, ("mul", values[0] or "0", root)), self.using("@1"))
        return Cases(term, (first, self.squared(isolated, [*values, fact], "@1")))

    def squared(self, isolated: Isolated, values: list[Value | None], *equations: str) -> Sum:
        """D G^2 + 2 D G Q r + Q^2 N - P^2 D."""
        factor, d, square = (value or "0" for value in values)
        root: Value = ("root", isolated.root)
        twice: Value = ("mul", "2", d, "goal", factor, root)
        return Sum((("mul", d, ("pow", "goal", 2)), twice, square), self.using(*equations))

    def below(self, isolated: Isolated, square: fmpq_mpoly) -> Proof | None:
        """Where Q <= 0: the lemma about Q itself is not needed."""
        if not self.may_be(square):
            return None
        rest, d = self.lemma("<=", isolated.rest), self.lemma("<", isolated.denominator)
        fact = None if None in (rest, d) else self.lemma(self.goal.claim.relation, square)
        if rest is None or d is None or fact is None:
            return None
        values = ("mul", d, ("pow", "goal", 2)), ("mul", "2", d, "goal", rest), fact
        return Sum(values, self.using())

    # --- lemmas ---------------------------------------------------------------------------------

    def using(self, *equations: str) -> tuple[str, ...]:
        """The definitions, and equations that hold in a branch."""
        return (*self.question.using, *equations)

    def lemma(self, relation: str, polynomial: fmpq_mpoly) -> Value | None:
        """The value of a fact 0 < p or 0 <= p."""
        return self.question.lemma(relation, polynomial, self.clearing.term(polynomial))

    def may_be(self, polynomial: fmpq_mpoly) -> bool:
        """Whether a polynomial is >= 0, as far as estimates tell."""
        if len(polynomial) > MAX_MONOMIALS:
            return False
        if polynomial.is_constant():
            return not polynomial.to_dict() or polynomial.leading_coefficient() >= 0
        claim = Claim("<=", ZERO, self.clearing.term(polynomial))
        size = float_of(max(abs(c) for c in polynomial.coeffs()))
        found = Minima(self.goal._replace(claim=claim), self.question.budget).found()
        return bool(found) and found[0][0] >= SLACK * size
