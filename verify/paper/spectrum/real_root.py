"""The proof of `EQUATSS3.5Alim_ContrRacRL`: Q is strictly increasing, its values at -r and -r^3."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from verify.language.statement import Obligation
from verify.language.terms import Number, Term, as_term, equal, symbol
from verify.paper.spectrum.characteristic import lam
from verify.paper.spectrum.printed import THEOREM, Printed, r
from verify.paper.spectrum.section import ANY, SHIFTED, Section, symbols

REAL_ROOT = "EQUATSS3.5Alim_ContrRacRL"

lambda_c = (-(r**3) + 9 * r**2 - 171 * r + 11) / (6 * 32)

#: The first display of the value of Q' at lambda_c.
MINIMUM = (
    -(r**6) / 12288
    + 3 * r**5 / 2048
    - 141 * r**4 / 4096
    + 247 * r**3 / 3072
    + 1131 * r**2 / 4096
    + 339 * r / 2048
    + as_term(Fraction(71, 12288))
)

_quartic_in_r = 5 * r**4 - 76 * r**3 + 2142 * r**2 - 76 * r + 5

#: The discriminant of Q in closed form.
DISCRIMINANT = -27 * (r + 1) ** 8 * _quartic_in_r / 2**24

_section = Section("real root")
needed, printed = _section.needed, _section.printed


def q(s: Number) -> Term:
    """The function q of the proof."""
    s = as_term(s)
    return s**4 - 24 * s**3 + 528 * s**2 - 2880 * s + 2304


def q_prime(s: Number) -> Term:
    """Its first derivative."""
    s = as_term(s)
    return 4 * s**3 - 72 * s**2 + 1056 * s - 2880


def q_second(s: Number) -> Term:
    """Its second derivative, as displayed."""
    s = as_term(s)
    return 12 * s**2 - 6 * 24 * s + 2 * 528


def rows(paper: Printed) -> Iterator[Obligation]:
    """Yield the rows from the second derivative of Q to the bounds on lambda_0."""
    yield from _derivatives(paper)
    yield from _quartic()
    yield from _increasing(paper)
    yield from _values(paper)


def _derivatives(paper: Printed) -> Iterator[Obligation]:
    eps = symbol("epsilon")
    u = r + 1
    bracket = u**4 - 24 * u**3 + 528 * u**2 - 2880 * u + 2304
    yield from (
        needed("Q-derivatives",    THEOREM, "Q(λ+ε) = Q(λ) + ε Q'(λ) + ε² Q''(λ)/2 + ε³",
            equal(paper.q(lam + eps),
            paper.q(lam) + eps * paper.q_prime(lam) + eps**2 * paper.q_second(lam) / 2 + eps**3)),
        needed("lambda_c",         THEOREM, "Q'' is zero only at λ_c: Q''(λ) = 6(λ-λ_c)",
            equal(paper.q_second(lam), 6 * (lam - lambda_c))),
        needed("Q-prime-minimum",  THEOREM,
            "Q' is a convex parabola with minimum at λ_c: Q'(λ) = 3(λ-λ_c)² + Q'(λ_c)",
            equal(paper.q_prime(lam), 3 * (lam - lambda_c) ** 2 + paper.q_prime(lambda_c))),
        needed("Q-prime-expanded", THEOREM, "Q'(λ_c), the first displayed form",
            equal(paper.q_prime(lambda_c), MINIMUM)),
        needed("Q-prime-factored", THEOREM, "Q'(λ_c), the second displayed form",
            equal(paper.q_prime(lambda_c), -(u**2 / 12288) * bracket)),
    )  # fmt: skip


def _quartic() -> Iterator[Obligation]:
    s, eps = symbols("s epsilon")
    says = "q decreases up to some s₀ and increases from there: q' increases and changes sign"
    u = r + 1
    yield from (
        needed("q-derivatives",            THEOREM,
            "q(s+ε) = q(s) + ε q'(s) + ε² q''(s)/2 + ε³(4s-24) + ε⁴, with q'' as displayed",
            equal(q(s + eps),
            q(s) + eps * q_prime(s) + eps**2 * q_second(s) / 2 + eps**3 * (4 * s - 24) + eps**4),
            context=ANY),
        printed("q-discriminant",          THEOREM, "the discriminant of q'' is -29952",
            equal(as_term(6 * 24) ** 2 - as_term(4) * 12 * 2 * 528, -29952)),
        printed("q-discriminant-negative", THEOREM, "it is negative", as_term(-29952) < as_term(0)),
        printed("q-convex",                THEOREM, "so q'' is positive: q''(s) = 12(s-6)² + 624",
            equal(q_second(s), 12 * (s - 6) ** 2 + 624), context=ANY),
        printed("q-falls", THEOREM, f"{says}; q'(0) < 0", q_prime(0) < 0, ["monotone"]),
        printed("q-rises", THEOREM, f"{says}; q'(6) > 0", 0 < q_prime(6), ["monotone"]),
        needed("q-1",                      THEOREM, "q(1) = -71", equal(q(1), -71)),
        needed("q-2",                      THEOREM, "q(2) = -1520", equal(q(2), -1520)),
        needed("q-negative",               THEOREM, "q(s) < 0 for 1 < s < 2 (and at both ends)",
            q(s) < 0, context=SHIFTED),
        needed("q-negative-r",             THEOREM,
            "(r+1)⁴ - 24(r+1)³ + 528(r+1)² - 2880(r+1) + 2304 < 0",
            u**4 - 24 * u**3 + 528 * u**2 - 2880 * u + 2304 < 0),
    )  # fmt: skip


def _increasing(paper: Printed) -> Iterator[Obligation]:
    kappa = symbol("kappa")
    a_0, a_1, a_2, _ = paper.coefficients
    yield from (
        needed("Q-prime-positive",        THEOREM,
            "the minimum Q'(λ_c) of the derivative is positive", 0 < paper.q_prime(lambda_c)),
        needed("Q-increasing",            THEOREM,
            "Q is strictly increasing: Q(λ)-Q(κ) is λ-κ times a sum of two squares and Q'(λ_c)",
            equal(paper.q(lam) - paper.q(kappa), (lam - kappa) * (3
            * ((lam + kappa) / 2 - lambda_c) ** 2 + ((lam - kappa) / 2) ** 2
            + paper.q_prime(lambda_c))), ["signs"]),
        needed("Q-discriminant",          THEOREM,
            "the discriminant of Q is -27(r+1)⁸(5r⁴-76r³+2142r²-76r+5)/2²⁴", equal(a_2**2 * a_1**2
            - 4 * a_1**3 - 4 * a_2**3 * a_0 + 18 * a_2 * a_1 * a_0 - 27 * a_0**2, DISCRIMINANT),
            ["polynomials"]),
        needed("Q-discriminant-square",   THEOREM, "its quartic factor is a sum of two squares",
            equal(_quartic_in_r,
            5 * (r**2 - as_term(Fraction(38, 5)) * r + 1) ** 2 + as_term(Fraction(9216, 5)) * r**2),
            context=ANY),
        needed("Q-discriminant-negative", THEOREM,
            "the discriminant is negative: one real root and a genuine complex pair",
            DISCRIMINANT < as_term(0), ["polynomials"]),
    )  # fmt: skip


def _values(paper: Printed) -> Iterator[Obligation]:
    at_r, at_r3 = paper.q(-r), paper.q(-(r**3))
    bracket = r**4 + 2 * r**3 - 2 * r - 1
    uses = ["intermediate-value"]
    yield from (
        needed("Q-minus-r", REAL_ROOT, "Q(-r), the first display", equal(at_r, r * (bracket / 64))),
        printed("Q-minus-r-root",    REAL_ROOT,
            "r⁴+2r³-2r-1 vanishes at r = 1: it is r-1 times (r+1)³",
            equal(bracket, (r - 1) * (r + 1) ** 3), context=ANY),
        needed("Q-minus-r-factored", REAL_ROOT, "Q(-r), the factorised display",
            equal(at_r, r / 64 * (r - 1) * (r + 1) ** 3)),
        needed("Q-minus-r-negative", REAL_ROOT, "Q(-r) < 0, so -r < λ₀", at_r < as_term(0), uses),
    )  # fmt: skip
    bracket = -63 * r**6 - 9 * r**5 + 171 * r**4 - 171 * r**2 + 9 * r + 63
    factor = 7 * r**2 - 13 * r + 7
    yield from (
        needed("Q-minus-r3",          REAL_ROOT, "Q(-r³), the first display",
            equal(at_r3, r**3 / 64 * bracket)),
        printed("Q-minus-r3-root",    REAL_ROOT, "its bracket vanishes at r = 1 and at r = -1",
            equal(bracket, -9 * (r - 1) * (r + 1) ** 3 * factor), context=ANY),
        needed("Q-minus-r3-factored", REAL_ROOT, "Q(-r³), the factorised display",
            equal(at_r3, -(9 * r**3 / 64) * (r - 1) * (r + 1) ** 3 * factor)),
        printed("Q-minus-r3-square",  REAL_ROOT,
            "7r²-13r+7 is always positive: 7(r-13/14)² + 27/28",
            equal(factor, 7 * (r - as_term(Fraction(13, 14))) ** 2 + as_term(Fraction(27, 28))),
            context=ANY),
        needed("Q-minus-r3-positive", REAL_ROOT, "Q(-r³) > 0, so λ₀ < -r³", 0 < at_r3, uses),
        needed("order-1",             REAL_ROOT, "-1 < -r", -1 < -r),
        needed("order-2",             REAL_ROOT, "-r < -r³", -r < -(r**3)),
        needed("order-3",             REAL_ROOT, "-r³ < 0", -(r**3) < as_term(0)),
    )  # fmt: skip
