"""A ball between a wall and another one: certified collapses go on in a simulation, and in time."""

from __future__ import annotations

import random
from fractions import Fraction

import pytest
from mpmath import mp

from tests.cli.running import validator
from tests.spheres.many.simulation import Simulation, number
from verify.spheres.many.decide import BETWEEN, Ending, decide_system
from verify.spheres.many.system import System, Wall
from verify.spheres.scene.decide import COLLAPSES, Budget
from verify.views.many import many_document

F = Fraction
MORE = 40


def drawn(seed: int, r: str = "") -> System:
    """Ball 0 near a wall, and ball 1 that falls on it; masses and radii decades apart."""
    rng = random.Random(f"wall {seed}")
    masses = tuple(F(rng.randint(1, 99), 10) * F(10) ** rng.randint(-1, 1) for _ in range(2))
    radii = tuple(F(rng.randint(5, 40), 20) for _ in range(2))
    angle = F(rng.randint(-30, 30), 100)
    normal = (2 * angle / (1 + angle**2), (1 - angle**2) / (1 + angle**2))
    along = (normal[1], -normal[0])
    gap, off = F(rng.randint(1, 999), 10 ** rng.randint(3, 6)), F(rng.randint(-30, 30), 100)
    height = sum(radii) + gap
    places = [
        tuple(radii[0] * n for n in normal),
        tuple((radii[0] + height) * n + off * t for n, t in zip(normal, along, strict=True)),
    ]
    slide = F(rng.randint(-40, 40), 100)
    moves = [
        tuple(F(rng.randint(1, 40), 100) * n for n in normal),
        tuple(-n + slide * t for n, t in zip(normal, along, strict=True)),
    ]
    coefficient = F(r) if r else F(rng.randint(1, 250), 1000)
    walls = (Wall(normal, F(0), F(rng.randint(1, 250), 1000)),)
    return System(coefficient, masses, radii, tuple(places), tuple(moves), walls=walls)


def simulated(system: System, found: Ending) -> None:
    """The contacts after the verdict are in turn, and before the end that it gives."""
    with mp.workdps(300):
        events = list(Simulation(system).events(len(found.contacts) + MORE))
        more = events[len(found.contacts) :]
        assert [name for name, _, _ in more] == ["0-1", "0-wall0"] * (MORE // 2)
        assert found.time is not None
        assert number(found.time[0]) <= more[-1][1] <= number(found.time[1])
        speeds = [speed for name, _, speed in more if name == "0-1"]
        assert speeds == sorted(speeds, reverse=True)


def test_certified_collapses_go_on() -> None:
    count = 0
    for seed in range(80):
        system = drawn(seed)
        try:
            found = decide_system(system, Budget(30))
        except ValueError:  # balls that overlap
            continue
        if found.verdict == COLLAPSES:
            assert found.why == BETWEEN
            simulated(system, found)
            count += 1
    assert count > 20


def test_nothing_collapses_beyond_the_threshold() -> None:
    """On a line b_1 b_w > (√r_1 + √r_w)² is necessary: equal masses and r above 3 - 2√2."""
    for seed in range(20):
        system = drawn(seed, "0.2")
        system = system._replace(masses=(F(1), F(1)), walls=(system.walls[0]._replace(r=F(1, 5)),))
        found = decide_system(system, Budget(30))
        assert found.why != BETWEEN


def together(*more: tuple[tuple[str, str], tuple[str, str]], dimension: int = 2) -> System:
    """Two balls that collapse on a floor at the time 2.2, and more of them."""
    places = [("0", "2"), ("1/20", "4001/1000"), *(place for place, _ in more)]
    moves = [("0", "-1/10"), ("3/10", "-1"), *(move for _, move in more)]
    rows = ([tuple(map(F, row)) + (F(0),) * (dimension - 2) for row in r] for r in (places, moves))
    one = (F(1),) * len(places)
    floor = Wall((F(0), F(1)) + (F(0),) * (dimension - 2), F(0), F(1, 20))
    return System(F(1, 20), one, one, *map(tuple, rows), walls=(floor,))


@pytest.mark.parametrize("dimension", [2, 3, 5])
def test_in_any_dimension(dimension: int) -> None:
    found = decide_system(together(dimension=dimension))
    assert (found.verdict, found.why, len(found.contacts)) == (COLLAPSES, BETWEEN, 4)
    simulated(found.system, found)


def test_on_a_line() -> None:
    floor = Wall((F(1),), F(0), F(1, 20))
    one, rows = (F(1), F(1)), (((F(2),), (F(5),)), ((F(0),), (F(-1),)))
    found = decide_system(System(F(1, 20), one, one, *rows, walls=(floor,)))
    assert (found.verdict, found.why) == (COLLAPSES, BETWEEN)
    simulated(found.system, found)


def test_a_ball_that_may_come_near_prevents_it() -> None:
    alone = decide_system(together())
    far = decide_system(together((("50", "9"), ("1", "0"))))
    near = decide_system(together((("5", "3"), ("-13/10", "0"))))
    assert alone.why == far.why == BETWEEN
    assert (near.why, len(near.contacts)) != (BETWEEN, 4)


def test_gravity_towards_the_wall_is_not_covered() -> None:
    system = together()
    along, down = (system._replace(gravity=(F(x), F(y))) for x, y in ((-1, 0), (0, -1)))
    assert decide_system(along).why == BETWEEN
    assert decide_system(down).why != BETWEEN


@pytest.mark.parametrize("r", ["1/2", "1"])
def test_a_wall_that_loses_too_little(r: str) -> None:
    system = together()
    wall = system.walls[0]._replace(r=F(r))
    assert decide_system(system._replace(walls=(wall,)), Budget(60)).why != BETWEEN


def test_its_document_is_of_the_form_that_is_described() -> None:
    document = many_document(decide_system(together()), None)
    validator("many").validate(document)
    assert document["cites"] == []
    assert document["wall"] == 0
