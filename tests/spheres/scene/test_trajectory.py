"""Centres, velocities, speeds and energies against a simulation with 400 digits."""

from __future__ import annotations

from fractions import Fraction
from itertools import permutations
from random import Random

import mpmath

from tests.spheres.scene.agreement import is_inside
from tests.spheres.scene.random_scenes import random_scene
from tests.spheres.scene.scenes import aligned, on_a_line
from verify.measure.simulation import DIGITS, simulate
from verify.spheres.scene.decide import DISPERSES, FINITE, Budget, decide_scene
from verify.spheres.scene.energy import energy_at_start, energy_lost
from verify.spheres.scene.scene import Scene
from verify.spheres.scene.trajectory import Ends, trajectory
from verify.spheres.scene.verdict import ball_ends, steps, told


def test_centres_are_where_a_simulation_sees_them() -> None:
    rng = Random(8)
    for _ in range(8):
        found = decide_scene(random_scene(rng), Budget(digits=4))
        dimension = found.flow.scene.dimension
        _, *after = trajectory(found)
        seen = simulate(found.flow.scene, len(after))
        assert len(after) == len(seen) == len(found.flow.collisions)
        for instant, impact in zip(after, seen, strict=True):
            assert instant.pair == impact.pair
            assert is_inside(impact.time, instant.time)
            for numbers, place in zip(instant.particles, impact.positions, strict=True):
                centre = numbers[:dimension]
                assert all(map(is_inside, place, centre))
                assert all(high - low < Fraction(1, 10**20) for low, high in centre)


def momentum(particles: object, axis: int) -> Ends:
    rows = [numbers[axis] for numbers in particles]  # type: ignore[attr-defined]
    return sum(low for low, _ in rows), sum(high for _, high in rows)


def test_momentum_stays_and_energy_falls_by_what_is_told() -> None:
    found = decide_scene(aligned(), Budget(digits=6))
    moments = list(trajectory(found))
    first, last = moments[0], moments[-1]
    for axis in (2, 3):
        low, high = momentum(last.particles, axis)
        start, _ = momentum(first.particles, axis)
        assert low <= start <= high

    def energy(particles: object) -> Fraction:
        rows = [numbers[2:] for numbers in particles]  # type: ignore[attr-defined]
        return sum(sum(low * low for low, _ in row) for row in rows) / 2

    lost = energy(first.particles) - energy(last.particles)
    low, high = energy_lost(found)
    assert low - Fraction(1, 10**20) <= lost <= high
    assert high - low < lost / 1000


def test_a_collapse_on_a_line_takes_all_energy() -> None:
    """On a line the three have the same velocity in the end."""
    found = decide_scene(on_a_line("0.03"), Budget(digits=20))
    whole = energy_at_start(found.flow)
    low, high = energy_lost(found)
    assert low <= whole <= high
    assert whole - low < whole / 10**15


def test_what_is_not_followed_may_take_all_that_is_left() -> None:
    ended, finite = (decide_scene(on_a_line(r)) for r in ("0.072", "0.0717968"))
    assert (ended.verdict, finite.verdict) == (DISPERSES, FINITE)
    low, high = energy_lost(ended)
    assert 0 < low <= high < energy_at_start(ended.flow)
    assert high - low < Fraction(1, 10**20)
    low, high = energy_lost(finite)
    assert 0 < low < high == energy_at_start(finite.flow)


def test_the_speeds_are_those_of_a_simulation() -> None:
    found = decide_scene(aligned(), Budget(digits=6))
    seen = simulate(found.flow.scene, found.collisions)
    moments = list(trajectory(found))
    with mpmath.workdps(DIGITS):
        for n, (impact, step) in enumerate(zip(seen, told(found).impacts, strict=True)):
            i, j = map(int, impact.pair)
            x = [b - a for a, b in zip(impact.positions[i], impact.positions[j], strict=True)]
            v = [
                (moments[n].particles[j][2 + k][0] - moments[n].particles[i][2 + k][0])
                for k in (0, 1)
            ]
            speed = -sum(
                a * mpmath.mpf(b.numerator) / b.denominator for a, b in zip(x, v, strict=True)
            )
            low, high = (mpmath.mpf(end.numerator) / end.denominator for end in step.speed)
            assert low - mpmath.mpf(10) ** -25 < speed < high + mpmath.mpf(10) ** -25


def test_the_next_pair_is_seen_alike_however_the_particles_are_numbered() -> None:
    """Also just after the first collision, where either of its particles may be central."""
    places = (
        (Fraction(103, 100), Fraction(3, 200), Fraction(1, 100)),
        (Fraction(-51, 50), Fraction(1, 50), Fraction(-3, 200)),
        (Fraction(0),) * 3,
    )
    speeds = (
        (Fraction(-10), Fraction(1, 2), Fraction(0)),
        (Fraction(5), Fraction(0), Fraction(1, 4)),
        (Fraction(0),) * 3,
    )
    seen = []
    for order in permutations(range(3)):
        rows = (tuple(table[k] for k in order) for table in (places, speeds))
        found = decide_scene(Scene(Fraction(1, 50), *rows), Budget(digits=4))
        first = next(steps(found)).after
        seen.append([ball_ends(x, found.flow.bits) for x in (first.y, first.d, first.C)])
    for numbers in zip(*seen, strict=True):
        assert max(low for low, _ in numbers) <= min(high for _, high in numbers)
