"""What is tried on a claim for all values of the variables in scope, in this order."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import chain

from verify.language.record import TYPE_CHECKING
from verify.language.statement import Given
from verify.language.terms import Claim, names_of
from verify.prover import boxes
from verify.prover.bernstein import bernstein
from verify.prover.clearing import Clearing
from verify.prover.goal import Goal
from verify.prover.proof import Proof
from verify.prover.rules import Antisymmetry, Entry, Least, Root, Sum
from verify.prover.search.cosine_bounds import by_cosines
from verify.prover.search.multiple_angles import by_multiple_angles
from verify.prover.search.strategy import Strategy
from verify.prover.session import ZERO
from verify.prover.signs import signs

if TYPE_CHECKING:
    from verify.prover.universal import Universal

#: With more variables than these a goal is not tried again with those that givens link to its own.
MAX_LINKED = 5


def techniques(goal: Goal, universal: Universal) -> Iterator[Proof | None]:
    """What each finds; the lemmas that a proof needs are written down by then."""
    sides = goal.claim.lhs, goal.claim.rhs
    yield _identity(goal, universal)
    if goal.claim.relation == "=":
        yield _equation(goal, universal)
        return
    yield boxes.interval(goal, universal.enclosed)
    if not universal.clears(sides, goal.context):
        return
    turned = Claim(goal.claim.relation, *(universal.turned(t, goal.context) for t in sides))
    if turned != goal.claim:
        goal, sides = goal._replace(claim=turned), (turned.lhs, turned.rhs)
        if not universal.clears(sides, goal.context):
            return
    if goal.claim.key == ("<", ZERO, goal.claim.rhs) and goal.claim.rhs.op == "sqrt":
        yield _root(goal, universal)
    if any(side.op in ("min", "max") for side in sides):
        yield Strategy(goal, universal).plain_squares()
    yield _extremum(goal, universal)
    yield signs(goal, lambda claim: universal.session.known(claim, goal.context))
    yield bernstein(goal)
    yield boxes.cuts(goal, universal.enclosed, universal.budget)
    yield from Strategy(goal, universal).proofs()
    wider = _with_neighbours(goal, universal)
    if wider is not None:
        yield from Strategy(wider, universal).proofs()


def _with_neighbours(goal: Goal, universal: Universal) -> Goal | None:
    """The goal with the variables that givens link to its own; None if there are none."""
    found = {*goal.variables}
    names = [{*names_of(given.claim.lhs, given.claim.rhs)} for given in _givens(goal, universal)]
    for _ in range(MAX_LINKED):
        linked = [near & universal.bounds.keys() for near in names if near & found]
        found |= {*chain(*linked)}
    if len(found) == len(goal.variables) or len(found) > MAX_LINKED:
        return None
    return goal._replace(variables={name: universal.bounds[name] for name in sorted(found)})


def _givens(goal: Goal, universal: Universal) -> Iterator[Given]:
    """The givens of the contexts around a goal."""
    for place in universal.session.chain(goal.context):
        yield from () if place is None else universal.contexts[place].givens


def _identity(goal: Goal, universal: Universal) -> Proof | None:
    claim, known = goal.claim, universal.session.definitions
    if claim.relation == "<":
        return None
    definitions = _definitions((*goal.constants, *goal.definitions), universal)
    for using in {(): None, definitions: None}:
        clearing = Clearing((claim.lhs, claim.rhs), universal.session.replaced(using))
        difference = clearing.difference(claim.lhs, claim.rhs)
        if not clearing.reduce(difference).to_dict():
            terms = claim.lhs, claim.rhs, *(known[name] for name in using)
            if not universal.clears(terms, goal.context):
                return None
            return Sum(() if claim.relation == "=" else ("goal",), using)
    return None


def _equation(goal: Goal, universal: Universal) -> Proof | None:
    """By cosines of multiples of an angle, or because each side is at most the other."""
    if not universal.clears((goal.claim.lhs, goal.claim.rhs), goal.context):
        return None
    strategy = Strategy(goal, universal)
    if not strategy.clears() or not strategy.may_be_equal():
        return None
    proof = next(filter(None, by_cosines(strategy.goal, universal, strategy.using)), None)
    proof = proof or by_multiple_angles(strategy)
    if proof is not None:
        return proof
    orders = []
    for sides in ((goal.claim.lhs, goal.claim.rhs), (goal.claim.rhs, goal.claim.lhs)):
        order = universal.prove(goal._replace(claim=Claim("<=", *sides)))
        if order is None:
            return None
        orders.append(order)
    return Antisymmetry((orders[0], orders[1]))


def _definitions(names: Iterable[str], universal: Universal) -> tuple[str, ...]:
    """The names that have definitions, and those in their definitions."""
    found: dict[str, None] = {}
    waiting = [*names]
    while waiting:
        name = waiting.pop()
        if name in universal.session.definitions and name not in found:
            found[name] = None
            waiting += names_of(universal.session.definitions[name])
    return tuple(sorted(found))


def _root(goal: Goal, universal: Universal) -> Proof | None:
    radicand = goal.claim.rhs.children[0]
    return Root() if universal.fact(Claim("<", ZERO, radicand), goal.context) else None


def _extremum(goal: Goal, universal: Universal) -> Proof | None:
    """A minimum is at most its entries; what is less than all of them is less than it."""
    lhs, rhs, relation = goal.claim.lhs, goal.claim.rhs, goal.claim.relation
    for side, term, other, small in (("lhs", lhs, rhs, "min"), ("rhs", rhs, lhs, "max")):
        if term.op == small and other in term.children and relation == "<=":
            return Entry(side)
        if term.op in ("min", "max") and term.op != small:
            sides = ((e, other) if side == "lhs" else (other, e) for e in term.children)
            claims = [Claim(relation, *pair) for pair in sides]
            proofs = [universal.prove(universal.goal(claim, goal.context)) for claim in claims]
            found = tuple(proof for proof in proofs if proof is not None)
            return Least(side, found) if len(found) == len(proofs) else None
    return None
