"""``sum``: the negation of the claim would make a positive number zero; or: an identity."""

from __future__ import annotations

from typing import Any

import pytest

from tests.check.support import IDENTITY, INTERVAL, Pair, cuts, ground, in_box, total, verdict

SQUARE = ("-1", "1")


def scene() -> Pair:
    """x > 0, 0 <= y <= 1, with constants and lemmas about them."""
    pair = Pair().constant("r", "sqrt(2)", INTERVAL)
    givens = {"x-pos": "0 < x", "y-low": "0 <= y", "y-high": "y <= 1", "neg": "0 < -(0 - 1 - y)"}
    pair.context("c", {"x": "1", "y": "0"}, givens)
    pair.inner("c", "q", "1/x").define("t", "x + y", context="c")
    pair.lemma("t-is", "t*t = x*x + 2*x*y + y*y", total(using=["t"]), "c")
    pair.lemma("s-pos", "0 < x + y", total("goal", "x-pos", "y-low"), "c")
    return pair.lemma("xy", "0 <= x*y", total("goal", ["mul", "x-pos", "y-low"]), "c")


def found(claim: str, proof: Any) -> str:
    return verdict(scene().row("row", claim, proof, "c"))


@pytest.mark.parametrize(
    ("claim", "proof"),
    [
        ("x + y = y + x", IDENTITY),
        ("(x + y)**2 = x**2 + 2*x*y + y**2", IDENTITY),
        ("x*(1/x) = 1", IDENTITY),
        ("1/x + y/x = (1 + y)/x", IDENTITY),
        ("(x + y)/2 = x/2 + y/2", None),
        ("x/(-2) = -x/2", None),
        ("1/(0 - 1 - y) = -(1/(1 + y))", None),
        ("sqrt(x)**2 = x", IDENTITY),
        ("sqrt(x)**3 = x*sqrt(x)", IDENTITY),
        ("sqrt(1/x)**2 = q", total(using=["q"])),
        ("q*x = 1", total(using=["q"])),
        ("q*x = 1", total(equations=[("q", "1")])),
        ("q*q*x = q", total(equations=[("q", "q")])),
        ("r*r = 2", total(using=["r"])),
        ("r**4 = 4", total(using=["r"])),
        ("sqrt(sqrt(x))**4 = x", None),
    ],
)
def test_identities(claim: str, proof: Any) -> None:
    pair = scene().lemma("inverse-pos", "0 < 1/x", total("goal", "1"), "c")
    pair.lemma("one-y", "0 < 1 + y", total("goal", "y-low", "1"), "c")
    pair.lemma("root-pos", "0 < sqrt(x)", {"rule": "root"}, "c")
    assert verdict(pair.row("row", claim, proof or IDENTITY, "c")) == "proved"


@pytest.mark.parametrize(
    ("claim", "proof"),
    [
        ("0 < x + y", total("goal", "x-pos", "y-low")),
        ("0 <= x", total("goal", "x-pos")),
        ("0 <= y*y", total("goal", ["square", "y"])),
        ("0 < 1 + y*y", total("goal", ["square", "y"], "1")),
        ("0 <= (x - y)**2", total("goal", ["square", ["sub", "x", "y"]])),
        ("y*y <= 1", total("goal", ["mul", ["add", "1", "y-low"], "y-high"])),
        ("y*y <= y", total("goal", ["mul", "y-low", "y-high"])),
        ("y**3 <= y**2", total("goal", ["mul", ["pow", "y-low", "2"], "y-high"])),
        ("0 < x**3", total("goal", ["pow", "x-pos", "3"])),
        ("x**2 < (x + 1)**2", total("goal", ["mul", "2", "x-pos"], "1")),
        (
            "x/(x + 1 + y) < 2 + x/(x + 1 + y)",
            total("goal", ["mul", "2", ["pow", "long-pos", "2"]]),
        ),
        ("0 < q", total("goal", "1", using=["q"])),
        ("0 <= sqrt(x)", total("goal", ["root", ["sqrt", "x"]])),
        ("x <= y + x", total("goal", "y-low")),
        ("0 < x", total(["mul", "goal", "x-pos"], ["pow", "x-pos", "2"])),
        ("0 <= x", total(["mul", "goal", "goal"], ["mul", "goal", "x-pos"])),
        ("0 < 3", total("goal", "3")),
        ("0 < 3", total("goal", ["mul", "3", ["mul"]])),
        ("0 <= r", total("goal", ["root", ["sqrt", "2"]], using=["r"])),
        ("q*x <= 1", total("goal", equations=[("q", "-1")])),
    ],
)
def test_inequalities(claim: str, proof: Any) -> None:
    pair = scene().lemma("long-pos", "0 < x + 1 + y", total("goal", "x-pos", "y-low", "1"), "c")
    assert verdict(pair.row("row", claim, proof, "c")) == "proved"


@pytest.mark.parametrize(
    ("claim", "proof", "reason"),
    [
        ("x = y", IDENTITY, "found sides that differ, by 1*x + -1*y"),
        ("x + 1 = x", IDENTITY, "found sides that differ, by 1"),
        ("x = x", total("1"), "found addends, but = has no negation"),
        ("x = x", total("goal"), "found addends, but = has no negation"),
        ("q*x = 1", IDENTITY, "found sides that differ"),
        ("q*x = 1", total(equations=[("q", "x")]), "found sides that differ"),
        ("q*x = 1", total(equations=[("q", "-1")]), "found sides that differ"),
        ("q*x = 1", total(equations=[("x-pos", "x")]), "found x-pos, which is no equation"),
        ("q*x = 1", total(using=["q", "q"]), "using: found q for an atom again"),
        ("x = x", total(using=["x-pos"]), "using: found x-pos, expected an equation"),
        ("sqrt(x) = sqrt(y)", IDENTITY, "found sides that differ"),
        ("sqrt(x*x) = x", IDENTITY, "the root of a term that is not known"),
        ("y/y = 1", IDENTITY, "division by a term that is not known to be > 0 or < 0"),
        ("x/(x - x) = x/(x - x)", IDENTITY, "division by a term that is not known"),
        ("1/0 = 1/(1 - 1)", IDENTITY, "division"),
        ("x*0/(1 - 1) = 0", IDENTITY, "division"),
        ("sqrt(y - 1) = sqrt(y - 1)", IDENTITY, "root of a term that is not known to be >= 0"),
        ("sqrt(-1) = sqrt(-1)", IDENTITY, "root of a term that is not known to be >= 0"),
        ("min(1, 1/(x - x)) = min(1, 1/(x - x))", IDENTITY, "division"),
        ("cos(1/y) = cos(1/y)", IDENTITY, "division"),
        ("0 < y", total("goal", "y-low"), "found no addend that is positive"),
        ("0 < x*y", total("goal", ["mul", "x-pos", "y-low"]), "no addend that is positive"),
        ("0 < y*y", total("goal", ["square", "y"]), "no addend that is positive"),
        ("0 < r", total("goal", ["root", ["sqrt", "2"]], using=["r"]), "no addend that is pos"),
        ("x <= x + y", total("y-low"), "found a sum that is not 0, but 1*y"),
        ("x < x", total("goal"), "found no addend that is positive"),
        ("x < x", total("goal", "1"), "found a sum that is not 0"),
        ("x < y", total("goal", "x-pos", "y-low"), "found a sum that is not 0, but 2*x"),
        ("x < x", total(), "found no addend that is positive"),
        ("x <= x", total(), "found no addend that is positive"),
        ("x < x", total(["mul"]), "found a sum that is not 0"),
        ("x <= 0", total("goal", "x-pos"), "found a sum that is not 0"),
        ("0 <= 0 - x", total("goal", "-1"), "found -1, expected a number >= 0"),
        ("0 <= 0 - x", total("goal", ["root", "x"]), "root: found another term"),
        ("0 <= y", total("goal", "q"), "found q, which is no inequality"),
        ("0 <= q", total("goal", equations=[("y-low", "1")]), "y-low, which is no equation"),
        ("0 < 0", total("goal", "0"), "found no addend that is positive"),
        ("0 < x", total("goal", "row"), "found row, which is no fact so far"),
        ("0 < x", total("goal", "x"), "found x, which is no fact so far"),
        ("0 < x", total("goal", "@1"), "found @1, which no branch adds"),
        ("0 < x", total("goal", "1/0"), "which is no fact so far"),
        ("0 < x", total("goal", "01"), "which is no fact so far"),
        ("q*x <= 1", total("goal", equations=[("q", "1")]), "found a sum that is not 0"),
        ("q*x < 1", total("goal", equations=[("q", "-1")]), "no addend that is positive"),
        ("0 < 1/x", total("goal", "1", using=["x-pos"]), "expected an equation for an atom"),
        ("0 < x", total("goal", ["square", ["div", "1", "y"]]), "division by a term"),
        ("0 <= x", total("goal", ["root", ["sqrt", ["sub", "y", "1"]]]), "the root of a term"),
    ],
)
def test_near_misses(claim: str, proof: Any, reason: str) -> None:
    assert reason in found(claim.replace("1/0 ", "1/(0*1) "), proof)


@pytest.mark.parametrize("name", ["@0", "@-1", "@", "@x", "@1.5", "@٣", "@1000", "@01", "@ 1"])
def test_names_of_hypotheses_are_numbers_from_1(name: str) -> None:
    assert found("0 < x", total("goal", name)).startswith("MALFORMED: obligation row: found ")


@pytest.mark.parametrize(
    "addend",
    [None, {}, [], 0, True, ["goal"], ["min", "1"], [["add"]], ["add", None], ["root"],
     ["root", "x", "x"], ["square"], ["square", "x", "y"], ["pow", "x-pos"], ["pow", "x-pos", "0"],
     ["pow", "x-pos", "-1"], ["pow", "x-pos", 2], ["pow", "x-pos", "1000"],
     ["pow", "x-pos", "2", "2"], ["sub", "goal", "goal"], ["neg", "goal"], "goal ", "Goal"],
)  # fmt: skip
def test_malformed_addends(addend: Any) -> None:
    assert found("0 < x", total("goal", addend)).startswith("MALFORMED: obligation row: ")


def test_products_are_strict_only_if_all_factors_are() -> None:
    assert "no addend" in found("0 < y*x", total("goal", ["mul", "y-low", "x-pos"]))
    assert "no addend" in found("0 < x*y", total("goal", ["mul", "x-pos", "y-low"]))


def test_the_goal_is_strict_only_for_the_weak_relation() -> None:
    assert "no addend" in found("y < y", total("goal"))
    assert found("y <= y", total("goal")) == "proved"
    assert "no addend" in found("y - 1 < 0", total("goal", "y-high"))


def test_equations_in_a_circle() -> None:
    pair = Pair().context("c", {"x": "1", "y": "1"}, {"a": "x = y", "b": "y = x"})
    proof = total(using=["a", "b"])
    assert "found equations in a circle" in verdict(pair.row("row", "x = y", proof, "c"))
    pair = Pair().context("c", {"x": "1"}, {"a": "x = x + 0"})
    assert "in a circle" in verdict(pair.row("row", "x = x", total(using=["a"]), "c"))


def test_an_equation_replaces_its_left_side_only_if_that_is_an_atom() -> None:
    pair = Pair().context("c", {"x": "1", "y": "1"}, {"a": "2*x = y + 1", "b": "y = 1"})
    assert "expected an equation for an atom" in verdict(
        pair.row("row", "x = 1", total(using=["a", "b"]), "c")
    )


def test_roots_atoms_minima_and_cosines_may_be_replaced() -> None:
    for atom in ("sqrt(x)", "min(x, 2)", "max(x, 1)", "cos(x - 1)", "cos_pi(x - 1)"):
        other = atom.replace("x", "y").replace("may", "max")
        givens = {"p": "0 < x", "q": "0 < y", "is": f"{atom} = {other}"}
        pair = Pair().context("c", {"x": "1", "y": "1"}, givens, [INTERVAL, INTERVAL, IDENTITY])
        claim = f"{atom}*2 = 2*{other}"
        wrong = f"{atom}*2 = 2*{other} + 1"
        pair.lemma("lemma", claim, total(using=["is"]), "c")
        assert "row [L]" in verdict(pair.row("row", wrong, total(using=["is"]), "c"))


def test_a_replacement_leaves_roots_of_other_terms_alone() -> None:
    """sqrt(x) stays an atom whose square is what x is replaced by."""
    pair = Pair().context("c", {"x": "4", "y": "2"}, {"p": "0 <= x", "e": "x = y*y"})
    assert verdict(pair.row("row", "sqrt(x)**2 = y**2", total(using=["e"]), "c")) == "proved"
    pair = Pair().context("c", {"x": "4", "y": "2"}, {"p": "0 <= x", "e": "x = y*y"})
    assert "differ" in verdict(pair.row("row", "sqrt(x) = y", total(using=["e"]), "c"))


def test_a_fact_known_of_a_divisor_is_of_the_term_as_it_stands() -> None:
    assert "division" in found("1/(y + x) = 1/(y + x)", IDENTITY)
    assert found("1/(x + y) = 1/(x + y)", IDENTITY) == "proved"


def test_known_in_a_branch_only() -> None:
    """0 <= x is known between the cuts, 0 < x is not."""
    claim, root = "x*sqrt(x)**2 <= x*x", total("goal")
    assert "the root of a term" in in_box(claim, root, SQUARE)
    assert "the root of a term" in in_box(claim, cuts("x", ["0"], root, root), SQUARE)
    assert in_box("0 <= x + 1", cuts("x", ["0"], *[total("goal", "x-low")] * 2), SQUARE) == "proved"
    assert "division" in in_box("x/x <= 1", cuts("x", ["0"], *[total("goal")] * 2), SQUARE)


def test_numbers_are_divided_by_numbers() -> None:
    assert ground(["=", "1/3", ["div", "1", "3"]], IDENTITY) == "proved"
    assert ground(["=", "2", ["div", "6", "3"]], IDENTITY) == "proved"
    assert ground(["=", ["div", "1", "-2"], "-1/2"], IDENTITY) == "proved"
    assert "division by" in ground(["=", ["div", "1", "0"], ["div", "1", "0"]], IDENTITY)


def test_the_negation_of_an_equation_is_no_sum() -> None:
    pair = Pair().row("next", "0 <= 1", INTERVAL)
    pair.row("row", "1 = 0", total("goal", "1"), None, "refuted", "printed")
    assert "found !=, expected <, <= or =" in verdict(pair)
