"""Families of scenes: terms, random points, and the interval of a share."""

from __future__ import annotations

from fractions import Fraction
from math import comb

import pytest

from verify.spheres.scene.families import Family, read_family
from verify.spheres.scene.sampling import draw, is_rare, share_between
from verify.wire.inputs import InputError

TEXT = """r = "0.01..0.08"
positions = [[0, "0"], [1.002, "0"], ["-1.004 - (h + 1)*0", "h**2 + 1/3"]]
velocities = [["0", 0], ["-1.5", "0"], ["0.8", "-v - h/2"]]
[parameters]
h = "0..0.1"
v = "-0.2..0.2"
"""


def family(text: str = TEXT) -> Family:
    return read_family("f", text.encode())


def test_terms_are_exact() -> None:
    found = family()
    assert list(found.sides) == ["h", "r", "v"]
    assert found.sides["r"] == (Fraction(1, 100), Fraction(2, 25))
    at = {"h": Fraction(1, 10), "v": Fraction(1, 7), "r": Fraction(3, 100)}
    scene = found.at(at)
    assert scene.r == Fraction(3, 100)
    assert scene.positions[2] == (Fraction(-251, 250), Fraction(1, 100) + Fraction(1, 3))
    assert scene.velocities[2] == (Fraction(4, 5), Fraction(-1, 7) - Fraction(1, 20))


@pytest.mark.parametrize("name", ["e", "E", "pi", "inf", "nan"])
def test_a_parameter_may_have_the_name_of_a_number(name: str) -> None:
    text = TEXT.replace("h**2 + 1/3", name) + f'{name} = "0..1"\n'
    at = {"h": Fraction(0), "v": Fraction(0), "r": Fraction(1, 50), name: Fraction(1, 3)}
    assert family(text).at(at).positions[2][1] == Fraction(1, 3)


@pytest.mark.parametrize(
    ("old", "new", "why"),
    [
        ('h = "0..0.1"', 'h = "0.1..0"', "is not A < B"),
        ('h = "0..0.1"', "h = 0.1", "is no interval"),
        ('h = "0..0.1"', 'h = "0..0.1"\nw = "0..1"', "the parameter w does not occur"),
        ('h = "0..0.1"', 'h = "0..0.1"\n"a b" = "0..1"', "is no name"),
        ('h = "0..0.1"', 'h = "0..0.1"\nr = "0..1"', "write it at the top"),
        ('h = "0..0.1"', 'h = "0..0.1"\npositions = "0..1"', "write another name"),
        ('h = "0..0.1"', 'h = "0..0.1"\nlambda = "0..1"', "write another name"),
        ('h = "0..0.1"', 'h = "0..0.1"\n"ｈ" = "0..1"', "is no name"),
        ('h = "0..0.1"', 'h = "0..0.1"\nh = "0..1"', "stands there twice"),
        # what Python's reader takes away, or takes for something else
        ("h**2", "h # + 1", "'#' is not known"),
        ("h**2", "ｈ", "'ｈ' is not known"),
        ("h**2", "ℎ", "'ℎ' is not known"),
        ("h**2", "h + ²", "'²' is not known"),
        ("h**2", "h + 'a'", "is not known"),
        ("h**2", "h**0x2", "whole power"),
        ("h**2", "h**1_0", "whole power"),
        ("h**2", "h**True", "whole power"),
        ("h**2", "h + True", "is not an exact number"),
        ("h**2", "h + 1_0", "is not an exact number"),
        ("h**2", "h*inf", "is no term"),
        ("h**2", "h**h", "whole power"),
        ("h**2", "(h**20)**20", ""),
        ("h**2", "((((h**20)**20)**20)**20)", "too long"),
        ("h**2", "h.real", "is no term"),
        ("h**2", "f(h)", "is no term"),
        ("h**2", "k", "is no term"),
        ("h**2", "h//2", "is no term"),
        ("h**2", "h +", "is no term"),
        ("h**2", "(" * 400 + "h", "is no term"),
        ("h**2", "h/(h-h)", "divides by zero"),
        ("h**2", "h + 0x10", "is not an exact number"),
        ("h**2", "h" + "+h" * 400, "letters"),
    ],
)
def test_what_is_no_family_is_said(old: str, new: str, why: str) -> None:
    point = {"h": Fraction(1, 10), "v": Fraction(0), "r": Fraction(3, 100)}
    if not why:
        assert family(TEXT.replace(old, new)).at(point).positions[2][1] < 1
        return
    with pytest.raises(InputError, match=why):
        family(TEXT.replace(old, new)).at(point)


@pytest.mark.parametrize("top", ["", "r = 0.03\n"])
def test_r_below_the_parameters_is_sent_to_the_top(top: str) -> None:
    text = top + TEXT.partition("\n")[2] + 'r = "0.01..0.09"\n'
    with pytest.raises(InputError, match=r"f: r: stands below \[parameters\]; write it at the top"):
        family(text)


def test_points_depend_on_the_seed_alone() -> None:
    first, again, other = (list(draw(family(), 5, seed)) for seed in (1, 1, 2))
    assert first == again
    assert first != other
    for point in first:
        assert all(low < point.values[name] < high for name, (low, high) in family().sides.items())


def test_points_where_particles_overlap_are_left_out_and_counted() -> None:
    text = TEXT.replace("[1.002,", '["0.5 + 10*h",')
    points = list(draw(family(text), 40, 3))
    assert 15 < points[-1].left_out < 90
    assert all(point.values["h"] >= Fraction(1, 20) for point in points)
    with pytest.raises(InputError, match="overlap at 1000 points in a row"):
        list(draw(family(TEXT.replace("[1.002,", '["0.5 + h",')), 1, 1))


def tail(count: int, seen: int, p: Fraction) -> Fraction:
    return sum(
        (comb(count, i) * p**i * (1 - p) ** (count - i) for i in range(seen, count + 1)),
        Fraction(0),
    )


@pytest.mark.parametrize(("count", "seen"), [(1, 1), (10, 3), (60, 59), (40, 40), (50, 1)])
def test_an_interval_is_as_exact_fractions_say(count: int, seen: int) -> None:
    alpha, step = Fraction(1, 20), Fraction(1, 2**24)
    low, high = share_between(count, seen, seen, alpha)
    assert tail(count, seen, low) <= alpha / 2 < tail(count, seen, low + step)
    if seen == count:
        assert high == 1
    else:
        other = tail(count, count - seen, 1 - high)
        assert other <= alpha / 2 < tail(count, count - seen, 1 - high + step)
    assert not is_rare(count, seen, low + step, alpha / 2)


def test_an_interval_leaves_room_for_what_is_undecided() -> None:
    alpha = Fraction(1, 100)
    assert share_between(100, 0, 100, alpha) == (0, 1)
    low, high = share_between(100, 40, 45, alpha)
    assert low == share_between(100, 40, 40, alpha)[0]
    assert high == share_between(100, 45, 45, alpha)[1]


def test_many_points_are_not_much_work() -> None:
    low, high = share_between(10**5, 30_000, 30_000, Fraction(1, 1000))
    assert Fraction(295, 1000) < low < Fraction(3, 10) < high < Fraction(305, 1000)
