"""The table of other provers: the same questions, put to them as SMT-LIB."""

from __future__ import annotations

import pytest

from tests.measure import peers
from tests.measure.peers import Problem, peers_table, problems, smt_of
from verify.language.statement import PROVED, REFUTED
from verify.measure.inequalities import entries, question


def _problem(name: str) -> Problem:
    entry = next(entry for entry in entries() if entry["name"] == name)
    return Problem("published", "claim", question(entry), entry["truth"])


def test_peers_that_are_not_installed_are_named_and_left_out(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(peers, "_version", lambda _: None)
    monkeypatch.setattr(peers, "problems", lambda _: iter([_problem("lotka-volterra")]))
    table = peers_table(quick=True)
    assert "not installed: Z3, cvc5" in table["title"]
    ((_, tool, claims, decided, wrong, _, certificates),) = table["rows"]
    assert (tool, claims, decided, wrong, certificates) == ("verify", 1, 1, 0, 1)


def test_a_claim_with_functions_is_written_for_those_who_have_them_only() -> None:
    drawn = {problem.name: problem for problem in problems(quick=False)}
    sine = drawn["sin-problem-3"].statement
    assert smt_of(sine, functions=False) is None
    assert "(sin |on-sin-problem-3.x|)" in (smt_of(sine, functions=True) or "")
    root = smt_of(drawn["cbrt-problem-1"].statement, functions=False) or ""
    assert root.count("declare-const") == 3  # the variable and two roots
    assert len(drawn) > 60  # the published ones share a name


@pytest.mark.parametrize("peer", peers.PEERS)
def test_a_peer_answers_both_ways(peer: str) -> None:
    pytest.importorskip(peer.split("-")[0])
    known = [p for p in problems(quick=True) if p.statement.contexts]
    for truth, verdict in ((True, PROVED), (False, REFUTED)):
        wanted = [p for p in known if p.truth is truth]
        answers = {peers._asked(peer, p).verdict for p in wanted[:4]}
        assert verdict in answers
        assert (REFUTED if truth else PROVED) not in answers
