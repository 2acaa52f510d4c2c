"""Claims and facts as the checker reads them: equations replace atoms, and divisors are gone."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction

from verify.language.terms import Claim, Term, as_term
from verify.prover.balls import fraction_of
from verify.prover.clearing import ATOMS, Clearing
from verify.prover.proof import product_of
from verify.prover.rules import Sum
from verify.prover.session import Session


def outside_atoms(term: Term, chosen: Mapping[Term, Term], *, divisors: bool = True) -> Term:
    """A term as the checker replaces atoms by equations: not inside other atoms, and again.

    Without ``divisors`` these stay.
    """
    if term in chosen:
        return outside_atoms(chosen[term], chosen, divisors=divisors)
    if term.op in ATOMS or not term.children:
        return term
    children = [outside_atoms(child, chosen, divisors=divisors) for child in term.children]
    if term.op == "div" and not divisors:
        children[1] = term.children[1]
    return Term(term.op, *children, *term.args[len(children) :])


def scale(claim: Claim, replaced: Mapping[Term, Term]) -> Fraction | None:
    """By which number the checker multiplies the difference of the sides; None if by a term."""
    clearing = Clearing(claim.key[1:], replaced)
    (_, d), (_, e) = (clearing.clear(side) for side in (claim.lhs, claim.rhs))
    whole = d * e
    return fraction_of(whole.leading_coefficient()) if whole.is_constant() else None


def from_fact(
    session: Session,
    claim: Claim,
    fact: str | None,
    using: Sequence[str] = (),
    is_negative: Callable[[Term], bool] | None = None,
) -> Sum | None:
    """A proof of a claim from a fact; None if it is no multiple of it as the checker reads both.

    Raises:
        TooLongError: if expanding both is too much work.
    """
    if fact is None:
        return None
    other = session.claims[fact]
    sides = (claim.lhs, claim.rhs, other.lhs, other.rhs)
    clearing = Clearing(sides, session.replaced(using), is_negative)
    differences = [clearing.difference(*pair) for pair in (sides[:2], sides[2:])]
    p, q = clearing.reduced(differences)
    if p.is_zero() or q.is_zero():
        ratio = Fraction(1) if p == q else None
    else:
        leading = p.leading_coefficient() / q.leading_coefficient()
        ratio = fraction_of(leading) if p == leading * q else None
    if ratio is None:
        return None
    if claim.relation == "=":
        return Sum((), (*using,), ((fact, as_term(ratio)),))
    return Sum(("goal", product_of(str(ratio), fact)), (*using,)) if ratio > 0 else None
