"""Why a row is undecided."""

from __future__ import annotations

import re

from verify.language.statement import UNDECIDED
from verify.language.terms import Claim, as_term, symbol
from verify.library import ask, for_all, lemma, prove
from verify.prover.reasons import MAX_BITS, is_too_long

x, y = symbol("x"), symbol("y")


def reason(claim: Claim, givens: list[Claim], work: int = 400_000) -> str:
    place = for_all("all", {f"g{i}": given for i, given in enumerate(givens)}, {"x": 0, "y": 0})
    found = prove(lemma("title", [ask("row", claim, place)], [], [place]), work=work)
    assert found.decisions["row"].verdict == UNDECIDED
    return found.decisions["row"].reason


def test_a_number_that_is_too_long_is_not_computed() -> None:
    tower = ((as_term(3) ** 999) ** 999) ** 999
    assert is_too_long((x + tower,), {})
    assert is_too_long((1 / tower,), {})
    assert not is_too_long(((x + 3) ** 999, as_term(3) ** 999), {})
    assert f"more than {MAX_BITS} bits" in reason(x < tower, [0 <= x])


def test_the_given_that_fails_at_the_point_is_named() -> None:
    assert "its given g1 was not shown there" in reason(x < y, [0 <= x, as_term(1) <= y])


def test_the_point_where_a_claim_is_most_nearly_false_is_named() -> None:
    motzkin = x**4 * y**2 + x**2 * y**4 - 3 * x**2 * y**2 + 1
    box = [0 <= x, x <= as_term(2), 0 <= y, y <= as_term(2)]
    said = reason(as_term(-1) / 10**30 < motzkin * (1 + x * y) ** 5, box, work=60_000)
    spent = re.search("techniques were tried with ([0-9]+) of 60000 units of work", said)
    assert spent is not None
    assert 0 < int(spent[1]) <= 60_000
    assert "it is most nearly false about x = 1, y = 1, where the sides differ by" in said
