"""The README says what the program finds; run this file to bring its table up to date."""

from __future__ import annotations

from pathlib import Path

from tests.points import parameters
from verify.prover import PROVED, REFUTED
from verify.statement import HYPOTHESES, PRINTED, REPAIRED
from verify.theorem1 import decide
from verify.views.markdown import defects

README = Path(__file__).resolve().parent.parent / "README.md"
BEGIN, END = "<!-- defects: begin -->\n", "<!-- defects: end -->\n"


def expected(text: str) -> str:
    before, rest = text.split(BEGIN)
    after = rest.split(END)[1]
    table = "\n".join(defects(decide(parameters("3/100", "1"))))
    return f"{before}{BEGIN}{table}\n{END}{after}"


def test_the_table_of_defects_is_what_the_program_finds() -> None:
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
