"""The flow is proved, its map is that of the laws in vectors, and another map is refused."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from random import Random
from typing import Any

import pytest

from verify import check
from verify.language.argument import Argument
from verify.language.terms import Claim, equal, sqrt, symbol
from verify.paper.commands import pages
from verify.paper.commands.pages import content, page
from verify.prover.arguments import write_down
from verify.spheres.flow.contexts import COLLISION, DRIFT, NAMED, PAIRS, RECENTRE, UNIT
from verify.spheres.flow.law import (
    Flight,
    Keep,
    State,
    collided,
    drifted,
    flight,
    outer,
    recentred,
    unnamed,
)
from verify.spheres.flow.pairs_and_units import pairs_of, unit_of
from verify.spheres.scene.scene import Coordinates, difference, inner_product
from verify.wire.text.read_page import read_page
from verify.wire.write import write


def report(statement: bytes, certificate: bytes) -> check.Report:
    return check.check(statement, certificate, {})


def files() -> tuple[bytes, bytes]:
    found = write(pages.decide("flow"))
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


# --- the page -------------------------------------------------------------------------------------


def computed(prefix: str, read: Callable[[State, Keep], object]) -> dict[str, Claim]:
    """What the program computes from a state of variables, as the page would write it."""
    found: dict[str, Claim] = {}

    def keep(name: str, term: Any) -> Any:
        new = symbol(f"{prefix}{name}")
        found[f"{new.name}-is"] = equal(new, term)
        return new

    read(State(*(symbol(f"{prefix}{name}") for name in State._fields)), keep)
    return found


def after(change: Callable[[State, Keep], object]) -> Callable[[State, Keep], object]:
    """The same, with the names of a next state."""
    return lambda now, keep: change(now, lambda name, term: keep(f"{name}_next", term))


def flight_and_collision(now: State, keep: Keep) -> None:
    way = flight(now, sqrt, keep)
    collided(symbol("r"), now, way, lambda name, term: keep(f"{name}_next", term))


@pytest.mark.parametrize(
    ("context", "prefix", "read"),
    [
        (COLLISION, "", flight_and_collision),
        (RECENTRE, "recentre.", after(recentred)),
        (DRIFT, "drift.", after(lambda now, keep: drifted(now, symbol("drift.t"), keep))),
        (PAIRS, "pairs.", pairs_of),
        (UNIT, "unit.", lambda now, keep: unit_of(now, sqrt, keep)),
    ],
)
def test_the_program_computes_with_the_formulas_of_the_page(
    context: str, prefix: str, read: Callable[[State, Keep], object]
) -> None:
    written = page("flow").statement.context(context).claims
    own = computed(prefix, read)
    assert own == {name: written[name] for name in own}
    assert {*own} == {name for name in written if name.endswith("-is")}
    if context in NAMED:
        named = {name for name in own if name.endswith("_next-is")}
        assert named == {f"{prefix}{name}_next-is" for name in NAMED[context]}


def test_another_map_is_refused() -> None:
    """With W_s pushed twice as hard the numbers are not those of the vectors."""
    right = "w_next-is: w_next = w + (1 + r)/2*"
    text = content("flow").decode()
    assert text.count(right) == 1
    wrong = read_page("flow.toml", text.replace(right, right.replace("= w +", "= 2*w +")).encode())
    found = write(write_down(Argument(wrong.statement, wrong.chapters)))
    verdict = report(found["statement.json"], found["certificate.json"])
    assert verdict.verdict == "REFUSED"
    assert any("next-" in line for line in verdict.lines if line.startswith("REFUSED"))
