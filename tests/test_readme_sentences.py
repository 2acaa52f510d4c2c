"""Every sentence of the README with a number, or with a word like "all" or "never", is tested.

`BACKED` has for a piece of each such sentence the tests that would fail if it were false: functions
of other files by name, or checks that stand here. The tables of the README and its commands have
tests of their own (`tests/test_readme.py`, `tests/cli`).
"""

from __future__ import annotations

import ast
import json
import re
import subprocess
import sys
from collections import Counter
from collections.abc import Callable
from fractions import Fraction
from functools import cache
from pathlib import Path

import pytest

from tests.points import parameters
from verify.language.statement import NEEDED, PRINTED, PROVED, REFUTED
from verify.language.typeset import Typesetter
from verify.paper.commands.classification import decide_classification
from verify.paper.commands.elsewhere import decide_elsewhere
from verify.paper.commands.spectrum import decide_spectrum
from verify.paper.commands.theorem1 import decide_point
from verify.paper.groups import REPAIRED
from verify.paper.initial_data import ConstantSet
from verify.paper.rows import BREAKS
from verify.paper.step.numbers import row_names
from verify.paper.theorem1 import theorem
from verify.prover.constants import DEFAULT_MAX_PRECISION, DEFAULT_PRECISION
from verify.prover.outcome import EXIT_CODES
from verify.views.words import headline

ROOT = Path(__file__).resolve().parent.parent

#: What a sentence says that needs a test.
CLAIMING = re.compile(
    r"\d|\b(all|any|both|each|every|never|no|none|nothing|only|"
    r"one|two|three|four|five|six|seven|eight|nine|ten)\b",
    re.IGNORECASE,
)


def python_version() -> None:
    assert 'requires-python = ">=3.11"' in (ROOT / "pyproject.toml").read_text(encoding="utf-8")


def ladder() -> None:
    assert (DEFAULT_PRECISION, DEFAULT_MAX_PRECISION) == (128, 65536)
    assert 65536 == 128 * 2**9


def changed_constants() -> None:
    """The entries of the repaired minima that the README names."""
    typesetter, k = Typesetter({}), ConstantSet(REPAIRED)
    bounds = {name: [typesetter.term(e) for e in terms] for name, terms in k.bounds().items()}
    assert "V_0/repaired.V_1·(delta_2²·h_5/12)" in bounds["delta_x"]
    assert "(1 - C_eta)/28·(V_0/√repaired.V_1)·repaired.Delta_theta" in bounds["eta_bar"]
    assert "repaired.Delta_theta/4" in bounds["d_const"]
    rows = [row for row, _ in decide_point(parameters("3/100", "1"), REPAIRED).rows]
    (angle,) = (row for row in rows if row.name == "repaired.angle-absorbed")
    assert "14/(1 - C_eta)·(√repaired.V_1/V_0)·repaired.eta_bar" in typesetter.claim(angle.claim)


def rows_of_the_step() -> None:
    """How many rows of the repaired set the step takes as givens."""
    taken = {name for name in row_names().values() if name.startswith(f"{REPAIRED}.")}
    rows = {row.name for row in theorem().parts[REPAIRED].obligations}
    assert taken < rows
    text = " ".join((ROOT / "README.md").read_text(encoding="utf-8").split())
    assert f"It takes {len(taken)} of these rows" in text


def changes_in_reports() -> None:
    for report in (ROOT / "certificates").glob("theorem1-r-*/report.md"):
        assert "| Label | Paper | Needed | Why |" in report.read_text(encoding="utf-8"), report


def equal_width() -> None:
    """Four bits at a time, and no greater width: in the data that the table is made from."""
    path = ROOT / "certificates/data/bench.json"
    table = json.loads(path.read_text(encoding="utf-8"))["tables"]["equal_width"]
    for bits, arb_bits, width, arb_width, _ in table["rows"]:
        assert arb_bits > bits
        assert (arb_bits - bits) % 4 == 0
        assert Fraction(arb_width) <= Fraction(width)


def oracle_bits() -> None:
    from tests.prover.test_oracle import CONTEXT

    assert CONTEXT.prec == 2000


def mutation_figures() -> None:
    """The figures were measured by hand; what is left of them to test is that they agree."""
    text = " ".join((ROOT / "README.md").read_text(encoding="utf-8").split())
    found = re.findall(r"(\d+) of (\d+) (?:mutants )?of `verify/\w+.py`, ([\d.]+) %", text)
    assert len(found) == 2
    for noticed, mutants, share in (map(Fraction, one) for one in found):
        assert abs(noticed / mutants * 100 - share) < Fraction(1, 20)
        assert share >= 95
        assert mutants >= 600


def counts_elsewhere() -> None:
    """Rows by role, all decided the right way; and how many things two readers found."""
    outcome = decide_elsewhere()
    roles = Counter((row.role, found.verdict) for row, found in outcome.rows)
    needed, printed = roles[NEEDED, PROVED], roles[PRINTED, REFUTED]
    assert needed + printed == sum(roles.values())
    text = " ".join((ROOT / "README.md").read_text(encoding="utf-8").split())
    said = f"with {needed + printed} rows: {needed} are needed and proved, {printed} are printed"
    assert said in text
    readers = f"found {44 + 23 + 6} things: 44 of them both, 23 the first alone, 6 the second alone"
    assert readers in text
    breaking = [row for row, _ in outcome.rows if row.severity == BREAKS]
    assert len(breaking) == 1


def conditionally_proved() -> None:
    outcome = decide_spectrum()
    assert headline(outcome) == "conditionally proved"
    assert EXIT_CODES[outcome.verdict] == 0


def sentences_of_the_classification() -> None:
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    assert f"given {len(decide_classification().assumptions)}\nsentences" in text


def the_set_is_small() -> None:
    outcome = decide_point(parameters("3/100", "1"), REPAIRED)
    assert Fraction(25, 10**19) < outcome.enclosures["repaired.d_bar"].ends[0][1]
    assert outcome.enclosures["repaired.d_bar"].ends[0][1] <= Fraction(26, 10**19)
    assert outcome.enclosures["repaired.eta_bar"].ends[0][1] == Fraction(52, 10**8)


def areas_of_the_map() -> None:
    """The shares of the README are those that the checker of maps counts."""
    said = subprocess.run(
        [sys.executable, "-I", "verify/check_map.py", "certificates/map/map.jsonl"],
        cwd=ROOT,
        capture_output=True,
        encoding="utf-8",
        check=True,
    ).stdout
    shares = [Fraction(share) for share in re.findall(r"\(about ([\d.]+) %\)", said)]
    assert [f"{float(share):.1f} %" for share in shares] == ["9.8 %", "90.0 %", "0.2 %"]


def inequality_figures() -> None:
    """How many were decided was measured by hand; here: that the names of the open ones add up."""
    path = ROOT / "verify/data/inequalities.json"
    names = set(re.findall(r'"name": "([^"]+)"', path.read_text(encoding="utf-8")))
    rest = {"minif2f-3onsqrt2", "dreal-sk"}
    assert rest <= names
    assert (len(names), len(names - rest)) == (99, 97)


Check = str | Callable[[], None]

COLLAPSES = "tests/paper/classification/test_classification.py::test_all_rows_are_proved"
RUNS = "tests/paper/classification/test_simulation.py::test_random_runs"
COUNTS = "tests/test_readme.py::test_the_counts_are_right"
TABLES = "tests/test_readme.py::test_the_tables_are_what_the_program_found"

BACKED: dict[str, tuple[Check, ...]] = {
    # judges
    "No verdict is given without a judge": (
        "tests/cli/test_judges.py::test_nothing_is_said_without_judges",
        "tests/cli/test_judges.py::test_only_judges_make_judgements",
    ),
    "For all other verdicts, and whatever is written": (
        "tests/cli/test_judges.py::test_what_rests_on_a_proof_is_not_said_without_the_checker",
    ),
    "`verify spectrum` says *conditionally proved*": (conditionally_proved,),
    # maps
    "`--long` lifts the limit": ("tests/check/test_check_map_lies.py::test_a_log_without_limit",),
    "`certificates/map` has the plane of": (areas_of_the_map,),
    "-η_c = 1/100 and both tangential speeds 1": (areas_of_the_map,),
    "this plane have centres and velocities in one plane, also in space": (
        "tests/spheres/map/test_boxes.py::test_points_of_decided_boxes_do_what_was_proved",
    ),
    "`verify map` has that checker prove the log": (
        "tests/cli/test_map.py::test_a_judge_that_decides_nothing",
        "tests/cli/test_map.py::test_a_log_whose_verdicts_were_changed",
    ),
    "with a curve f that its log has, every state": (
        "tests/check/test_check_map.py::test_the_committed_strip",
    ),
    "proves each box of a log again": (
        "tests/check/test_check_map.py::test_it_stands_alone_and_calculates_with_whole_numbers",
        "tests/check/test_check_map.py::test_one_verdict_changed",
    ),
    # the checker in Coq; what it proves is for Coq to say, in `.ci/coq`
    "`verify/coq/Theorem1.v` says Theorem 1 for all parameters": (
        "tests/coq/test_theorem.py::test_the_page_has_only_definitions",
    ),
    "Coq proves it from the certificates of the step and of `theorem1 --all`": (
        "tests/coq/test_theorem.py",
        "tests/coq/test_tampering.py::test_what_all_theorems_rest_on_is_committed",
        "tests/coq/test_tampering.py::test_an_assumption_is_seen_in_the_file",
    ),
    "For each dimension from 2 on there are such scenes": (
        "tests/coq/test_theorem.py::test_the_theorem_is_what_the_page_says",
    ),
    # statements of one's own
    "Of 99 published inequalities": (inequality_figures,),
    "Open are minif2f-3onsqrt2": (inequality_figures,),
    "Another 48 (`tests/prover/holdout.json`)": ("tests/prover/test_holdout.py::test_decided",),
    # what is printed elsewhere
    "`verify elsewhere` judges Sections 1 to 4.1": (
        counts_elsewhere,
        "tests/paper/elsewhere/test_elsewhere.py::test_a_misprint_is_false_at_its_point",
    ),
    "has a line for each displayed formula and each numbered claim outside Section 4": (
        "tests/paper/test_formulas_elsewhere.py",
    ),
    "Two readers who did not know each other's list": (counts_elsewhere,),
    "One refuted row breaks an argument": (
        counts_elsewhere,
        "tests/paper/elsewhere/test_elsewhere.py::test_a_misprint_is_corrected_by_a_row_that_is_proved",
    ),
    "is false for each collapse on a line": (
        "tests/paper/elsewhere/test_elsewhere.py::test_the_line_satisfies_what_the_mapping_assumes",
    ),
    # beyond the paper
    "`verify classification` proves four theorems": (sentences_of_the_classification, COLLAPSES),
    "Throughout, triple contacts are excluded": ("tests/cli/test_classification.py",),
    "No triangular collapse": (COLLAPSES, RUNS),
    "Three balls of any masses and radii": (COLLAPSES, RUNS),
    "With equal masses and one r the final": (COLLAPSES, RUNS),
    "So for r > 7-4√3": ("tests/cli/test_classification.py::test_at_one_r",),
    "At r = 0.08 one ball meets two others": (
        "tests/cli/test_classification.py::test_the_longest_run",
    ),
    "the impulses of all collisions have a finite sum": (COLLAPSES, RUNS),
    "Infinitely many collisions of three balls": (COLLAPSES,),
    # the separatrix; what Coq proves is for Coq to say, in `verify/coq/build-separatrix`
    "Coq proves that there is such a curve if and only if": (
        "tests/coq/test_separatrix.py::test_the_theorem_is_what_the_page_says",
        "tests/spheres/test_separatrix.py::test_the_threshold_is_strict",
    ),
    "f(1/10) = 0.0517785627": ("tests/spheres/test_separatrix.py::test_a_known_value",),
    "Nothing is decided here about the full dynamics": (
        "tests/cli/test_separatrix.py::test_what_is_not_decided_is_said",
    ),
    # scenes
    "The set of Theorem 1 is small": (the_set_is_small,),
    "It writes nothing while a row": (
        "tests/cli/test_prove.py::test_an_undecided_row_writes_nothing",
    ),
    "Numbers are texts like": ("tests/cli/test_prove.py::test_an_unusable_statement",),
    "For three given particles a sharper theorem decides": ("tests/paper/sharper/test_sharper.py",),
    "three `positions` and three `velocities`": (
        "tests/cli/test_scene.py::test_numbers_are_read_exactly",
        "tests/cli/test_scene.py::test_unusable_input_is_one_line",
    ),
    "it *disperses*, no two collide any more": (
        "tests/cli/test_scene.py::test_the_examples",
        "tests/paper/commands/test_scene.py::test_random_scenes_with_every_kind_of_move",
    ),
    # what the paper says, in the words of its abstract
    "construct an explicit set of initial data from which three hard spheres": (
        "tests/paper/step/test_step.py::test_orbits_from_the_initial_set_satisfy_all_conditions",
    ),
    # what was found
    "rows of the repaired set are proved there": (
        COUNTS,
        "tests/paper/commands/test_theorem1.py::test_chosen_constants_are_short_and_do_not_depend_on_the_precision",
    ),
    "The step is proved for every state": (
        "tests/paper/step/test_step.py::test_the_step_is_proved_and_small",
        "tests/paper/step/test_step.py::test_no_claim_is_violated_at_random_states",
        "tests/paper/step/test_step.py::test_a_point_run_cites_the_step",
    ),
    "of these rows; the others are": (
        rows_of_the_step,
        "tests/paper/test_formulas.py::test_every_needed_row_is_on_a_path_or_beside_a_fact_that_is",
    ),
    "the verdict at a point rests on": (
        COUNTS,
        "tests/paper/step/test_step.py::test_a_point_run_cites_the_step",
        "tests/paper/step/test_step.py::test_glue_names_rows_that_are_there",
    ),
    "sentences that the paper's own rows rest on": (COUNTS,),
    "The repaired theorem, for all parameters, given": (
        COUNTS,
        "tests/paper/everywhere/test_everywhere.py::test_everything_is_proved_and_small",
    ),
    "`verify theorem1 --all` proves all these rows": (
        COUNTS,
        "tests/paper/everywhere/test_everywhere.py::test_the_rows_are_those_of_the_theorem",
        "tests/paper/step/test_step.py::test_the_step_is_proved_and_small",
    ),
    "re-checks them with nothing but Python's standard library": (
        "tests/check/test_wall.py::test_it_imports_nothing_but_the_standard_library",
        "tests/check/test_wall.py::test_nothing_from_this_package_is_loaded",
    ),
    "steps of the printed proof are refuted at every point": (
        "tests/prover/test_cover.py::test_verdicts_on_cells_hold_at_their_points",
        "tests/views/test_plots.py::test_cells_of_the_picture_lie_where_they_say",
    ),
    "all rows of the repaired set are proved at every point": (
        "tests/prover/test_cover.py::test_verdicts_on_cells_hold_at_their_points",
        "tests/prover/test_cover.py::test_algebraic_rows_hold_elsewhere_too",
    ),
    # using it
    "Python 3.11 or newer": (python_version,),
    "Nothing passes through a float": (
        "tests/language/test_terms.py::test_a_float_is_refused_with_what_to_write_instead",
        "tests/cli/test_theorem1.py::test_500_digits_are_read_exactly",
        "tests/check/test_wall.py::test_no_floating_point",
    ),
    "on a machine with nothing but Python": (
        "tests/check/test_wall.py::test_it_imports_nothing_but_the_standard_library",
        "tests/check/test_report.py::test_it_runs_alone",
    ),
    # how to read a verdict
    "A row is a claim `left < right`": ("tests/prover/test_universal.py::test_verdicts",),
    "a minimum is at most each of its entries": (
        "tests/check/test_rule_entry.py",
        "tests/cli/test_holes.py::test_a_an_entry_is_not_the_minimum_on_the_way_to_it",
    ),
    "There is no tolerance": (
        "tests/prover/test_cover.py::test_an_equality_on_a_cell_is_never_decided",
        "tests/paper/commands/test_theorem1.py::test_equality_in_the_hypothesis_is_a_definite_no",
    ),
    "for a claim about all values, at a witness": (
        "tests/paper/spectrum/test_rows.py::test_each_witness_is_exact",
        "tests/check/test_rule_witness.py",
    ),
    "128 bits, doubled up to 65536": (ladder,),
    "a refuted one says how bad it is": (
        "tests/paper/test_rows.py::test_every_refuted_row_says_how_bad_it_is_and_what_corrects_it",
    ),
    # what the printed proof gets wrong
    "At r = 3/100, θ₀ = π, V₀ = 1, δ_θ = 1/10": (TABLES,),
    "the digits shown are those on which both ends agree": (
        TABLES,
        "tests/prover/test_decimals.py::test_short_texts_show_only_common_digits",
    ),
    "-cos θ₀ = 1 violates the hypothesis as printed": (
        "tests/paper/test_rows.py::test_the_printed_hypothesis_fails_wherever_the_needed_one_holds",
    ),
    "Why, once for each cause": (
        TABLES,
        "tests/paper/test_rows.py::test_each_row_with_a_severity_has_one_cause",
    ),
    "`verify spectrum` judges formulas of Sections 4.1": (
        "tests/paper/spectrum/test_rows.py::test_a_row_is_claimed_for_its_numbers",
    ),
    "each with an exact witness": (
        COUNTS,
        "tests/paper/spectrum/test_rows.py::test_exactly_these_sentences_are_refuted",
        "tests/paper/spectrum/test_rows.py::test_each_witness_is_exact",
    ),
    # what is changed
    "is in the committed reports on Theorem 1": (changes_in_reports,),
    "the tail of the angle sum is 14": (changed_constants,),
    "rounded down to three digits": (
        "tests/paper/commands/test_theorem1.py::test_each_chosen_constant_is_the_last_that_works",
        "tests/paper/commands/test_theorem1.py::test_chosen_constants_are_short_and_do_not_depend_on_the_precision",
    ),
    # speed against error
    "Measured by `verify bench`": (TABLES, "tests/measure/test_bench.py::test_the_quick_form"),
    "At no greater width": (equal_width,),
    "the least multiple of four extra bits": (equal_width,),
    "each is compared with an independent computation": (
        "tests/measure/test_stress.py::test_every_short_case_is_right",
        "tests/measure/test_stress.py::test_a_wrong_verdict_is_seen",
    ),
    # what is trusted
    "The assumptions listed with each statement": (
        "tests/paper/test_rows.py::test_assumptions_have_a_kind_and_are_used",
    ),
    "a file of tests for each rule": (
        "tests/check/test_wall.py::test_every_rule_has_a_test_file",
        "tests/lies/test_lies.py::test_enough_lies",
        "tests/test_mutation.py::test_all_mutants_of_a_function",
    ),
    "With 2000 bits as an oracle": (oracle_bits, "tests/prover/test_oracle.py::test_agreement"),
    "Mutants of both checkers": (
        "tests/test_mutation.py::test_all_mutants_of_a_function",
        "tests/test_mutation.py::test_what_is_noticed",
    ),
    "in random samples the tests noticed": (mutation_figures,),
    "which `tests/excused` lists with the reasons": (
        "tests/test_mutation.py::test_each_excused_mutant_is_one_and_has_a_reason",
    ),
    "had not seen the first": (
        "tests/paper/test_transcription.py::test_the_constants_are_the_same",
        "tests/paper/test_transcription.py::test_every_blind_row_is_here_or_accounted_for",
    ),
    "maps the displayed formulas of Section 4": (
        "tests/paper/test_formulas.py::test_there_is_one_line_for_every_displayed_formula",
    ),
}


@cache
def sentences() -> tuple[str, ...]:
    """The sentences of the README; not its headings, tables, commands and generated lists."""
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    made = r"<!-- (?!mutation)(\w+): begin -->.*?<!-- \1: end -->\n"
    text = re.sub(made, "\n", text, flags=re.DOTALL)
    text = re.sub(r"<!--.*?-->\n", "", text)
    text = re.sub(r"```.*?```", "\n\n", text, flags=re.DOTALL)
    found = []
    for block in re.split(r"\n\s*\n", text):
        if not block.startswith(("|", "#", "![")):
            for item in re.split(r"\n(?=\* )", block):
                words = " ".join(item.split()).removeprefix("* ")
                found += re.split(r"(?<=[.:])(?:\*\*)? (?=[A-Z*`(])", words)
    return tuple(filter(None, found))


def claiming() -> list[str]:
    return [s for s in sentences() if CLAIMING.search(re.sub(r"`[^`]*`", "", s))]


def test_each_sentence_that_claims_something_has_a_test() -> None:
    assert len(claiming()) > 30
    assert not [s for s in claiming() if not any(piece in s for piece in BACKED)]


def test_each_entry_is_about_a_sentence() -> None:
    assert not [piece for piece in BACKED if not any(piece in s for s in sentences())]


def test_the_tests_exist() -> None:
    for checks in BACKED.values():
        for check in checks:
            if isinstance(check, str):
                path, _, name = check.partition("::")
                body = ast.parse((ROOT / path).read_text(encoding="utf-8")).body
                names = {node.name for node in body if isinstance(node, ast.FunctionDef)}
                assert names if not name else name in names, check


HERE = sorted({c for checks in BACKED.values() for c in checks if not isinstance(c, str)}, key=repr)


@pytest.mark.parametrize("check", HERE, ids=lambda check: check.__name__)
def test_checks_that_stand_here(check: Callable[[], None]) -> None:
    check()
