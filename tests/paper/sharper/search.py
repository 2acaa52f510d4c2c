"""Numbers with which the sharper theorem may apply to a state: a search, which decides nothing.

Each bound starts at the state itself and is made as large as the others force it to be, a little
more each time, until nothing grows any more; then all are rounded. Floating-point numbers are good
enough for that: the inequalities between the rational numbers that come out are decided later.
"""

from __future__ import annotations

from fractions import Fraction
from math import floor, log10, sqrt

from verify.language.record import Record

ROUNDS = 400
#: How much more each bound is made, and to how many digits the numbers are rounded.
MORE = 1e-5
DIGITS = 8


class Near(Record):
    """A state just after a collision: y and the speed at most, and -cos theta within `spread`.

    ``low`` and ``high`` enclose eta_s/y, ``slope`` is d/y^2 at most.
    """

    r: float
    y: float
    low: float
    high: float
    C: float
    spread: float
    slope: float
    speed: float


class Bounds(Record):
    """The ratio eta_s/y lies in [low, high], y'/y in [slow, fast]; the others as in the theorem."""

    low: float
    high: float
    slow: float
    fast: float
    k: float
    V: float
    T: float
    Theta: float


def search(near: Near) -> dict[str, Fraction] | None:
    """The numbers of the context `start` but r; none if the bounds grow without end."""
    alpha = (1 + near.r) / 2 * near.C
    if alpha**2 <= 4 * near.r:
        return None
    p = (alpha + sqrt(alpha**2 - 4 * near.r)) / 2
    found: Bounds | None
    found = Bounds(near.low, near.high, p, p, near.slope, near.speed, 0.0, 0.0)
    for _ in range(ROUNDS):
        before, found = found, _grown(near, found)
        if found is None or max(abs(x - z) for x, z in zip(before, found, strict=True)) < 1e-12:
            break
    return None if found is None else _rounded(near, found)


def _grown(near: Near, b: Bounds) -> Bounds | None:
    """The bounds that these ones force; none if an inequality is out of reach."""
    half, y = (1 + near.r) / 2, near.y
    if not b.fast < 1:
        return None
    reach = 1 + b.k * y**2
    V = (near.speed + half * reach * y / (1 - b.fast)) * (1 + MORE)
    if not 2 * b.k * V**2 < 1:
        return None
    T = (1 - sqrt(1 - 2 * b.k * V**2)) / V**2 * (1 + MORE)
    root = 1 - T * V**2
    turned = (2 * T * V * y) / (1 - b.fast) + (b.k + (T * V) ** 2) * y**2 / (1 - b.fast**2)
    Theta = (near.spread + turned + T * V * b.k * y**3 / (1 - b.fast**3)) * (1 + MORE)
    slow = min(b.slow, half * root * (near.C - Theta) - b.high - T * V**2 - MORE)
    if not (slow > 0 and root > 0 and Theta < near.C):
        return None
    fast = max(b.fast, (half * reach * (near.C + Theta) - b.low / reach) * (1 + MORE))
    low = min(b.low, near.r * root / fast * (1 - MORE))
    high = max(b.high, near.r * reach / slow * (1 + MORE))
    k = max(b.k, (high * T + (V * T) ** 2 / 2) / slow**2 * (1 + MORE))
    return Bounds(low, high, slow, fast, k, V, T, Theta)


def _rounded(near: Near, b: Bounds) -> dict[str, Fraction]:
    low, high = _down(b.low), _up(b.high)
    slow, fast = _down(b.slow), _up(b.fast)
    eta_0 = _up(near.y)
    return {
        "m": (low + high) / 2,
        "p": (slow + fast) / 2,
        "X": (high - low) / 2,
        "Y": (fast - slow) / 2,
        "k": _up(b.k),
        "V": _up(b.V),
        "T": _up(b.T),
        "V_0": max(_up(near.speed), eta_0),
        "eta_0": eta_0,
        "C_0": min(_down(near.C), Fraction(1)),
        "Theta": _up(b.Theta),
    }


def _down(number: float) -> Fraction:
    """A rational number with few digits, not above this one."""
    if number <= 0:
        return Fraction(0)
    scale = Fraction(10) ** (DIGITS - 1 - floor(log10(number)))
    return Fraction(floor(Fraction(number) * scale)) / scale


def _up(number: float) -> Fraction:
    """A rational number with few digits, above this one."""
    if number <= 0:
        return Fraction(0)
    scale = Fraction(10) ** (DIGITS - 1 - floor(log10(number)))
    return (floor(Fraction(number) * scale) + 1) / scale
