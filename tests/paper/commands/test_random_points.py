"""Prover and checker agree on each row, at random points, next to thresholds, and beyond them.

`RANDOM_POINTS=300` runs all the points of the continuous integration; without it there are a few.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from fractions import Fraction
from math import isqrt
from random import Random

import pytest

from verify import check
from verify.language.statement import NEEDED, PROVED, REFUTED, UNDECIDED
from verify.language.terms import Term, as_term, cos, cos_pi
from verify.paper.commands.theorem1 import decide_point
from verify.prover.outcome import Outcome
from verify.wire.read import read
from verify.wire.write import write

COUNT = int(os.environ.get("RANDOM_POINTS", "25"))
SEED = 1729

Point = tuple[Fraction, Term]


def decade(random: Random, most: int) -> Fraction:
    """A number in (0, 1) whose number of zeros is random."""
    digits = random.randint(1, 6)
    mantissa = random.randint(1, 10**digits - 1)
    return Fraction(mantissa, 10 ** (digits + random.randint(0, most)))


def step(random: Random) -> Fraction:
    """A small step to either side, or none."""
    return random.choice((-1, 0, 1)) * Fraction(random.randint(1, 9), 10 ** random.randint(2, 60))


def in_range(c: Fraction) -> Term:
    return as_term(min(max(c, Fraction(1, 10**9)), Fraction(1)))


def anywhere(random: Random) -> Point:
    return decade(random, 12), as_term(decade(random, 3))


def near_stability(random: Random) -> Point:
    """With s = r^(1/3) rational the threshold 2s(1+s)/(1+r) is rational."""
    s = decade(random, 3)
    r = s**3
    return r, in_range(2 * s * (1 + s) / (1 + r) + step(random))


def near_existence(random: Random) -> Point:
    """With q = √r rational the threshold 4q/(1+r) is rational."""
    q = decade(random, 3)
    return q**2, in_range(4 * q / (1 + q**2) + step(random))


def near_stabi(random: Random) -> Point:
    """r next to 9 - 4√5, where the threshold for the angle is 1."""
    digits = random.randint(3, 60)
    r = (
        9
        - Fraction(isqrt(80 * 10 ** (2 * digits)), 10**digits)
        + random.randint(-3, 3) * Fraction(1, 10**digits)
    )
    return r, in_range(1 - random.choice((Fraction(0), abs(step(random)))))


def at_an_angle(random: Random) -> Point:
    if random.random() < 0.5:
        n = random.randint(3, 40)
        return decade(random, 6), -cos_pi(Fraction(random.randint(n // 2 + 1, n - 1), n))
    return decade(random, 6), -cos(Fraction(random.randint(1571, 3141), 1000))


KINDS: list[Callable[[Random], Point]] = [
    anywhere, near_stability, near_existence, near_stabi, at_an_angle, near_stability, anywhere,
]  # fmt: skip


def points() -> list[Point]:
    random = Random(SEED)
    return [KINDS[number % len(KINDS)](random) for number in range(COUNT)]


def outcome_at(r: Fraction, c: Term) -> Outcome:
    point = {"r": as_term(r), "c": c, "V_0": as_term(1), "delta_theta": as_term(Fraction(1, 10))}
    return decide_point(point)


def test_the_points_are_what_they_are_meant_to_be() -> None:
    verdicts = [outcome_at(r, c).verdict for r, c in points()[:25]]
    assert {PROVED, REFUTED} <= set(verdicts)
    assert verdicts.count(PROVED) >= 5
    assert verdicts.count(REFUTED) >= 5


@pytest.mark.parametrize("number", range(COUNT))
def test_prover_and_checker_agree_on_each_row(number: int) -> None:
    r, c = points()[number]
    outcome = outcome_at(r, c)
    assert not outcome.spent
    undecided = [row for row, found in outcome.rows if found.verdict == UNDECIDED]
    assert [row.name for row in undecided if row.role == NEEDED] == []
    files = write(outcome)
    statement, certificate = files["statement.json"], files["certificate.json"]
    cited = {name[6:-5]: data for name, data in files.items() if name.startswith("cited/")}
    report = check.check(statement, certificate, cited)
    assert [line for line in report.lines if line.startswith("REFUSED")] == []
    assert report.verdict == {PROVED: "PROVED", REFUTED: "REFUTED"}[outcome.verdict]
    shown = sum(line.startswith("proved  ") for line in report.lines)
    assert shown == len(outcome.rows) - len(undecided)
    assert read(statement, certificate, cited) == outcome.draft
