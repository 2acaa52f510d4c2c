"""``witness``: not for all values, as the negation holds at these."""

from __future__ import annotations

from typing import Any

import pytest

from tests.check.support import (
    IDENTITY,
    INTERVAL,
    answer,
    box,
    interval,
    total,
    verdict,
    witness,
)  # fmt: skip

IN = [INTERVAL, INTERVAL]


def refutes(claim: Any, proof: Any, context: str | None = "box") -> str:
    pair = box(("0", "1")).row("needed", "0 <= 1", INTERVAL)
    return verdict(pair.row("row", claim, proof, context, "refuted", "printed"))


@pytest.mark.parametrize(
    ("claim", "at", "reason"),
    [
        ("x < 1", "1", "proved"),
        ("x <= 1/2", "1", "proved"),
        ("x = 1/2", "1", "proved"),
        ("0 < x", "0", "proved"),
        ("x <= 1", "1", "expected < between them"),
        ("x <= 1", "2", "expected <= between them"),
        ("0 <= x", "-1", "expected <= between them"),
        ("x < 1", "1/2", "expected <= between them"),
        ("x = 1/2", "1/2", "expected != between them"),
        ("1/x < 1", "0", "division by [0, 0]"),
        ("sqrt(x - 1) <= 0", "0", "found a square root of [-1"),
    ],
)
def test_witnesses(claim: str, at: str, reason: str) -> None:
    assert reason in refutes(claim, witness({"x": at}, IN, INTERVAL))


@pytest.mark.parametrize(
    ("proof", "reason"),
    [
        (witness({}, IN, INTERVAL), "too many or too few variables: ['x']"),
        (witness({"x": "1", "y": "1"}, IN, INTERVAL), "too many or too few variables: ['y']"),
        (witness({"x": "x"}, IN, INTERVAL), "found a name of box, which is not in scope"),
        (witness({"x": "1"}, IN[:1], INTERVAL), "found 1 proofs, expected 2"),
        (witness({"x": "1"}, [], INTERVAL), "found 0 proofs, expected 2"),
        (witness({"x": "1"}, ["x-low", "x-high"], INTERVAL), "which is a fact of box only"),
        (witness({"x": "1"}, IN, None), "rule: found None"),
        (witness({"x": "1"}, IN, "x-high"), "rule: found x-high"),
        (witness({"x": "1"}, IN, witness({"x": "1"}, IN, INTERVAL)), "rule: found witness"),
        (witness({"x": ["div", "1", ["sub", "1", "1"]]}, IN, INTERVAL), "division"),
        (INTERVAL, "found a variable without bounds"),
    ],
)  # fmt: skip
def test_near_misses(proof: Any, reason: str) -> None:
    assert reason in refutes("x < 1", proof)


def test_without_variables_the_negation_itself_is_proved() -> None:
    assert refutes("1 < 1", INTERVAL, None) == "proved"
    assert "expected <= between them" in refutes("1 < 2", INTERVAL, None)
    assert "found a witness, but no variable" in refutes("1 < 1", witness({}, [], INTERVAL), None)


def test_the_negation_for_all_values_refutes_too() -> None:
    """A context has a point, so what fails everywhere does not hold everywhere."""
    bounds = interval(("x", "x-low", "x-high"))
    assert refutes("2 <= x", bounds) == "proved"
    assert refutes("x < 0", total("goal", "x-low")) == "proved"
    assert "expected < between them" in refutes("1 <= x", bounds)


def test_a_proved_row_has_no_witness() -> None:
    pair = box(("0", "1")).row("row", "x <= 1", witness({"x": "1"}, IN, INTERVAL), "box")
    assert "rule: found witness, expected one of" in verdict(pair)


def test_a_refuted_row_is_no_fact() -> None:
    pair = box(("0", "1"))
    pair.row("row", "x < 1", witness({"x": "1"}, IN, INTERVAL), "box", "refuted", "printed")
    pair.row("next", "x < 1", total("goal", "row"), "box")
    assert "found row, which is no fact so far" in verdict(pair)


def test_a_needed_row_that_is_refuted_refutes() -> None:
    pair = box(("0", "1"))
    pair.row("row", "x < 1", witness({"x": "1"}, IN, INTERVAL), "box", "refuted")
    code, lines = answer(pair)
    assert (code, lines[0]) == (1, "proved  row [L] not (lhs < rhs throughout the context box)")
    assert lines[-1].startswith(
        "REFUTED: T's title: 0 needed proved, 0 printed proved, 1 needed re"
    )


def test_values_over_the_parent() -> None:
    """For some y in [x, 2x], whatever x in [1, 2]: not y < 3/2 x."""
    pair = box(("1", "2"))
    givens = {"y-low": "x <= y", "y-high": "y <= 2*x"}
    premises = [total("goal"), total("goal", "x-low", "1")]
    pair.context("inner", {"y": "x"}, givens, premises, "box").row("needed", "0 <= 1", INTERVAL)
    proof = witness({"y": "2*x"}, [total("goal", "x-low", "1"), total("goal")],
                    total("goal", ["mul", "1/2", "x-low"], "1/2"))  # fmt: skip
    pair.row("row", "y < 3/2*x", proof, "inner", "refuted", "printed")
    assert verdict(pair) == "proved"
    pair.steps[-1]["proof"]["at"]["y"] = ["mul", "3", "x"]
    assert "REFUSED" in verdict(pair)
    pair.steps[-1]["proof"]["at"]["y"] = "y"
    assert "not in scope" in verdict(pair)


def test_the_two_sides_are_defined_at_the_witness() -> None:
    assert "division" in refutes("1/x = 1/x", witness({"x": "0"}, IN, IDENTITY))
