"""What scalings and changes of sign leave alone, and the smaller matrices that are left.

If p and all factors are multiplied by powers of c when each x_i is by c^w_i, then only squares for
which the products have the weight of p can help (the others' leading parts would have to cancel).
If changing the signs of some x_i changes none of them, the matrices may be averaged over that: no
entry is left but between monomials that change in the same way.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import lcm

from flint import fmpq, fmpq_mat, fmpq_mpoly, nmod_mat

from verify.prover.search.faces import Block

Exponents = tuple[int, ...]


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
            rows += [_minus(m, twice) for m in _exponents(square)]
        rows = sorted(set(rows)) or [(0,) * len(self.target)]
        self.weights = _kernel(rows)
        self.signs = _signs(rows)

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


def _exponents(polynomial: fmpq_mpoly) -> list[Exponents]:
    found = [tuple(map(int, m)) for m in polynomial.monoms()]
    return found or [(0,) * polynomial.context().nvars()]


def _first(polynomial: fmpq_mpoly) -> Exponents:
    return _exponents(polynomial)[0]


def _differences(polynomial: fmpq_mpoly) -> list[Exponents]:
    first, *others = _exponents(polynomial)
    return [_minus(other, first) for other in others]


def _minus(a: Exponents, b: Exponents) -> Exponents:
    return tuple(x - y for x, y in zip(a, b, strict=True))


def _dot(a: Sequence[int], b: Exponents) -> int:
    return sum(x * y for x, y in zip(a, b, strict=True))


def _kernel(rows: Sequence[Exponents]) -> list[list[int]]:
    """Integer vectors that span what all rows are orthogonal to."""
    n = len(rows[0])
    reduced, rank = fmpq_mat([[fmpq(v) for v in row] for row in rows]).rref()
    pivots = [next(c for c in range(n) if reduced[r, c]) for r in range(rank)]
    found = []
    for free in (c for c in range(n) if c not in pivots):
        vector = [fmpq(int(c == free)) for c in range(n)]
        for r, pivot in enumerate(pivots):
            vector[pivot] = -reduced[r, free]
        scale = lcm(*(int(value.q) for value in vector))
        found.append([int((value * scale).p) for value in vector])
    return found


def _signs(rows: Sequence[Exponents]) -> list[list[int]]:
    """Vectors of 0 and 1 that span what all rows are orthogonal to, modulo 2."""
    n = len(rows[0])
    reduced, rank = nmod_mat([[v % 2 for v in row] for row in rows], 2).rref()
    pivots = [next(c for c in range(n) if int(reduced[r, c])) for r in range(rank)]
    found = []
    for free in (c for c in range(n) if c not in pivots):
        vector = [int(c == free) for c in range(n)]
        for r, pivot in enumerate(pivots):
            vector[pivot] = int(reduced[r, free])
        found.append(vector)
    return found
