"""Boxes are proved again by the same steps in balls; a verdict that is not true is not."""

from __future__ import annotations

import random
from fractions import Fraction

import numpy as np
import pytest

from tests.prover.test_map_boxes import PLANES, refined
from verify import check_map
from verify.jobs.map import Target, grow
from verify.jobs.map_recheck import rechecked
from verify.jobs.map_workers import workers
from verify.prover import balls
from verify.prover.map_balls import BallModels, Span, exact_models, parameter, reproved
from verify.prover.map_curve import strip_along
from verify.prover.map_intervals import exactly
from verify.wire.map_log import Progress

HERE = workers(1, None)
#: Numbers that close somewhere.
SIX = (25193416, 438582174, 4204233, 44262473, 12592029, 2163065221)


@pytest.mark.parametrize("name", ["straight", "slow", "slice-contact", "slice-space"])
def test_verdicts_are_proved_again_and_their_contraries_are_not(name: str) -> None:
    plane, rng = PLANES[name], random.Random(name)
    boxes = [box for box in refined(plane, 2) if box[1] != "u"]
    size = max(len(key) for key, _, _ in boxes)
    level = [box for box in boxes if len(box[0]) == size]
    level = rng.sample(level, min(len(level), 5))
    assert all(reproved(plane, level))
    others = [(key, "d", []) if letter == "c" else (key, "c", [SIX]) for key, letter, _ in level]
    assert not any(reproved(plane, others))
    without = [(key, letter, []) for key, letter, _ in level if letter == "c"]
    assert not without or not any(reproved(plane, without))


def test_all_of_a_strip_in_balls() -> None:
    phi = PLANES["straight"]._replace(x=(Fraction(1, 10), Fraction(3, 25)))
    progress = Progress(strip_along(phi, Fraction(1, 1000), 3, 3))
    with workers(1, None) as staff:
        for _ in grow(progress, Target(Fraction(0), 10**6, 12), staff, len):
            pass
    found = rechecked(progress, 20, HERE)
    assert found.decided >= 64
    assert found.balls == 20
    assert found.whole_numbers == 0


def test_what_balls_do_not_show_the_checker_does(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("verify.jobs.map_recheck.reproved", lambda _, level: [False] * len(level))
    progress = Progress(PLANES["straight"])
    with workers(1, None) as staff:
        for _ in grow(progress, Target(Fraction(1, 10), 10**6, 12), staff, len):
            pass
    found = rechecked(progress, 5, HERE)
    assert (found.balls, found.whole_numbers) == (0, 5)
    chunk = progress.found[0]
    progress.found[0] = chunk._replace(letters=chunk.letters.replace("c", "d"), numbers=[])
    with pytest.raises(check_map.RefusedError):
        rechecked(progress, 10**9, HERE)


def test_models_contain_what_exact_rationals_give() -> None:
    rng = random.Random(7)
    with balls.precision(96), np.errstate(all="ignore"):
        for _ in range(20):
            ends = [sorted(rng.uniform(0.5, 2) for _ in "ab") for _ in "xy"]
            x, y = (
                parameter(k, type(exactly(0.0))(np.array([a]), np.array([b])))
                for k, (a, b) in enumerate(ends)
            )
            shares = [Fraction(rng.choice((-1, 0, 1, rng.uniform(-1, 1)))) for _ in "xy"]
            p, q = (
                (Fraction(a) + Fraction(b)) / 2 + t * (Fraction(b) - Fraction(a)) / 2
                for (a, b), t in zip(ends, shares, strict=True)
            )
            found = (x * y - 3 * x) / (1 + y) ** 2 + 1 / (x + y)
            exact = (p * q - 3 * p) / (1 + q) ** 2 + 1 / (p + q)
            assert is_in(found, shares, exact)
            root = ((x + y) * (x + y) + exact_models(Fraction(1, 3))).root()
            assert is_in(root * root, shares, (p + q) ** 2 + Fraction(1, 3))


def is_in(found: BallModels, at: list[Fraction], exact: Fraction) -> bool:
    """Between the bounds, and near the polynomial."""
    t, u = map(balls.from_fraction, at)
    c, value = found.c[:, 0], balls.from_fraction(exact)
    polynomial = c[0] + c[1] * t + c[2] * u + c[3] * t * t + c[4] * t * u + c[5] * u * u
    assert Fraction(float(found.low[0])) <= exact <= Fraction(float(found.high[0]))
    return not abs(polynomial - value) > found.e[0]


def test_what_has_no_value() -> None:
    """Nothing is shown of it; and of no number at all everything is."""
    with balls.precision(96), np.errstate(all="ignore"):
        zero = parameter(0, type(exactly(0.0))(np.array([-1.0]), np.array([1.0])))
        for nothing in (1 / zero, zero.root()):
            assert not (nothing.low <= nothing.high).any()
            assert not (nothing.low > nothing.high).any()
        assert not (zero.above(np.array([np.nan])).low > -1).any()
        low, high = (balls.from_fraction(Fraction(n)) for n in (2, 1))
        none = BallModels(zero.c, zero.e, np.array([Span(low, high)], object))
        assert (none + zero).empty.all()
        assert ((none * zero).low > (none * zero).high).all()
