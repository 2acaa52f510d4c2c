"""Where the map ends, collisions in turn end: accepted as it is, refused when changed, and true."""

from __future__ import annotations

import os
from fractions import Fraction

import pytest
from flint import arb

from tests.paper.sandwich.states import Random, values_of
from tests.paper.sandwich.states import fails as fails_inside
from tests.paper.sandwich_above.states import (
    Ending,
    collisions_in_turn,
    ending,
    fails,
    floor_of,
    numbers_of,
)
from verify.prover import balls
from verify.spheres.flow.collapse import Start, start_of
from verify.spheres.flow.follow import Flow
from verify.spheres.flow.sandwich import search
from verify.spheres.scene.scene import Scene

#: 1 200 digits: a run of 60 collisions loses most of them.
BITS = 4000
ROUNDS = int(os.environ.get("OUTSIDE_ROUNDS", "400"))


# --- what is true --------------------------------------------------------------------------------


def is_true(found: Ending) -> bool:
    """Whether there are no more collisions in turn than the theorem allows."""
    most = len(found.points)
    return collisions_in_turn(found.particles, most + 2) <= most


@pytest.mark.parametrize("dimension", [2, 3])
def test_random_states_on_both_sides(dimension: int) -> None:
    """No state is told to collapse by one half and to end by the other, and told ends come."""
    draw, told = Random(430 + dimension, dimension), {"collapses": 0, "ends": 0, "open": 0}
    with balls.precision(BITS):
        for _ in range(ROUNDS):
            kept = draw.random.getstate()
            end = ending(draw)
            draw.random.setstate(kept)
            inside = draw.applied()
            assert end is None or inside is None
            told["ends" if end else "collapses" if inside else "open"] += 1
            assert end is None or is_true(end)
    print(told)
    assert min(told.values()) > ROUNDS // 50


def test_a_state_just_outside_is_not_accepted() -> None:
    """One part in a million beyond a hypothesis on the state it fails."""
    draw, found = Random(7, 2), list[Ending]()
    with balls.precision(BITS):
        while len(found) < 10:
            end = ending(draw)
            if end is not None:
                found.append(end)
        for _, at, points in found:
            more, less = (
                1 + balls.fmpq_of(Fraction(1, 10**4)),
                1 - balls.fmpq_of(Fraction(1, 10**4)),
            )
            for name, number, by in (
                ("start-q", "Q_0", more),
                ("start-C", "C_p", less),
                ("start-A-most", "w_0", less),
                ("start-B-most", "w_1", less),
                ("start-A-least", "v_0", more),
                ("start-B-least", "v_1", more),
                ("start-u", "U_0", more),
            ):
                assert name in fails({**at, number: at[number] * by}, points), name


def test_a_floor_that_does_not_fit_is_not_accepted() -> None:
    """Numbers that are too high are no floor, and a floor has to end."""
    draw, seen = Random(8, 2), 0
    with balls.precision(BITS):
        while seen < 10:
            end = ending(draw)
            if end is None or len(end.points) < 3:
                continue
            seen += 1
            _, at, points = end
            for place in range(1, len(points)):
                Q, U = points[place]
                for higher in ((Q * 2, U), (Q, U * 2)):
                    assert fails(at, (*points[:place], higher, *points[place + 1 :]))
            assert "end" in fails(at, points[:-1])


def test_a_simulation_that_contradicts_would_be_seen() -> None:
    """Told of one collision less, most states contradict."""
    draw, seen, less = Random(9, 3), 0, 0
    with balls.precision(BITS):
        while seen < 20:
            end = ending(draw)
            if end is not None:
                seen += 1
                less += collisions_in_turn(end.particles, len(end.points)) >= len(end.points)
    assert less > 5


#: The separatrix at r = 3/100, -cos = 1, equal speeds and q = 1/10.
BORDER = Fraction("0.0517785628")


def nearly_aligned(y: Fraction, u: Fraction) -> Start:
    """A state in the plane with -cos = 1, unit speeds and q = 1/10, and with this u."""
    closing, parting = balls.from_fraction(y), balls.from_fraction(y / 10)
    zeta = balls.from_fraction(u * (2 - u))
    across = (1 - parting**2).sqrt() * (1 - closing**2).sqrt()
    one = arb(1)
    return Start(
        closing, parting, one, closing, -parting, one, one, parting * closing + across,
        1 / (1 - zeta * closing**2).sqrt() - 1,
    )  # fmt: skip


@pytest.mark.parametrize("y", [Fraction(1, 1000), Fraction(1, 10**4)])
def test_both_borders_come_together_at_the_separatrix(y: Fraction) -> None:
    r = Fraction(3, 100)
    with balls.precision(BITS):
        low = nearly_aligned(y, BORDER - y)
        found = search(r, low, Fraction(2))
        assert found is not None
        assert not fails_inside(values_of(found, Fraction(2), low), found[1].points)
        high = numbers_of(r, nearly_aligned(y, BORDER + 4 * y))
        assert high is not None
        points = floor_of(*high)
        assert points is not None
        assert not fails(high[0], points)


#: Particles with 0-2 and 0-1 in turn, nine times; then 1-2 meet.
MEETING_LATER = Scene(
    Fraction("0.0522299"),
    (
        (Fraction(0), Fraction(0)),
        (Fraction("1.00360729"), Fraction("-0.1490082")),
        (Fraction("-1.00969542"), Fraction("-0.2753928")),
    ),
    (
        (Fraction("0.47918"), Fraction("0.187468")),
        (Fraction("-0.327398"), Fraction("0.157718")),
        (Fraction("0.815177"), Fraction("0.1914068")),
    ),
)


def test_another_pair_may_meet_after_collisions_in_turn_have_ended() -> None:
    """The theorem allows three more in turn, and there are four: so a scene has to be followed."""
    with balls.precision(256):
        flow = Flow(MEETING_LATER, 256)
        for _ in range(6):
            assert flow.advance()
        assert flow.now is not None
        found = numbers_of(MEETING_LATER.r, start_of(flow.now.state))
        assert found is not None
        points = floor_of(*found)
        assert points is not None
        assert not fails(found[0], points)
        assert len(points) == 3
        while flow.advance():
            pass
    pairs = [tuple(sorted(move.after.frame[:2])) for move in flow.collisions]
    assert pairs == [(0, 1), (0, 2)] * 4 + [(0, 1), (1, 2)]
