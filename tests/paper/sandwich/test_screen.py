"""The screen in floats before the search of a stair rejects nothing that the search accepts."""

from __future__ import annotations

from fractions import Fraction
from random import Random

import pytest

from verify.spheres.flow import sandwich
from verify.spheres.flow.sandwich import Bounds, Point, Stair, above, find_stair

#: How many draws, and how near to each other the last two tried values of U are, relatively.
DRAWS, NEAR = 24, 2e-7


def searched(bounds: Bounds, at: Point) -> Stair | None:
    """What the search finds without the screen."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(sandwich, "may_close", lambda *_: True)
        return find_stair(bounds, at)


def edge(rng: Random) -> tuple[Bounds, Point] | None:
    """Bounds, and almost the highest point over a drawn Q from which the search finds a stair."""
    r, C = Fraction(rng.randint(1, 60), 1000), Fraction(rng.randint(700, 1000), 1000)
    G, w_1 = 1 + Fraction(1, 10**6), above(rng.uniform(0.2, 1))
    bounds = Bounds(r, G, Fraction(1), w_1, Fraction(9, 10), C, Fraction(1, 10**5))
    Q = above(10 ** rng.uniform(-3, -0.3))
    low, high = 1e-6, 0.6
    if searched(bounds, (Q, above(low))) is None:
        return None
    while high > low * (1 + NEAR):
        middle = (low * high) ** 0.5
        if searched(bounds, (Q, above(middle))) is None:
            high = middle
        else:
            low = middle
    return bounds, (Q, above(low))


def test_the_screen_rejects_no_stair(monkeypatch: pytest.MonkeyPatch) -> None:
    """Next to the highest points the screen accepts; one that asks for 30 % less rejects.

    This is how fine the test is: a screen that asks for 5 % less still rejects none of them.
    """
    rng = Random(26)
    found = [x for x in (edge(rng) for _ in range(DRAWS)) if x is not None]
    edges = [x for x in found if searched(*x) is not None]
    assert len(edges) >= DRAWS // 4
    assert all(find_stair(*x) is not None for x in edges)
    monkeypatch.setattr(sandwich, "TINY", -0.3)
    assert any(find_stair(*x) is None for x in edges)
