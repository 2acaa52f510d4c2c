"""What the form of a claim shows: identities, roots, minima and their entries, both orders."""

from __future__ import annotations

from verify.language.terms import Claim, Term, as_term, pi
from verify.prover.clearing import ROOTS, Clearing
from verify.prover.goal import definitions_below
from verify.prover.proof import Proof, every
from verify.prover.rules import Antisymmetry, Entry, InRange, Least, Root, Sum
from verify.prover.search.question import Question
from verify.prover.session import ZERO

CIRCULAR = ("sin", "cos", "cos_pi")
#: For each function the lower end of its values (False), and the upper one (True).
RANGES: dict[str, dict[bool, Term]] = {
    "exp": {False: ZERO},
    "atan": {False: -(pi / 2), True: pi / 2},
    **{op: {False: as_term(-1), True: as_term(1)} for op in CIRCULAR},
}


def by_identity(question: Question) -> Proof | None:
    """The sides are the same polynomial, or quotient, perhaps after names are replaced."""
    goal, session = question.plain, question.session
    claim = goal.claim
    if claim.relation == "<":
        return None
    names = (*goal.constants, *goal.definitions)
    every_name = tuple(sorted(definitions_below(names, session.definitions)))
    for using in {(): None, every_name: None}:
        clearing = Clearing((claim.lhs, claim.rhs), session.replaced(using))
        difference = clearing.difference(claim.lhs, claim.rhs)
        if not clearing.reduce(difference).to_dict():
            terms = claim.lhs, claim.rhs, *(session.definitions[name] for name in using)
            if not question.known.clears(terms, goal.context):
                return None
            return Sum(() if claim.relation == "=" else ("goal",), using)
    return None


def by_orders(question: Question) -> Proof | None:
    """Each side of an equation is at most the other."""
    goal = question.plain
    both = (goal.claim.lhs, goal.claim.rhs), (goal.claim.rhs, goal.claim.lhs)
    claims = (Claim("<=", *sides) for sides in both)
    orders = every(question.known.prove(goal._replace(claim=claim)) for claim in claims)
    return None if orders is None else Antisymmetry((orders[0], orders[1]))


def by_range(question: Question) -> Proof | None:
    """An end of the range of a function, and a value."""
    claim = question.plain.claim
    for value, is_above in ((claim.rhs, False), (claim.lhs, True)):
        end = RANGES.get(value.op, {}).get(is_above)
        sides = (value, end) if is_above else (end, value)
        strict = "<=" if value.op in CIRCULAR else "<"
        if end is not None and claim.key == (strict, *sides):
            return InRange()
    return None


def by_root(question: Question) -> Proof | None:
    """A root is positive, as its radicand is."""
    claim = question.plain.claim
    if claim.key != ("<", ZERO, claim.rhs) or claim.rhs.op not in ROOTS:
        return None
    radicand = claim.rhs.children[0]
    known = question.known.fact(Claim("<", ZERO, radicand), question.plain.context)
    return None if known is None else Root()


def by_extremum(question: Question) -> Proof | None:
    """A minimum is at most its entries; what is less than all of them is less than it."""
    (relation, lhs, rhs), known = question.plain.claim.key, question.known
    for side, term, other, small in (("lhs", lhs, rhs, "min"), ("rhs", rhs, lhs, "max")):
        if term.op == small and other in term.children and relation == "<=":
            return Entry(side)
        if term.op in ("min", "max") and term.op != small:
            sides = ((e, other) if side == "lhs" else (other, e) for e in term.children)
            goals = [known.goal(Claim(relation, *s), question.plain.context) for s in sides]
            found = every(map(known.prove, goals))
            return None if found is None else Least(side, found)
    return None
