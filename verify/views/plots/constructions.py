"""The constants of both sets as formulas in r and c, and the rows that judge them.

The repaired constants are short decimals chosen at one point. Over a region they are formulas: a
fixed share of the bound below which each may be chosen, so that each row is a claim about r and
c. (V_0 and delta_theta are those of the committed certificates.)
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from functools import cache
from typing import NamedTuple

from verify.prover.algebra import is_identity
from verify.paper.theorem1 import theorem
from verify.prover.ground import PROVED, Prover
from verify.language.statement import Constant, Obligation, Statement
from verify.language.terms import Term, as_term, symbol

FIXED = {"V_0": as_term(1), "delta_theta": as_term(Fraction(1, 10))}

#: Where it is found out which rows are identities.
SAMPLE = FIXED | {"r": as_term(Fraction(3, 100)), "c": as_term(1)}


def as_formulas(group: str, share: Fraction) -> Statement:
    """The statement of a set whose constants are ``share`` of their bounds (1/share of T*)."""
    statement = theorem().of_group(group)
    return statement._replace(constants=tuple(_formula(c, share) for c in statement.constants))


def _formula(constant: Constant, share: Fraction) -> Constant:
    if not constant.chosen or share == 1:
        return constant._replace(chosen=False)
    if constant.base is not None:
        term = constant.base + share * (constant.term - constant.base)
    else:
        term = (share if constant.direction == "down" else 1 / share) * constant.term
    return constant._replace(term=term, chosen=False)


def definitions(statement: Statement) -> Iterator[tuple[str, Term]]:
    """What a field over r and c needs; r and c themselves stay to be defined before it."""
    yield from FIXED.items()
    for constant in statement.constants:
        # phi+ = alpha_0 - phi-, the sum of the roots: the slopes of alpha_0 then cancel.
        term = symbol("alpha_0") - symbol("phi_minus") if constant.name == "phi_plus" else None
        yield constant.name, constant.term if term is None else term


class Rows(NamedTuple):
    """The rows of a set: those that enclosures can decide, and those that algebra does.

    ``algebraic`` rows are identities of formulas, or follow because a min is at most its entries;
    the same rewriting proves them for all parameters, and as both sides are equal no enclosure
    can. The sample point only shows which rows these are.
    """

    open: tuple[Obligation, ...]
    algebraic: tuple[Obligation, ...]


@cache
def rows(group: str, share: Fraction) -> Rows:
    """The rows of a set, sorted into the two kinds."""
    statement = as_formulas(group, share)
    prover = Prover(statement, SAMPLE)
    open_rows: list[Obligation] = []
    algebraic: list[Obligation] = []
    for row in statement.obligations:
        decision = prover.decide(row.claim)
        used = {name for name, _ in decision.steps}
        rewritten = decision.closing == "identity" and not used & set(SAMPLE)
        rewritten = rewritten and decision.verdict == PROVED
        equal = row.claim.relation != "<" and is_identity(row.claim.lhs, row.claim.rhs)
        (algebraic if rewritten or equal else open_rows).append(row)
    return Rows(tuple(open_rows), tuple(algebraic))
