"""Slow: f at 200 points against orbits with 60 digits, and 10^5 orbits next to its enclosure."""

from __future__ import annotations

import random
from fractions import Fraction

import numpy as np
import pytest
from mpmath import mp, mpf
from numpy.typing import NDArray

from tests.spheres.test_separatrix import curve, goes_on, letters, samples
from verify.spheres.limit_map import Parameters

Numbers = NDArray[np.float64]
SAMPLES = samples(200, 2026)
#: Orbits for each sample: half of them below f, half above.
ORBITS = 500
#: Doubles are enough: at a distance of 1e-9 their errors grow as the distance does.
NEAR = 1e-9


@pytest.mark.parametrize(("parameters", "q"), SAMPLES)
def test_orbits_with_60_digits_part_at_the_enclosure(parameters: Parameters, q: Fraction) -> None:
    strip = curve(parameters).strip(q, 25)
    assert strip.reached
    with mp.workdps(60):
        below, above = (mpf(end.numerator) / end.denominator for end in (strip.low, strip.high))
        assert goes_on(parameters, q, below * (1 - mpf(10) ** -28), 10**6) is True
        assert goes_on(parameters, q, above * (1 + mpf(10) ** -28), 10**6) is False


def fates(parameters: Parameters, q: Numbers, u: Numbers) -> Numbers:
    """1 where the collisions end, -1 where u has become small, by the map in doubles."""
    r, a, rho = map(float, letters(parameters))
    first, found = u.copy(), np.zeros(len(u))
    for _ in range(50000):
        left = found == 0
        if not left.any():
            break
        p = a * (1 - u) - q - rho * u
        top = rho * u * (2 * q + rho * u)
        found[left & ((p <= 0) | (top >= p * p))] = 1
        p, h = np.where(found == 0, p, 1), np.where(found == 0, top, 0)
        h = h / (p * p)
        q, u, rho = r * (1 - u) / p, h / (1 + np.sqrt(1 - h)), 1 / rho
        found[(found == 0) & (u < first * 1e-6)] = -1
    return found


@pytest.mark.parametrize(("parameters", "q"), SAMPLES)
def test_orbits_next_to_the_enclosure(parameters: Parameters, q: Fraction) -> None:
    """Their distances are between 1e-9 and 1/10, in u, or in u and q."""
    strip = curve(parameters).strip(q, 14)
    chosen = random.Random(str((parameters, q)))
    for side, end in ((-1, strip.low), (1, strip.high)):
        count = ORBITS // 2
        away = np.array([NEAR * 10 ** chosen.uniform(0, 8) for _ in range(count)])
        away[0] = NEAR
        also = np.array([chosen.choice((0.0, chosen.random())) for _ in range(count)])
        u = float(end) * (1 + side * away)
        found = fates(parameters, float(q) * (1 + side * away * also), u)
        assert (found == side).all(), (parameters, q, side, away[found != side])
