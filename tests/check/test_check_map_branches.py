"""Which collision the checker of maps takes for the next one: all cases of what is known.

A pair never meets (-1), may meet (0) or always meets (1). In each world that this allows, the one
collision that can come next has to be followed, or the checker has to refuse.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from itertools import product
from typing import Any

import pytest

from verify import check_map as m
from verify.check_map import INTERVALS, ONE, RefusedError, Sight, Three, Way

LAW = m.law_of(Fraction(1, 2))
CODES = (-1, 0, 1)
#: What may be true of a pair.
MEETS = {-1: [False], 0: [False, True], 1: [True]}


def sight(name: str) -> Sight:
    """A sight that the functions below know by its name."""
    return Sight(*[(ONE, ONE)] * 9, (name, name))  # type: ignore[arg-type]


def name_of(z: Sight) -> Any:
    return z.w[0]


def told(run: Callable[[], tuple[bool, list[Any]]]) -> tuple[bool, list[Any]] | None:
    try:
        return run()
    except RefusedError:
        return None


def next_ones(
    near: int, away: int, way: bool, seen: bool, far_apart: bool, own_apart: bool
) -> tuple[bool, set[str]] | None:
    """Whether there may be no collision, and which pairs may be next; None if that is open."""
    may_end, states = False, set()
    for first, second in product(MEETS[near], MEETS[away]):
        if not first and not second:
            may_end = True
            continue
        if first and second:
            found = "near" if way and far_apart else "far" if seen and own_apart else ""
        else:
            found = "near" if first else "far"
        if not {"near": way, "far": seen, "": False}[found]:
            return None
        states.add(found)
    return may_end, states


def test_the_next_collision_of_two_pairs(monkeypatch: pytest.MonkeyPatch) -> None:
    flags = (False, True)
    for near, away, way, seen, far_apart, own_apart in product(CODES, CODES, *[flags] * 4):
        far = Three((ONE, ONE), (7, 7), (ONE, ONE))
        own = Three((ONE, ONE), (9, 9), (ONE, ONE))
        ways = {"here": "near" if way else None, "there": "far" if seen else None}
        codes = {True: away, False: near}

        def seen_from(kind: m.Arithmetic, z: Sight, pair: Three, far: Three = far) -> Sight:
            assert (kind, name_of(z), pair) == (INTERVALS, "here", far)
            return sight("there")

        pairs = {"far": far, "own": own}
        for name, pair in pairs.items():
            of_here = {(INTERVALS, "here"): pair}
            monkeypatch.setattr(m, name, lambda kind, z, x=of_here: x[kind, name_of(z)])
        monkeypatch.setattr(m, "looks", lambda _, lam, *__, codes=codes: codes[lam == (-7, -7)])
        monkeypatch.setattr(m, "from_s", seen_from)
        monkeypatch.setattr(m, "way_of", lambda _, z, ways=ways: ways[name_of(z)])
        apart = {(far, "near"): far_apart, (own, "far"): own_apart}
        monkeypatch.setattr(m, "is_apart", lambda _, pair, to, apart=apart: apart[pair, to])
        monkeypatch.setattr(m, "collide", lambda _, z, to: (name_of(z), to))
        found = told(lambda: m.after(LAW, sight("here")))
        wanted = next_ones(near, away, way, seen, far_apart, own_apart)
        case = (near, away, way, seen, far_apart, own_apart)
        if wanted is None:
            assert found is None, case
            continue
        assert found is not None, case
        states = {"near": ("here", "near"), "far": ("there", "far")}
        assert found[0] == wanted[0], case
        assert sorted(found[1]) == sorted(states[name] for name in wanted[1]), case


def test_the_first_collision_of_three_pairs(monkeypatch: pytest.MonkeyPatch) -> None:
    """Each pair that can be the first is followed, or it is refused."""
    pairs = [Three((ONE, ONE), (-i, -i), (ONE, ONE)) for i in range(3)]
    places = [(i, j) for i in range(3) for j in range(3) if i != j]
    some = set()
    for meets, flags in product(product(CODES, repeat=3), product((False, True), repeat=6)):
        before = dict(zip(places, flags, strict=True))
        for missing in (None, 0, 1, 2):
            monkeypatch.setattr(m, "looks", lambda _, lam, *__, meets=meets: meets[lam[0]])
            monkeypatch.setattr(
                m, "way_of", lambda _, z, missing=missing: None if z == missing else z
            )
            monkeypatch.setattr(
                m, "is_apart",
                lambda _, pair, way, before=before: before[way, -pair.p[0]],
            )  # fmt: skip
            monkeypatch.setattr(m, "collide", lambda _, z, way, sig: (z, way, sig))
            found = told(lambda: m.first_after(LAW, pairs, lambda place: (place, 10 + place)))
            if found is None:
                # It is open which of two is the first, or whether one meets.
                known = all(
                    before[i, j] or before[j, i]
                    for i, j in places
                    if min(meets[i], meets[j]) >= 0 and missing not in (i, j)
                )
                some.add(known)
                assert not known or (missing is not None and meets[missing] >= 0)
                continue
            may_end, states = found
            assert may_end == (max(meets) < 1)
            assert all(
                (before[i, j] and i != missing) or (before[j, i] and j != missing)
                for i, j in places
                if min(meets[i], meets[j]) >= 0
            )
            assert all(state == (state[0], state[0], 10 + state[0]) for state in states)
            followed = [state[0] for state in states]
            assert all(meets[i] >= 0 for i in followed)
            assert len({*followed}) == len(followed)
            for world in product(*(MEETS[code] for code in meets)):
                there = [i for i in range(3) if world[i]]
                for i in there:
                    later = any((j, i) in before and before[j, i] and j != missing for j in there)
                    assert later or i in followed, (meets, before, missing, world)
            for i in followed:
                assert not any(
                    meets[j] > 0 and before[j, i] and not before[i, j] and missing not in (i, j)
                    for j in range(3)
                    if j != i
                )
    assert some == {False, True}


ZERO, WIDE = (0, 0), (-1, 1)


@pytest.mark.parametrize(
    ("g", "p", "m_", "wanted"),
    [
        ((0, 0), (0, 0), (1, 1), True),
        ((0, 0), (0, 0), (0, 0), False),
        ((0, 0), (0, 0), (0, 1), False),
        ((-1, 1), (5, 5), (5, 5), False),
        ((0, 1), (-1, 1), (5, 5), False),
        ((1, 1), (-1, 1), (2, 2), True),
        ((4, 4), (-3, -3), (3, 3), True),
        ((4, 4), (-3, -3), (2, 2), False),
        ((4, 4), (-4, -4), (5, 5), True),
        ((4, 4), (-5, -5), (9, 9), False),
    ],
)  # fmt: skip
def test_a_pair_is_apart_where_three_coefficients_are(
    g: m.Interval, p: m.Interval, m_: m.Interval, wanted: bool
) -> None:
    """Of g + 2 p t + m t² up to t = 1, then up to 2: g >= 0, g + p t >= 0, the last > 0."""

    def units(x: m.Interval, share: int = 1) -> m.Interval:
        return x[0] * ONE // share, x[1] * ONE // share

    one = (ONE, ONE)
    assert m.is_apart(INTERVALS, Three(*map(units, (g, p, m_))), Way(*[one] * 5)) is wanted
    to_2 = Way(one, (2 * ONE,) * 2, one, one, one)
    slower = Three(units(g), units(p, 2), units(m_, 4))
    assert m.is_apart(INTERVALS, slower, to_2) is wanted
    to_2 = Way(one, one, one, one, (2 * ONE,) * 2)
    assert m.is_apart(INTERVALS, slower, to_2) is wanted


@pytest.mark.parametrize(
    ("lam", "A", "eps", "wanted"),
    [
        ((0, 0), (1, 1), (0, 0), -1), ((-2, 0), (1, 1), (0, 0), -1), ((-1, 1), (1, 1), (2, 2), -1),
        ((1, 1), (1, 1), (1, 1), 0), ((-1, 1), (1, 1), (0, 0), 0), ((0, 2), (0, 0), (0, 0), 0),
        ((2, 2), (1, 1), (3, 3), 1), ((2, 3), (1, 1), (3, 4), 0), ((2, 3), (2, 2), (1, 1), 1),
        ((1, 2), (1, 1), (4, 5), 0), ((1, 2), (1, 1), (5, 6), -1), ((2, 2), (1, 2), (3, 3), 0),
        ((0, 2), (1, 1), (-1, -1), 0), ((1, 1), (1, 1), (0, 0), 1), ((1, 1), (1, 1), (-1, 0), 1),
    ],
)  # fmt: skip
def test_whether_a_pair_meets(lam: m.Interval, A: m.Interval, eps: m.Interval, wanted: int) -> None:
    """Where lam > 0 and lam² > A eps."""
    found = [(low * ONE, high * ONE) for low, high in (lam, A, eps)]
    assert m.looks(INTERVALS, *found) == wanted
    assert m.looks(m.MODELS, *map(m.flat, found)) == wanted


def test_spheres_that_overlap_or_touch_at_the_start() -> None:
    apart, touching = (ONE, ONE), (0, 0)
    none = Three(apart, (ONE, ONE), apart)
    sights: Callable[[int], Any] = lambda i: (i, i)  # noqa: E731
    assert m.first_after(LAW, [none] * 3, sights) == (True, [])
    touch = Three(touching, (ONE, ONE), apart)
    assert m.first_after(LAW, [touch, none, none], sights) == (True, [])
    for pairs, why in (
        ([none, Three((-1, ONE), (ONE, ONE), apart), none], "overlap"),
        ([touch, touch, none], "touch"),
        ([none, none, Three(touching, (ONE, ONE), (0, ONE))], "stay in contact"),
    ):
        with pytest.raises(RefusedError, match=why):
            m.first_after(LAW, pairs, sights)
    for rho, B, refused in (((0, ONE), (0, ONE), True), ((1, 1), (0, 0), False)):
        z = Sight(*[(ONE, ONE)] * 10)._replace(rho=rho, B=B, lam=(-ONE, -ONE))
        if refused:
            with pytest.raises(RefusedError, match="stay in contact"):
                m.after(LAW, z)
        else:
            m.after(LAW, z)


@pytest.mark.parametrize(
    ("told", "apart"), [(-1, False), (0, False), (0, True), (1, False), (1, True)]
)
def test_bounds_alone_tell_only_what_is_known(
    told: int, apart: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(m, "looks", lambda *_: told)
    monkeypatch.setattr(m, "is_apart", lambda *_: apart)
    z = Sight(*[(ONE, ONE)] * 10)
    assert m.is_plain(z, Way(*[(ONE, ONE)] * 5)) == (told < 0 or apart)
