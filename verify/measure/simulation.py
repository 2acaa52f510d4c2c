"""A plain simulation of scenes with mpmath: a second opinion, and what a verdict is timed against.

It has nothing in common with the flow that it is compared with: centres and velocities themselves,
the smallest root of each pair's quadratic equation, many digits, and no enclosures.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

import mpmath

from verify.language.record import Record
from verify.spheres.scene.scene import PAIRS, Scene

DIGITS = 400


class Impact(Record):
    """A pair, the time, and the centres then."""

    pair: str
    time: Any
    positions: list[list[Any]]


def simulate(scene: Scene, most: int, digits: int = DIGITS) -> list[Impact]:
    """The first collisions of a scene, computed with so many digits and without proof."""
    with mpmath.workdps(digits):
        number = mpmath.mpf
        x = [[number(a.numerator) / a.denominator for a in row] for row in scene.positions]
        v = [[number(a.numerator) / a.denominator for a in row] for row in scene.velocities]
        masses, radii = (
            [number(a.numerator) / a.denominator for a in row] for row in _bodies(scene)
        )
        found: list[Impact] = []
        time, last = number(0), None
        while len(found) < most:
            meetings = [
                (t, pair) for pair in PAIRS if (t := _meeting(x, v, pair, last, radii)) is not None
            ]
            if not meetings:
                break
            t, (i, j) = min(meetings)
            x = [[a + t * b for a, b in zip(p, w, strict=True)] for p, w in zip(x, v, strict=True)]
            e, w = _minus(x[j], x[i]), _minus(v[j], v[i])
            given = scene.r if scene.restitutions is None else scene.restitutions[i + j - 1]
            r = number(given.numerator) / given.denominator
            push = (1 + r) / (masses[i] + masses[j]) * _dot(e, w) / _dot(e, e)
            v[i] = [a + push * masses[j] * b for a, b in zip(v[i], e, strict=True)]
            v[j] = [a - push * masses[i] * b for a, b in zip(v[j], e, strict=True)]
            time, last = time + t, (i, j)
            found.append(Impact(f"{i}{j}", time, x))
        return found


def _bodies(scene: Scene) -> tuple[Sequence[Fraction], Sequence[Fraction]]:
    """Masses and radii."""
    if scene.bodies is None:
        return (Fraction(1),) * 3, (Fraction(1, 2),) * 3
    return scene.bodies.masses, scene.bodies.radii


def _meeting(
    x: list[list[Any]],
    v: list[list[Any]],
    pair: tuple[int, int],
    last: object,
    radii: Sequence[Any],
) -> Any | None:
    """The time until a pair is in contact; None if it does not meet."""
    i, j = pair
    e, w = _minus(x[j], x[i]), _minus(v[j], v[i])
    a, b, c = _dot(w, w), _dot(e, w), _dot(e, e) - (radii[i] + radii[j]) ** 2
    if pair == last or b >= 0 or b * b < a * c:
        return None
    return c / (-b + mpmath.sqrt(b * b - a * c))


def _minus(x: Sequence[Any], z: Sequence[Any]) -> list[Any]:
    return [a - b for a, b in zip(x, z, strict=True)]


def _dot(x: Sequence[Any], z: Sequence[Any]) -> Any:
    return sum(a * b for a, b in zip(x, z, strict=True))
