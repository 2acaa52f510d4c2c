"""Many balls: the events are those of a naive simulation; three are decided as they are alone."""

from __future__ import annotations

from random import Random

import pytest
from mpmath import mp, mpf

from tests.spheres.many.simulation import Simulation
from tests.spheres.many.systems import random_system, system_of
from tests.spheres.scene.kinds import KINDS, random_scene_of
from verify.spheres.many.decide import Ending, decide_system
from verify.spheres.scene.decide import Budget, decide_scene

LIMITS = Budget(200)


def contradictions(found: Ending, dps: int = 300) -> list[str]:
    """Where a simulation with so many digits differs: the pair, the time or the speed."""
    wrong = []
    with mp.workdps(dps):
        slack = mpf(10) ** (-dps // 3)
        simulated = Simulation(found.system).events(len(found.contacts))
        for n, (own, other) in enumerate(zip(found.impacts(), simulated, strict=True)):
            pair, time, speed = other
            near = all(
                mpf(low.numerator) / low.denominator - slack
                <= value
                <= mpf(high.numerator) / high.denominator + slack
                for (low, high), value in ((own.time, time), (own.speed, speed))
            )
            if own.pair != pair or not near:
                wrong.append(f"{n}: {own.pair}, {pair}")
                break
    return wrong


@pytest.mark.parametrize("kind", ["free", "walls", "floor", "box"])
def test_the_events_are_those_of_a_simulation(kind: str) -> None:
    rng = Random(f"many {kind}")
    events = 0
    for number in (4, 5, 8, 4, 5, 6):
        found = decide_system(random_system(rng, number, kind), Budget(25))
        assert contradictions(found) == []
        events += len(found.contacts)
    assert events > 40


@pytest.mark.parametrize("kind", KINDS)
def test_three_balls_are_decided_as_they_are_alone(kind: str) -> None:
    rng = Random(f"three {kind}")
    for _ in range(8):
        scene = random_scene_of(kind, rng)
        alone, found = decide_scene(scene, LIMITS), decide_system(system_of(scene), LIMITS)
        assert found.verdict == alone.verdict, (scene, alone.verdict, found.verdict, found.says)
