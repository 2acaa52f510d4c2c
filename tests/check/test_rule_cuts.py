"""``cuts``: a term lies between neighbouring cuts, or beyond the first or last one."""

from __future__ import annotations

import pytest

from tests.check.support import (
    BOUNDS,
    IDENTITY,
    cuts,
    ground,
    in_box,
    interval,
    total,
)

LEFT, RIGHT = interval(("x", "x-low", "@1")), interval(("x", "@1", "x-high"))
BUMP = "x*(1 - x) <= 1/2"


def test_a_split_box() -> None:
    assert "REFUSED" in in_box(BUMP, interval(BOUNDS))
    assert in_box(BUMP, cuts("x", ["1/2"], LEFT, RIGHT)) == "proved"


def test_inner_branches_have_both_ends() -> None:
    inner = interval(("x", "@1", "@2"))
    assert in_box(BUMP, cuts("x", ["1/3", "2/3"], LEFT, inner, RIGHT)) == "proved"
    swapped = interval(("x", "@2", "@1"))
    assert "does not bound" in in_box(BUMP, cuts("x", ["1/3", "2/3"], LEFT, swapped, RIGHT))


def test_cuts_inside_cuts_number_the_hypotheses_on() -> None:
    inner = cuts("x", ["1/4"], interval(("x", "x-low", "@2")), interval(("x", "@2", "@1")))
    assert in_box(BUMP, cuts("x", ["1/2"], inner, RIGHT)) == "proved"
    wrong = cuts("x", ["1/4"], interval(("x", "x-low", "@3")), interval(("x", "@2", "@1")))
    assert "found @3, which no branch adds" in in_box(BUMP, cuts("x", ["1/2"], wrong, RIGHT))


def test_a_term_may_be_cut() -> None:
    """t^2 >= 0, as a product of what is known of t on each side of 0."""
    square = total("goal", ["mul", "@1", "@1"])
    claim, t = "0 <= (x*x - 1/2)*(x*x - 1/2)", "x*x - 1/2"
    assert in_box(claim, cuts(t, ["0"], square, square)) == "proved"
    odd = total("goal", ["mul", "@1", "x-low"])
    claim = "0 <= (x*x - 1/2)*x"
    assert "REFUSED" in in_box(claim, cuts(t, ["0"], odd, odd))


@pytest.mark.parametrize("at", [["1/2", "1/2"], ["1/2", "1/3"], ["1/2", "2/4"], []])
def test_cuts_increase(at: list[str]) -> None:
    branches = [interval(BOUNDS)] * (len(at) + 1)
    assert "that do not increase" in in_box("x <= 1", cuts("x", at, *branches))


@pytest.mark.parametrize("count", [0, 1, 3])
def test_each_part_has_a_branch(count: int) -> None:
    found = in_box("x <= 1", cuts("x", ["1/2"], *[interval(BOUNDS)] * count))
    assert f"found {count} proofs, expected 2" in found


@pytest.mark.parametrize("at", ["1/0", "x", "0.5", "", "1e2", "+1", " 1", "01"])
def test_cuts_are_numbers(at: str) -> None:
    found = in_box("x <= 1", cuts("x", [at], LEFT, RIGHT))
    assert "cuts.at 1: found" in found


def test_the_term_is_defined() -> None:
    found = in_box("x <= 1", cuts("1/x", ["1"], interval(BOUNDS), interval(BOUNDS)))
    assert "found a division by a term that is not known to be > 0 or < 0" in found
    found = in_box("x <= 1", cuts("sqrt(x - 1)", ["1"], interval(BOUNDS), interval(BOUNDS)))
    assert "found the root of a term that is not known to be >= 0" in found


def test_every_branch_has_to_hold() -> None:
    proof = cuts("x", ["1/2"], LEFT, RIGHT)
    assert "REFUSED" in in_box("x <= 3/4", proof)
    assert "REFUSED" in in_box("1/4 <= x", proof)


def test_a_hypothesis_ends_with_its_branch() -> None:
    proof = cuts(
        "x",
        ["1/2"],
        cuts("x", ["1/4"], LEFT, interval(("x", "@2", "@1"))),
        interval(("x", "@2", "x-high")),
    )
    assert "found @2, which no branch adds" in in_box("x <= 1", proof)


def test_numbers_may_be_cut() -> None:
    assert ground("sqrt(2)**2 = 2", cuts("sqrt(2)", ["1"], IDENTITY, IDENTITY)) == "proved"
