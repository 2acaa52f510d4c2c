"""Sixteen kinds of random scenes: what collapses, what ends, and what is hard to tell apart."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from math import isqrt
from random import Random

from verify.spheres.scene.scene import PAIRS, Coordinates, Scene

Vector = tuple[Fraction, ...]
Rows = tuple[Vector, Vector, Vector]


def between(rng: Random, low: str, high: str, digits: int = 6) -> Fraction:
    """A decimal in an interval."""
    a, b = Fraction(low), Fraction(high)
    return a + (b - a) * Fraction(rng.randint(0, 10**digits), 10**digits)


def towards(rng: Random, dimension: int, gap: str, side: str, spin: str) -> tuple[Rows, Rows]:
    """Particles 1 and 2 go towards 0 from two sides, from so far and so far beside it."""

    def beside(scale: str) -> Vector:
        return tuple(between(rng, f"-{scale}", scale) for _ in range(dimension - 1))

    zero = (Fraction(0),) * dimension
    positions = (
        zero,
        (1 + between(rng, "0", gap), *beside(side)),
        (-1 - between(rng, "0", gap), *beside(side)),
    )
    velocities = (
        (between(rng, "-0.5", "0.5"), *beside(spin)),
        (-between(rng, "0", "1"), *beside(spin)),
        (between(rng, "0", "1"), *beside(spin)),
    )
    return positions, velocities


def _near(dimension: int) -> Callable[[Random], Scene]:
    return lambda rng: Scene(
        between(rng, "0.005", "0.055"), *towards(rng, dimension, "0.01", "0.3", "0.2")
    )


def _far(dimension: int) -> Callable[[Random], Scene]:
    return lambda rng: Scene(
        between(rng, "0.005", "0.1"), *towards(rng, dimension, "3", "1", "0.2")
    )


def nearly_aligned(rng: Random) -> Scene:
    """Below the second threshold."""
    return Scene(between(rng, "0.01", "0.055"), *towards(rng, 2, "0.1", "0.03", "0.03"))


def between_thresholds(rng: Random) -> Scene:
    """Near a line, where a line itself collapses."""
    return Scene(between(rng, "0.057", "0.0717"), *towards(rng, 2, "0.1", "0.05", "0.05"))


def _numbers_on_a_line(rng: Random) -> tuple[Fraction, list[Fraction], list[Fraction]]:
    places = [Fraction(0), 1 + between(rng, "0", "2"), -1 - between(rng, "0", "2")]
    speeds = [between(rng, "-1", "1"), between(rng, "-1", "0.1"), between(rng, "-0.1", "1")]
    return between(rng, "0.01", "0.0717"), places, speeds


def on_an_axis(rng: Random) -> Scene:
    """In one dimension."""
    r, places, speeds = _numbers_on_a_line(rng)
    x, v = (((row[0],), (row[1],), (row[2],)) for row in (places, speeds))
    return Scene(r, x, v)


def along(direction: Sequence[Fraction], numbers: Sequence[Fraction], shift: Vector) -> Rows:
    """Numbers as points on a line."""
    first, second, third = (
        tuple(a * x + b for a, b in zip(direction, shift, strict=True)) for x in numbers
    )
    return first, second, third


def on_a_turned_line(rng: Random) -> Scene:
    """On a line whose direction is a rational unit vector, or one of another length."""
    r, places, speeds = _numbers_on_a_line(rng)
    t = between(rng, "-3", "3", 2)
    unit = ((1 - t * t) / (1 + t * t), 2 * t / (1 + t * t))
    shift, drift = ((between(rng, "-1", "1"), between(rng, "-1", "1")) for _ in range(2))
    return Scene(r, along(unit, places, shift), along(unit, speeds, drift))


def hardly_inelastic(rng: Random) -> Scene:
    """Above the first threshold."""
    return Scene(between(rng, "0.0718", "0.95"), *towards(rng, 2, "0.5", "0.5", "0.3"))


def tiny_restitution(rng: Random) -> Scene:
    """From 10^-3 to 10^-40."""
    r = Fraction(rng.randint(1, 9), 10 ** rng.randint(3, 40))
    return Scene(r, *towards(rng, 2, "0.3", "0.3", "0.2"))


def uneven_speeds(rng: Random) -> Scene:
    """One particle is up to a million times slower."""
    x, v = towards(rng, 2, "0.01", "0.2", "0.2")
    slow = Fraction(1, 10 ** rng.randint(1, 6))
    return Scene(between(rng, "0.01", "0.05"), x, (v[0], v[1], tuple(a * slow for a in v[2])))


def in_contact(rng: Random) -> Scene:
    """Particles 0 and 1 touch, and approach or part."""
    x, v = towards(rng, 2, "0.2", "0.3", "0.3")
    x = (x[0], (Fraction(1), Fraction(0)), x[2])
    v = (v[0], (between(rng, "-1", "1"), v[1][1]), v[2])
    return Scene(between(rng, "0.01", "0.06"), x, v)


def small_numbers(rng: Random) -> Scene:
    """Half integers, often with a symmetry: exact ties, grazes and contacts are frequent."""
    x = [tuple(Fraction(rng.randint(-8, 8), 2) for _ in range(2)) for _ in range(3)]
    v = [tuple(Fraction(rng.randint(-2, 2)) for _ in range(2)) for _ in range(3)]
    if rng.random() < 0.3:
        x[2], v[2] = ((-a, b) for a, b in (x[1], v[1]))
        x[0], v[0] = ((Fraction(0), row[0][1]) for row in (x, v))
    return Scene(Fraction(rng.choice(("0.01", "0.03", "0.05"))), tuple(x), tuple(v))


def in_five_dimensions(rng: Random) -> Scene:
    """Vectors with five coordinates."""
    return Scene(between(rng, "0.01", "0.055"), *towards(rng, 5, "0.05", "0.1", "0.1"))


def with_many_digits(rng: Random) -> Scene:
    """Numbers with 200 digits."""
    x, v = towards(rng, 2, "0.05", "0.1", "0.1")

    def longer(rows: Rows) -> Rows:
        one, two, three = (
            tuple(a + Fraction(rng.randint(0, 10**190), 10**200) for a in row) for row in rows
        )
        return one, two, three

    return Scene(between(rng, "0.01", "0.055", 200), longer(x), longer(v))


def at_an_angle(rng: Random) -> Scene:
    """Just after a collision of 0 and 1, with 2 near, at an angle about that of the threshold."""
    r = between(rng, "0.005", "0.05")
    limit = Fraction(isqrt(int(r * 10**24)), 10**12) * 4 / (1 + r)
    C = limit + (1 - limit) * between(rng, "-0.1", "0.9")
    t = Fraction(isqrt(int((1 + C) / (1 - C) * 10**16)), 10**8)
    c, s = (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)
    y = Fraction(1, 10 ** rng.randint(2, 30))
    reach = 1 + between(rng, "0.001", "0.01") * y * y
    x = ((Fraction(0), Fraction(0)), (Fraction(1), Fraction(0)), (reach * c, reach * s))
    v = ((Fraction(0), Fraction(0)), (y / 10, Fraction(1)), (-y * c - s, -y * s + c))
    return Scene(r, x, v)


#: The sixteen kinds by their names.
KINDS: dict[str, Callable[[Random], Scene]] = {
    "near-plane": _near(2),
    "near-space": _near(3),
    "far-plane": _far(2),
    "far-space": _far(3),
    "nearly-aligned": nearly_aligned,
    "between-thresholds": between_thresholds,
    "on-an-axis": on_an_axis,
    "on-a-turned-line": on_a_turned_line,
    "hardly-inelastic": hardly_inelastic,
    "tiny-restitution": tiny_restitution,
    "uneven-speeds": uneven_speeds,
    "in-contact": in_contact,
    "small-numbers": small_numbers,
    "five-dimensions": in_five_dimensions,
    "many-digits": with_many_digits,
    "at-an-angle": at_an_angle,
}
KINDS_ON_A_LINE = ("on-an-axis", "on-a-turned-line")


def random_scene_of(kind: str, rng: Random) -> Scene:
    """A scene of a kind in which no particles overlap."""
    while True:
        scene = KINDS[kind](rng)
        given = Coordinates(scene.positions, scene.velocities)
        if all(given.pair(i, j).g >= 0 for i, j in PAIRS):
            return scene
