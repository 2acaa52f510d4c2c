"""The order of two states, and orbits over one base point: exact, and from the law of collision."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from itertools import pairwise
from random import Random

import mpmath
import pytest
from mpmath import mpf

from verify.language.record import Record

Vector = Sequence[mpf]


class Balls(Record):
    """Three balls with contact distances 1, just after 0 met one; they may have any masses."""

    masses: Sequence[mpf]
    r: mpf
    x: Sequence[Vector]
    v: Sequence[Vector]

    def seen(self, ball: int) -> tuple[Vector, Vector]:
        """Where a ball is seen from 0, and how fast."""
        return plus(self.x[ball], -1, self.x[0]), plus(self.v[ball], -1, self.v[0])

    def coordinates(self, s: int, c: int) -> tuple[mpf, mpf, mpf]:
        """κ, q and y, where 0 just met s and meets c next."""
        (x, v), (x_s, v_s) = self.seen(c), self.seen(s)
        apart = mpmath.sqrt(dot(x, x))
        y = -dot(x, v) / apart
        return (apart - 1) / y**2, dot(x_s, v_s) / y, y

    def met(self, c: int) -> Balls | None:
        """Just after the next collision of 0 and c; nothing if they do not meet."""
        x, v = self.seen(c)
        closing, gap = -dot(x, v), dot(x, x) - 1
        root = closing**2 - dot(v, v) * gap
        if closing <= 0 or root <= 0:
            return None
        time = gap / (closing + mpmath.sqrt(root))
        at = [plus(a, time, b) for a, b in zip(self.x, self.v, strict=True)]
        line, speeds = plus(at[c], -1, at[0]), [*self.v]
        impulse = -(1 + self.r) * dot(line, v) / (1 / self.masses[0] + 1 / self.masses[c])
        for ball, sign in ((0, -1), (c, 1)):
            speeds[ball] = plus(speeds[ball], sign * impulse / self.masses[ball], line)
        return Balls(self.masses, self.r, at, speeds)


def orbit(balls: Balls, most: int) -> list[tuple[mpf, mpf, mpf]]:
    """κ, q and y after each collision, in turn, until there is none or there are so many."""
    now: Balls | None = balls
    found: list[tuple[mpf, mpf, mpf]] = []
    s, c = 1, 2
    while now is not None and len(found) <= most:
        found.append(now.coordinates(s, c))
        if found[-1][2] <= 0:
            return found[:-1]
        now, s, c = now.met(c), c, s
    return found


def over(rng: Random, masses: Sequence[float], r: float) -> Callable[[mpf], Balls]:
    """The states over a base point in space, by their κ; s has no tangential speed."""
    away = mpf(rng.uniform(0, 0.1))
    w_s, w_c, side = (-mpmath.cos(away), mpmath.sin(away), 0), (mpf(1), 0, 0), (0, 0.6, 0.8)
    y = mpf(10) ** rng.uniform(-6, -4)
    v_0 = [mpf(rng.uniform(-1, 1)) for _ in range(3)]
    v = [v_0, plus(v_0, y * rng.uniform(0.05, 0.1), w_s), plus(plus(v_0, -y, w_c), 1, side)]
    m = [*map(mpf, masses)]
    return lambda kappa: Balls(m, mpf(r), [(0, 0, 0), w_s, (1 + kappa * y * y, 0, 0)], v)


@pytest.mark.parametrize(("masses", "r"), [((1, 1, 1), 0.03), ((0.01, 100, 1), 0.3)])
def test_over_a_base_point_one_state_stays(masses: Sequence[float], r: float) -> None:
    """κ falls below the border, collisions end above it; the quotient of two κ grows."""
    rng, most = Random(7), 40
    with mpmath.workdps(100):
        state = over(rng, masses, r)
        low, high = mpf(0), mpf(10)
        while high - low > mpf(10) ** -20 * high:
            middle = (low + high) / 2
            ends = len(orbit(state(middle), most)) <= most
            low, high = (low, middle) if ends else (middle, high)
        upper = orbit(state(low), 15)
        for offset in ("0.5", "1e-3"):
            assert len(orbit(state(low * (1 + mpf(offset))), most)) <= most
            lower = orbit(state(low * (1 - mpf(offset))), most)
            assert len(lower) > most
            assert lower[-1][0] < lower[-3][0] < lower[-5][0] < low / 100
            quotients = [k_b / k_a for (k_a, _, _), (k_b, _, _) in zip(lower, upper, strict=False)]
            assert 1 < quotients[0]
            assert all(a < b for a, b in pairwise(quotients))
            assert all(a[1] <= b[1] for a, b in zip(lower, upper, strict=False))


def test_the_limit_map_keeps_the_order() -> None:
    """In exact numbers, also where one of the two speeds vanishes."""
    rng, kept = Random(8), 0
    while kept < 300:
        a, r, big_q, big_t = (Fraction(rng.randint(1, 999), 1000) for _ in range(4))
        speeds = rng.choice(((0, 1), (1, 0), (1, 3)))
        q, t = (big * Fraction(rng.randint(1, 100), 100) for big in (big_q, big_t))
        lower, upper = limit(a, r, speeds, q, t), limit(a, r, speeds, big_q, big_t)
        if upper is None or (q, t) == (big_q, big_t):
            continue
        assert lower is not None
        (k, p, x, v), (big_k, big_p, big_x, big_v) = lower, upper
        gap = (speeds[0] * a + speeds[1]) * (big_k - k) + big_q - q
        assert p - big_p >= gap > 0
        assert big_x >= x
        assert (big_x - x) * p * big_p >= r * (q * speeds[0] + speeds[1]) * (big_k - k)
        assert v / big_v <= k / big_k * (big_p / p) ** 2
        kept += 1


def limit(
    a: Fraction, r: Fraction, speeds: tuple[int, int], q: Fraction, t: Fraction
) -> tuple[Fraction, Fraction, Fraction, Fraction] | None:
    """κ, p, the next q and the next κ, where t is the time of flight over y."""
    s = 1 - speeds[0] * t
    p = a * s - q - speeds[1] * t
    if s <= 0 or p <= 0:
        return None
    return t - speeds[0] * t * t / 2, p, r * s / p, t * (2 * q + speeds[1] * t) / (2 * p * p)


def dot(x: Vector, y: Vector) -> mpf:
    return mpmath.fsum(a * b for a, b in zip(x, y, strict=True))


def plus(x: Vector, factor: mpf, y: Vector) -> Vector:
    return [a + factor * b for a, b in zip(x, y, strict=True)]
