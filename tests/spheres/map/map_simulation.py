"""A second opinion on maps: positions and velocities with 200 digits, in nothing like the flow.

A scene is set up from the words of its description; each flight ends at the first root of a pair's
quadratic equation. A scene collapses if a closing speed falls below 10^-25; gaps fall faster than
speeds, hence so many digits.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import mpmath

from verify.spheres.map.planes import Phi, Plane, Through

DIGITS, MOST = 200, 400
SMALL = "1e-25"
PAIRS = ((0, 1), (0, 2), (1, 2))
Vectors = list[list[Any]]


def number(value: Fraction) -> Any:
    return mpmath.mpf(value.numerator) / value.denominator


def scene(plane: Phi, phi_1: Fraction, phi_2: Fraction) -> tuple[Vectors, Vectors]:
    """Sphere 0 rests at the origin, 1 touches it, 2 comes near."""
    cosine, eta, f_1, f_2 = map(number, (plane.neg_cos, plane.speed, phi_1, phi_2))
    u_c, u_s = map(number, plane.tangential)
    sine = mpmath.sqrt(1 - cosine**2)
    to_2, to_1 = [mpmath.mpf(1), mpmath.mpf(0)], [-cosine, -sine]
    across_2, across_1 = ([-y, x] for x, y in (to_2, to_1))
    x = [[mpmath.mpf(0)] * 2, to_1, [(1 + f_2 * eta**2) * a for a in to_2]]
    v_1 = [f_1 * eta * a + u_s * b for a, b in zip(to_1, across_1, strict=True)]
    v_2 = [-eta * a + u_c * b for a, b in zip(to_2, across_2, strict=True)]
    return x, [[mpmath.mpf(0)] * 2, v_1, v_2]


def fate(plane: Plane, x_share: Fraction, y_share: Fraction) -> str:
    """c, d, or ? if there is no end."""
    with mpmath.workdps(DIGITS):
        r, last = number(plane.r), (0, 0)
        if isinstance(plane, Phi):
            (x, v), last = scene(plane, x_share, y_share), (0, 1)
        else:
            x, v = varied(plane, x_share, y_share)
        for _ in range(MOST):
            meetings = [(t, p) for p in PAIRS if p != last and (t := _meeting(x, v, p))]
            if not meetings:
                return "d"
            time, last = min(meetings)
            if _collide(r, x, v, time, last) < mpmath.mpf(SMALL):
                return "c"
    return "?"


def varied(plane: Through, x_value: Fraction, y_value: Fraction) -> tuple[Vectors, Vectors]:
    rows = {
        "positions": [[*row] for row in plane.scene.positions],
        "velocities": [[*row] for row in plane.scene.velocities],
    }
    for (kind, i, k), value in ((plane.x_at, x_value), (plane.y_at, y_value)):
        rows[kind][i][k] = value
    x, v = ([[number(a) for a in row] for row in table] for table in rows.values())
    return x, v


def _meeting(x: Vectors, v: Vectors, pair: tuple[int, int]) -> Any:
    i, j = pair
    e, w = ([b - a for a, b in zip(u[i], u[j], strict=True)] for u in (x, v))
    closing = -_dot(e, w)
    gap, speed = _dot(e, e) - 1, _dot(w, w)
    square = closing**2 - speed * gap
    return None if closing <= 0 or square < 0 else gap / (closing + mpmath.sqrt(square))


def _collide(r: Any, x: Vectors, v: Vectors, time: Any, pair: tuple[int, int]) -> Any:
    for place, speed in zip(x, v, strict=True):
        place[:] = [a + time * b for a, b in zip(place, speed, strict=True)]
    i, j = pair
    e, w = ([b - a for a, b in zip(u[i], u[j], strict=True)] for u in (x, v))
    closing = -_dot(e, w) / mpmath.sqrt(_dot(e, e))
    push = (1 + r) / 2 * _dot(e, w) / _dot(e, e)
    v[i] = [a + push * b for a, b in zip(v[i], e, strict=True)]
    v[j] = [a - push * b for a, b in zip(v[j], e, strict=True)]
    return closing


def _dot(x: list[Any], y: list[Any]) -> Any:
    return sum(a * b for a, b in zip(x, y, strict=True))
