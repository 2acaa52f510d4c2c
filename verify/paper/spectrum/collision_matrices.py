"""The matrices A_a, A_b, A_c and their product, rebuilt from the definition and as printed.

First stand the collisions by their definition, and the limiting triangle, in any dimension. A
vector is given by its coefficients on omega_1, on omega_2 and on a unit vector e orthogonal to
both; inner products are the only thing used. In an equilateral triangle omega_1 . omega_2 = 1/2,
and omega_3 = omega_2 - omega_1.

The text fixes the basis by omega_1_perp . omega_2 > 0 and omega_2_perp . omega_1 > 0. The printed
matrices belong to the opposite omega_2_perp.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction

from verify.language.statement import Obligation
from verify.language.terms import Claim, Term, as_term, equal
from verify.paper.rows import SLIP
from verify.paper.spectrum import matrices
from verify.paper.spectrum.matrices import (
    ZERO,
    Matrix,
    Vector,
    difference_of,
    dot,
    form,
    product,
    product_of,
    sum_of,
    total,
    vector,
)
from verify.paper.spectrum.printed import MATRIX_LABEL, THEOREM, Printed, r, root_3
from verify.paper.spectrum.section import ANY, Section, symbols

LAW_A = "EQUATSS3.5VitesColli_0-1_"
LAW_B = "EQUATSS3.5DefinMatrix_A_b"
LAW_C = "EQUATSS3.5DefinMatrix_A_c"
DEFINITION = "DEFINSS3.5MatriLimitVites"
SPACE_F = "EQUATSS3.5DefinSs-Ev__F__"
EIGENSPACE = "EQUATSS3.5Alim_EspPp_L=1_"

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


A_A: Matrix = (
    vector(-r, 0, 0, 0),
    vector(0, 1, 0, 0),
    vector(-((1 + r) / 4), 0, 1, 0),
    vector(root_3 * (1 + r) / 4, 0, 0, 1),
)
A_B: Matrix = (
    vector(1, 0, -((1 + r) / 4), 0),
    vector(0, 1, -(root_3 * (1 + r) / 4), 0),
    vector(0, 0, -r, 0),
    vector(0, 0, 0, 1),
)
A_C: Matrix = (
    vector((7 - r) / 8, root_3 * (1 + r) / 8, -((1 + r) / 8), -(root_3 * (1 + r) / 8)),
    vector(root_3 * (1 + r) / 8, (5 - 3 * r) / 8, root_3 * (1 + r) / 8, 3 * (1 + r) / 8),
    vector(-((1 + r) / 8), root_3 * (1 + r) / 8, (7 - r) / 8, -(root_3 * (1 + r) / 8)),
    vector(-(root_3 * (1 + r) / 8), 3 * (1 + r) / 8, -(root_3 * (1 + r) / 8), (5 - 3 * r) / 8),
)

#: Two matrices are equal if u A v is the same for all u and v.
ROW = symbols("u_1 u_2 u_3 u_4")
COLUMN = symbols("v_1 v_2 v_3 v_4")

#: The change of sign of the fourth coordinate.
_FLIP = vector(1, 1, 1, -1)

_section = Section("collision matrices")
needed, printed, misprint = _section.needed, _section.printed, _section.misprint


def rows(paper: Printed) -> Iterator[Obligation]:
    """Yield the rows up to the printed 4x4 matrix."""
    yield from _laws()
    yield from _triangle()
    yield from _spaces()
    yield from _printed_factors()
    yield from _product(paper)


def _laws() -> Iterator[Obligation]:
    v_0, v_1, v_2, w, g = symbols("v_0 v_1 v_2 w g")
    half = (1 + r) / 2 * g * w
    says = "post-collisional relative velocities, one coordinate, g = normal component"
    for name, label, after, before in (
        ("law-01-W1", LAW_A, (v_1 - half) - (v_0 + half), (v_1 - v_0) - (1 + r) * g * w),
        ("law-01-W2", LAW_A, v_2 - (v_0 + half), (v_2 - v_0) - half),
        ("law-02-W1", LAW_B, v_1 - (v_0 + half), (v_1 - v_0) - half),
        ("law-02-W2", LAW_B, (v_2 - half) - (v_0 + half), (v_2 - v_0) - (1 + r) * g * w),
        ("law-12-W1", LAW_C, (v_1 - half) - v_0, (v_1 - v_0) - half),
        ("law-12-W2", LAW_C, (v_2 + half) - v_0, (v_2 - v_0) + half),
    ):
        yield needed(name, label, says, equal(after, before), ["collision-law"])


def _triangle() -> Iterator[Obligation]:
    c = symbols("c")[0]
    yield needed("triangle", DEFINITION, "|ω₂-ω₁|² = 2 - 2c is 1 exactly if c = ω₁·ω₂ is 1/2",
        equal((2 - 2 * c) - 1, 2 * (as_term(1) / 2 - c)), context=ANY)  # fmt: skip
    for name, says, u, v, value in (
        ("unit-omega_3", "ω₃ = ω₂-ω₁ is a unit vector", omega_3, omega_3, 1),
        ("omega_1-omega_3", "2 ω₁·ω₃ = -1", omega_1, omega_3, -1),
        ("omega_2-omega_3", "2 ω₂·ω₃ = 1", omega_2, omega_3, 1),
        ("unit-perp_1", "ω₁⊥ is a unit vector", omega_1_perp, omega_1_perp, 1),
        ("unit-perp_2", "ω₂⊥ is a unit vector", omega_2_perp, omega_2_perp, 1),
        ("orthogonal-perp_1", "ω₁⊥ is orthogonal to ω₁", omega_1_perp, omega_1, 0),
        ("orthogonal-perp_2", "ω₂⊥ is orthogonal to ω₂", omega_2_perp, omega_2, 0),
    ):
        factor = as_term(2 if says.startswith("2") else 1)
        yield needed(name, DEFINITION, says, equal(product_of(factor, inner(u, v)), value))
    yield from (
        needed("orientation-1",        MATRIX_LABEL, "ω₁⊥·ω₂ > 0, as stated",
            0 < inner(omega_1_perp, omega_2)),
        needed("orientation-2-stated", MATRIX_LABEL,
            "the vector that the text calls ω₂⊥ has ω₂⊥·ω₁ > 0",
            0 < inner(omega_2_perp_stated, omega_1)),
        needed("orientation-2",        MATRIX_LABEL,
            "the ω₂⊥ of the printed matrices has ω₂⊥·ω₁ < 0",
            inner(omega_2_perp, omega_1) < 0),
    )  # fmt: skip


def _spaces() -> Iterator[Obligation]:
    p, q = symbols("p_1 p_2 p_3 p_4"), symbols("q_1 q_2")
    uses = ["any-dimension"]
    image = triple((vector(0, 0, q[0]), vector(0, 0, q[1])))
    weights = symbols("u_1 u_2 u_3 u_4 u_5 u_6")
    components = [component for vector_ in image for component in vector_]
    yield needed("identity-on-E", SPACE_F,
        "𝔄_∞ fixes (q₁e, q₂e) for every e orthogonal to ω₁ and ω₂ (components weighted by u)",
        equal(dot(weights, components), weights[2] * q[0] + weights[5] * q[1]), uses)  # fmt: skip
    image = triple((vector(p[0], p[1], q[0]), vector(p[2], p[3], q[1])))
    yield needed("F-invariant", THEOREM,
        "𝔄_∞ changes no component outside F, so that the image of F is contained in F",
        equal(sum_of(product_of(weights[0], image[0][2]), product_of(weights[1], image[1][2])),
        weights[0] * q[0] + weights[1] * q[1]), uses)  # fmt: skip


def _as_stated(letter: str, claim: Claim) -> Obligation:
    """Of the three matrices only A_b is the same in both bases."""
    name, says = (
        f"A_{letter}-stated",
        (
            f"the printed A_{letter}, in the basis as the text states it (ω₂⊥·ω₁ > 0): "
            "u A v = u A_printed v for all u, v"
        ),
    )
    if letter == "b":
        return printed(name, EIGENSPACE, says, claim)
    return misprint(name, EIGENSPACE, says, claim, severity=SLIP, corrected_by=f"A_{letter}")


def _printed_factors() -> Iterator[Obligation]:
    stated = basis(omega_2_perp_stated)
    right = basis(omega_2_perp)
    for letter, collision, matrix in (
        ("a", collision_a, A_A),
        ("b", collision_b, A_B),
        ("c", collision_c, A_C),
    ):
        printed = form(ROW, matrix, COLUMN)
        yield _as_stated(letter,
            equal(form(ROW, matrix_of(collision, stated), COLUMN), printed))  # fmt: skip
        yield needed(f"A_{letter}", EIGENSPACE, f"the printed A_{letter}, in the basis with "
            "ω₂⊥·ω₁ < 0: u A v = u A_printed v for all u, v",
            equal(form(ROW, matrix_of(collision, right), COLUMN), printed))  # fmt: skip


def _product(paper: Printed) -> Iterator[Obligation]:
    for i, row in enumerate(product(A_C, product(A_B, A_A)), 1):
        for j, entry in enumerate(row, 1):
            yield needed(f"entry-{i}-{j}", MATRIX_LABEL,
                f"entry ({i},{j}) of A_c A_b A_a is the printed one",
                equal(entry, paper.matrix[i - 1][j - 1]))  # fmt: skip
    stated = matrix_of(triple, basis(omega_2_perp_stated))
    right = matrix_of(triple, basis(omega_2_perp))
    printed = form(ROW, paper.matrix, COLUMN)
    yield from (
        misprint("matrix-stated", MATRIX_LABEL, "the printed matrix, in the basis as the text "
            "states it (ω₂⊥·ω₁ > 0): u 𝔄 v = u 𝔄_printed v for all u, v",
            equal(form(ROW, stated, COLUMN), printed), SLIP, "matrix"),
        needed("matrix",          MATRIX_LABEL, "the printed matrix is 𝔄_∞ on F, in the basis "
            "with ω₂⊥·ω₁ < 0: u 𝔄 v = u 𝔄_printed v for all u, v",
            equal(form(ROW, right, COLUMN), printed)),
        needed("matrix-flipped",  MATRIX_LABEL,
            "in the basis as the text states it the matrix is D 𝔄_printed D, D = diag(1,1,1,-1)",
            equal(form(ROW, stated, COLUMN), form(ROW, flipped(paper.matrix), COLUMN))),
    )  # fmt: skip


def flipped(matrix: Matrix) -> Matrix:
    """The matrix D A D, D = diag(1, 1, 1, -1): in the basis as the text states it."""
    return tuple(
        tuple(
            entry if entry == ZERO or a == b else -entry
            for entry, b in zip(row, _FLIP, strict=True)
        )
        for row, a in zip(matrix, _FLIP, strict=True)
    )
