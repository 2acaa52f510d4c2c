"""Two derivations of the characteristic polynomial that share no code with the program."""

from __future__ import annotations

from fractions import Fraction

import sympy
from flint import fmpq, fmpq_mat, fmpq_poly

from tests.paper.spectrum.page import table, terms
from tests.paper.spectrum.test_rows import to_sympy

R, LAMBDA = sympy.symbols("r lambda", real=True)


def printed_q() -> list[sympy.Poly]:
    return [
        sympy.Poly(to_sympy(entry, {"r": R}), R) for entry in terms("r^3", "a_1(r)", "a_2(r)", "1")
    ]


def characteristic(matrix: sympy.Matrix) -> sympy.Expr:
    return sympy.expand((LAMBDA * sympy.eye(4) - matrix).det(method="berkowitz"))


def by_sympy() -> sympy.Poly:
    """From the definition, in the coordinates of the plane, by SymPy."""
    root = sympy.sqrt(3)
    half = (1 + R) / 2
    w_1, w_2 = sympy.Matrix([1, 0]), sympy.Matrix([sympy.Rational(1, 2), root / 2])
    w_3 = w_2 - w_1
    one, zero = sympy.eye(2), sympy.zeros(2, 2)
    p_1, p_2, p_3 = (w * w.T for w in (w_1, w_2, w_3))

    def block(a: object, b: object, c: object, d: object) -> sympy.Matrix:
        return sympy.Matrix(sympy.BlockMatrix([[a, b], [c, d]]).as_explicit())

    first = block(one - 2 * half * p_1, zero, -half * p_1, one)
    second = block(one, -half * p_2, zero, one - 2 * half * p_2)
    third = block(one - half * p_3, half * p_3, half * p_3, one - half * p_3)
    product = (third * second * first).applyfunc(sympy.expand)
    return sympy.Poly(characteristic(product), LAMBDA)


def by_flint(r: Fraction) -> fmpq_poly:
    """From the definition, in the basis (1, 0), (1/2, sqrt(3)/2) itself: rational, by FLINT."""
    gram = [[Fraction(1), Fraction(1, 2)], [Fraction(1, 2), Fraction(1)]]
    vectors = {1: (1, 0), 2: (0, 1), 3: (-1, 1)}

    def normal(i: int, w: list[Fraction]) -> Fraction:
        return sum((vectors[i][a] * gram[a][b] * w[b] for a in (0, 1) for b in (0, 1)), Fraction(0))

    def column(index: int) -> list[Fraction]:
        state = [Fraction(i == index) for i in range(4)]
        for kind in (1, 2, 3):
            w_1, w_2 = state[:2], state[2:]
            moved = [a - b for a, b in zip(w_1, w_2, strict=True)]
            g = normal(kind, {1: w_1, 2: w_2, 3: moved}[kind])
            k_1, k_2 = {1: (2, 1), 2: (1, 2), 3: (1, -1)}[kind]
            half = (1 + r) / 2 * g
            state = [w_1[a] - k_1 * half * vectors[kind][a] for a in (0, 1)] + [
                w_2[a] - k_2 * half * vectors[kind][a] for a in (0, 1)
            ]
        return state

    columns = [column(i) for i in range(4)]
    entries = [
        fmpq(columns[j][i].numerator, columns[j][i].denominator) for i in range(4) for j in range(4)
    ]
    return fmpq_mat(4, 4, entries).charpoly()


def test_sympy_derives_the_printed_polynomial() -> None:
    q = sum(a.as_expr() * LAMBDA**i for i, a in enumerate(printed_q()))
    assert sympy.expand(by_sympy().as_expr() - (LAMBDA - 1) * q) == 0


def test_flint_derives_the_same_polynomial() -> None:
    """Coefficients have degree at most 12 in r, so that 13 values of r determine them."""
    expected = by_sympy()
    for k in range(13):
        r = Fraction(k + 2, 17)
        at_r = [
            sympy.Rational(c.subs(R, sympy.Rational(r.numerator, r.denominator)))
            for c in reversed(expected.all_coeffs())
        ]
        assert list(by_flint(r)) == [fmpq(int(c.p), int(c.q)) for c in at_r]


def test_the_printed_matrix_has_it_too() -> None:
    matrix = sympy.Matrix([[to_sympy(entry, {"r": R}) for entry in row] for row in table("A(r)")])
    assert sympy.expand(characteristic(matrix) - by_sympy().as_expr()) == 0
