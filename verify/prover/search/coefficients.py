"""Polynomials without negative coefficients in numbers that facts say are >= 0.

Each variable is a lower bound, or another variable that is not above it, plus such a number.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction

from flint import fmpq_mpoly

from verify.language.record import TYPE_CHECKING
from verify.prover.proof import Value
from verify.prover.rules import Sum

if TYPE_CHECKING:
    from verify.prover.search.strategy import Strategy

MAX_MONOMIALS = 400


def by_coefficients(
    strategy: Strategy,
    order: Sequence[str] = (),
    above: Mapping[tuple[str, str], str] | None = None,
) -> Sum | None:
    """A proof, for variables in an order: ``above`` has the fact that one is not above the next."""
    goal = strategy.goal
    clearing = strategy.clearing
    if any(atom.op != "symbol" for atom in clearing.atoms):
        return None
    gens = dict(zip((atom.name for atom in clearing.atoms), clearing.context.gens(), strict=True))
    before = dict(zip(order[1:], order, strict=False))
    values, facts = [], []
    inner: dict[str, fmpq_mpoly] = {}
    for name in [*order, *(name for name in gens if name not in order)]:
        if name not in gens:
            return None
        bounds = goal.variables[name]
        if name in before:
            inner[name] = inner[before[name]] + gens[name]
            facts.append((name, (above or {})[before[name], name], False))
        elif bounds.low is not None and bounds.low_relation != "=":
            inner[name] = clearing.constant(bounds.low) + gens[name]
            facts.append((name, bounds.low_fact, bounds.low_relation == "<"))
        else:
            return None
    p = clearing.difference(goal.claim.rhs, goal.claim.lhs).compose(*(inner[n] for n in gens))
    monomials = p.to_dict()
    if len(monomials) > MAX_MONOMIALS or any(value < 0 for value in monomials.values()):
        return None
    known = {name: (fact, strict) for name, fact, strict in facts}
    strict = goal.claim.relation == "<="
    for exponents, value in monomials.items():
        factors: list[Value] = [str(Fraction(int(value.p), int(value.q)))]
        all_strict = True
        for name, exponent in zip(gens, exponents, strict=True):
            if exponent:
                fact, is_strict = known[name]
                factors.append(("pow", fact, int(exponent)) if exponent > 1 else fact)
                all_strict = all_strict and is_strict
        values.append(factors[0] if len(factors) == 1 else ("mul", *factors))
        strict = strict or all_strict
    return Sum(("goal", *values), strategy.using) if strict else None
