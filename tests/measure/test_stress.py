"""The hard cases are answered rightly, and a wrong answer would be seen."""

from __future__ import annotations

import json

import pytest

from tests.points import parameters
from verify.cli import main
from verify.measure import stress
from verify.measure.stress import Case, run_claim, run_spectrum, run_theorem1
from verify.paper.commands.eigenvalues import Spectrum
from verify.paper.commands.theorem1 import decide_point


def test_every_short_case_is_right() -> None:
    findings = list(map(stress.run_case, stress.cases(quick=True)))
    assert len(findings) > 30
    assert [finding.case.name for finding in findings if not finding.right] == []


def test_the_long_form_has_more_cases_and_no_name_twice() -> None:
    names = [case.name for case in stress.cases(quick=False)]
    assert len(set(names)) == len(names) > len(stress.cases(quick=True))


CASE = Case("ordinary", "for the test", "theorem1", {"r": "0.03"}, "proved")


def test_a_wrong_verdict_is_seen() -> None:
    assert run_theorem1(CASE).right
    assert not run_theorem1(CASE._replace(expect="refuted")).right


def test_a_wrong_answer_about_functions_is_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    case = Case("sine", "for the test", "claim", {"claim": "0 < sin(10^22)"}, "refuted")
    assert run_claim(case).right
    assert not run_claim(case._replace(expect="proved")).right
    ends = stress.CheckerEngine.ends
    monkeypatch.setattr(stress.CheckerEngine, "ends", lambda *a: [-e for e in ends(*a)][::-1])
    assert not run_claim(case).right


def test_a_wrong_enclosure_is_seen() -> None:
    outcome = decide_point(parameters("3/100", "1"), "repaired")
    assert stress.constants_agree(outcome, 600)
    found = outcome.enclosures["phi_minus"]
    low, high = found.ends[0]
    shifted = found._replace(ends=((low * 2, high * 2),))
    wrong = outcome._replace(enclosures={**outcome.enclosures, "phi_minus": shifted})
    assert not stress.constants_agree(wrong, 600)


def test_a_wrong_hypothesis_is_seen() -> None:
    outcome = decide_point(parameters("1/64", "8/13"), "repaired")
    assert stress.hypotheses_are_exact(outcome)
    name = "hypotheses.stability"
    found = outcome.decisions[name]
    assert found.judged is not None
    wrong = found._replace(judged=found.judged._replace(verdict="proved"))
    outcome = outcome._replace(decisions={**outcome.decisions, name: wrong})
    assert not stress.hypotheses_are_exact(outcome)


def test_a_wrong_eigenvalue_is_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    case = Case("root", "for the test", "spectrum", {"r": "1/3"}, "enclosed")
    assert run_spectrum(case).right
    honest = stress.eigenvalues.at

    def other(r: object, bits: int) -> Spectrum:
        return honest(r * 2, bits)  # type: ignore[arg-type, operator]

    monkeypatch.setattr(stress.eigenvalues, "at", other)
    assert not run_spectrum(case).right


def test_the_command(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["stress", "--quick", "--json"]) == 0
    document = json.loads(capsys.readouterr().out)
    assert document["command"] == "stress"
    table = document["tables"]["cases"]
    assert all(len(row) == len(table["columns"]) for row in table["rows"])
