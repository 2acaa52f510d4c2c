"""Stronger bounds: the committed proofs do not prove them, and other proofs may."""

from __future__ import annotations

from verify.language.terms import Claim, as_term, substitute, symbol
from verify.measure.bench import SOME, slack_table
from verify.paper.commands import pages
from verify.paper.commands.slack import CONTEXT, POINT, find_slack, stronger, values_at
from verify.prover.ground import Ground
from verify.prover.session import Session


def test_no_proof_proves_a_stronger_bound() -> None:
    """Every needed row that says more than the sign of a term."""
    found = find_slack(search=False)
    rows = [
        row.name
        for row in pages.decide("all_parameters").statement.obligations
        if isinstance(row.claim, Claim) and row.context == CONTEXT and row.claim.lhs != as_term(0)
    ]
    assert found.accepted == found.slack == set()
    assert len(found.bounds) > len(rows) - 5 > 150


def test_a_stronger_bound_is_stronger() -> None:
    ground, values = Ground(Session()), values_at(POINT)
    for bound in find_slack(search=False).bounds:
        old, new = bound.row.claim, bound.stronger
        assert isinstance(old, Claim)
        assert old.relation == new.relation
        side, weak = (new.rhs, old.rhs) if new.lhs is old.lhs else (old.lhs, new.lhs)
        values_there = (substitute(term, values) for term in (side, weak))
        assert ground.prove(Claim("<", *values_there))[0] == "proved", bound.row.name
    x = symbol("r")
    assert stronger(0 < x, values, ground) is None
    assert stronger(-x < as_term(0), values, ground) is None
    claim = stronger(x < as_term(1), values, ground)
    assert claim is not None
    assert ground.prove(Claim("<", claim.rhs, as_term(1)))[0] == "proved"


def test_slack_is_found_where_there_is_some() -> None:
    found = find_slack(SOME)
    assert found.slack == {"repaired.y-ratio", "repaired.zeta-ratio"}
    assert found.accepted == set()
    table = slack_table(quick=True)
    assert [line[0] for line in table["rows"]] == [
        bound.row.name for bound in found.bounds if bound.row.name in found.slack
    ]
