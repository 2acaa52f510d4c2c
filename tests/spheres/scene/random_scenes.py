"""Random scenes: r in {0.01, 0.03, 0.05}, near contact and far, in the plane and in space."""

from __future__ import annotations

from fractions import Fraction
from random import Random

from verify.spheres.scene.scene import PAIRS, Coordinates, Scene


def random_scene(rng: Random) -> Scene:
    """Three particles, of which 1 and 2 go towards 0 from two sides, more or less."""
    while True:
        dimension, far = rng.choice((2, 3)), rng.choice((Fraction(1, 100), Fraction(1, 10), 1))

        def number(scale: Fraction | int, rng: Random = rng) -> Fraction:
            return Fraction(rng.randint(-1000, 1000), 1000) * scale

        def vector(
            first: Fraction | int, scale: Fraction | int, d: int = dimension
        ) -> tuple[Fraction, ...]:
            return (Fraction(first), *(number(scale) for _ in range(d - 1)))

        positions = (
            vector(0, 0),
            vector(1 + abs(number(far)), far),
            vector(-1 - abs(number(far)), far),
        )
        spin = rng.choice((Fraction(1, 10), Fraction(3, 10), 1))
        velocities = (
            vector(number(Fraction(1, 2)), spin),
            vector(-abs(number(1)), spin),
            vector(abs(number(1)), spin),
        )
        r = rng.choice((Fraction(1, 100), Fraction(3, 100), Fraction(5, 100)))
        scene = Scene(r, positions, velocities)
        if all(Coordinates(positions, velocities).pair(i, j).g >= 0 for i, j in PAIRS):
            return scene
