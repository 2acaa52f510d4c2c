"""Forms that are no sums of squares, but are one after they are multiplied by one.

For a form p of degree 2d and t = x_1^2 + ... + x_n^2, let t p = A and p + s t = B be sums of
squares, where s = c t^(d-1). Then G = -p > 0 cannot be, as G^2 + B G + s A = 0.
"""

from __future__ import annotations

from collections.abc import Sequence

from flint import fmpq_mpoly

from verify.prover.balls import fraction_of
from verify.prover.budget import WorkBudget
from verify.prover.proof import Value
from verify.prover.rules import Sum
from verify.prover.search.bases import all_monomials, pruned
from verify.prover.search.domain import Domain
from verify.prover.search.faces import Block, vanishing_near
from verify.prover.search.squares import Summand, decompose

MAX_DEGREE = 8


def by_form(
    domain: Domain, zeros: Sequence[Sequence[float]], budget: WorkBudget, using: tuple[str, ...]
) -> Sum | None:
    """A proof of p >= 0 for a form p on the whole space; ``zeros`` are some of p."""
    p, used = domain.p, domain.used
    degrees = {sum(map(int, m)) for m in p.monoms()}
    if domain.strict or domain.facts or len(degrees) != 1 or any(s.m for s in domain.scales):
        return None
    half, odd = divmod(degrees.pop(), 2)
    if odd or not 2 <= half <= MAX_DEGREE // 2:
        return None
    t = sum((domain.gens[i] ** 2 for i in used), domain.number(0))
    times = _squares(domain, p * t, pruned(domain, p * t, half + 1, used), zeros, budget)
    if times is None:
        return None
    c = max(abs(fraction_of(value)) for value in p.coeffs()) * len(p)
    basis = all_monomials(domain, half, used, exact=True)
    plus = _squares(domain, p + domain.number(c) * t**half, basis, (), budget)
    if plus is None:
        return None
    sphere: Value = ("add", *(("square", domain.atoms[i]) for i in used))
    s: Value = ("mul", str(c), sphere if half == 2 else ("pow", sphere, half - 1))
    values: list[Value] = [("pow", "goal", 2), ("mul", "goal", _sum(domain, plus))]
    return Sum((*values, ("mul", s, _sum(domain, times))), using)


def _squares(
    domain: Domain,
    p: fmpq_mpoly,
    basis: tuple[fmpq_mpoly, ...],
    zeros: Sequence[Sequence[float]],
    budget: WorkBudget,
) -> list[Summand] | None:
    one = domain.number(1)
    block = vanishing_near(Block(0, basis), one, zeros)
    return decompose(p, domain, [one], [block], budget)


def _sum(domain: Domain, terms: Sequence[Summand]) -> Value:
    values: list[Value] = [("mul", str(w), ("square", domain.term(q))) for w, _, q in terms]
    return values[0] if len(values) == 1 else ("add", *values)
