"""What is claimed by formulas of which one holds: a or (b and c) is a or b, and a or c."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import chain, product
from math import prod

from verify.language.terms import Claim

#: Claims of which at least one holds.
Clause = tuple[Claim, ...]
#: So many clauses are read from one text with alternatives.
MAX_CLAUSES = 64


def one_of_each(parts: Sequence[Sequence[Clause]], *, chains: bool) -> list[Clause]:
    """The clauses that hold where all clauses of some part do; some parts may be ``chains``.

    Raises:
        ValueError: if they cannot be written as claims, saying what to write instead.
    """
    if chains:
        raise ValueError(
            "a chain is no alternative; write one sign on each side of or, or (a < b < c)"
        )
    if prod(map(len, parts)) > MAX_CLAUSES:
        raise ValueError(f"its alternatives are more than {MAX_CLAUSES} claims; write fewer")
    clauses = [tuple(dict.fromkeys(chain(*chosen))) for chosen in product(*parts)]
    if any(len({claim.relation for claim in clause}) > 1 for clause in clauses):
        raise ValueError(
            "alternatives need one relation in all of them; write < in each, which says more, "
            "or <= in each"
        )
    return clauses
