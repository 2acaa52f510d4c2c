"""``instance``: what holds for all values that satisfy the givens holds for these."""

from __future__ import annotations

from typing import Any

import pytest

from tests.check.support import (
    BOUNDS,
    IDENTITY,
    INTERVAL,
    Pair,
    answer,
    box,
    cuts,
    in_box,
    instance,
    interval,
    total,
    verdict,
)  # fmt: skip

X = interval(BOUNDS)


def scene() -> Pair:
    """0 <= x <= 1 <= u; x in ``box``, u in ``other``, y in ``inside`` inside ``box``."""
    pair = box(("0", "1")).inner("box", "d", "x*x")
    pair.context("other", {"u": "1"}, {"u-low": "1 <= u"})
    pair.context("inside", {"y": "x"}, {"y-low": "x <= y"}, [IDENTITY_LE], parent="box")
    pair.lemma("square", "x*x <= x", total("goal", ["mul", "x-low", "x-high"]), "box")
    pair.lemma("named", "d <= x", total("goal", ["mul", "x-low", "x-high"], using=["d"]), "box")
    return pair.lemma("deep", "0 <= y", total("goal", "x-low", "y-low"), "inside")


IDENTITY_LE = total("goal")
HALF = [INTERVAL, INTERVAL]
INVERSE = [interval(("u", "u-low", "u-low")), total("goal", "u-low")]


@pytest.mark.parametrize(
    ("claim", "context", "proof", "reason"),
    [
        ("1/2*(1/2) <= 1/2", None, instance("square", {"x": "1/2"}, *HALF), "proved"),
        ("1/4 <= 1/2", None, instance("square", {"x": "1/2"}, *HALF), "found another claim than"),
        ("1/2*(1/2) < 1/2", None, instance("square", {"x": "1/2"}, *HALF), "found another claim"),
        ("1/2 <= 1/2*(1/2)", None, instance("square", {"x": "1/2"}, *HALF), "found another"),
        ("1/2*(1/2) <= 1/2", None, instance("named", {"x": "1/2"}, *HALF), "proved"),
        ("1/3*(1/3) <= 1/2", None, instance("named", {"x": "1/2"}, *HALF), "found another claim"),
        ("2*2 <= 2", None, instance("square", {"x": "2"}, *HALF), "expected <= between them"),
        ("(0 - 1)*(0 - 1) <= 0 - 1", None, instance("square", {"x": "0 - 1"}, *HALF),
         "expected <= between them"),
        ("1/2*(1/2) <= 1/2", None, instance("square", {"x": "1/2"}, INTERVAL),
         "found 1 proofs, expected 2"),
        ("1/2*(1/2) <= 1/2", None, instance("square", {"x": "1/2"}), "0 proofs, expected 2"),
        ("1/2*(1/2) <= 1/2", None, instance("square", {"x": "1/2"}, *HALF, INTERVAL), "3 proofs"),
        ("1/2*(1/2) <= 1/2", None, instance("square", {}, *HALF), "too few variables: ['x']"),
        ("1/2*(1/2) <= 1/2", None, instance("square", {"x": "1/2", "d": "1"}, *HALF),
         "too many or too few variables: ['d']"),
        ("1/2*(1/2) <= 1/2", None, instance("square", {"u": "1/2"}, *HALF), "['u', 'x']"),
        ("1/2*(1/2) <= 1/2", None, instance("missing", {"x": "1/2"}, *HALF), "no fact so far"),
        ("1/2*(1/2) <= 1/2", None, instance("@1", {"x": "1/2"}, *HALF), "instance.of: found @1"),
        ("u*u <= u", "other", instance("square", {"x": "u"}, *HALF), "REFUSED"),
        ("u*u <= u", "other", instance("square", {"x": "u"}, "u-low", "u-low"), "another claim"),
        ("x*x <= x", "other", instance("square", {"x": "x"}, *HALF), "not in scope"),
        ("1/u*(1/u) <= 1/u", "other", instance("square", {"x": "1/u"}, *HALF), "division"),
        ("x*x*(x*x) <= x*x", "box", instance("square", {"x": "x*x"}, X, X), "proved"),
        ("d*d <= d", "box", instance("square", {"x": "d"}, X, X), "proved"),
        ("1 - x <= 1", "box", instance("square", {"x": "1 - x"}, X, X), "another claim"),
        ("0 <= 1", None, instance("deep", {"y": "1"}, INTERVAL), "outside the parent of inside"),
        ("0 <= u", "other", instance("deep", {"y": "u"}, "u-low"), "outside the parent of inside"),
        ("0 <= x + 1", "box", instance("deep", {"y": "x + 1"}, total("goal", "1")), "proved"),
        ("0 <= x - 1", "box", instance("deep", {"y": "x - 1"}, total("goal", "1")), "not 0"),
        ("0 <= y + y", "inside",
         instance("deep", {"y": "y + y"}, total("goal", "x-low", "y-low", "y-low")), "proved"),
        ("0 <= 1", None, instance("ground", {}), "found a place outside the parent"),
    ],
)  # fmt: skip
def test_instances(claim: str, context: str | None, proof: Any, reason: str) -> None:
    pair = scene().lemma("ground", "0 <= 1", INTERVAL)
    assert reason in verdict(pair.row("row", claim, proof, context))


def test_values_are_substituted_at_once() -> None:
    pair = box(("0", "1"), ("2", "3"))
    bounds = interval(BOUNDS, ("y", "y-low", "y-high"))
    pair.lemma("order", "x <= y", bounds, "box")
    good = instance("order", {"x": "y - 2", "y": "x + 2"}, *[bounds] * 4)
    assert verdict(pair.row("row", "y - 2 <= x + 2", good, "box")) == "proved"
    assert "another claim" in verdict(pair.row("next", "x + 2 - 2 <= x + 2", good, "box"))


def test_values_are_defined() -> None:
    """The claim does not hold where the value is not defined, whatever the givens say."""
    pair = Pair().context("free", {"v": "0"}, {}).lemma("free-v", "v = v", IDENTITY, "free")
    pair.row("row", "1/(1 - 1) = 1/(1 - 1)", instance("free-v", {"v": "1/(1 - 1)"}))
    assert "division" in verdict(pair)


def test_a_premise_may_be_the_name_of_this_very_fact() -> None:
    pair = scene().context(
        "c", {"t": "1"}, {"t-low": "0 <= t", "t-high": "t <= 1", "w": "0 <= t*t"}
    )
    proof = instance("square", {"x": "t"}, "t-low", "t-high")
    wrong = [
        (instance("square", {"x": "t"}, "t-high", "t-low"), "which is another claim"),
        (instance("square", {"x": "t"}, "w", "t-high"), "which is another claim"),
        (instance("square", {"x": "t"}, "x-low", "x-high"), "which is a fact of box only"),
        (instance("square", {"x": "t"}, "row", "t-high"), "which is no fact so far"),
        (instance("square", {"x": "t"}, "@1", "t-high"), "which no branch adds"),
        (instance("square", {"x": "t"}, None, "t-high"), "rule: found None"),
        (instance("square", {"x": "t"}, [], "t-high"), "rule: found []"),
        (instance("square", {"x": "t"}, {}, "t-high"), "rule: found None"),
    ]
    for i, (bad, reason) in enumerate(wrong):
        assert reason in verdict(pair.row(f"wrong-{i}", "t*t <= t", bad, "c"))
        del pair.steps[-1], pair.statement["obligations"][-1]
    assert verdict(pair.row("row", "t*t <= t", proof, "c")) == "proved"


def test_hypotheses_are_premises_in_their_branch() -> None:
    pair = Pair().context("free", {"v": "0"}, {"pos": "0 <= v"})
    pair.lemma("cube", "0 <= v*v*v", total("goal", ["pow", "pos", "3"]), "free")
    pair.context("box", {"x": "0"}, {"x-low": "-1 <= x", "x-high": "x <= 1"})
    claim = "0 <= x*x*x"
    proof = cuts("x", ["0"], instance("cube", {"x": "x"}), instance("cube", {"v": "x"}, "@1"))
    assert "too many or too few" in verdict(pair.row("row", claim, proof, "box"))
    pair.steps[-1]["proof"] = cuts("x", ["0"], *[instance("cube", {"v": "x"}, "@1")] * 2)
    assert "which is another claim" in verdict(pair)


def test_applies() -> None:
    for at, premises, reason in [
        ({"x": "1/2"}, HALF, "proved"),
        ({"x": "2"}, HALF, "expected <= between them"),
        ({"x": "1/2"}, HALF[:1], "found 1 proofs, expected 2"),
        ({"x": ["div", "1", ["sub", "1", "1"]]}, HALF, "division"),
        ({"y": "1/2"}, HALF, "too many or too few variables"),
        ({}, HALF, "too many or too few variables"),
        ({"x": "x"}, HALF, "not in scope"),
    ]:
        pair = box(("0", "1"))
        proof = {"rule": "instance", "givens": premises}
        assert reason in verdict(pair.row("row", ["applies", "box", at], proof))


def test_applies_has_a_proof_by_instance_and_no_negation() -> None:
    claim = ["applies", "box", {"x": "1/2"}]
    pair = box(("0", "1")).row("row", claim, INTERVAL)
    assert "rule: found interval, expected one of ['instance']" in verdict(pair)
    pair = box(("0", "1")).row("row", claim, {"rule": "instance", "givens": HALF}, None, "refuted")
    assert "row: found refuted of such a claim" in verdict(pair)
    pair = box(("0", "1")).row("row", claim, None, None, "undecided")
    assert "row: found undecided of such a claim" in verdict(pair)
    pair = box(("0", "1")).row(
        "row", ["applies", "nowhere", {}], {"rule": "instance", "givens": []}
    )
    assert "found no context nowhere so far" in verdict(pair)


def test_that_a_theorem_applies_is_no_fact() -> None:
    claim = ["applies", "box", {"x": "1/2"}]
    pair = box(("0", "1")).row("row", claim, {"rule": "instance", "givens": HALF})
    pair.row("next", "0 <= 1", total("goal", "row"))
    assert "found row, which is no fact so far" in verdict(pair)


def test_an_instance_of_a_refused_fact() -> None:
    pair = scene().lemma("false", "x <= 1/2", X, "box")
    pair.row("row", "1 <= 1/2", instance("false", {"x": "1"}, *HALF))
    assert "found false, whose proof was refused" in answer(pair)[1][1]


def test_a_hypothesis_of_a_branch_is_not_in_the_claim_of_another() -> None:
    assert "found @2, which no branch adds" in in_box(
        "x <= 1", cuts("x", ["1/2"], X, instance("x-high", {"x": "x"}, "x-low", "@2"))
    )
