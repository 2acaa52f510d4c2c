"""Where the spheres of a scene are: floats for drawings, which follow the certain collisions."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from itertools import islice

from verify.language.record import Record
from verify.prover import balls
from verify.views.scene import Step, Told

Vector = list[float]


class Leg(Record):
    """From a time on all spheres move straight; ``pair`` has just collided, if any."""

    time: float
    pair: str
    places: list[Vector]
    velocities: list[Vector]


def legs(told: Told, steps: Iterable[Step], most: int = 200) -> list[Leg]:
    """The flight after the start and after each collision, seen from the centre of mass."""
    scene, r = told.scene, float(told.scene.r)
    x = [[float(a) for a in row] for row in scene.positions]
    v = [[float(a) for a in row] for row in scene.velocities]
    x, v = _centred(x), _centred(v)
    path = [Leg(0.0, "", x, v)]
    with balls.precision(told.bits):
        for step in islice(steps, most):
            time = balls.as_float(step.time)
            x = [_moved(a, time - path[-1].time, b) for a, b in zip(x, v, strict=True)]
            v = _collided(x, v, step.hit, r)
            path.append(Leg(time, step.pair, x, v))
    return _in_plane(path)


def places_at(path: Sequence[Leg], time: float) -> list[Vector]:
    """The centres at a time."""
    leg = next((leg for leg in reversed(path) if leg.time <= time), path[0])
    pairs = zip(leg.places, leg.velocities, strict=True)
    return [_moved(x, time - leg.time, v) for x, v in pairs]


def _moved(x: Vector, time: float, v: Vector) -> Vector:
    return [a + time * b for a, b in zip(x, v, strict=True)]


def _centred(rows: list[Vector]) -> list[Vector]:
    middle = [sum(column) / 3 for column in zip(*rows, strict=True)]
    return [[a - b for a, b in zip(row, middle, strict=True)] for row in rows]


def _collided(x: list[Vector], v: list[Vector], pair: tuple[int, int], r: float) -> list[Vector]:
    i, j = pair
    e = [b - a for a, b in zip(x[i], x[j], strict=True)]
    length = math.sqrt(_dot(e, e)) or 1.0
    e = [a / length for a in e]
    push = (1 + r) / 2 * _dot(e, [b - a for a, b in zip(v[i], v[j], strict=True)])
    new = list(v)
    new[i], new[j] = _moved(v[i], push, e), _moved(v[j], -push, e)
    return new


def _dot(x: Vector, z: Vector) -> float:
    return sum(a * b for a, b in zip(x, z, strict=True))


def _in_plane(path: list[Leg]) -> list[Leg]:
    """The path projected to the plane of the three centres at its end."""
    first, second = _basis(path[-1].places)

    def flat(rows: list[Vector]) -> list[Vector]:
        return [[_dot(row, first), _dot(row, second)] for row in rows]

    return [Leg(leg.time, leg.pair, flat(leg.places), flat(leg.velocities)) for leg in path]


def _basis(x: list[Vector]) -> tuple[Vector, Vector]:
    """Two orthonormal vectors; in the plane they are the usual ones."""
    axes = [[float(i == k) for i in range(len(x[0]))] for k in range(len(x[0]))]
    if len(axes) == 2:
        return axes[0], axes[1]
    spans = [_moved(x[2], -1.0, x[1]), _moved(x[0], -1.0, x[1]), *axes]
    found: list[Vector] = []
    for span in spans:
        rest = list(span)
        for unit in found:
            rest = _moved(rest, -_dot(rest, unit), unit)
        length = math.sqrt(_dot(rest, rest))
        if length > 1e-9 and len(found) < 2:
            found.append([a / length for a in rest])
    return found[0], found[1]
