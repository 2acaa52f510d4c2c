"""Who stays away from whom: quadratics, groups, images, and what is near three that collapse."""

from __future__ import annotations

from fractions import Fraction
from random import Random

from tests.spheres.many.systems import decimal
from verify.prover import balls
from verify.spheres.many.decide import decide_system
from verify.spheres.many.groups import find_groups
from verify.spheres.many.isolation import is_apart
from verify.spheres.many.motion import Motion
from verify.spheres.many.queue import Queue
from verify.spheres.many.system import System
from verify.spheres.scene.decide import COLLAPSES, DISPERSES, Budget

HALF = Fraction(1, 2)


def system(r: str, *rows: tuple[str, str], box: tuple[Fraction, ...] = ()) -> System:
    """Equal balls: places and velocities as people write them."""
    x, v = (tuple(tuple(map(Fraction, row[k].split())) for row in rows) for k in (0, 1))
    return System(Fraction(r), (Fraction(1),) * len(rows), (HALF,) * len(rows), x, v, box=box)


#: Three that collapse about the origin.
THREE = (("0 0", "0 0"), ("1.002 0", "-1.5 0"), ("-1.004 0.06", "0.8 -0.1"))
PAIR = (("0 50", "1 9"), ("9 50", "-1 9"))


def test_apart_is_said_only_where_it_is_so_at_all_times() -> None:
    rng, said = Random(1), 0
    for _ in range(600):
        x, w = ([decimal(rng, -4, 4) for _ in range(2)] for _ in range(2))
        reach, slope, time = decimal(rng, 0.1, 2), decimal(rng, 0, 2), decimal(rng, 0.1, 3)
        exact = [[balls.fmpq_of(a) for a in row] for row in (x, w)]
        numbers = [balls.fmpq_of(a) for a in (reach, slope, time)]
        for end in (time, None):
            found = is_apart(*exact, *numbers[:2], None if end is None else numbers[2])
            last = time if end else Fraction(40)
            times = [last * k / 200 for k in range(201)]
            truly = all(
                sum((a + t * b) ** 2 for a, b in zip(x, w, strict=True)) > (reach + slope * t) ** 2
                for t in times
            )
            said += found
            assert truly or not found
            if end and not found:  # it is no weaker than it could be, up to what the grid misses
                closest = min(
                    sum((a + t * b) ** 2 for a, b in zip(x, w, strict=True))
                    - (reach + slope * t) ** 2
                    for t in times
                )
                assert closest < Fraction(1, 4)
    assert said > 100


def groups_of(given: System) -> list[list[int]] | None:
    return find_groups(Queue(Motion(given, 128)), balls.fmpq_of(Fraction(1, 10**6)))


def test_groups_that_never_meet() -> None:
    assert groups_of(system("0.03", *THREE, *PAIR)) == [[0, 1, 2], [3, 4]]
    towards = (("0 50", "0 -9"), ("30 50", "0 0"))
    assert groups_of(system("0.03", *THREE, *towards)) is None


def test_three_collapse_whatever_a_far_pair_does() -> None:
    found = decide_system(system("0.03", *THREE, *PAIR))
    assert (found.verdict, {*found.members}) == (COLLAPSES, {0, 1, 2})
    assert found.scene is not None


def test_a_ball_in_the_way_is_met_first() -> None:
    """A fast ball reaches the middle one before the three have collapsed."""
    found = decide_system(system("0.03", *THREE, ("0 1.01", "0 -400")), Budget(1))
    assert found.verdict != COLLAPSES
    assert found.contacts[0][0] == "0-3"


def test_an_image_in_the_way_is_met_first() -> None:
    """As before, but the ball comes from the other side of the box."""
    side = Fraction(8)
    near = system("0.03", *THREE, ("0 -6.99", "0 -400"), box=(side, side))
    found = decide_system(near, Budget(1))
    assert found.verdict != COLLAPSES
    assert found.contacts[0][0] == "0-3"
    far = system("0.03", *THREE, ("0 -4", "0 -1"), box=(side, side))
    assert decide_system(far).verdict == COLLAPSES


def test_all_disperse_in_groups_or_none_collides() -> None:
    found = decide_system(system("0.5", *PAIR, ("0 0", "0 1"), ("5 0", "0 1")))
    assert (found.verdict, len(found.contacts)) == (DISPERSES, 1)
