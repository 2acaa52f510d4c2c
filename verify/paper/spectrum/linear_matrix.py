"""Section 4.1: the 2x2 matrix of the nearly-linear collapse and the printed rate of convergence.

C is the cosine of the limiting angle; the trace of the matrix is -(1+r)/2 C.
"""

from __future__ import annotations

from collections.abc import Iterator

from verify.language.statement import Obligation
from verify.language.terms import as_term, equal, maximum
from verify.paper.rows import BREAKS
from verify.paper.spectrum.characteristic import lam
from verify.paper.spectrum.matrices import Matrix, apply, determinant, dot, identity_minus, vector
from verify.paper.spectrum.printed import r
from verify.paper.spectrum.section import LINEAR, Section, symbols

LAW = "EQUATSS3.4EvoluVNormLinea"
LIMIT = "EQUATSS3.4MatriLimitLinea"
RATE = "PROPOSS3.4CLineConveNorma"

C, s, k, d, alpha = symbols("C s k d alpha")

#: `EQUATSS3.4MatriLimitLinea`.
A: Matrix = (vector(0, -r), vector(1, -((1 + r) / 2 * C)))
trace = -((1 + r) / 2 * C)
_square = trace**2 - 4 * r

_section = Section("nearly-linear matrix")
needed, misprint = _section.needed, _section.misprint


def rows() -> Iterator[Obligation]:
    """Yield the rows on the matrix, its eigenvalues and the rate."""
    yield from _matrix()
    yield from _real_eigenvalues()
    yield from _complex_eigenvalues()
    yield from _rate()


def _matrix() -> Iterator[Obligation]:
    eta_s, eta_c = symbols("eta_s eta_c")
    u = symbols("u_1 u_2")
    # The colliding particle becomes the spectator, and the other way round.
    spectator = eta_c - (1 + r) * eta_c
    colliding = eta_s - (1 + r) / 2 * eta_c * C
    yield from (
        needed("linear-law",                  LAW, "the limiting law: (η_s, η_c) becomes η_c - "
            "(1+r)η_c and η_s - (1+r)/2 η_c cos θ (weighted by u)",
            equal(dot(u, apply(A, (eta_s, eta_c))), u[0] * spectator + u[1] * colliding),
            ["collision-law"]),
        needed("linear-determinant",          LIMIT, "det A = r", equal(determinant(A), r)),
        needed("linear-determinant-positive", RATE, "det A = r > 0", 0 < r),
        needed("linear-characteristic",       LIMIT, "det(λI - A) = λ² - Tr(A) λ + det A",
            equal(determinant(identity_minus(lam, A)), lam**2 - trace * lam + r)),
    )  # fmt: skip


def _real_eigenvalues() -> Iterator[Obligation]:
    for name, sign, value in (("plus", "+", (trace + d) / 2), ("minus", "-", (trace - d) / 2)):
        yield needed(f"linear-real-{name}", RATE,
            f"real case: (Tr {sign} d)/2 is an eigenvalue if d² = Tr²-4det",
            equal(value**2 - trace * value + r, (d**2 - _square) / 4))  # fmt: skip
    yield from (
        needed("linear-real-bound",  RATE,
            "real case: √(Tr²-4det) < |Tr|, because the difference of the squares is 4r",
            equal(trace**2 - _square, 4 * r), ["signs"]),
        needed("linear-real-sign",   RATE, "4r > 0", 0 < 4 * r, ["signs"]),
        needed("linear-trace-bound", RATE, "|Tr(A)| ≤ (1+r)/2 < 1, as |cos θ| ≤ 1",
            (1 + r) / 2 < as_term(1), ["signs"]),
    )  # fmt: skip


def _complex_eigenvalues() -> Iterator[Obligation]:
    yield from (
        needed("linear-complex-pair",    RATE,
            "complex case: det(λI - A) = (λ-Tr/2)² + (4det-Tr²)/4",
            equal(lam**2 - trace * lam + r, (lam - trace / 2) ** 2 + (4 * r - trace**2) / 4)),
        needed("linear-complex-modulus", RATE, "complex case: |λ±|² = (Tr²+4det-Tr²)/4 = r",
            equal((trace**2 + 4 * r - trace**2) / 4, r)),
        needed("linear-complex-bound",   RATE, "complex case: r < 1", r < as_term(1)),
    )  # fmt: skip


def _rate() -> Iterator[Obligation]:
    uses = ["spectral-radius"]
    yield needed("rate-real", RATE, "real case: the spectral radius (α+d)/2, α = |Tr|, d = "
        "√(Tr²-4det), is α minus (α-d)/2, which is positive (linear-real-bound); so the printed "
        "rate holds", equal((alpha + d) / 2, alpha - (alpha - d) / 2), uses)  # fmt: skip
    # Complex case: |Tr| = 2 s k with s = sqrt(r), k < 1; -cos(theta) = 4sk/(1+s^2).
    yield misprint("rate-complex-stated", RATE,
                   "complex case: the spectral radius √r is at most max((1+r)/2 |cos θ|, r), the "
                   "printed rate, where s = √r and |cos θ| = 4sk/(1+s²)",
                   s <= maximum((1 + s**2) / 2 * (4 * s * k / (1 + s**2)), s**2), severity=BREAKS,
                   corrected_by="rate-complex", within=LINEAR)  # fmt: skip
    y = symbols("y")[0]
    yield from (
        needed("rate-complex-cosine", RATE, "these angles exist: 4sk/(1+s²) ≤ 1 for k ≤ 1/2",
            2 * s <= 1 + s**2),
        needed("rate-complex",        RATE, "complex case: the square of the spectral radius is "
            "r, so the rate is √r, and max((1+r)/2 |cos θ|, √r) is a rate in both cases; where "
            "the first Zhou-Kadanoff condition holds this case does not occur (existence-real)",
            equal((trace / 2) ** 2 + (4 * r - trace**2) / 4, r), uses),
        needed("rate-complex-worse",  RATE, "r < √r: written s² < s, s = √r", s**2 < s),
        needed("rate-existence",      "EQUATSS3.4ZKCl1CondiExist", "y + r/y ≥ 2√r for y > 0, "
            "times y, s = √r: in a nearly-linear collapse y_{n+1} ≤ α - r/y_n with y_n > 0, which "
            "is impossible for ever if α < 2√r", equal(y**2 + s**2 - 2 * s * y, (y - s) ** 2),
            ["zhou-kadanoff"], within=LINEAR),
    )  # fmt: skip
