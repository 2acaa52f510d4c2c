"""The law of collision of balls of any masses and radii: of vectors, as the page writes it."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from random import Random

import pytest

from tests.spheres.flow.test_flow import after, check_page
from verify import check
from verify.language.argument import Argument
from verify.language.terms import sqrt, symbol
from verify.paper.commands.pages import content
from verify.prover.arguments import write_down
from verify.spheres.flow.contexts import COLLISION, DRIFT, PAIRS, RECENTRE, UNIT
from verify.spheres.flow.law import (
    EQUAL,
    Flight,
    Keep,
    Sizes,
    State,
    collided,
    drifted,
    flight,
    outer,
    recentred,
    unnamed,
)
from verify.spheres.flow.pairs_and_units import pairs_of, scaled_unit_of
from verify.spheres.scene.scene import Bodies, Coordinates, difference, inner_product
from verify.wire.text.read_page import read_page
from verify.wire.write import write

PAGE = "flow_of_balls"


def sizes(prefix: str = "") -> Sizes:
    """The variables of the page."""
    return Sizes(*(symbol(f"{prefix}{name}") for name in ("K_c", "K_s", "K_o")), symbol("n"))


def flight_and_collision(now: State, keep: Keep) -> None:
    way = flight(now, sqrt, keep)
    collided(symbol("r"), now, way, lambda name, term: keep(f"{name}_next", term), sizes())


def unit(now: State, keep: Keep) -> None:
    scaled_unit_of(now, (symbol("unit.l_c"), symbol("unit.l_s")), sqrt, keep)


@pytest.mark.parametrize(
    ("context", "prefix", "read"),
    [
        (COLLISION, "", flight_and_collision),
        (RECENTRE, "recentre.", after(lambda now, keep: recentred(now, keep, sizes("recentre.")))),
        (DRIFT, "drift.", after(lambda now, keep: drifted(now, symbol("drift.t"), keep))),
        (PAIRS, "pairs.", lambda now, keep: pairs_of(now, keep, sizes("pairs."))),
        (UNIT, "unit.", unit),
    ],
)
def test_the_program_computes_with_the_formulas_of_the_page(
    context: str, prefix: str, read: Callable[[State, Keep], object]
) -> None:
    check_page(PAGE, context, prefix, read)


def drawn(rng: Random, *, equal: bool) -> tuple[Bodies, Coordinates, Fraction]:
    """Balls of which 0 touches 2, in space; r."""
    masses = tuple(Fraction(rng.randint(1, 40), 10) for _ in range(3))
    touch = Fraction(rng.randint(2, 9), 3)
    inside = touch * Fraction(rng.randint(1, 9), 10)
    radii = (inside, Fraction(rng.randint(1, 9), 4), touch - inside)
    if equal:
        masses, radii, touch = (Fraction(1),) * 3, (Fraction(1, 2),) * 3, Fraction(1)
    x = [[Fraction(rng.randint(-9, 9), rng.randint(1, 5)) for _ in range(3)] for _ in range(3)]
    v = [[Fraction(rng.randint(-9, 9), rng.randint(1, 5)) for _ in range(3)] for _ in range(3)]
    way = rng.choice(((3, 4, 0), (0, 4, 3)))
    x[2] = [a + touch * Fraction(b, 5) for a, b in zip(x[0], way, strict=True)]
    bodies = Bodies(masses, radii)
    squares = [bodies.square(i, j) for i, j in ((0, 1), (0, 2), (1, 2))]
    return bodies, Coordinates(x, v, squares), Fraction(rng.randint(1, 10), 10)


@pytest.mark.parametrize("equal", [False, True])
@pytest.mark.parametrize("seed", range(8))
def test_a_collision_in_inner_products_is_that_of_the_vectors(seed: int, equal: bool) -> None:
    """Momentum, and the normal relative velocity times -r, with both masses."""
    bodies, given, r = drawn(Random(seed), equal=equal)
    before = given.state((0, 1, 2), unnamed)
    if before.lam == 0:
        pytest.skip("the balls do not move against each other")
    e, w = difference(given.x, 0, 2), difference(given.v, 0, 2)
    m_0, _, m_2 = bodies.masses
    impulse = (1 + r) * m_0 * m_2 / (m_0 + m_2) * inner_product(e, w) / inner_product(e, e)
    v = [list(row) for row in given.v]
    v[0] = [a + impulse / m_0 * b for a, b in zip(v[0], e, strict=True)]
    v[2] = [a - impulse / m_2 * b for a, b in zip(v[2], e, strict=True)]
    expected = Coordinates(given.x, v, given.squares).state((0, 2, 1), unnamed)
    way = Flight(before.lam, before.rho / before.lam, Fraction(0), Fraction(1), Fraction(0))
    sizes = bodies.sizes((0, 1, 2), Fraction)
    assert not equal or sizes == EQUAL
    found = collided(r, before, way, unnamed, sizes)
    assert (found.lam * way.y, found.rho * way.y) == (expected.lam, expected.rho)
    assert found.eps * way.y**2 == expected.eps
    assert (found.A, found.B, found.C) == (expected.A, expected.B, expected.C)
    assert (found.a, found.b, found.w) == (expected.a, expected.b, expected.w)


@pytest.mark.parametrize("equal", [False, True])
@pytest.mark.parametrize("seed", range(4))
def test_another_centre_and_a_drift_are_those_of_the_vectors(seed: int, equal: bool) -> None:
    bodies, given, _ = drawn(Random(seed), equal=equal)
    of, state = bodies.sizes((0, 1, 2), Fraction), given.state((0, 1, 2), unnamed)
    assert recentred(state, sizes=of) == given.state((1, 0, 2), unnamed)
    assert outer(state, of) == given.pair(1, 2)
    time = Fraction(7, 3)
    x = [
        [a + time * b for a, b in zip(p, w, strict=True)]
        for p, w in zip(given.x, given.v, strict=True)
    ]
    assert drifted(state, time) == Coordinates(x, given.v, given.squares).state((0, 1, 2), unnamed)


#: What is miswritten: of another pair, another mass, a factor that is missing.
MUTANTS = (
    ("lam_next = (1 + r)/n*s*C_next/K_c", "lam_next = (1 + r)/n*s*C_next/K_s"),
    ("lam_next = (1 + r)/n*s*C_next/K_c", "lam_next = (1 + r)/2*s*C_next/K_c"),
    ("B_next = A - (1 - r^2)*(y*s)^2/K_c", "B_next = A - (1 - r^2)*(y*s)^2"),
    ("b_next = a + y*T*w - n*", "b_next = a + y*T*w - 2*"),
    ("w_next = w + (1 + r)/n*(y*s)*(n*", "w_next = w + (1 + r)/n*(y*s)*(2*"),
    ("A_next = B + (1 + r)/n*", "A_next = B + (1 + r)/2*"),
    ("C_next = -C - K_s - sig*v^2", "C_next = -C - K_c - sig*v^2"),
    ("eps_next = K_c + K_s - K_o", "eps_next = K_c + K_s - 1"),
    ("outer-last: 0 < K_c + K_s - K_o", "outer-last: 0 < K_c + K_s"),
    ("closing = lam*v/reach/l_c", "closing = lam*v/reach/l_s"),
    ("distance = eps*v^2/l_c/", "distance = eps*v^2/"),
)


@pytest.mark.parametrize(("right", "wrong"), MUTANTS)
def test_a_mutant_is_refused(right: str, wrong: str) -> None:
    text = content(PAGE).decode()
    assert right in text
    changed = read_page("flow.toml", text.replace(right, wrong, 1).encode())
    found = write(write_down(Argument(changed.statement, changed.chapters)))
    verdict = report_of(found)
    assert verdict != "PROVED"


def report_of(files: dict[str, bytes]) -> str:
    """The checker's verdict."""
    return check.check(files["statement.json"], files["certificate.json"], {}).verdict
