"""Claims with named constants inside functions: the same claims with their definitions."""

from __future__ import annotations

from collections.abc import Mapping

from verify.language.fold import replaced
from verify.language.terms import Claim, Term, equal, names_of, parts_of, symbol
from verify.prover.clearing import atoms_of, inner_first
from verify.prover.proof import Proof
from verify.prover.rules import Antisymmetry, Monotony, Sum
from verify.prover.search.laws import Laws
from verify.prover.search.question import Question

#: Functions that rise: equal arguments have equal values by their monotony, both ways.
RISING = ("exp", "log", "atan")
FUNCTIONS = (*RISING, "sqrt", "root", "sin", "cos", "cos_pi")


def by_definitions(question: Question) -> Proof | None:
    """The claim follows from the one in which the definitions of all constants are written out.

    For sums a function of a name is another number than that of the definition, so equations say
    that they are equal.
    """
    constants = {*question.plain.constants}
    claim, laws = question.plain.claim, Laws(question)
    terms = (claim.lhs, claim.rhs, *question.goal.definitions.values())
    atoms = inner_first(atoms_of(terms, {}), lambda term: term.children)
    of_constants = [
        part for part in atoms if part.op in FUNCTIONS and not constants.isdisjoint(names_of(part))
    ]
    own = {part.op for part in parts_of(claim.lhs, claim.rhs)}
    if not constants or own.isdisjoint(FUNCTIONS):
        return None
    if any(part.op not in RISING for part in of_constants):
        return None
    values = _written_out(question)
    simpler = _with(claim, values)
    if not laws.clears(simpler.lhs, simpler.rhs) or (fact := laws.fact(simpler)) is None:
        return None
    for part in of_constants:
        _equate(laws, part, replaced(part, values), question.using)
    return question.from_fact(claim, fact, (*question.using, *laws.used))


def _with(claim: Claim, values: Mapping[Term, Term]) -> Claim:
    return Claim(claim.relation, *(replaced(side, values) for side in (claim.lhs, claim.rhs)))


def _written_out(question: Question) -> dict[Term, Term]:
    """The definitions of constants without names of others."""
    found: dict[Term, Term] = {}
    for name, term in question.known.ground.definitions.items():
        if name in question.goal.definitions:
            found[symbol(name)] = replaced(term, found)
    return found


def _equate(laws: Laws, part: Term, other: Term, using: tuple[str, ...]) -> None:
    """Afterwards it is an equation to use that a function of constants is that of their values."""
    orders = []
    for low, high in ((part, other), (other, part)):
        pairs = zip(low.children, high.children, strict=True)
        (low_x, high_x), *_ = pairs
        below = laws.lemma(Claim("<=", low_x, high_x), Sum(("goal",), (*using, *laws.used)))
        orders.append(laws.lemma(Claim("<=", low, high), Monotony(below)))
    first, second = (Sum(("goal", order)) for order in orders)
    laws.use(equal(part, other), Antisymmetry((first, second)))
