"""Random states to which the sharper theorem applies, at the ends of what it allows included."""

from __future__ import annotations

import random
from fractions import Fraction
from math import sqrt

from flint import arb

from tests.paper.sharper.particles import Particles, Vector, combine, directions, dot
from tests.paper.sharper.search import Near, search
from verify.prover import balls

Numbers = dict[str, Fraction]


class Random:
    """Numbers of the theorem, and particles in some dimension that satisfy its conditions."""

    def __init__(self, seed: int, dimension: int) -> None:
        self.random, self.dimension = random.Random(seed), dimension

    def share(self) -> Fraction:
        """A number in [0, 1], often an end."""
        return self.random.choice(
            [Fraction(0), Fraction(1), Fraction(self.random.randrange(1001), 1000)]
        )

    def numbers(self) -> Numbers | None:
        """The numbers of the theorem, r among them; none if the search does not find any."""
        r = Fraction(self.random.randrange(1, 60), 1000)
        speed, C = 10 ** self.random.uniform(-2, 2), self.random.uniform(0.5, 1)
        alpha = (1 + float(r)) / 2 * C
        if alpha**2 < 4 * r:
            return None
        m = (alpha - sqrt(alpha**2 - 4 * float(r))) / 2
        low, high = sorted(m * self.random.uniform(0.5, 2) for _ in range(2))
        y = speed * 10 ** self.random.uniform(-4, -0.5)
        slope = 10 ** self.random.uniform(-5, -1) / speed**2
        spread = 10 ** self.random.uniform(-8, -1.5)
        found = search(Near(float(r), y, low, high, C, spread, slope, speed))
        return None if found is None else found | {"r": r}

    def between(self, low: Fraction, high: Fraction) -> Fraction:
        """A number between two others, often one of them."""
        return low + (high - low) * self.share()

    def particles(self, n: Numbers, room: Fraction) -> Particles | None:
        """Particles at a state that the conditions allow; `room` is how far C may be from C_0."""
        y = n["eta_0"] * self.between(Fraction(1, 100), Fraction(1))
        eta_s = y * self.between(n["m"] - n["X"], n["m"] + n["X"])
        d = n["k"] * y**2 * self.between(Fraction(1, 10**9), Fraction(1))
        C = min(n["C_0"] + self.between(-room, room), Fraction(1))
        if not eta_s > 0:
            return None
        omega_s, omega_c = directions(self.dimension, C)
        W_s = self.velocity(omega_s, balls.from_fraction(eta_s), n["V_0"])
        W_c = self.velocity(omega_c, balls.from_fraction(-y), n["V_0"])
        away = [balls.from_fraction(1 + d) * x for x in omega_c]
        rest = [arb(0)] * self.dimension
        return Particles([rest, omega_s, away], [rest, W_s, W_c], balls.from_fraction(n["r"]))

    def velocity(self, omega: Vector, normal: arb, speed: Fraction) -> Vector:
        """A velocity with a normal component and a speed that is at most the given one."""
        draw = [balls.from_fraction(Fraction(self.random.randrange(-99, 99), 100)) for _ in omega]
        draw[-1] += balls.from_fraction(Fraction(1, 1000))
        across = combine(draw, -dot(draw, omega), omega)
        size = balls.from_fraction(speed * self.between(Fraction(1, 2), 1 - Fraction(1, 10**30)))
        rest = size**2 - normal**2
        if not rest > 0:
            rest = balls.from_fraction(Fraction(0))
        length = (rest / dot(across, across)).sqrt()
        return combine([normal * x for x in omega], length, across)
