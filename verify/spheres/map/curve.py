"""A curve near the border, by bisection: nothing is proved about it."""

from __future__ import annotations

import math
from fractions import Fraction

import numpy as np

from verify.spheres.flow.law import State
from verify.spheres.map.boxes import COLLAPSES, DISPERSES, INTERVALS, follow
from verify.spheres.map.intervals import Array, exactly
from verify.spheres.map.planes import Phi, start
from verify.spheres.map.strip import BorderStrip

#: Coefficients are whole numbers of this unit.
GRID = 2**64


def border(plane: Phi, phi_1: Array, digits: float) -> Array:
    """About where φ2 begins to disperse, for each φ1."""
    low, high = np.full(len(phi_1), float(plane.y[0])), np.full(len(phi_1), float(plane.y[1]))
    for _ in range(math.ceil(math.log2((high - low).max() / digits))):
        middle = (low + high) / 2
        letters = np.array(list(_point_verdicts(plane, phi_1, middle)))
        low = np.where(letters == COLLAPSES, middle, low)
        high = np.where(letters == DISPERSES, middle, high)
    return (low + high) / 2


def _point_verdicts(plane: Phi, phi_1: Array, phi_2: Array) -> str:
    with np.errstate(all="ignore"):
        x, y = exactly(phi_1), exactly(phi_2)
        state = start(plane, x, y, INTERVALS.number, lambda x: x.root())
        size = len(phi_1)
        whole = State(*(x if isinstance(x, int) else INTERVALS.spread(x, size) for x in state))
        return follow(plane.r, INTERVALS, whole, np.arange(size)).letters


def strip_along(plane: Phi, delta: Fraction, level: int, bands_below: int) -> BorderStrip:
    """A strip of 2^level parts, with so many of its 2^level rows of tiles below it."""
    parts = 2**level
    low, high = map(float, plane.x)
    places = np.linspace(low, high, 2 * parts + 1)
    f = border(plane, places, float(delta) / 64)
    left, middle, right = f[:-2:2], f[1:-1:2], f[2::2]
    half = (high - low) / parts / 2
    columns = (middle, (right - left) / (2 * half), (left - 2 * middle + right) / (2 * half**2))
    curve = tuple(
        tuple(Fraction(round(c * GRID), GRID) for c in part) for part in zip(*columns, strict=True)
    )
    below = _bands(float(delta) / f.max(), bands_below)
    above = _bands(float(delta) / float(plane.y[1]), parts - bands_below)
    return BorderStrip(plane, delta, curve, below, above)


def _bands(first: float, count: int) -> tuple[Fraction, ...]:
    """From 0 to 1 in that many steps, the first one about as given, and then geometric."""
    ends = [Fraction(round(first ** (1 - i / (count - 1)) * GRID), GRID) for i in range(count)]
    return Fraction(0), *ends
