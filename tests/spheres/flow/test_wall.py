"""The theorem on a ball at a wall: numbers that claim more than they may are refused."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

import pytest

from verify.prover import balls
from verify.spheres.flow.wall import Bounds, Point, Start, WallPair, find_wall, search, shows

F = Fraction
NONE, LESS, MUCH = F(0), F(99, 100), F(9, 10)
Change = Callable[[Bounds, list[Point]], tuple[Bounds, list[Point]]]


def state(**changed: Fraction) -> Start:
    """A state whose collapse is found; its contacts are as long as their distance."""
    numbers = {"y": F(1, 100), "eta": F(1, 500), "d": F(1, 10**6), "A": F(10001, 10000)}
    return Start(
        **{k: balls.fmpq_of(x) for k, x in (numbers | {"C": F(99, 100)} | changed).items()}
    )


def pair(least_cosine: Fraction = NONE) -> WallPair:
    """Two equal balls with r = 1/20, and a wall with the same."""
    r = F(1, 20)
    return WallPair(((1 + r) / 2, 1 + r), (r, r), least_cosine, F(1), (1 + r) / 2)


def replaced(**changed: Callable[[Fraction], Fraction]) -> Change:
    """Some numbers, changed."""
    return lambda x, points: (
        x._replace(**{name: change(getattr(x, name)) for name, change in changed.items()}),
        points,
    )


def of_two(name: str, i: int, factor: Fraction) -> Change:
    """One of two numbers."""

    def change(x: Bounds, points: list[Point]) -> tuple[Bounds, list[Point]]:
        both = list(getattr(x, name))
        both[i] *= factor
        return x._replace(**{name: tuple(both)}), points

    return change


def of_points(n: int, i: int, factor: Fraction) -> Change:
    """Q or U of a point."""

    def change(x: Bounds, points: list[Point]) -> tuple[Bounds, list[Point]]:
        found = [list(point) for point in points]
        found[n][i] *= factor
        return x, [(Q, U) for Q, U in found]

    return change


LIES: dict[str, Change] = {
    "gamma": replaced(G=lambda G: 1 + (G - 1) * MUCH),
    "gamma-below-one": replaced(G=lambda _: LESS),
    "speed": replaced(w=lambda w: w * LESS),
    "no-speed": replaced(w=lambda w: -w),
    "largest-U": replaced(U_b=lambda U: U / 2),
    "U-of-one": replaced(U_b=lambda _: F(1)),
    "largest-z": replaced(z_b=lambda z: z * MUCH),
    "angle": replaced(Theta=lambda T: T * LESS),
    "angle-elsewhere": replaced(C_0=lambda C: C - F(1, 100)),
    "angle-beyond": replaced(C_0=lambda _: F(101, 100)),
    "time": replaced(E=lambda E: E * MUCH),
    "decay-ball": of_two("Y", 0, LESS),
    "decay-wall": of_two("Y", 1, LESS),
    "no-decay": of_two("Y", 1, F(10)),
    "decay-negative": of_two("Y", 0, F(-1)),
    "least-at-ball": of_two("k", 0, F(3)),
    "least-at-wall": of_two("k", 1, F(3)),
    "least-negative": of_two("k", 0, F(-1)),
    "first-Q": of_points(0, 0, MUCH),
    "first-U": of_points(0, 1, MUCH),
    "last-Q": of_points(-1, 0, F(1, 10)),
    "last-Q-above": of_points(-1, 0, F(2)),
    "last-U": of_points(-1, 1, F(0)),
    "last-U-above": of_points(-1, 1, F(2)),
}


@pytest.mark.parametrize("name", LIES)
def test_numbers_that_claim_more_are_refused(name: str) -> None:
    with balls.precision(200):
        found = search(pair(), state(), F(2))
        assert found is not None
        assert shows(*found, state(), balls.fmpq_of(F(2)))
        assert not shows(*LIES[name](*found), state(), balls.fmpq_of(F(2)))


STATES = {
    "a-wider-gap": {"d": F(1, 10)},
    "straight-away": {"eta": F(1, 10)},
    "sideways": {"C": F(1, 2)},
    "the-other-way": {"C": F(-99, 100)},
    "parting": {"y": F(-1, 100)},
    "into-the-wall": {"eta": F(-1, 500)},
    "in-contact": {"d": F(0)},
    "faster": {"A": F(4)},
}


@pytest.mark.parametrize("name", STATES)
def test_numbers_of_another_state_are_refused(name: str) -> None:
    with balls.precision(200):
        found = search(pair(), state(), F(2))
        assert found is not None
        other = state(**STATES[name])
        refused = find_wall(pair(), other) is None
        assert refused or not shows(*found, other, balls.fmpq_of(F(2)))


def test_a_large_ball_may_touch_the_wall() -> None:
    """Its direction has to be steeper than that in which it does."""
    with balls.precision(200):
        assert find_wall(pair(), state()) is not None
        assert find_wall(pair(F(98, 100)), state()) is not None
        assert find_wall(pair(F(99, 100)), state()) is None
