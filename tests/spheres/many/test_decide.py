"""Many balls: the events are those of a naive simulation; three are decided as they are alone."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from random import Random

import pytest
from mpmath import mp, mpf

from tests.spheres.many.simulation import Simulation
from tests.spheres.many.systems import random_system, system_of
from tests.spheres.scene.kinds import KINDS, random_scene_of
from verify.spheres.many.decide import RESTS, Ending, decide_system
from verify.spheres.many.system import System, name_of
from verify.spheres.scene.decide import APART, COLLAPSES, DISPERSES, Budget, decide_scene

LIMITS = Budget(200)
#: So many collisions more are simulated.
AFTERWARDS = 16


def contradictions(found: Ending, dps: int = 300) -> list[str]:
    """Where a simulation with so many digits differs: a pair, a time, a speed, or what comes after.

    After a verdict that three collapse, or one comes to rest, these meet in turn and nobody else
    does, other balls that bounce excepted, until the time that is said.
    """
    with mp.workdps(dps):
        simulated = Simulation(found.system).events(len(found.contacts) + AFTERWARDS)
        left = list(found.impacts())
        while left:
            pair, time, speed = next(simulated)
            own = next((one for one in left if one.pair == pair), left[0])
            # Those before it may come later if their times are not told apart.
            before = left[: left.index(own)]
            together = all(one.time[1] >= own.time[0] for one in before)
            ends = ((own.time, time), (own.speed, speed))
            if own.pair != pair or not together or not all(is_in(*one) for one in ends):
                return [f"{own.pair} at {own.time}, {pair} at {time}"]
            left.remove(own)
        if found.verdict in (COLLAPSES, RESTS):
            return list(wrong_afterwards(found, simulated))
        if found.verdict == DISPERSES and found.why == APART:
            return [f"then {pair}" for pair, _, _ in simulated]
    return []


def is_in(ends: tuple[Fraction, Fraction] | None, value: mpf) -> bool:
    """Whether a number is in an enclosure, up to a third of its digits."""
    slack = mpf(10) ** (-mp.dps // 3)
    low, high = (mpf(end.numerator) / end.denominator for end in ends or ())
    return bool(low - slack <= value <= high + slack)


def wrong_afterwards(found: Ending, simulated: Iterator[tuple[str, mpf, mpf]]) -> Iterator[str]:
    """What contradicts a verdict in the collisions that come next."""
    last = None
    if found.verdict == RESTS:
        (ball,), wall = found.members, found.wall
        for pair, time, _ in simulated:
            if "wall" not in pair:
                yield f"then {pair}"
            last = time if pair == f"{ball}-wall{wall}" else last
    else:
        o, s, c = found.members
        turns = [name_of(o, c), name_of(o, s)]
        seen = [(pair, time) for pair, time, _ in simulated if found.place or pair in turns]
        pairs, last = [pair for pair, _ in seen], seen[-1][1]
        # Groups are followed on alone: it is not known here how many collisions come before.
        in_turn = {*pairs[-6::2]} != {*pairs[-5::2]} and {*pairs[-6:]} == {*turns}
        if not in_turn or (found.place and pairs != turns * (len(pairs) // 2)):
            yield f"then {seen}"
    low, high = (mpf(end.numerator) / end.denominator for end in found.time or ())
    if last is None or last > high or (found.verdict == COLLAPSES and last < low):
        yield f"the last time is {last}"


def check(kind: str, numbers: Sequence[int]) -> None:
    rng = Random(f"many {kind}")
    found = [decide_system(random_system(rng, n, kind), Budget(20)) for n in numbers]
    assert [contradictions(one) for one in found] == [[]] * len(found)
    assert sum(len(one.contacts) for one in found) > 25


@pytest.mark.parametrize("kind", ["free", "walls", "floor"])
def test_the_events_are_those_of_a_simulation(kind: str) -> None:
    check(kind, (4, 5, 8, 4, 5, 6))


def test_the_events_in_a_box_are_those_of_a_simulation() -> None:
    check("box", (4, 4, 5))


@pytest.mark.parametrize("kind", KINDS)
def test_three_balls_are_decided_as_they_are_alone(kind: str) -> None:
    rng = Random(f"three {kind}")
    for _ in range(8):
        scene = random_scene_of(kind, rng)
        alone, found = decide_scene(scene, LIMITS), decide_system(system_of(scene), LIMITS)
        assert found.verdict == alone.verdict, (scene, alone.verdict, found.verdict, found.says)


def test_balls_that_fall_side_by_side_stay_apart() -> None:
    """Two contacts at once, of pairs 20 apart, after a fall of 605."""
    rows = ((0, 0), (12, 0), (0, -20), (12, -20)), ((1, 0), (0, 0), (1, 0), (0, 0))
    x, v = (tuple(tuple(map(Fraction, row)) for row in part) for part in rows)
    one, half, gravity = (Fraction(1),) * 4, (Fraction(1, 2),) * 4, (Fraction(0), Fraction(-10))
    found = decide_system(System(Fraction(1, 2), one, half, x, v, gravity=gravity))
    assert (found.verdict, len(found.contacts)) == (DISPERSES, 2)
