"""The hard cases are answered rightly, and a wrong answer would be seen."""

from __future__ import annotations

import json

import pytest

from tests.points import parameters
from verify.measure import stress
from verify.cli import main
from verify.prover.eigenvalues import Spectrum
from verify.prover.ground import Prover
from verify.language.statement import HYPOTHESES
from verify.measure.stress import Case, run_spectrum, run_theorem1
from verify.jobs.theorem1 import decide


def test_every_short_case_is_right() -> None:
    findings = list(stress.run(quick=True))
    assert len(findings) > 30
    assert [finding.case.name for finding in findings if not finding.right] == []


def test_the_long_form_has_more_cases_and_no_name_twice() -> None:
    names = [case.name for case in stress.cases(quick=False)]
    assert len(set(names)) == len(names) > len(stress.cases(quick=True))


CASE = Case("ordinary", "for the test", "theorem1", {"r": "0.03"}, "proved")


def test_a_wrong_verdict_is_seen() -> None:
    assert run_theorem1(CASE).right
    assert not run_theorem1(CASE._replace(expect="refuted")).right


def test_a_wrong_enclosure_is_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    honest = Prover.enclose

    def shifted(self: Prover, term: object) -> object:
        ends = honest(self, term)  # type: ignore[arg-type]
        return None if ends is None else (ends[0] * 2, ends[1] * 2)

    monkeypatch.setattr(Prover, "enclose", shifted)
    assert not run_theorem1(CASE).right


def test_a_wrong_hypothesis_is_seen() -> None:
    outcome = decide(parameters("1/64", "8/13"), "repaired")
    assert stress.hypotheses_are_exact(outcome)
    rows = outcome.rows[HYPOTHESES]
    outcome.rows[HYPOTHESES] = [
        (row, found._replace(verdict="proved") if row.name.endswith("stability") else found)
        for row, found in rows
    ]
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
