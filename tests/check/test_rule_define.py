"""``define``: a constant has a value, and equals its definition."""

from __future__ import annotations

from typing import Any

import pytest

from tests.check.support import (
    DEFINE,
    IDENTITY,
    INTERVAL,
    Pair,
    answer,
    box,
    interval,
    total,
    verdict,
)


@pytest.mark.parametrize(
    ("value", "proof", "reason"),
    [
        ("x + 1", DEFINE, "proved"),
        ("min(x, 2)", DEFINE, "proved"),
        ("sqrt(x)", DEFINE, "proved"),
        ("1/(1 + x)", interval(("x", "x-low", "x-high")), "proved"),
        ("1/x", DEFINE, "a division by a term that is not known"),
        ("1/x", interval(("x", "x-low", "x-high")), "found a division by [0"),
        ("1/(1 + x)", DEFINE, "a division by a term that is not known"),
        ("sqrt(x - 1)", DEFINE, "the root of a term"),
        ("sqrt(x - 1)", interval(("x", "x-low", "x-high")), "found a square root of [-1"),
        ("min(1, 1/x)", DEFINE, "a division by a term"),
        ("max(1, 1/x)", interval(("x", "x-low", "x-high")), "found a division by [0"),
        ("x", interval(), "found a variable without bounds"),
        ("0*(1/0*1)", DEFINE, "division"),
    ],
)
def test_definitions(value: str, proof: Any, reason: str) -> None:
    value: Any = ["mul", "0", ["div", "1", "0"]] if value.startswith("0*") else value
    for kind in ("inner", "define"):
        pair = box(("0", "1"))
        if kind == "inner":
            pair.inner("box", "d", value, proof)
        else:
            pair.define("d", value, proof, "box")
        assert reason in verdict(pair.row("row", "0 <= 1", INTERVAL))


@pytest.mark.parametrize("rule", ["sum", "instance", "witness", "induction", "cuts", None])
def test_other_rules_do_not_define(rule: Any) -> None:
    found = verdict(Pair().constant("c", "1", {"rule": rule}).row("row", "0 <= 1", INTERVAL))
    assert f"constant c: rule: found {rule}, expected one of ['define', 'interval']" in found


def test_a_definition_is_a_fact_of_its_context_only() -> None:
    pair = box(("0", "1")).define("d", "x + 1", context="box")
    pair.row("row", "0 <= 1", total("goal", "1", using=["d"]))
    assert "found d, which is a fact of box only" in verdict(pair)


@pytest.mark.parametrize("name", ["x", "box", "x-low", "row", "goal", "c", "short", "other", "T"])
def test_a_definition_has_a_name_of_its_own(name: str) -> None:
    pair = box(("0", "1")).constant("c", "1")
    pair.statement["terms"]["short"] = "2"
    pair.terms["other"] = "3"
    found = verdict(pair.define(name, "1").row("row", "0 <= 1", INTERVAL))
    assert (f"found the name {name} twice" in found) == (name != "T")


def test_a_refused_definition_is_no_fact_and_has_no_value() -> None:
    pair = box(("0", "1")).define("d", "1/x", context="box")
    pair.lemma("same", "d = d", IDENTITY, "box").lemma("used", "d = d", total(using=["d"]), "box")
    lines = answer(pair.row("row", "0 <= 1", INTERVAL))[1]
    assert lines[0].startswith("REFUSED define d: found a division")
    assert "found a constant before its definition is proved to have a value" in lines[1]
    assert lines[2] == "REFUSED lemma used: found d, whose proof was refused"


def test_definitions_use_earlier_names_only() -> None:
    found = verdict(Pair().constant("a", "b").constant("b", "1").row("row", "0 <= 1", INTERVAL))
    assert "constant a: found b, which is no name so far and no number" in found
    found = verdict(Pair().constant("a", "a").row("row", "0 <= 1", INTERVAL))
    assert "constant a: found a, which is no name so far and no number" in found


def test_constants_are_used_after_their_step() -> None:
    pair = Pair().constant("a", "sqrt(2)", INTERVAL).row("row", "a = a", IDENTITY)
    assert verdict(pair) == "proved"
    pair.steps.reverse()
    assert "a constant before its definition" in verdict(pair)


def test_each_constant_has_one_step() -> None:
    pair = Pair().constant("a", "1").row("row", "0 <= a", INTERVAL)
    pair.steps.append(pair.steps[0])
    assert "constant a: found a second step" in verdict(pair)
    del pair.steps[-1], pair.steps[0]
    assert "steps: found none for ['a']" in verdict(pair)
    pair.step(constant="b", proof=DEFINE)
    assert "constant b: found no such constant" in verdict(pair)
