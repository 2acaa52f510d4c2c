"""Polynomials that are positive on a box, a half-line or everywhere: by squares times facts.

By the theorems of Schmüdgen and Putinar a polynomial that is positive on a compact set given by
inequalities is a sum of squares times products of them; what is tried are small degrees.

A form that is no sum of squares may be one after it is multiplied by one. For a form p of degree 2d
and t = x_1^2 + ... + x_n^2, let t p = A and p + s t = B be sums of squares, where s = c t^(d-1).
Then G = -p > 0 cannot be, as G^2 + B G + s A = 0.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import combinations, islice
from math import comb

from flint import fmpq_mpoly

from verify.language.record import Record
from verify.language.terms import Term
from verify.prover.balls import fraction_of
from verify.prover.budget import WorkBudget
from verify.prover.proof import Proof, Value
from verify.prover.rules import Sum
from verify.prover.search.bases import Gradings, all_monomials, pruned
from verify.prover.search.domain import Domain, Factor, multiplied
from verify.prover.search.faces import Block, vanishing, vanishing_near
from verify.prover.search.question import Question
from verify.prover.search.squares import MAX_SIZE, Summand, decompose
from verify.prover.search.zeros import zeros_in_floats

ATTEMPTS = 100
#: Programmes of more work than this are not tried.
MAX_COST = 20_000_000
#: Products of three facts are tried where there are not more facts than this.
FEW = 6
#: Squares of sums of more monomials, before it is seen which of them can occur, are not tried.
MAX_MONOMIALS = 2000
#: Sums of more work for the checker are no proofs.
MAX_UNITS = 5_500_000
#: Forms of a higher degree are not multiplied by one.
MAX_DEGREE = 8


class Attempt(Record):
    """To write p, times the polynomial of a factor > 0, as squares times factors."""

    factors: list[Factor]
    blocks: list[Block]
    multiple: Factor | None = None


def squares(question: Question) -> Proof | None:
    """Squares times facts."""
    domain = Domain(question.goal, question.facts, None, question.is_negative)
    if not _is_short(domain):
        return None
    zeros = question.zeros(domain)
    return by_squares(domain, zeros, question.budget, question.using, ATTEMPTS)


def _is_short(domain: Domain) -> bool:
    """Whether squares may be sought, of sums of not too many monomials."""
    count, half = len(_connected(domain)), (int(domain.p.total_degree()) + 1) // 2
    return domain.is_plain and comb(count + max(half, 0), count) <= MAX_MONOMIALS


def by_squares(
    domain: Domain,
    zeros: Sequence[Sequence[Fraction]],
    budget: WorkBudget,
    using: tuple[str, ...] = (),
    attempts: int | None = None,
) -> Sum | None:
    """A proof of the claim; ``zeros`` are points of the domain where p is 0.

    A square that divides p is left out, unless p has to be positive. So many ``attempts`` are made
    at most.
    """
    if domain.p.is_zero():
        return None if domain.strict else Sum((domain.goal,), using)
    outer = None if domain.strict else domain.divide_by_squares()
    zeros = [point for point in zeros if domain.is_zero(point)]
    near = zeros_in_floats(domain, budget)
    tried = set()
    for attempt in islice(_attempts(domain), attempts):
        polynomials = [factor.polynomial for factor in attempt.factors]
        p = domain.p
        if attempt.multiple is not None:
            p = domain.reduced(p * attempt.multiple.polynomial)
        gradings = Gradings(p, polynomials, domain.squares)
        blocks = [part for block in attempt.blocks for part in gradings.split(block)]
        key = str((p, [(polynomials[b.factor], b.basis) for b in blocks]))
        if not is_small(blocks) or key in tried:
            continue
        tried.add(key)
        for point in zeros:
            blocks = [vanishing(block, polynomials[block.factor], point) for block in blocks]
        smaller = [vanishing_near(b, polynomials[b.factor], near) for b in blocks]
        blocks = smaller if any(block.basis for block in smaller) else blocks
        terms = decompose(p, domain, polynomials, blocks, budget)
        proof = None if terms is None else written(domain, attempt, terms, outer)
        if proof is not None:
            return proof._replace(using=using)
    return None if outer is not None else by_form(domain, near, budget, using)


def written(
    domain: Domain, attempt: Attempt, terms: Sequence[Summand], outer: Term | None
) -> Sum | None:
    """The sum, if it is strict, and not too much work for the checker."""
    goal, strict = domain.goal, not domain.strict
    if attempt.multiple is not None:
        goal, strict = ("mul", goal, attempt.multiple.value), strict and attempt.multiple.strict
    addends: list[Value] = [goal]
    units = 0
    for weight, index, square in terms:
        factor = attempt.factors[index]
        value, is_strict = _value(domain, weight, factor, square)
        addends.append(value if outer is None else ("mul", ("square", outer), value))
        strict = strict or (is_strict and outer is None)
        units += _units(domain, factor, square)
    return Sum(tuple(addends)) if strict and 3 * units < MAX_UNITS else None


def _units(domain: Domain, factor: Factor, square: fmpq_mpoly) -> int:
    """About the work of the checker for one term: expanding the square, times its factors."""
    flat = domain.unscaled(square)
    n, twice = len(flat), flat * flat
    size = 3 + max(c.height_bits() for c in flat.coeffs()) // 120
    atoms = 1 + max(sum(map(bool, m)) for m in flat.monoms())
    total = size * (6 * n * len(square) + 2 * n * n * atoms + 2 * len(twice) * atoms)
    for part in factor.parts:
        total += 3 * size * len(twice) * len(part) * atoms
        twice = twice * part
    return total


def _value(
    domain: Domain, weight: Fraction, factor: Factor, square: fmpq_mpoly
) -> tuple[Value, bool]:
    """The product weight * factor * square^2 as a value, and whether it is strict."""
    constant = square.is_constant()
    if constant:
        leading = square.leading_coefficient()
        weight *= fraction_of(leading) ** 2
    parts: list[Value] = [str(weight)] if weight != 1 or factor.value == "1" else []
    if not constant:
        parts.append(("square", domain.term(square)))
    if factor.value != "1":
        parts.append(factor.value)
    value = parts[0] if len(parts) == 1 else ("mul", *parts)
    return value, constant and factor.strict


def is_small(blocks: Sequence[Block]) -> bool:
    """Whether the semidefinite programme is not too much work."""
    sizes = [len(block.basis) for block in blocks]
    return 0 < max(sizes, default=0) <= MAX_SIZE and sum(n**4 for n in sizes) <= MAX_COST


def _attempts(domain: Domain) -> Iterator[Attempt]:
    """Products of facts with bases of squares, those of little work first."""
    p, one = domain.p, Factor(domain.number(1), "1", True, ())
    degree = max(int(p.total_degree()), 1)
    top = degree + degree % 2
    used = _connected(domain)
    facts = [f for f in domain.facts.values() if set(_variables(f.polynomial)) <= set(used)]
    if not facts or top > 2:
        yield Attempt([one], [Block(0, pruned(domain, p, top // 2, used))])
    if not facts:
        multiple = _of_squares(domain, used)
        basis = pruned(domain, p * multiple.polynomial, top // 2 + 1, used)
        yield Attempt([one], [Block(0, basis)], multiple)
        return
    goal = Factor(-domain.whole, domain.goal, not domain.strict, (domain.whole,))
    pairs = [multiplied(a, b) for a, b in combinations(facts, 2)]
    ends = [f for f in pairs if len(_variables(f.polynomial)) == 1]
    mixed = pairs if len(ends) < len(pairs) else []
    again = [multiplied(goal, f) for f in (*facts, goal)]
    triples = [multiplied(a, b) for a, b in _triples(facts, pairs)] if len(facts) <= FEW else []
    if domain.strict:
        ends = [*ends, *_powers(facts, top + 2)]
    for higher in (top, top + 2):
        yield _attempt(domain, [one, *facts, *ends], higher, used)
        if mixed:
            yield _attempt(domain, [one, *facts, *mixed], higher, used)
        if triples and degree > 2:
            yield _attempt(domain, [one, *facts, *pairs, *triples], higher, used)
        yield _attempt(domain, [one, *facts, *ends, *again], higher, used)
        if mixed:
            yield _attempt(domain, [one, *facts, *mixed, *again], higher, used)
    for fact in (goal, *facts[:FEW]):
        if fact.strict:
            even = degree + 1 + (degree + 1) % 2
            yield _attempt(domain, [one, *facts, *pairs, *again], even, used, fact)


def _attempt(
    domain: Domain,
    factors: list[Factor],
    degree: int,
    used: Sequence[int],
    multiple: Factor | None = None,
) -> Attempt:
    """Bases of monomials so that all products are of this degree at most."""
    halves = [(degree - int(factor.polynomial.total_degree())) // 2 for factor in factors]
    blocks = [Block(i, all_monomials(domain, h, used)) for i, h in enumerate(halves) if h >= 0]
    return Attempt(factors, blocks, multiple)


def _powers(facts: Sequence[Factor], degree: int) -> Iterator[Factor]:
    """The odd powers of positive polynomials: they make a sum positive."""
    for fact in facts:
        power = fact
        for _ in range(3, degree // max(1, int(fact.polynomial.total_degree())) + 1, 2):
            power = multiplied(multiplied(power, fact), fact)
            if fact.strict:
                yield power


def _triples(facts: Sequence[Factor], pairs: Sequence[Factor]) -> Iterator[tuple[Factor, Factor]]:
    """What makes the products of three different facts."""
    order = [*combinations(range(len(facts)), 2)]
    for i, fact in enumerate(facts):
        for (j, _), pair in zip(order, pairs, strict=True):
            if i < j:
                yield fact, pair


def _of_squares(domain: Domain, used: Sequence[int]) -> Factor:
    """1 and the squares of the variables, added up."""
    polynomial = domain.number(1)
    values: list[Value] = ["1"]
    for i in used:
        polynomial += domain.gens[i] ** 2
        values.append(("square", domain.atoms[i]))
    return Factor(polynomial, ("add", *values), True, ())


def _variables(polynomial: fmpq_mpoly) -> list[int]:
    return [i for i, d in enumerate(polynomial.degrees()) if d > 0]


def _connected(domain: Domain) -> list[int]:
    """The atoms of p, and of the facts that have something to do with it."""
    used = set(_variables(domain.p))
    sets = [set(_variables(f.polynomial)) for f in domain.facts.values()]
    while more := [s for s in sets if s & used and not s <= used]:
        used.update(*more)
    return sorted(used)


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
