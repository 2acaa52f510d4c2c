"""Bases of monomials for squares, and what scalings and changes of sign leave of them.

The monomials are all of a degree, or those that the Newton polytope allows. If p and all factors
are multiplied by powers of c when each x_i is by c^w_i, then only squares for which the products
have the weight of p can help (the others' leading parts would have to cancel). If changing the
signs of some x_i changes none of them, the matrices may be averaged over that: no entry is left but
between monomials that change in the same way.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cache
from itertools import combinations, product
from math import lcm

from flint import fmpq, fmpq_mat, fmpq_mpoly, nmod_mat

from verify.prover.search.domain import Domain
from verify.prover.search.faces import Block, null_space

Exponents = tuple[int, ...]
#: The directions in the plane of two exponents.
SLOPES = [(x, y) for x, y in product((-2, -1, 1, 2), repeat=2) if abs(x * y) < 4]
SLOPES += [(3, -2), (-2, 3), (3, -1), (-1, 3)]


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
    present = set(support)
    directions = [*_directions(n, used)]

    @cache
    def top(number: int) -> int:
        return max(_dot(directions[number], e) for e in support)

    def is_inside(twice: Exponents) -> bool:
        """Most are seen at once: those in p are inside, and others outside of the first few."""
        if twice in present:
            return True
        return all(_dot(d, twice) <= top(number) for number, d in enumerate(directions))

    found = [e for e in _exponents(n, used, degree) if is_inside(tuple(2 * x for x in e))]
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
        for x, y in SLOPES:
            yield [x * (j == a) + y * (j == b) for j in range(n)]
    for a, b, c in combinations(used, 3):
        for k in range(1, 8):
            signs = [1 if k >> i & 1 else -1 for i in range(3)]
            yield [
                signs[0] * (j == a) + signs[1] * (j == b) + signs[2] * (j == c) for j in range(n)
            ]


class Gradings:
    """The scalings and signs of a polynomial, of factors, and of squares of roots."""

    def __init__(
        self,
        target: fmpq_mpoly,
        factors: Sequence[fmpq_mpoly],
        squares: Sequence[tuple[int, fmpq_mpoly]],
    ) -> None:
        self.target = _first(target)
        self.factors = [_first(factor) for factor in factors]
        rows = [row for polynomial in (target, *factors) for row in _differences(polynomial)]
        for index, square in squares:
            twice = tuple(2 * (i == index) for i in range(len(self.target)))
            rows += [_minus(m, twice) for m in _support(square)]
        rows = sorted(set(rows)) or [(0,) * len(self.target)]
        self.weights = [*_kernel(rows)]
        self.signs = [*_signs(rows)]

    def split(self, block: Block) -> Iterator[Block]:
        """What is left of a block of monomials, by the signs."""
        factor = self.factors[block.factor]
        if any(_dot(s, self.target) % 2 != _dot(s, factor) % 2 for s in self.signs):
            return
        classes: dict[Exponents, list[fmpq_mpoly]] = {}
        wanted = _minus(self.target, factor)
        for element in block.basis:
            exponents = _first(element)
            if all(2 * _dot(w, exponents) == _dot(w, wanted) for w in self.weights):
                key = tuple(_dot(s, exponents) % 2 for s in self.signs)
                classes.setdefault(key, []).append(element)
        for basis in classes.values():
            yield block._replace(basis=tuple(basis))


def _support(polynomial: fmpq_mpoly) -> list[Exponents]:
    found = [tuple(map(int, m)) for m in polynomial.monoms()]
    return found or [(0,) * polynomial.context().nvars()]


def _first(polynomial: fmpq_mpoly) -> Exponents:
    return _support(polynomial)[0]


def _differences(polynomial: fmpq_mpoly) -> list[Exponents]:
    first, *others = _support(polynomial)
    return [_minus(other, first) for other in others]


def _minus(a: Exponents, b: Exponents) -> Exponents:
    return tuple(x - y for x, y in zip(a, b, strict=True))


def _kernel(rows: Sequence[Exponents]) -> Iterator[list[int]]:
    """Integer vectors that span what all rows are orthogonal to."""
    for vector in null_space(fmpq_mat([[fmpq(v) for v in row] for row in rows])):
        numbers = [*map(fmpq, vector)]
        scale = lcm(*(int(value.q) for value in numbers))
        yield [int((value * scale).p) for value in numbers]


def _signs(rows: Sequence[Exponents]) -> Iterator[list[int]]:
    """Vectors of 0 and 1 that span what all rows are orthogonal to, modulo 2."""
    for vector in null_space(nmod_mat([[v % 2 for v in row] for row in rows], 2)):
        yield [*map(int, vector)]
