"""Zeros of a polynomial on its domain, in floats, those with irrational coordinates too.

Where a form has a zero it has a line of them: one on each is found by setting a variable to 1.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from fractions import Fraction

from flint import fmpq_mpoly

from verify.language.terms import Claim, symbol
from verify.prover.balls import float_of, fmpq_of
from verify.prover.budget import WorkBudget
from verify.prover.clearing import expanded
from verify.prover.goal import Bounds, Goal
from verify.prover.search.domain import Domain
from verify.prover.search.faces import gauss, value_at
from verify.prover.search.local_minima import Minima
from verify.prover.session import ZERO

#: A minimum below this, for coefficients of size 1, may be a zero.
NEAR_ZERO = 1e-7
#: Where the polynomial is larger than this after polishing there is no zero.
IS_ZERO = 1e-13
STEPS = 6
MAX_MONOMIALS = 150
MAX_VARIABLES = 6

Point = tuple[float, ...]


def zeros_in_floats(domain: Domain, budget: WorkBudget) -> list[Point]:
    """Zeros of p in scaled coordinates where all facts hold; not of a domain with roots."""
    p = domain.p
    used = domain.used
    if domain.squares or not 0 < len(used) <= MAX_VARIABLES or len(p) > MAX_MONOMIALS:
        return []
    if any(domain.atoms[i].op != "symbol" for i in used):
        return []
    found: list[Point] = []
    size = max(float_of(abs(c)) for c in p.coeffs())
    if not math.isfinite(size):
        return []
    for fixed in _slices(domain):
        for point in _minima(domain, fixed, budget, NEAR_ZERO * size):
            polished = _polished(p, point, fixed, used)
            if polished is not None and abs(value_at(p, polished)) < IS_ZERO * size:
                found.append(polished)
    return [point for point in found if _is_inside(domain, point) and _may_be_zero(domain, point)]


def _slices(domain: Domain) -> Iterator[int | None]:
    """The variables that are set to 1, for a form; else none."""
    if len({sum(map(int, m)) for m in domain.p.monoms()}) > 1:
        yield None
    else:
        yield from domain.used


def _minima(domain: Domain, fixed: int | None, budget: WorkBudget, most: float) -> Iterator[Point]:
    """Local minima where p is nearly 0."""
    p, n = domain.p, len(domain.atoms)
    names = [symbol(f"u.{i}") for i in range(n)]
    left = [i for i in domain.used if i != fixed]
    if fixed is not None:
        gens = list(domain.gens)
        gens[fixed] = domain.number(1)
        p = p.compose(*gens)
    bounds = {}
    for i in left:
        low, high = domain.ends[i]
        if fixed is not None:
            low, high = Fraction(-1) if low is None else low, Fraction(1)
        bounds[f"u.{i}"] = Bounds(low, high)
    claim = Claim("<=", ZERO, expanded(p, names))
    goal = Goal(claim, None, bounds, (), {})
    for value, point in Minima(goal, budget).found():
        if value > most:
            return
        coordinates = dict(zip(left, point, strict=True))
        yield tuple(1.0 if i == fixed else coordinates.get(i, 0.0) for i in range(n))


def _polished(p: fmpq_mpoly, point: Point, fixed: int | None, used: Sequence[int]) -> Point | None:
    """Nearer to a zero of the gradient in the free variables, by Newton's method."""
    free = [i for i in used if i != fixed and abs(abs(point[i]) - 1) > 1e-9 and point[i] != 0]
    if not free:
        return point
    first = [p.derivative(i) for i in free]
    second = [[g.derivative(i) for i in free] for g in first]
    x = list(point)
    for _ in range(STEPS):
        hessian = [[value_at(h, x) for h in row] for row in second]
        step = gauss(hessian, [-value_at(g, x) for g in first])
        for i, d in zip(free, step, strict=True):
            x[i] += d
    if max(abs(a - b) for a, b in zip(x, point, strict=True)) > 1e-3:
        return None
    return tuple(x)


def _is_inside(domain: Domain, point: Point) -> bool:
    return all(value_at(f.polynomial, point) > -1e-9 for f in domain.facts.values())


def _may_be_zero(domain: Domain, point: Point) -> bool:
    """False for simple numbers where p is not 0."""
    near = [Fraction(x).limit_denominator(1000) for x in point]
    if any(abs(float(a) - b) > 1e-8 for a, b in zip(near, point, strict=True)):
        return True
    return not domain.p(*map(fmpq_of, near))
