"""Sections 4.1 and 4.2: the nearly-linear collapse, and the two conditions of Zhou and Kadanoff.

The 2x2 matrix of the nearly-linear collapse and the printed rate of convergence come first: C is
the cosine of the limiting angle; the trace of the matrix is -(1+r)/2 C. Then the conditions and
their critical values: in the first s is the square root of r, in the second its cube root; c is
-cos(theta) and alpha is (1+r)c/2.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from verify.language.statement import Applies, Obligation
from verify.language.terms import Number, Term, as_term, equal, maximum, sqrt
from verify.paper.rows import REMARK
from verify.paper.spectrum.characteristic import lam
from verify.paper.spectrum.matrices import Matrix, apply, determinant, dot, identity_minus, vector
from verify.paper.spectrum.printed import r, root_3
from verify.paper.spectrum.section import LINEAR, SMALLER, Section, symbols

EXISTENCE = "EQUATSS3.4ZKCl1CondiExist"
STABILITY = "EQUATSS3.4ZKCl2CondiStabi"
TEXT = "SSSCT3.4.2LineaZhou-Kadan"

LAW = "EQUATSS3.4EvoluVNormLinea"
LIMIT = "EQUATSS3.4MatriLimitLinea"
RATE = "PROPOSS3.4CLineConveNorma"

C, d, alpha = symbols("C d alpha")

#: `EQUATSS3.4MatriLimitLinea`.
A: Matrix = (vector(0, -r), vector(1, -((1 + r) / 2 * C)))
trace = -((1 + r) / 2 * C)
_square = trace**2 - 4 * r

linear = Section("nearly-linear matrix")
#: The row that applies theorem II of the classification, and the facts that show what its context
#: `final` gives: of √r, of 1+r, and of -cos of the angle.
CITED, PREMISES = "existence-cited", ("linear.s.low", "existence-size", "existence-below")


def linear_rows() -> Iterator[Obligation]:
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
        linear.needed("linear-law",                  LAW,
            "the limiting law: (η_s, η_c) becomes η_c - "
            "(1+r)η_c and η_s - (1+r)/2 η_c cos θ (weighted by u)",
            equal(dot(u, apply(A, (eta_s, eta_c))), u[0] * spectator + u[1] * colliding),
            ["collision-law"]),
        linear.needed("linear-determinant",          LIMIT, "det A = r", equal(determinant(A), r)),
        linear.needed("linear-determinant-positive", RATE, "det A = r > 0", 0 < r),
        linear.needed("linear-characteristic",       LIMIT, "det(λI - A) = λ² - Tr(A) λ + det A",
            equal(determinant(identity_minus(lam, A)), lam**2 - trace * lam + r)),
    )  # fmt: skip


def _real_eigenvalues() -> Iterator[Obligation]:
    for name, sign, value in (("plus", "+", (trace + d) / 2), ("minus", "-", (trace - d) / 2)):
        yield linear.needed(f"linear-real-{name}", RATE,
            f"real case: (Tr {sign} d)/2 is an eigenvalue if d² = Tr²-4det",
            equal(value**2 - trace * value + r, (d**2 - _square) / 4))  # fmt: skip
    yield from (
        linear.needed("linear-real-bound",  RATE,
            "real case: √(Tr²-4det) < |Tr|, because the difference of the squares is 4r",
            equal(trace**2 - _square, 4 * r), ["signs"]),
        linear.needed("linear-real-sign",   RATE, "4r > 0", 0 < 4 * r, ["signs"]),
        linear.needed("linear-trace-bound", RATE, "|Tr(A)| ≤ (1+r)/2 < 1, as |cos θ| ≤ 1",
            (1 + r) / 2 < as_term(1), ["signs"]),
    )  # fmt: skip


def _complex_eigenvalues() -> Iterator[Obligation]:
    yield from (
        linear.needed("linear-complex-pair",    RATE,
            "complex case: det(λI - A) = (λ-Tr/2)² + (4det-Tr²)/4",
            equal(lam**2 - trace * lam + r, (lam - trace / 2) ** 2 + (4 * r - trace**2) / 4)),
        linear.needed("linear-complex-modulus", RATE, "complex case: |λ±|² = (Tr²+4det-Tr²)/4 = r",
            equal((trace**2 + 4 * r - trace**2) / 4, r)),
        linear.needed("linear-complex-bound",   RATE, "complex case: r < 1", r < as_term(1)),
    )  # fmt: skip


def _rate() -> Iterator[Obligation]:
    uses = ["spectral-radius"]
    yield linear.needed("rate-real", RATE, "real case: the spectral radius (α+d)/2, α = |Tr|, d = "
        "√(Tr²-4det), is α minus (α-d)/2, which is positive (linear-real-bound); so the printed "
        "rate holds", equal((alpha + d) / 2, alpha - (alpha - d) / 2), uses)  # fmt: skip
    # Complex case: |Tr| = 2 s k with s = sqrt(r), k < 1; -cos(theta) = 4sk/(1+s^2).
    yield linear.misprint("rate-complex-stated", RATE,
                   "complex case, in which no collapse is (existence-cited): the spectral "
                   "radius √r is at most max((1+r)/2 |cos θ|, r), the printed rate, where s = √r "
                   "and |cos θ| = 4sk/(1+s²)",
                   s <= maximum((1 + s**2) / 2 * (4 * s * k / (1 + s**2)), s**2), severity=REMARK,
                   corrected_by="rate-complex", context=LINEAR)  # fmt: skip
    y = symbols("y")[0]
    yield from (
        linear.needed("rate-complex-cosine", RATE, "these angles exist: 4sk/(1+s²) ≤ 1 for k ≤ 1/2",
            2 * s <= 1 + s**2),
        linear.needed("rate-complex",        RATE,
            "complex case: the square of the spectral radius is "
            "r, so the rate is √r, and max((1+r)/2 |cos θ|, √r) is a rate in both cases; where "
            "the first Zhou-Kadanoff condition holds this case does not occur (existence-real)",
            equal((trace / 2) ** 2 + (4 * r - trace**2) / 4, r), uses),
        linear.needed("rate-complex-worse",  RATE, "r < √r: written s² < s, s = √r", s**2 < s),
        linear.needed("rate-existence",      "EQUATSS3.4ZKCl1CondiExist",
            "y + r/y ≥ 2√r for y > 0, "
            "times y, s = √r: in a nearly-linear collapse y_{n+1} ≤ α - r/y_n with y_n > 0, which "
            "is impossible for ever if α < 2√r", equal(y**2 + s**2 - 2 * s * y, (y - s) ** 2),
            ["zhou-kadanoff"], context=LINEAR),
        linear.needed("existence-size",      EXISTENCE, "1+r > 0, r = s²", 0 < 1 + s**2,
            context=LINEAR),
        linear.needed("existence-below",     EXISTENCE,
            "4√r k/(1+r) is below 4√r/(1+r), as k < 1/2, s = √r",
            4 * s * k / (1 + s**2) < 4 * s / (1 + s**2), context=LINEAR),
        linear.needed(CITED,                 EXISTENCE,
            "for -cos θ = 4√r k/(1+r) with k < 1/2, s = √r, theorem II of the classification "
            "applies: no nearly-linear collapse has this final angle",
            Applies("classification:final", {"final.s": s, "final.C": 4 * s * k / (1 + s**2)}),
            ["zhou-kadanoff"], context=LINEAR),
    )  # fmt: skip


s, k, c = symbols("s k c")
root_5 = sqrt(5)

r_exist = 7 - 4 * root_3
r_stabi = 9 - 4 * root_5
#: The cube root of r_stabi.
critical = (3 - root_5) / 2

_section = Section("Zhou-Kadanoff")
needed, printed = _section.needed, _section.printed


def threshold(s: Number) -> Term:
    """2 r^(1/3) (1 + r^(1/3)) / (1 + r), s = r^(1/3)."""
    s = as_term(s)
    return 2 * s * (1 + s) / (1 + s**3)


def rows() -> Iterator[Obligation]:
    """Yield the rows on existence, on stability and on the two critical values."""
    yield from _existence()
    yield from _critical_existence()
    yield from _stability()
    yield from _critical_stability()


def _existence() -> Iterator[Obligation]:
    alpha = (1 + s**2) / 2 * c
    yield from (
        needed("existence",              EXISTENCE,
            "-cos θ - 4√r/(1+r) is 2/(1+r) times α - 2√r, s = √r",
            equal(c - 4 * s / (1 + s**2), 2 / (1 + s**2) * (alpha - 2 * s)), ["signs"]),
        needed("existence-real",         EXISTENCE,
            "so for an obtuse angle it says that the eigenvalues are real: α²-4r = (α-2√r)(α+2√r)",
            equal(alpha**2 - 4 * s**2, (alpha - 2 * s) * (alpha + 2 * s)), ["signs"]),
        needed("existence-small-r",      TEXT,
            "4√r/(1+r) is 4√r minus this, so every obtuse angle is allowed once 4√r ≤ -cos θ",
            equal(4 * s / (1 + s**2), 4 * s - 4 * s**3 / (1 + s**2)), ["signs"]),
        needed("existence-small-r-sign", TEXT, "4 r^{3/2} > 0", 0 < 4 * s**3, ["signs"]),
    )  # fmt: skip


def _critical_existence() -> Iterator[Obligation]:
    yield from (
        needed("exist-square",     TEXT,
            "θ = π: 4√r ≤ 1+r is r²-14r+1 ≥ 0, the difference of the squares",
            equal((1 + r) ** 2 - 16 * r, r**2 - 14 * r + 1), ["signs"]),
        needed("exist-factors",    TEXT, "r²-14r+1 = (r-(7-4√3))(r-(7+4√3))",
            equal(r**2 - 14 * r + 1, (r - r_exist) * (r - (7 + 4 * root_3)))),
        needed("exist-other-root", TEXT,
            "the second factor is negative for r ≤ 1, so the condition is r ≤ r_exist",
            as_term(1) < 7 + 4 * root_3, ["signs"]),
    )  # fmt: skip
    yield from _decimal("r_exist", r_exist, "0.07179677")


def _decimal(name: str, value: Term, digits: str) -> Iterator[Obligation]:
    half_a_unit = Fraction(5, 10**9)
    says = f"{name} ≈ {digits}, within half a unit of the last digit"
    yield from (
        printed(f"{name}-above", TEXT, says, as_term(Fraction(digits) - half_a_unit) < value),
        printed(f"{name}-below", TEXT, says, value < as_term(Fraction(digits) + half_a_unit)),
    )  # fmt: skip


def _stability() -> Iterator[Obligation]:
    alpha = (1 + s**3) / 2 * c
    p, v = symbols("p v")
    yield from (
        needed("stability",                   STABILITY, "-cos θ - 2r^{1/3}(1+r^{1/3})/(1+r) is "
            "2/(1+r) times α - (r^{1/3}+r^{2/3}), s = r^{1/3}",
            equal(c - threshold(s), 2 / (1 + s**3) * (alpha - (s + s**2))), ["signs"]),
        needed("stability-eigenvalues",       STABILITY, "with the eigenvalues p and p²v³ it says "
            "that v < 1, the smaller one below p²: α - (r^{1/3}+r^{2/3}) = p(1-v)(1-pv²), r^{1/3} "
            "= pv", equal(p + p**2 * v**3 - (p * v + (p * v) ** 2), p * (1 - v) * (1 - p * v**2)),
            ["signs"], context=SMALLER),
        needed("stability-implies-existence", TEXT, "the second condition implies the first: "
            "r^{1/3}+r^{2/3} - 2√r is a square, s = r^{1/6}",
            equal(s**2 + s**4 - 2 * s**3, s**2 * (1 - s) ** 2), ["signs"]),
        needed("threshold",                   TEXT,
            "2s(1+s)/(1+s³) is 2s/(1-s+s²): 1-s+s² times 1+s is 1+s³",
            equal((1 + s) * (1 - s + s**2), 1 + s**3)),
        needed("threshold-denominator",       TEXT, "1-s+s² > 0", 0 < 1 - s + s**2, ["signs"]),
        needed("threshold-difference",        TEXT, "the function increases: its difference at s "
            "and k, times both denominators, is s-k times a positive number",
            equal(2 * s * (1 - k + k**2) - 2 * k * (1 - s + s**2),
            2 * (s - k) * ((1 - s) + s * (1 - k))), ["signs"]),
        needed("threshold-0",                 TEXT, "it is 0 at r = 0", equal(threshold(0), 0)),
        needed("threshold-1",                 TEXT, "it is 2 at r = 1", equal(threshold(1), 2)),
    )  # fmt: skip


def _critical_stability() -> Iterator[Obligation]:
    first = (27 - 27 * root_5 + 45 - 5 * root_5) / 8
    yield from (
        needed("stabi-equation",   TEXT, "the threshold is 1 where 1-s+s² = 2s, that is where "
            "this vanishes, and above 1 where it is negative",
            equal((1 - s + s**2) - 2 * s, s**2 - 3 * s + 1), ["signs"]),
        needed("stabi-factors",    TEXT, "s²-3s+1 = (s-(3-√5)/2)(s-(3+√5)/2)",
            equal(s**2 - 3 * s + 1, (s - critical) * (s - (3 + root_5) / 2))),
        needed("stabi-other-root", TEXT,
            "the second factor is negative for s ≤ 1: the critical value is unique in [0,1]",
            as_term(1) < (3 + root_5) / 2, ["signs"]),
        needed("stabi-above-0",    TEXT, "0 < (3-√5)/2", 0 < critical),
        needed("stabi-below-1",    TEXT, "(3-√5)/2 < 1", critical < as_term(1)),
        needed("stabi-cube",       TEXT, "r_stabi = ((3-√5)/2)³ = (27-27√5+45-5√5)/8",
            equal(critical**3, first)),
        needed("stabi-sum",        TEXT, "= (72-32√5)/8", equal(first, (72 - 32 * root_5) / 8)),
        needed("stabi-value",      TEXT, "= 9-4√5", equal((72 - 32 * root_5) / 8, r_stabi)),
    )  # fmt: skip
    yield from _decimal("r_stabi", r_stabi, "0.05572809")
    yield from (
        needed("stabi-polynomial",  TEXT, "r < r_stabi is r²-18r+1 > 0 for r < 1",
            equal(r**2 - 18 * r + 1, (r - r_stabi) * (r - (9 + 4 * root_5))), ["signs"]),
        needed("stabi-below-exist", TEXT, "r_stabi < r_exist", r_stabi < r_exist),
    )  # fmt: skip
