"""``monotony``: functions that rise keep the order, and it can be read off from them."""

from __future__ import annotations

from typing import Any

import pytest

from tests.check.support import INTERVAL, Pair, answer, ground, verdict

WRONG = "expected the same function"


def monotony(premise: Any, under: str | None = None) -> dict[str, Any]:
    return {"rule": "monotony", "under": under, "premise": premise}


def context() -> Pair:
    return Pair().context(
        "c", {"x": "1", "y": "2"},
        {"low": "0 < x", "less": "x < y", "most": "x <= y", "high": "0 < y"},
    )  # fmt: skip


RISING: list[tuple[str, Any, str]] = [
    ("exp(x) < exp(y)", "less", "proved"),
    ("exp(x) <= exp(y)", "most", "proved"),
    ("log(x) < log(y)", "less", "proved"),
    ("atan(x) < atan(y)", "less", "proved"),
    ("sqrt(x) < sqrt(y)", "less", "proved"),
    ("root(x, 3) <= root(y, 3)", "most", "proved"),
    ("root(x, 3) < root(y, 4)", "less", WRONG),
    ("sqrt(x) < root(y, 2)", "less", WRONG),
    ("exp(x) < exp(y)", "most", "another claim"),
    ("exp(y) < exp(x)", "less", "another claim"),
    ("exp(y) <= exp(x)", "most", "another claim"),
    ("sin(x) < sin(y)", "less", WRONG),
    ("cos(x) <= cos(y)", "most", WRONG),
    ("exp(x) < log(y)", "less", WRONG),
    ("x < y", "less", WRONG),
    ("x**3 < y**3", "less", WRONG),
    ("x**2 <= y**2", "most", WRONG),
    ("-x < -y", "less", WRONG),
    ("min(x, y) < min(y, x)", "less", WRONG),
    ("x + 1 < y + 1", "less", WRONG),
    ("pi() < pi()", "less", WRONG),
    ("log(x - 1) < log(y - 1)", INTERVAL, "a term that is not known to be > 0"),
    ("exp(x) = exp(y)", "less", "another claim"),
]
READ_OFF: list[tuple[str, str, Any, str]] = [
    ("x < y", "exp", monotony("less"), "proved"),
    ("x <= y", "log", monotony("most"), "proved"),
    ("x < y", "atan", monotony("less"), "proved"),
    ("x < y", "sqrt", monotony("less"), "proved"),
    ("x <= y", "sqrt", "most", "another claim"),
    ("y < x", "exp", monotony("less"), "another claim"),
    ("x < y", "exp", monotony("most"), "another claim"),
    ("x < y", "sin", monotony("less"), "MALFORMED"),
    ("x < y", "cos", monotony("less"), "MALFORMED"),
    ("x < y", "root", monotony("less"), "MALFORMED"),
    ("x < y", "pow", monotony("less"), "MALFORMED"),
    ("x < y", "", monotony("less"), "MALFORMED"),
]


def statements() -> list[tuple[Pair, str]]:
    """The claims, each with what the checker says of it."""
    found = [(context().row("row", a, monotony(p), "c"), word) for a, p, word in RISING]
    return found + [
        (context().row("row", a, monotony(p, under), "c"), word) for a, under, p, word in READ_OFF
    ]


@pytest.mark.parametrize(("pair", "found"), statements())
def test_what_rises_and_what_is_read_off(pair: Pair, found: str) -> None:
    assert found in verdict(pair)


@pytest.mark.parametrize("function", ["exp", "log", "atan", "sqrt", "sin", "cos", "cos_pi"])
def test_equal_numbers_have_equal_values(function: str) -> None:
    pair = Pair().constant("a", "2", INTERVAL).lemma("pos", "0 < a", INTERVAL)
    proof = monotony("a")
    assert verdict(pair.row("row", f"{function}(a) = {function}(2)", proof)) == "proved"


def test_equal_numbers_have_equal_roots_of_an_index() -> None:
    for index, found in (("3", "proved"), ("4", WRONG)):
        pair = Pair().constant("a", "2", INTERVAL).lemma("pos", "0 < a", INTERVAL)
        pair.row("row", f"root(a, 3) = root(2, {index})", monotony("a"))
        assert found in verdict(pair)


def test_numbers() -> None:
    for claim, found in [
        ("exp(10**99) < exp(10**99 + 1)", "proved"),
        ("exp(10**99 + 1) < exp(10**99)", "between them"),
        ("exp(10**99) < exp(10**99)", "between them"),
    ]:
        pair = context().row("row", claim, monotony({**INTERVAL, "bits": 999}))
        pair.enclosures["rows"]["row"] = {"bits": 64, "lhs": ["0", "1"], "rhs": ["0", "1"]}
        assert any(found in line for line in answer(pair)[1]), claim
    assert "logarithm" in ground("-2 < -1", monotony(INTERVAL, "log"))
