"""Pairs of files, true ones and lies, each of which tells some mutants from the checker."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import pytest

from tests.check.support import (
    IDENTITY,
    INTERVAL,
    ROOT,
    Pair,
    answer,
    box,
    cases,
    cuts,
    entry,
    instance,
    interval,
    total,
    witness,
)  # fmt: skip
from tests.lies.lies import honest


def more() -> Iterator[Pair]:
    """Pairs that tell some mutants from the checker, true ones and lies."""
    yield honest()
    yield Pair().row("row", "1/3 <= 1/3 - 0*sqrt(2)", IDENTITY).row("next", "2 = 2", INTERVAL)
    pair = box(("-1", "1")).row("row", "0 < sqrt(x)", cuts("x", ["0"], ROOT, ROOT), "box")
    yield pair
    bounds = interval(("x", "x-low", "x-high"))
    yield box(("-2", "1")).row("row", "1 <= x**2", bounds, "box")
    yield box(("-1", "1")).row("row", "x - x <= 0", bounds, "box")
    yield box(("-1", "1")).row("row", "0 <= sqrt(x)", bounds, "box")
    yield box(("-1", "1")).row("row", "min(x, 2) <= 1/2", bounds, "box")
    yield box(("-1", "1")).row("row", "x <= 0", cuts("x", ["0"], *[total("goal", "@1")] * 2), "box")
    for claim in ("sqrt(2) <= sqrt(2)", "sqrt(2)**2 <= 2", "2 <= sqrt(2)**2", "sqrt(2) = sqrt(2)"):
        yield Pair().row("row", claim, INTERVAL)
    lie = Pair().row("row", "sqrt(4) = 2", INTERVAL, None, "refuted", "printed")
    yield lie.row("next", "0 <= 1", INTERVAL)
    free = box(("0", "1")).context("free", {"v": "0"}, {})
    free.lemma("same", "v = v", IDENTITY, "free")
    undefined = "1/(x - x)"
    same = instance("same", {"v": undefined})
    yield free.row("row", f"{undefined} = {undefined}", same, "box")
    yield Pair().context("c", {"x": "1/(1 - 1)"}, {}).row("row", "0 <= 1", INTERVAL)
    yield box(("0", "1")).row("row", "x*sqrt(-1) = x*sqrt(-1)", IDENTITY, "box")
    two = Pair().context("c", {"x": "1"}, {"p": "0 < x"}).context("d", {"y": "x"}, {}, [], "c")
    two.row("row", "y/x = y*(1/x)", IDENTITY, "d").row("wrong", "x/y = x/y", IDENTITY, "c")
    yield two
    yield (
        box(("0", "1"))
        .define("n", "max(x, 2)", context="box")
        .row("row", "x <= 1", entry("rhs", "n"), "box")
    )
    falls = Pair().context("c", {"x": "-1"}, {"n": "0 < -x", "m": "-2 <= x"})
    falls.row("row", "1/x < 0", total("goal", "1"), "c")
    yield falls
    below = Pair().context("c", {"x": "1"}, {"p": "0 < x"}).lemma("f", "0 < x*x", POSITIVE, "c")
    below.context("d", {"y": "1"}, {}, [])
    yield below.row("row", "0 < y*y", instance("f", {"x": "y"}, "p"), "d")
    inner = box(("0", "1")).context("in", {"y": "x"}, {"low": "x <= y"}, [total("goal")], "box")
    inner.lemma("fact", "0 <= y", total("goal", "x-low", "low"), "in")
    yield inner.row("row", "0 <= 1", instance("fact", {"y": "1"}, INTERVAL))
    state = Pair().context("s", {"x": "1"}, {})
    claim = ["always", "s", {"x": "1"}, {"x": ["div", "1", "x"]}]
    yield state.row("row", claim, {"rule": "induction", "start": [], "next": []})
    out = box(("0", "1")).row("needed", "0 <= 1", INTERVAL)
    proof = witness({"x": "1"}, [INTERVAL, INTERVAL], INTERVAL)
    yield out.row("row", "x <= 1", proof, "box", "refuted", "printed")
    elsewhere = box(("0", "1")).context("s", {"x2": "1"}, {})
    claim = ["always", "s", {"x2": "x"}, {"x2": "x2"}]
    induction = {"rule": "induction", "start": [], "next": []}
    yield elsewhere.row("row", claim, induction, "box")
    yield (
        Pair()
        .constant("a", "1")
        .row("row", "0 <= 1", INTERVAL)
        .lemma("l", "a <= 1", interval(("a", "a", "a")))
    )


def proofs() -> Iterator[Pair]:
    """Proofs of what is false, or true, which one check each tells apart."""
    bounds = interval(("x", "x-low", "x-high"))
    beside = Pair().context("a", {"x": "1"}, {}).context("b", {"y": "1"}, {})
    yield beside.row("row", "y + (x - x) = y", IDENTITY, "b")
    yield box(("1/2", "1")).row("row", "0 < sqrt(x)", cuts("x", ["0"], bounds, ROOT), "box")
    unfolded = Pair().constant("k", "1").context("c", {"x": "1"}, {})
    unfolded.lemma("f", "x <= x + k", total("goal", "1", using=["k"]), "c")
    yield unfolded.row("row", "2 <= 2 + k", instance("f", {"x": "2"}))
    for claim in ("sqrt(2)*sqrt(2) = 2", "1 < 1", "1 <= 1"):
        pair = Pair().row("next", "0 <= 1", INTERVAL)
        yield pair.row("row", claim, INTERVAL, None, "refuted", "printed")
    for of, at in (("1/x", ["0"]), ("x", ["1/2", "1/2"]), ("x", ["1/2", "1/3"])):
        yield box(("0", "1")).row("row", "x <= 1", cuts(of, at, *[bounds] * (len(at) + 1)), "box")
    wrong = total("goal", equations=[("@1", "-1")])
    yield Pair().row("row", "1 <= 0", cases("1 + 1", wrong, wrong))
    greater = cases("max(x, 2)", total("goal", using=["@1"]), total("goal", "@2", using=["@1"]))
    yield box(("0", "1")).row("row", "max(x, 2) <= x", greater, "box")
    less = cases("min(x, 2)", total("goal", "@2", using=["@1"]), total("goal", using=["@1"]))
    yield box(("0", "3")).row("row", "2 <= min(x, 2)", less, "box")
    positive = Pair().context("c", {"x": "1"}, {"p": "0 < x"})
    yield positive.row("row", "0 <= sqrt(x)", ROOT, "c")
    unit = [
        ("1 <= x", total("goal", equations=[("x-high", "1")])),
        ("(x + 1)*(x + 1) = x*x + 2*x + 1", IDENTITY),
        ("0 < x*x", total("goal", ["square", "x"])),
        ("0 < x", total("goal", ["mul", "1", "x-low"])),
        ("0 < x", total("goal", "x-low")),
        ("x <= 1", cuts("x", ["3"], bounds, interval(("x", "@1", "x-high")))),
    ]
    for claim, proof in unit:
        yield box(("0", "1")).row("row", claim, proof, "box")
    for addend in (["square", "x"], ["root", "x"]):
        yield box(("-1", "1")).row("row", "0 <= x", total("goal", addend), "box")
    for claim, proof in [
        ("1 <= 0", total("goal", "-1")),
        ("0 < 0", total("goal", "0")),
        ("sqrt(-1) = sqrt(-1)", IDENTITY),
        (["=", ["div", "1", "0"], ["div", "1", "0"]], IDENTITY),
    ]:
        yield Pair().row("row", claim, proof)
    equal = Pair().context("c", {"x": "1", "y": "1"}, {"is": "x = y"})
    yield equal.row("row", "x <= y", total("goal", "is"), "c")


def steps() -> Iterator[Pair]:
    """Steps in a wrong order, or at a wrong place."""
    nested = box(("0", "1")).context("in", {"y": "1"}, {"low": "0 <= y"}, None, "box")
    nested.lemma("f", "0 <= y", total("goal", "low"), "in")
    yield nested.row("row", "0 <= 1", instance("f", {"y": "1"}, INTERVAL))
    other = Pair().context("c", {"x": "1"}, {"p": "0 < x"}).lemma("f", "0 < x*x", POSITIVE, "c")
    other.context("d", {"y": "1"}, {"n": "-5 <= y"})
    yield other.row("row", "0 < y*y", instance("f", {"x": "y"}, "n"), "d")
    early = Pair().constant("a", "sqrt(2)", INTERVAL).row("row", "a = a", IDENTITY)
    early.steps.reverse()
    yield early
    unopened = Pair().context("c", {"x": "1"}, {}).row("row", "x = x", IDENTITY, "c")
    unopened.steps.reverse()
    yield unopened
    applies = box(("0", "1")).row("next", "0 <= 1", INTERVAL)
    proof = {"rule": "instance", "givens": [INTERVAL, INTERVAL]}
    yield applies.row("row", ["applies", "box", {"x": "1/2"}], proof, None, "refuted", "printed")


POSITIVE = total("goal", ["mul", "p", "p"])

#: The exit codes that the checker has to give.
CODES: dict[Callable[[], Iterator[Pair]], str] = {
    more: "0111111111111111410411111",
    proofs: "41010111111111011111111111",
    steps: "11144",
}


@pytest.mark.parametrize("pairs", CODES)
def test_the_codes_of_pairs(pairs: Callable[[], Iterator[Pair]]) -> None:
    assert "".join(str(answer(pair)[0]) for pair in pairs()) == CODES[pairs]
