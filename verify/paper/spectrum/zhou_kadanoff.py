"""Section 4.2: the two conditions of Zhou and Kadanoff and their critical values.

In the first s is the square root of r, in the second its cube root; c is -cos(theta) and alpha is
(1+r)c/2.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from verify.language.statement import Obligation
from verify.language.terms import Number, Term, as_term, equal, sqrt
from verify.paper.spectrum.printed import r, root_3
from verify.paper.spectrum.section import SMALLER, Section, symbols

EXISTENCE = "EQUATSS3.4ZKCl1CondiExist"
STABILITY = "EQUATSS3.4ZKCl2CondiStabi"
TEXT = "SSSCT3.4.2LineaZhou-Kadan"

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
            ["signs"], within=SMALLER),
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
