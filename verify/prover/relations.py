"""What a relation means: the only place where `<`, `<=` and `=` are given a meaning."""

from __future__ import annotations

from collections.abc import Callable
from operator import le, lt
from typing import Any

from verify.language.record import Record
from verify.language.terms import Claim

#: What a claim comes to, in compiled code: the claim is certified, its negation is, or neither.
HOLDS, FAILS, OPEN = 1, 2, 0


class Meaning(Record):
    """When a relation holds, and when it fails, between two values of an ordered type.

    Each is true only if it is so for all numbers of both values, so that balls can be compared.
    """

    holds: Callable[[Any, Any], bool]
    fails: Callable[[Any, Any], bool]


def _equal(x: Any, y: Any) -> bool:
    return bool(x <= y) and bool(y <= x)


def _different(x: Any, y: Any) -> bool:
    return bool(x < y) or bool(y < x)


MEANINGS = {
    "<": Meaning(lt, lambda x, y: y <= x),
    "<=": Meaning(le, lambda x, y: y < x),
    "=": Meaning(_equal, _different),
}


def holds(relation: str, x: Any, y: Any) -> bool:
    """True only if the relation holds between all numbers of x and y.

    Raises:
        KeyError: for an unknown relation.
    """
    return bool(MEANINGS[relation].holds(x, y))


def fails(relation: str, x: Any, y: Any) -> bool:
    """True only if the relation fails between all numbers of x and y.

    Raises:
        KeyError: for an unknown relation.
    """
    return bool(MEANINGS[relation].fails(x, y))


def negation(claim: Claim) -> Claim | None:
    """The claim that holds where this one fails, unless that takes two claims."""
    swapped = {"<": "<=", "<=": "<"}
    if claim.relation not in swapped:
        return None
    return Claim(swapped[claim.relation], claim.rhs, claim.lhs)
