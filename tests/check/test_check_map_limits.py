"""The limits of a log, each at the limit and one beyond, and the price of what is proved."""

from __future__ import annotations

import io
from fractions import Fraction
from typing import Any

import pytest

from tests.check.test_check_map import sealed
from verify import check_map
from verify.check_map import ONE, LogError, RefusedError, Sight, Work

PHI = check_map.Phi(*[Fraction(1, 2)] * 3, *[(Fraction(0), Fraction(1))] * 3)


def test_whole_numbers_and_fractions_have_40_digits() -> None:
    assert check_map._whole("9" * 40) == 10**40 - 1
    assert check_map._rational("-" + "9" * 40 + "/" + "7" * 40) == Fraction(-9, 7)
    with pytest.raises(LogError, match="40 digits"):
        check_map._whole("9" * 41)
    for text in ("9" * 41, "1/" + "7" * 41, "", "1/", "/2", "1/2/3", "+1", "1.5"):
        with pytest.raises(LogError, match="an exact number"):
            check_map._rational(text)


def test_lines_have_16_mib() -> None:
    with pytest.raises(LogError, match="no JSON"):
        check_map._line(b"?" * (1 << 24), "", check_map.HEADER)
    with pytest.raises(LogError, match="a line has more than 16777216 bytes"):
        check_map._line(b"?" * ((1 << 24) + 1), "", check_map.HEADER)


def test_boxes_have_40_levels() -> None:
    for level in (40, 41):
        record = {"level": level, "keys": "0", "verdicts": "d", "numbers": []}
        if level == 40:
            assert check_map._boxes(record, level) == (["0"], "d", [])
        else:
            with pytest.raises(LogError, match="boxes of level"):
                check_map._boxes(record, level)


@pytest.mark.parametrize("branches", [1, 2])
@pytest.mark.parametrize("sixes", [0, 1, 4])
def test_a_box_is_followed_for_2000_steps(
    monkeypatch: pytest.MonkeyPatch, branches: int, sixes: int
) -> None:
    """A step is a collision, or six numbers tried once, in all branches together."""
    calls = []

    def after(_: Any, state: Sight) -> tuple[bool, list[Sight]]:
        calls.append(state)
        return False, [state] * branches

    monkeypatch.setattr(check_map, "after", after)
    monkeypatch.setattr(check_map, "closes", lambda *_: False)
    law, state = check_map.law_of(Fraction(1, 2)), Sight(*[(ONE, ONE)] * len(Sight._fields))
    with pytest.raises(RefusedError, match="no end after 2000 steps"):
        check_map.prove(law, [state], "c", [()] * sixes, Work(None))
    assert len(calls) == 2000 // (1 + sixes) + (2000 % (1 + sixes) > 0)


def spent(kind: check_map.Arithmetic, bits: int, sixes: int) -> int:
    """What a box costs that ends after one collision of numbers with so many bits."""
    work, law = Work(10**6), check_map.law_of(Fraction(1, 2), kind)
    number = (-1, 1 << bits - 1) if kind is check_map.INTERVALS else (-1, 1 << bits - 1, *[0] * 7)
    state = Sight(*[number] * len(Sight._fields))
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(check_map, "after", lambda *_: (True, []))
        patch.setattr(check_map, "closes", lambda *_: False)
        check_map.prove_box(law, lambda _: [state], "0", "d", [()] * sixes, work)
    assert work.left is not None
    return 10**6 - work.left


@pytest.mark.parametrize("bits", [2, 255, 256, 1535, 1536])
@pytest.mark.parametrize("sixes", [0, 3])
def test_a_box_costs_three_steps_and_long_numbers_cost_more(bits: int, sixes: int) -> None:
    step = (1 + sixes) * (1 + bits // 256)
    assert spent(check_map.INTERVALS, bits, sixes) == 3 + step
    assert spent(check_map.MODELS, bits, sixes) == 10 * (3 + step)
    with pytest.raises(RefusedError, match="too large to go on"):
        spent(check_map.INTERVALS, 16 * 96 + 1, 0)


def test_all_boxes_have_290_000_steps() -> None:
    assert Work().left == check_map.MAX_WORK == 290_000


def test_areas_have_8192_bits(monkeypatch: pytest.MonkeyPatch) -> None:
    short, long = Fraction(1, 1 << 8191), Fraction(1, 1 << 8192)
    monkeypatch.setattr(check_map, "share_of", lambda *_: short)
    assert check_map._and_share(Fraction(0), PHI, "0") == short
    monkeypatch.setattr(check_map, "share_of", lambda *_: long)
    with pytest.raises(LogError, match="shorter fractions"):
        check_map._and_share(Fraction(0), PHI, "0")


STRIP = {
    "name": "strip", "r": "1/2", "neg_cos": "1", "speed": "1", "tangential": ["0", "0"],
    "x": ["0", "16"], "y": ["0", "3"], "delta": "1/10", "below": ["0", "1/2", "1"],
    "above": ["0", "1/2", "1"],
}  # fmt: skip


@pytest.mark.parametrize(
    ("row", "good"),
    [
        # The parts have half a width of 2, so that f and δ differ from c0 by up to 11/10.
        (["111/100", "1/2", "0"], True),
        (["11/10", "1/2", "0"], False),
        (["189/100", "-1/2", "0"], True),
        (["19/10", "-1/2", "0"], False),
        (["111/100", "1/4", "-1/8"], True),
        (["11/10", "1/4", "1/8"], False),
        (["1/2", "0", "0"], True),
        (["1/10", "0", "0"], False),
    ],
)
def test_a_curve_lies_between_0_and_the_top(row: list[str], good: bool) -> None:
    document = {**STRIP, "curve": [["3/2", "1/10", "0"]] * 3 + [row]}
    if good:
        assert check_map._strip(document).curve[3] == tuple(map(Fraction, row))
    else:
        with pytest.raises(LogError, match="between 0 and the top"):
            check_map._strip(document)


def test_a_strip_begins_with_a_box_for_each_part() -> None:
    plane = {**STRIP, "curve": [["3/2", "1/10", "0"]] * 4}
    plane = {name: plane[name] for name in check_map.STRIP}
    for level in (1, 2, 3):
        header = {"format": check_map.FORMAT, "plane": plane, "first_level": level, "code": 1}
        if level == 2:
            assert check_map.check_log(iter(sealed([header])))[1].boxes == 0
        else:
            with pytest.raises(LogError, match="a first box for each part of the curve"):
                check_map.check_log(iter(sealed([header])))


SCENE = {
    "name": "scene", "r": "1/2",
    "positions": [["0", "0"], ["2", "0"], ["-2", "0"]],
    "velocities": [["0", "0"], ["-1", "0"], ["1", "0"]],
    "x_at": "velocities[2][0]", "y_at": "velocities[2][1]", "x": ["1", "2"], "y": ["-1", "1"],
}  # fmt: skip


@pytest.mark.parametrize("r", ["0", "1", "3/2", "-1/2"])
def test_r_lies_between_0_and_1_in_a_scene(r: str) -> None:
    with pytest.raises(LogError, match="0 < r < 1"):
        check_map._through({**SCENE, "r": r})


@pytest.mark.parametrize("name", ["x", "y"])
@pytest.mark.parametrize("ends", [["2", "1"], ["1", "1"]])
def test_a_rectangle_of_scenes_has_an_area(name: str, ends: list[str]) -> None:
    assert check_map._through(SCENE).x == (1, 2)
    with pytest.raises(LogError, match="two places, and a rectangle"):
        check_map._through({**SCENE, name: ends})


@pytest.mark.parametrize("size", [1, 2, 20, 21])
def test_a_scene_has_from_2_to_20_dimensions(size: int) -> None:
    zeros = ["0"] * (size - 1)
    rows = {name: [["1", *zeros]] * 3 for name in ("positions", "velocities")}
    places = {"x_at": "positions[0][0]", "y_at": "positions[1][0]"}
    if 2 <= size <= 20:
        assert len(check_map._through({**SCENE, **rows, **places}).positions[0]) == size
    else:
        with pytest.raises(LogError, match="one length from 2 to 20"):
            check_map._through({**SCENE, **rows, **places})


@pytest.mark.parametrize(
    ("below", "above", "parts", "good"),
    [
        (["0", "1"], ["0", "1"], 2, True),
        (["0", "1"], ["0", "1/2", "2/3", "1"], 4, True),
        (["0"], ["0", "1/2", "1"], 2, False),
        (["0", "1/2", "1/2", "1"], ["0", "1"], 4, False),
        (["0", "2/3", "1/3", "1"], ["0", "1"], 4, False),
        (["0", "1/2"], ["0", "1"], 2, False),
        (["1/2", "1"], ["0", "1"], 2, False),
        (["0", "1"], ["0", "1"], 4, False),
    ],
)
def test_bands_go_from_0_to_1(below: list[str], above: list[str], parts: int, good: bool) -> None:
    document = {**STRIP, "x": ["0", "2"], "curve": [["3/2", "1/10", "0"]] * parts}
    document |= {"below": below, "above": above}
    if good:
        assert len(check_map._strip(document).curve) == parts
    else:
        with pytest.raises(LogError, match="bands"):
            check_map._strip(document)


def test_an_interrupt_is_told(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def answer(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(check_map, "answer", answer)
    assert check_map.main([__file__]) == 130
    assert capsys.readouterr() == ("", "check_map: interrupted\n")


def test_a_box_that_disperses_needs_no_numbers() -> None:
    assert check_map.sixes([], "d") == []
    twelve = [tuple((n << 66,) * 2 for n in range(first, first + 6)) for first in (0, 6)]
    assert check_map.sixes([*range(6)], "c") == check_map.sixes([*range(6)], "d") == twelve[:1]
    assert check_map.sixes([*range(12)], "c") == twelve
    for flat, letter in (([], "c"), ([1], "d"), ([1] * 5, "c"), ("", "c"), ([True] * 6, "c")):
        with pytest.raises(LogError):
            check_map.sixes(flat, letter)


def test_squares_of_what_varies_are_not_negative() -> None:
    """Of a velocity that varies in [1, 2] and [-1, 1] the square is in [1, 5]."""
    kind, plane = check_map.INTERVALS, check_map._through(SCENE)
    products = [check_map._products(kind, plane, place) for place in check_map.PAIRS]
    varied = check_map._varied(kind, plane, (ONE, 2 * ONE), (-ONE, ONE))
    pairs, sight = check_map._scenes(kind, products, varied)
    assert pairs[1].m == sight(1)[0].A == sight(0)[0].B == (ONE, 5 * ONE)


@pytest.mark.parametrize(("x", "meets"), [(["1", "11/10"], True), (["-2", "-1"], False)])
def test_a_scene_may_end_only_if_no_pair_must_meet(x: list[str], meets: bool) -> None:
    """One sphere runs to another one, or away from it; None stands for no collision."""
    kind = check_map.INTERVALS
    velocities = [["0", "0"], ["3", "0"], ["1", "0"]]
    document = {**SCENE, "velocities": velocities, "x": x, "y": ["-1/1000", "1/1000"]}
    plane = check_map._through(document)
    states = check_map.beginning(check_map.law_of(plane.r, kind), plane)("0")
    assert [state is None for state in states] == [not meets]


def test_a_stream_without_an_encoding(monkeypatch: pytest.MonkeyPatch) -> None:
    stream, file = io.StringIO(), io.BytesIO()
    monkeypatch.setattr("sys.stdout", stream)
    assert check_map.output(["Δ = 1"], 3) == 3
    assert stream.getvalue() == "\\u0394 = 1\n"
    monkeypatch.setattr("sys.stdout", io.TextIOWrapper(file, encoding="utf-8"))
    assert check_map.output(["Δ = 1"], 3) == 3
    assert file.getvalue() == "Δ = 1\n".encode()


@pytest.mark.parametrize("level", [-1, 0, 1, 8, 9, True])
def test_the_first_level_is_from_1_to_8(level: int) -> None:
    header = {"format": check_map.FORMAT, "plane": SCENE, "first_level": level, "code": 1}
    if level in (1, 8) and level is not True:
        assert check_map.check_log(iter(sealed([header])))[1].boxes == 0
    else:
        with pytest.raises(LogError, match="a first level from 1 to 8"):
            check_map.check_log(iter(sealed([header])))


def test_a_strip_begins_at_0() -> None:
    document = {**STRIP, "curve": [["3/2", "1/10", "0"]] * 4}
    assert check_map._strip(document).phi.y == (0, 3)
    with pytest.raises(LogError, match="a curve between 0 and the top"):
        check_map._strip({**document, "y": ["1/10", "3"]})
