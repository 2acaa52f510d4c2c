"""What is given of exponentials and logarithms, as facts about what they are of.

From log t <= c follows t <= exp c, and from exp t <= c, for c > 0, t <= log c; from log s <= log t
follows s <= t. A bound of a variable by a number is known as such.
"""

from __future__ import annotations

from collections.abc import Iterator

from verify.language.record import Record
from verify.language.statement import Given
from verify.language.terms import Claim, Term, equal, exp, log, names_of
from verify.prover.clearing import Clearing, TooLongError, coefficients
from verify.prover.rules import Law, Monotony, Sum
from verify.prover.search.question import Question
from verify.prover.session import ZERO

INVERSE = {"exp": log, "log": exp}


class Bound(Record):
    """The fact that a function is at most a term, or at least that."""

    fact: str
    relation: str
    function: Term
    term: Term
    up: bool

    def ordered(self, a: Term, b: Term) -> Claim:
        """The claim that relates two terms in the same way."""
        return Claim(self.relation, *((a, b) if self.up else (b, a)))


def find_inverse_ranges(question: Question) -> bool:
    """Afterwards these facts are known; whether one of them is new."""
    bounds = [bound for given in question.givens() for bound in _bounds(question, given)]
    are_new = [_inverted(question, bound) for bound in bounds]
    return any(are_new)


def _bounds(question: Question, given: Given) -> Iterator[Bound]:
    """The functions that a given bounds: they stand in it once, times a number."""
    relation, lhs, rhs = given.claim.key
    if relation == "=" or not question.known.is_cleared(given.claim, question.goal.context):
        return
    try:
        clearing = Clearing((lhs, rhs), {})
        difference = clearing.difference(rhs, lhs)
    except TooLongError:
        return
    for index, atom in enumerate(clearing.atoms):
        parts = coefficients(difference, index) if atom.op in INVERSE else {}
        factor = parts.get(1)
        if parts.keys() <= {0, 1} and factor is not None and factor.is_constant():
            number = factor.leading_coefficient()
            rest = parts.get(0, clearing.one - clearing.one)
            bound = Bound("", relation, atom, clearing.term(-rest / number), number < 0)
            claim = bound.ordered(atom, bound.term)
            proof = question.from_fact(claim, given.name)
            if proof is not None:
                fact = question.session.ensure(claim, proof, question.goal.context)
                yield bound._replace(fact=fact)


def _inverted(question: Question, bound: Bound) -> bool:
    """Whether the bound gives a new fact."""
    known, session, place = question.known, question.session, question.goal.context
    function, term = bound.function, bound.term
    inverse, inner = INVERSE[function.op], function.children[0]
    is_positive = function.op == "log" or not [*names_of(term)] or term.op == "exp"
    if not is_positive and session.known(Claim("<", ZERO, term), place) is None:
        return False
    if not [*names_of(inner)] or not known.clears((inverse(term), inverse(function)), place):
        return False
    sides = [t.children[0] if t.op == function.op else inverse(t) for t in (function, term)]
    claim = bound.ordered(*sides)
    if session.known(claim, place) is not None:
        return False
    rises = session.ensure(
        bound.ordered(inverse(function), inverse(term)), Monotony(bound.fact), place
    )
    laws = [
        session.ensure(equal(inverse(t), t.children[0]), Law(), place)
        for t in (function, term)
        if t.op == function.op
    ]
    name = session.lemma(claim, Sum(("goal", rises), (*laws,)), place)
    known.rows.add(name)
    _narrow(question, bound, inner, sides[1], name)
    return True


def _narrow(question: Question, bound: Bound, x: Term, end: Term, fact: str) -> None:
    """Know a bound of a variable by a number, if it has none."""
    known, place = question.known, question.goal.context
    if x.op != "symbol" or [*names_of(end)] or not known.is_at_home(x.name, place):
        return
    own = known.bounds[x.name]
    if (own.high if bound.up else own.low) is not None:
        return
    number = known.ground.short_bound(end, up=bound.up)
    if number is None:
        return
    near = known.ground.lemma(bound._replace(relation="<=").ordered(end, number))
    if near is not None:
        claim = bound.ordered(x, number)
        name = question.session.ensure(claim, Sum(("goal", fact, near)), place)
        known.narrow(x.name, Given(name, claim))
