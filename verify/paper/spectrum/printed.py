"""The displayed objects from which all rows are built: the matrix and the polynomial Q."""

from __future__ import annotations

from verify.language.record import Record
from verify.language.terms import Number, Term, as_term, sqrt, substitute, symbol
from verify.paper.spectrum.matrices import Matrix, Vector, product_of, vector

THEOREM = "THEORSS3.5SpectMatricVitLm"
MATRIX_LABEL = "EQUATSS3.5MatrixAlim_ResF"
Q_LABEL = "EQUATSS3.5Alim_DetaiPCarQ"

r = symbol("r")
root_3 = sqrt(3)

#: (1+r)/4: what a collision with normal velocity g takes from the two other pairs is this times g.
h = (1 + r) / 4

#: `EQUATSS3.5MatrixAlim_ResF`.
MATRIX: Matrix = (
    vector((-(r**3) + 5 * r**2 - 59 * r - 1) / 64, root_3 * (r + 1) / 8,
           (r**2 - 4 * r - 5) / 16, -(root_3 * (r + 1) / 8)),
    vector(root_3 * (r**3 + 3 * r**2 + 11 * r + 9) / 64, (5 - 3 * r) / 8,
           -(root_3 * (r**2 + 4 * r + 3) / 16), (3 * r + 3) / 8),
    vector((-(r**3) + 17 * r**2 + 13 * r - 5) / 64, root_3 * (r + 1) / 8,
           (r**2 - 16 * r - 1) / 16, -(root_3 * (r + 1) / 8)),
    vector(root_3 * (-(r**3) + r**2 + 13 * r + 11) / 64, (3 * r + 3) / 8,
           root_3 * (r**2 - 1) / 16, (5 - 3 * r) / 8),
)  # fmt: skip

#: The coefficients of `EQUATSS3.5Alim_DetaiPCarQ`, from the constant one to the leading one.
COEFFICIENTS: Vector = vector(
    r**3,
    (-11 * r**3 + 171 * r**2 - 9 * r + 1) / 64,
    (r**3 - 9 * r**2 + 171 * r - 11) / 64,
    1,
)


class Printed(Record):
    """What the paper displays as the result: every row takes the matrix and Q from here."""

    matrix: Matrix = MATRIX
    coefficients: Vector = COEFFICIENTS

    def q(self, x: Number, restitution: Term | None = None) -> Term:
        """Q at a point, where another term may stand for r."""
        x = as_term(x)
        a_0, a_1, a_2, a_3 = (
            coefficient if restitution is None else substitute(coefficient, {"r": restitution})
            for coefficient in self.coefficients
        )
        return product_of(a_3, x**3) + a_2 * x**2 + a_1 * x + a_0

    def q_prime(self, x: Number) -> Term:
        """The first derivative of Q in its argument."""
        x = as_term(x)
        _, a_1, a_2, a_3 = self.coefficients
        return product_of(a_3, 3 * x**2) + 2 * a_2 * x + a_1

    def q_second(self, x: Number) -> Term:
        """The second derivative of Q in its argument."""
        _, _, a_2, a_3 = self.coefficients
        return product_of(a_3, 6 * as_term(x)) + 2 * a_2
