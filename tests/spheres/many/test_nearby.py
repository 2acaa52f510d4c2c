"""Floats leave out no balls that touch: the same ending with and without them, and alone."""

from __future__ import annotations

import time
from fractions import Fraction
from random import Random

import pytest

from tests.cpu import seconds_of
from tests.spheres.many.systems import random_system
from verify.prover import balls
from verify.spheres.many import nearby
from verify.spheres.many.decide import Ending, decide_system
from verify.spheres.many.motion import Ball, Motion
from verify.spheres.many.queue import Doubt, above, meeting
from verify.spheres.many.system import System
from verify.spheres.many.ways import Ways
from verify.spheres.scene.decide import BUDGET, Budget

ALL = 10**9


def ending(system: System, few: int, monkeypatch: pytest.MonkeyPatch) -> Ending:
    monkeypatch.setattr(nearby, "FEW", few)
    return decide_system(system, Budget(60, max_bits=256))


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


def two_balls(rng: Random, low: int, high: int) -> System | None:
    """Two balls of sizes and speeds within powers of ten, aimed at each other or not."""
    ten = Fraction(10)

    def size() -> Fraction:
        sign = rng.choice((1, -1))
        return sign * ten ** rng.randint(low, high) * Fraction(rng.randint(1, 999), 100)

    dimension, length, speed = rng.choice((1, 2, 3)), size(), size()
    axes = range(dimension)
    half = abs(length) * ten ** rng.randint(-12, 12)
    x = [length * Fraction(rng.randint(-50, 50), 10) for _ in axes]
    off = [length * Fraction(rng.randint(-99, 99), rng.choice((1, 10, 10**6))) for _ in axes]
    if rng.random() < 0.4:  # beside each other by their size, or nearly so
        beside = 2 * half * (1 + rng.choice((-1, 0, 1)) * ten ** -rng.randint(1, 15))
        off = [(2 * half * rng.randint(2, 9), beside, Fraction(0))[k] for k in axes]
    v = [speed * Fraction(rng.randint(-50, 50), 10) for _ in axes]
    apart = rng.choice((1, 10, 10**9, 10**14))
    w = [speed * Fraction(rng.randint(-99, 99), apart) for _ in axes]
    if rng.random() < 0.4:  # along the first axis alone
        w = [-abs(speed) * ten ** -rng.randint(0, 12), Fraction(0), Fraction(0)][:dimension]
    if sum(a * a for a in off) < (2 * half) ** 2:
        return None
    gravity = tuple(speed * rng.randint(-9, 9) for _ in axes) if rng.random() < 0.2 else ()
    places = tuple(x), tuple(a + b for a, b in zip(x, off, strict=True))
    speeds = tuple(v), tuple(a + b for a, b in zip(v, w, strict=True))
    one = (Fraction(1),) * 2
    return System(Fraction(1, 2), one, (half, half), places, speeds, gravity=gravity)


@pytest.mark.parametrize(
    ("low", "high"), [(-3, 3), (-80, 70), (-165, 3), (-165, 160), (-330, -150), (-330, 310)]
)
def test_none_that_touches_is_left_out(low: int, high: int) -> None:
    """At numbers whose squares are no floats, too; one ball may have had a contact since."""
    rng, touching = Random(f"{low} {high}"), 0
    for _ in range(1000):
        system = two_balls(rng, low, high)
        if system is None:
            continue
        with balls.precision(rng.choice((64, 200))):
            motion = Motion(system, 128)
            if rng.random() < 0.5:
                since = balls.fmpq_of(rng.randint(1, 99) * Fraction(10) ** rng.randint(-6, 6))
                motion.balls[0] = Ball(since, *motion.at(0, since)[1:])
            now, ways = motion.balls[0].time, Ways(motion)
            wait = meeting(motion.pair(0, 1, now, ()))
            if wait is None or isinstance(wait, Doubt):
                continue
            touching += 1
            assert ways.at_once(0) == [1] or ways.due(above(now + wait)) == (0, 1)
    assert touching > 50


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


def test_two_balls_that_slow_down_in_a_box_end() -> None:
    """After so long a way floats do not tell their images apart: minutes were spent on each."""
    places = (Fraction(1), Fraction(1), Fraction(1)), (Fraction(2), Fraction(5, 2), Fraction(6, 5))
    speeds = (
        (Fraction(1043, 1000), Fraction(314, 1000), Fraction(223, 1000)),
        (Fraction(-53, 100), Fraction(752, 1000), Fraction(136, 1000)),
    )
    system = System(
        Fraction(1, 2),
        (Fraction(1),) * 2,
        (Fraction(3, 10),) * 2,
        places,
        speeds,
        box=(Fraction(3),) * 3,
    )
    seconds, found = seconds_of(lambda: decide_system(system, Budget(1000)))
    assert found.why == BUDGET
    assert "1000 images of ball 1 may touch ball 0" in found.says
    assert len(found.contacts) > 20
    assert seconds < 10
