"""The README says what the program finds; run this file to bring its tables up to date."""

from __future__ import annotations

import json
import re
from collections import Counter
from collections.abc import Iterable
from pathlib import Path
from textwrap import wrap

from tests.points import parameters
from verify.language.statement import PRINTED, PROVED, REFUTED
from verify.paper.commands import everywhere, spectrum
from verify.paper.commands.theorem1 import decide_point
from verify.paper.groups import REPAIRED
from verify.paper.rows import BREAKS, HARMLESS, SLIP
from verify.paper.source import PAPER
from verify.paper.step.numbers import COLLAPSE
from verify.paper.theorem1 import theorem
from verify.views.markdown import defects
from verify.views.setting import markdown_template

ROOT = Path(__file__).resolve().parent.parent
README = ROOT / "README.md"
DATA = ROOT / "certificates" / "data" / "bench.json"


def expected(text: str) -> str:
    text = between(text, "counts", counts())
    table = defects(decide_point(parameters("3/100", "1")), PAPER)
    text = between(text, "defects", table.splitlines())
    text = between(text, "causes", [f"* `{'`, `'.join(c.rows)}`: {c.text}" for c in causes()])
    remarks = theorem().remarks
    text = between(text, "remarks", [f"* `{remark.label}`: {remark.text}" for remark in remarks])
    for name in ("precision", "equal_width", "double_verdicts"):
        measured = json.loads(DATA.read_text(encoding="utf-8"))["tables"][name]
        rows = [tuple(map(str, row)) for row in measured["rows"]]
        table = markdown_template("markdown.j2").module.grid(measured["columns"], rows)
        text = between(text, name, table.strip().splitlines())
    return text


def counts() -> list[str]:
    """What is wrong with the print at the point of the README, in numbers."""
    outcome = decide_point(parameters("3/100", "1"))
    refuted = [row for row, d in outcome.rows if row.role == PRINTED and d.verdict == REFUTED]
    assert all(outcome.decisions[row.name].sides for row in refuted)
    by_severity = Counter(row.severity for row in refuted)
    alone = sum(".alone-" in row.name for row in refuted)
    breaking = {row.name for row in refuted if row.severity == BREAKS}
    assert sum(bool(breaking & set(cause.rows)) for cause in causes()) == 1
    text = (
        f"* **The proof as printed does not close.** At r = 0.03, θ₀ = π, {len(refuted)} of its "
        f"rows are refuted, each with both sides enclosed; they have {len(causes())} causes. "
        f"{by_severity[BREAKS]} rows, of one cause, break the argument; {by_severity[HARMLESS]} "
        f"are false but harmless there, and {alone} of these ask of one entry of a minimum alone "
        "what the text claims of the whole minimum; "
        f"{by_severity[SLIP]} are slips of wording."
    )
    return wrap(text, 99, subsequent_indent="  ")


def causes():
    """The causes of rows that are refuted at the point of the README."""
    found = decide_point(parameters("3/100", "1"))
    refuted = {row.name for row, decision in found.rows if decision.verdict == REFUTED}
    return [cause for cause in theorem().causes if refuted & set(cause.rows)]


def between(text: str, name: str, lines: Iterable[str]) -> str:
    begin, end = f"<!-- {name}: begin -->\n", f"<!-- {name}: end -->\n"
    before, rest = text.split(begin)
    content = "\n".join(lines)
    return f"{before}{begin}{content}\n{end}{rest.split(end)[1]}"


def test_the_tables_are_what_the_program_found() -> None:
    text = README.read_text(encoding="utf-8")
    assert text == expected(text), "run `python -m tests.test_readme`, and look at what it changed"


def test_the_counts_are_right() -> None:
    text = " ".join(README.read_text(encoding="utf-8").split())
    outcome = decide_point(parameters("3/100", "1"))
    own = [(row, d) for row, d in outcome.of_group(REPAIRED) if row.name != COLLAPSE]
    proved = [d.verdict for _, d in own]
    assert {*proved, outcome.decisions[COLLAPSE].verdict} == {PROVED}
    assert "all rows of the repaired set are proved" in text
    assert f"The {len(outcome.printed_assumptions)} sentences that the paper's own rows" in text
    graded = [assumption.kind for assumption in outcome.assumptions]
    assert outcome.assumptions == everywhere.decide_everywhere().assumptions
    assert len(graded) == 8
    assert "rests on eight sentences: a definition" in text
    rows = [row for row, _ in everywhere.decide_everywhere().rows if row.group == REPAIRED]
    assert {row.name for row in rows} >= {row.name for row, _ in outcome.of_group(REPAIRED)}
    assert sorted(graded) == ["definition", *["general mathematics"] * 3, *["numbered glue"] * 4]
    witnesses = [d for _, d in spectrum.decide_spectrum().rows if d.verdict == REFUTED]
    assert len(witnesses) == 9
    assert all(d.method == "witness" for d in witnesses)
    assert "Nine rows are refuted, each with an exact witness" in text


def test_the_files_that_it_names_exist() -> None:
    text = README.read_text(encoding="utf-8")
    for path in re.findall(r"`((?:verify|tests|certificates)/[\w./-]*)`", text):
        assert (ROOT / path).exists(), path


if __name__ == "__main__":
    README.write_text(expected(README.read_text(encoding="utf-8")), encoding="utf-8")
