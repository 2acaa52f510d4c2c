"""``cases``: a minimum is one of its entries, the least."""

from __future__ import annotations

from typing import Any

import pytest

from tests.check.support import BOUNDS, IDENTITY, box, cases, in_box, interval, total, verdict

BOTH = total(using=["@1"])


@pytest.mark.parametrize(
    ("claim", "of", "branches", "reason"),
    [
        # m m = (x + 2) m - 2 x: m is a root of (m - x)(m - 2)
        ("(m - x)*(m - 2) = 0", "min(x, 2)", [BOTH, BOTH], "proved"),
        ("(m - x)*(m - 1) = 0", "min(x, 2)", [BOTH, BOTH], "found sides that differ"),
        ("m <= x", "min(x, 2)", [total("goal", using=["@1"]), total("goal", "@2", using=["@1"])],
         "proved"),
        ("x <= m", "max(x, 2)", [total("goal", using=["@1"]), total("goal", "@2", using=["@1"])],
         "proved"),
        ("x <= m", "min(x, 2)", [total("goal", using=["@1"]), total("goal", "@2", using=["@1"])],
         "found a sum that is not 0"),
        ("m <= x", "max(x, 2)", [total("goal", using=["@1"]), total("goal", "@2", using=["@1"])],
         "found a sum that is not 0"),
        ("m <= 2", "min(x, 2)", [total("goal", "@2", using=["@1"]), total("goal", using=["@1"])],
         "proved"),
        ("m <= 2", "min(x, 2)", [total("goal", "@1"), total("goal", using=["@1"])],
         "found @1, which is no inequality"),
        ("m <= 2", "min(x, 2)", [total("goal", "@3", using=["@1"]), total("goal", using=["@1"])],
         "found @3, which no branch adds"),
        ("m <= 2", "min(x, 2)", [total("goal", "@2", using=["@1"])], "found 1 proofs, expected 2"),
        ("m <= 2", "min(x, 2)", [], "found 0 proofs, expected 2"),
        ("0 <= x", "x", [IDENTITY], "of: found name, expected min or max"),
        ("0 <= x", "x + 1", [IDENTITY] * 2, "of: found add, expected min or max"),
        ("0 <= x", "cos(x)", [IDENTITY], "of: found cos, expected min or max"),
        ("0 <= x", "min(x, 1/x)", [total("goal", "x-low")] * 2, "found a division by a term"),
        ("0 <= x", "max(x, sqrt(x - 1))", [total("goal", "x-low")] * 2, "the root of a term"),
    ],
)  # fmt: skip
def test_cases(claim: str, of: str, branches: list[Any], reason: str) -> None:
    claim = claim.replace("m", of)
    assert reason in in_box(claim, cases(of, *branches))


def test_three_entries_compare_with_both_others() -> None:
    def proof(*pairs: tuple[str, ...]) -> Any:
        return cases("min(x, 1, 2 - x)", *[total("goal", *names, using=["@1"]) for names in pairs])

    claim = "min(x, 1, 2 - x) <= 1"
    assert in_box(claim, proof(("@2",), (), ("@3",)), ("0", "3")) == "proved"
    assert "not 0" in in_box(claim, proof(("@3",), (), ("@3",)), ("0", "3"))
    assert "not 0" in in_box(claim, proof(("@2",), (), ("@2",)), ("0", "3"))


def test_the_term_is_in_scope() -> None:
    pair = box(("0", "1")).context("other", {"u": "0"}, {}, [])
    proof = cases("min(u, 2)", *[interval(BOUNDS)] * 2)
    assert "of: found a name of other, which is not in scope" in verdict(
        pair.row("row", "0 <= x", proof, "box")
    ).replace("term: ", "of: ")


def test_a_root_of_a_minimum_stays_an_atom() -> None:
    """sqrt(min(x, 2)) = sqrt(x) where min(x, 2) = x is not seen by the polynomials."""
    pair = box(("0", "1"))
    low = total("goal", "x-low", using=["@1"])
    pair.lemma(
        "m-low", "0 <= min(x, 2)", cases("min(x, 2)", low, total("goal", "2", using=["@1"])), "box"
    )
    claim = "sqrt(min(x, 2)) = sqrt(x)"
    assert "differ" in verdict(pair.row("row", claim, cases("min(x, 2)", BOTH, BOTH), "box"))
