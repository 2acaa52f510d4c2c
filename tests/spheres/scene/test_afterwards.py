"""The velocities at a collapse, and what comes after it, against a simulation with 400 digits."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise
from pathlib import Path
from random import Random
from typing import Any

import mpmath
import pytest

from tests.spheres.scene.agreement import is_inside
from tests.spheres.scene.kinds import random_scene_of
from tests.spheres.scene.scenes import aligned, on_a_line
from tests.spheres.scene.test_three_balls import scenes
from verify.measure.simulation import DIGITS, Impact, simulate
from verify.spheres.scene.afterwards import MEET, TOGETHER, Afterwards, afterwards, collisions_until
from verify.spheres.scene.decide import COLLAPSES, Budget, Fate, decide_scene
from verify.spheres.scene.energy import energy_at_start, masses_of
from verify.spheres.scene.scene import PAIRS, Scene
from verify.spheres.scene.scene_files import read_scene

ROOT = Path(__file__).resolve().parents[3]
#: Collisions of the simulation: of the speeds that are left at most 10^-8 remains.
FAR = 120


def collapses(found: list[Scene]) -> list[tuple[Fate, Afterwards]]:
    decided = [decide_scene(scene) for scene in found]
    known = [(one, afterwards(one, Budget())) for one in decided]
    assert all((after is None) == (one.collapse is None) for one, after in known)
    return [(one, after) for one, after in known if after is not None]


def seen_velocities(impacts: list[Impact]) -> list[list[Any]]:
    """Those after the last collision but one."""
    before, last = impacts[-2:]
    wait = last.time - before.time
    rows = zip(before.positions, last.positions, strict=True)
    return [[(b - a) / wait for a, b in zip(p, q, strict=True)] for p, q in rows]


def wrong(found: Fate, after: Afterwards, far: int = FAR) -> bool:
    """Whether a simulation that is followed further has other velocities, or another end."""
    scene = found.flow.scene
    count = max(far, 3 * len(found.flow.collisions))
    impacts = simulate(scene, count)
    with mpmath.workdps(DIGITS):
        velocities = seen_velocities(impacts)
        last = max(
            abs(a - b)
            for one, other in pairwise((seen_velocities(impacts[:-1]), velocities))
            for p, q in zip(one, other, strict=True)
            for a, b in zip(p, q, strict=True)
        )
        room = Fraction(str(mpmath.nstr(last * 10**4, 5)))
        rows = zip(velocities, after.velocities, strict=True)
        return not all(
            is_inside(a, (low - room, high + room))
            for p, q in rows
            for a, (low, high) in zip(p, q, strict=True)
        )


def random_scenes(kind: str, count: int) -> list[Scene]:
    rng = Random(kind)
    return [random_scene_of(kind, rng) for _ in range(count)]


@pytest.mark.parametrize("kind", ["near-plane", "uneven-speeds", "five-dimensions"])
def test_velocities_are_those_of_a_simulation(kind: str) -> None:
    found = collapses(random_scenes(kind, 12))
    assert len(found) > 6
    assert [one for one, after in found if wrong(one, after)] == []


@pytest.mark.parametrize("heavy", [False, True])
def test_velocities_of_different_balls_are_those_of_a_simulation(heavy: bool) -> None:
    found = collapses(scenes(12, 16, heavy=heavy))
    assert len(found) > 3
    assert [one for one, after in found if wrong(one, after)] == []


def test_a_shifted_velocity_is_noticed() -> None:
    found = decide_scene(aligned())
    after = afterwards(found, Budget())
    assert after is not None
    assert not wrong(found, after)
    for ball in range(3):
        rows = [list(row) for row in after.velocities]
        low, high = rows[ball][0]
        rows[ball][0] = low + (high - low) * 2, high + (high - low) * 2
        assert wrong(found, after._replace(velocities=rows))


def test_momentum_is_kept_and_the_energy_is_that_of_the_velocities() -> None:
    for found, after in collapses([aligned(), *scenes(3, 8)]):
        scene, masses = found.flow.scene, masses_of(found.flow.scene)
        given, now = zip(*scene.velocities, strict=True), zip(*after.velocities, strict=True)
        for column, ends in zip(given, now, strict=True):
            low, high = (
                sum(m * end[k] for m, end in zip(masses, ends, strict=True)) for k in (0, 1)
            )
            assert low <= sum(m * v for m, v in zip(masses, column, strict=True)) <= high
        middle = [[(low + high) / 2 for low, high in row] for row in after.velocities]
        left = sum(
            masses[i]
            * masses[j]
            * sum((a - b) ** 2 for a, b in zip(middle[i], middle[j], strict=True))
            for i, j in PAIRS
        ) / (2 * sum(masses))
        lost, room = energy_at_start(found.flow) - left, after.width * 100
        assert after.energy[0] - room < lost < after.energy[1] + room


@pytest.mark.parametrize("digits", [8, 20])
def test_digits_can_be_asked_for(digits: int) -> None:
    after = afterwards(decide_scene(aligned(), Budget(digits=digits)), Budget(digits=digits))
    assert after is not None
    assert after.width <= after.spread / 10**digits


def test_on_a_line_the_three_stay_together() -> None:
    found = decide_scene(on_a_line("0.03"))
    after = afterwards(found, Budget())
    assert after is not None
    assert after.then == TOGETHER
    assert after.energy == (energy_at_start(found.flow),) * 2
    mean = sum(row[0] for row in found.flow.scene.velocities) / 3
    assert {row[0] for row in after.velocities} == {(mean, mean)}


def test_without_a_collapse_there_is_nothing_after_it() -> None:
    found = decide_scene(on_a_line("0.5"))
    assert found.verdict != COLLAPSES
    assert afterwards(found, Budget()) is None


def test_two_may_meet_again() -> None:
    """The outer ones, once the middle one has left them; at the time that their paths say."""
    met = [
        (one, after)
        for one, after in collapses(random_scenes("near-plane", 40))
        if after.then == MEET
    ]
    assert len(met) > 1
    for found, after in met:
        assert after.wait is not None
        assert found.collapse is not None
        assert str(found.flow.now.frame[0] if found.flow.now else "") not in after.pair
        impacts = simulate(found.flow.scene, FAR)
        with mpmath.workdps(DIGITS):
            last, velocities = impacts[-1].positions, seen_velocities(impacts)
            i, j = map(int, after.pair)
            x = [b - a for a, b in zip(last[i], last[j], strict=True)]
            w = [b - a for a, b in zip(velocities[i], velocities[j], strict=True)]
            low, high = (mpmath.mpf(end.numerator) / end.denominator for end in after.wait)
            assert distance(x, w, low) > 1 - mpmath.mpf(10) ** -9
            assert distance(x, w, high) < 1 + mpmath.mpf(10) ** -9
            assert high - low < low / 1000


@pytest.mark.parametrize("power", [0, 2, 5, 12, 40])
def test_what_is_left_until_the_collapse_is_that_of_a_simulation(power: int) -> None:
    cutoff = Fraction(1, 10**power)
    for found, _ in collapses([aligned(), *scenes(12, 5), *random_scenes("near-space", 3)]):
        count = collisions_until(found, cutoff, Budget())
        assert count is not None
        least, most = count
        assert least == most
        times = [0, *(impact.time for impact in simulate(found.flow.scene, most + FAR))]
        with mpmath.workdps(DIGITS):
            left = [times[-1] - time for time in times]
            assert left[most] < mpmath.mpf(10) ** -power
            assert most == 0 or left[most - 1] >= mpmath.mpf(10) ** -power


def test_a_cutoff_needs_a_collapse_and_a_budget() -> None:
    assert collisions_until(decide_scene(on_a_line("0.5")), Fraction(1), Budget()) is None
    found = decide_scene(aligned())
    assert collisions_until(found, Fraction(1, 10**60), Budget(collisions=10)) is None


def test_no_scene_is_followed_further_than_its_numbers_reach() -> None:
    """However many collisions are allowed: a light ball's speeds fall by 2 % each."""
    (scene,) = scenes(12, 1)
    bead = read_scene("bead", (ROOT / "certificates/scenes/bead.toml").read_bytes())
    for one in (scene, bead):
        found, many = decide_scene(one), Budget(collisions=10**7)
        assert collisions_until(found, Fraction(1, 10**4000), many) is None
        assert (afterwards(found, many) is None) == (found.collapse is None)


def distance(x: list[Any], w: list[Any], time: Any) -> Any:
    return mpmath.sqrt(sum((a + time * b) ** 2 for a, b in zip(x, w, strict=True)))
