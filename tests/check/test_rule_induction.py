"""``induction``: what holds at the start, and at the next state whenever at one, always does."""

from __future__ import annotations

from typing import Any

import pytest

from tests.check.support import INTERVAL, Pair, box, induction, instance, total, verdict

HALVE = total("goal", ["mul", "1/2", "x-low"])
BELOW = total("goal", ["mul", "1/2", "x-high"], "1/2")


def halving(kind: str = "carried", assumption: str | None = None) -> Pair:
    """0 <= x <= 1 is carried from x to x/2."""
    givens = {"x-low": ("0 <= x", "carried", None), "x-high": ("x <= 1", kind, assumption)}
    pair = Pair().context("state", {"x": "1"}, givens)
    pair.statement["terms"]["following"] = ["div", "x", "2"]
    return pair


def always(start: Any = "1", following: Any = "following") -> list[Any]:
    return ["always", "state", {"x": start}, {"x": following}]


GOOD = induction([INTERVAL, INTERVAL], [HALVE, BELOW])


@pytest.mark.parametrize(
    ("claim", "proof", "reason"),
    [
        (always(), GOOD, "proved"),
        (always("2"), GOOD, "expected <= between them"),
        (always("-1"), GOOD, "expected <= between them"),
        (always(following=["mul", "2", "x"]), GOOD, "found a sum that is not 0"),
        (always(following=["sub", "x", "1/2"]), GOOD, "found a sum that is not 0"),
        (always(following=["div", "1", "x"]), GOOD, "division"),
        (always(["div", "1", ["sub", "1", "1"]]), GOOD, "division"),
        (always("x"), GOOD, "not in scope"),
        (always(), induction([INTERVAL], [HALVE, BELOW]), "found 1 proofs, expected 2"),
        (always(), induction([INTERVAL, INTERVAL], [HALVE]), "found 1 proofs, expected 2"),
        (always(), induction([INTERVAL, INTERVAL], [BELOW, HALVE]), "found a sum that is not 0"),
        (always(), induction([], []), "found 0 proofs, expected 2"),
        (always(), induction([INTERVAL, INTERVAL], ["x-low", "x-high"]), "is another claim"),
        (always(), induction(["x-low", "x-high"], [HALVE, BELOW]), "which is a fact of state only"),
        (["always", "state", {}, {"x": "x"}], GOOD, "too many or too few variables"),
        (["always", "state", {"x": "1"}, {}], GOOD, "too many or too few variables"),
        (["always", "nowhere", {"x": "1"}, {"x": "x"}], GOOD, "found no context nowhere"),
        (["always", "state", {"x": "1"}], GOOD, "expected 4 entries"),
        (["always", None, {"x": "1"}, {"x": "x"}], GOOD, "expected the name of a context"),
        (always(), INTERVAL, "expected one of ['induction']"),
    ],
)
def test_induction(claim: Any, proof: Any, reason: str) -> None:
    assert reason in verdict(halving().row("row", claim, proof))


def test_a_plain_given_is_not_carried() -> None:
    found = verdict(halving("plain").row("row", always(), GOOD))
    assert "found givens that are neither carried nor standing: ['x-high']" in found


def test_a_standing_given_is_assumed_of_each_state() -> None:
    one = induction([INTERVAL], [HALVE])
    pair = halving("standing", "law").assume("law")
    assert verdict(pair.row("row", always(), one)) == "proved"
    pair = halving("standing", "law").assume("law")
    assert "found 2 proofs, expected 1" in verdict(pair.row("row", always(), GOOD))


@pytest.mark.parametrize(
    ("kind", "assumption"),
    [("standing", None), ("standing", "other"), ("carried", "law"), ("plain", "law")],
)
def test_standing_givens_name_their_assumption(kind: str, assumption: str | None) -> None:
    pair = halving(kind, assumption).assume("law").row("row", always(), GOOD)
    assert f"found the assumption {assumption} of a {kind} given" in verdict(pair)


def test_a_standing_given_holds_at_the_point_too() -> None:
    pair = Pair().assume("law")
    pair.context("state", {"x": "2"}, {"x-high": ("x <= 1", "standing", "law")})
    assert "REFUSED open state" in verdict(pair.row("row", "0 <= 1", INTERVAL))


def test_the_next_state_is_made_of_names_of_the_state() -> None:
    pair = halving().context("time", {"t": "0"}, {"t-low": "0 <= t"}, parent="state")
    assert "not in scope" in verdict(pair.row("row", always(following="t"), GOOD))


def test_the_row_stands_in_the_parent() -> None:
    pair = box(("0", "1"))
    halves = halving()
    pair.statement["contexts"] += halves.statement["contexts"]
    pair.statement["contexts"][1]["variables"] = [{"name": "s", "letter": "s", "tex": "s"}]
    pair.statement["contexts"][1]["givens"] = []
    pair.statement["contexts"][1]["point"] = {"s": "1"}
    pair.step(open="state", givens=[])
    claim = ["always", "state", {"s": "1"}, {"s": "s"}]
    assert "found state elsewhere" in verdict(pair.row("row", claim, induction([], []), "box"))


def test_facts_of_the_state_may_be_used_for_the_next() -> None:
    pair = halving().lemma("half", "0 <= following", HALVE, "state")
    proof = induction([INTERVAL, INTERVAL], ["half", BELOW])
    assert verdict(pair.row("row", always(), proof)) == "proved"


def test_the_givens_at_the_next_state_are_not_usable() -> None:
    circular = instance("x-low", {"x": "x/2"}, "x-low", "x-high")
    proof = induction([INTERVAL, INTERVAL], [circular, BELOW])
    assert "which is another claim" in verdict(halving().row("row", always(), proof))


def test_that_it_holds_always_is_no_fact() -> None:
    pair = halving().row("row", always(), GOOD).row("next", "0 <= 1", total("goal", "row"))
    assert "found row, which is no fact so far" in verdict(pair)


@pytest.mark.parametrize("rule", [GOOD, {"rule": "witness", "at": {}, "givens": [], "negation": 0}])
def test_induction_and_witness_prove_whole_rows_only(rule: Any) -> None:
    found = verdict(halving().row("row", "0 <= 1", rule))
    assert f"rule: found {rule['rule']}, expected one of ['interval', 'cuts'" in found
