"""The prover of claims with variables: near misses, and what it refuses to decide."""

from __future__ import annotations

from fractions import Fraction

import pytest

from verify.prover.forall import decide_row
from verify.paper.spectrum.rows import Section, symbols
from verify.prover.polynomials import NotPolynomialError, bernstein, coefficients
from verify.prover.ground import PROVED, REFUTED, UNDECIDED
from verify.language.terms import Claim, as_term, equal, maximum, sqrt

x, y, r, k = symbols("x y r k")
TINY = Fraction(1, 10**30)
SECTION = Section("test")


def verdict(claim: Claim, **intervals: tuple[int | None, int | None]) -> tuple[str, str]:
    finding = decide_row(SECTION.needed("row", "label", "says", claim, **intervals))
    return finding.verdict, finding.method


@pytest.mark.parametrize(
    ("claim", "expected"),
    [
        (equal((x + y) ** 2, x**2 + 2 * x * y + y**2), (PROVED, "identity")),
        (equal((x + y) ** 2, x**2 + (2 + TINY) * x * y + y**2), (REFUTED, "witness")),
        (equal(sqrt(3) * x * sqrt(3), 3 * x), (PROVED, "identity")),
        (equal(sqrt(3) * x * sqrt(3), (3 + TINY) * x), (REFUTED, "witness")),
        (0 < r * (1 - r), (PROVED, "bernstein")),
        (0 < r * (1 - TINY - r), (UNDECIDED, "")),
        (0 < (2 * r - 1) ** 2 + TINY, (UNDECIDED, "")),
        (0 <= (2 * r - 1) ** 2 - Fraction(1, 100), (REFUTED, "witness")),
        (0 < (2 * r - 1) ** 2, (REFUTED, "witness")),
        (r**2 < r, (PROVED, "bernstein")),
        (r < r**2, (REFUTED, "witness")),
        (0 < 1 + r * k, (PROVED, "cuts")),
        (1 < 1 + r * k, (UNDECIDED, "")),
        (maximum(r, k) < as_term(Fraction(1, 2)), (REFUTED, "witness")),
    ],
)
def test_verdicts(claim: Claim, expected: tuple[str, str]) -> None:
    assert verdict(claim) == expected


@pytest.mark.parametrize(
    ("claim", "expected"),
    [
        (equal(as_term(2) * 3, 6), (PROVED, "exact")),
        (equal(as_term(2) * 3, 6 + TINY), (REFUTED, "exact")),
        (sqrt(3) < as_term(2), (PROVED, "interval")),
        (equal(sqrt(3) * sqrt(3), 3), (PROVED, "identity")),
        (sqrt(3) * sqrt(3) <= as_term(3), (PROVED, "identity")),
        (sqrt(3) * sqrt(3) < as_term(3), (UNDECIDED, "")),
        (equal(sqrt(3) * sqrt(3), 3 + TINY), (REFUTED, "interval")),
        (sqrt(as_term(-1)) < as_term(3), (UNDECIDED, "")),
    ],
)
def test_verdicts_without_variables(claim: Claim, expected: tuple[str, str]) -> None:
    assert verdict(claim) == expected


def test_the_interval_matters() -> None:
    assert verdict(r < as_term(1)) == (PROVED, "bernstein")
    assert verdict(r < as_term(1), r=(0, 2)) == (REFUTED, "witness")
    assert verdict(r < as_term(1), r=(None, 1)) == (UNDECIDED, "")


def test_an_interval_for_an_unknown_symbol_is_refused() -> None:
    with pytest.raises(ValueError, match="does not use"):
        SECTION.needed("row", "label", "says", 0 < r, x=(0, 1))


def test_bernstein_coefficients_are_those_of_the_polynomial() -> None:
    polynomial = coefficients(1 - 3 * r + 2 * r**3, "r")
    assert polynomial == [1, -3, 0, 2]
    low, high = Fraction(-1, 2), Fraction(3, 2)
    for degree in (3, 4, 7):
        values = bernstein(polynomial, low, high, degree)
        assert values[0] == sum(c * low**i for i, c in enumerate(polynomial))
        assert values[-1] == sum(c * high**i for i, c in enumerate(polynomial))
        # The mean of the coefficients is the mean of the polynomial.
        integral = sum(
            c * (high ** (i + 1) - low ** (i + 1)) / (i + 1) for i, c in enumerate(polynomial)
        )
        assert sum(values) / (degree + 1) == integral / (high - low)


@pytest.mark.parametrize("term", [1 / r, sqrt(r), x + r, sqrt(3) * r])
def test_what_is_no_polynomial(term: object) -> None:
    with pytest.raises(NotPolynomialError):
        coefficients(term, "r")  # type: ignore[arg-type]
