"""A point in the middle of what linear givens allow, or near where givens are violated least."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction

from verify.language.terms import Claim, Term, as_term
from verify.prover.budget import WorkBudget
from verify.prover.search.interior import interior
from verify.wire.text.estimates import exactly, seems

#: Fractions with larger denominators come near solutions of equations by accident.
SIMPLE = 100


def in_the_middle(
    variables: Sequence[str],
    claims: Sequence[Claim],
    values: Mapping[str, float],
    budget: WorkBudget,
) -> dict[str, Term] | None:
    """Numbers for the variables, by a linear programme and near the places that violate least."""

    def seem(point: Sequence[Fraction]) -> bool:
        exact = dict(zip(variables, map(as_term, point), strict=True))
        at = dict(values) | dict(zip(variables, map(float, point), strict=True))
        if not all(seems(claim, at, exact) for claim in claims):
            return False
        if all(x.denominator <= SIMPLE for x in point):
            return True
        return all(c.relation != "=" or exactly(c, exact) is not None for c in claims)

    found = interior(variables, claims, values, seem, budget)
    return None if found is None else dict(zip(variables, map(as_term, found), strict=True))
