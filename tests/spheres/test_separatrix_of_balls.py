"""The separatrix of balls with any masses and radii: the full motion next to it; equal balls."""

from __future__ import annotations

import random
from fractions import Fraction

import pytest
from mpmath import mp, mpf

from tests.spheres.test_separatrix import bisected, curve
from verify.spheres.limit_map import Parameters, has_separatrix
from verify.spheres.scene.decide import COLLAPSES, decide_scene
from verify.spheres.scene.scene import Bodies, Scene

F = Fraction
#: The closing speed of the states that are followed, beside speeds near 1.
CLOSING = F(1, 10**7)


def drawn(seed: int) -> tuple[Parameters, Fraction]:
    """Balls with masses and radii decades apart that have a separatrix, and a q below it."""
    rng = random.Random(f"balls {seed}")
    while True:
        masses = tuple(F(rng.randint(1, 99), 10) * F(10) ** rng.randint(-2, 1) for _ in range(3))
        radii = tuple(F(rng.randint(1, 99), 10) * F(10) ** rng.randint(-1, 1) for _ in range(3))
        t = F(rng.randint(0, 30), 100)
        neg_cos = (1 - t * t) / (1 + t * t)
        ratio = F(rng.randint(1, 12), rng.randint(1, 12)) ** 2
        parameters = Parameters(F(rng.randint(1, 300), 1000), neg_cos, ratio, masses, radii)
        if has_separatrix(parameters):
            root = F(round(1000 * float(parameters.r) ** (1 / 3)), 1000)
            return parameters, F(rng.randint(0, 20), 100) * root


@pytest.mark.parametrize("seed", range(8))
def test_it_agrees_with_a_bisection(seed: int) -> None:
    parameters, q = drawn(seed)
    strip = curve(parameters).strip(q, 20)
    assert strip.reached
    with mp.workdps(60):
        low, high = bisected(parameters, q)
        assert mpf(strip.low.numerator) / strip.low.denominator <= high
        assert low <= mpf(strip.high.numerator) / strip.high.denominator


def state(parameters: Parameters, q: Fraction, u: Fraction) -> Scene:
    """Balls just after a contact of 0 and 1, by what the letters of the map stand for."""
    (m0, m1, m2), (r0, r1, r2) = parameters.masses, parameters.radii
    c, last, after = parameters.neg_cos, r0 + r1, r0 + r2
    t = F(mp.nstr(mp.sqrt((1 - mpf(float(c))) / (1 + mpf(float(c)))), 6)).limit_denominator(100)
    sine = 2 * t / (1 + t * t)
    assert (1 - t * t) / (1 + t * t) == c
    with mp.workdps(40):
        scale = m1 * (m0 + m2) / (m2 * (m0 + m1))
        root = mp.sqrt(mpf(scale.numerator) / scale.denominator)
        receding = F(str(mp.mpf(q.numerator) / q.denominator / root)) * CLOSING
        speed = F(str(mp.sqrt(mpf(parameters.ratio.numerator) / parameters.ratio.denominator)))
    gap = after * u * (2 - u) * CLOSING**2 / 2
    normal, side = (-c, sine), (-sine, -c)
    place = [(after + gap) * x for x in normal]
    moves = [side[i] - CLOSING * normal[i] for i in range(2)]
    return Scene(
        parameters.r,
        ((F(0), F(0)), (last, F(0)), tuple(place)),
        ((F(0), F(0)), (receding, speed), tuple(moves)),
        bodies=Bodies(parameters.masses, parameters.radii),
    )


@pytest.mark.parametrize("seed", range(12))
def test_the_full_motion_next_to_it(seed: int) -> None:
    """A little below the curve the balls collapse about ball 0; a little above it they do not."""
    parameters, q = drawn(seed)
    strip = curve(parameters).strip(q, 8)
    below, above = (
        decide_scene(state(parameters, q, u))
        for u in (strip.low * F(97, 100), strip.high * F(103, 100))
    )
    assert below.verdict == COLLAPSES
    assert above.verdict != COLLAPSES


def test_equal_balls_of_any_size() -> None:
    """Neither a common mass nor a common radius matters."""
    one = Parameters(F(3, 100), F(9, 10), F(2))
    other = one._replace(masses=(F(7),) * 3, radii=(F(1, 9),) * 3)
    assert not other.is_unlike
    assert curve(one).strip(F(1, 10), 12) == curve(other).strip(F(1, 10), 12)


def test_radii_matter_as_a_ratio_does() -> None:
    unlike = Parameters(F(3, 100), F(1), F(2), radii=(F(1), F(2), F(5)))
    strips = [curve(p).strip(F(1, 10), 12) for p in (unlike, Parameters(F(3, 100), F(1), F(4)))]
    assert strips[0] == strips[1]


def test_the_last_ball_and_the_next_one_are_not_exchanged() -> None:
    """With their masses exchanged the curve is another one, beyond what the motion allows."""
    first, *others = F(1), F(5), F(1, 2)
    right, wrong = (
        curve(Parameters(F(3, 100), F(1), F(1), (first, *masses))).strip(F(1, 10), 8)
        for masses in (others, others[::-1])
    )
    assert wrong.high < right.low * F(9, 10) or wrong.low > right.high * F(11, 10)
