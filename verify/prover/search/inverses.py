"""Claims that were shown for the inverse of a variable, in a context of their own."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from flint import fmpq_mpoly

from verify.language.statement import Given
from verify.language.terms import Claim, Term, as_term, equal, substitute, substitute_claim, symbol
from verify.prover.balls import fraction_of
from verify.prover.clearing import Clearing, TooLongError, atoms_of
from verify.prover.inverses import Image, inverted
from verify.prover.proof import Proof, Value, power_of, product_of
from verify.prover.rules import Instance, Monotony, Sum
from verify.prover.search.question import Question
from verify.prover.session import ZERO


def by_inverses(question: Question) -> Proof | None:
    """A proof from the row for the inverse, whose instance is a multiple of the claim."""
    known, session, claim = question.known, question.session, question.plain.claim
    place = f"{question.plain.context}.inverse"
    context = known.contexts.get(place)
    if context is None or not context.givens:  # a context of the page may be called so
        return None
    t = context.givens[0].claim.rhs  # 0 < t is given first
    own = {v.name: symbol(v.name.removeprefix(f"{place}.")) for v in context.variables}
    rows = {
        session.claims[name]: name
        for name in sorted(known.usable_rows)
        if session.homes[name] == place
    }
    if t.op != "symbol" or t.name not in own:
        return None
    x = own.pop(t.name)
    there = {name.name: symbol(variable) for variable, name in own.items()}
    for sign in (1, -1):
        found = inverted(claim, x, t, sign)
        row = None if found is None else rows.get(substitute_claim(found[0], there))
        if found is not None and row is not None:
            inverse = as_term(sign) / x
            if known.clears((inverse, claim.lhs, claim.rhs), question.plain.context):
                at = {**own, t.name: inverse}
                return _Inverses(question, t, at).proof(row, context.givens, found[1])
    return None


class _Inverses:
    """The row for the inverse at one place."""

    def __init__(self, question: Question, t: Term, at: Mapping[str, Term]) -> None:
        self.question, self.known, self.at = question, question.known, at
        self.place, self.inverse = question.plain.context, {t.name: at[t.name]}

    def proof(
        self, row: str, givens: Sequence[Given], images: Mapping[Term, Image]
    ) -> Proof | None:
        """A proof of the claim; the equations of its functions are lemmas."""
        claim, session = self.question.plain.claim, self.known.session
        premises = []
        for given in givens:
            name = self.question.fact(substitute_claim(given.claim, self.at))
            if name is None:
                return None
            premises.append(name)
        instance = substitute_claim(session.claims[row], self.at)
        if not self.known.clears((instance.lhs, instance.rhs), self.place):
            return None
        fact = session.ensure(instance, Instance(row, self.at, tuple(premises)), self.place)
        equations: dict[Term, str] = {}
        for atom, image in images.items():
            here = Image(*(substitute(term, self.inverse) for term in image))
            if atom == here.used:
                continue
            name = self._equation(atom, here, equations)
            if name is None:
                return None
            equations[atom] = name
        try:
            return self._multiple(claim, instance, fact, [*equations.values()])
        except TooLongError:
            return None

    def _equation(self, atom: Term, here: Image, equations: Mapping[Term, str]) -> str | None:
        """The fact that a function is what it is of the inverse."""
        if not self.known.clears((atom, here.plain, here.used), self.place):
            return None
        session, first = self.known.session, ""
        if here.plain != atom:
            inner = [equations[a] for a in atoms_of(atom.children, {}) if a in equations]
            proof = Monotony(Sum((), (*inner,)))
            first = session.ensure(equal(atom, here.plain), proof, self.place)
        if here.plain == here.used:
            return first
        second = self.question.fact(equal(here.plain, here.used))
        if second is None or not first:
            return second
        both = Sum((), (), ((first, as_term(1)), (second, as_term(1))))
        return session.ensure(equal(atom, here.used), both, self.place)

    def _multiple(
        self, claim: Claim, instance: Claim, fact: str, using: Sequence[str]
    ) -> Proof | None:
        """A proof from the instance, times factors that are positive."""
        sides = (claim.lhs, claim.rhs, instance.lhs, instance.rhs)
        replaced = self.known.session.replaced(using)
        clearing = Clearing(sides, replaced, self.question.is_negative)
        differences = [clearing.difference(*pair) for pair in (sides[:2], sides[2:])]
        p, q = clearing.reduced(differences)
        if p.is_zero() or q.is_zero():
            return None
        common = p.gcd(q)
        above, below = self._positive(clearing, p / common), self._positive(clearing, q / common)
        if above is None or below is None:
            return None
        addends = (product_of("goal", *below), product_of(fact, *above))
        return Sum(addends, (*using,))

    def _positive(self, clearing: Clearing, polynomial: fmpq_mpoly) -> list[Value] | None:
        """The values of factors whose product a polynomial is, or its opposite."""
        number, factors = polynomial.factor()
        values: list[Value] = [str(abs(fraction_of(number)))]
        for factor, power in factors:
            for signed in (factor, -factor):
                name = self.question.fact(Claim("<", ZERO, clearing.term(signed)))
                if name is not None:
                    values.append(power_of(name, int(power)))
                    break
            else:
                return None
        return [value for value in values if value != "1"]
