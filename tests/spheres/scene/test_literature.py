"""What is known of three particles from the literature, as the program decides it."""

from __future__ import annotations

from collections import Counter
from fractions import Fraction
from itertools import pairwise
from random import Random

import pytest

from tests.spheres.scene.kinds import random_scene_of
from tests.spheres.scene.scenes import on_a_line
from verify.spheres.scene.decide import COLLAPSES, DISPERSES, decide_scene
from verify.spheres.scene.families import read_family
from verify.spheres.scene.sampling import draw
from verify.spheres.scene.trajectory import trajectory
from verify.spheres.scene.verdict import told

LINE = """r = "0.056..0.0717"
positions  = [[0], ["1 + a"], ["-1 - b"]]
velocities = [["u"], [-1], [1]]
parameters = {a = "0..1", b = "0..1", u = "-1..1"}
"""
PLANE = """r = "RANGE"
positions  = [[0, 0], ["1.01", 0], ["-1 - b", "h"]]
velocities = [[0, 0], [-1, "w"], [1, "-w/2"]]
parameters = {b = "0.01..0.1", h = "-0.05..0.05", w = "-0.1..0.1"}
"""


def largest_number(r: Fraction) -> int:
    """The least n with s_n <= 0: no more collisions on a line are possible."""
    before, now, n = Fraction(0), Fraction(1), 1
    while now > 0:
        before, now, n = now, (1 + r) / 2 * now - r * before, n + 1
    return n


@pytest.mark.parametrize(("r", "number"), [("0.08", 11), ("0.072", 64), ("0.0718", 504)])
def test_the_largest_numbers_on_a_line_are_attained(r: str, number: int) -> None:
    assert largest_number(Fraction(r)) == number
    found = decide_scene(on_a_line(r))
    assert (found.verdict, found.collisions) == (DISPERSES, number)


def verdicts(text: str, count: int) -> Counter[str]:
    points = draw(read_family("family", text.encode()), count, 3)
    return Counter(decide_scene(point.scene).verdict for point in points)


def test_on_a_line_all_of_a_sample_collapse_up_to_the_first_threshold() -> None:
    assert verdicts(LINE, 60) == {COLLAPSES: 60}


@pytest.mark.parametrize(("r", "verdict"), [("0.05..0.055", COLLAPSES), ("0.057..0.07", DISPERSES)])
def test_near_a_line_the_second_threshold_divides_a_sample(r: str, verdict: str) -> None:
    assert verdicts(PLANE.replace("RANGE", r), 40) == {verdict: 40}


def test_each_theorem_on_collapses_is_told_with_its_energy() -> None:
    text = PLANE.replace("RANGE", "0.05..0.055").replace("-0.05..0.05", "-0.4..0.4")
    names = set()
    for point in draw(read_family("family", text.encode()), 150, 3):
        found = told(decide_scene(point.scene))
        names.add(found.reason)
        assert 0 <= found.energy[0] <= found.energy[1]
    assert {"sharper", "sandwich"} <= names


@pytest.mark.parametrize("kind", ["near-plane", "near-space", "at-an-angle"])
def test_the_angle_of_each_collapse_is_that_of_zhou_and_kadanoff(kind: str) -> None:
    """(1+r) (-cos θ) >= 4√r: no enclosure of a final angle lies below; some are near it."""
    rng, count = Random(4), 0
    for _ in range(60):
        scene = random_scene_of(kind, rng)
        found = decide_scene(scene)
        if found.collapse is None:
            continue
        count += 1
        most = found.collapse.angle[1] * (1 + scene.r)
        assert most > 0
        assert most**2 >= 16 * scene.r
    assert count > 10


def test_particles_do_not_turn_as_those_of_schoerghofer_and_zhou_may() -> None:
    """Collisions change velocities along the line of centres only."""
    rng, collisions = Random(6), 0
    for _ in range(12):
        scene = random_scene_of("near-space", rng)
        found = decide_scene(scene)
        for before, after in pairwise(trajectory(found)):
            i, j = map(int, after.pair)
            x = [[(low + high) / 2 for low, high in row[:3]] for row in after.particles]
            v, w = ([[(low + high) / 2 for low, high in row[3:]] for row in instant.particles]
                    for instant in (before, after))  # fmt: skip
            line = [b - a for a, b in zip(x[i], x[j], strict=True)]
            change = [b - a for a, b in zip(v[i], w[i], strict=True)]
            turned = [line[k] * change[k - 1] - line[k - 1] * change[k] for k in range(3)]
            assert all(abs(part) < Fraction(1, 10**12) for part in turned)
            assert v[3 - i - j] == w[3 - i - j]
            collisions += 1
    assert collisions > 20
