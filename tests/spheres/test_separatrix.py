"""The separatrix agrees with an independent bisection, and points near it do what it says."""

from __future__ import annotations

import inspect
import json
import random
from collections.abc import Callable
from fractions import Fraction
from itertools import pairwise
from pathlib import Path
from textwrap import dedent
from typing import Any

import pytest
from mpmath import mp, mpf

from verify.prover import balls
from verify.spheres import limit_cycle, limit_map, separatrix
from verify.spheres.limit_map import Allowance, Curve, Orbits, Parameters

ROOT = Path(__file__).resolve().parents[2]
F = Fraction
AT_3_100 = Parameters(F(3, 100), F(1), F(1))
STEPS = 2 * 10**6


def curve(parameters: Parameters, steps: int = STEPS) -> Curve:
    return Curve(parameters, Allowance(steps))


# --- the map once more, as the text has it --------------------------------------------------------


def letters(parameters: Parameters) -> tuple[mpf, mpf, mpf]:
    """r, a and ρ from what a collision does to normal speeds, in the digits of mpmath."""
    r, c, ratio = (mpf(x.numerator) / x.denominator for x in parameters[:3])
    (m0, m1, m2), (r0, r1, r2) = (
        [mpf(x.numerator) / x.denominator for x in each] for each in parameters[3:]
    )
    last, after = ((1 + r) * m / (m0 + m) for m in (m1, m2))
    return r, c * mp.sqrt(last * after), ratio * (r0 + r2) / (r0 + r1) * mp.sqrt(last / after)


def goes_on(parameters: Parameters, q: Fraction, u: mpf, most: int = 4000) -> bool | None:
    """Whether the collisions go on, by the map in 60 digits; None where that is not seen."""
    r, a, rho = letters(parameters)
    x, before = mpf(q.numerator) / q.denominator, u
    for _ in range(most):
        p = a * (1 - u) - x - rho * u
        if p <= 0 or rho * u * (2 * x + rho * u) >= p**2:
            return False
        x, u, rho = r * (1 - u) / p, 1 - mp.sqrt(1 - rho * u * (2 * x + rho * u) / p**2), 1 / rho
        if u < before * mpf(10) ** -6:
            return True
    return None


def bisected(parameters: Parameters, q: Fraction) -> tuple[mpf, mpf]:
    """f(q) by halving, without any care for rounding but 60 digits."""
    low, high = mpf(0), mpf(1)
    for _ in range(2000):
        middle = (low + high) / 2 if low else high / 4
        does = goes_on(parameters, q, middle)
        if does is None or (low and high - low < low * mpf(10) ** -35):
            break
        low, high = (middle, high) if does else (low, middle)
    return low, high


def samples(count: int, seed: int) -> list[tuple[Parameters, Fraction]]:
    """Parameters decades apart, some next to the threshold and some q next to phi_plus."""
    chosen, found = random.Random(seed), []
    while len(found) < count:
        r = F(chosen.randrange(10**5, 10**6), 10**6) / 10 ** chosen.randrange(1, 6)
        ratio = F(chosen.randrange(1, 1000), 100) * F(10) ** chosen.randrange(-3, 3)
        s = F(float(r) ** (1 / 3))
        least = 2 * (s + s * s) / (1 + r)
        share = chosen.choice([F(1, 50), F(1, 10), F(1, 2), F(1)])
        c = F(int((least + (1 - least) * share) * 10**6), 10**6)
        if not 0 < c <= 1 or r > F(1, 20):
            continue
        parameters = Parameters(r, c, ratio)
        if separatrix.has_separatrix(parameters):
            (low, _), _ = reversed(limit_map.fixed_points(parameters, 64))
            share = chosen.choice([F(0), F(1, 10), F(1, 2), F(9, 10), F(99, 100)])
            found.append((parameters, F(int(low * share * 10**9), 10**9)))
    return found


#: A few: in test_separatrix_orbits.py orbits part at the enclosure at 200 points, with more digits.
@pytest.mark.parametrize(("parameters", "q"), samples(8, 26))
def test_it_agrees_with_an_independent_bisection(parameters: Parameters, q: Fraction) -> None:
    strip = curve(parameters).strip(q, 30)
    assert strip.reached
    with mp.workdps(60):
        low, high = bisected(parameters, q)
        assert high - low < low * mpf(10) ** -28
        assert mpf(strip.low.numerator) / strip.low.denominator <= high
        assert low <= mpf(strip.high.numerator) / strip.high.denominator


@pytest.mark.parametrize(("parameters", "q"), samples(40, 27))
def test_points_near_the_strip_do_what_it_says(parameters: Parameters, q: Fraction) -> None:
    strip = curve(parameters).strip(q, 12)
    with mp.workdps(60):
        low, high = (mpf(end.numerator) / end.denominator for end in (strip.low, strip.high))
        for exponent in (9, 6, 3):
            assert goes_on(parameters, q, low * (1 - mpf(10) ** -exponent)) is True
            assert goes_on(parameters, q, high * (1 + mpf(10) ** -exponent)) is False


def test_a_known_value() -> None:
    strip = curve(AT_3_100).strip(F(1, 10), 30)
    assert F(517785628, 10**10) - F(1, 10**10) < strip.low <= strip.high < F(517785629, 10**10)
    assert (strip.high - strip.low) * 10**30 <= strip.low


def test_the_border_of_the_committed_map_lies_a_little_below_the_curve() -> None:
    """The closing speed of that map is 1/100; the curve is the limit of its border."""
    with (ROOT / "certificates/map/strip/map.jsonl").open(encoding="utf-8") as log:
        plane = json.loads(log.readline())["plane"]
    assert (plane["x"][0], plane["speed"], plane["r"], plane["neg_cos"]) == (
        "1/100", "1/100", "3/100", "1",
    )  # fmt: skip
    border = Fraction(plane["curve"][0][0])
    u = curve(AT_3_100).strip(F(1, 100), 12).low
    limit = u * (2 - u) / 2
    assert Fraction(98, 100) < border / limit < Fraction(99, 100)
    page = (ROOT / "docs/explanation/separatrix.md").read_text(encoding="utf-8")
    assert f"{float(border):.4f}" in page
    assert f"{float(limit):.4f}" in page


def test_200_digits() -> None:
    long, short = (curve(AT_3_100).strip(F(1, 10), digits) for digits in (200, 30))
    assert long.reached
    assert short.low <= long.high
    assert long.low <= short.high
    assert 0 < (long.high - long.low) * 10**200 <= long.low


def test_it_decreases_and_is_convex() -> None:
    strips = [curve(AT_3_100).strip(F(k, 20), 12) for k in range(9)]
    assert all(right.high < left.low for left, right in pairwise(strips))
    for left, middle, right in zip(strips, strips[1:], strips[2:], strict=False):
        assert 2 * middle.high < left.low + right.low


# --- the conditions -------------------------------------------------------------------------------


@pytest.mark.parametrize("s", [F(1, 10), F(1, 5), F(37, 100)])
def test_the_threshold_is_strict(s: Fraction) -> None:
    """At a = s + s² there is none, and a hair above there is one."""
    r = s**3
    c = 2 * (s + s * s) / (1 + r)
    assert separatrix.has_separatrix(Parameters(r, c, F(1))) is False
    assert separatrix.has_separatrix(Parameters(r, c * (1 - F(1, 10**30)), F(1))) is False
    assert separatrix.has_separatrix(Parameters(r, c * (1 + F(1, 10**30)), F(1))) is True


@pytest.mark.parametrize("r", [F(6, 100), F(1, 2), F(99, 100)])
def test_there_is_none_for_large_r(r: Fraction) -> None:
    assert separatrix.has_separatrix(Parameters(r, F(1), F(1))) is False


def test_it_is_zero_from_phi_plus_on() -> None:
    """At r = 1/20 phi_plus is 2/5 exactly, and phi_minus 1/8."""
    parameters = Parameters(F(1, 20), F(1), F(3))
    assert limit_map.fixed_points(parameters, 64) == ((F(1, 8), F(1, 8)), (F(2, 5), F(2, 5)))
    for q in (F(2, 5), F(1, 2), F(10)):
        assert curve(parameters).strip(q, 12)[1:3] == (0, 0)
    just_below = curve(parameters).strip(F(2, 5) - F(1, 10**6), 12)
    assert just_below.reached
    assert 0 < just_below.low < just_below.high < F(1, 10**6)


# --- two steps in order ---------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("before", "after", "found"),
    [
        ((2, 2), (1, 1), -1),
        ((2, 2), (2, 1), -1),
        ((2, 2), (2, 2), -1),
        ((2, 2), (1, 3), 0),
        ((2, 2), (3, 1), 0),
        ((2, 2), (3, 2), 1),
        ((0, 2), (0, 3), 1),
        ((1, 0), (2, 0), 0),
        ((-1, 1), (2, 2), 0),
    ],
)
def test_the_direction(before: tuple[int, int], after: tuple[int, int], found: int) -> None:
    one, other = ((F(q, 7), F(u, 7)) for q, u in (before, after))
    assert limit_map.direction(one, other) == found


def near_threshold(seed: str, distance: Fraction) -> tuple[Parameters, Fraction]:
    """Parameters of which a exceeds s + s² by a factor that is 1 plus about this distance."""
    rng = random.Random(seed)
    s = F(rng.randint(100, 380), 1000)
    ratio = F(rng.choice((1, 2, 10, 1000)), rng.choice((1, 3, 100)))
    neg_cos = 2 * (s + s**2) / (1 + s**3) * (1 + distance)
    return Parameters(s**3, neg_cos, ratio), F(rng.randint(0, 99), 100) * s


@pytest.mark.parametrize("power", [2, 5, 10, 30, 100])
def test_next_to_the_threshold_few_collisions_decide(power: int) -> None:
    """Their number grows as the number of digits of the distance does."""
    for seed in range(5):
        budget = Allowance(10000 + 1000 * power)
        parameters, q = near_threshold(f"{power} {seed}", F(1, 10**power))
        strip = Curve(parameters, budget).strip(q, 14)
        assert strip.reached
        assert 0 < strip.high - strip.low <= strip.low / 10**14
        assert not limit_map.has_separatrix(near_threshold(f"{power} {seed}", F(0))[0])


def part(parameters: Parameters, q: Fraction, u: mpf) -> int:
    """-1 once two collisions make q and u smaller; 1 once both grow, or no collision follows."""
    r, a, rho = letters(parameters)
    states = [(mpf(q.numerator) / q.denominator, u)]
    while True:
        x, u = states[-1]
        p = a * (1 - u) - x - rho * u
        if p <= 0 or rho * u * (2 * x + rho * u) >= p**2:
            return 1
        states.append((r * (1 - u) / p, 1 - mp.sqrt(1 - rho * u * (2 * x + rho * u) / p**2)))
        rho = 1 / rho
        signs = {int(mp.sign(y - z)) for y, z in zip(states[-1], states[-3:][0], strict=True)}
        if len(states) > 2 and len(signs) == 1 and 0 not in signs:
            return signs.pop()


def test_hard_points_agree_with_plain_digits() -> None:
    hard = [(Parameters(F("0.05572799"), F(1), F("1.872")), F("0.129221"))]
    hard += [near_threshold(str(seed), F(1, 10**9)) for seed in range(5)]
    with mp.workdps(90):
        for parameters, q in hard:
            strip = curve(parameters, 10**5).strip(q, 18)
            low, high = (mpf(end.numerator) / end.denominator for end in (strip.low, strip.high))
            assert part(parameters, q, low * (1 - mpf(10) ** -25)) == -1
            assert part(parameters, q, high * (1 + mpf(10) ** -25)) == 1


def test_next_to_the_threshold_there_is_a_cycle() -> None:
    parameters, _ = near_threshold("cycle", F(1, 10**9))
    assert len(limit_cycle.cycle(curve(parameters, 10**5), 14)) == 4


# --- the cycle ------------------------------------------------------------------------------------


@pytest.mark.parametrize("ratio", [F(1), F(7), F(1, 1000)])
@pytest.mark.parametrize("digits", [12, 60])
def test_the_cycle_is_one_and_on_the_curve(ratio: Fraction, digits: int) -> None:
    parameters = AT_3_100._replace(ratio=ratio)
    found = limit_cycle.cycle(curve(parameters), digits)
    with balls.precision(400):
        (q, q_above), (u, u_above), *after = map(balls.ends, found)
    assert 0 < (u_above - u) * 10**digits <= u
    above, below = (curve(parameters).strip(end, 12) for end in (q, q_above))
    assert below.low <= u_above
    assert u <= above.high
    with mp.workdps(80):
        r, a, rho = mpf("0.03"), mpf("0.515"), mpf(ratio.numerator) / ratio.denominator
        start = x, v = mpf(q.numerator) / q.denominator, mpf(u.numerator) / u.denominator
        for w in (rho, 1 / rho):
            p = a * (1 - v) - x - w * v
            x, v = r * (1 - v) / p, 1 - mp.sqrt(1 - w * v * (2 * x + w * v) / p**2)
            if w is rho:
                for value, (low, high) in zip((x, v), after, strict=True):
                    assert abs(mpf(low.numerator) / low.denominator - value) < mpf(10) ** -digits
                    assert 0 < (high - low) * 10**digits <= low
                assert (after[0][0] <= q_above and q <= after[0][1]) == (ratio == 1)
        assert abs(x - start[0]) < mpf(10) ** (-digits)
        assert abs(v - start[1]) < mpf(10) ** (-digits)


def test_for_equal_speeds_the_cycle_is_the_root_of_a_cubic() -> None:
    """P³ + (a+1) p² - (a+r) p - r = 0, with q = r (1-u)/p."""
    found = limit_cycle.cycle(curve(AT_3_100), 40)
    with balls.precision(300):
        q, u, *after = found
        assert all(ball.overlaps(other) for ball, other in zip((q, u), after, strict=True))
        r, a = balls.from_fraction(AT_3_100.r), limit_map.root(AT_3_100.square_a)
        p = r * (1 - u) / q
        value = ((p + a + 1) * p - (a + r)) * p - r
        assert abs(value) < 1e-38


# --- what is noticed, and what is not said --------------------------------------------------------


def _image(change: str) -> Callable[[Orbits, Any, Any], Any]:
    """The step of the map with a slip in it."""
    source = dedent(inspect.getsource(Orbits.image))
    old, new = change.split(" -> ")
    assert source.count(old) == 1
    names: dict[str, Any] = {"Ball": balls.Ball, "Point": limit_map.Point}
    exec(source.replace(old, new), names)
    image: Callable[[Orbits, Any, Any], Any] = names["image"]
    return image


@pytest.mark.parametrize(
    "change",
    [
        "1 - u, ratio * u -> 1 + u, ratio * u",
        "1 - u, ratio * u -> 1 - u, u / ratio",
        "1 - u, ratio * u -> 1 - u, u",
        "self.a * rest - q - product -> self.a * rest - q",
        "self.a * rest - q - product -> self.a * rest - q + product",
        "(2 * q + product) -> (q + product)",
        "(2 * q + product) -> 2 * q",
        "self.r * rest / p -> self.r / p",
        "self.r * rest / p -> rest / p",
        "h / (1 + (1 - h).sqrt()) -> h / 2",
        "h / (1 + (1 - h).sqrt()) -> h",
    ],
)
def test_a_slip_in_the_map_is_noticed(change: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """The value is not the one of the bisection any more."""
    parameters, q = AT_3_100._replace(ratio=F(2)), F(1, 10)
    with mp.workdps(60):
        low, high = bisected(parameters, q)
        monkeypatch.setattr(Orbits, "image", _image(change))
        strip = curve(parameters, 10**5).strip(q, 9)
        ends = [mpf(end.numerator) / end.denominator for end in (strip.low, strip.high)]
        assert high < ends[0] or ends[1] < low or not strip.reached


@pytest.mark.parametrize(("wrong", "right"), [("upper", "lower"), ("lower", "upper")])
def test_rounding_to_the_wrong_side_is_noticed(
    wrong: str, right: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """At few bits points are then said to lie on the wrong side."""
    strip = curve(AT_3_100).strip(F(1, 10), 40)
    source = dedent(inspect.getsource(Orbits._followed))
    state = "(q.{0}(), u.{0}())"
    assert source.count(state.format(right)) == 1
    names: dict[str, Any] = {**vars(limit_map)}
    exec(source.replace(state.format(right), state.format(wrong)), names)
    is_up = right == "upper"
    followed = names["_followed"]

    def alone(self: Orbits, state: limit_map.Point, *, up: bool) -> int:
        return followed(self, state, up=up) if up == is_up else 0

    monkeypatch.setattr(Orbits, "_followed", alone)
    says, inside = (-1, strip.high) if is_up else (1, strip.low)
    found = set()
    for bits in range(12, 40):
        for k in range(4, 14):
            u = inside * (1 - says * F(1, 10**k))
            found.add(curve(AT_3_100).orbits(bits).side(F(1, 10), u))
    assert says in found


def test_a_point_is_never_on_both_sides() -> None:
    """At few bits nothing wrong is said of points next to the curve."""
    strip = curve(AT_3_100).strip(F(1, 10), 40)
    orbits = {bits: curve(AT_3_100).orbits(bits) for bits in (16, 24, 32, 53, 80)}
    for k in range(2, 39):
        for bits in orbits:
            assert orbits[bits].side(F(1, 10), strip.high * (1 + F(1, 10**k))) in (0, 1)
            assert orbits[bits].side(F(1, 10), strip.low * (1 - F(1, 10**k))) in (0, -1)
    assert orbits[16].side(F(1, 10), strip.high * (1 + F(1, 10**30))) == 0


def test_a_judge_that_decides_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Orbits, "side", lambda *_: 0)
    found = separatrix.decide_separatrix(AT_3_100, F(1, 10), 12, STEPS)
    assert (found.verdict, found.exit_code) == ("undecided", 3)
    assert found.strips[0].low == 0
    assert found.strips[0].high >= F(515, 1515)


def test_a_budget_is_kept() -> None:
    """Near the threshold orbits take long; what was reached is still an enclosure."""
    budget = Allowance(200)
    strip = Curve(AT_3_100, budget).strip(F(1, 10), 30)
    assert not strip.reached
    assert budget.left == 0
    assert 0 < strip.low < curve(AT_3_100).strip(F(1, 10), 12).high
    assert strip.high > curve(AT_3_100).strip(F(1, 10), 12).low


def test_a_number_on_the_curve_is_only_enclosed() -> None:
    """A dyadic point that cannot be told apart from the curve is left for another one."""
    asked: list[Fraction] = []
    work = curve(AT_3_100)
    honest = work._side

    def unclear_once(q: Fraction, u: Fraction, bits: int) -> int:
        asked.append(u)
        return 0 if len(asked) % 7 == 0 else honest(q, u, bits)

    work._side = unclear_once  # type: ignore[method-assign]
    strip, other = work.strip(F(1, 10), 12), curve(AT_3_100).strip(F(1, 10), 12)
    assert strip.reached
    assert strip.low <= other.high
    assert other.low <= strip.high
