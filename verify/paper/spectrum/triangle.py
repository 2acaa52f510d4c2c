"""The collisions by their definition, and the limiting triangle, in any dimension.

A vector is given by its coefficients on omega_1, on omega_2 and on a unit vector e orthogonal to
both; inner products are the only thing used. In an equilateral triangle omega_1 . omega_2 = 1/2,
and omega_3 = omega_2 - omega_1.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction

from verify.language.terms import Term, as_term
from verify.paper.spectrum import matrices
from verify.paper.spectrum.matrices import (
    ZERO,
    Matrix,
    Vector,
    difference_of,
    product_of,
    sum_of,
    total,
    vector,
)
from verify.paper.spectrum.printed import r, root_3

Pair = tuple[Vector, Vector]
Collision = Callable[[Pair], Pair]

_HALF = as_term(Fraction(1, 2))
_GRAM = (vector(1, _HALF, 0), vector(_HALF, 1, 0), vector(0, 0, 1))

omega_1 = vector(1, 0, 0)
omega_2 = vector(0, 1, 0)
omega_3 = vector(-1, 1, 0)
e = vector(0, 0, 1)

#: The unit vector orthogonal to omega_1 with omega_1_perp . omega_2 > 0.
omega_1_perp = vector(-(root_3 / 3), 2 * root_3 / 3, 0)
#: The unit vector orthogonal to omega_2 with omega_2_perp . omega_1 > 0, as the text states it.
omega_2_perp_stated = vector(2 * root_3 / 3, -(root_3 / 3), 0)
#: The opposite one: omega_1_perp and this are omega_1, omega_2 turned by the same right angle.
omega_2_perp = vector(-(2 * root_3 / 3), root_3 / 3, 0)


def inner(u: Vector, v: Vector) -> Term:
    """The inner product u . v."""
    return total(
        product_of(_GRAM[i][j], product_of(u[i], v[j]))
        for i in range(3)
        for j in range(3)
        if ZERO not in (_GRAM[i][j], u[i], v[j])
    )


def _shifted(u: Vector, factor: Term, v: Vector) -> Vector:
    """The vector u - factor v."""
    return tuple(difference_of(a, product_of(factor, b)) for a, b in zip(u, v, strict=True))


def collision_a(state: Pair) -> Pair:
    """`EQUATSS3.5DefinMatrix_A_a`: 0 and 1 collide along omega_1."""
    w_1, w_2 = state
    normal = inner(w_1, omega_1)
    return (
        _shifted(w_1, product_of(1 + r, normal), omega_1),
        _shifted(w_2, product_of((1 + r) / 2, normal), omega_1),
    )


def collision_b(state: Pair) -> Pair:
    """`EQUATSS3.5DefinMatrix_A_b`: 0 and 2 collide along omega_2."""
    w_1, w_2 = state
    normal = inner(w_2, omega_2)
    return (
        _shifted(w_1, product_of((1 + r) / 2, normal), omega_2),
        _shifted(w_2, product_of(1 + r, normal), omega_2),
    )


def collision_c(state: Pair) -> Pair:
    """`EQUATSS3.5DefinMatrix_A_c`: 1 and 2 collide along omega_3."""
    w_1, w_2 = state
    normal = inner(_shifted(w_1, matrices.ONE, w_2), omega_3)
    return (
        _shifted(w_1, product_of((1 + r) / 2, normal), omega_3),
        _shifted(w_2, product_of(-((1 + r) / 2), normal), omega_3),
    )


def triple(state: Pair) -> Pair:
    """The three collisions, in the order 0-1, 0-2, 1-2."""
    return collision_c(collision_b(collision_a(state)))


_NOTHING = vector(0, 0, 0)


def basis(second_perp: Vector) -> tuple[Pair, ...]:
    """The basis (omega_1, 0), (omega_1_perp, 0), (0, omega_2), (0, second_perp) of F."""
    return (
        (omega_1, _NOTHING),
        (omega_1_perp, _NOTHING),
        (_NOTHING, omega_2),
        (_NOTHING, second_perp),
    )


def matrix_of(collision: Collision, orthonormal: Sequence[Pair]) -> Matrix:
    """The matrix of a linear map in an orthonormal basis."""
    columns = [collision(element) for element in orthonormal]
    return tuple(
        tuple(sum_of(inner(u_1, w_1), inner(u_2, w_2)) for w_1, w_2 in columns)
        for u_1, u_2 in orthonormal
    )
