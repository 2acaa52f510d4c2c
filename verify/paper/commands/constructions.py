"""The constants of both sets as formulas in r and c, and the rows that judge them.

The repaired constants are short decimals chosen at one point. Over a region they are formulas: a
fixed share of the bound below which each may be chosen, so that each row is a claim about r and
c. (V_0 and delta_theta are those of the committed certificates.)
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from fractions import Fraction
from functools import cache

from verify.language.record import Record
from verify.language.statement import PROVED, Choice, Constant, Obligation
from verify.language.terms import Claim, Term, as_term, sqrt, symbol
from verify.paper.theorem1 import theorem
from verify.prover.ground import Ground
from verify.prover.proof import LemmaStep, Proof
from verify.prover.rules import Interval
from verify.prover.session import Session

FIXED = {"V_0": as_term(1), "delta_theta": as_term(Fraction(1, 10))}

#: Where it is found out which rows are identities: irrational, so that values alone decide none.
SAMPLE = FIXED | {"r": sqrt(2) / 50, "c": sqrt(Fraction(19, 20))}


def formulas(group: str, share: Fraction) -> tuple[Constant, ...]:
    """The constants of a set as ``share`` of their bounds (1/share of T*), after the common ones.

    With the share 1 each is its bound.
    """
    own = theorem().parts[group].constants
    return (*theorem().common, *(_formula(constant, share) for constant in own))


def _formula(item: Constant | Choice, share: Fraction) -> Constant:
    if isinstance(item, Constant):
        return item
    bound = item.constant.term
    if share == 1:
        return item.constant
    if item.base is not None:
        return item.constant._replace(term=item.base + share * (bound - item.base))
    factor = share if item.direction == "down" else 1 / share
    return item.constant._replace(term=factor * bound)


def field_definitions(constants: Iterable[Constant]) -> Iterator[tuple[str, Term]]:
    """What a field over r and c needs; r and c themselves stay to be defined before it."""
    yield from FIXED.items()
    for constant in constants:
        # phi+ = alpha_0 - phi-, the sum of the roots: the slopes of alpha_0 then cancel.
        term = symbol("alpha_0") - symbol("phi_minus") if constant.name == "phi_plus" else None
        yield constant.name, constant.term if term is None else term


def at_point(group: str, share: Fraction, parameters: dict[str, Term]) -> Ground:
    """The formulas at one point, where claims about them can be decided."""
    ground = Ground(Session())
    for name, term in parameters.items():
        ground.define(Constant(name, name, name, "", term))
    for constant in formulas(group, share):
        ground.define(constant)
    return ground


class Rows(Record):
    """The rows of a set: those that enclosures can decide, and those that algebra does.

    The two sides of ``algebraic`` rows are equal wherever they are defined, or the row follows
    because a min is at most its entries; no enclosure can decide that. The sample point only
    shows which rows these are: the proof there uses no value of a parameter.
    """

    open: tuple[Obligation, ...]
    algebraic: tuple[Obligation, ...]

    @property
    def claims(self) -> dict[str, Claim]:
        """The claims that enclosures can decide, by the names of their rows."""
        return {row.name: row.claim for row in self.open if isinstance(row.claim, Claim)}


@cache
def sorted_rows(group: str, share: Fraction) -> Rows:
    """The rows of a set, sorted into the two kinds."""
    ground = at_point(group, share, SAMPLE)
    kinds: tuple[list[Obligation], list[Obligation]] = ([], [])
    for row in theorem().parts[group].obligations:
        kinds[_is_algebraic(ground, row)].append(row)
    return Rows(*map(tuple, kinds))


def _is_algebraic(ground: Ground, row: Obligation) -> bool:
    if not isinstance(row.claim, Claim):
        raise TypeError(f"{row.name} compares no numbers")
    before = len(ground.session.steps)
    verdict, proof = ground.prove(row.claim)
    if verdict != PROVED or proof is None or isinstance(proof, Interval):
        return False
    lemmas = [s.proof for s in ground.session.steps[before:] if isinstance(s, LemmaStep)]
    return not any(SAMPLE.keys() & _uses(found) for found in (proof, *lemmas))


def _uses(proof: Proof) -> set[str]:
    """The definitions that a proof by algebra unfolds."""
    return set(getattr(proof, "using", ()))
