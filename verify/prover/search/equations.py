"""Claims where equations hold: what is left of them after multiples of the equations are taken off.

What is left has fewer variables, or a lower degree: it is shown as a lemma, from givens of which
the same multiples are taken off.
"""

from __future__ import annotations

from flint import fmpq_mpoly

from verify.language.terms import Claim
from verify.prover.clearing import expanded
from verify.prover.proof import Proof, Value
from verify.prover.rules import Sum
from verify.prover.search.ideal import Cofactors, Ideal
from verify.prover.search.question import Question
from verify.prover.search.system import System
from verify.prover.session import ZERO

#: Facts that are shorter than this are rewritten too.
MAX_TERMS = 60


def by_normal_form(question: Question) -> Proof | None:
    """The claim without what the equations replace."""
    system = System(question)
    if not system.equations:
        return None
    ideal = Ideal(system.equations, question.budget)
    rest, taken = ideal.normal_form(system.goal.polynomial)
    if question.goal.claim.relation == "=":
        return None if not rest.is_zero() else _sum(system, (), taken, sign=1)
    if not taken:
        return None
    _rewrite(system, ideal)
    question.known.ranged.discard(question.goal.context)
    value = question.lemma(question.goal.claim.relation, -rest, expanded(-rest, system.atoms))
    return None if value is None else _sum(system, ("goal", value), taken, sign=-1)


def _rewrite(system: System, ideal: Ideal) -> None:
    """Afterwards inequalities without what the equations replace are known, too."""
    question = system.question
    for fact in system.facts:
        if not isinstance(fact.value, str) or fact.value in system.enclosures | system.ranges:
            continue
        rest, taken = ideal.normal_form(fact.polynomial)
        if not taken or rest.is_constant() or len(rest) > MAX_TERMS:
            continue
        claim = Claim("<" if fact.strict else "<=", ZERO, expanded(rest, system.atoms))
        place = question.goal.context
        if question.session.known(claim, place) is None:
            proof = _sum(system, ("goal", fact.value), taken, sign=-1)
            question.known.rows.add(question.session.lemma(claim, proof, place))


def _sum(system: System, addends: tuple[Value, ...], taken: Cofactors, *, sign: int) -> Sum:
    """Values, and multiples of equations."""
    equations = tuple((name, expanded(_signed(p, sign), system.atoms)) for name, p in taken.items())
    return Sum(addends, system.using, equations)


def _signed(polynomial: fmpq_mpoly, sign: int) -> fmpq_mpoly:
    return polynomial if sign > 0 else -polynomial
