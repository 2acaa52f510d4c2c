"""``interval``: enclosures decide."""

from __future__ import annotations

import pytest

from tests.check.support import proves, verdict

ROOT_2 = "1.4142135623730950488016887242096980785696718753769480731766797379907"
BELOW = f"{ROOT_2[0]}{ROOT_2[2:]}/1{'0' * (len(ROOT_2) - 2)}"
ABOVE = f"{int(ROOT_2[0] + ROOT_2[2:]) + 1}/1{'0' * (len(ROOT_2) - 2)}"
SQRT_2 = ["sqrt", "2"]


@pytest.mark.parametrize("relation", ["<", "<="])
def test_near_misses_in_the_last_digit(relation: str) -> None:
    assert proves([relation, SQRT_2, ABOVE], "interval", bits=256)
    assert proves([relation, BELOW, SQRT_2], "interval", bits=256)
    assert not proves([relation, SQRT_2, BELOW], "interval", bits=256)
    assert not proves([relation, ABOVE, SQRT_2], "interval", bits=256)


def test_too_few_bits_do_not_decide() -> None:
    assert not proves(["<", SQRT_2, ABOVE], "interval", bits=64)


def test_strict_and_not_strict() -> None:
    assert proves(["<=", "1/3", "1/3"], "interval")
    assert not proves(["<", "1/3", "1/3"], "interval")
    assert proves(["<=", SQRT_2, SQRT_2], "interval") is False


def test_equality_needs_single_points() -> None:
    assert proves(["=", ["add", "1/3", "1/6"], "1/2"], "interval")
    assert not proves(["=", "1/3", "1/2"], "interval")
    assert not proves(["=", SQRT_2, SQRT_2], "interval")
    assert not proves(["=", "0", "1"], "interval")
    assert not proves(["=", "1", "0"], "interval")


@pytest.mark.parametrize(
    ("claim", "good"),
    [
        (["not", ["<", "2", "1"]], True),
        (["not", ["<", "1", "1"]], True),
        (["not", ["<", "1", "2"]], False),
        (["not", ["<=", "2", "1"]], True),
        (["not", ["<=", "1", "1"]], False),
        (["not", ["=", "1", "2"]], True),
        (["not", ["=", "2", "1"]], True),
        (["not", ["=", "1", "1"]], False),
        (["not", ["=", SQRT_2, SQRT_2]], False),
        (["not", ["=", SQRT_2, "7/5"]], True),
        (["not", ["not", ["<", "1", "2"]]], True),
        (["not", ["not", ["<", "2", "1"]]], False),
        (["not", ["not", ["not", ["<", "2", "1"]]]], True),
    ],
)
def test_negations(claim: object, good: bool) -> None:
    assert proves(claim, "interval") is good


def test_every_operation() -> None:
    term = ["sub", ["mul", ["neg", "3"], ["div", "1", "4"]], ["pow", ["min", "1", "2", "1/2"], "2"]]
    assert proves(["=", term, "-1"], "interval")
    assert proves(["<", ["max", "1", SQRT_2, "-5"], "3/2"], "interval")
    assert proves(["<=", ["cos", "0"], "1"], "interval")
    assert proves(["<", ["cos", "29/10"], "-97/100"], "interval")
    assert not proves(["<", ["cos", "29/10"], "-98/100"], "interval")
    assert proves(["<", ["cos_pi", "5/6"], "-866/1000"], "interval")
    assert not proves(["<", ["cos_pi", "5/6"], "-867/1000"], "interval")
    assert proves(["<=", ["cos_pi", "1"], "0"], "interval")


def test_variables_range_over_their_whole_interval() -> None:
    unit = {"x": ["0", "1"]}
    assert proves(["<", "x", "2"], "interval", variables=unit)
    assert proves(["<=", "x", "1"], "interval", variables=unit)
    assert not proves(["<", "x", "1"], "interval", variables=unit)
    assert not proves(["<=", "x", "999/1000"], "interval", variables=unit)
    assert not proves(["<=", "1/1000", "x"], "interval", variables=unit)
    assert "without bounds" in verdict(["<", "x", "2"], "interval", variables={"x": [None, "1"]})


def test_a_negation_over_variables_is_not_the_opposite_inequality() -> None:
    claim = ["not", ["<", "x", "1/2"]]
    assert "expected witness" in verdict(claim, "interval", variables={"x": ["0", "1"]})


def test_what_is_undefined_is_refused() -> None:
    zero = ["sub", "1/3", "1/3"]
    assert "contains 0" in verdict(["<", ["div", "1", zero], "2"], "interval")
    assert "below 0" in verdict(["<", ["sqrt", "-1"], "2"], "interval")
    assert "contains 0" in verdict(["<", "0", "k"], "interval", constants={"k": ["div", "1", zero]})
    unused = verdict(["<", "0", "1"], "interval", constants={"k": ["sqrt", ["neg", "2"]]})
    assert "below 0" in unused or "constant k" in unused


@pytest.mark.parametrize(
    ("lhs", "rhs", "good"),
    [
        (["1.4142135623730950488", "1.4142135623730950489"], ["3/2", "3/2"], None),
        (["1.4142135623730950488", "1.4142135623730950489"], ["1.5", "1.5"], True),
        (["1.4142135623730950489", "1.4142135623730950490"], ["1.5", "1.5"], False),
        (["1.4142135623730950487", "1.4142135623730950488"], ["1.5", "1.5"], False),
        (["1.4142135623730950488", "1.4142135623730950489"], ["1.5000000001", "1.6"], False),
        (["-1e5", "1e5"], ["-1e-5", "2e0"], True),
    ],
)
def test_enclosures_of_the_certificate_are_compared(
    lhs: list[str], rhs: list[str], good: bool | None
) -> None:
    found = verdict(["<", SQRT_2, "3/2"], "interval", bits=128, lhs=lhs, rhs=rhs)
    if good is None:
        assert found.startswith("malformed")
    else:
        assert (found == "proved") is good


def test_enclosures_belong_to_the_sides_as_they_are_written() -> None:
    one, two = ["1", "1"], ["2", "2"]
    claim = ["not", ["<", "2", "1"]]
    assert proves(claim, "interval", lhs=two, rhs=one)
    assert not proves(claim, "interval", lhs=one, rhs=two)


def test_wide_enclosures_overlap_with_close_ones() -> None:
    close = ["1.4142135623730950488", "1.4142135623730950489"]
    assert proves(["<", SQRT_2, "3"], "interval", bits=2, lhs=close, rhs=["3", "3"])
    assert proves(["<", SQRT_2, "3"], "interval", bits=2, lhs=["1", close[1]], rhs=["3", "9"])
    assert proves(["<", SQRT_2, "3"], "interval", bits=2, lhs=[close[0], "2"], rhs=["-1", "3"])


def test_tiny_and_huge_numbers() -> None:
    tiny, huge = "1/1" + "0" * 4000, "1" + "0" * 4000
    assert proves(["<", ["mul", tiny, tiny], tiny], "interval")
    assert proves(["<", ["sqrt", tiny], ["mul", "1/9", ["div", "10", ["sqrt", huge]]]], "interval")
    assert not proves(["<", ["sqrt", tiny], ["div", "1", ["sqrt", huge]]], "interval")
