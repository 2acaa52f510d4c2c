"""Scenes of different masses and radii that collapse by the theorem on three balls."""

from __future__ import annotations

from collections import Counter
from fractions import Fraction
from random import Random

import pytest

from tests.spheres.scene.agreement import contradictions
from verify.spheres.flow.collapse import THREE_BALLS
from verify.spheres.scene.decide import COLLAPSES, UNDECIDED, Budget, Fate, decide_scene
from verify.spheres.scene.scene import PAIRS, Bodies, Scene, coordinates
from verify.spheres.scene.verdict import central, told

ONE = Fraction(1)
#: What a simulation keeps, and how many collisions are followed.
DIGITS, FEW = 500, Budget(collisions=200)
#: Nearly in line; the bead between the two others is light, or small and light.
BEADS = {
    "light, r = 0.9": ("9/10", (ONE, Fraction(1, 1000), ONE), (Fraction(1, 2),) * 3),
    "light, r = 0.3": ("3/10", (ONE, Fraction(1, 100), ONE), (Fraction(1, 2),) * 3),
    "small, r = 0.8": ("4/5", (ONE, Fraction(27, 8000), ONE), (ONE, Fraction(3, 20), ONE)),
}


def bead(r: str, masses: tuple[Fraction, ...], radii: tuple[Fraction, ...]) -> Scene:
    """The middle ball is 1, in contact with none."""
    left, right = (radii[1] + radii[i] for i in (0, 2))
    aside, zero = Fraction(1, 1000), Fraction(0)
    places = ((-left - Fraction(1, 10), aside), (zero, zero), (right + Fraction(1, 5), zero))
    speeds = ((zero, zero), (Fraction(-1, 10), aside), (-ONE, zero))
    return Scene(Fraction(r), places, speeds, bodies=Bodies(masses, radii))


@pytest.mark.parametrize("name", BEADS)
def test_a_bead_between_two_heavy_balls(name: str) -> None:
    found = decide_scene(bead(*BEADS[name]))
    assert (found.verdict, found.name, central(found)) == (COLLAPSES, THREE_BALLS, 1)
    assert told(found).theorems == [THREE_BALLS]
    assert contradictions(found, DIGITS) == []


def test_digits_of_the_time_can_be_asked_for() -> None:
    found = decide_scene(bead(*BEADS["small, r = 0.8"]), Budget(digits=20))
    assert found.collapse is not None
    low, high = told(found).time or (Fraction(0), ONE)
    assert 0 < high - low <= low / 10**20
    assert contradictions(found, DIGITS) == []


def random_scene(rng: Random, *, heavy: bool) -> Scene:
    """Ball 0 between two others that come nearly along one line; they are in no contact."""

    def number(low: float, high: float) -> Fraction:
        return Fraction(low * (high / low) ** rng.random()).limit_denominator(10**6)

    dimension = rng.choice((2, 3))
    masses = (number(0.01, 10), number(0.01, 10), number(0.01, 10))
    masses = (masses[0] * 10, *masses[1:]) if heavy else masses
    radii = (number(0.1, 3), number(0.1, 3), number(0.1, 3))
    aside = [[number(1e-4, 0.05) * rng.choice((-1, 1)) for _ in range(dimension)] for _ in range(6)]
    along = (
        Fraction(0), radii[0] + radii[1] + number(0.01, 0.5), -radii[0] - radii[2] - number(1, 2),
    )  # fmt: skip
    rates = (Fraction(0), -number(0.5, 2), number(0.5, 2))
    rows = [(value, *rest[1:]) for value, rest in zip((*along, *rates), aside, strict=True)]
    return Scene(number(1e-3, 0.3), tuple(rows[:3]), tuple(rows[3:]), bodies=Bodies(masses, radii))


def scenes(seed: int, count: int, *, heavy: bool = False) -> list[Scene]:
    """So many scenes without overlap."""
    rng, found = Random(seed), []
    while len(found) < count:
        scene = random_scene(rng, heavy=heavy)
        given = coordinates(scene, Fraction)
        if all(given.pair(i, j).g > 0 for i, j in PAIRS):
            found.append(scene)
    return found


@pytest.mark.parametrize("part", range(4))
def test_random_scenes_nearly_in_line(part: int) -> None:
    """A simulation contradicts none, and few are undecided, with light and with heavy middles."""
    found = [decide_scene(one, FEW) for one in scenes(part, 60, heavy=part % 2 == 1)]
    kinds = Counter(one.verdict for one in found)
    assert [one for one in map(_wrong, found) if one] == []
    assert kinds[COLLAPSES] >= 5
    assert kinds[UNDECIDED] <= 1


def _wrong(found: Fate) -> list[str]:
    return contradictions(found, DIGITS)
