"""The limits of a log, each at the limit and one beyond, and the price of what is proved."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest

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
    assert spent(check_map.MODELS, bits, sixes) == 5 * (3 + step)
    with pytest.raises(RefusedError, match="too large to go on"):
        spent(check_map.INTERVALS, 16 * 96 + 1, 0)


def test_all_boxes_have_290_000_steps() -> None:
    assert Work().left == check_map.MAX_WORK == 290_000


def test_areas_have_8192_bits(monkeypatch: pytest.MonkeyPatch) -> None:
    short, long = Fraction(1, 1 << 8191), Fraction(1, 1 << 8192)
    monkeypatch.setattr(check_map, "share_of", lambda *_: short)
    assert check_map._and_share(short, PHI, "0") == 2 * short
    monkeypatch.setattr(check_map, "share_of", lambda *_: long)
    with pytest.raises(LogError, match="shorter fractions"):
        check_map._and_share(Fraction(0), PHI, "0")
