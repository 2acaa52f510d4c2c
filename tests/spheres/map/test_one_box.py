"""A scene, and a map of one box around it, have one verdict."""

from __future__ import annotations

import random
from fractions import Fraction

import pytest

from tests.spheres.scene import test_on_a_line
from tests.spheres.scene.random_scenes import random_scene
from verify.spheres.map.boxes import verdicts
from verify.spheres.map.planes import FamilyPlane
from verify.spheres.scene.decide import COLLAPSES, DISPERSES, FINITE, UNDECIDED, decide_scene
from verify.spheres.scene.scene import Coordinates, Scene

#: The letters of boxes that say no less than a verdict on a scene.
LETTERS = {COLLAPSES: "c", DISPERSES: "df", FINITE: "fd", UNDECIDED: "cdfu"}
WIDTH = Fraction(1, 10**12)


def one_box(scene: Scene) -> str:
    """The letter of the box in which the velocity of the particle 2 varies a little."""
    velocities = [list(row) for row in scene.velocities]
    speed, velocities[2][0] = velocities[2][0], "x"  # type: ignore[call-overload]
    side = (speed - WIDTH, speed + WIDTH)
    plane = FamilyPlane(scene.r, Coordinates(scene.positions, velocities), ("vx",), side)
    one, two = verdicts(plane, ["0", "1"]).letters
    assert one == two
    return one


def test_random_scenes() -> None:
    rng, seen = random.Random(2027), set()
    for _ in range(60):
        scene = random_scene(rng)
        verdict = decide_scene(scene).verdict
        assert one_box(scene) in LETTERS[verdict], scene
        seen.add(verdict)
    assert seen == {COLLAPSES, DISPERSES}


@pytest.mark.parametrize("text", ["1/100", "3/50", "7/100", "71/1000", "2/25"])
def test_random_scenes_on_a_line(text: str) -> None:
    rng, seen = random.Random(2028), set()
    for _ in range(60):
        scene, direction = test_on_a_line.random_scene(rng, Fraction(text))
        if direction != [1] or any(x == y for x, y in _neighbours(scene)):
            continue
        verdict = decide_scene(scene).verdict
        assert one_box(scene) in LETTERS[verdict], scene
        seen.add(verdict)
    assert (COLLAPSES in seen) == (text != "2/25")


def _neighbours(scene: Scene) -> list[tuple[Fraction, Fraction]]:
    """The velocities of pairs: two that are equal differ in every box."""
    (a,), (b,), (c,) = scene.velocities
    return [(a, c), (b, c)]
