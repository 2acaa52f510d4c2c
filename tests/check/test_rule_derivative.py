"""``derivative``: what holds at a number holds beyond it, as the derivative has a sign."""

from __future__ import annotations

from typing import Any

import pytest

from tests.check.support import INTERVAL, Pair, cuts, interval, term, total, verdict
from verify import check

Json = Any
RANGE = {"rule": "range"}


def derivative(
    slope: Json, sign: Json, order: Json, *bounds: Json, start: Json = INTERVAL, **others: Json
) -> dict[str, Json]:
    """The rule for x, from 0 upwards, unless something else is said."""
    fields = {"variable": "x", "at": "0", "side": "above", "strict": "start", "term": term(slope)}
    return {
        "rule": "derivative", **fields, "start": start, "order": order, "sign": sign,
        "bounds": list(bounds), **others,
    }  # fmt: skip


def half_line(*more: str) -> Pair:
    """x >= 0, and x > 0 as well with ``strict``."""
    givens = {"low": "0 <= x", **{name: name for name in more}}
    return Pair().context("c", {"x": "1", "y": "1"}, givens)


def proved(pair: Pair, claim: str, proof: Json) -> str:
    pair.lemma("e", "0 < exp(x)", RANGE, "c")
    pair.lemma("e0", "0 <= exp(x)", total("goal", "e"), "c")
    return verdict(pair.row("row", claim, proof, "c"))


def rise(**others: Json) -> dict[str, Json]:
    """Exp x >= 1 for x >= 0."""
    return {**derivative("exp(x)", "e0", "low", INTERVAL), **others}


def test_an_exponential() -> None:
    assert proved(half_line(), "1 <= exp(x)", rise()) == "proved"


@pytest.mark.parametrize(
    ("claim", "change", "found"),
    [
        ("1 < exp(x)", {}, "between them"),
        ("1 < exp(x)", {"start": INTERVAL, "sign": INTERVAL}, "between them"),
        ("2 <= exp(x)", {}, "between them"),
        ("exp(x) <= 1", {}, "another term than the derivative"),
        ("exp(x) <= 1", {"term": term("-exp(x)")}, "another claim than is needed"),
        ("1 <= exp(x)", {"term": "1"}, "another term than the derivative"),
        ("1 <= exp(x)", {"term": term("1*exp(x)")}, "another term than the derivative"),
        ("1 <= exp(x)", {"side": "below"}, "another claim than is needed"),
        ("1 <= exp(x)", {"at": "1"}, "another claim than is needed"),
        ("1 <= exp(x)", {"at": "x"}, "in which x occurs"),
        ("1 <= exp(x)", {"at": term("x - x")}, "in which x occurs"),
        ("1 <= exp(x)", {"variable": "y"}, "the variable does not occur"),
        ("1 <= exp(x)", {"variable": "z"}, "no variable of the context"),
        ("1 <= exp(x)", {"variable": "c"}, "no variable of the context"),
        ("1 <= exp(x)", {"variable": ["x"]}, "MALFORMED"),
        ("1 <= exp(x)", {"bounds": []}, "expected 1"),
        ("1 <= exp(x)", {"bounds": [INTERVAL, INTERVAL]}, "expected 1"),
        ("1 <= exp(x)", {"side": "both"}, "MALFORMED"),
        ("1 <= exp(x)", {"strict": "both"}, "MALFORMED"),
        ("1 <= exp(x)", {"order": "e0"}, "another claim than is needed"),
        ("1 <= exp(x)", {"sign": "low"}, "another claim than is needed"),
        ("1 <= exp(x)", {"start": "low"}, "another claim than is needed"),
        ("0 <= y", {}, "the variable does not occur"),
    ],
)
def test_near_misses(claim: str, change: dict[str, Json], found: str) -> None:
    assert found in proved(half_line(), claim, rise(**change))


def test_strict_from_the_start() -> None:
    """0 < exp(0), and it rises."""
    assert proved(half_line(), "0 < exp(x)", rise()) == "proved"
    assert "between them" in proved(half_line(), "1 < exp(x)", rise(start=INTERVAL))


def positive() -> Pair:
    return Pair().context("c", {"x": "1"}, {"pos": "0 < x"})


def test_strict_from_the_slope() -> None:
    """1 < exp x for x > 0: the given does not hold at 0 itself, where it starts."""
    proof = derivative("exp(x)", "e", "pos", INTERVAL, strict="slope")
    assert proved(positive(), "1 < exp(x)", proof) == "proved"
    for change in ({"strict": "start"}, {"sign": "e0"}):
        assert proved(positive(), "1 < exp(x)", {**proof, **change}).startswith("REFUSED")
    low = {**proof, "order": "low"}
    assert "another claim" in proved(half_line(), "1 < exp(x)", low)


def test_the_given_has_to_hold_where_it_starts() -> None:
    """For x >= 0 the slope 2x is >= 0, which says nothing of -1."""
    proof = derivative("2*x", total("goal", ["mul", "2", "low"]), "down", INTERVAL)
    proof |= {"at": "-1", "order": {"rule": "sum", "using": [], "addends": ["goal", "low", "1"]}}
    proof["order"]["equations"] = []
    claim = "1 <= x**2"
    found = verdict(half_line().row("row", claim, proof, "c"))
    assert "expected <= between them" in found


def test_the_given_has_to_hold_where_it_starts_from_above() -> None:
    """For x <= 0 the slope 2x is <= 0, which says nothing of what is between 0 and 1."""
    pair = Pair().context("c", {"x": "-1"}, {"high": "x <= 0"})
    sign = total("goal", ["mul", "2", "high"])
    order = total("goal", "high", "1")
    proof = derivative("2*x", sign, order, INTERVAL, at="1", side="below")
    assert "expected <= between them" in verdict(pair.row("row", "1 <= x**2", proof, "c"))
    pair = Pair().context("c", {"x": "-1"}, {"high": "x <= 0"})
    good = derivative("2*x", sign, "high", INTERVAL, side="below")
    assert verdict(pair.row("row", "0 <= x**2", good, "c")) == "proved"


def test_hypotheses_count_as_givens() -> None:
    """In the branch x >= 1 the slope x - 1 is >= 0, which says nothing of what is below 1."""
    slope = "2*x - 2"
    sign = total("goal", ["mul", "2", "@1"])
    start = {"start": INTERVAL, "at": "0"}
    proof = derivative(slope, sign, "low", INTERVAL, INTERVAL, **start)
    found = verdict(half_line().row("row", "0 <= x**2 - 2*x", cuts("x", ["1"], proof, proof), "c"))
    assert found.startswith("REFUSED")
    good = derivative(slope, sign, "@1", INTERVAL, INTERVAL, **{**start, "at": "1"})
    below = derivative(slope, total("goal", ["mul", "2", "@1"]), "@1", INTERVAL)
    below |= {"at": "1", "side": "below"}
    branches = cuts("x", ["1"], below, good)
    assert verdict(half_line().row("row", "-1 <= x**2 - 2*x", branches, "c")) == "proved"
    swapped = cuts("x", ["1"], good, below)
    assert verdict(half_line().row("row", "-1 <= x**2 - 2*x", swapped, "c")).startswith("REFUSED")


@pytest.mark.parametrize(
    "given", ["0 <= x*x - 4", "4 <= x**2", "1 = x", "x = 1", "x*y <= 1", "min(x, y) <= 4", "x <= x"]
)
def test_other_givens_of_the_variable_are_refused(given: str) -> None:
    """They may hold at both ends and not between them."""
    pair = Pair().context("c", {"x": "1", "y": "1"}, {"low": "0 <= x", "odd": given})
    if given == "0 <= x*x - 4" or given == "4 <= x**2":
        pair = Pair().context("c", {"x": "2", "y": "1"}, {"low": "0 <= x", "odd": given})
    assert "no bound of the variable" in proved(pair, "1 <= exp(x)", rise())


def test_givens_of_other_variables_do_not_matter() -> None:
    pair = Pair().context("c", {"x": "1", "y": "1"}, {"low": "0 <= x", "odd": "y*y = 1"})
    assert proved(pair, "1 <= exp(x)", rise()) == "proved"


def test_a_constant_hides_the_variable() -> None:
    """What occurs in a definition occurs: w*w <= 1 with w = x - 1 says that x is no interval."""
    pair = Pair().context("c", {"x": "1"}, {"low": "0 <= x"}).inner("c", "w", "x - 1")
    assert "in which x occurs" in proved(pair, "1 <= exp(x)", rise(at="w"))
    pair = Pair().context("c", {"x": "1"}, {"low": "0 <= x"}).inner("c", "w", "x - 1")
    proof = cuts("w**2", ["1"], rise(), rise())
    assert "no bound of the variable" in proved(pair, "1 <= exp(x)", proof)


def test_a_constant_is_differentiated() -> None:
    for slope, found in (("2*x", "proved"), ("1", "another term")):
        pair = Pair().context("c", {"x": "1"}, {"low": "0 <= x"}).inner("c", "w", "x**2")
        proof = derivative(slope, total("goal", ["mul", "2", "low"]), "low", INTERVAL)
        assert found in verdict(pair.row("row", "0 <= w", proof, "c"))


def atan_sum(sign: str) -> str:
    """Whether atan x + atan (1/x), or the difference, stays what it is at 1, for x >= 1."""
    pair = Pair().context("c", {"x": "1"}, {"low": "1 <= x"})
    pair.lemma("pos", "0 < x", total("goal", "low", "1"), "c")
    pair.lemma("square", "0 < x**2", total("goal", ["mul", "pos", "pos"]), "c")
    pair.lemma("one", "0 < 1 + x**2", total("goal", "1", ["square", "x"]), "c")
    inverse = ["div", "1", "x"]
    other = ["add", "1", ["pow", inverse, "2"]]
    pair.lemma("two", ["<", "0", other], total("goal", "1", ["square", "x"]), "c")
    unit = {"rule": "monotony", "under": None, "premise": INTERVAL}
    pair.lemma("unit", ["=", ["atan", ["div", "1", "1"]], ["atan", "1"]], unit)
    change = ["div", ["neg", ["div", "1", ["pow", "x", "2"]]], other]
    slope = [sign, ["div", "1", term("1 + x**2")], change]
    start = total(equations=[("unit", "-1" if sign == "add" else "1")])
    proof = derivative(slope, total(), "low", INTERVAL, start=start, at="1")
    constant = [sign, ["atan", "1"], ["atan", "1"]]
    claim = ["=", constant, [sign, ["atan", "x"], ["atan", inverse]]]
    return verdict(pair.row("row", claim, proof, "c"))


def test_equations() -> None:
    """A function whose derivative is 0 does not change; another one does."""
    assert atan_sum("add") == "proved"
    assert "found sides that differ" in atan_sum("sub")


@pytest.mark.parametrize(
    ("text", "slope"),
    [
        ("x", "1"),
        ("x + 1", "1"),
        ("y + x", "1"),
        ("x + x", "1 + 1"),
        ("x - y", "1"),
        ("y - x", "-(1*1)"),
        ("x - x**2", "1 - 2*x"),
        ("-x", "-(1*1)"),
        ("y*x", "y"),
        ("x*y", "y"),
        ("x*exp(x)", "exp(x) + x*exp(x)"),
        ("exp(2*x)", "exp(2*x)*2"),
        ("x/y", "(1*1)/y"),
        ("y/x", "-(y/x**2)"),
        ("exp(x)/x", "(x*exp(x) - exp(x))/x**2"),
        ("x**1", "1"),
        ("x**2", "2*x"),
        ("x**3", "3*x**2"),
        ("(y*x)**3", "3*(y*x)**2*y"),
        ("sqrt(x)", "(1*1)/(2*sqrt(x))"),
        ("root(x, 3)", "(1*1)/(3*root(x, 3)**2)"),
        ("root(x, 2)", "(1*1)/(2*root(x, 2))"),
        ("log(y*x)", "y/(y*x)"),
        ("atan(x)", "(1*1)/(1 + x**2)"),
        ("sin(x)", "cos(x)"),
        ("sin(y*x)", "cos(y*x)*y"),
        ("cos(y*x)", "-(sin(y*x)*y)"),
        ("cos(x)", "-sin(x)"),
        ("cos_pi(x)", "-(pi()*sin(pi()*x))"),
        ("cos_pi(y*x)", "-(pi()*sin(pi()*(y*x))*y)"),
        ("max(y, 1)*x", "max(y, 1)"),
    ],
)
def test_derivatives(text: str, slope: str) -> None:
    kernel = check.Kernel()
    context = check.Context("c", kernel.outermost)
    x, y = (kernel.new_name(name, context) for name in "xy")
    found = check.Slopes(kernel, context, x).of(kernel.read("", term(text), context))
    wanted = term(slope)
    wanted = repair(wanted)
    assert found == kernel.read("", wanted, context), (text, kernel.nodes[found])
    assert y != found or text in ("x*y", "y*x")


def repair(value: Json) -> Json:
    """What is written 1*1 is a plain 1 that does not melt into a number before it."""
    if value == ["mul", "1", "1"]:
        return "1"
    return [value[0], *map(repair, value[1:])] if isinstance(value, list) else value


@pytest.mark.parametrize("text", ["min(x, y)", "max(x, 0) + 1", "exp(min(x, 1))"])
def test_what_has_no_derivative(text: str) -> None:
    kernel = check.Kernel()
    context = check.Context("c", kernel.outermost)
    x, _ = (kernel.new_name(name, context) for name in "xy")
    with pytest.raises(check.Refused, match="no derivative of m"):
        check.Slopes(kernel, context, x).of(kernel.read("", term(text), context))


def test_a_root_is_not_differentiated_where_it_is_zero() -> None:
    """Sqrt x at 0: the derivative divides by the root, which has to be known to be positive."""
    proof = derivative("1/(2*sqrt(x))", INTERVAL, "low", INTERVAL)
    proof["term"] = ["div", "1", term("2*sqrt(x)")]
    found = verdict(half_line().row("row", "0 <= sqrt(x)", proof, "c"))
    assert found.startswith("REFUSED")
    bounds = interval(("x", "low", "high"))
    pair = Pair().context("c", {"x": "1"}, {"low": "0 < x", "high": "x <= 4"})
    pair.lemma("nonneg", "0 <= x", total("goal", "low"), "c")
    pair.lemma("root", "0 < sqrt(x)", {"rule": "root"}, "c")
    pair.lemma("double", "0 < 2*sqrt(x)", total("goal", "root", "root"), "c")
    sign = total("goal", "1")
    good = {**proof, "order": "nonneg", "sign": sign, "bounds": [INTERVAL]}
    assert verdict(pair.row("row", "0 <= sqrt(x)", good, "c")) == "proved"
    assert bounds["bits"] == 64


def test_both_sides_have_to_be_defined() -> None:
    """The derivative of 1/x - 1/x + x is defined nowhere else than this is."""
    pair = Pair().context("c", {"x": "1"}, {"low": "-1 <= x"})
    proof = derivative("1/(1 + x**2)", INTERVAL, "low", INTERVAL)
    proof |= {"term": ["div", "1", "x"], "at": "-1"}
    found = verdict(pair.row("row", "0 <= log(x)", proof, "c"))
    assert "logarithm of a term" in found


def test_without_a_context_there_is_no_variable() -> None:
    proof = derivative("1", INTERVAL, INTERVAL)
    assert "no variable" in verdict(Pair().row("row", "0 <= 1", proof))
