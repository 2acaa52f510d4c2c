"""The README says what the program finds; run this file to bring its table up to date."""

from __future__ import annotations

import json
from collections.abc import Iterable
from pathlib import Path

from tests.points import parameters
from verify.prover.ground import PROVED, REFUTED
from verify.language.statement import HYPOTHESES, PRINTED, REPAIRED
from verify.jobs.theorem1 import decide
from verify.views.markdown import defects, table

README = Path(__file__).resolve().parent.parent / "README.md"
DATA = README.parent / "certificates" / "data" / "bench.json"


def expected(text: str) -> str:
    text = between(text, "defects", defects(decide(parameters("3/100", "1"))))
    for name in ("precision", "equal_width", "double_verdicts"):
        measured = json.loads(DATA.read_text(encoding="utf-8"))["tables"][name]
        rows = [tuple(map(str, row)) for row in measured["rows"]]
        text = between(text, name, table(tuple(measured["columns"]), rows))
    return text


def between(text: str, name: str, lines: Iterable[str]) -> str:
    begin, end = f"<!-- {name}: begin -->\n", f"<!-- {name}: end -->\n"
    before, rest = text.split(begin)
    content = "\n".join(lines)
    return f"{before}{begin}{content}\n{end}{rest.split(end)[1]}"


def test_the_tables_are_what_the_program_found() -> None:
    text = README.read_text(encoding="utf-8")
    assert text == expected(text)


def test_the_counts_are_right() -> None:
    text = README.read_text(encoding="utf-8")
    outcome = decide(parameters("3/100", "1"))
    printed = [
        decision.verdict
        for group in (HYPOTHESES, PRINTED)
        for row, decision in outcome.rows[group]
        if row.role == "printed"
    ]
    assert f"{printed.count(REFUTED)} of its steps are refuted" in text
    proved = [d.verdict for _, d in outcome.rows[REPAIRED]].count(PROVED)
    assert f"all {proved} inequalities are proved, given {len(outcome.assumptions)}" in text


if __name__ == "__main__":
    README.write_text(expected(README.read_text(encoding="utf-8")), encoding="utf-8")
