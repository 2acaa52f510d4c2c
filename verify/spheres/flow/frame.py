"""Vectors as formal combinations of x_s, W_s, x_c, W_c: only their inner products are known."""

from __future__ import annotations

import operator
from functools import reduce

from verify.language.terms import Term, as_term
from verify.language.vectors import Combination, add, scale
from verify.spheres.flow.law import Number, State

BASIS = ("x_s", "W_s", "x_c", "W_c")


def vector(name: str) -> Combination:
    """One of the four."""
    return {name: as_term(1)}


x_s, W_s, x_c, W_c = map(vector, BASIS)


def moved(x: Combination, time: Number, w: Combination) -> Combination:
    """X + t w."""
    return add(x, scale(time, w))


def minus(x: Combination, z: Combination) -> Combination:
    """X - z."""
    return add(x, scale(-1, z))


class Frame:
    """The inner products of the four in a state."""

    def __init__(self, state: State) -> None:
        v = state.v
        self._gram: dict[tuple[str, str], Term] = {
            ("x_s", "x_s"): 1 + state.sig * v**2,
            ("x_c", "x_c"): 1 + state.eps * v**2,
            ("W_s", "W_s"): state.B,
            ("W_c", "W_c"): state.A,
            ("x_s", "x_c"): -state.C,
            ("x_s", "W_s"): state.rho * v,
            ("x_c", "W_c"): -(state.lam * v),
            ("x_s", "W_c"): state.a,
            ("W_s", "x_c"): state.b,
            ("W_s", "W_c"): state.w,
        }

    def gram(self, i: str, j: str) -> Term:
        """The inner product of two of the four."""
        found = self._gram.get((i, j))
        return self._gram[j, i] if found is None else found

    def dot(self, x: Combination, z: Combination) -> Term:
        """The inner product of two combinations."""
        pairs = ((i, j) for i in BASIS for j in BASIS if i in x and j in z)
        return reduce(operator.add, (x[i] * z[j] * self.gram(i, j) for i, j in pairs))

    def square(self, x: Combination) -> Term:
        """The squared length of a combination."""
        return self.dot(x, x)
