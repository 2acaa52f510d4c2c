"""``root``: the root of a positive number is positive."""

from __future__ import annotations

import pytest

from tests.check.support import BOUNDS, INTERVAL, ROOT, Pair, box, cuts, ground, interval, verdict


@pytest.mark.parametrize(
    ("claim", "reason"),
    [
        ("0 < sqrt(x)", "proved"),
        ("0 < sqrt(1 + y)", "proved"),
        ("0 <= sqrt(x)", "expected 0 < a root"),
        ("0 = sqrt(x)", "expected 0 < a root"),
        ("1 < sqrt(x)", "expected 0 < a root"),
        ("-1 < sqrt(x)", "expected 0 < a root"),
        ("sqrt(x) < 0", "expected 0 < a root"),
        ("0 < x", "expected 0 < a root"),
        ("0 < 3", "expected 0 < a root"),
        ("0 < cos(x)", "expected 0 < a root"),
        ("0 < 2*sqrt(x)", "expected 0 < a root"),
        ("0 < sqrt(y)", "found a radicand that is not known to be positive"),
        ("0 < sqrt(y + 1)", "found a radicand that is not known to be positive"),
        ("0 < sqrt(x*x)", "found a radicand that is not known to be positive"),
        ("0 < sqrt(sqrt(x))", "found a radicand that is not known to be positive"),
    ],
)
def test_root(claim: str, reason: str) -> None:
    pair = Pair().context(
        "c", {"x": "1", "y": "0"}, {"a": "0 < x", "b": "0 <= y", "c2": "0 < 1 + y"}
    )
    assert reason in verdict(pair.row("row", claim, ROOT, "c"))


def test_a_rational_radicand_needs_a_fact() -> None:
    assert "not known to be positive" in ground("0 < sqrt(2)", ROOT)
    pair = Pair().lemma("two", "0 < 2", INTERVAL).row("row", "0 < sqrt(2)", ROOT)
    assert verdict(pair) == "proved"


def test_a_weak_hypothesis_is_not_enough() -> None:
    pair = box(("-1", "1"))
    proof = cuts("x", ["0"], interval(BOUNDS), ROOT)
    assert "REFUSED" in verdict(pair.row("row", "0 < sqrt(x)", proof, "box"))
    pair = box(("-1", "1"))
    proof = cuts("x", ["0"], ROOT, ROOT)
    assert "not known to be positive" in verdict(pair.row("row", "0 < sqrt(x)", proof, "box"))
