"""The table of how times grow: its exponents, its jobs, and what the page shows of it."""

from __future__ import annotations

import json

import pytest

from tests.measure.benchmarks.growth import COLUMNS, FIGURES, JOBS, Growth, rows, slope
from verify.wire import questions
from verify.wire.write import statement_file


def test_the_exponent_of_a_power_is_found_from_the_larger_sizes() -> None:
    sizes = (1, 2, 4, 8, 16)
    assert slope(sizes, [n**1.5 for n in sizes]) == pytest.approx(1.5)
    assert slope(sizes, [9, 9, *(3 * n**2 for n in sizes[2:])]) == pytest.approx(2)


@pytest.mark.parametrize("growth", JOBS, ids=lambda growth: growth.varied)
def test_each_job_does_its_work(growth: Growth) -> None:
    growth.prepare(growth.sizes[0])()


def test_the_committed_table_is_about_these_jobs() -> None:
    found = json.loads(FIGURES.read_text(encoding="utf-8"))
    assert found["columns"] == list(COLUMNS)
    assert [(row[:3], row[-1]) for row in found["rows"]] == [
        ([growth.varied, growth.job, growth.ends], growth.limit) for growth in JOBS
    ]


def test_a_statement_is_written_as_often_for_many_rows(monkeypatch: pytest.MonkeyPatch) -> None:
    written: list[object] = []

    def counted(outcome: questions.Outcome) -> object:
        written.append(outcome)
        return statement_file(outcome)

    monkeypatch.setattr("verify.wire.questions.statement_file", counted)
    monkeypatch.setattr("verify.wire.write.statement_file", counted)
    rows(2)()
    few = len(written)
    rows(12)()
    assert len(written) == 2 * few
