"""Balls that fly and collide, one event after the other: written without the program under test.

Numbers are mpmath's with 100 digits, or fractions on a line. A run is a list of collisions with
what the theorems speak of.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

from mpmath import mp, mpf

mp.dps = 100
Vector = list[Any]
PAIRS = ((0, 1), (0, 2), (1, 2))
#: Where 100 digits are not enough any more: the balls are that near, or that slow.
NEAR = mpf(10) ** -60


def dot(x: Vector, z: Vector) -> Any:
    return sum(p * q for p, q in zip(x, z, strict=True))


def minus(x: Vector, z: Vector) -> Vector:
    return [p - q for p, q in zip(x, z, strict=True)]


@dataclass
class Collision:
    """One collision: closing speed u, impulse J, and the cosine of the angle at either ball."""

    pair: tuple[int, int]
    time: Any
    u: Any
    J: Any
    cosines: dict[int, Any]


@dataclass
class Balls:
    """Three balls in the frame of their centre of mass."""

    x: list[Vector]
    v: list[Vector]
    m: Sequence[Any]
    sigma: dict[tuple[int, int], Any]
    restitution: Callable[[], Any]
    time: Any = 0
    collisions: list[Collision] = field(default_factory=list)

    def __post_init__(self) -> None:
        total = sum(self.m)
        for vectors in (self.x, self.v):
            centre = [
                sum(m * z[k] for m, z in zip(self.m, vectors, strict=True)) / total
                for k in range(len(vectors[0]))
            ]
            vectors[:] = [minus(z, centre) for z in vectors]

    def between(self, i: int, j: int) -> tuple[Vector, Vector]:
        return minus(self.x[j], self.x[i]), minus(self.v[j], self.v[i])

    def meeting(self, pair: tuple[int, int]) -> Any:
        """The time to the next contact, if none hits another ball before; None without one."""
        x, w = self.between(*pair)
        p, square = dot(x, w), dot(w, w)
        if p >= 0:
            return None
        room = dot(x, x) - self.sigma[pair] ** 2
        radicand = p**2 - square * room
        if radicand <= 0:
            return None
        if isinstance(radicand, Fraction):  # on a line
            return (-p - abs(w[0]) * self.sigma[pair]) / square
        return max(room / (-p + mp.sqrt(radicand)), 0)

    def step(self) -> bool:
        """Go on to the next collision and through it; False if there is none."""
        times = {pair: t for pair in PAIRS if (t := self.meeting(pair)) is not None}
        if not times:
            return False
        pair = min(times, key=times.__getitem__)
        self.time += times[pair]
        self.x = [
            [p + times[pair] * q for p, q in zip(x, v, strict=True)]
            for x, v in zip(self.x, self.v, strict=True)
        ]
        self.collide(pair)
        return True

    def collide(self, pair: tuple[int, int]) -> None:
        i, j = pair
        (k,) = {0, 1, 2} - {i, j}
        x, w = self.between(i, j)
        e = [p / self.sigma[pair] for p in x]
        rho = dot(e, w)
        mu = self.m[i] * self.m[j] / (self.m[i] + self.m[j])
        J = mu * (1 + self.restitution()) * -rho
        self.v[i] = [p - J / self.m[i] * q for p, q in zip(self.v[i], e, strict=True)]
        self.v[j] = [p + J / self.m[j] * q for p, q in zip(self.v[j], e, strict=True)]
        cosines = {}
        for ball, out in ((i, e), (j, [-p for p in e])):
            to = minus(self.x[k], self.x[ball])
            length = abs(to[0]) if len(to) == 1 else mp.sqrt(dot(to, to))
            cosines[ball] = dot(out, to) / length
        self.collisions.append(Collision(pair, self.time, -rho, J, cosines))

    # --- what the theorems speak of -------------------------------------------------------------

    def total(self, first: list[Vector], second: list[Vector]) -> Any:
        parts = zip(self.m, first, second, strict=True)
        return sum(m * dot(p, q) for m, p, q in parts)

    @property
    def square(self) -> Any:
        return self.total(self.x, self.x)

    @property
    def virial(self) -> Any:
        return self.total(self.x, self.v)

    @property
    def energy(self) -> Any:
        return self.total(self.v, self.v)

    def spin(self) -> list[Any]:
        """The components of the angular momentum."""
        size = len(self.x[0])
        return [
            sum(
                m * (x[a] * v[b] - x[b] * v[a])
                for m, x, v in zip(self.m, self.x, self.v, strict=True)
            )
            for a in range(size)
            for b in range(a)
        ]


def on_a_line(r: Fraction, approach: Fraction) -> Balls:
    """Three equal balls on a line; 1 hits 0 with the speed 1, then 0 meets 2 with ``approach``."""
    # v_1 - v_0 = -1 at the contact; after it 0 has lost (1+r)/2 of its distance to 2's speed.
    half = (1 + r) / 2
    v_2 = half - approach * 1
    x = [[Fraction(0)], [Fraction(-2)], [Fraction(50)]]
    v = [[Fraction(0)], [Fraction(1)], [v_2]]
    one = Fraction(1)
    return Balls(x, v, [one] * 3, dict.fromkeys(PAIRS, one), lambda: r)


def scattered(seed: int, dimension: int, *, equal: bool, r: Fraction | None, kind: str) -> Balls:
    """Random balls: a heap, a chain, or nearly an equilateral triangle."""
    choose = random.Random(f"{seed} {dimension} {kind}")

    def number(low: float, high: float) -> Any:
        return mpf(choose.randrange(1, 10**9)) / 10**9 * (high - low) + low

    m = [mpf(1)] * 3 if equal else [mpf(10) ** number(-1, 1) for _ in range(3)]
    radii = [mpf(1) / 2] * 3 if equal else [number(0.1, 1) for _ in range(3)]
    sigma = {(i, j): radii[i] + radii[j] for i, j in PAIRS}
    small = mpf(10) ** -choose.randrange(0, 8)
    x = _places(kind, sigma, dimension, number, small)
    v = [[number(-1, 1) * (small if k else 1) for k in range(dimension)] for _ in range(3)]
    if kind != "heap":  # towards ball 0
        for ball in (1, 2):
            v[ball] = [-p + small * q for p, q in zip(minus(x[ball], x[0]), v[ball], strict=True)]
            v[ball] = [choose.choice((1, 2, 5)) * p for p in v[ball]]
    given = (lambda: mpf(r.numerator) / r.denominator) if r is not None else lambda: number(0, 1)
    return Balls(x, v, m, sigma, given)


def _places(
    kind: str, sigma: dict[tuple[int, int], Any], dimension: int, number: Any, small: Any
) -> list[Vector]:
    if kind == "heap":
        while True:
            x = [[number(-3, 3) for _ in range(dimension)] for _ in range(3)]
            gaps = (dot(y, y) - sigma[p] ** 2 for p in PAIRS for y in [minus(x[p[1]], x[p[0]])])
            if all(gap > 0 for gap in gaps):
                return x
    zero = [mpf(0)] * (dimension - 2)
    bend = mp.pi / 3 if kind == "triangle" else mp.pi - small * number(0, 1)
    far = [sigma[(0, 1)] * (1 + small * number(0, 1)), sigma[(0, 2)] * (1 + small * number(0, 1))]
    if kind == "triangle":
        far = [max(max(far), sigma[(1, 2)]) * (1 + small)] * 2
    return [
        [mpf(0), mpf(0), *zero],
        [far[0], mpf(0), *zero],
        [far[1] * mp.cos(bend), far[1] * mp.sin(bend), *zero],
    ]
