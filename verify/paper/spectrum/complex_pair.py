"""The roots in closed form, hence the moduli, the multiplicities and the eigenspaces.

With m = (-lambda_0)^(1/3), which runs through ]0,1[ as r does,

    r = m (4m^2 - m + 1) / (m^2 - m + 4),  Q(lambda) = (lambda + m^3) ((lambda - x)^2 + w),

where x and w > 0 are rational functions of m. So everything about the roots, for every r, is a
claim about polynomials in m.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from verify.language.statement import Obligation
from verify.language.terms import as_term, equal, substitute, symbol
from verify.paper.rows import SLIP
from verify.paper.spectrum.characteristic import lam
from verify.paper.spectrum.collision_matrices import EIGENSPACE, ROW, flipped
from verify.paper.spectrum.matrices import Vector, apply, determinant, dot, identity_minus, vector
from verify.paper.spectrum.printed import THEOREM, Printed, h, r, root_3
from verify.paper.spectrum.real_root import DISCRIMINANT, REAL_ROOT
from verify.paper.spectrum.section import Section, symbols

COMPLEX_PAIR = "EQUATSS3.5Alim_ContrRacCx"

m = symbol("m")

numerator = 4 * m**2 - m + 1
denominator = m**2 - m + 4

#: r as a function of m.
r_of_m = m * numerator / denominator
#: The square of the modulus of a complex root of mu^3 + h mu^2 + h mu + r; its cube belongs to Q.
modulus = numerator / denominator
#: Minus the sum of the two complex roots of mu^3 + h mu^2 + h mu + r.
trace = (m**2 - 4 * m + 1) / denominator

#: The real part of the complex roots of Q.
real_part = trace * (3 * modulus - trace**2) / 2
_quartic = 5 * m**4 - 4 * m**3 + 18 * m**2 - 4 * m + 5
#: The square of their imaginary part.
imaginary_square = 27 * (m + 1) ** 4 * (m**2 - m + 1) ** 2 * _quartic / (4 * denominator**6)

#: The eigenspace of 1.
FIXED: Vector = vector(0, 1, 0, 1)

#: An eigenvector for lambda_0 = -m^3.
REAL_EIGENVECTOR: Vector = (
    as_term(1),
    -(root_3 * m * (m + 1) / denominator),
    (m**2 - 4 * m + 1) / denominator,
    root_3 * (m - 1) * (m + 1) / denominator,
)

_section = Section("roots")
needed, misprint = _section.needed, _section.misprint


def rows(paper: Printed) -> Iterator[Obligation]:
    """Yield the rows on the roots, their moduli, the multiplicities and the eigenvectors."""
    yield from _parametrisation()
    yield from _factorisation(paper)
    yield from _eigenspace(paper)
    yield from _eigenvectors(paper)


def _parametrisation() -> Iterator[Obligation]:
    n = symbol("n")
    uses = ["intermediate-value"]
    rising = m**2 * n**2 - m**2 * n + 4 * m**2 - m * n**2 + 4 * m * n - m + 4 * n**2 - n + 1
    other = substitute(denominator, {"m": n})
    yield from (
        needed("m-denominator", REAL_ROOT, "the denominator of r(m) is positive", 0 < denominator),
        needed("m-at-0",        REAL_ROOT, "r(0) = 0",
            equal(substitute(r_of_m, {"m": as_term(0)}), 0), uses),
        needed("m-at-1",        REAL_ROOT, "r(1) = 1",
            equal(substitute(r_of_m, {"m": as_term(1)}), 1), uses),
        needed("m-difference",  REAL_ROOT, "r(m) - r(n) is m - n times a quotient of polynomials",
            equal(r_of_m - substitute(r_of_m, {"m": n}),
            4 * (m - n) * rising / (denominator * other)), uses),
        needed("m-increasing",  REAL_ROOT, "its numerator is positive, so that r(m) increases",
            0 < rising, uses),
    )  # fmt: skip


def _factorisation(paper: Printed) -> Iterator[Obligation]:
    """Q in factors, the moduli of its roots, and the multiplicities."""
    every = ["every-r"]
    yield from (
        needed("Q-factorised",        COMPLEX_PAIR, "Q(λ) = (λ+m³)((λ-x)²+w) at r = r(m)",
            equal(paper.q(lam, r_of_m), (lam + m**3) * ((lam - real_part) ** 2 + imaginary_square)),
            every),
        needed("w-quartic", COMPLEX_PAIR, "w > 0, its factor of degree 4", 0 < _quartic, ["signs"]),
        needed("w-square", COMPLEX_PAIR, "w > 0, its squared factor", 0 < m**2 - m + 1, ["signs"]),
        needed("root-above-minus-r",  REAL_ROOT,
            "-r < λ₀ = -m³ at r = r(m), both sides times the denominator",
            m**3 * denominator < m * numerator, every),
        needed("root-below-minus-r3", REAL_ROOT,
            "λ₀ < -r³, that is r < m, at r = r(m), both sides times the denominator",
            m * numerator < m * denominator, every),
        needed("modulus",                 COMPLEX_PAIR,
            "|λ±|² = x² + w is the cube of a rational function of m",
            equal(real_part**2 + imaginary_square, modulus**3), every),
        needed("viete",                   COMPLEX_PAIR, "Viète: |λ₀| |λ±|² = r³",
            equal(m**3 * modulus**3, r_of_m**3), every),
        needed("modulus-below-1",         COMPLEX_PAIR,
            "|λ±|² = r³/|λ₀| < 1: its cube root r/m is smaller than 1, times the denominator",
            numerator < denominator, every),
        needed("modulus-above-real-root", COMPLEX_PAIR, "|λ±|²/|λ₀|² = r³/|λ₀|³ > 1: its cube "
            "root r/m³ exceeds 1, times m² and the denominator", m**2 * denominator < numerator,
            every),
        needed("real-root-nonzero",       COMPLEX_PAIR, "0 < |λ₀| = m³", 0 < m**3, every),
        needed("geometric-multiplicity", THEOREM, "the discriminant Q(1)² disc(Q) of the "
            "characteristic polynomial is not 0: four distinct eigenvalues, each of geometric "
            "multiplicity 1", (27 * (1 + r) ** 3 / 32) ** 2 * DISCRIMINANT < as_term(0),
            ["polynomials", "linear-algebra"]),
    )  # fmt: skip


def _eigenspace(paper: Printed) -> Iterator[Obligation]:
    uses = ["linear-algebra"]
    minor = tuple(row[:3] for row in identity_minus(as_term(1), paper.matrix)[:3])
    value = 27 * (1 + r) ** 3 / 64
    stated = flipped(paper.matrix)
    opposite = vector(0, 1, 0, -1)
    left = vector(1, root_3, -1, root_3)
    state = symbols("x y z t")
    yield from (
        needed("eigenspace",           EIGENSPACE,
            "𝔄 (0,1,0,1) = (0,1,0,1) in the basis with ω₂⊥·ω₁ < 0 (components weighted by u)",
            equal(dot(ROW, apply(paper.matrix, FIXED)), ROW[1] + ROW[3]), uses),
        needed("eigenspace-minor",     EIGENSPACE,
            "the minor of I - 𝔄 of the first three rows and columns is 27(1+r)³/64",
            equal(determinant(minor), value), uses),
        needed("eigenspace-dimension", EIGENSPACE,
            "it is not 0, so the eigenspace of 1 is the span of (0,1,0,1)", 0 < value, uses),
        misprint("eigenspace-stated",  EIGENSPACE,
            "(0,1,0,1) is fixed, in the basis as the text states it (ω₂⊥·ω₁ > 0)",
            equal(dot(ROW, apply(stated, FIXED)), ROW[1] + ROW[3]), SLIP, "eigenspace-flipped"),
        needed("eigenspace-flipped",   EIGENSPACE,
            "in the basis as the text states it, (0,1,0,-1) is fixed",
            equal(dot(ROW, apply(stated, opposite)), ROW[1] - ROW[3])),
        needed("angular-momentum",     THEOREM,
            "l = (1,√3,-1,√3) is a left eigenvector for 1: l 𝔄 v = l v for all v",
            equal(dot(left, apply(paper.matrix, state)), dot(left, state))),
    )  # fmt: skip


def _eigenvectors(paper: Printed) -> Iterator[Obligation]:
    mu = symbol("mu")
    cubic = mu**3 + h * mu**2 + h * mu + r
    z = mu + h
    half = as_term(Fraction(1, 2))
    rising = root_3 / 3 * (mu**2 + (h - half) * mu + (h - 1) / 2)
    middle = root_3 / 6 * (z - 1)
    eigenvector = (as_term(1), middle - rising, z, middle + rising)
    quotients = (
        as_term(-1),
        root_3 / 3 * mu * (mu - 1),
        -mu,
        -(root_3 / 3 * (mu - 1) * (mu + 1)),
    )
    for i, (image, entry, factor) in enumerate(
        zip(apply(paper.matrix, eigenvector), eigenvector, quotients, strict=True), 1
    ):
        yield needed(f"eigenvector-{i}", THEOREM, "an eigenvector for λ = μ³ where μ³+hμ²+hμ+r = "
            f"0, h = (1+r)/4: component {i} of 𝔄v - μ³v is a multiple of that cubic",
            equal(image - mu**3 * entry, cubic * factor))  # fmt: skip
    for i, (entry, value) in enumerate(zip(eigenvector, REAL_EIGENVECTOR, strict=True), 1):
        if i > 1:
            at_m = substitute(entry, {"r": r_of_m, "mu": -m})
            yield needed(f"eigenvector-real-{i}", THEOREM,
                f"component {i} of the eigenvector for λ₀ = -m³: μ = -m at r = r(m)",
                equal(at_m, value), ["every-r"])  # fmt: skip
    twentieth = as_term(Fraction(1, 20))
    root = as_term(Fraction(-1, 125))
    yield needed("exact-root", REAL_ROOT, "at r = 1/20 the real root is -1/125",
        equal(paper.q(root, twentieth), 0))  # fmt: skip
