"""How near facts are to a claim, so that those that it does not need make it little harder.

A claim is looked for with few facts at first, the nearest ones, each time with more work; and with
all of them in between. What is not needed costs a part of the work, and not the proof.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from verify.language.terms import Claim, names_of, parts_of
from verify.prover.goal import Goal
from verify.prover.universal import Universal

#: With at most so many facts all of them are tried at first.
FEW = 8
#: How many of the nearest facts are tried (None: all), with how many units of work.
EARLY: tuple[tuple[int | None, int], ...] = ((0, 150_000), (FEW, 1_000_000), (2 * FEW, 1_500_000))
EARLY_OF_FEW: tuple[tuple[int | None, int], ...] = ((None, 1_500_000), (0, 1_500_000))
#: The same, with a part of the work that is left.
LATE: tuple[tuple[int | None, int], ...] = ((None, 2), (0, 3), (FEW, 2), (2 * FEW, 1))


def rounds(goal: Goal, known: Universal) -> Iterator[tuple[frozenset[str], int]]:
    """The facts that are hidden, one set after another, with the units of work for each."""
    names = ranked(goal, facts_around(goal, known))
    for count, units in (EARLY_OF_FEW if len(names) <= FEW else EARLY) if names else ():
        yield frozenset(() if count is None else names[count:]), units
    for count, part in LATE:
        if count is None or count < len(names):
            hidden = frozenset(() if count is None else names[count:])
            yield hidden, known.budget.left // (part if names else 1)


def facts_around(goal: Goal, known: Universal) -> dict[str, Claim]:
    """The givens and rows that are usable where a claim is, but for bounds by numbers."""
    session = known.session
    places = {*session.chain(goal.context)}
    found = {
        given.name: given.claim
        for place in places
        if place is not None
        for given in known.contexts[place].givens
    }
    rows = sorted(name for name in known.rows if session.homes.get(name) in places)
    found |= {name: session.claims[name] for name in rows if name in session.claims}
    return {name: claim for name, claim in found.items() if not is_bound(claim)}


def is_bound(claim: Claim) -> bool:
    """Whether a claim bounds a name by a number."""
    return {claim.lhs.op, claim.rhs.op} == {"symbol", "rational"}


def ranked(goal: Goal, facts: Mapping[str, Claim]) -> list[str]:
    """The names of facts that are linked to a claim, the nearest first.

    A fact about the names in the claim only is nearer than one with others, and that nearer than
    one which it links to the claim.
    """
    near = {*names_of(goal.claim.lhs, goal.claim.rhs), *goal.definitions}
    near = near.union(*(names_of(term) for term in goal.definitions.values()))
    left = {name: {*names_of(claim.lhs, claim.rhs)} for name, claim in facts.items()}
    found: list[str] = []
    while linked := [name for name, own in left.items() if own & near]:
        sizes = {
            name: (len(left[name] - near), sum(1 for _ in parts_of(*facts[name].key[1:])))
            for name in linked
        }
        found += sorted(linked, key=sizes.__getitem__)
        near = near.union(*map(left.pop, linked))
    return found
