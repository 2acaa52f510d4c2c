"""README.md and docs/: what they say of the program is so, links lead somewhere, nothing grows.

Numbers are in `tests.test_prose`.
"""

from __future__ import annotations

import json
import re
import sys
from fractions import Fraction
from pathlib import Path

import pytest

from tests.points import parameters
from tests.readme_commands import ROOT
from verify.language.statement import PROVED, REFUTED
from verify.language.typeset import Typesetter
from verify.paper.commands import pages
from verify.paper.commands.theorem1 import decide_point
from verify.paper.parameters import REPAIRED
from verify.paper.theorem1 import theorem
from verify.prover.choices import entries_of
from verify.publication import BREAKS

sys.path.append(str(ROOT / "docs"))

README = ROOT / "README.md"
PAGES = [README, *sorted((ROOT / "docs").rglob("*.md"))]


def words(page: str) -> str:
    return " ".join((ROOT / page).read_text(encoding="utf-8").split())


# --- figures -------------------------------------------------------------------------------------


def test_what_breaks_the_argument_has_two_causes() -> None:
    """One estimate of the proof, and the interior that the theorem claims of the set."""
    outcome = decide_point(parameters("3/100", "1"))
    refuted = {row.name: row for row, d in outcome.rows if d.verdict == REFUTED}
    assert all(outcome.decisions[name].sides for name in refuted)
    breaking = {name for name, row in refuted.items() if row.severity == BREAKS}
    causes = [cause for cause in theorem().causes if breaking & set(cause.rows)]
    assert [len(cause.rows) for cause in causes] == [1, 4]


def test_the_assumptions_are_those_of_the_readme() -> None:
    every = pages.decide("all_parameters")
    outcome = decide_point(parameters("3/100", "1"))
    assert {d.verdict for _, d in (*outcome.of_group(REPAIRED), *every.rows)} == {PROVED}
    assert outcome.assumptions == every.assumptions
    kinds = sorted(assumption.kind for assumption in outcome.assumptions)
    assert kinds == ["definition", *["general mathematics"] * 4, *["numbered glue"] * 4]


def test_what_is_generated_is_there() -> None:
    from generated import FRAGMENTS, MARK, section

    marks = [mark for page in PAGES for mark in MARK.findall(page.read_text(encoding="utf-8"))]
    assert sorted(marks) == sorted(FRAGMENTS)
    assert section("What was changed").startswith("| Label | Paper | Needed | Why |")
    for name in ("causes", "exit_codes", "schemas", "letters"):
        assert FRAGMENTS[name]().count("\n") > 5, name


def test_the_changes_are_those_of_the_repaired_set() -> None:
    """The entries of the repaired minima of which the pages speak."""
    typesetter = Typesetter({})
    bounds = {
        bound.short_name: [typesetter.term(entry) for entry in entries_of(bound.term)]
        for bound in theorem().parts[REPAIRED].bounds
    }
    assert "V_0/repaired.V_1·(delta_2²·h_5/12)" in bounds["delta_x"]
    assert "(1 - C_eta)/28·(V_0/√repaired.V_1)·repaired.Delta_theta" in bounds["eta_bar"]
    assert "repaired.Delta_theta/4" in bounds["d_const"]
    assert "one more entry in the minimum that defines δ_x: (V₀/V₁) δ₂² h₅/12" in words(
        "docs/explanation/proof.md"
    )


def test_equal_width() -> None:
    """Four bits at a time, and no greater width: in the data that the table is made from."""
    path = ROOT / "certificates/data/bench.json"
    table = json.loads(path.read_text(encoding="utf-8"))["tables"]["equal_width"]
    for bits, arb_bits, width, arb_width, _ in table["rows"]:
        assert arb_bits > bits
        assert (arb_bits - bits) % 4 == 0
        assert Fraction(arb_width) <= Fraction(width)


# --- paths and links -----------------------------------------------------------------------------


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_paths_and_links_lead_somewhere(page: Path) -> None:
    text = page.read_text(encoding="utf-8")
    for path in re.findall(r"`((?:verify|tests|certificates|docs)/[\w./-]*)`", text):
        assert (ROOT / path).exists(), path
    for link in re.findall(r"\]\(([^)#:]+)\)", text):
        places = [page.parent / link, page.parent / f"{link}.md"]
        assert any(place.exists() for place in places), link


def test_the_readme_is_short_and_has_the_lines_that_ci_reads() -> None:
    lines = README.read_text(encoding="utf-8").splitlines()
    assert len(lines) <= 110
    starts = [line for line in lines if line.startswith("python3 -m venv ")]
    assert [line.endswith("pytest") for line in starts] == [False, True]
