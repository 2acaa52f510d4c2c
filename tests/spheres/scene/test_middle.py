"""Finitely many collisions of balls of any masses: thresholds, certificates, near misses."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from fractions import Fraction
from functools import cache
from random import Random
from typing import Any

import mpmath
import pytest

from tests.spheres.scene.agreement import contradictions
from tests.spheres.scene.test_unequal import unequals
from verify.language.statement import PROVED
from verify.measure.simulation import simulate
from verify.paper.commands.scene import scene_outcome, tell
from verify.prover.outcome import Outcome
from verify.spheres.scene.criteria import INELASTIC, MOMENTUM, RECEDING, TURNING
from verify.spheres.scene.decide import FINITE, Budget, Fate, decide_scene
from verify.spheres.scene.middle import Middle, excluded, middles, rests, root_below
from verify.spheres.scene.scene import Bodies, Scene
from verify.spheres.scene.scene_files import read_scene
from verify.spheres.scene.verdict import theorems
from verify.wire.judge import judged

HALF = Fraction(1, 2)
#: r is by a millionth above the thresholds 0.2880201006… and 0.2642909331….
LINE = b"""r = "0.288020101629408072424832"
masses = [1, 5, 5]
positions = [[0], [2], ["-2.5"]]
velocities = [[0], [-1], [1]]
"""
PLANE = b"""r = "0.264291933136957437470189"
masses = [1, 5, 5]
positions = [[0, 0], ["1.001", 0], ["-1.001", "0.001"]]
velocities = [[0, 0], [-1, "0.1"], [1, "0.07"]]
"""


def middle_of(rng: Random) -> Middle:
    """Masses between 10⁻³ and 10³, and two coefficients of restitution."""
    masses = [Fraction(round(10 ** rng.uniform(-3, 3), 5)).limit_denominator(10**6)
              for _ in range(3)]  # fmt: skip
    both = tuple(Fraction(rng.randint(1, 999), 1000) for _ in "ab")
    return Middle(0, (1, 2), masses[0], (masses[1], masses[2]), (both[0], both[1]))


def thresholds(middle: Middle) -> tuple[object, object]:
    """(√r + √r')² and r + r' + t + t² with t³ = rr', less b²."""
    one, two = (mpmath.mpf(x.numerator) / x.denominator for x in middle.r)
    b2 = mpmath.mpf(middle.square.numerator) / middle.square.denominator
    t = mpmath.cbrt(one * two)
    return (mpmath.sqrt(one) + mpmath.sqrt(two)) ** 2 - b2, one + two + t + t * t - b2


def test_the_thresholds_are_those_of_the_theorem() -> None:
    rng, seen = Random(1), Counter[tuple[bool, bool]]()
    with mpmath.workdps(80):
        for _ in range(600):
            middle = middle_of(rng)
            first, second = thresholds(middle)
            assert (excluded(middle) is not None) == (first > 0)
            assert (rests(middle) is not None) == (second > 0)
            seen[first > 0, second > 0] += 1
    assert seen[False, True] >= 5
    assert seen[True, False] == 0
    assert min(seen[True, True], seen[False, False]) > 100


@pytest.mark.parametrize("sign", [-1, 1])
@pytest.mark.parametrize("places", [8, 40, 150])
def test_near_the_thresholds_of_equal_balls(sign: int, places: int) -> None:
    with mpmath.workdps(200):
        for shown, root in ((excluded, 7 - 4 * mpmath.sqrt(3)), (rests, 9 - 4 * mpmath.sqrt(5))):
            r = Fraction(int(root * 10**places) + (sign > 0), 10**places)
            equal = Middle(0, (1, 2), Fraction(1), (Fraction(1), Fraction(1)), (r, r))
            assert (shown(equal) is not None) == (sign > 0)


def test_what_is_shown_holds() -> None:
    rng = Random(2)
    for _ in range(200):
        middle = middle_of(rng)
        s, t = excluded(middle), rests(middle)
        product = middle.r[0] * middle.r[1]
        if s is not None:
            assert 0 < s**2 <= product
            assert middle.square - sum(middle.r) < 2 * s
        if t is not None:
            assert 0 < t**3 <= product
            assert middle.square - sum(middle.r) < t + t**2


def test_roots_of_whole_numbers() -> None:
    for value in range(70):
        for degree in (2, 3):
            root = root_below(Fraction(value) + Fraction(1, 3), degree)
            assert root**degree <= value < (root + 1) ** degree


# --- scenes --------------------------------------------------------------------------------------


@cache
def decided(content: bytes, collisions: int = 1000) -> Fate:
    """The verdict on a file."""
    return decide_scene(read_scene("a", content), Budget(collisions=collisions))


@cache
def certified(content: bytes) -> Outcome:
    """The certificate, after one collision was followed."""
    found = decided(content, 1)
    return scene_outcome(found, 16 * found.flow.bits)


def test_just_above_the_thresholds_of_their_masses() -> None:
    """Both were undecided after 1 000 collisions."""
    for content, name in ((LINE, INELASTIC), (PLANE, MOMENTUM)):
        assert (decided(content).verdict, decided(content).name) == (FINITE, name)
        assert theorems(decided(content)) == ["flow-of-balls", "classification-of-balls"]
        assert judged(certified(content)).verdict == PROVED


def test_just_below_them_nothing_is_said() -> None:
    for content, digits, near in ((LINE, b"0.288020101", b"0.288020100"),
                                  (PLANE, b"0.264291", b"0.264290")):  # fmt: skip
        few = decided(content.replace(digits, near), 1)
        assert few.verdict != FINITE
    on_a_line = PLANE.replace(b'"0.1"', b"0").replace(b'"0.07"', b"0").replace(b'"0.001"', b"0")
    assert decided(on_a_line, 1).verdict != FINITE


@pytest.mark.parametrize("name", ["finite.middle.0", "finite.middle.1", "finite.middle.2"])
def test_a_certificate_with_a_smaller_r_is_refused(name: str) -> None:
    """Only the row about the lightest ball is near its threshold."""
    found = decided(LINE, 1)
    low = found.flow.scene._replace(r=Fraction("0.28802"))
    flow = found.flow
    telling = tell(found)
    assert any(row.name == name for row in telling.rows)
    for middle in middles(low):
        assert (excluded(middle) is None) == (middle.ball == 0)
    flow.scene, scene = low, flow.scene
    try:
        with pytest.raises(ValueError, match="particle 0"):
            tell(found)
    finally:
        flow.scene = scene


def least(masses: tuple[Fraction, ...], shown: Any) -> Fraction:
    """About the least r for which something is shown of each ball in the middle; no less."""
    low, high = Fraction(0), Fraction(1)
    for _ in range(12):
        r = (low + high) / 2
        probe = Scene(r, ((), (), ()), ((), (), ()), bodies=Bodies(masses, (HALF,) * 3))
        low, high = (low, r) if all(map(shown, middles(probe))) else (r, high)
    return high


def just_above(rng: Random, shown: Any) -> Iterator[Scene]:
    """Scenes nearly in line, whose r is above where something is shown of the lightest ball.

    It is above both thresholds, or half way between them.
    """
    while True:
        masses = tuple(Fraction(rng.randint(1, 60), 10) for _ in range(3))
        first, second = (least(masses, one) for one in (excluded, rests))
        r = first + (1 - first) / 20 if shown is excluded else (first + second) / 2
        radii = tuple(Fraction(rng.randint(2, 10), 10) for _ in range(3))
        o = min(range(3), key=masses.__getitem__)
        i, j = {0, 1, 2} - {o}
        sides = rng.randint(0, 100), rng.randint(-100, 100)
        x, v = [None] * 3, [None] * 3
        x[o], v[o] = (Fraction(0),) * 2, (Fraction(0),) * 2
        for k, sign, side in ((i, 1, sides[0]), (j, -1, sides[1])):
            gap = radii[o] + radii[k] + Fraction(rng.randint(1, 50), 1000)
            x[k] = (sign * gap, Fraction(side, 10**4))
            v[k] = (
                -sign * Fraction(rng.randint(50, 150), 100),
                Fraction(rng.randint(-20, 20), 100),
            )
        yield Scene(r, tuple(x), tuple(v), bodies=Bodies(masses, radii))


@pytest.mark.parametrize("shown", [excluded, rests])
def test_what_is_finite_ends_in_a_simulation(shown: Any) -> None:
    rng = Random(5)
    scenes = just_above(rng, shown)
    names = Counter[str]()
    for _ in range(40):
        found = decide_scene(next(scenes), Budget(collisions=3))
        names[found.name] += 1
        if found.verdict == FINITE:
            assert contradictions(found, 200) == []
            assert len(simulate(found.flow.scene, 400, 200)) < 400
            assert judged(scene_outcome(found, 4 * found.flow.bits)).verdict == PROVED
    assert names[INELASTIC if shown is excluded else MOMENTUM] > 5


def test_each_finite_scene_has_a_certificate() -> None:
    names = Counter[str]()
    for scene in unequals(11, 120):
        found = decide_scene(scene, Budget(collisions=1))
        if found.verdict == FINITE:
            names[found.name] += 1
            assert judged(scene_outcome(found, 4 * found.flow.bits)).verdict == PROVED
    assert names[RECEDING] > 3
    assert names.total() - names[RECEDING] > 3
    assert {*names} <= {INELASTIC, MOMENTUM, RECEDING, TURNING}
