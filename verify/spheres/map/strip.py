"""A strip along the border in the plane of the two ratios, and all that lies above and below it.

Over each of 2^n equal parts of an interval of φ1 the curve f is a polynomial of degree two. Below
the strip φ2 = (1 - u)(f - δ), above it φ2 = (1 - u)(f + δ) + u top, where u runs from 0 to 1: so
the tiles, parts of an interval of φ1 times parts of one of u, leave out just |φ2 - f(φ1)| < δ.
"""

from __future__ import annotations

from fractions import Fraction

from verify.language.record import Record
from verify.spheres.flow.law import Number
from verify.spheres.map.planes import Phi, Side


class BorderStrip(Record):
    """The plane, δ, the coefficients of f over each part, and the ends of the bands of u.

    f = c0 + c1 t + c2 t² at the distance t from the middle of a part. The rows of tiles are the
    bands below, beginning with the lowest, and then those above.
    """

    phi: Phi
    delta: Fraction
    curve: tuple[tuple[Fraction, ...], ...]
    below: tuple[Fraction, ...]
    above: tuple[Fraction, ...]

    @property
    def r(self) -> Fraction:
        """The coefficient of restitution."""
        return self.phi.r

    @property
    def level(self) -> int:
        """The n of 2^n parts, and as many bands."""
        return len(self.curve).bit_length() - 1

    @property
    def x(self) -> Side:
        """The interval of φ1."""
        return self.phi.x

    @property
    def y(self) -> Side:
        """The interval of φ2."""
        return self.phi.y

    @property
    def bands(self) -> list[tuple[Fraction, Fraction]]:
        """The bands of u, a row each."""
        low = [*zip(self.below, self.below[1:], strict=False)]
        return [*reversed(low), *zip(self.above, self.above[1:], strict=False)]

    def share(self, *keys: str) -> Fraction:
        """The share of the rectangle that tiles of one level have together.

        Their keys have a digit x + 2y for each level. Tiles in one column, on one side of the
        curve, have areas in proportion to their parts of u.
        """
        bands, depth = self.bands, len(keys[0]) - self.level if keys else 0
        found: dict[tuple[int, bool], Fraction] = {}
        for key in keys:
            column, row = (int("".join("01"[int(d) >> k & 1] for d in key), 2) for k in (0, 1))
            band = row >> depth
            place, (first, last) = (column, self.is_above(band)), bands[band]
            found[place] = found.get(place, 0) + last - first
        whole = (self.x[1] - self.x[0]) * (self.y[1] - self.y[0]) * (1 << depth)
        return sum((self._gap(depth, *p) * u for p, u in found.items()), Fraction(0)) / whole

    def _gap(self, depth: int, column: int, is_above: bool) -> Fraction:
        """The area between curve and goal over one of the columns of a level."""
        place, size = column >> depth, Fraction(1, 1 << depth)
        half = (self.x[1] - self.x[0]) / len(self.curve) / 2
        low = half * (2 * (column - (place << depth)) * size - 1)
        high = low + 2 * half * size
        f = sum(c * (high**i - low**i) / i for i, c in enumerate(self.curve[place], 1))
        width = high - low
        return (self.y[1] - self.delta) * width - f if is_above else f - self.delta * width

    def corners(self, key: str) -> list[tuple[Fraction, Fraction]]:
        """The corners of a tile in turn: φ1, and φ2 - f(φ1)."""
        column, row = (int("".join("01"[int(d) >> k & 1] for d in key), 2) for k in (0, 1))
        depth = len(key) - self.level
        place, band, size = column >> depth, row >> depth, Fraction(1, 1 << depth)
        width, (first, last) = (self.x[1] - self.x[0]) / len(self.curve), self.bands[band]
        found = []
        for i, k in ((0, 0), (1, 0), (1, 1), (0, 1)):
            t = width * ((column - (place << depth) + i) * size - Fraction(1, 2))
            u = first + (last - first) * (row - (band << depth) + k) * size
            f = sum((c * t**n for n, c in enumerate(self.curve[place])), Fraction(0))
            delta, goal = (self.delta, self.y[1]) if self.is_above(band) else (-self.delta, 0)
            x = self.x[0] + width * (place + Fraction(1, 2)) + t
            found.append((x, (1 - u) * (f + delta) + u * goal - f))
        return found

    def is_above(self, row: int) -> bool:
        """Whether a row of tiles lies above the curve."""
        return row >= len(self.below) - 1


def height(f: Number, u: Number, delta: Number, goal: Number) -> Number:
    """φ2: the goal is 0 below, where δ is subtracted, and the top above."""
    return (1 - u) * (f + delta) + u * goal
