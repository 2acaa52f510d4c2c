"""The saddle of the limiting map, against a Newton iteration with 60 digits and differences."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import mpmath
import pytest

from verify.spheres.map.planes import Phi
from verify.spheres.map.saddle import Saddle, saddle

ONE = Fraction(1)
PLANES = [
    Phi(Fraction(1, 100), ONE),
    Phi(Fraction(3, 100), ONE),
    Phi(Fraction(3, 100), Fraction(19, 20)),
    Phi(Fraction(1, 20), ONE),
    Phi(Fraction(1, 20), Fraction(97, 100)),
    Phi(Fraction(3, 100), ONE, tangential=(2 * ONE, -2 * ONE)),
]


def limit(plane: Phi, q: Any, k: Any) -> tuple[Any, Any]:
    """One collision of positions and velocities with a tiny -eta_c."""
    r, c, u = (
        mpmath.mpf(x.numerator) / x.denominator
        for x in (plane.r, plane.neg_cos, plane.tangential[0])
    )
    # The approaching sphere moves across at the speed u; it hits when its height has risen by k.
    root = mpmath.sqrt(1 - 2 * k * u**2)
    time = (1 - root) / u**2
    closing = (1 + r) / 2 * c * root - q - u**2 * time
    return r * root / closing, (q * time + u**2 * time**2 / 2) / closing**2


@pytest.mark.parametrize("plane", PLANES)
def test_it_is_a_fixed_point_with_these_multipliers(plane: Phi) -> None:
    found = saddle(plane)
    assert found is not None
    with mpmath.workdps(60):
        q, k = (mpmath.mpf(e[0].numerator) / e[0].denominator for e in (found.phi_1, found.phi_2))
        solved = mpmath.findroot(
            lambda x, y: [a - b for a, b in zip(limit(plane, x, y), (x, y), strict=True)], (q, k)
        )
        h = mpmath.mpf(10) ** -20
        slopes = mpmath.matrix(2)
        for j, step in enumerate(((h, 0), (0, h))):
            after, before = (limit(plane, q + s * step[0], k + s * step[1]) for s in (1, -1))
            for i in range(2):
                slopes[i, j] = (after[i] - before[i]) / (2 * h)
        stable, unstable = sorted(mpmath.eig(slopes, left=False, right=False), key=abs)
        for ends, value in zip(
            found, (*solved, mpmath.re(stable), mpmath.re(unstable)), strict=True
        ):
            low, high = (mpmath.mpf(e.numerator) / e.denominator for e in ends)
            assert low - mpmath.mpf(10) ** -30 <= value <= high + mpmath.mpf(10) ** -30
            assert 0 <= high - low < mpmath.mpf(10) ** -15


def test_none_where_there_is_no_saddle_or_no_limit() -> None:
    assert saddle(Phi(Fraction(1, 2), ONE)) is None
    assert saddle(Phi(Fraction(3, 100), ONE, tangential=(ONE, 2 * ONE))) is None


def test_the_unstable_multiplier_tends_to_1() -> None:
    """Where r is large and the angle is no straight one the border is hard to enclose."""
    near, nearer = (saddle(Phi(Fraction(1, 20), Fraction(c, 100))) for c in (100, 97))
    assert isinstance(near, Saddle)
    assert isinstance(nearer, Saddle)
    assert nearer.unstable[1] < Fraction("1.07") < near.unstable[0]
