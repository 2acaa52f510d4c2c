"""``have``: a claim that is proved on the way is a hypothesis for what follows."""

from __future__ import annotations

from typing import Any

import pytest

from tests.check.support import INTERVAL, Pair, cuts, ground, term, total, verdict


def have(claim: str, first: Any, then: Any) -> dict[str, Any]:
    return {"rule": "have", "claim": term(claim), "branches": [first, then]}


USED = total("goal", "@1")


@pytest.mark.parametrize(
    ("claim", "proof", "found"),
    [
        ("0 < 2", have("0 < 1", INTERVAL, total("goal", ["mul", "2", "@1"])), "proved"),
        ("0 < 2", have("0 < -1", INTERVAL, total("goal", ["mul", "2", "@1"])), "between them"),
        ("0 < -1", have("0 < 1", INTERVAL, USED), "found a sum that is not 0"),
        ("0 < 1", have("0 < 1", USED, USED), "which no branch adds"),
        ("0 < -1", have("0 < -1", total("goal", "@1"), USED), "which no branch adds"),
        ("0 < 1", {**have("0 < 1", INTERVAL, USED), "branches": [INTERVAL]}, "expected 2"),
        ("0 < 1", have("z < 1", INTERVAL, USED), "which is no name"),
    ],
)
def test_what_is_had(claim: str, proof: Any, found: str) -> None:
    assert found in ground(claim, proof)


def test_it_comes_after_the_hypotheses_of_the_branch() -> None:
    pair = Pair().context("c", {"x": "1"}, {})
    inner = have("x <= 2*x", total("goal", "@1"), total("goal", "@2"))
    other = have("x <= 0", total("goal", "@1"), total("goal", "@2"))
    branches = cuts("x", ["0"], total("goal", ["mul", "-1", "@1"]), inner)
    assert "expected a number >= 0" in verdict(pair.row("row", "x <= 2*x", branches, "c"))
    pair = Pair().context("c", {"x": "1"}, {})
    branches = cuts("x", ["0"], have("2*x <= x", total("goal", "@1"), other), inner)
    assert "found a sum that is not 0" in verdict(pair.row("row", "x <= 2*x", branches, "c"))
    pair = Pair().context("c", {"x": "1"}, {"low": "0 <= x"})
    branches = cuts("x", ["0"], total("goal", "low"), inner)
    assert verdict(pair.row("row", "x <= 2*x", branches, "c")) == "proved"


def test_what_is_had_elsewhere_is_not_known() -> None:
    pair = Pair().row("a", "0 < 1", have("0 < 1", INTERVAL, USED)).row("b", "0 < 1", USED)
    assert "which no branch adds" in verdict(pair)
