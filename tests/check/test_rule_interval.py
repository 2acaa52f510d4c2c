"""``interval``: the enclosures of the two sides decide."""

from __future__ import annotations

from copy import deepcopy as copy

import pytest

from tests.check.support import BOUNDS, Pair, box, cuts, ground, in_box, interval, verdict

UNIT = interval(BOUNDS)


@pytest.mark.parametrize(
    "claim",
    ["1 < 2", "1 <= 1", "1/3 = 2/6", "sqrt(2) < 3/2", "0 < cos(1)", "cos_pi(1/3) <= 3/4",
     "min(1, 2) = 1", "max(1, sqrt(2)) < 2", "1/(1 - sqrt(2)) < 0", "(0-2)**3 < 0",
     "(0-2)**2 = 4", "-(0-1) = 1", "-sqrt(4) < -1"],
)  # fmt: skip
def test_true_claims_about_numbers(claim: str) -> None:
    assert ground(claim, interval()) == "proved"


@pytest.mark.parametrize(
    ("claim", "reason"),
    [
        ("1 < 1", "expected < between them"),
        ("2 <= 1", "expected <= between them"),
        ("1 = 2", "expected = between them"),
        ("sqrt(2) = sqrt(2)", "expected = between them"),
        ("sqrt(2)**2 <= 2", "expected <= between them"),
        ("0 < sqrt(0-1)", "found a square root of [-1"),
        ("0 <= 1/(1 - 1)", "found a division by [0, 0], which contains 0"),
        ("min(1, 1/(1-1)) <= 1", "found a division by"),
        ("2 <= max(2, sqrt(0-1))", "found a square root of"),
        ("cos(22/7) <= -1", "expected <= between them"),
    ],
)
def test_false_or_undefined_claims_about_numbers(claim: str, reason: str) -> None:
    assert reason in ground(claim, interval())


def test_the_negation_of_an_equation() -> None:
    def found(claim: str) -> str:
        pair = Pair().row("row", claim, interval(), verdict="refuted", role="printed")
        return verdict(pair.row("other", "0 <= 1", interval()))

    assert found("sqrt(2) = 1") == found("1 = sqrt(2)") == "proved"
    assert "expected != between them" in found("1 = 1")
    assert "expected != between them" in found("sqrt(4) = 2")


@pytest.mark.parametrize(
    ("claim", "good"),
    [("x <= 1", True), ("0 <= x", True), ("x < 1", False), ("0 < x", False), ("x*x <= 1", True),
     ("x - x <= 1", True), ("x - x <= 0", False), ("1/(1 + x) <= 1", True), ("1/x <= 2", False),
     ("0 <= 1/x", False), ("sqrt(x) <= 1", True), ("0 < 1 + sqrt(x)", True)],
)  # fmt: skip
def test_claims_about_a_variable(claim: str, good: bool) -> None:
    assert (in_box(claim, UNIT) == "proved") == good


def test_a_variable_needs_bounds() -> None:
    assert "found a variable without bounds" in in_box("x <= 1", interval())


@pytest.mark.parametrize(
    ("bounds", "reason"),
    [
        (("x", "x-high", "x-high"), "found x-high, which does not bound x"),
        (("x", "x-low", "x-low"), "found x-low, which does not bound x"),
        (("x", "x-high", "x-low"), "which does not bound x"),
        (("x", "y-low", "x-high"), "found y-low, which does not bound x"),
        (("box", "x-low", "x-high"), "bounds: found box, which is no name"),
        (("nobody", "x-low", "x-high"), "bounds: found nobody, which is no name"),
        (("x", "nothing", "x-high"), "found nothing, which is no fact so far"),
        (("x", "row", "x-high"), "found row, which is no fact so far"),
        (("x", "@1", "x-high"), "found @1, which no branch adds"),
        (("x", "x-low", "goal"), "found goal, which is no fact so far"),
    ],
)
def test_bounds_are_facts_about_the_name(bounds: tuple[str, str, str], reason: str) -> None:
    assert reason in in_box("x <= 1", interval(bounds), ("0", "1"), ("0", "1"))


def test_a_name_is_bounded_once() -> None:
    assert "whose value is known" in in_box("x <= 1", interval(BOUNDS, BOUNDS))


def test_a_constant_is_not_bounded() -> None:
    pair = Pair().constant("c", "2").lemma("low", "1 <= c", interval())
    pair.lemma("high", "c <= 3", interval())
    bounds = interval(("c", "low", "high"))
    assert "found bounds of c, whose value is known" in verdict(pair.row("row", "1 <= c", bounds))


def test_bounds_that_exclude_each_other() -> None:
    """Between the cuts 3 and 4 lies no x of the box; such a branch is not proved by intervals."""
    proof = cuts("x", ["3"], UNIT, interval(("x", "@1", "x-high")))
    assert "found bounds of x that exclude each other" in in_box("x <= 1", proof)


def test_a_bound_may_be_a_term_in_names_bounded_earlier() -> None:
    pair = Pair().context(
        "c",
        {"x": "0", "y": "0"},
        {"a": "0 <= x", "b": "x <= 1", "c-low": "x - 1 <= y", "c-high": "y <= 2*x"},
    )
    good, bad = ("x", "a", "b"), ("y", "c-low", "c-high")
    for bounds, found in (
        ([good, bad], "proved"),
        ([bad, good], "found a variable without bounds"),
    ):
        proof = interval(*bounds)
        answer = verdict(copy(pair).row("row", "y <= 2", proof, "c"))
        assert found in answer
    assert verdict(copy(pair).row("row", "-1 <= y", interval(good, bad), "c")) == "proved"
    assert "REFUSED" in verdict(copy(pair).row("row", "y <= 199/100", interval(good, bad), "c"))


def test_equations_bound_on_both_sides() -> None:
    for claim in ("x = 2", "2 = x"):
        pair = Pair().context("c", {"x": "2"}, {"is": claim})
        assert verdict(pair.row("row", "x <= 2", interval(("x", "is", "is")), "c")) == "proved"
        pair = Pair().context("c", {"x": "2"}, {"is": claim})
        assert "REFUSED" in verdict(pair.row("row", "x < 2", interval(("x", "is", "is")), "c"))


def test_definitions_are_unfolded() -> None:
    pair = box(("0", "1")).inner("box", "d", "x**2 + 1").define("e", "d*d", context="box")
    assert verdict(copy(pair).row("row", "1 <= d*d", UNIT, "box")) == "proved"
    pair.lemma("lemma", "e <= 4", UNIT, "box")
    assert "proved" == verdict(pair.row("row", "d <= 2", UNIT, "box"))


def test_a_name_with_a_definition_may_have_bounds() -> None:
    pair = box(("0", "1")).inner("box", "d", "x - x")
    pair.lemma("low", "0 <= d", ZERO, "box").lemma("high", "d <= 0", ZERO, "box")
    assert verdict(copy(pair).row("row", "d <= 0", interval(("d", "low", "high")), "box")) == (
        "proved"
    )
    assert "REFUSED" in verdict(pair.row("row", "d <= 0", UNIT, "box"))


ZERO = {"rule": "sum", "using": ["d"], "addends": ["goal"], "equations": []}


def test_precision_decides() -> None:
    claim = f"sqrt(2)*sqrt(2) <= 2 + 1/{10**30}"
    assert "REFUSED" in ground(claim, interval(bits=64))
    assert ground(claim, interval(bits=128)) == "proved"


def test_bits_alone_are_a_proof_without_bounds() -> None:
    claim = f"sqrt(2)*sqrt(2) <= 2 + 1/{10**30}"
    assert "REFUSED" in ground(claim, 64)
    assert ground(claim, 128) == "proved"
    assert "found a variable without bounds" in in_box("x <= 1", 64, ("0", "1"))


@pytest.mark.parametrize("bits", [0, 1, 65537, 99999999])
def test_bits_alone_have_bounds(bits: int) -> None:
    assert f"interval: found {bits}, expected 2 to 65536" in ground("1 < 2", bits)


@pytest.mark.parametrize("proof", [True, None, [], "64"])
def test_bits_alone_are_a_number(proof: object) -> None:
    assert "rule: found" in ground("1 < 2", proof)


@pytest.mark.parametrize("bits", [0, 1, 65537, 99999999, True, "64", None, []])
def test_bits_have_bounds(bits: object) -> None:
    assert f"interval.bits: found {bits}, expected 2 to 65536" in ground(
        "1 < 2", interval(bits=bits)
    )


def test_odd_powers_are_monotone() -> None:
    claim = "x**3 <= 1"
    bounds = ("-2", "1")
    assert in_box(claim, UNIT, bounds) == "proved"
    assert in_box("-8 <= x**3", UNIT, bounds) == "proved"
    assert "REFUSED" in in_box("-7 <= x**3", UNIT, bounds)
    assert "REFUSED" in in_box("x**3 <= 0", UNIT, bounds)
    assert in_box("0 <= x**2", UNIT, bounds) == in_box("x**2 <= 4", UNIT, bounds) == "proved"
    assert "REFUSED" in in_box("x**2 <= 1", UNIT, bounds)
    assert "REFUSED" in in_box("1/1000 <= x**2", UNIT, bounds)
