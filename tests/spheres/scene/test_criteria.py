"""R², A and L² from inner products are those of the centre of mass."""

from __future__ import annotations

from fractions import Fraction
from random import Random

import pytest

from tests.spheres.scene.random_scenes import random_scene
from verify.spheres.flow.law import recentred, unnamed
from verify.spheres.scene.criteria import whole
from verify.spheres.scene.scene import Coordinates


def centred(rows: tuple[tuple[Fraction, ...], ...]) -> list[list[Fraction]]:
    middle = [sum(column) / 3 for column in zip(*rows, strict=True)]
    return [[a - b for a, b in zip(row, middle, strict=True)] for row in rows]


@pytest.mark.parametrize("seed", range(5))
def test_whole(seed: int) -> None:
    scene = random_scene(Random(seed))
    X, V = centred(scene.positions), centred(scene.velocities)
    squares = sum(a * a for row in X for a in row)
    A = sum(a * b for x, v in zip(X, V, strict=True) for a, b in zip(x, v, strict=True))
    n = range(scene.dimension)
    spins = [
        sum(x[i] * v[k] - x[k] * v[i] for x, v in zip(X, V, strict=True))
        for i in n
        for k in n
        if i < k
    ]
    state = Coordinates(scene.positions, scene.velocities).state((0, 1, 2), unnamed)
    expected = (squares, A, sum(spin**2 for spin in spins))
    assert whole(state) == expected
    assert whole(recentred(state)) == expected
