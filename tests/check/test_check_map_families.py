"""Families of scenes in a log: terms, r as a parameter, lines, intervals."""

from __future__ import annotations

import random
from fractions import Fraction
from itertools import product
from typing import Any

import pytest

from tests.check.test_check_map import sealed
from verify import check_map
from verify.check_map import INTERVALS, MODELS, ONE, Family, LogError, RefusedError, Run

F = Fraction
LINE: dict[str, Any] = {
    "name": "family", "r": "x",
    "positions": [["0", "0"], ["2", "0"], ["-5/2", "0"]],
    "velocities": [["0", "0"], ["-1", "0"], ["1", "0"]],
    "axes": ["r"], "x": ["1/20", "3/50"],
}  # fmt: skip
PLANE = {**LINE, "axes": ["r", "vx"], "y": ["0", "1"]}
PHI: dict[str, Any] = {
    "name": "phi", "r": "3/50", "neg_cos": "1", "speed": "1/100", "tangential": ["1", "1"],
    "x": ["0", "1/2"], "y": ["0", "1/4"],
}  # fmt: skip
Lines = list[dict[str, Any]]


def log_of(plane: dict[str, Any], level: int, *records: tuple[str, str, list[Any]]) -> Lines:
    """A log with these keys, verdicts and numbers, level by level."""
    header = {"format": check_map.FORMAT, "plane": plane, "first_level": level, "code": 2}
    lines = [
        {"level": level + i, "keys": keys, "verdicts": letters, "numbers": numbers}
        for i, (keys, letters, numbers) in enumerate(records)
    ]
    return [header, *lines]


def checked(lines: Lines) -> tuple[check_map.Plane, check_map.Areas]:
    return check_map.check_log(iter(sealed(lines)))


def family(**changes: Any) -> Family:
    found = check_map.plane_of(LINE | changes)
    assert isinstance(found, Family)
    return found


# --- an interval of scenes -----------------------------------------------------------------------


def test_an_interval_is_cut_in_two() -> None:
    lines = log_of(LINE, 1, ("0 1", "cu", [[]]), ("10 11", "cc", [[], []]))
    plane, areas = checked(lines)
    assert isinstance(plane, Family)
    assert (areas.boxes, areas.proved, areas.collapses) == (4, 3, 1)
    assert (areas.disperses, areas.finite, areas.is_strip) == (0, 0, False)
    assert areas.runs == (Run("c", F(1, 20), F(3, 50)),)
    assert check_map.cites(plane, areas) == ("flow", "sharper", "line")
    text = check_map.says(plane, areas)
    assert text == (
        "spheres of diameter 1, positions (0, 0) (2, 0) (-5/2, 0), velocities (0, 0) (-1, 0) "
        "(1, 0), r in [1/20, 3/50]: 4 boxes, 3 of them proved; collapses in [1/20, 3/50]; of the "
        "interval: collapses 1 (about 100.0000 %), disperses 0 (about 0.0000 %), undecided 0 "
        "(about 0.0000 %)"
    )
    for keys in ("1 0", "1", "0 1 2", "0 1 2 3"):
        with pytest.raises(LogError):
            checked(log_of(LINE, 1, (keys, "c" * len(keys.split()), [[]] * len(keys.split()))))


def test_runs_are_apart_where_something_is_undecided() -> None:
    plane = LINE | {"x": ["1/20", "53/500"]}
    lines = log_of(plane, 2, ("00 01 10 11", "cufu", [[]]), ("010 011 110 111", "uuff", []))
    found, areas = checked(lines)
    width = F(56, 1000)
    assert areas.runs == (
        Run("c", F(1, 20), F(1, 20) + width / 4),
        Run("f", F(1, 20) + width / 2, F(53, 500)),
    )
    assert (areas.collapses, areas.finite, areas.proved) == (F(1, 4), F(1, 2), 4)
    assert areas.undecided == F(1, 4)
    assert check_map.cites(found, areas)[2:] == ("line", "classification")
    assert "finitely many collisions in [39/500, 53/500]" in check_map.says(found, areas)
    assert "finitely many collisions 1/2 (about 50.0000 %)" in check_map.says(found, areas)
    assert check_map.given(found, areas).startswith(
        "given the theorems of certificates/flow, certificates/sharper, certificates/line and "
        "certificates/classification; scenes with an overlap"
    )


def test_finitely_many_collisions_are_said_unless_there_is_a_triple_contact() -> None:
    """0 and 1 stay in contact, so that each of these scenes ends when 2 meets 0, undecided."""
    plane = LINE | {
        "r": "2/25", "positions": [["0", "0"], ["1", "0"], ["-3", "x"]],
        "velocities": [["0", "0"], ["0", "0"], ["1", "0"]],
    }  # fmt: skip
    found, areas = checked(log_of(plane, 1, ("0 1", "ff", [])))
    assert areas.finite == 1
    unless = "only finitely many collisions are possible, unless three touch at once or two graze"
    assert unless in check_map.given(found, areas)
    assert unless not in check_map.given(found, areas._replace(finite=F(0)))


def test_a_rectangle_is_cut_in_four() -> None:
    """All boxes of this family are on a line; vx moves nothing."""
    plane = check_map.plane_of(PLANE)
    assert check_map.digits_of(plane) == "0123"
    assert check_map.digits_of(family()) == "01"
    assert check_map.share_of(plane, "01") == F(1, 16)
    assert check_map.share_of(family(), "01") == F(1, 4)
    assert [check_map._key(i, 2, "01") for i in range(4)] == ["00", "01", "10", "11"]
    assert [check_map._key(i, 2) for i in (0, 1, 4, 15)] == ["00", "01", "10", "33"]
    assert check_map.sides(family(), "1")[1] == (0, 0)
    low, high = check_map.sides(family(), "1")[0]
    assert low <= F(11, 200) * ONE <= low + 1
    assert high - 1 <= F(3, 50) * ONE <= high
    _, areas = checked(log_of(PLANE, 1, ("0 1 2 3", "cccu", [[], [], []])))
    assert (areas.collapses, areas.runs) == (F(3, 4), ())


@pytest.mark.parametrize("letters", ["dc", "fc", "cd"])
def test_another_verdict(letters: str) -> None:
    numbers = [[]] * letters.count("c")
    with pytest.raises(RefusedError, match=r"box [01], [df]: "):
        checked(log_of(LINE, 1, ("0 1", letters, numbers)))


def test_elsewhere_six_numbers_are_needed() -> None:
    off = LINE | {"velocities": [["0", "x"], ["-1", "0"], ["1", "0"]], "r": "1/20"}
    with pytest.raises(LogError, match="six numbers"):
        checked(log_of(off, 1, ("0 1", "cc", [[], []])))


# --- the theorems that a family may use -----------------------------------------------------------


@pytest.mark.parametrize(
    ("r", "good"),
    [
        ("7/100", False),
        ("359/5000", True),
        ("3589/50000", False),
        ("9/125", True),
        ("99/100", True),
    ],
)
def test_finitely_many_collisions_need_a_large_r(r: str, good: bool) -> None:
    """7 - 4√3 = 0.071796…"""
    law = check_map.law_of(F(r), MODELS)
    check_map.check_finite(law, lambda: True)
    if good:
        check_map.check_finite(law)
        return
    with pytest.raises(RefusedError, match="7 - 4√3 or less, and the angular momentum 0"):
        check_map.check_finite(law)


@pytest.mark.parametrize(
    ("r", "good"),
    [("1/1000", False), ("5572809/100000000", False), ("55728091/1000000000", True)],
)
def test_with_angular_momentum_a_smaller_r_is_enough(r: str, good: bool) -> None:
    """9 - 4√5 = 0.0557280900008…"""
    law = check_map.law_of(F(r), MODELS)
    if good:
        check_map.check_finite(law, lambda: True)
    for turns in (True, False)[good:]:
        with pytest.raises(RefusedError, match="r may be"):
            check_map.check_finite(law, lambda turns=turns: turns)


#: 3 L = 3 (x - 1/2): sphere 2 is at (0, x - 1/2) from the middle of the two others, and passes by.
PASSING: dict[str, Any] = {
    "name": "family", "r": "3/50",
    "positions": [["0", "0"], ["2", "0"], ["-2", ["-", "1/2", "x"]]],
    "velocities": [["0", "0"], ["0", "0"], ["3/2", "0"]],
    "axes": ["h"], "x": ["0", "1"],
}  # fmt: skip


def momenta(plane: Family, x: Fraction, y: Fraction) -> list[Fraction]:
    """The components of 3 L, about the centre of mass, at a point."""
    places, speeds = (
        [[exact(cell, x, y) for cell in row] for row in rows]
        for rows in (plane.positions, plane.velocities)
    )
    centre, drift = (
        [sum(column) for column in zip(*rows, strict=True)] for rows in (places, speeds)
    )

    def wedge(a: list[Fraction], b: list[Fraction], k: int, m: int) -> Fraction:
        return a[k] * b[m] - a[m] * b[k]

    return [
        3 * sum(wedge(p, v, k, m) for p, v in zip(places, speeds, strict=True))
        - wedge(centre, drift, k, m)
        for k in range(len(centre))
        for m in range(k)
    ]


def test_where_there_is_angular_momentum() -> None:
    plane = family(**PASSING)
    assert momenta(plane, F(1), F(0)) == [F(-3, 2)] == [-p for p in momenta(plane, F(0), F(0))]
    assert [check_map.turns(plane, key) for key in ("0", "1")] == [False, False]
    assert [check_map.turns(plane, key) for key in ("00", "01", "10", "11")] == [
        True, False, False, True
    ]  # fmt: skip
    for end in (F(1, 2), F(1, 2) - F(1, 2**80)):
        near = plane._replace(x=(F(0), end))
        assert check_map.turns(near, "1") == (end < F(1, 2))
        far = plane._replace(x=(1 - end, F(1)))
        assert check_map.turns(far, "0") == (end < F(1, 2))


def test_angular_momentum_is_that_about_the_centre_of_mass() -> None:
    """Scenes on a line have none, wherever they are and however they drift."""
    shifted = {
        "positions": [["9", "x"], ["11", "x"], ["13/2", "x"]],
        "velocities": [["7", "x"], ["6", "x"], ["8", "x"]],
    }
    for plane in (family(), family(**shifted)):
        assert not any(check_map.turns(plane, key) for key in ("0", "1", "01011"))
    line = {"positions": [["0"], ["2"], ["x"]], "velocities": [["0"], ["-1"], ["1"]]}
    assert not check_map.turns(family(**line, x=["-3", "-2"]), "0")
    for axis in range(3):  # the plane of one pair of axes is enough
        positions = [["0"] * 3, ["2"] * 3, ["-2"] * 3]
        velocities = [["0"] * 3, ["0"] * 3, ["1"] * 3]
        velocities[2][axis] = "x"
        turned = family(positions=positions, velocities=velocities, x=["0", "2"])
        assert [check_map.turns(turned, key) for key in ("00", "01", "10", "11")] == [
            True, False, False, True
        ]  # fmt: skip
    other = check_map.plane_of(PHI)
    assert not check_map.turns(other, "0")


@pytest.mark.parametrize("place", ["positions[2][1]", "velocities[2][1]"])
def test_a_plane_through_a_scene_has_angular_momentum(place: str) -> None:
    """3 L = -3 y where the position varies, and -(4 + x) y where the velocity does."""
    plane = check_map.plane_of({
        "name": "scene", "r": "3/50", "positions": [["0", "0"], ["2", "0"], ["-2", "0"]],
        "velocities": [["0", "0"], ["-1", "0"], ["1", "0"]], "x_at": "positions[1][0]",
        "y_at": place, "x": ["2", "3"], "y": ["-1", "1"],
    })  # fmt: skip
    assert [check_map.turns(plane, key) for key in ("00", "02", "20", "22")] == [
        True, False, False, True
    ]  # fmt: skip


def test_random_boxes_with_angular_momentum() -> None:
    """One component has one sign at all points of such a box."""
    choose, found, missed = random.Random(11), 0, 0
    for _ in range(400):
        size = choose.choice((2, 3))
        cells = [[random_term(choose, 2) for _ in range(size)] for _ in range(6)]
        plane = Family(
            F(3, 50), tuple(map(tuple, cells[:3])), tuple(map(tuple, cells[3:])), ("a", "b"),
            (F(1), F(2)), (F(1, 2), F(1)),
        )  # fmt: skip
        key = "".join(choose.choice("0123") for _ in range(3))
        try:
            turns = check_map.turns(plane, key)
        except RefusedError:
            continue
        column, row = check_map.corner(key)
        points = [
            (1 + (column + F(i, 4)) / 8, F(1, 2) + (row + F(j, 4)) / 16)
            for i in range(5)
            for j in range(5)
        ]
        at_points = zip(*(momenta(plane, *point) for point in points), strict=True)
        has_sign = any(all(p > 0 for p in ps) or all(p < 0 for p in ps) for ps in at_points)
        assert has_sign or not turns
        found, missed = found + turns, missed + (has_sign and not turns)
    assert found > 100
    assert missed < found / 20


def test_finitely_many_collisions_in_a_log() -> None:
    good = log_of(PASSING, 2, ("00 01 10 11", "fuuf", []))
    plane, areas = checked(good)
    assert (areas.finite, areas.undecided) == (F(1, 2), F(1, 2))
    assert check_map.cites(plane, areas) == ("flow", "sharper", "classification")
    for letters in ("ffuf", "fuff"):
        with pytest.raises(RefusedError, match=r"box (01|10), f: .*the angular momentum 0"):
            checked(log_of(PASSING, 2, ("00 01 10 11", letters, [])))
    for low, said in (("5572/100000", "9 - 4√5"), ("5573/100000", None)):
        both = PASSING | {"r": "y", "axes": ["h", "r"], "y": [low, "7/100"]}
        lines = log_of(
            both, 2, (" ".join(map("".join, product("0123", repeat=2))), "f" + "u" * 15, [])
        )
        if said is None:
            checked(lines)
            continue
        with pytest.raises(RefusedError, match=said):
            checked(lines)
    law = check_map.law_of(F(3, 50), MODELS)
    with pytest.raises(RefusedError, match="the angular momentum 0"):
        check_map.prove_box(law, lambda _: [], "0", "f", [])
    with pytest.raises(RefusedError, match="the angular momentum 0"):
        checked(log_of(PHI, 1, ("0 1 2 3", "fuuu", [])))


def test_r_of_a_box_is_in_01() -> None:
    law = check_map.law_around(check_map.parameter(MODELS, 0, (ONE // 8, ONE // 4)))
    assert law.bounds[0] <= ONE // 8 < ONE // 4 <= law.bounds[1]
    half = [end / ONE for end in law.half[:2]]
    assert half[0] <= F(9, 16) < F(10, 16) <= half[1] + 1e-9
    for ends in ((0, ONE // 2), (-1, ONE // 2), (ONE // 2, ONE), (ONE // 2, 2 * ONE)):
        with pytest.raises(RefusedError, match="not be in"):
            check_map.law_around(check_map.parameter(MODELS, 0, ends))
    for r in (F(0), F(1)):
        bad = check_map.law_of(F(1, 2), MODELS)._replace(bounds=check_map.around(r))
        with pytest.raises(RefusedError):
            check_map.check_finite(bad)


def sight(**changes: tuple[int, int]) -> check_map.Sight:
    """A state on a line whose ratio of speeds is 1/10, far enough apart."""
    one = (ONE, ONE)
    fields: dict[str, Any] = dict.fromkeys(check_map.Sight._fields, one)
    fields |= {"rho": (ONE // 10, ONE // 10 + 1), "eps": (1, 2), "v": one, "C": one}
    fields |= changes
    return check_map.Sight(**fields)


def test_a_collapse_on_a_line() -> None:
    law = check_map.law_of(F(1, 20))
    assert check_map.closes_on_a_line(law, sight())
    for name in ("lam", "rho", "eps", "v", "C"):
        assert not check_map.closes_on_a_line(law, sight(**{name: (0, ONE)})), name
    # The roots of Q² - (1+r)/2 Q + r at r = 1/20 are 0.106 and 0.418; half of the sum is 0.2625.
    assert check_map.closes_on_a_line(law, sight(rho=(ONE // 5, ONE // 4)))
    assert not check_map.closes_on_a_line(law, sight(rho=(0, ONE // 5)))
    assert not check_map.closes_on_a_line(law, sight(rho=(ONE // 5, 27 * ONE // 100)))
    far = (4 * ONE, 4 * ONE)
    assert not check_map.closes_on_a_line(law, sight(rho=(ONE // 5, ONE // 5), eps=far))
    slow = (ONE // 3, ONE // 3)
    assert not check_map.closes_on_a_line(law, sight(lam=slow))
    assert check_map.closes_on_a_line(check_map.law_of(F(71, 1000)), sight())
    for r in (F(72, 1000), F(1, 5)):
        assert not check_map.closes_on_a_line(check_map.law_of(r), sight())


# --- terms ----------------------------------------------------------------------------------------


def exact(term: Any, x: Fraction, y: Fraction) -> Fraction:
    if not isinstance(term, tuple):
        return term if isinstance(term, Fraction) else {"x": x, "y": y}[term]
    name, one, two = term
    a, b = exact(one, x, y), exact(two, x, y)
    return {"+": a + b, "-": a - b, "*": a * b, "/": a / b if b else F(0)}[name]


def random_term(choose: random.Random, depth: int) -> Any:
    if depth == 0 or choose.random() < 0.2:
        return choose.choice(["x", "y", F(choose.randint(-9, 9), choose.randint(1, 9))])
    name = choose.choice("+-*/")
    one = random_term(choose, depth - 1)
    return name, one, one if choose.random() < 0.1 else random_term(choose, depth - 1)


@pytest.mark.parametrize("kind", [INTERVALS, MODELS])
def test_terms_contain_their_values(kind: check_map.Arithmetic) -> None:
    choose, divided = random.Random(5), 0
    for _ in range(400):
        term = random_term(choose, 4)
        low, wide = choose.randint(-3 * ONE, 2 * ONE), choose.choice([1, ONE // 9, ONE])
        sides = (low, low + wide), (ONE // 3, ONE // 2)
        try:
            found = check_map.value_of(
                kind, term, *(check_map.parameter(kind, i, s) for i, s in enumerate(sides))
            )
        except RefusedError:
            divided += 1
            continue
        for _ in range(4):
            x, y = (F(choose.randint(*ends), ONE) for ends in sides)
            assert found[0] <= exact(term, x, y) * ONE <= found[1]
    assert 10 < divided < 250


def test_a_divisor_may_be_negative_but_not_0() -> None:
    below = check_map.value_of(INTERVALS, ("/", F(1), "x"), (-2 * ONE, -ONE), (0, 0))
    assert below[0] <= -ONE <= -ONE // 2 <= below[1] < 0
    for ends in ((-ONE, ONE), (0, ONE), (-ONE, 0)):
        with pytest.raises(RefusedError, match="divisor"):
            check_map.value_of(INTERVALS, ("/", F(1), "x"), ends, (0, 0))


def test_terms_are_counted_and_told() -> None:
    term = check_map._term(["+", "x", ["*", "1/2", ["-", "y", ["/", "x", "3"]]]], "xy")
    assert check_map.operations(term) == 4
    assert check_map.operations("x") == check_map.operations(F(1)) == 0
    assert check_map.term_text(term, ("r", "vx")) == "(r + (1/2 * (vx - (r / 3))))"
    over_a_half = ("/", "y", Fraction(1, 2))
    assert check_map.term_text(over_a_half, ("r", "vx")) == "(vx / (1/2))"
    assert check_map.term_text(("/", "x", ("/", "y", F(3))), ("r", "vx")) == "(r / (vx / 3))"
    many: Any = "x"
    for _ in range(15):
        many = ["+", many, "0"]
    assert check_map.price_of(family()) == check_map.BOX_PRICE
    assert check_map.price_of(family(r=many)) == check_map.BOX_PRICE + 1
    rows = [["0", "0"], [many, "0"], ["-5/2", "0"]]
    assert check_map.price_of(family(r=["+", many, "0"], positions=rows)) == check_map.BOX_PRICE + 3
    assert check_map.price_of(check_map.plane_of(PLANE)) == check_map.BOX_PRICE


@pytest.mark.parametrize(("n", "moving", "more"), [(3, 3, 2), (20, 0, 47), (20, 20, 47), (8, 8, 7)])
def test_a_box_costs_more_in_many_dimensions(n: int, moving: int, more: int) -> None:
    """15 products for each coordinate of places or velocities that varies, or 4 n (n - 1)."""
    here = ["x"] * moving + ["0"] * (n - moving)
    rows = [here, ["100"] + ["0"] * (n - 1), ["-100"] + ["0"] * (n - 1)]
    plane = family(positions=rows, velocities=rows)
    assert max(15 * 2 * moving, 4 * n * (n - 1)) // 32 == more
    assert check_map.price_of(plane) == check_map.BOX_PRICE + more


def test_which_coordinates_vary_and_which_scenes_are_on_a_line() -> None:
    moved = family(velocities=[["0", "0"], ["x", "0"], ["1", "0"]], r="1/20")
    assert check_map.varying(moved) == [(("velocities", 1, 0), "x")]
    assert check_map.on_a_line(moved)
    assert check_map.on_a_line(family())
    assert check_map.on_a_line(family(velocities=[["0", "3"], ["-1", "3"], ["1", "3"]]))
    assert not check_map.on_a_line(family(velocities=[["0", "3"], ["-1", "3"], ["1", "2"]]))
    assert check_map.on_a_line(family(velocities=[["0", "x"], ["-1", "x"], ["1", "x"]]))
    assert not check_map.on_a_line(family(velocities=[["0", "x"], ["-1", "x"], ["1", "0"]]))
    turned = {"positions": [["0", "0"], ["2", "1"], ["-4", "-2"]]}
    parallel = [["0", "0"], ["-2", "-1"], [["*", "4", "x"], ["*", "2", "x"]]]
    assert check_map.on_a_line(family(**turned, velocities=parallel))
    beside = [["0", "0"], ["-2", "-1"], [["*", "4", "x"], "x"]]
    assert not check_map.on_a_line(family(**turned, velocities=beside))
    assert not check_map.on_a_line(family(positions=[["0", "0"], ["2", "1"], ["-5/2", "1"]]))
    assert not check_map.on_a_line(check_map.Phi(*[F(1, 2)] * 3, *[(F(0), F(1))] * 3))
    drifting = [["0", "3"], [["/", "-1", "x"], "3"], ["1", "3"]]
    assert check_map.on_a_line(family(velocities=drifting))
    assert not check_map.on_a_line(family(velocities=[*drifting[:2], ["1", "2"]]))


def test_quotients_are_polynomials_if_the_divisor_is_a_number() -> None:
    assert check_map.polynomial(("/", "x", F(3))) == {(1, 0): F(1, 3)}
    assert check_map.polynomial(("/", F(1), "x")) is None
    assert check_map.polynomial(("/", "x", F(0))) is None
    assert check_map.polynomial(("*", "y", ("*", "x", "y"))) == {(1, 2): 1}
    power: Any = F(1)
    for _ in range(check_map.MAX_COEFFICIENTS - 1):
        power = ("+", ("*", "y", power), F(1))
    assert len(check_map.polynomial(power) or ()) == 100
    assert check_map.polynomial(("*", "y", power)) is not None
    assert check_map.polynomial(("+", ("*", "y", power), F(1))) is None


@pytest.mark.parametrize("kind", [INTERVALS, MODELS])
def test_terms_have_short_numbers(kind: check_map.Arithmetic) -> None:
    """A thousand operations on long numbers take minutes, and cost no more than on short ones."""

    def power(bits: int) -> check_map.Term:
        found: check_map.Term = F(1 << bits % 127)
        for _ in range(bits // 127):
            found = ("*", F(1 << 127), found)
        return found

    many: check_map.Term = F(1)
    for count in range(1, check_map.MAX_COEFFICIENTS + 1):
        many = ("*", ("+", "x", F(1)), many)
        found = check_map.polynomial(many)
        assert (found is not None) is (count < check_map.MAX_COEFFICIENTS)
    most = check_map.MAX_BITS - 1
    for under in (F(1), F(3)):
        assert check_map.polynomial(("/", power(most), under)) == {(0, 0): (1 << most) / under}
        assert check_map.polynomial(("/", under, power(most))) == {(0, 0): under / (1 << most)}
        assert check_map.polynomial(("/", power(most + 1), under)) is None
        assert check_map.polynomial(("/", under, power(most + 1))) is None
    units = most - check_map.PLACES
    assert check_map.value_of(kind, power(units), None, None)[0] == 1 << most
    with pytest.raises(RefusedError, match="numbers of a term are too large"):
        check_map.value_of(kind, power(units + 1), None, None)


# --- what is malformed ----------------------------------------------------------------------------

SPOILT: dict[str, dict[str, Any]] = {
    "expected the names of the axes": {"axes": "r"},
    "expected the names of the axes ": {"axes": [1]},
    "expected a name for each axis": {"axes": ["r", "s"]},
    "expected a name for each axis ": {"axes": []},
    "expected names of axes": {"axes": ["a b"]},
    "expected names of axes ": {"axes": ["a[1][2][3]"]},
    "expected an interval for each axis": {"x": ["1/20", "1/20"]},
    "expected three vectors of 1 to 20": {"positions": []},
    "expected three vectors of 1 to 20 ": {"velocities": [["0", "0"]] * 4},
    "expected three vectors of 1 to 20  ": {"positions": [[], [], []], "velocities": [[], [], []]},
    "expected vectors of one length": {"positions": [["0"], ["2"], ["3"]]},
    "expected 0 < r < 1": {"r": "1"},
    "expected 0 < r < 1 ": {"r": "0"},
    "expected a list": {"positions": "000"},
    "expected a list ": {"positions": ["0", "0", "0"]},
    "expected a term": {"r": ["+", "x"]},
    "expected a term ": {"r": 1},
    "expected one of the operations": {"r": ["^", "x", "2"]},
    "an exact number": {"r": "y"},
}


@pytest.mark.parametrize("words", SPOILT)
def test_malformed(words: str) -> None:
    with pytest.raises(LogError, match=words.strip()):
        check_map.plane_of(LINE | SPOILT[words])


def test_names_of_axes_and_three_vectors() -> None:
    for axes in (["r", "1"], ["r", ""], ["r", "v\n"]):
        with pytest.raises(LogError, match="names of axes"):
            check_map.plane_of(PLANE | {"axes": axes})
    for few in ([], [["0", "0"]]):
        with pytest.raises(LogError, match="three vectors"):
            check_map.plane_of(PLANE | {"positions": few})


def test_limits() -> None:
    for y in (["0", "0"], ["1", "0"]):
        with pytest.raises(LogError, match="an interval for each axis"):
            check_map.plane_of(PLANE | {"y": y})
    with pytest.raises(LogError, match="a name for each axis"):
        check_map.plane_of(PLANE | {"axes": ["r", "r"]})
    for size, good in ((20, True), (21, False)):
        rows = [[str(5 * i), *["0"] * (size - 1)] for i in range(3)]
        changes = {"positions": rows, "velocities": rows}
        if good:
            family(**changes)
        else:
            with pytest.raises(LogError, match="1 to 20 numbers"):
                family(**changes)
    for depth, good in ((61, True), (62, False)):
        term: Any = "x"
        for _ in range(depth):
            term = ["+", term, "0"]
        if good:
            family(r=term)
        else:
            with pytest.raises(LogError, match="not deep"):
                family(r=term)
    twice: Any = "x"
    for _ in range(9):
        twice = ["+", twice, twice]  # 511 operations
    more: Any = ["+", "x", "0"]
    for _ in range(7):
        more = ["+", more, more]  # 255
    other = [["0", "0"], [more, "0"], [["+", more, "x"], "0"]]
    with pytest.raises(LogError, match="at most 1000 operations"):
        family(r=twice, positions=other)
    row = [["0", "0"], [more, "0"], ["5", "0"]]
    assert check_map.price_of(family(r=twice, positions=row)) > 90
