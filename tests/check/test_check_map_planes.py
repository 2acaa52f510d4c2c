"""What the checker of maps takes for the scenes of a box: all of them are in its numbers."""

from __future__ import annotations

import random
from fractions import Fraction
from typing import Any

import pytest

from tests.check.test_check_map_lies import plane
from verify import check_map as m
from verify.check_map import INTERVALS, MODELS, ONE, RefusedError

F = Fraction
PHI = m.plane_of(
    {
        "name": "phi", "r": "1/10", "neg_cos": "3/5", "speed": "1/7", "tangential": ["2/3", "-5/4"],
        "x": ["1/10", "2/5"], "y": ["1/20", "1/3"],
    }
)  # fmt: skip
Vector = tuple[Fraction, ...]


def dot(x: Vector, y: Vector) -> Fraction:
    return sum((a * b for a, b in zip(x, y, strict=True)), F(0))


def minus(x: Vector, y: Vector) -> Vector:
    return tuple(a - b for a, b in zip(x, y, strict=True))


def holds(found: Any, exact: Fraction, at: tuple[Fraction, Fraction] = (F(0), F(0))) -> bool:
    """Whether a number, an interval or a model, has a value at two parameters in [-1, 1]."""
    good = found[0] <= exact * ONE <= found[1]
    if len(found) > 2:
        x, y = at
        c0, c1, c2, c3, c4, c5, e = found[2:]
        near = c0 + c1 * x + c2 * y + c3 * x * x + c4 * x * y + c5 * y * y
        # The middle of a side is rounded to a unit.
        good = good and abs(near - exact * ONE) <= e + 40
    return good


def keys(rng: random.Random, level: int) -> str:
    return "".join(rng.choice("0123") for _ in range(level))


def place_in(key: str, ends: m.Side, axis: int, at: Fraction) -> Fraction:
    """The coordinate at a number from [-1, 1] in a box, by halving."""
    low, high = ends
    for digit in key:
        middle = (low + high) / 2
        low, high = (middle, high) if int(digit) >> axis & 1 else (low, middle)
    return (low + high) / 2 + at * (high - low) / 2


def at_random(rng: random.Random) -> tuple[Fraction, Fraction]:
    x, y = (rng.choice((F(-1), F(1), F(rng.randint(-9, 9), 10))) for _ in "xy")
    return x, y


@pytest.mark.parametrize("kind", [INTERVALS, MODELS])
def test_the_sides_of_a_box(kind: m.Arithmetic) -> None:
    rng = random.Random(1)
    for _ in range(300):
        key, at = keys(rng, rng.randint(1, 12)), at_random(rng)
        found = m._on_box(kind, PHI, key)
        for axis, ends in ((0, PHI.x), (1, PHI.y)):
            assert holds(found[axis], place_in(key, ends, axis, at[axis]), at)
            width = (ends[1] - ends[0]) / 2 ** len(key)
            assert found[axis][1] - found[axis][0] <= width * ONE + 2
        assert m.share_of(PHI, key) == F(1, 4 ** len(key))


@pytest.mark.parametrize("kind", [INTERVALS, MODELS])
def test_the_scenes_at_contact(kind: m.Arithmetic) -> None:
    """Their inner products are those of centres and velocities in the plane."""
    rng = random.Random(2)
    C, sine, v, (u_c, u_s) = F(3, 5), F(4, 5), PHI.speed, PHI.tangential
    begin = m.beginning(m.law_of(PHI.r, kind), PHI)
    for _ in range(300):
        key, at = keys(rng, rng.randint(3, 12)), at_random(rng)
        x, y = (place_in(key, (PHI.x, PHI.y)[axis], axis, at[axis]) for axis in (0, 1))
        # ω_s is to the right of ω_c; n is to the left of ω.
        w_c, n_c, w_s, n_s = (F(1), F(0)), (F(0), F(1)), (-C, -sine), (sine, -C)
        x_c, x_s = tuple((1 + y * v * v) * n for n in w_c), w_s
        W_c = tuple(-v * p + u_c * q for p, q in zip(w_c, n_c, strict=True))
        W_s = tuple(x * v * p + u_s * q for p, q in zip(w_s, n_s, strict=True))
        (found,) = begin(key)
        assert found is not None
        exact = {
            "v": v, "lam": -dot(x_c, W_c) / v, "rho": dot(x_s, W_s) / v,
            "eps": (dot(x_c, x_c) - 1) / v**2, "A": dot(W_c, W_c), "B": dot(W_s, W_s),
            "C": -dot(x_s, x_c), "a": dot(x_s, W_c), "b": dot(x_c, W_s), "w": dot(W_s, W_c),
        }  # fmt: skip
        for name, number in exact.items():
            assert holds(getattr(found, name), number, at), name
        apart, rates = minus(x_c, x_s), minus(W_c, W_s)
        pair = m.Three(dot(apart, apart) - 1, dot(apart, rates), dot(rates, rates))
        for one, number in zip(m.far(kind, found), pair, strict=True):
            assert holds(one, number, at)
        own = (exact["eps"] * v * v, dot(x_c, W_c), exact["A"])
        for one, number in zip(m.own(kind, found), own, strict=True):
            assert holds(one, number, at)


@pytest.mark.parametrize("kind", [INTERVALS, MODELS])
def test_the_tiles_of_a_strip(kind: m.Arithmetic) -> None:
    """Below the curve from f - δ down to 0, above it from f + δ up to the top."""
    rng, strip = random.Random(3), m.plane_of(plane("strip"))
    assert isinstance(strip, m.Strip)
    (left, right), top = strip.phi.x, strip.phi.y[1]
    half, seen = (right - left) / 8, set()
    for _ in range(600):
        key, at = keys(rng, rng.randint(2, 8)), at_random(rng)
        column = int("".join(str(int(d) & 1) for d in key[:2]), 2)
        row = int("".join(str(int(d) >> 1) for d in key[:2]), 2)
        bands = (strip.below, 1 - row) if row < 2 else (strip.above, row - 2)
        u_ends = bands[0][bands[1]], bands[0][bands[1] + 1]
        t = place_in(key[2:], (-half, half), 0, at[0])
        u = place_in(key[2:], u_ends, 1, at[1])
        c_0, c_1, c_2 = strip.curve[column]
        f = c_0 + c_1 * t + c_2 * t * t
        above = row >= 2
        y = (1 - u) * (f + strip.delta) + u * top if above else (1 - u) * (f - strip.delta)
        phi_1, phi_2 = m._on_tile(kind, strip, key)
        assert holds(phi_1, left + half * (2 * column + 1) + t, at)
        assert holds(phi_2, y, at)
        assert m.is_above(strip, key) == m.tile(strip, key).above == above
        seen.add((column, row))
    assert len(seen) == 16


def test_the_shares_of_tiles_add_up() -> None:
    strip = m.plane_of(plane("strip"))
    assert isinstance(strip, m.Strip)
    for level in (2, 3, 4):
        shares = [m.share_of(strip, m._key(i, level)) for i in range(4**level)]
        assert min(shares) > 0
        assert sum(shares) == 1 - 2 * strip.delta / strip.phi.y[1]
    below = sum(
        m.share_of(strip, m._key(i, 4)) for i in range(4**4) if not m.is_above(strip, m._key(i, 4))
    )
    half = (strip.phi.x[1] - strip.phi.x[0]) / 8
    curve = sum(2 * half * c_0 + c_2 * 2 * half**3 / 3 for c_0, _, c_2 in strip.curve)
    whole = 8 * half * strip.phi.y[1]
    assert below == curve / whole - strip.delta / strip.phi.y[1]


@pytest.mark.parametrize("kind", [INTERVALS, MODELS])
def test_the_scenes_of_a_file(kind: m.Arithmetic) -> None:
    """Each pair is seen with its own inner products, and the third sphere too."""
    rng = random.Random(4)
    for round_ in range(60):
        rows = {
            name: [[F(rng.randint(-30, 30), 7) for _ in range(3)] for _ in range(3)]
            for name in ("positions", "velocities")
        }
        (one, i, k), (two, j, n) = rng.sample(
            [(name, i, k) for name in rows for i in range(3) for k in range(3)], 2
        )
        document = {
            "name": "scene", "r": "1/2",
            **{name: [[str(x) for x in row] for row in found] for name, found in rows.items()},
            "x_at": f"{one}[{i}][{k}]", "y_at": f"{two}[{j}][{n}]",
            "x": ["-3", "5"], "y": ["2", "7/2"],
        }  # fmt: skip
        through = m.plane_of(document)
        assert isinstance(through, m.Through)
        key, at = keys(rng, 1 + round_ % 9), at_random(rng)
        rows[one][i][k] = place_in(key, (F(-3), F(5)), 0, at[0])
        rows[two][j][n] = place_in(key, (F(2), F(7, 2)), 1, at[1])
        products = [m._products(kind, through, place) for place in m.PAIRS]
        varied = m._varied(kind, through, *m._on_box(kind, through, key))
        pairs, sight = m._scenes(kind, products, varied)
        for place, (o, c, s) in enumerate(m.PAIRS):
            assert {o, c, s} == {0, 1, 2}
            x_c, x_s, W_c, W_s = (
                minus(tuple(rows[name][other]), tuple(rows[name][o]))
                for name in ("positions", "velocities")
                for other in (c, s)
            )
            exact = (dot(x_c, x_c) - 1, dot(x_c, W_c), dot(W_c, W_c))
            for found, number in zip(pairs[place], exact, strict=True):
                assert holds(found, number, at)
            seen, sig = sight(place)
            values = {
                "v": F(1), "lam": -dot(x_c, W_c), "rho": dot(x_s, W_s), "eps": exact[0],
                "A": exact[2], "B": dot(W_s, W_s), "C": -dot(x_s, x_c), "a": dot(x_s, W_c),
                "b": dot(x_c, W_s), "w": dot(W_s, W_c),
            }  # fmt: skip
            for name, number in values.items():
                assert holds(getattr(seen, name), number, at), name
            assert holds(sig, dot(x_s, x_s) - 1, at)


def test_the_same_moment_seen_from_the_other_sphere() -> None:
    """From s the spectator is o; a unit of speed is 1 then."""
    rng = random.Random(5)
    for _ in range(100):
        x_c, W_c, W_s = (tuple(F(rng.randint(-30, 30), 7) for _ in range(3)) for _ in "abc")
        x_s = (F(2, 7), F(3, 7), F(6, 7))  # s is in contact with o
        z = sight_of(x_c, x_s, W_c, W_s, F(1, 3))
        pair = m.far(INTERVALS, z)
        found = m.from_s(INTERVALS, z, pair)
        o = tuple(-n for n in x_s)
        other = minus(x_c, x_s)
        wanted = sight_of(other, o, minus(W_c, W_s), tuple(-n for n in W_s), F(1))
        for name, number in wanted._asdict().items():
            low, high = getattr(found, name)
            assert low <= number[1]
            assert number[0] <= high
            assert high - low < 1 << 14


def sight_of(x_c: Vector, x_s: Vector, W_c: Vector, W_s: Vector, v: Fraction) -> m.Sight:
    values = (
        v, -dot(x_c, W_c) / v, dot(x_s, W_s) / v, (dot(x_c, x_c) - 1) / v**2, dot(W_c, W_c),
        dot(W_s, W_s), -dot(x_s, x_c), dot(x_s, W_c), dot(x_c, W_s), dot(W_s, W_c),
    )  # fmt: skip
    return m.Sight(*map(m.around, values))


@pytest.mark.parametrize("is_first", [False, True])
def test_a_collision_is_the_law_for_vectors(is_first: bool) -> None:
    """Exactly, where the time of the collision is rational."""
    rng, r, done = random.Random(6), F(3, 10), 0
    law = m.law_of(r)
    unit = (F(2, 7), F(3, 7), F(6, 7))
    other = (F(6, 7), F(2, 7), F(-3, 7))
    while done < 60:
        time, v = F(rng.randint(1, 9), 5), F(rng.randint(1, 5), 3)
        W_c, W_s = (tuple(F(rng.randint(-9, 9), 5) for _ in range(3)) for _ in "ab")
        x_s = tuple(n * F(5, 4) for n in other) if is_first else other
        x_c = tuple(p - time * q for p, q in zip(unit, W_c, strict=True))
        if dot(unit, W_c) >= 0 or dot(x_c, W_c) >= 0 or dot(x_c, x_c) <= 1 or dot(x_s, W_s) <= 0:
            continue
        z = sight_of(x_c, x_s, W_c, W_s, v)
        way = m.way_of(INTERVALS, z)
        assert way is not None
        assert holds(way.y, -dot(x_c, W_c))
        flown = m.mul(way.y, way.T)
        assert near(flown, time)
        sig = m.around((dot(x_s, x_s) - 1) / v**2) if is_first else None
        found = m.collide(law, z, way, sig)
        # Now c touches o, along `unit`; o gets half the impulse, and everything is seen from o.
        normal = dot(unit, W_c)
        push = tuple((1 + r) / 2 * normal * n for n in unit)
        at_s = tuple(p + time * q for p, q in zip(x_s, W_s, strict=True))
        W_c_after = minus(W_c, tuple(2 * n for n in push))
        exact = sight_of(at_s, unit, minus(W_s, push), W_c_after, -dot(x_c, W_c))
        for name, number in exact._asdict().items():
            assert near(getattr(found, name), F(number[0], ONE)), (name, done)
        done += 1


def near(found: m.Interval, exact: Fraction) -> bool:
    """Around a number, and not wider than the roundings are."""
    return found[0] - 1 <= exact * ONE <= found[1] + 1 and found[1] - found[0] < ONE >> 60


def test_a_flight_has_bounds() -> None:
    one, zero = (ONE, ONE), (0, 0)
    z = m.Sight(*[one] * 10)
    never = z._replace(lam=(-ONE, 0))
    assert m.way_of(INTERVALS, never._replace(eps=(-ONE, 0))) is None
    assert m.way_of(INTERVALS, never._replace(A=(-5, ONE))) is None
    assert m.way_of(INTERVALS, z._replace(lam=(-ONE, ONE), A=(-5, ONE))) is None
    assert m.way_of(INTERVALS, z._replace(lam=(-ONE, ONE), eps=(-5, ONE))) is None
    found = m.way_of(INTERVALS, z._replace(lam=(-ONE, 2 * ONE), A=(4 * ONE, 5 * ONE)))
    assert found is not None
    assert found.lam == (2 * ONE, 2 * ONE)
    grazing = m.way_of(INTERVALS, z)
    assert grazing is not None
    assert grazing.s[0] == 0
    assert grazing.s[1] <= 1 + m.isqrt(ONE) * 4
    straight = m.way_of(INTERVALS, z._replace(eps=zero))
    assert straight is not None
    assert straight.T[0] == 0
    with pytest.raises(RefusedError):
        m.div(one, zero)
