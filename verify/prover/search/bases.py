"""Bases of monomials for squares: all of a degree, or those that the Newton polytope allows."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations

from flint import fmpq, fmpq_mpoly

from verify.prover.search.domain import Domain

Exponents = tuple[int, ...]


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


def all_monomials(
    domain: Domain, degree: int, used: Sequence[int], *, exact: bool = False
) -> tuple[fmpq_mpoly, ...]:
    """All monomials of at most this degree, or of just this degree."""
    found = _exponents(len(domain.atoms), used, degree)
    return _monomials(domain, [e for e in found if not exact or sum(e) == degree])


def pruned(
    domain: Domain, p: fmpq_mpoly, degree: int, used: Sequence[int]
) -> tuple[fmpq_mpoly, ...]:
    """Only those that may occur in squares that add up to p.

    Twice their exponents lie in the Newton polytope of p (Reznick); and a square that no other
    product of two of them cancels has to be in p.
    """
    support = [tuple(map(int, m)) for m in p.monoms()]
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
