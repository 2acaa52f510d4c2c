"""Random points of a family, and between what the share of a kind of scenes lies.

The interval is that of Clopper and Pearson: it holds with the confidence that is asked for, or
more, whatever the share is and however few points there are. Sums are enclosed in balls.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from fractions import Fraction
from random import Random

from verify.language.record import Record
from verify.prover import balls
from verify.spheres.scene.families import Family
from verify.spheres.scene.scene import Scene
from verify.spheres.scene.scene_files import OverlapError
from verify.wire.inputs import InputError

#: A point is one of 2^CELLS middles of equal parts, in each parameter.
CELLS = 32
#: The ends of an interval are multiples of 2^-FINENESS.
FINENESS, BITS = 24, 160
#: For each point that is drawn so many may be left out.
MAX_LEFT_OUT = 1000


class Drawn(Record):
    """A point, its scene, and how many points before it were left out: particles overlap there."""

    values: dict[str, Fraction]
    scene: Scene
    left_out: int


def draw(family: Family, count: int, seed: int) -> Iterator[Drawn]:
    """So many points, independent and uniform among those where no particles overlap.

    Raises:
        InputError: if a point is no scene for another reason, or if nearly all are left out.
    """
    rng, left_out = Random(seed), 0  # noqa: S311
    for _ in range(count):
        here = 0
        while True:
            values = {
                name: low
                + (high - low) * Fraction(2 * rng.getrandbits(CELLS) + 1, 2 ** (CELLS + 1))
                for name, (low, high) in family.sides.items()
            }
            try:
                yield Drawn(values, family.at(values), left_out)
                break
            except OverlapError as error:
                here, left_out = here + 1, left_out + 1
                if here >= MAX_LEFT_OUT:
                    raise InputError(
                        f"{family.where}: particles overlap at {here} points in a row; choose "
                        "intervals with fewer such points"
                    ) from error


def share_between(count: int, certain: int, possible: int, alpha: Fraction) -> tuple[Fraction, ...]:
    """Between what a share lies, with a confidence of at least 1 - alpha.

    Of so many independent points these are certainly of the kind, and these possibly.
    """
    return _least(count, certain, alpha / 2), 1 - _least(count, count - possible, alpha / 2)


def _least(count: int, seen: int, alpha: Fraction) -> Fraction:
    """A share p so small that seeing so many, or more, has a probability of at most alpha."""
    low, high = 0, seen * 2**FINENESS // count
    while high - low > 1:
        middle = (low + high) // 2
        if is_rare(count, seen, Fraction(middle, 2**FINENESS), alpha):
            low = middle
        else:
            high = middle
    return Fraction(low, 2**FINENESS)


def is_rare(count: int, seen: int, share: Fraction, alpha: Fraction) -> bool:
    """True only if so many of the kind, or more, have a probability of at most alpha.

    The share is below seen/count, so that the terms of the sum get smaller ever faster.
    """
    with balls.precision(BITS):
        p, bound = balls.from_fraction(share), balls.from_fraction(alpha)
        term = balls.from_fraction(Fraction(math.comb(count, seen)))
        term = term * p**seen * (1 - p) ** (count - seen)
        total, odds = term, p / (1 - p)
        for i in range(seen, count):
            ratio = odds * (count - i) / (i + 1)
            rest = term * ratio / (1 - ratio)
            if total > bound:
                return False
            if total + rest <= bound:
                return True
            term = term * ratio
            total = total + term
        return bool(total <= bound)
