"""Which balls may touch, and which images of them: told by floats with a margin, fast.

The floats are wrong by much less than the margin. Balls that may touch can be left out only if that
is certain; of those that remain everything is decided in balls of arithmetic.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from itertools import product
from typing import TYPE_CHECKING

from verify.prover import balls
from verify.spheres.flow.follow import UnclearError
from verify.spheres.many.motion import Ball, Motion, Shift
from verify.spheres.scene.decide import BUDGET

if TYPE_CHECKING:
    from verify.spheres.many.ways import Ways

#: Floats are taken to be wrong by this share of the numbers that they come from, or less.
MARGIN = 1e-9
#: Without a limit of time: for ever.
FOR_EVER = math.inf
#: So few balls are all looked at.
FEW = 32
#: More images than these of one ball are not looked at.
MOST_IMAGES = 1_000


class Nearby:
    """Floats of the ways of all balls since their last contacts."""

    def __init__(self, motion: Motion) -> None:
        self.motion = motion
        self.sides = [balls.as_float(side) for side in motion.box]
        self.ways = [_floats(ball) for ball in motion.balls]
        self.table: Ways | None = None
        if len(self.ways) > FEW:
            from verify.spheres.many.ways import Ways

            self.table = Ways(motion)

    def moved(self, i: int) -> None:
        """Afterwards a ball has its present way."""
        self.ways[i] = _floats(self.motion.balls[i])
        if self.table is not None:
            self.table.moved(i)

    def others(self, i: int, end: float) -> Iterable[int]:
        """The balls that may touch this one up to a time, and some more.

        For ever, those that certainly do not touch it yet are left to ``due``.
        """
        if self.table is None:
            return (j for j in range(len(self.ways)) if j != i)
        return self.table.at_once(i) if end == FOR_EVER else self.table.up_to(i, end)

    def due(self, time: float) -> tuple[int, int] | None:
        """Two balls that may touch up to a time and were left, from now on no more; else None."""
        return None if self.table is None else self.table.due(time)

    def images(self, i: int, j: int, span: tuple[float, float], more: float) -> Iterator[Shift]:
        """The images of the second ball that may touch the first one in a span of time.

        In it each ball may be off its straight way by half of ``more``. Images that do not may be
        given, too.

        Raises:
            UnclearError: if they are too many, as they are after so long a way that floats do not
                tell any more in which period it ends.
        """
        (start, end), reach = span, float(self.motion.system.contact(i, j)) + more
        ranges = []
        for k, side in enumerate(self.sides):
            (a, size_a, v), (b, size_b, w) = (self._place(ball, k, start) for ball in (i, j))
            ends = (b - a, b - a + (w - v) * (end - start))
            size = size_a + size_b + (abs(v) + abs(w)) * (end - start) + side
            room = reach + MARGIN * (size + reach)
            low, high = (-room - max(ends)) / side, (room - min(ends)) / side
            if not high - low < MOST_IMAGES:
                raise self._too_many(i, j)
            ranges.append(range(math.ceil(low), math.floor(high) + 1))
        if math.prod(map(len, ranges)) > MOST_IMAGES:
            raise self._too_many(i, j)
        yield from product(*ranges)

    def _too_many(self, i: int, j: int) -> UnclearError:
        what = f"more than {MOST_IMAGES} images of ball {j} may touch ball {i}"
        return UnclearError(f"budget: {what}, as far as floats tell", BUDGET)

    def _place(self, i: int, k: int, time: float) -> tuple[float, float, float]:
        """A coordinate then, the size of what it is computed from, and its rate."""
        start, x, v = self.ways[i]
        way = v[k] * (time - start)
        return x[k] + way, abs(x[k]) + abs(v[k]) * (abs(time) + abs(start)), v[k]


def _floats(ball: Ball) -> tuple[float, list[float], list[float]]:
    x, v = ([balls.as_float(a) for a in row] for row in (ball.x, ball.v))
    return balls.as_float(ball.time), x, v
