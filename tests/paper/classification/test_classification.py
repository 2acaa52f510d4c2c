"""The theorems: accepted as they are, and refused with a wrong sign, index or factor."""

from __future__ import annotations

import pytest

from tests.pages import Variables
from tests.paper.changed_claims import changed_claims, refused
from tests.paper.changed_statements import report
from verify import check
from verify.language.statement import NEEDED, PROVED, Always, Obligation
from verify.language.terms import symbol
from verify.paper.commands import pages
from verify.paper.commands.pages import page

STATEMENT = page("classification").statement


# --- as they are ---------------------------------------------------------------------------------


def test_the_misprint_is_corrected_by_a_row_that_is_needed() -> None:
    rows = {row.name: (row, decision) for row, decision in pages.decide("classification").rows}
    row, decision = rows["cone-image-stated"]
    assert row.corrected_by is not None
    correction = rows[row.corrected_by]
    assert (correction[0].role, correction[1].verdict) == (NEEDED, PROVED)
    assert set(decision.witness) == {"r", "triple.a", "triple.b", "triple.c", "triple.t"}


# --- what is refused -----------------------------------------------------------------------------


#: Mutants that are true, and that the same proof proves.
TRUE = {"law-of-cosines.index", "bound-below-one.sign"}


MUTANTS = changed_claims("classification").keys() - TRUE


@pytest.mark.parametrize("name", sorted(MUTANTS))
def test_a_wrong_claim_is_refused(name: str) -> None:
    assert name in refused("classification")


def test_there_are_many_wrong_claims() -> None:
    assert len(MUTANTS) > 3 * len(pages.decide("classification").statement.obligations)


run, first = Variables("classification", "run"), Variables("classification", "first")

NEXT = {
    "the balls keep their roles": {"s": run.s, "c": run.c},
    "the ghost of the last speed is forgotten": {"u_0": run.u_0},
    "the comparison sequence runs ahead": {"low": symbol("high_next")},
    "with the wrong sign": {"high": -symbol("high_next")},
    "with the wrong factor": {"high": first.a * run.high - 2 * first.r * run.low},
    "the bend is not halved": {"b": (1 + first.r) * symbol("C_next")},
    "the distance stays": {"D": run.D, "eta": run.eta},
}


@pytest.mark.parametrize("what", NEXT)
def test_a_wrong_next_state_is_refused(what: str) -> None:
    outcome = pages.decide("classification")
    rows = outcome.statement.obligations
    index = next(i for i, row in enumerate(rows) if row.name == "run-always")
    claim = rows[index].claim
    assert isinstance(claim, Always)
    changed = {run.full(name): term for name, term in NEXT[what].items()}
    wrong: Obligation = rows[index]._replace(
        claim=Always(claim.context, claim.start, {**claim.next, **changed})
    )
    statement = outcome.statement._replace(obligations=(*rows[:index], wrong, *rows[index + 1 :]))
    found = report(outcome._replace(statement=statement))
    assert found.verdict == "REFUSED"
    assert any(line.startswith("REFUSED run-always") for line in found.lines)


GIVENS = [
    given.name
    for context in STATEMENT.contexts
    for given in context.givens
    if context.name in ("flight", "limit", "speeds", "inward")
]


@pytest.mark.parametrize("name", GIVENS)
def test_a_given_is_needed(name: str) -> None:
    outcome = pages.decide("classification")
    contexts = tuple(
        context._replace(givens=tuple(g for g in context.givens if g.name != name))
        for context in outcome.statement.contexts
    )
    lie = outcome._replace(statement=outcome.statement._replace(contexts=contexts))
    try:
        assert report(lie).verdict == "REFUSED"
    except check.Malformed:
        return
