"""Claims that are the same after two variables are exchanged: by the order of their values.

The difference of two such variables is cut at 0. In each branch it, or its opposite, is a
polynomial that is >= 0, which products of facts may use.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from verify.language.record import TYPE_CHECKING
from verify.language.terms import Claim, symbol
from verify.prover.clearing import Clearing
from verify.prover.goal import Goal
from verify.prover.proof import Proof
from verify.prover.rules import Cuts
from verify.prover.search.coefficients import by_coefficients
from verify.prover.search.domain import Domain
from verify.prover.search.positive import by_squares
from verify.prover.session import ZERO

if TYPE_CHECKING:
    from verify.prover.search.strategy import Strategy


def by_order(strategy: Strategy, facts: Mapping[str, Claim]) -> Proof | None:
    """A proof in which the values of variables that may be exchanged have an order."""
    names = _exchanged(strategy.goal, strategy.clearing)
    if not 2 <= len(names) <= 3:
        return None
    return _split(strategy, names, [], dict(facts), 0)


def _exchanged(goal: Goal, clearing: Clearing) -> list[str]:
    """Variables with equal bounds, of which neighbours may be exchanged in the claim."""
    p = clearing.difference(goal.claim.rhs, goal.claim.lhs)
    gens = clearing.context.gens()
    if any(atom.op != "symbol" for atom in clearing.atoms):
        return []
    found: list[int] = []
    for i, degree in enumerate(p.degrees()):
        if not degree:
            continue
        if found:
            j = found[-1]
            swapped = list(gens)
            swapped[i], swapped[j] = gens[j], gens[i]
            ends = [goal.variables[clearing.atoms[k].name] for k in (i, j)]
            if p.compose(*swapped) != p or ends[0][:2] != ends[1][:2]:
                continue
        found.append(i)
    return [clearing.atoms[i].name for i in found]


def _split(
    strategy: Strategy, names: list[str], order: list[str], facts: dict[str, Claim], count: int
) -> Proof | None:
    """Insert the first of the names into the order, from the least on; then the others."""
    if not names:
        proof = by_coefficients(strategy, order, _neighbours(facts))
        if proof is not None:
            return proof
        domain = Domain(strategy.goal, facts)
        return by_squares(domain, strategy.zeros(domain), strategy.budget, strategy.using)
    return _insert(strategy, names, order, 0, facts, count)


def _insert(
    strategy: Strategy,
    names: list[str],
    order: list[str],
    place: int,
    facts: dict[str, Claim],
    count: int,
) -> Proof | None:
    """The first name is not below those before its place."""
    first, *others = names
    if place == len(order):
        return _split(strategy, others, [*order, first], facts, count)
    term = symbol(first) - symbol(order[place])
    name = f"@{count + 1}"
    inserted = [*order[:place], first, *order[place:]]
    low = {**facts, name: Claim("<=", term, ZERO)}
    high = {**facts, name: Claim("<=", ZERO, term)}
    below = _split(strategy, others, inserted, low, count + 1)
    if below is None:
        return None
    above = _insert(strategy, names, order, place + 1, high, count + 1)
    return None if above is None else Cuts(term, (Fraction(0),), (below, above))


def _neighbours(facts: Mapping[str, Claim]) -> dict[tuple[str, str], str]:
    """For two variables of which the first is not above the second the hypothesis that says so."""
    found = {}
    for name, claim in facts.items():
        if name.startswith("@"):
            difference = claim.lhs if claim.rhs == ZERO else claim.rhs
            a, b = (child.name for child in difference.children)
            found[(a, b) if claim.rhs == ZERO else (b, a)] = name
    return found
