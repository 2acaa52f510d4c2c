"""A scene, and a map of one box around it, have one verdict."""

from __future__ import annotations

import random
from fractions import Fraction
from typing import Any

import pytest

from tests.spheres.scene import test_on_a_line
from tests.spheres.scene.random_scenes import random_scene
from verify.check_map import Family, on_a_line
from verify.spheres.map.boxes import verdicts
from verify.spheres.map.planes import FamilyPlane, is_on_a_line, value_of
from verify.spheres.scene.decide import COLLAPSES, DISPERSES, FINITE, UNDECIDED, decide_scene
from verify.spheres.scene.scene import Coordinates, Scene, difference

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


@pytest.mark.parametrize("text", ["1/100", "3/50", "71/1000", "2/25"])
def test_random_scenes_on_a_turned_line(text: str) -> None:
    """The speed of the particle 2 along the line varies a little."""
    rng, seen = random.Random(2029), set()
    for _ in range(60):
        scene, direction = test_on_a_line.random_scene(rng, Fraction(text))
        if len(direction) < 2 or 0 in direction or len({*scene.velocities}) < 3:
            continue
        velocities: list[Any] = [*map(list, scene.velocities)]
        velocities[2] = [
            ("+", speed, ("*", "x", Fraction(part)))
            for speed, part in zip(velocities[2], direction, strict=True)
        ]
        given, side = Coordinates(scene.positions, velocities), (-WIDTH, WIDTH)
        plane = FamilyPlane(scene.r, given, ("s",), side)
        assert is_on_a_line(plane)
        (letter, _) = verdicts(plane, ["0", "1"]).letters
        verdict = decide_scene(scene).verdict
        assert letter in LETTERS[verdict], scene
        seen.add(verdict)
    assert (COLLAPSES in seen) == (text != "2/25")


def _term(rng: random.Random, depth: int = 2) -> Any:
    if not depth or rng.random() < 0.3:
        return rng.choice(("x", "y", Fraction(rng.randint(1, 3))))
    return (rng.choice("+-*/"), _term(rng, depth - 1), _term(rng, depth - 1))


def _on_line(rng: random.Random, factor: Fraction) -> list[list[Any]]:
    """Three points on the line through (1, 2) in the direction (3, factor)."""
    terms = [_term(rng) for _ in range(3)]
    return [[("+", Fraction(1), ("*", Fraction(3), t)), ("+", Fraction(2), ("*", t, factor))]
            for t in terms]  # fmt: skip


def test_program_and_checker_know_the_same_lines() -> None:
    rng, seen = random.Random(5), []
    for _ in range(300):
        factors = [Fraction(rng.choice((-4, -4, 0, 5))) for _ in range(2)]
        rows = [_on_line(rng, factor) for factor in factors]
        side = (Fraction(0), Fraction(1))
        plane = FamilyPlane(Fraction(1, 20), Coordinates(*rows), ("a", "b"), side, side)
        frozen = [tuple(map(tuple, part)) for part in rows]
        checked = Family(Fraction(1, 20), *frozen, ("a", "b"), side, side)
        assert is_on_a_line(plane) == on_a_line(checked), rows
        seen.append((is_on_a_line(plane), factors[0] == factors[1]))
        assert not seen[-1][0] or _is_straight(plane), rows
    assert {*seen} >= {(True, True), (False, False), (False, True)}


def _is_straight(plane: FamilyPlane) -> bool:
    """Whether all vectors are parallel at some points."""
    for x, y in ((Fraction(1, 7), Fraction(2, 3)), (Fraction(5, 11), Fraction(1, 13))):
        try:
            x_at, v_at = ([[value_of(cell, x, y, Fraction) for cell in row] for row in rows]
                          for rows in (plane.coordinates.x, plane.coordinates.v))  # fmt: skip
        except ZeroDivisionError:
            continue
        vectors = [difference(rows, 0, i) for rows in (x_at, v_at) for i in (1, 2)]
        if any(a[0] * b[1] != a[1] * b[0] for a in vectors for b in vectors):
            return False
    return True


def _neighbours(scene: Scene) -> list[tuple[Fraction, Fraction]]:
    """The velocities of pairs: two that are equal differ in every box."""
    (a,), (b,), (c,) = scene.velocities
    return [(a, c), (b, c)]
