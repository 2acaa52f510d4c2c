"""The step: accepted as it is, refused with anything missing or stronger, true at random states."""

from __future__ import annotations

import json
import shutil
from collections.abc import Mapping
from fractions import Fraction
from hashlib import sha256
from pathlib import Path
from typing import Any

import pytest

from tests.paper.changed_statements import report
from tests.paper.step.states import BITS, NAMES, STEP, Random, Values, checker, evaluate
from verify import check
from verify.cli import main
from verify.language.statement import NEEDED, PROVED, REFUTED, UNDECIDED, Always, Obligation
from verify.language.terms import Claim, Term, as_term, substitute_claim, symbol
from verify.paper.commands import citing, pages
from verify.paper.commands.theorem1 import decide_point
from verify.paper.parameters import ALL, PARAMETERS
from verify.paper.theorem1 import theorem
from verify.prover import balls
from verify.prover.ground import Ground
from verify.prover.outcome import Decision
from verify.prover.proof import LemmaStep, ObligationStep
from verify.views.words import headline
from verify.wire import judge, packaged
from verify.wire.packaged import PACKAGED, PACKAGED_FILES, packaged_files
from verify.wire.write import encode, write

ROOT = Path(__file__).resolve().parents[3]


def test_the_point_is_the_theorem_at_three_hundredths() -> None:
    point = STEP.context("parameters").point
    outcome = decide_point({n: point[n] for n in PARAMETERS}, "repaired")
    for name, meaning in citing.MEANING.items():
        low, high = outcome.enclosures[meaning.name].ends[0]
        assert low <= point[name].value <= high


def as_term_of(text: str) -> Any:
    return as_term(Fraction(text))


# --- what is refused -----------------------------------------------------------------------------


@pytest.mark.parametrize("context", ["parameters", "initial", "state", "plane"])
def test_without_a_given_the_step_is_refused(context: str) -> None:
    outcome = pages.decide("step")
    contexts = list(outcome.statement.contexts)
    index = [c.name for c in contexts].index(context)
    givens = contexts[index].givens
    for i in range(0, len(givens), 4):
        fewer = contexts[index]._replace(givens=givens[:i] + givens[i + 1 :])
        changed = (*contexts[:index], fewer, *contexts[index + 1 :])
        lie = outcome._replace(statement=outcome.statement._replace(contexts=changed))
        try:
            assert report(lie).verdict == "REFUSED", givens[i].name
        except check.Malformed:
            continue


# --- states --------------------------------------------------------------------------------------


def claims_in(*contexts: str) -> dict[str, Claim]:
    rows = {row.name: row for row in STEP.obligations}
    found = {
        given.name: given.claim
        for context in STEP.contexts
        if context.name in contexts
        for given in context.givens
    }
    for item in pages.decide("step").steps:
        if isinstance(item, LemmaStep) and item.context in contexts:
            found[item.name] = item.claim
        if isinstance(item, ObligationStep) and rows[item.name].context in contexts:
            claim = rows[item.name].claim
            if isinstance(claim, Claim):
                found[item.name] = claim
    return found


@pytest.mark.parametrize("dimension", [2, 3, 4])
def test_no_claim_is_violated_at_random_states(dimension: int) -> None:
    here = STEP.context("state")
    names = [*citing.MEANING, *following(), "t", "s"]
    claims = claims_in("parameters", "state", "before", "meanwhile")
    (time,) = (constant.term for constant in here.constants if constant.name == "tau")
    with balls.precision(BITS):
        draw, seen = Random(dimension, dimension), 0
        violated = checker([here], claims, names)
        for _ in range(100):
            values = draw.state()
            if values is None:
                continue
            tau = evaluate({"tau": time}, values)["tau"]
            values |= {"t": tau * draw.share(), "s": tau * draw.share()}
            assert violated(values) == []
            seen += 1
    assert seen > 80


@pytest.mark.parametrize("dimension", [2, 3])
def test_orbits_from_the_initial_set_satisfy_all_conditions(dimension: int) -> None:
    here = STEP.context("state")
    names = [*citing.MEANING, *following()]
    conditions = {given.name: given.claim for given in here.givens if given.kind == "carried"}
    with balls.precision(4 * BITS):
        draw = Random(7, dimension)
        starting = checker([], claims_in("initial"), [*names, *(f"{n}_start" for n in NAMES)])
        violated = checker([here], conditions, names)
        for _ in range(5):
            values = draw.start()
            assert values is not None
            assert starting(values) == []
            for _ in range(40):
                assert violated(values) == []
                values = next_state({n: values[n] for n in names})


def following() -> Mapping[str, Term]:
    """The next state, as the induction has it."""
    (always,) = (row.claim for row in STEP.obligations if isinstance(row.claim, Always))
    return always.next


def next_state(values: Values) -> Values:
    known = dict(values)
    for constant in STEP.context("state").constants:
        known |= evaluate({constant.name: constant.term}, known)
    return values | evaluate(following(), known)


# --- points that cite the step -------------------------------------------------------------------


@pytest.mark.parametrize("point", [("3/100", "1"), ("1/1000", "3/10"), ("1/1000000", "1/20")])
@pytest.mark.parametrize("selection", ["repaired", "all"])
def test_a_point_run_cites_the_step(point: tuple[str, str], selection: str) -> None:
    texts = dict(zip(("r", "c"), point, strict=True)) | {"V_0": "2", "delta_theta": "1/10"}
    outcome = decide_point({n: as_term_of(text) for n, text in texts.items()}, selection)
    files = write(outcome)
    cited = {name[6:-5]: data for name, data in files.items() if name.startswith("cited/")}
    found = check.check(files["statement.json"], files["certificate.json"], cited)
    assert found.verdict == "PROVED"
    assert found.cites[0][0] == "step"
    assert not any(row.uses for row, _ in outcome.rows if row.role == NEEDED)
    assert outcome.own_assumptions == ()
    assert outcome.assumptions == pages.decide("step").assumptions
    assert bool(outcome.printed_assumptions) == (selection == "all")
    assert headline(outcome) == PROVED


@pytest.mark.parametrize(("name", "page"), [("step", "step"), (ALL, "all_parameters")])
def test_what_comes_with_the_program_is_what_it_makes(name: str, page: str) -> None:
    """If not: verify certify, then python -m tests.bring."""
    files = write(pages.decide(page))
    for file in PACKAGED_FILES[name]:
        for folder in (Path(PACKAGED), ROOT / "certificates"):
            assert (folder / name / file).read_bytes() == files[file], folder
    assert packaged_files(name) == (files["statement.json"], files["certificate.json"])
    known = {
        sha256(packaged_files(cited)[0]).hexdigest(): packaged_files(cited)[0]
        for cited in PACKAGED_FILES
    }
    checked = judge.read_judged(*packaged_files(name), known).decisions
    for row, found in judge.packaged(name).decisions.items():
        assert (found.verdict, found.proof) == (checked[row].verdict, checked[row].proof), row
        assert found.judge in (None, judge.SHIPPED)


BOX = "theorem1 --r 0.02..0.03 --neg-cos 1"


@pytest.mark.usefixtures("a_new_process")
@pytest.mark.parametrize("name", ["statement.json", "certificate.json"])
@pytest.mark.parametrize(
    ("folder", "words"),
    [
        ("step", "theorem1 --r 0.03"),
        ("step", "theorem1 --r 0.02..0.04 --steps 2"),
        ("step", BOX),
        (ALL, BOX),
        (ALL, f"explain {ALL} collapse"),
        (ALL, "theorem1 --all"),
        ("flow", "explain flow contact"),
        ("spectrum", "spectrum"),
    ],
)
def test_nothing_is_proved_by_a_file_that_was_tampered_with(
    name: str,
    folder: str,
    words: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """What is not checked again in each run is compared, by the digests of both files."""
    shutil.copytree(PACKAGED, tmp_path, dirs_exist_ok=True)
    changed = tmp_path / folder / name
    changed.write_bytes(changed.read_bytes() + b" ")
    monkeypatch.setattr(packaged, "PACKAGED", str(tmp_path))
    assert main(words.replace("OUT", str(tmp_path)).split()) == 5
    found = capsys.readouterr()
    assert found.out == ""
    assert f"{name} is not the file that came with the program" in found.err


def test_every_given_is_a_row_a_definition_or_a_lemma_of_the_point() -> None:
    kinds = (citing.row_names(), citing.DEFINED, citing.BETWEEN)
    assert all(sum(name in kind for kind in kinds) == 1 for name in citing.GIVENS)
    assert len(citing.GIVENS) == sum(map(len, kinds))


def test_who_cites_the_step_takes_on_trust_what_its_page_does() -> None:
    assert citing.step_cited().trusted == STEP.assumptions


def test_the_givens_of_the_page_are_the_theorems_rows_word_for_word() -> None:
    here, parts = STEP.context(citing.CONTEXT), theorem().parts
    assert [variable.name for variable in here.variables] == list(citing.MEANING)
    assert list(here.claims) == list(citing.GIVENS)
    rows = {row.name: row.claim for part in parts.values() for row in part.obligations}
    shown = {name: rows[row] for name, row in citing.row_names().items()} | citing.BETWEEN
    for name, claim in shown.items():
        assert substitute_claim(here.claims[name], citing.MEANING) == claim, name
    for name, constant in citing.DEFINED.items():
        meant = substitute_claim(here.claims[name], citing.MEANING)
        assert (meant.relation, meant.lhs) == ("=", symbol(constant)), name


@pytest.mark.parametrize("name", ["zeta-total", "final-angle", "fixed-points-exist"])
@pytest.mark.parametrize("verdict", [UNDECIDED, REFUTED])
def test_the_step_does_not_apply_where_a_row_that_it_needs_is_not_proved(
    monkeypatch: pytest.MonkeyPatch, name: str, verdict: str
) -> None:
    """The row is undecided then, and so is the verdict, or it is refuted as that row is."""
    honest = Ground.decide

    def broken(ground: Ground, row: Obligation, *, all_sides: bool = True) -> Decision:
        found = honest(ground, row, all_sides=all_sides)
        return (
            found._replace(judged=found.judged._replace(verdict=verdict))
            if found.judged and row.name == f"repaired.{name}"
            else found
        )

    monkeypatch.setattr(Ground, "decide", broken)
    texts = {"r": "3/100", "c": "1", "V_0": "1", "delta_theta": "1/10"}
    outcome = decide_point({n: as_term_of(text) for n, text in texts.items()})
    assert outcome.decisions[citing.COLLAPSE] == Decision(UNDECIDED)
    assert (outcome.verdict, headline(outcome)) == (verdict, verdict)


def test_a_row_that_the_step_does_not_need_is_no_premise() -> None:
    """The final angle is within δ_θ by final-angle; that the drift is absorbed is not used."""
    assert "angle-absorbed" not in citing.row_names()
    assert "final-angle" in citing.row_names()


def test_a_point_where_the_hypotheses_fail_cites_nothing() -> None:
    texts = {"r": "1/2", "c": "1", "V_0": "1", "delta_theta": "1/10"}
    outcome = decide_point({n: as_term_of(text) for n, text in texts.items()})
    assert outcome.statement.cites == ()
    assert citing.COLLAPSE not in outcome.decisions


@pytest.mark.parametrize("point", [("3/100", "1"), ("1/1000", "3/10")])
def test_a_given_that_is_dropped_or_exchanged_is_refused(point: tuple[str, str]) -> None:
    texts = dict(zip(("r", "c"), point, strict=True)) | {"V_0": "1", "delta_theta": "1/10"}
    files = write(decide_point({n: as_term_of(text) for n, text in texts.items()}, "repaired"))
    cited = {name[6:-5]: data for name, data in files.items() if name.startswith("cited/")}
    certificate = json.loads(files["certificate.json"])
    (last,) = [s for s in certificate["steps"] if s.get("obligation") == citing.COLLAPSE]
    givens = last["proof"]["givens"]
    for changed in (givens[:-1], [*givens[1:], givens[0]], [*givens[:-1], "l.1"]):
        last["proof"]["givens"] = changed
        forged = encode(certificate)
        try:
            verdict = check.check(files["statement.json"], forged, cited).verdict
        except check.Malformed:
            continue
        assert verdict == "REFUSED"
