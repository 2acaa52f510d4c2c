"""Why a row is undecided."""

from __future__ import annotations

import re

import pytest

from verify.language.statement import PROVED, UNDECIDED
from verify.language.terms import Claim, as_term, log, sqrt, symbol
from verify.library import always, ask, for_all, lemma, prove
from verify.prover.lengths import MAX_BITS, Lengths

x, y = symbol("x"), symbol("y")


def reason(claim: Claim, givens: list[Claim], work: int = 400_000) -> str:
    place = for_all("all", {f"g{i}": given for i, given in enumerate(givens)}, {"x": 0, "y": 0})
    found = prove(lemma("title", [ask("row", claim, place)], [], [place]), work=work)
    assert found.decisions["row"].verdict == UNDECIDED
    return found.decisions["row"].reason


def test_a_number_that_is_too_long_is_not_computed() -> None:
    tower = ((as_term(3) ** 999) ** 999) ** 999
    lengths = Lengths()
    assert lengths.is_too_long((x + tower,), {})
    assert lengths.is_too_long((1 / tower,), {})
    assert not lengths.is_too_long(((x + 3) ** 999, as_term(3) ** 999), {})
    assert f"more than {MAX_BITS} bits" in reason(x < tower, [0 <= x])


def test_the_given_that_fails_at_the_point_is_named() -> None:
    assert "its given g1 was not shown there" in reason(x < y, [0 <= x, as_term(1) <= y])


@pytest.mark.parametrize(
    ("claim", "says"),
    [
        (sqrt(x) < 2, "√x was not seen to have a value everywhere: a radicand must not be neg"),
        (1 - sqrt(log(x)) < 2, "log(x) was not seen to have a value everywhere: what a logarithm"),
        (-(x**2) - 3 < 1 / y**2, "1/y² was not seen to have a value everywhere: a divisor must"),
    ],
)
def test_a_term_that_may_have_no_value_is_named(claim: Claim, says: str) -> None:
    assert says in reason(claim, [x <= as_term(1), y <= as_term(1)])


def test_a_number_without_a_value_is_told() -> None:
    found = prove(lemma("title", [ask("row", sqrt(as_term(1) - 2) < 1)])).decisions["row"]
    assert found.verdict == UNDECIDED
    assert re.match(
        "a side has no value at [0-9]+ bits; look for a divisor that is 0", found.reason
    )


def test_the_claim_that_an_induction_lacks_is_named() -> None:
    place = for_all("step", (), {"x": 0}, carried={"low": 0 <= x, "high": x <= 1})
    rows = [ask("always", always(place, {"x": 0}, {"x": x + 1}))]
    found = prove(lemma("title", rows, [], [place]), work=400_000).decisions["always"]
    assert found.reason == (
        "its given high was not shown at the next state; ask it as a row before in step: x + 1 ≤ 1"
    )
    rows = [ask("always", always(place, {"x": as_term(-1)}, {"x": x}))]
    found = prove(lemma("title", rows, [], [place]), work=400_000).decisions["always"]
    assert found.reason == (
        "its given low was not shown at the start; ask it as a row before: 0 ≤ -1"
    )


def test_an_induction_is_asked_around_its_context() -> None:
    outer = for_all("outer", (), {"a": 0})
    for around, where in ((None, "no context, under [rows]"), (outer, "outer")):
        place = for_all("step", (), {"x": 0}, within=around, carried={"low": 0 <= x})
        rows = [ask("always", always(place, {"x": 0}, {"x": x + 1}), place)]
        found = prove(lemma("title", rows, [], [outer, place])).decisions["always"]
        why = f"the context step is not one inside that of the row; ask it in {where}"
        assert (found.verdict, found.reason) == (UNDECIDED, why)
        rows = [ask("always", always(place, {"x": 0}, {"x": x + 1}), around)]
        assert prove(lemma("title", rows, [], [outer, place])).claimed == PROVED


def test_an_induction_asks_for_carried_givens() -> None:
    place = for_all("step", {"low": 0 <= x}, {"x": 0})
    rows = [ask("always", always(place, {"x": 0}, {"x": x + 1}))]
    found = prove(lemma("title", rows, [], [place]), work=400_000).decisions["always"]
    assert found.reason == "its given low is neither carried nor standing; make it carried"


def test_the_point_where_a_claim_is_most_nearly_false_is_named() -> None:
    motzkin = x**4 * y**2 + x**2 * y**4 - 3 * x**2 * y**2 + 1
    box = [0 <= x, x <= as_term(2), 0 <= y, y <= as_term(2)]
    said = reason(as_term(-1) / 10**30 < motzkin * (1 + x * y) ** 5, box, work=60_000)
    assert "was not seen to have a value" not in said
    spent = re.search("techniques were tried with ([0-9]+) of 60000 units of work", said)
    assert spent is not None
    assert 0 < int(spent[1]) <= 60_000
    assert "it is most nearly false about x = 1, y = 1, where the sides differ by" in said
