"""Work is counted in whatever walks a table or makes a fraction, so that no file takes long."""

from __future__ import annotations

from fractions import Fraction
from hashlib import sha256
from typing import Any

import pytest

from tests.check.support import INTERVAL, Pair, answer, cases, entry, instance, total
from verify import check


def work(pair: Pair) -> int:
    """What is counted where all is proved."""
    report = check.check(*pair.files(), {})
    assert report.verdict == "PROVED"
    return report.work


def long_entries(n: int) -> Pair:
    """A minimum of n long fractions, with a branch for each in which all are cleared."""
    entries = [f"{7**4000 + i}/{3**6000 + i}" for i in range(n)]
    term = ["min", *entries]
    branches = [total("goal", "1")] * n
    return Pair().row("row", ["<", term, ["add", term, "1"]], cases(term, *branches))


def test_a_fraction_is_made_once_and_counted(monkeypatch: pytest.MonkeyPatch) -> None:
    """To clear it; not again in each branch of a minimum."""
    made = []

    class Counted(Fraction):
        def __new__(cls, *parts: Any) -> Any:
            made.append(parts)
            return Fraction(*parts)

    pair = long_entries(8)
    monkeypatch.setattr(check, "Fraction", Counted)
    check.rational.cache_clear()
    report = check.check(*pair.files(), {})
    assert report.verdict == "PROVED"
    assert sum(len(parts) == 2 and max(parts) > 7**3000 for parts in made) == 8
    bits = (7**4000).bit_length() + (3**6000).bit_length()
    assert report.work >= 8 * (bits * bits >> 20)


def steps_over_a_minimum(n: int) -> Pair:
    pair = Pair().row("row", "0 <= 1", INTERVAL)
    pair.terms = {"m": ["min", *map(str, range(n))]}
    for i in range(100):
        pair.lemma(f"l{i}", ["<=", "m", str(n - 1)], entry("lhs"))
    return pair


def test_looking_for_an_entry_is_counted() -> None:
    assert work(steps_over_a_minimum(1700)) - work(steps_over_a_minimum(100)) > 100 * 2 * 99


def sums_of_a_product(n: int, steps: int) -> Pair:
    """So many additions of a product of n variables."""
    names = [f"v{i}" for i in range(n)]
    product: Any = names[0]
    for name in names[1:]:
        product = ["mul", product, name]
    pair = Pair().context("c", dict.fromkeys(names, "1"), {}, []).row("row", "0 <= 1", INTERVAL)
    pair.terms = {"p": product}
    for i in range(steps):
        claim = ["<", "p", ["add", "p", "1"]]
        pair.lemma(f"l{i}", claim, total("goal", "1"), "c")
    return pair


def test_adding_a_long_monomial_is_counted() -> None:
    """Its hash is worked out for each table."""
    more = [work(sums_of_a_product(n, 60)) - work(sums_of_a_product(n, 10)) for n in (2, 82)]
    assert more[1] - more[0] >= 50 * 2 * (80 // 16)


def instances(givens: int, steps: int) -> Pair:
    pair = Pair().context("c", {"x": "1"}, {f"g{i}": ["<=", "0", "x"] for i in range(givens)})
    pair.lemma("fact", "0 <= x", total("goal", "g0"), "c").lemma("one", "0 <= 1", INTERVAL)
    for i in range(steps):
        pair.lemma(f"l{i}", "0 <= 1", instance("fact", {"x": "1"}, *["one"] * givens))
    return pair.row("row", "0 <= 1", INTERVAL)


def test_premises_are_counted() -> None:
    more = [work(instances(n, 20)) - work(instances(n, 10)) for n in (1, 101)]
    assert more[1] - more[0] >= 10 * 100 * 4


def test_looking_through_the_contexts_around_is_counted() -> None:
    found = []
    for depth in (1, 65):
        pair = Pair().row("row", "0 <= 1", INTERVAL)
        for i in range(depth):
            parent = f"c{i - 1}" if i else None
            pair.context(f"c{i}", {f"v{i}": "1"}, {f"g{i}": f"0 < v{i}"}, None, parent)
        before = work(pair)
        for i in range(50):
            pair.lemma(
                f"l{i}", ["<", "0", ["sqrt", f"v{depth - 1}"]], {"rule": "root"}, f"c{depth - 1}"
            )
        found.append(work(pair) - before)
    assert found[1] - found[0] >= 50 * 2 * 4


@pytest.mark.parametrize("which", ["statement", "certificate"])
def test_the_bytes_of_both_files_are_counted(which: str) -> None:
    pair = Pair().row("row", "0 <= 1", INTERVAL)
    before = work(pair)
    if which == "statement":
        pair.statement["obligations"][0]["says"] = "x" * 80_000
    else:
        pair.terms["idle"] = "1" * 80_000  # which nobody reads
    assert 20_000 <= work(pair) - before < 21_000


def refused_sums(n: int) -> Pair:
    pair = Pair().row("row", "0 <= 1", INTERVAL)
    for i in range(n):
        pair.lemma(f"l{i}", "0 = 1", total())
    return pair


def test_refusals_up_to_the_limit() -> None:
    code, lines = answer(refused_sums(check.MAX_REFUSED))
    assert (code, len(lines)) == (1, check.MAX_REFUSED + 2)
    code, lines = answer(refused_sums(check.MAX_REFUSED + 1))
    assert (code, lines) == (4, ["MALFORMED: found more than 1000 refusals"])


def test_all_kinds_of_refusals_are_counted_together(monkeypatch: pytest.MonkeyPatch) -> None:
    """A step, an enclosure, and a needed row that is undecided."""
    pair = refused_sums(1).constant("c", "1").row("open", "0 < 1", None, verdict="undecided")
    pair.enclosures["constants"] = {"c": {"bits": 64, "ends": ["2", "3"]}}
    monkeypatch.setattr(check, "MAX_REFUSED", 3)
    assert answer(pair)[0] == 1
    monkeypatch.setattr(check, "MAX_REFUSED", 2)
    assert answer(pair) == (4, ["MALFORMED: found more than 2 refusals"])


def test_a_refusal_walks_no_table_of_names() -> None:
    """The names in a message are found one by one, however many there are."""
    pair = Pair().parameter("p", "2").row("row", "0 <= 1", INTERVAL)
    kernel = check.Kernel()
    reader = check.Reader(kernel, {})
    checking = check.Checking(kernel, reader, reader.read(pair.statement))

    class Unwalked(dict[str, int]):
        def items(self) -> Any:
            raise AssertionError("the table of all names is walked")

    kernel.names = Unwalked(kernel.names)
    kernel.defined.add(kernel.names["p"])
    checking.step({"lemma": "l", "context": None, "claim": ["=", "p", "1"], "proof": total()})
    assert checking.lines == ["REFUSED lemma l: found sides that differ, by 1*p + -1"]


def test_a_name_of_a_fact_with_too_many_colons() -> None:
    """It is refused before a pattern is tried at millions of places."""
    name = "a:" * 2_000_000 + "a"
    pair = Pair().row("row", "0 < 1", total("goal", using=[name]))
    assert answer(pair)[1][0].endswith("expected the name of a fact")


def slopes_beside(givens: int, steps: int) -> Pair:
    """Proofs by the sign of a derivative in a context with givens about something else."""
    pair = Pair().row("row", "0 <= 1", INTERVAL)
    others = {f"g{i}": ["<", "0", "1"] for i in range(givens)}
    pair.context("c", {"x": "1"}, others | {"low": "0 <= x"}, [INTERVAL] * (givens + 1))
    proof = {
        "rule": "derivative", "variable": "x", "side": "above", "strict": "start", "at": "0",
        "term": "1", "start": INTERVAL, "order": "low", "sign": INTERVAL, "bounds": [INTERVAL],
    }  # fmt: skip
    for i in range(steps):
        pair.lemma(f"l{i}", "0 <= x", proof, "c")
    return pair


def test_givens_that_a_derivative_looks_at_are_counted() -> None:
    more = [work(slopes_beside(n, 20)) - work(slopes_beside(n, 10)) for n in (1, 101)]
    assert more[1] - more[0] >= 10 * 100 * 8


def test_values_are_not_copied_for_each_given() -> None:
    """A context may have as many variables as givens."""

    class Uncopied(dict[int, int]):
        def __iter__(self) -> Any:
            raise AssertionError("the values are copied")

        def keys(self) -> Any:
            raise AssertionError("the values are copied")

    kernel = check.Kernel()
    context = check.Context("c", kernel.outermost)
    x, y = kernel.new_name("x", context), kernel.new_name("y", context)
    seven, eight = (kernel.rational(Fraction(n)) for n in (7, 8))
    total_ = kernel.node("add", (x, y))
    at = Uncopied({x: seven, y: eight})
    found = kernel.substitute(check.Claim("<", total_, y), context, at)
    assert found == check.Claim("<", kernel.node("add", (seven, eight)), eight)
    assert kernel.substitute(check.Claim("<", x, seven), context, at).lhs == seven


def test_lists_in_files_are_counted() -> None:
    """They take most memory for their bytes."""
    pair = Pair().row("row", "0 <= 1", INTERVAL)
    before = work(pair)
    pair.terms["idle"] = [[]] * 10_000  # which nobody reads
    assert 2 * 10_000 <= work(pair) - before < 4 * 10_000


def test_sentences_are_counted_under_the_names_that_are_told() -> None:
    other = Pair("T").row("row", "0 <= 1", INTERVAL)
    for i in range(50):
        other.assume(f"a{i}")
    found = []
    for length in (1, 81):
        pair = Pair().row("row", "0 <= 1", INTERVAL).cite("c" * length, other)
        available = {sha256(other.files()[0]).hexdigest(): other.files()[0]}
        found.append(check.check(*pair.files(), available).work)
    assert found[1] - found[0] >= 50 * 80 // 4 * 2
