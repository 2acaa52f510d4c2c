"""Polynomials that are positive on a box, a half-line or everywhere: by squares times facts.

By the theorems of Schmüdgen and Putinar a polynomial that is positive on a compact set given by
inequalities is a sum of squares times products of them; what is tried are small degrees.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import combinations

from flint import fmpq, fmpq_mpoly

from verify.prover.budget import Budget
from verify.prover.proof import Value
from verify.prover.rules import Sum
from verify.prover.search.domain import Domain, Factor, product
from verify.prover.search.squares import MAX_SIZE, Block, decompose, vanishing

Exponents = tuple[int, ...]

#: Programmes of more work than this are not tried.
MAX_COST = 20_000_000
#: Sums of more work for the checker are no proofs.
MAX_UNITS = 5_000_000


def by_squares(
    domain: Domain, zeros: Sequence[Sequence[Fraction]], budget: Budget, using: tuple[str, ...] = ()
) -> Sum | None:
    """A proof of the claim; ``zeros`` are points of the domain where p is 0.

    A square that divides p is left out at first.
    """
    outer = domain.divide_by_squares()
    zeros = [point for point in zeros if domain.is_zero(point)]
    for factors, blocks in _attempts(domain):
        if _cost(blocks) > MAX_COST or max(len(b.basis) for b in blocks) > MAX_SIZE:
            continue
        polynomials = [factor.polynomial for factor in factors]
        for point in zeros:
            blocks = [vanishing(block, polynomials[block.factor], point) for block in blocks]
        terms = decompose(domain, polynomials, blocks, budget)
        if terms is None:
            continue
        addends: list[Value] = [domain.goal]
        strict = not domain.strict
        for weight, index, square in terms:
            value, is_strict = _value(domain, weight, factors[index], square)
            addends.append(value if outer is None else ("mul", ("square", outer), value))
            strict = strict or (is_strict and outer is None)
        if strict and sum(_units(domain, factors[t.factor], t.square) for t in terms) < MAX_UNITS:
            return Sum(tuple(addends), using)
    return None


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
    """weight * factor * square^2 as a value, and whether it is strict."""
    constant = square.is_constant()
    if constant:
        leading = square.leading_coefficient()
        weight *= Fraction(int(leading.p), int(leading.q)) ** 2
    parts: list[Value] = [str(weight)] if weight != 1 or factor.value == "1" else []
    if not constant:
        parts.append(("square", domain.term(square)))
    if factor.value != "1":
        parts.append(factor.value)
    value = parts[0] if len(parts) == 1 else ("mul", *parts)
    return value, constant and factor.strict


def _cost(blocks: Sequence[Block]) -> int:
    return sum(len(block.basis) ** 4 for block in blocks)


def _attempts(domain: Domain) -> Iterator[tuple[list[Factor], list[Block]]]:
    """Products of facts with bases of squares, those of little work first."""
    p, one = domain.p, Factor(domain.number(1), "1", True, ())
    degree = max(int(p.total_degree()), 1)
    top = degree + degree % 2
    used = _connected(domain)
    facts = [f for f in domain.facts.values() if set(_variables(f.polynomial)) <= set(used)]
    if not facts or top > 2:
        yield [one], [Block(0, _pruned(domain, top // 2, used))]
    if not facts:
        yield [one], [Block(0, _all(domain, top // 2 + 1, used))]
        return
    pairs = [product(a, b) for a, b in combinations(facts, 2)]
    ends = [f for f in pairs if len(_variables(f.polynomial)) == 1]
    mixed = [f for f in pairs if len(_variables(f.polynomial)) > 1]
    goal = Factor(-p, domain.goal, not domain.strict, (p,))
    again = [product(goal, f) for f in (*facts, goal)]
    for higher in (top, top + 2):
        for chosen in (
            [*facts, *ends],
            [*facts, *pairs] if mixed else [],
            [*facts, *ends, *again],
            [*facts, *pairs, *again] if mixed else [],
        ):
            factors = [one, *chosen]
            degrees = [int(f.polynomial.total_degree()) for f in factors]
            blocks = [
                Block(i, _all(domain, (higher - d) // 2, used))
                for i, d in enumerate(degrees)
                if d <= higher
            ]
            if chosen:
                yield factors, blocks


def _variables(polynomial: fmpq_mpoly) -> list[int]:
    return [i for i, d in enumerate(polynomial.degrees()) if d]


def _connected(domain: Domain) -> list[int]:
    """The atoms of p, and of the facts that have something to do with it."""
    used = set(_variables(domain.p))
    sets = [set(_variables(f.polynomial)) for f in domain.facts.values()]
    while more := [s for s in sets if s & used and not s <= used]:
        used.update(*more)
    return sorted(used)


# --- bases ---------------------------------------------------------------------------------------


def _exponents(n: int, used: Sequence[int], degree: int) -> Iterator[Exponents]:
    """All exponents of monomials of at most this degree, the highest first."""

    def further(left: Sequence[int], room: int) -> Iterator[dict[int, int]]:
        if not left:
            yield {}
            return
        for e in range(room, -1, -1):
            for rest in further(left[1:], room - e):
                yield {left[0]: e, **rest}

    found = [tuple(e.get(i, 0) for i in range(n)) for e in further(used, degree)]
    yield from sorted(found, key=lambda e: (-sum(e), e))


def _monomials(domain: Domain, found: Sequence[Exponents]) -> tuple[fmpq_mpoly, ...]:
    return tuple(domain.context.from_dict({e: fmpq(1)}) for e in found)


def _all(domain: Domain, degree: int, used: Sequence[int]) -> tuple[fmpq_mpoly, ...]:
    return _monomials(domain, [*_exponents(len(domain.atoms), used, degree)])


def _pruned(domain: Domain, degree: int, used: Sequence[int]) -> tuple[fmpq_mpoly, ...]:
    """Only those that may occur in squares that add up to p.

    Twice their exponents lie in the Newton polytope of p (Reznick); and a square that no other
    product of two of them cancels has to be in p.
    """
    support = [tuple(map(int, m)) for m in domain.p.monoms()]
    n = len(domain.atoms)
    directions = [*_directions(n, used)]
    most = [max(_dot(d, e) for e in support) for d in directions]
    found = [
        e
        for e in _exponents(n, used, degree)
        if all(2 * _dot(d, e) <= top for d, top in zip(directions, most, strict=True))
    ]
    present = set(support)
    while True:
        products: dict[Exponents, int] = {}
        for a, b in combinations(found, 2):
            key = tuple(x + y for x, y in zip(a, b, strict=True))
            products[key] = products.get(key, 0) + 1
        kept = [e for e in found if (d := tuple(2 * x for x in e)) in present or d in products]
        if len(kept) == len(found):
            return _monomials(domain, found)
        found = kept


def _dot(a: Sequence[int], b: Sequence[int]) -> int:
    return sum(x * y for x, y in zip(a, b, strict=True))


def _directions(n: int, used: Sequence[int]) -> Iterator[list[int]]:
    """Some directions in which the exponents of p are bounded."""
    for i in used:
        yield [int(j == i) for j in range(n)]
        yield [-int(j == i) for j in range(n)]
    yield [-1] * n
    for a, b in combinations(used, 2):
        for x, y in (
            (1, 1),
            (1, -1),
            (-1, 1),
            (-1, -1),
            (1, 2),
            (2, 1),
            (-1, 2),
            (2, -1),
            (1, -2),
            (-2, 1),
            (-1, -2),
            (-2, -1),
            (3, -2),
            (-2, 3),
            (3, -1),
            (-1, 3),
        ):
            yield [x * (j == a) + y * (j == b) for j in range(n)]
    for a, b, c in combinations(used, 3):
        for k in range(1, 8):
            signs = [1 if k >> i & 1 else -1 for i in range(3)]
            yield [
                signs[0] * (j == a) + signs[1] * (j == b) + signs[2] * (j == c) for j in range(n)
            ]
