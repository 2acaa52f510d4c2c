"""Claims that were shown in two parts of a context, in contexts of their own.

In one of them a term is at most another, in the other at least.
"""

from __future__ import annotations

from fractions import Fraction

from verify.language.terms import Claim, Term, substitute_claim, symbol
from verify.prover.proof import Premise, Proof
from verify.prover.rules import Cuts, Instance, Sum
from verify.prover.search.question import Question
from verify.prover.session import ZERO


def by_parts(question: Question) -> Proof | None:
    """The two cases, each an instance of a row of a part."""
    known, place, number = question.known, question.plain.context, 1
    while f"{place}.part{number}" in known.contexts:
        low, high = f"{place}.part{number}", f"{place}.part{number + 1}"
        first, second = _instance(question, low), _instance(question, high)
        if first is not None and second is not None:
            difference, proofs = first[0], (first[1], second[1])
            if known.clears((difference,), place):
                return Cuts(difference, (Fraction(0),), proofs)
        number += 2
    return None


def _instance(question: Question, part: str) -> tuple[Term, Proof] | None:
    """The difference whose sign is known in a part, and the row there as a fact here."""
    known, session = question.known, question.session
    context = known.contexts.get(part)
    if context is None or not context.givens:  # a context of the page may be called so
        return None
    names = {v.name: symbol(v.name.removeprefix(f"{part}.")) for v in context.variables}
    claims = {
        name: substitute_claim(session.claims[name], names)
        for name in sorted(known.usable_rows)
        if session.homes[name] == part
    }
    row = next((name for name, claim in claims.items() if claim == question.plain.claim), None)
    if row is None:
        return None
    first, *others = context.givens
    relation, lhs, rhs = substitute_claim(first.claim, names).key
    is_low = part.endswith(("1", "3", "5", "7", "9"))
    pair = (lhs, rhs) if is_low else (rhs, lhs)
    difference = pair[0] if pair[1] == ZERO else pair[0] - pair[1]
    premises: list[Premise] = [Sum(("goal", "@1"))]
    if relation == "<":
        square = session.known(Claim("<", ZERO, difference**2), question.plain.context)
        if square is None:
            return None
        premises = [Sum((("mul", "goal", "@1"), square))]
    for given in others:
        here = substitute_claim(given.claim, names)
        name = session.known(here, question.plain.context)
        if name is None:
            return None
        premises.append(name)
    return difference, Instance(row, names, tuple(premises))
