"""What masses and restitutions say of collapses with one of three balls in the middle.

For a ball of mass m with two others, of masses m_1 and m_2, b² is (1+r_1)(1+r_2)m_1m_2 over
(m+m_1)(m+m_2); radii do not matter. With d = b² - r_1 - r_2 there is no collapse around it if
d < 2√(r_1r_2); if d < t + t² for the cube root t of r_1r_2, then all relative motion ends in one.
Each is shown by a decimal below the root. Source: `verify/paper/classification_of_balls.toml`.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction

from flint import fmpz

from verify.language.record import Record
from verify.spheres.scene.scene import Scene

#: How many decimals of a root are taken, the next where these show nothing.
PLACES = (6, 20, 60, 200)


class Middle(Record):
    """The ball in the middle, and the two others: masses, and coefficients of restitution."""

    ball: int
    others: tuple[int, int]
    m: Fraction
    masses: tuple[Fraction, Fraction]
    r: tuple[Fraction, Fraction]

    @property
    def square(self) -> Fraction:
        """b², the product of the two shares."""
        (one, two), (first, second) = self.masses, self.r
        return (1 + first) * (1 + second) * one * two / ((self.m + one) * (self.m + two))

    @property
    def excess(self) -> Fraction:
        """b² - r_1 - r_2."""
        return self.square - sum(self.r)


def middles(scene: Scene) -> list[Middle]:
    """Each ball in the middle."""
    masses = (Fraction(1),) * 3 if scene.bodies is None else scene.bodies.masses
    return [
        Middle(
            o,
            (i, j),
            masses[o],
            (masses[i], masses[j]),
            (scene.restitution(o, i), scene.restitution(o, j)),
        )
        for o, i, j in ((0, 1, 2), (1, 0, 2), (2, 0, 1))
    ]


def excluded(middle: Middle) -> Fraction | None:
    """A number s > 0 with s² <= r_1r_2 and b² - r_1 - r_2 < 2s; None if none is found."""
    return _shown(middle, 2, lambda s: 2 * s)


def rests(middle: Middle) -> Fraction | None:
    """A number t > 0 with t³ <= r_1r_2 and b² - r_1 - r_2 < t + t²; None if none is found."""
    return _shown(middle, 3, lambda t: t + t * t)


def _shown(middle: Middle, degree: int, bound: Callable[[Fraction], Fraction]) -> Fraction | None:
    product, excess = middle.r[0] * middle.r[1], middle.excess
    for places in PLACES:
        scale = 10**places
        root = Fraction(root_below(product * scale**degree, degree), scale)
        if root > 0 and excess < bound(root):
            return root
    return None


def root_below(value: Fraction, degree: int) -> int:
    """The largest whole number whose power is at most a number that is not negative."""
    return int(fmpz(math.floor(value)).root(degree))
