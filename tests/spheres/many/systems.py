"""Random systems: balls in free space, under gravity, between walls and in a box."""

from __future__ import annotations

from fractions import Fraction
from random import Random

from verify.spheres.many.system import System, Wall
from verify.spheres.scene.scene import Scene


def decimal(rng: Random, low: float, high: float) -> Fraction:
    return Fraction(rng.randint(round(low * 1000), round(high * 1000)), 1000)


def system_of(scene: Scene) -> System:
    """A scene of three as a system."""
    bodies = scene.bodies
    masses = (scene.mass,) * 3 if bodies is None else bodies.masses
    radii = (Fraction(1, 2),) * 3 if bodies is None else bodies.radii
    pairs = {(i, j): scene.restitution(i, j) for i, j in ((0, 1), (0, 2), (1, 2))}
    return System(scene.r, masses, radii, scene.positions, scene.velocities, restitutions=pairs)


def far_enough(system: System) -> bool:
    """Whether no ball of it overlaps another one, an image, or a wall."""
    for i in range(system.number):
        for wall in system.walls:
            above = sum(a * b for a, b in zip(wall.normal, system.positions[i], strict=True))
            if above - wall.level <= 2 * system.radii[i]:
                return False
        for j in range(i):
            x = [b - a for a, b in zip(system.positions[i], system.positions[j], strict=True)]
            if system.box:
                x = [min(abs(a), side - abs(a)) for a, side in zip(x, system.box, strict=True)]
            if sum(a * a for a in x) <= system.contact(i, j) ** 2:
                return False
    return True


def random_system(rng: Random, number: int, kind: str, r: Fraction | None = None) -> System:
    """Balls of different masses and radii, or all alike, in a room that gets full."""
    dimension = rng.choice((1, 2, 3)) if kind == "free" else rng.choice((2, 3))
    size = {1: 2.5 * number, 2: 2.2 * number**0.5 + 2, 3: 2.0 * number ** (1 / 3) + 2}[dimension]
    box = (Fraction(round(size * 100), 100),) * dimension if kind == "box" else ()
    gravity, walls = (), ()
    axes = [tuple(Fraction(int(k == axis)) for k in range(dimension)) for axis in range(dimension)]
    if kind == "walls":
        backs = [tuple(-a for a in axis) for axis in axes]
        own = decimal(rng, 0.1, 0.9)
        walls = (*(Wall(axis, Fraction(-1), own) for axis in axes),
                 *(Wall(back, Fraction(-round(size) - 1), own) for back in backs))  # fmt: skip
    if kind == "floor":
        gravity = (*(decimal(rng, -0.2, 0.2) for _ in axes[1:]), Fraction(-1))
        tilted = (*(decimal(rng, -0.1, 0.1) for _ in axes[1:]), Fraction(1))
        walls = (Wall(tilted, Fraction(-3), decimal(rng, 0.1, 0.9)),)
    r = rng.choice((decimal(rng, 0.01, 0.95), Fraction(1))) if r is None else r
    while True:
        masses = tuple(decimal(rng, 0.2, 3) for _ in range(number))
        radii = tuple(decimal(rng, 0.2, 0.5) for _ in range(number))
        positions = tuple(tuple(decimal(rng, 0, size) for _ in axes) for _ in range(number))
        velocities = tuple(
            tuple(decimal(rng, -1, 1) - (a - Fraction(round(size)) / 2) / 5 for a in x)
            for x in positions
        )
        found = System(r, masses, radii, positions, velocities, restitutions={(0, 1): r / 2},
                       gravity=gravity, walls=walls, box=box)  # fmt: skip
        if far_enough(found):
            return found
