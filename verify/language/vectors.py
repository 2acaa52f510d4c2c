"""Vectors as formal combinations of four, in any dimension: only inner products are known.

The four are omega_s, W_s, omega_c, W_c. Two are unit vectors; the other inner products are
variables of the state.
"""

from __future__ import annotations

from collections.abc import Mapping

from verify.language.record import Record
from verify.language.terms import Claim, Number, Term, as_term

BASIS = ("omega_s", "W_s", "omega_c", "W_c")
Combination = Mapping[str, Term]


class Frame(Record):
    """The numbers of a state: y = -eta_c, C = -cos theta, the other inner products, and d."""

    y: Term
    eta_s: Term
    C: Term
    a: Term
    b: Term
    A: Term
    B: Term
    w: Term
    d: Term

    def gram(self, i: str, j: str) -> Term:
        """The inner product of two of the four vectors."""
        if i == j:
            squares = {"W_s": self.B, "W_c": self.A}
            return squares.get(i, as_term(1))
        return {
            frozenset(("omega_s", "omega_c")): -self.C,
            frozenset(("omega_s", "W_s")): self.eta_s,
            frozenset(("omega_c", "W_c")): -self.y,
            frozenset(("omega_s", "W_c")): self.a,
            frozenset(("omega_c", "W_s")): self.b,
            frozenset(("W_s", "W_c")): self.w,
        }[frozenset((i, j))]

    def dot(self, x: Combination, z: Combination) -> Term:
        """The inner product of two combinations."""
        total: Term | None = None
        for i in BASIS:
            for j in BASIS:
                if i in x and j in z:
                    part = _times(_times(x[i], z[j]), self.gram(i, j))
                    total = part if total is None else total + part
        return as_term(0) if total is None else total

    def cauchy_schwarz(self, x: Combination, z: Combination) -> Claim:
        """(x.z)^2 <= |x|^2 |z|^2."""
        return self.dot(x, z) ** 2 <= self.dot(x, x) * self.dot(z, z)


def basis_vector(name: str) -> Combination:
    """One of the four vectors."""
    return {name: as_term(1)}


def scale(number: Number, x: Combination) -> Combination:
    """A multiple of a vector."""
    return {name: _times(as_term(number), value) for name, value in x.items()}


def add(x: Combination, z: Combination) -> Combination:
    """The sum of two vectors."""
    total = dict(x)
    for name, value in z.items():
        total[name] = total[name] + value if name in total else value
    return total


def _times(x: Term, z: Term) -> Term:
    one = as_term(1)
    return z if x is one else x if z is one else x * z


omega_s, W_s, omega_c, W_c = map(basis_vector, BASIS)
