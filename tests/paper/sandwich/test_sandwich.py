"""The sandwich theorem: accepted as it is, refused with anything missing or changed, and true."""

from __future__ import annotations

from fractions import Fraction
from functools import cache

import pytest
from flint import arb

from tests.paper.sandwich.states import (
    Applied,
    Random,
    Values,
    fails,
)
from tests.paper.sharper.particles import dot
from verify.prover import balls

#: 430 digits.
BITS = 1430
COLLISIONS = 30


# --- what is true --------------------------------------------------------------------------------


def what_fails(applied: Applied) -> list[str]:
    """The conclusions that the next collisions contradict."""
    particles, at, points = applied
    repeats = len(points) - 3
    at = {name: arb(x) for name, x in at.items()}
    ratio = (1 + at["r"]) / 2 * at["G"]
    end = at["G"] * at["U_b"] * at["y_start"] / at["w_b"] ** 2 / (1 - ratio)
    s, c, clock, most, w_c, w_s = 1, 2, arb(0), at["y_start"], at["w_0"], at["w_1"]
    one = 1 + arb(10) ** -100
    for number in range(COLLISIONS):
        (x_s, W_s), (x_c, W_c) = particles.relative(0, s), particles.relative(0, c)
        far = dot(x_c, x_c).sqrt()
        y, eta_s, cosine = -dot(x_c, W_c) / far, dot(x_s, W_s), -dot(x_s, x_c) / far
        here = number if number <= repeats else repeats + (number - repeats) % 2
        Q, U = (balls.from_fraction(x) for x in points[here])
        meeting = particles.next()
        held = {
            "pair": meeting is not None and meeting[1:] == (0, c),
            "closing": y <= most * one,
            "q": eta_s <= Q * y * one,
            "u": (far**2 - 1) * w_c**2 <= U * (2 - U) * far**2 * y**2 * one,
            "angle": abs(cosine - at["C_0"]) <= at["Theta"],
            "speeds": dot(W_c, W_c) <= w_c**2 and dot(W_s, W_s) <= w_s**2,
            "distance": far <= at["G"],
        }
        if meeting is None or not all(held.values()):
            return [name for name, is_so in held.items() if not is_so]
        clock += meeting[0]
        if not (clock <= end and meeting[0] * w_c**2 <= at["G"] * U * y * one):
            return ["time"]
        particles.collide(*meeting)
        s, c, w_c, w_s, most = c, s, w_s, w_c, most * ratio
    return []


@cache
def draws(dimension: int, count: int) -> tuple[Applied, ...]:
    """States to which the theorem applies."""
    draw, found = Random(26 + dimension, dimension), []
    while len(found) < count:
        applied = draw.applied()
        if applied is not None:
            found.append(applied)
    return tuple(found)


@pytest.mark.parametrize("dimension", [2, 3])
def test_particles_do_as_they_are_told(dimension: int) -> None:
    with balls.precision(BITS):
        assert [what_fails(one) for one in draws(dimension, 40)] == [[]] * 40


@pytest.mark.parametrize("part", range(10))
def test_ten_thousand_states_do_as_they_are_told(part: int) -> None:
    with balls.precision(BITS):
        draw, followed = Random(1000 + part, 2 + part % 2), 0
        while followed < 1000:
            applied = draw.applied()
            if applied is not None:
                assert what_fails(applied) == []
                followed += 1


EDGES = ("start-q", "start-u", "start-A-most", "start-B-most", "start-C-upper", "start-C-lower",
         "start-cs-c", "start-cs-s")  # fmt: skip


def edges(at: Values) -> dict[str, tuple[str, arb]]:
    """For each hypothesis on the state the number that it bounds, and the bound."""
    ratio, y = (1 + at["r"]) / 2 * at["G"], at["y_start"]
    gain = ratio / (1 - ratio**2) * y
    step = at["G"] * at["U_b"] / at["w_b"] ** 2 / (1 - ratio)
    room = at["Theta"] - (at["w_0"] + at["w_1"] + y) * step * y
    zeta = at["U_0"] * (2 - at["U_0"]) * y**2 / at["w_0"] ** 2
    return {
        "start-q": ("eta_s_start", at["Q_0"] * y),
        "start-u": ("d_start", 1 / (1 - zeta).sqrt() - 1),
        "start-A-most": ("A_start", (at["w_0"] - ratio * gain) ** 2),
        "start-B-most": ("B_start", (at["w_1"] - gain) ** 2),
        "start-C-upper": ("C_start", at["C_0"] + room),
        "start-cs-c": ("A_start", y**2),
        "start-cs-s": ("B_start", at["eta_s_start"] ** 2),
        "start-C-lower": ("C_start", at["C_0"] - room),
    }


@pytest.mark.parametrize("name", EDGES)
def test_a_state_just_outside_is_not_accepted(name: str) -> None:
    """One part in 10^30 beyond a hypothesis it fails, and no other one; just inside it holds."""
    least = {"start-cs-c", "start-cs-s", "start-C-lower"}
    with balls.precision(BITS):
        tiny = arb(10) ** -30 * (-1 if name in least else 1)
        for _, at, points in draws(2, 40):
            number, edge = edges(at)[name]
            assert name in fails({**at, number: edge * (1 + tiny)}, points)
            assert name not in fails({**at, number: edge * (1 - tiny)}, points)


def test_a_stair_that_does_not_fit_is_not_accepted() -> None:
    """Each number of a stair is needed: half of it is too low."""
    with balls.precision(BITS):
        for _, at, points in draws(2, 40):
            for place in range(1, len(points)):
                Q, U = points[place]
                for lower in ((Q / 2, U), (Q, U / 4)):
                    assert fails(at, (*points[:place], lower, *points[place + 1 :]))
            assert "period" in fails(at, ((Fraction(0), Fraction(0)), *points[1:3]))


def test_a_simulation_that_contradicts_would_be_seen() -> None:
    """With a stair that is too low, something fails."""
    with balls.precision(BITS):
        for particles, at, points in draws(3, 10):
            low = tuple((Q / 2, U / 4) for Q, U in points)
            assert set(what_fails(Applied(particles, at, low))) & {"q", "u"}
