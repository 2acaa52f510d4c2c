"""The flow is proved, its map is that of the laws in vectors, and another map is refused."""

from __future__ import annotations

from fractions import Fraction
from random import Random
from typing import Any

import pytest

from verify import check
from verify.paper.commands.scene import decide_flow
from verify.spheres.flow import law
from verify.spheres.flow.law import Flight, State, collided, drifted, outer, recentred, unnamed
from verify.spheres.scene.scene import Coordinates, difference, inner_product
from verify.wire.write import write


def report(statement: bytes, certificate: bytes) -> check.Report:
    return check.check(statement, certificate, {})


def files() -> tuple[bytes, bytes]:
    found = write(decide_flow())
    return found["statement.json"], found["certificate.json"]


def test_the_flow_is_proved() -> None:
    assert report(*files()).verdict == "PROVED"


def random_state(rng: Random, gap: int = 1) -> tuple[Coordinates, State]:
    def vector() -> tuple[Fraction, ...]:
        return tuple(Fraction(rng.randint(-20, 20), 10) for _ in range(3))

    given = Coordinates([vector() for _ in range(3)], [vector() for _ in range(3)])
    return given, given.state((0, 1, 2), unnamed)


def at_contact(rng: Random) -> Coordinates:
    """Spheres 0 and 2 in contact."""
    given, _ = random_state(rng)
    places = list(given.x)
    touch = rng.choice(((3, 4, 0), (0, 4, 3), (1, 2, 2)))
    length = 3 if touch == (1, 2, 2) else 5
    places[2] = [a + Fraction(b, length) for a, b in zip(places[0], touch, strict=True)]
    return Coordinates(places, given.v)


@pytest.mark.parametrize("seed", range(8))
def test_a_collision_in_inner_products_is_that_of_the_vectors(seed: int) -> None:
    rng, r = Random(seed), Fraction(3, 10)
    given = at_contact(rng)
    before = given.state((0, 1, 2), unnamed)
    e, w = difference(given.x, 0, 2), difference(given.v, 0, 2)
    push = (1 + r) / 2 * inner_product(e, w)
    v = [list(row) for row in given.v]
    v[0] = [a + push * b for a, b in zip(v[0], e, strict=True)]
    v[2] = [a - push * b for a, b in zip(v[2], e, strict=True)]
    expected = Coordinates(given.x, v).state((0, 2, 1), unnamed)
    if before.lam == 0:
        pytest.skip("the spheres do not move against each other")
    way = Flight(before.lam, before.rho / before.lam, Fraction(0), Fraction(1), Fraction(0))
    after = collided(r, before, way)
    y = way.y
    assert after.lam * y == expected.lam
    assert after.rho * y == expected.rho
    assert after.eps * y**2 == expected.eps
    assert (after.A, after.B, after.C) == (expected.A, expected.B, expected.C)
    assert (after.a, after.b, after.w) == (expected.a, expected.b, expected.w)


@pytest.mark.parametrize("seed", range(4))
def test_another_centre_and_a_drift_are_those_of_the_vectors(seed: int) -> None:
    rng = Random(seed)
    given, state = random_state(rng)
    assert recentred(state) == given.state((1, 0, 2), unnamed)
    assert outer(state) == given.pair(1, 2)
    time = Fraction(7, 3)
    x = [
        [a + time * b for a, b in zip(p, w, strict=True)]
        for p, w in zip(given.x, given.v, strict=True)
    ]
    assert drifted(state, time) == Coordinates(x, given.v).state((0, 1, 2), unnamed)


def test_another_map_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    """With W_s pushed twice as hard the numbers are not those of the vectors."""
    from verify.prover.arguments import write_down
    from verify.spheres.flow import collision
    from verify.spheres.flow.theorem import flow

    def wrong(r: Any, state: State, way: Flight, keep: Any = unnamed) -> State:
        return law.collided(r, state._replace(w=2 * state.w), way, keep)

    monkeypatch.setattr(collision, "collided", wrong)
    flow.cache_clear()
    try:
        found = write(write_down(flow()))
    finally:
        flow.cache_clear()
    verdict = report(found["statement.json"], found["certificate.json"])
    assert verdict.verdict == "REFUSED"
    assert any("next-" in line for line in verdict.lines if line.startswith("REFUSED"))
