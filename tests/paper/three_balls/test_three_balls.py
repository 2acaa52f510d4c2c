"""The theorem on three balls: accepted as it is, refused with anything changed, and true."""

from __future__ import annotations

from collections import Counter
from functools import cache
from pathlib import Path

import pytest
from flint import arb

from tests.paper.three_balls.states import (
    STATEMENT,
    Applied,
    Random,
    Values,
    fails,
)
from verify.language.argument import Argument
from verify.language.statement import PROVED
from verify.paper.commands.pages import cite, content
from verify.prover import balls
from verify.prover.arguments import write_down
from verify.wire.judge import judged
from verify.wire.text.read_page import read_page

#: 430 digits.
BITS = 1430
COLLISIONS = 30


def test_no_two_numbers_of_the_balls_are_equal_at_the_point() -> None:
    point = STATEMENT.context("start").point
    for name in ("m", "r", "sigma", "beta", "Y", "E"):
        assert point[f"{name}_0"] != point[f"{name}_1"], name


def test_equal_particles_are_a_special_case() -> None:
    """What the sandwich theorem asks implies what this one asks: the page beside this test."""
    path = Path(__file__).with_name("equal.toml")
    cited = (cite("three_balls"),)
    read_here = read_page(str(path), path.read_bytes(), cited, lambda _: content("sandwich_below"))
    found = judged(write_down(Argument(read_here.statement, read_here.chapters)))
    assert found.decisions["equal"].verdict == found.verdict == PROVED


# --- what is true --------------------------------------------------------------------------------


def what_fails(applied: Applied) -> list[str]:
    """The conclusions that the next collisions contradict."""
    bodies, at, points = applied
    repeats = len(points) - 3
    at = {name: arb(x) for name, x in at.items()}
    end = at["E_0"] * at["y_start"]
    s, c, clock, most, one = 1, 2, arb(0), at["y_start"], 1 + arb(10) ** -100
    for number in range(COLLISIONS):
        here = bodies.start(s, c)
        index = number if number <= repeats else repeats + (number - repeats) % 2
        Q, U = (balls.from_fraction(x) for x in points[index])
        far, w_c, w_s = 1 + here.d, at[f"w_{number % 2}"], at[f"w_{1 - number % 2}"]
        meeting = bodies.next()
        held = {
            "pair": meeting is not None and meeting[1:] == (0, c),
            "closing": here.y <= most * one,
            "q": here.eta_s <= Q * here.y * one,
            "k": at[f"k_{number % 2}"] * here.y <= here.eta_s * one,
            "u": (far**2 - 1) * w_c**2 <= U * (2 - U) * far**2 * here.y**2 * one,
            "angle": abs(here.C - at["C_0"]) <= at["Theta"],
            "speeds": here.A <= w_c**2 and here.B <= w_s**2,
            "distance": far <= at["G"],
        }
        if meeting is None or not all(held.values()):
            return [name for name, is_so in held.items() if not is_so]
        clock += meeting[0]
        if not (clock <= end and meeting[0] * w_c**2 <= at["G"] * U * here.y * one):
            return ["time"]
        bodies.collide(*meeting)
        s, c, most = c, s, most * at[f"Y_{number % 2}"]
    return []


@cache
def draws(dimension: int, count: int, *, equal: bool = False) -> tuple[Applied, ...]:
    """States to which the theorem applies."""
    draw, found = Random(43 + dimension, dimension, equal=equal), []
    while len(found) < count:
        applied = draw.applied()
        if applied is not None:
            found.append(applied)
    return tuple(found)


@pytest.mark.parametrize("dimension", [2, 3])
def test_balls_do_as_they_are_told(dimension: int) -> None:
    with balls.precision(BITS):
        assert [what_fails(one) for one in draws(dimension, 40)] == [[]] * 40


@pytest.mark.parametrize("part", range(4))
def test_many_states_do_as_they_are_told(part: int) -> None:
    """Among them light middle balls, for which q has to be bounded from below, and C* > 0."""
    with balls.precision(BITS):
        draw, kinds = Random(1000 + part, 2 + part % 2), Counter[str]()
        while kinds["all"] < 500:
            applied = draw.applied()
            if applied is None:
                continue
            bodies, at, _ = applied
            assert what_fails(applied) == []
            kinds["all"] += 1
            kinds["light"] += bool(at["G"] ** 2 * at["beta_0"] * at["beta_1"] >= 1)
            kinds["large"] += bodies.bodies(1, 2).least_cosine > 0
            kinds["two"] += at["r_0"] != at["r_1"]
        assert min(kinds.values()) >= 10
        assert len(kinds) == 4


def edges(at: Values) -> dict[str, tuple[str, arb]]:
    """For each hypothesis on the state the number that it bounds, and the bound."""
    y, w_0 = at["y_start"], at["w_0"]
    gain = at["G"] / (1 - at["Y_0"] * at["Y_1"]) * y
    room = at["Theta"] - (w_0 + at["w_1"] + at["z_b"]) * at["E_0"] * y
    zeta = at["U_0"] * (2 - at["U_0"]) * y**2 / w_0**2
    return {
        "start-q": ("eta_s_start", at["Q_0"] * y),
        "start-u": ("d_start", 1 / (1 - zeta).sqrt() - 1),
        "start-A-most": ("A_start", (w_0 - at["beta_1"] * at["Y_0"] * gain) ** 2),
        "start-B-most": ("B_start", (at["w_1"] - at["beta_0"] * gain) ** 2),
        "start-C-upper": ("C_start", at["C_0"] + room),
        "start-C-lower": ("C_start", at["C_0"] - room),
        "start-cs-c": ("A_start", y**2),
        "start-cs-s": ("B_start", at["eta_s_start"] ** 2),
        "start-least": ("eta_s_start", at["k_0"] * y),
    }


@pytest.mark.parametrize("name", ["start-q", "start-u", "start-A-most", "start-B-most",
                                  "start-C-upper", "start-C-lower", "start-cs-c", "start-cs-s",
                                  "start-least"])  # fmt: skip
def test_a_state_just_outside_is_not_accepted(name: str) -> None:
    """One part in 10^30 beyond a hypothesis it fails, and no other one; just inside it holds."""
    least = {"start-cs-c", "start-cs-s", "start-C-lower", "start-least"}
    with balls.precision(BITS):
        tiny = arb(10) ** -30 * (-1 if name in least else 1)
        for _, at, points in draws(2, 40):
            number, edge = edges(at)[name]
            assert name in fails({**at, number: edge * (1 + tiny)}, points)
            assert name not in fails({**at, number: edge * (1 - tiny)}, points)


def test_a_simulation_that_contradicts_would_be_seen() -> None:
    """With a stair that is too low, something fails."""
    with balls.precision(BITS):
        for bodies, at, points in draws(3, 10):
            low = tuple((Q / 2, U / 4) for Q, U in points)
            assert set(what_fails(Applied(bodies, at, low))) & {"q", "u"}
