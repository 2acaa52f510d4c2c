"""Contexts and scopes: what may be named and used where."""

from __future__ import annotations

from typing import Any

import pytest

from tests.check.support import (
    IDENTITY,
    INTERVAL,
    Pair,
    answer,
    box,
    cuts,
    instance,
    interval,
    total,
    verdict,
    witness,
)  # fmt: skip


def family() -> Pair:
    """``child`` and ``other`` inside ``box``; ``alone`` beside it."""
    pair = box(("0", "1"))
    for name in ("child", "other"):
        pair.context(name, {f"{name}-v": "x"}, {}, [], "box")
    pair.context("alone", {"u": "1"}, {"u-low": "1 <= u"})
    return pair.lemma("inside", "0 <= x + 1", total("goal", "x-low", "1"), "child")


@pytest.mark.parametrize(
    ("context", "fact", "good"),
    [("box", "x-low", True), ("child", "x-low", True), ("other", "x-low", True),
     (None, "x-low", False), ("alone", "x-low", False), ("child", "inside", True),
     ("other", "inside", False), ("box", "inside", False), ("alone", "u-low", True),
     ("child", "u-low", False)],
)  # fmt: skip
def test_facts_are_usable_in_their_context_and_inside(
    context: str | None, fact: str, good: bool
) -> None:
    pair = family()
    pair.lemma("uses", "0 <= 1", total("goal", "1", ["mul", "0", fact]), context)
    found = verdict(pair.row("row", "0 <= 1", INTERVAL))
    assert (found == "proved") == good
    assert good or f"found {fact}, which is a fact of " in found


def test_what_is_known_to_be_positive_is_known_inside() -> None:
    for context, good in (("one", True), ("in-one", True), ("two", False)):
        pair = Pair().context("one", {"x": "1"}, {"p": "0 < x"})
        pair.context("in-one", {"y": "x"}, {}, [], "one").context("two", {"z": "1"}, {})
        name = "z" if context == "two" else "x"
        pair.row("row", f"{name}/{name} = 1", IDENTITY, context)
        assert (verdict(pair) == "proved") == good


def test_what_is_proved_inside_is_not_known_outside() -> None:
    """0 < 2 as a fact of a context makes no root positive beside it."""
    pair = Pair().context("one", {"x": "1"}, {"p": "0 < x"}).lemma("two", "0 < 2", INTERVAL, "one")
    pair.row("row", "0 < sqrt(2)", {"rule": "root"})
    assert "not known to be positive" in verdict(pair)
    pair.steps[-1]["proof"], pair.statement["obligations"][-1]["context"] = {"rule": "root"}, "one"
    assert verdict(pair) == "proved"


def test_a_hypothesis_is_not_known_after_its_branch() -> None:
    """Terms are the same objects; what a branch knows of them is not remembered."""
    pair = box(("-1", "1")).lemma(
        "first", "0 <= x*x", cuts("x", ["0"], *[total("goal", ["square", "x"])] * 2), "box"
    )
    root = ["square", ["sqrt", "x"]]
    branch = total("goal", ["mul", "x-high", "0"], root)
    proof = cuts("x", ["0"], total("goal", "@1"), branch)
    found = verdict(pair.row("row", "0 <= x + 5", proof, "box"))
    assert "REFUSED" in found
    pair = box(("-1", "1"))
    inner = cuts("x", ["0"], total("goal", "x-low"), total("goal", "x-low", ["mul", "0", root]))
    pair.row("row", "-1 <= x", inner, "box")
    assert verdict(pair) == "proved"
    pair.steps[-1]["proof"]["branches"].reverse()
    assert "the root of a term" in verdict(pair)
    pair.steps[-1]["proof"] = total("goal", "x-low", ["mul", "0", root])
    assert "the root of a term" in verdict(pair)


def test_enclosures_are_not_remembered() -> None:
    pair = box(("0", "1")).lemma("low", "0 <= 1 - x", total("goal", "x-high"), "box")
    half = cuts("x", ["1/2"], interval(("x", "x-low", "@1")), interval(("x", "@1", "x-high")))
    pair.lemma("cut", "x*(1 - x) <= 1/2", half, "box")
    pair.row("row", "x*(1 - x) <= 1/2", interval(("x", "x-low", "x-high")), "box")
    assert "expected <= between them" in verdict(pair)
    pair.steps[-1]["proof"] = INTERVAL
    assert "found a variable without bounds" in verdict(pair)


def test_a_point_over_the_names_of_the_parent() -> None:
    for point, reason in (
        ("x", "proved"),
        ("x + 1", "proved"),
        ("0 - 1 - x", "REFUSED open c"),
        ("y", "not in scope"),
        ("z", "no name so far"),
        ("1/x", "division"),
    ):
        pair = box(("0", "1"))
        pair.context("c", {"y": point}, {"low": "0 <= y"}, [total("goal", "x-low")], "box")
        if point == "x + 1":
            pair.steps[-1]["givens"] = [total("goal", "x-low", "1")]
        assert reason in verdict(pair.row("row", "0 <= 1", INTERVAL))


@pytest.mark.parametrize("point", [{}, {"x": "1", "y": "1"}, {"y": "1"}, {"c": "1"}])
def test_a_point_for_each_variable(point: dict[str, str]) -> None:
    pair = Pair().context("c", {"x": "1"}, {}).row("row", "0 <= 1", INTERVAL)
    pair.statement["contexts"][0]["point"] = point
    assert "point: found too many or too few variables: " in verdict(pair)


def test_givens_are_defined_by_earlier_ones() -> None:
    givens = {"p": "0 < y", "q": "1/y <= 2", "r": "0 <= sqrt(y)"}
    pair = Pair().context("c", {"y": "1"}, givens).row("row", "0 <= 1", INTERVAL)
    assert verdict(pair) == "proved"
    reverse = dict(reversed(givens.items()))
    pair = Pair().context("c", {"y": "1"}, reverse).row("row", "0 <= 1", INTERVAL)
    assert "REFUSED open c: found the root of a term" in verdict(pair)
    pair = Pair().context("c", {"y": "1"}, {"s": "1/y <= 2"}).row("row", "0 <= 1", INTERVAL)
    assert "REFUSED open c: found a division by" in verdict(pair)
    pair = Pair().context("c", {"y": "1"}, {"s": "2 <= 3/y"}).row("row", "0 <= 1", INTERVAL)
    assert "REFUSED open c: found a division by" in verdict(pair)


def test_givens_are_defined_by_facts_of_the_parent() -> None:
    pair = Pair().context("c", {"y": "1"}, {"p": "0 < y"})
    pair.context("d", {"z": "y"}, {"q": "z/y <= 2"}, [total("goal", "p")], "c")
    assert verdict(pair.row("row", "z <= 2*y", total("goal", "q"), "d")) == "proved"


def test_givens_at_the_point_are_not_usable_for_the_next_at_the_point() -> None:
    pair = Pair().context("c", {"y": "1"}, {"p": "0 < y", "q": "0 < y + 0"}, [INTERVAL, "p"])
    assert "found p, which is a fact of c only" in verdict(pair.row("row", "0 <= 1", INTERVAL))


def test_a_refused_context() -> None:
    """Its rows are refused too, and so are its children."""
    pair = Pair().context("c", {"y": "0"}, {"a": "0 <= y", "b": "0 < y"})
    pair.context("d", {"z": "y"}, {}, [], "c").row("in-c", "0 <= y", total("goal", "a"), "c")
    pair.row("in-d", "0 <= y", total("goal", "a"), "d").row("outside", "0 <= 1", INTERVAL)
    pair.row("at", "0 <= 5", instance("a", {"y": "5"}, INTERVAL, INTERVAL))
    lines = answer(pair)[1]
    assert [line.split()[0] for line in lines[:6]] == ["REFUSED"] * 4 + ["proved"] * 2
    assert "found c, which could not be opened" in lines[1]
    assert "found c, which could not be opened" in lines[2]
    assert "found d, which could not be opened" in lines[3]


def test_a_refused_fact_is_not_usable() -> None:
    uses: list[Any] = [
        total("goal", "bad"), total("goal", using=["bad"]), total("goal", equations=[("bad", "1")]),
        interval(("x", "bad", "x-high")), instance("bad", {"x": "x"}, "x-low", "x-high"),
    ]  # fmt: skip
    for proof in uses:
        pair = box(("0", "1")).lemma("bad", "1 <= x", IDENTITY, "box")
        lines = answer(pair.row("row", "1 <= x", proof, "box"))[1]
        assert "found bad, whose proof was refused" in lines[1]


def test_contexts_in_order() -> None:
    pair = Pair().context("d", {}, {}, [], "c").context("c", {}, {}).row("r", "0 <= 1", INTERVAL)
    assert "found no context c so far" in verdict(pair)
    pair = Pair().context("c", {}, {}, [], "c").row("r", "0 <= 1", INTERVAL)
    assert "found no context c so far" in verdict(pair)
    pair = Pair().context("c", {}, {}).context("d", {}, {}, [], "c").row("r", "0 <= 1", INTERVAL)
    pair.steps.reverse()
    assert "open d: found c, which is not open so far" in verdict(pair)


@pytest.mark.parametrize("name", ["", "1", "_x", "a b", "a:b", "é", "x" * 101, "a\n", "@1", "-a"])
def test_names(name: str) -> None:
    pair = Pair().context("c", {}, {}).row("row", "0 <= 1", INTERVAL)
    pair.statement["contexts"][0]["name"] = name
    assert "expected a name" in verdict(pair)


def test_long_names_and_deep_terms_are_allowed() -> None:
    pair = Pair().constant("x" * 100, "1").row("row", "0 <= 1", INTERVAL)
    assert verdict(pair) == "proved"
    pair.terms = {"t0": "1"} | {f"t{i + 1}": ["add", f"t{i}", "1"] for i in range(199)}
    pair.lemma("deep", ["=", "t199", "200"], IDENTITY)
    assert verdict(pair) == "proved"
    pair.terms["t200"] = ["add", "t199", "1"]
    pair.steps[-1]["claim"] = ["=", "t200", "201"]
    assert "found a term of more than 200 levels" in verdict(pair)


def test_100_contexts_inside_one_another() -> None:
    for depth, reason in ((100, "proved"), (101, "found more than 100 contexts")):
        pair, parent = Pair(), None
        for i in range(depth):
            pair.context(f"c{i}", {}, {}, [], parent)
            parent = f"c{i}"
        assert reason in verdict(pair.row("row", "0 <= 1", INTERVAL))


def test_shared_terms_are_read_where_they_are_used_first() -> None:
    pair = box(("0", "1")).constant("k", "1")
    pair.statement["terms"] = {"s": ["add", "x", "k"]}
    pair.terms = {"t": ["mul", "s", "2"]}
    pair.lemma("l", ["<=", "0", "t"], total("goal", ["mul", "2", "x-low"], "2", using=["k"]), "box")
    assert verdict(pair.row("row", "0 <= 1", INTERVAL)) == "proved"
    pair.lemma("m", ["<=", "0", "t"], total("goal"))
    assert "found a name of box, which is not in scope" in verdict(pair)
    pair = Pair().constant("k", "s")
    pair.statement["terms"] = {"s": ["add", "k", "1"]}
    assert "found k, which is no name so far" in verdict(pair.row("row", "0 <= 1", INTERVAL))


def test_a_witness_is_of_one_context() -> None:
    """What fails for values of the inner context is the claim for all of both."""
    pair = box(("0", "1")).context("in", {"y": "x"}, {"low": "x <= y"}, [total("goal")], "box")
    pair.row("needed", "0 <= 1", INTERVAL)
    proof = witness({"y": "x + 1"}, [total("goal", "1")], total("goal", "x-low"))
    pair.row("row", "y < 1", proof, "in", "refuted", "printed")
    assert verdict(pair) == "proved"
    pair.steps[-1]["proof"]["at"]["x"] = "0"
    assert "too many or too few variables: ['x']" in verdict(pair)


@pytest.mark.parametrize(
    ("step", "reason"),
    [
        ({"obligation": "none", "proof": INTERVAL}, "obligation none: found no such row"),
        ({"obligation": "row", "proof": INTERVAL}, "obligation row: found a second step"),
        ({"open": "none", "givens": []}, "open none: found no such context"),
        ({"constant": "none", "proof": INTERVAL}, "constant none: found no such constant"),
        ({"constant": "x", "proof": INTERVAL}, "constant x: found no such constant"),
        ({"constant": "row", "define": "d"}, "expected one of ['obligation', 'lemma'"),
        ({"obligation": "row"}, "step: found too many or too few keys: ['proof']"),
        ({"lemma": "l", "context": "none", "claim": ["<", "0", "1"], "proof": INTERVAL},
         "found no context none so far"),
        ({"lemma": "l", "context": None, "claim": ["!=", "0", "1"], "proof": INTERVAL},
         "expected [<, <= or =, lhs, rhs]"),
        ({"lemma": "l", "context": None, "claim": ["always", "box", {}, {}], "proof": INTERVAL},
         "expected [<, <= or =, lhs, rhs]"),
        ({"lemma": "l:m", "context": None, "claim": ["<", "0", "1"], "proof": INTERVAL},
         "expected a name"),
        ({}, "steps: found {}, expected one of"),
        (None, "steps: found None, expected one of"),
    ],
)  # fmt: skip
def test_steps(step: Any, reason: str) -> None:
    pair = box(("0", "1")).row("row", "0 <= 1", INTERVAL)
    pair.steps.append(step)
    assert reason in verdict(pair)


@pytest.mark.parametrize(
    "value",
    [["neg"], ["neg", "1", "2"], ["add", "1"], ["add", "1", "2", "3"], ["div", "1"], ["min", "1"],
     ["min"], ["max", "1"], ["sqrt"], ["sqrt", "1", "1"], ["cos"], ["cos_pi", "1", "2"],
     ["pow", "1"], ["pow", "1", "2", "3"], ["pow", "1", ["neg", "2"]], ["name", "1"],
     ["rational", "1", "2"], ["tan", "1"], ["pi", "1"], ["root", "1"], ["root", "1", "1"],
     ["root", "1", "100"], [], [["neg"], "1"], {"neg": "1"}, None, 1, True],
)  # fmt: skip
def test_terms_have_an_operation_and_its_numbers_of_terms(value: Any) -> None:
    found = verdict(Pair().constant("c", value).row("row", "0 <= 1", INTERVAL))
    assert found.startswith("MALFORMED: constant c")


@pytest.mark.parametrize(
    "claim",
    [["<"], ["<", "0"], ["<", "0", "1", "2"], [">", "1", "0"], ["!=", "0", "1"], "0 < 1", "<", [],
     [["<"], "0", "1"], {"<": ["0", "1"]}, ["not", ["<", "0", "1"]], ["applies"], "applies",
     ["applies", "box"], ["applies", "box", []], ["applies", "box", {"x": "1"}, {}], ["always"],
     ["applies", None, {"x": "1"}], ["always", "box", {"x": "1"}, []], ["always", "box"]],
)  # fmt: skip
def test_claims_have_a_relation_and_two_sides(claim: Any) -> None:
    pair = box(("0", "1")).row("row", "0 <= 1", INTERVAL)
    pair.statement["obligations"][0]["claim"] = claim
    assert verdict(pair).startswith("MALFORMED: ")
