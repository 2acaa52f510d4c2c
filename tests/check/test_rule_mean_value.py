"""``mean_value``: on a box a term is its value at a point, and slopes times distances."""

from __future__ import annotations

from typing import Any

import pytest

from tests.check.support import Pair, cuts, interval, verdict

Json = Any
X, Y = ("x", "x-low", "x-high"), ("y", "y-low", "y-high")


def mean(at: Json, *bounds: tuple[str, str, str], bits: int = 64, **more: Json) -> dict[str, Json]:
    """The rule with bounds of x, unless there are others."""
    found = {**interval(*(bounds or (X,)), bits=bits), "rule": "mean_value", "at": at}
    return {**found, **more}


def on(low: str, high: str) -> Pair:
    """The context c, with x and y between the same numbers."""
    givens = {
        f"{name}-{side}": ["<=", *pair]
        for name in "xy"
        for side, pair in (("low", (low, name)), ("high", (name, high)))
    }
    return Pair().context("c", {"x": low, "y": low}, givens)


def found(claim: str, proof: Json, low: str = "0", high: str = "1") -> str:
    return verdict(on(low, high).row("row", claim, proof, "c"))


@pytest.mark.parametrize(
    ("claim", "at"),
    [
        ("sin(x) <= x", "0"),
        ("x - x**3 <= x", "0"),
        ("x - 1 < x", "1/2"),
        ("x*exp(-x) <= x", "0"),
        ("log(1 + x) <= x", "0"),
        ("atan(x) <= x", "0"),
        ("1 - 1/(1 + x) <= x", "0"),
        ("sqrt(1 + x) <= 1 + x", "0"),
        ("cos_pi(x) <= 5/2 - x", "1"),
        ("x*(1 - x) < 13/10", "1/2"),
        ("x*(1 - x) < 13/10", "1"),
        ("-x <= x", "0"),
        ("0 <= 1 - x", "1"),
        ("x/3 + 1/2 < 1", "1"),
    ],
)
def test_what_occurs_twice_is_the_same(claim: str, at: str) -> None:
    assert found(claim, mean({"x": at})) == "proved"


def test_a_root() -> None:
    sides = ["root", ["add", "1", "x"], "3"], ["add", "1", "x"]
    pair = on("0", "1").row("row", ["<=", *sides], mean({"x": "0"}), "c")
    assert verdict(pair) == "proved"


@pytest.mark.parametrize(
    ("claim", "at", "reason"),
    [
        # it is true at the point, and false elsewhere, on either side
        ("x <= 1/2", "0", "expected 0 <= it"),
        ("1/2 <= x", "1", "expected 0 <= it"),
        ("x <= 1/2", "1/2", "expected 0 <= it"),
        ("1/2 <= x", "1/2", "expected 0 <= it"),
        ("x*(1 - x) <= 6/25", "0", "expected 0 <= it"),
        ("x*(1 - x) <= 6/25", "1", "expected 0 <= it"),
        # it is true, with equality
        ("sin(x) < x", "0", "expected 0 < it"),
        ("0 < 1 - x", "1", "expected 0 < it"),
        # a wrong end
        ("sin(x) <= x", "1", "expected 0 <= it"),
        # the point lies outside of the box
        ("x <= 2", "2", "found x outside of [0, "),
        ("x <= 2", "-1/9", "found x outside of [0, "),
        # other relations
        ("x = x", "0", "found =, expected < or <="),
        # what is not defined on all of the box, at a place that the slope does not see
        ("0 <= 9 + x + 0*log(x - 1/2)", "1", "found a logarithm"),
        ("0 <= 9 + x + sqrt(x - 1/2)", "1", "found a square root"),
        ("0 <= 9 + x + 1/(x - 1/2)", "1", "found a division"),
        # and where only the slope is not defined
        ("0 <= sqrt(x)", "1", "found a division"),
        # what has no slope
        ("min(x, 1 - x) <= x", "0", "found no derivative of min"),
        ("0 <= max(x, 1 - x)", "0", "found no derivative of max"),
        ("y - y <= 0", "0", "in which the variable does not occur"),
        ("0 <= 1", "0", "in which the variable does not occur"),
    ],
)
def test_near_misses(claim: str, at: str, reason: str) -> None:
    assert reason in found(claim, mean({"x": at}, X, Y))


def test_a_logarithm_of_a_negative_number_has_a_slope() -> None:
    """1/x + 1 is defined on [-2, -1], log x is not."""
    claim = "0 <= 9 + x + log(x)"
    assert "found a logarithm" in found(claim, mean({"x": "-1"}), "-2", "-1")


@pytest.mark.parametrize(
    ("change", "reason"),
    [
        ({"at": {"y": "0"}}, "at: found y, expected a variable with bounds"),
        ({"at": {"z": "0"}}, "at: found z, expected a variable with bounds"),
        ({"at": {"c": "0"}}, "at: found c, expected a variable with bounds"),
        ({"at": {}}, "expected 0 <= it"),
        ({"bounds": []}, "found a variable without bounds"),
        ({"bounds": [], "at": {}}, "found a variable without bounds"),
        ({"bounds": [["x", "x-low", "y-high"]]}, "which does not bound x"),
        ({"bounds": [["x", "x-high", "x-low"]]}, "which does not bound x"),
        ({"at": {"x": "1/0"}}, "MALFORMED"),
        ({"at": {"x": "y"}}, "MALFORMED"),
        ({"at": {"x": 0}}, "MALFORMED"),
        ({"at": ["x"]}, "MALFORMED"),
        ({"bits": 1}, "MALFORMED"),
        ({"more": "x"}, "MALFORMED"),
    ],
)
def test_other_near_misses(change: dict[str, Json], reason: str) -> None:
    assert reason in found("sin(x) <= x", {**mean({"x": "0"}), **change})


@pytest.mark.parametrize(
    ("claim", "at", "good"),
    [
        ("x*y - y <= 2*x", {"x": "0", "y": "0"}, True),
        ("sin(x) + sin(y) <= x + y", {"x": "0", "y": "0"}, True),
        ("sin(x) + sin(y) < x + y", {"x": "0", "y": "0"}, False),
        ("sin(x) + sin(y) <= x + y", {"x": "0"}, False),
        ("sin(x) + sin(y) <= x + y", {"y": "0"}, False),
        ("sin(x) + sin(y) <= x + y", {"x": "0", "y": "1"}, False),
        ("sin(x) + sin(y) <= x + y + 1", {"x": "0"}, True),
        ("y <= x + 1", {"x": "0"}, True),
        ("y < x + 1", {"x": "0"}, False),
        ("x + y <= 3/2", {"x": "0", "y": "0"}, False),
        ("x + y <= 3/2", {"x": "1", "y": "0"}, False),
        ("x + y <= 2", {"x": "1", "y": "1"}, True),
        ("x*y <= 1", {"x": "1", "y": "1"}, True),
        ("x*y <= 99/100", {"x": "1", "y": "1"}, False),
    ],
)
def test_two_variables(claim: str, at: dict[str, str], good: bool) -> None:
    assert (found(claim, mean(at, X, Y)) == "proved") == good


def test_a_constant_has_a_slope_and_no_bounds() -> None:
    """k = x^2 is not 0 where x is moved, whatever a fact says of it where x is."""
    pair = on("0", "1").inner("c", "k", "x**2")
    proof = mean({"x": "1"})
    assert verdict(pair.row("row", "k + x <= 2", proof, "c")) == "proved"
    pair = on("0", "1").inner("c", "k", "x**2")
    assert "expected 0 <= it" in verdict(pair.row("row", "k + x <= 19/10", proof, "c"))
    pair = Pair().context("c", {"x": "0"}, {"x-low": "0 <= x", "x-high": "x <= 1"})
    pair.inner("c", "k", "x**2").lemma("low", "0 <= k", interval(X), "c")
    pair.lemma("high", "k <= 1", interval(X), "c")
    proof = mean({"x": "1"}, X, ("k", "low", "high"))
    assert "found bounds of the constant k" in verdict(pair.row("row", "k <= 1", proof, "c"))


def inside() -> Pair:
    """z between 0 and 1 in a context in which x and y are fixed."""
    givens = {"z-low": "0 <= z", "z-high": "z <= 1"}
    return on("0", "1").context("inner", {"z": "0"}, givens, parent="c")


def test_variables_of_contexts_around_are_fixed() -> None:
    z = ("z", "z-low", "z-high")
    proof = mean({"z": "0"}, X, z)
    claim = "sin(z) - x <= z"
    assert verdict(inside().row("row", claim, proof, "inner")) == "proved"
    proof = mean({"x": "0", "z": "0"}, X, z)
    reason = "at: found x, expected a variable with bounds"
    assert reason in verdict(inside().row("row", claim, proof, "inner"))


def test_bounds_by_hypotheses_and_other_variables() -> None:
    """On [0, 1/2] and [1/2, 1] the slope of x - x^2 has a sign."""
    halves = [mean({"x": c}, bound) for c, bound in (
        ("0", ("x", "x-low", "@1")), ("1", ("x", "@1", "x-high")),
    )]  # fmt: skip
    claim = "0 <= x*(1 - x)"
    assert found(claim, cuts("x", ["1/2"], *halves)) == "proved"
    assert "expected 0 <= it" in found(claim, cuts("x", ["1/3"], *halves))
    pair = Pair().context("c", {"x": "0", "y": "0"}, {
        "x-low": "0 <= x", "x-high": "x <= 1", "y-low": "0 <= y", "y-high": "y <= x**2",
    })  # fmt: skip
    assert verdict(pair.row("row", "sin(y) <= y", mean({"y": "0"}, X, Y), "c")) == "proved"


def test_proofs_one_after_another() -> None:
    """Slopes are kept, for each difference and each variable."""
    pair = on("0", "1")
    for i, (claim, at) in enumerate(
        [("x*y <= x + y", {"x": "0", "y": "0"}), ("x*y <= x + y", {"x": "0"}),
         ("x*y <= x + y", {"y": "0"}), ("x <= 2*x + y", {"x": "0", "y": "0"})]
    ):  # fmt: skip
        pair.lemma(f"l{i}", claim, mean(at, X, Y), "c")
    assert verdict(pair.row("row", "sin(x) <= x", mean({"x": "0"}), "c")) == "proved"
    pair = on("0", "1").lemma("l", "sin(x) <= x", mean({"x": "0"}), "c")
    assert "REFUSED" in verdict(pair.row("row", "2*x <= sin(x) + 1", mean({"x": "0"}), "c"))


def test_few_bits_are_rounded_outward() -> None:
    """What is missing is a thousandth."""
    claim = "x*(2 - x) < 1001/1000"
    halves = mean({"x": "1"})
    assert "expected 0 < it" in found(claim, mean({"x": "1"}, bits=4))
    assert found("x - x**2/8 < 1", {**halves, "at": {"x": "1"}}) == "proved"
    assert "expected 0 < it" in found("x*1000/1001 < 1000/1001", mean({"x": "1"}, bits=64))
