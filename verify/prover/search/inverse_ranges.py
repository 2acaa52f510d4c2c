"""Bounds of variables by what is given of their exponentials and logarithms.

From log x <= c follows x <= exp c, and from exp x <= c, for a number c > 0, x <= log c.
"""

from __future__ import annotations

from verify.language.statement import Given
from verify.language.terms import Claim, Term, equal, exp, log, names_of
from verify.prover.proof import product_of
from verify.prover.rules import Law, Monotony, Sum
from verify.prover.search.question import Question

INVERSE = {"exp": log, "log": exp}


def find_inverse_ranges(question: Question) -> bool:
    """Afterwards variables have these bounds; whether that is news."""
    found = False
    for given in [*question.givens()]:
        relation, lhs, rhs = given.claim.key
        for value, bound, up in ((lhs, rhs, True), (rhs, lhs, False)):
            is_inverse = value.op in INVERSE and value.children[0].op == "symbol"
            if relation != "=" and is_inverse and not [*names_of(bound)]:
                found |= _bounded(question, given.name, relation, (value, bound), up=up)
    return found


def _bounded(
    question: Question, fact: str, relation: str, sides: tuple[Term, Term], *, up: bool
) -> bool:
    """Whether a function on the one side, and a number on the other, give a bound."""
    (value, bound), known = sides, question.known
    place, session, x = question.goal.context, question.session, value.children[0]
    own = known.bounds.get(x.name)
    inverse = INVERSE[value.op]
    if own is None or not known.is_at_home(x.name, place):
        return False
    if (own.high if up else own.low) is not None or not known.clears(
        (inverse(bound), inverse(value)), place
    ):
        return False
    number = known.ground.short_bound(inverse(bound), up=up)
    if number is None:
        return False

    def ordered(a: Term, b: Term, between: str) -> Claim:
        return Claim(between, *((a, b) if up else (b, a)))

    near = known.ground.lemma(ordered(inverse(bound), number, "<="))
    if near is None:
        return False
    rises = session.ensure(ordered(inverse(value), inverse(bound), relation), Monotony(fact), place)
    law = session.ensure(equal(inverse(value), x), Law(), place)
    claim = ordered(x, number, relation)
    proof = Sum(("goal", product_of(rises), near), (law,))
    known.narrow(x.name, Given(session.ensure(claim, proof, place), claim))
    return True
