"""The ways of many balls in arrays of floats: which balls may touch one of them, and how soon.

Each number comes with how wrong it may be: by the radius of the ball of arithmetic of which it is
the middle, by a share ``MARGIN`` of all that it is computed from, which is much more than floats
lose, and by ``TINY``, since products of small numbers underflow. So balls are left out only where
it is certain that they do not touch.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from verify.prover import balls
from verify.prover.balls import as_float
from verify.spheres.many.motion import ZERO, Motion
from verify.spheres.many.nearby import FOR_EVER, MARGIN

#: Of larger numbers nothing follows: products of four of them are floats, too.
TINY, LARGE = 1e-280, 1e75
Array = np.ndarray[Any, Any]


class Seen(NamedTuple):
    """All balls seen from one of them, each from the later of the two last contacts on.

    Row k of ``x`` and ``w`` has coordinate k of the places and velocities, and these are wrong by
    less than ``off_x`` and ``off_w``; ``reach`` is the distance at a contact, or a little more.
    """

    start: Array
    off_start: Array
    x: Array
    w: Array
    off_x: Array
    off_w: Array
    reach: Array


class Ways:
    """The ways of many balls in arrays: a row for each coordinate, a column for each ball."""

    def __init__(self, motion: Motion) -> None:
        count = len(motion.balls)
        shape = motion.system.dimension, count
        self.motion, self.sides = motion, [as_float(side) for side in motion.box]
        self.time, self.x, self.v = np.zeros(count), np.zeros(shape), np.zeros(shape)
        #: How much is not known of the time, the place and the velocity.
        self.off = np.zeros((3, count))
        self.radii = np.array([as_float(balls.fmpq_of(a)) for a in motion.system.radii])
        gravity = motion.gravity or [ZERO] * motion.system.dimension
        self.gravity = np.array([[as_float(g)] for g in gravity])
        #: Before which time two balls that were left do not touch, and no more than the least of a
        #: row.
        self.soonest = np.full((count, count), FOR_EVER)
        self.least = np.full(count, FOR_EVER)
        for i in range(count):
            self.moved(i)

    def moved(self, i: int) -> None:
        """Afterwards a ball has its present way."""
        ball = self.motion.balls[i]
        self.time[i] = as_float(ball.time)
        self.x[:, i], self.v[:, i] = (list(map(as_float, row)) for row in (ball.x, ball.v))
        self.off[:, i] = _radius(ball.time), *(sum(map(_radius, row)) for row in (ball.x, ball.v))

    @np.errstate(all="ignore")  # of what is no number afterwards nothing is certain
    def up_to(self, i: int, end: float) -> list[int]:
        """Those that in some coordinate are not apart, with their images, up to this time."""
        seen = self._seen(i)
        wait = np.maximum(end - seen.start, 0.0) + seen.off_start
        room = seen.reach + seen.off_x + wait * seen.off_w
        far = np.zeros(len(room), dtype=bool)
        for k, (x, w) in enumerate(zip(seen.x, seen.w, strict=True)):
            low, high = x + np.minimum(w * wait, 0.0) - room, x + np.maximum(w * wait, 0.0) + room
            if self.sides:
                side = self.sides[k]
                far |= np.floor(high / side) < np.ceil(low / side)
            else:
                far |= (low > 0) | (high < 0)
        far[i] = True
        return np.flatnonzero(~far).tolist()

    @np.errstate(all="ignore")
    def at_once(self, i: int) -> list[int]:
        """Those that may touch it now; of others that do not part or pass by it is noted when."""
        seen = self._seen(i)
        low_d, high_d = _norms(seen.x)
        low_u, high_u = _norms(seen.w)
        p = (seen.x * seen.w).sum(0)
        off_p = high_d * seen.off_w + high_u * seen.off_x + seen.off_x * seen.off_w
        off_p = off_p + MARGIN * high_d * high_u + TINY
        near, slow = low_d - seen.off_x, np.maximum(low_u - seen.off_w, 0.0)
        part = slow**2 * (near**2 - seen.reach**2) * (1 - MARGIN)
        apart = (near > seen.reach) & (high_d < LARGE) & (high_u < LARGE)
        never = apart & ((p > off_p) | ((abs(p) + off_p) ** 2 + TINY < part))
        wait = (near - seen.reach) / (high_u + seen.off_w) * (1 - MARGIN)
        soonest = seen.start + wait - seen.off_start
        left = apart & ~never & (soonest < FOR_EVER)
        row = np.where(left, soonest, FOR_EVER)
        row[i] = FOR_EVER
        self.soonest[i], self.soonest[:, i] = row, row
        self.least = np.minimum(self.least, row)
        self.least[i] = row.min()
        now = ~(left | never)
        now[i] = False
        return np.flatnonzero(now).tolist()

    def due(self, time: float) -> tuple[int, int] | None:
        """Two balls that may touch up to a time and were left, from now on no more; else None."""
        while True:
            i = int(self.least.argmin())
            if not self.least[i] <= time:
                return None
            j = int(self.soonest[i].argmin())
            found = self.soonest[i, j]
            if found > self.least[i]:
                self.least[i] = found
                continue
            if found == FOR_EVER:
                return None
            self.soonest[i, j] = self.soonest[j, i] = FOR_EVER
            return min(i, j), max(i, j)

    def _seen(self, i: int) -> Seen:
        """All balls seen from this one."""
        start = np.maximum(self.time, self.time[i])
        off_time, off_x, off_w = self.off + self.off[:, [i]]
        g = self.gravity
        size, x, w = np.zeros((2, len(start))), np.zeros_like(self.x), np.zeros_like(self.v)
        for sign, t, place, v, off_v in (
            (1, self.time, self.x, self.v, self.off[2]),
            (-1, self.time[i], self.x[:, [i]], self.v[:, [i]], self.off[2, i]),
        ):
            wait, span = start - t, abs(start) + abs(t)
            x = x + sign * (place + wait * (v + wait * g / 2))
            w = w + sign * (v + wait * g)
            speeds = (abs(v) + span * abs(g)).sum(0)
            size += [abs(place).sum(0) + span * speeds, speeds]
            off_x = off_x + wait * off_v
        off_start = off_time + MARGIN * abs(start) + TINY
        off_x = off_x + MARGIN * size[0] + off_start * size[1] + TINY
        off_w = off_w + MARGIN * size[1] + off_start * abs(g).sum() + TINY
        reach = (self.radii[i] + self.radii) * (1 + MARGIN) + TINY
        return Seen(start, off_start, x, w, off_x, off_w, reach)


def _norms(rows: Array) -> tuple[Array, Array]:
    """Numbers below and above the lengths of vectors, up to what floats lose."""
    size = abs(rows)
    square = (rows * rows).sum(0)
    is_root = square > TINY  # else squares may have underflown
    return np.where(is_root, np.sqrt(square), size.max(0)), size.sum(0)


def _radius(value: Any) -> float:
    """How much is not known of a number, at most about."""
    return float(balls.as_ball(value).rad())
