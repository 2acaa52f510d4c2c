"""README.md and docs/: counts are the program's, paths and links lead somewhere, nothing grows."""

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
from verify.paper.commands import everywhere
from verify.paper.commands.theorem1 import decide_point
from verify.paper.initial_data import ConstantSet
from verify.paper.parameters import REPAIRED
from verify.paper.rows import BREAKS
from verify.paper.theorem1 import theorem
from verify.prover.ground import DEFAULT_MAX_PRECISION, DEFAULT_PRECISION

sys.path.append(str(ROOT / "docs"))

README = ROOT / "README.md"
PAGES = [README, *sorted((ROOT / "docs").rglob("*.md"))]


def words(page: str) -> str:
    return " ".join((ROOT / page).read_text(encoding="utf-8").split())


# --- figures -------------------------------------------------------------------------------------


def counts() -> str:
    """What is wrong with the print at the point of the README, as it stands there."""
    from generated import figures

    found = figures()
    return (
        f"{found['refuted']} of its claims are refuted at r = 0.03, θ₀ = π, or at another point "
        f"that is named. {found['breaking']} of the {found['refuted']}, with "
        f"{found['breaking_causes']} causes, break the argument; {found['harmless']} are false but "
        f"harmless; {found['slips']} are slips of wording."
    )


def test_the_counts_are_right() -> None:
    assert counts() in words("README.md"), f"write in README.md: {counts()}"


def test_what_breaks_the_argument_has_two_causes() -> None:
    """One estimate of the proof, and the interior that the theorem claims of the set."""
    outcome = decide_point(parameters("3/100", "1"))
    refuted = {row.name: row for row, d in outcome.rows if d.verdict == REFUTED}
    assert all(outcome.decisions[name].sides for name in refuted)
    breaking = {name for name, row in refuted.items() if row.severity == BREAKS}
    causes = [cause for cause in theorem().causes if breaking & set(cause.rows)]
    assert [len(cause.rows) for cause in causes] == [1, 4]


def test_the_assumptions_are_those_of_the_readme() -> None:
    every = everywhere.decide_everywhere()
    outcome = decide_point(parameters("3/100", "1"))
    assert {d.verdict for _, d in (*outcome.of_group(REPAIRED), *every.rows)} == {PROVED}
    assert outcome.assumptions == every.assumptions
    kinds = sorted(assumption.kind for assumption in outcome.assumptions)
    assert kinds == ["definition", *["general mathematics"] * 4, *["numbered glue"] * 4]
    assert f"Given {len(kinds)} assumptions*: a definition" in words("README.md")


def test_what_the_verdicts_on_the_print_rest_on() -> None:
    from generated import sentences_of

    readme, tutorial = words("README.md"), words("docs/tutorials/referee.md")
    for folder, short in (
        ("printed-sign", "sentences for the sign"),
        ("printed-set", "for the set"),
    ):
        found = [proved and "(" not in name for name, proved in sentences_of(folder)]
        proved = str(sum(found) or "none")
        assert re.search(
            f" {len(found)} {short}, of which (Coq|it) has proved {proved}[ ,.]", readme
        )
        assert f"rests on {len(found)} sentences, of which Coq has proved {proved}" in tutorial


def test_what_is_generated_is_there() -> None:
    from generated import FRAGMENTS, MARK, section

    marks = [mark for page in PAGES for mark in MARK.findall(page.read_text(encoding="utf-8"))]
    assert sorted(marks) == sorted(FRAGMENTS)
    assert section("What was changed").startswith("| Label | Paper | Needed | Why |")
    for name in ("causes", "exit_codes", "schemas", "letters"):
        assert FRAGMENTS[name]().count("\n") > 5, name


def test_the_changes_are_those_of_the_repaired_set() -> None:
    """The entries of the repaired minima of which the pages speak."""
    typesetter, k = Typesetter({}), ConstantSet(REPAIRED)
    bounds = {name: [typesetter.term(e) for e in terms] for name, terms in k.bounds().items()}
    assert "V_0/repaired.V_1·(delta_2²·h_5/12)" in bounds["delta_x"]
    assert "(1 - C_eta)/28·(V_0/√repaired.V_1)·repaired.Delta_theta" in bounds["eta_bar"]
    assert "repaired.Delta_theta/4" in bounds["d_const"]
    assert "one more entry in the minimum that defines δ_x: (V₀/V₁) δ₂² h₅/12" in words(
        "docs/explanation/proof.md"
    )


def test_the_precision_of_the_glossary() -> None:
    said = f"{DEFAULT_PRECISION} bits, doubled up to {DEFAULT_MAX_PRECISION}"
    assert said in words("docs/reference/glossary.md")


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
    assert len(lines) <= 120
    starts = [line for line in lines if line.startswith("python3 -m venv ")]
    assert [line.endswith("pytest") for line in starts] == [False, True]
