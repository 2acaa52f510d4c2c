"""Floats leave out no balls that touch: the same ending with and without them, and alone."""

from __future__ import annotations

import time
from fractions import Fraction
from random import Random

import pytest

from tests.spheres.many.systems import random_system
from verify.prover import balls
from verify.spheres.many import nearby
from verify.spheres.many.decide import Ending, decide_system
from verify.spheres.many.motion import Motion
from verify.spheres.many.queue import Doubt, meeting
from verify.spheres.many.system import System
from verify.spheres.many.ways import Ways
from verify.spheres.scene.decide import BUDGET, Budget

ALL = 10**9


def ending(system: System, few: int, monkeypatch: pytest.MonkeyPatch) -> Ending:
    monkeypatch.setattr(nearby, "FEW", few)
    return decide_system(system, Budget(60))


def resized(system: System, length: Fraction, speed: Fraction) -> System:
    """The same in other units of length, and with other speeds; without gravity."""
    return system._replace(
        radii=tuple(length * a for a in system.radii),
        positions=tuple(tuple(length * a for a in x) for x in system.positions),
        velocities=tuple(tuple(speed * a for a in v) for v in system.velocities),
        walls=tuple(wall._replace(level=length * wall.level) for wall in system.walls),
        box=tuple(length * a for a in system.box),
    )


@pytest.mark.parametrize(
    ("kind", "exponents"),
    [(kind, (0, 0)) for kind in ("free", "box", "walls", "floor")]
    + [(kind, size) for kind in ("free", "walls") for size in ((7, -9), (-150, 90), (320, -320))],
)
def test_endings_are_the_same(
    kind: str, exponents: tuple[int, int], monkeypatch: pytest.MonkeyPatch
) -> None:
    rng, ten, found = Random(7), Fraction(10), set()
    for _ in range(12):
        system = random_system(rng, rng.choice((4, 9, 16)), kind)
        system = resized(system, *(ten**k for k in exponents))
        one, two = (ending(system, few, monkeypatch) for few in (ALL, 0))
        assert (one.verdict, one.why, one.members) == (two.verdict, two.why, two.members)
        assert sorted(map(str, one.contacts)) == sorted(map(str, two.contacts))
        found.add(len(one.contacts))
    assert max(found) > 10


@pytest.mark.parametrize("scale", [Fraction(1), Fraction(10) ** -140, Fraction(10) ** 200])
def test_none_that_touches_is_left_out(scale: Fraction) -> None:
    """Balls that come near or pass by a radius or by 10^-12 of one, at once or much later."""
    rng, touching = Random(11), 0
    for _ in range(300):
        off = rng.choice((-1, 1)) * Fraction(1, 10 ** rng.randrange(0, 14))
        gap, speed = Fraction(1, 10 ** rng.randrange(0, 12)), Fraction(10) ** rng.randrange(-6, 7)
        way = rng.choice((1, -1)) * Fraction(rng.randint(1, 999), 100)
        aside = rng.choice((Fraction(0), 1 + off))
        far = 1 + gap if not aside else gap * 10
        places = ((Fraction(5), Fraction(7)), (5 + far, 7 + aside))
        rates = ((way, Fraction(1)), (way - speed, Fraction(1)))
        x, v = (tuple(tuple(scale * a for a in row) for row in rows) for rows in (places, rates))
        half = scale / 2
        system = System(Fraction(1, 2), (Fraction(1),) * 2, (half, half), x, v)
        with balls.precision(200):
            motion = Motion(system, 200)
            wait = meeting(motion.pair(0, 1, motion.balls[0].time, ()))
            ways = Ways(motion)
            now, late = ways.at_once(0), ways.due(nearby.FOR_EVER)
            if wait is None:
                continue
            touching += 1
            if now == [1]:
                continue
            assert late == (0, 1)
            ways.at_once(0)
            time = balls.as_float(wait.wait if isinstance(wait, Doubt) else wait)
            assert ways.due(time) == (0, 1)
            assert ways.up_to(0, time) == [1]
    assert touching > 100


def test_many_balls_take_seconds() -> None:
    """1 500 discs that fly to one point, and as many in a box: a minute and more without floats."""
    side, number = 40, 1500
    rng = Random(1)

    def place(k: int) -> tuple[Fraction, Fraction]:
        a, b = (Fraction(rng.randint(100, 900), 1000) for _ in range(2))
        return 2 * (k % side) + a, 2 * (k // side) + b

    x = tuple(place(k) for k in range(number))
    v = tuple(tuple((side - a) / 10 for a in row) for row in x)
    sizes = (Fraction(1),) * number, (Fraction(1, 2),) * number
    for box in ((), (Fraction(2 * side),) * 2):
        system = System(Fraction(9, 10), *sizes, x, v, box=box)
        before = time.process_time()
        found = decide_system(system, Budget(300))
        assert found.why == BUDGET
        assert time.process_time() - before < 10
