"""Sines and cosines of rational multiples of pi, of which `cos_pi` has the exact values.

By laws cos u = cos_pi(u/π), and sin u = cos(π/2 - u).
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

from flint import fmpq

from verify.language.fold import replaced
from verify.language.terms import Claim, Term, as_term, cos, cos_pi, equal, parts_of, pi
from verify.prover.clearing import Clearing
from verify.prover.numbers import fraction_of
from verify.prover.proof import Proof
from verify.prover.rules import Law, Sum
from verify.prover.tight import Tight


def by_half_turns(
    tight: Tight, claim: Claim, prove: Callable[[Claim], Proof | None]
) -> Proof | None:
    """A proof of a claim by one of the same about values of `cos_pi`, if it has such angles."""
    equations: dict[Term, tuple[str, Term]] = {}
    for part in parts_of(claim.lhs, claim.rhs):
        if part.op in ("cos", "sin") and tight.cleared(part):
            turns = _half_turns(part.children[0])
            if turns is not None:
                equations |= _equations(tight, part, turns)
    if not equations:
        return None
    values = {atom: value for atom, (_, value) in equations.items()}
    sides = [replaced(replaced(side, values), values) for side in (claim.lhs, claim.rhs)]
    simpler = Claim(claim.relation, *sides)
    if not tight.cleared(*sides):
        return None
    session, proof = tight.session, prove(simpler)
    if proof is None:
        return None
    lemma = session.known(simpler, None) or session.lemma(simpler, proof)
    using = tuple(name for name, _ in equations.values())
    if claim.relation == "=":
        return Sum((), using, ((lemma, as_term(1)),))
    return Sum(("goal", lemma), using)


def _equations(tight: Tight, part: Term, turns: Fraction) -> dict[Term, tuple[str, Term]]:
    """For each atom on the way from a sine or cosine to `cos_pi` the equation, and what it is."""
    found: dict[Term, tuple[str, Term]] = {}
    session = tight.session
    if part.op == "sin":
        turns = Fraction(1, 2) - turns
        shifted = cos(turns * pi)
        found[part] = session.lemma(equal(part, shifted), Law()), shifted
        part = shifted
    value = cos_pi(turns)
    found[part] = session.lemma(equal(part, value), Law()), value
    return found


def _half_turns(angle: Term) -> Fraction | None:
    """The rational q of an angle q pi; None for any other."""
    clearing = Clearing((angle,), {})
    if clearing.atoms not in ([], [pi]):
        return None
    above, below = clearing.clear(angle)
    quotient = above / below.leading_coefficient() if below.is_constant() else None
    if quotient is None:
        return None
    powers = {int(m[0]) if m else 0: c for m, c in quotient.to_dict().items()}
    return fraction_of(powers.get(1, fmpq(0))) if powers.keys() <= {1} else None
