"""A simulation of many balls by another hand: mpmath, all pairs and all images after each event."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations, product
from typing import Any

from mpmath import mp, mpf, sqrt

from verify.spheres.many.system import System

Number = Any
#: Images that are looked at, in each direction.
IMAGES = (-1, 0, 1)


def number(value: Any) -> Number:
    return mpf(value.numerator) / value.denominator


def dot(x: list[Number], y: list[Number]) -> Number:
    return sum((a * b for a, b in zip(x, y, strict=True)), mpf(0))


def contact(x: list[Number], w: list[Number], reach: Number) -> Number | None:
    """The time at which |x + tw| falls to the reach."""
    b, a = dot(x, w), dot(w, w)
    below = b * b - a * (dot(x, x) - reach**2)
    return (-b - sqrt(below)) / a if b < 0 and below > 0 else None


def landing(gap: Number, rate: Number, fall: Number, is_on: bool) -> Number | None:
    """The time at which gap + rate·t + fall·t²/2 falls to 0; the ball may be on the wall."""
    if is_on:
        gap = mpf(0)
    if fall == 0:
        return gap / -rate if rate < 0 else None
    below = rate**2 - 2 * fall * gap
    if below < 0:
        return None
    roots = sorted(((-rate - sqrt(below)) / fall, (-rate + sqrt(below)) / fall))
    first = mpf(10) ** (-mp.dps // 2) if is_on else 0
    return next((t for t in roots if t > first and rate + fall * t < 0), None)


class Simulation:
    """The balls of a system, moved from event to event."""

    def __init__(self, system: System) -> None:
        self.system, self.now = system, mpf(0)
        self.x = [[number(a) for a in row] for row in system.positions]
        self.v = [[number(a) for a in row] for row in system.velocities]
        self.g = [number(a) for a in system.gravity] or [mpf(0)] * system.dimension
        self.box = [number(a) for a in system.box]
        self.walls = [([number(a) for a in wall.normal], number(wall.level), number(wall.r))
                      for wall in system.walls]  # fmt: skip
        self.before: tuple[int, int] | None = None

    def events(self, count: int) -> Iterator[tuple[str, Number, Number]]:
        """The collisions: pair, time and normal speed."""
        while count:
            found = min(self._all(), key=lambda one: one[0], default=None)
            if self.box:
                fastest = max(max(row) - min(row) for row in zip(*self.v, strict=True))
                far = min(self.box) / (2 * fastest)
                if found is None or found[0] > far:  # other images may come before
                    self._move(far)
                    continue
            if found is None:
                return
            wait, i, j, shift = found
            self._move(wait)
            count -= 1
            speed = self._bounce(i, -1 - j) if j < 0 else self._collide(i, j, shift)
            self.before = (i, j)
            yield (f"{i}-wall{-1 - j}" if j < 0 else f"{i}-{j}"), self.now, speed

    def _move(self, wait: Number) -> None:
        self.now += wait
        for x, v in zip(self.x, self.v, strict=True):
            for k, g in enumerate(self.g):
                x[k] += v[k] * wait + g * wait**2 / 2
                v[k] += g * wait

    def _all(self) -> Iterator[tuple[Number, int, int, tuple[int, ...]]]:
        for i, j in combinations(range(self.system.number), 2):
            reach = number(self.system.contact(i, j))
            w = [b - a for a, b in zip(self.v[i], self.v[j], strict=True)]
            base = self._base(i, j)
            for more in product(IMAGES, repeat=len(self.box)):
                shift = tuple(n + m for n, m in zip(base, more, strict=True))
                time = contact(self._seen(i, j, shift), w, reach)
                if time is not None and time >= 0:
                    yield time, i, j, shift
        for i, (x, v) in enumerate(zip(self.x, self.v, strict=True)):
            for k, (n, level, _) in enumerate(self.walls):
                gap = dot(n, x) - level - number(self.system.radii[i]) * sqrt(dot(n, n))
                is_on = self.before == (i, -1 - k)
                time = landing(gap, dot(n, v), dot(n, self.g), is_on)
                if time is not None:
                    yield time, i, -1 - k, ()

    def _base(self, i: int, j: int) -> tuple[int, ...]:
        """The image that is about nearest."""
        rows = zip(self.x[i], self.x[j], self.box, strict=False)
        return tuple(-int(mp.nint((b - a) / side)) for a, b, side in rows)

    def _seen(self, i: int, j: int, shift: tuple[int, ...]) -> list[Number]:
        x = [b - a for a, b in zip(self.x[i], self.x[j], strict=True)]
        return [a + n * side for a, n, side in zip(x, shift, self.box, strict=True)] if shift else x

    def _collide(self, i: int, j: int, shift: tuple[int, ...]) -> Number:
        x = self._seen(i, j, shift)
        unit = [a / sqrt(dot(x, x)) for a in x]
        speed = -dot(unit, [b - a for a, b in zip(self.v[i], self.v[j], strict=True)])
        m_i, m_j = (number(self.system.masses[k]) for k in (i, j))
        impulse = (1 + number(self.system.restitution(i, j))) * speed * m_i * m_j / (m_i + m_j)
        self.v[i] = [v - impulse * u / m_i for v, u in zip(self.v[i], unit, strict=True)]
        self.v[j] = [v + impulse * u / m_j for v, u in zip(self.v[j], unit, strict=True)]
        return speed

    def _bounce(self, i: int, wall: int) -> Number:
        n, _, r = self.walls[wall]
        unit = [a / sqrt(dot(n, n)) for a in n]
        speed = -dot(unit, self.v[i])
        self.v[i] = [v + (1 + r) * speed * u for v, u in zip(self.v[i], unit, strict=True)]
        return speed
