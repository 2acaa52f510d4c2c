"""The commands that show proofs: `theorem1 --all`, `explain`."""

from __future__ import annotations

import json
import shutil
from collections import defaultdict
from pathlib import Path

import pytest

from tests.cli.running import check_refused, command
from verify import check
from verify.cli import proofs
from verify.cli.proofs import outcome_of
from verify.language.statement import UNDECIDED
from verify.paper.commands import index, pages
from verify.paper.source import PAPER
from verify.prover.outcome import CHECKER
from verify.prover.rules import RULES, Sum
from verify.prover.uses import nodes
from verify.views.explain import explain
from verify.wire.judge import SHIPPED


@pytest.fixture(autouse=True)
def at_the_root(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(Path(__file__).resolve().parents[2])


run = command()


def test_all_parameters(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    code, _, err = run(capsys, "theorem1", "--all", "--out", tmp_path / "all")
    assert (code, err) == (0, "")
    cited, proof = sorted((tmp_path / "all/cited").iterdir(), reverse=True)
    assert proof.name == f"{cited.stem}.certificate.json"
    step_folder = tmp_path / "step"
    step_folder.mkdir()
    assert run(capsys, "check", tmp_path / "all")[0] == 0
    code, out, _ = run(capsys, "theorem1", "--all", "--json")
    document = json.loads(out)
    assert (code, document["verdict"], len(document["assumptions"])) == (0, "proved", 9)
    assert {row["verdict"] for row in document["claims"]} == {"proved"}
    assert len(cited.read_bytes()) < check.MAX_BYTES


@pytest.mark.parametrize(
    "words",
    [
        ("--r", "0.03"),
        ("--steps", "3"),
        ("--neg-cos", "1"),
        ("--V0", "2"),
        ("--precision", "abc"),
        ("--constants", "none"),
    ],
)
def test_all_takes_no_values(words: tuple[str, ...], capsys: pytest.CaptureFixture[str]) -> None:
    check_refused(run(capsys, "theorem1", "--all", *words))


def test_explain_takes_a_point_or_a_place(capsys: pytest.CaptureFixture[str]) -> None:
    for words in (("--neg-cos", "1", "x"), ("--r", "0.03", "step", "x"), ("--r", "2", "x")):
        check_refused(run(capsys, "explain", *words))


def test_explain_says_nothing_that_the_checker_does_not_accept(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    folder = tmp_path / "mean"
    shutil.copytree("certificates/examples/mean", folder)
    assert run(capsys, "explain", folder, "means")[0] == 0
    path = folder / "certificate.json"
    document = json.loads(path.read_text(encoding="utf-8"))
    document["steps"][-1]["proof"]["addends"][1][1] = "1/5"
    path.write_text(json.dumps(document), encoding="utf-8")
    check_refused(run(capsys, "explain", folder, "means"))

    rows = defaultdict[str, str](lambda: "refused")

    def refuses(*_: object) -> check.Report:
        return check.Report("REFUSED", ["REFUSED all"], "none", "", rows=rows)

    monkeypatch.setattr(check, "check", refuses)
    for words, expected in (
        (("--r", "0.03", "zeta-term-2"), 5), (("certificates/examples/mean", "means"), 2),
    ):  # fmt: skip
        code, out, err = run(capsys, "explain", *words)
        assert (code, out, err.count("\n")) == (expected, "", 1)


def test_explain_proves_nothing_anew_unless_the_paper_has_changed(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """The same lines both ways: from what comes with the program, and made anew."""
    words = ("explain", "flow", "contact"), ("explain", "gap-positive")
    expected = [run(capsys, *command) for command in words]
    assert [code for code, *_ in expected] == [0, 0]
    made: list[str] = []
    monkeypatch.setattr(proofs, "progress", made.append)
    assert [run(capsys, *command) for command in words] == expected
    assert made == []
    monkeypatch.setattr(index, "sources", lambda: "of another paper")
    index.lines.cache_clear()
    try:
        anew = [run(capsys, *command) for command in words]
    finally:
        index.lines.cache_clear()
    assert made[0] == "proving flow …"
    assert anew == [(code, out.replace(SHIPPED, CHECKER), err) for code, out, err in expected]


def test_a_constant_has_a_name_and_a_letter(capsys: pytest.CaptureFixture[str]) -> None:
    by_name, by_letter, printed = (run(capsys, "explain", word)
                                   for word in ("eta_bar", "η̄", "printed.eta_bar"))  # fmt: skip
    assert by_letter == (0, by_name[1].replace(" eta_bar\n", " η̄\n"), "")
    assert (printed[0], printed[2]) == (0, "")
    assert printed[1] != by_name[1]


def test_a_constant_and_a_packaged_row_are_told_without_a_check(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """The judge of a point is FLINT; what comes with the program was checked before."""

    def never(*_: object) -> None:
        raise AssertionError("nothing is to be checked")

    monkeypatch.setattr("verify.check.check", never)
    for word in ("delta_1", "ratio-falls"):
        code, _, err = run(capsys, "explain", word)
        assert (code, err) == (0, "")


def test_rows_are_found_by_the_number_of_their_formula(
    capsys: pytest.CaptureFixture[str],
) -> None:
    code, out, _ = run(capsys, "theorem1", "--r", "0.03", "--rows", "4.47")
    assert code == 0
    assert run(capsys, "theorem1", "--r", "0.03", "--rows", "(4.47)")[1] == out
    assert run(capsys, "theorem1", "--r", "0.03", "--rows", "4.470")[0] == 2


def test_explain_finds_labels_and_near_names(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    def never(*_: object) -> None:
        raise AssertionError("nothing is to be decided")

    monkeypatch.setattr("verify.cli.explain.outcome_of", never)
    monkeypatch.setattr("verify.cli.explain._statements_with", lambda *_: [])
    code, out, err = run(capsys, "explain", "-v", "EQUATSS4.1Recurrence_CndT")
    assert (code, err) == (0, "")
    assert "repaired.CndT is written in verify/paper/theorem1.toml:" in out
    check_refused(run(capsys, "explain", "tau-positiv"), "is it tau-positive")


@pytest.mark.parametrize("row", ["matrix-stated", "printed.d-index", "repaired.delta_x", "l.1"])
def test_explain_looks_in_every_statement(capsys: pytest.CaptureFixture[str], row: str) -> None:
    code, out, err = run(capsys, "explain", row)
    assert (code, err) == (0, "")
    assert f" {row}" in out


def test_explain_lists_the_statements_that_have_a_name(capsys: pytest.CaptureFixture[str]) -> None:
    """The first one that has it as a row is explained, and the others are commands."""
    code, out, err = run(capsys, "explain", "contact")
    assert (code, err) == (0, "")
    assert "(4.57)" in out
    commands = [line for line in out.splitlines() if line.startswith("  verify explain ")]
    assert "  verify explain flow contact" in commands
    for written in commands:
        code, text, err = run(capsys, *written.split()[1:])
        assert (code, err) == (0, "")
        assert " contact" in text


#: Statements that are made, or read, in no time.
QUICK = ("flow", "sharper", "step-printed", "certificates/examples/induction-standing",
         "certificates/examples/cuts", "certificates/scenes/passing")  # fmt: skip


@pytest.mark.parametrize("where", QUICK)
def test_every_fact_can_be_explained(where: str) -> None:
    outcome = outcome_of(where)
    for name in [*nodes(outcome)][::5]:
        assert explain(outcome, name, PAPER), name
    assert all(explain(outcome, row.name, PAPER) for row, _ in outcome.rows)


@pytest.mark.parametrize("proofs", RULES)
def test_a_proof_by_each_rule_is_told_in_words(proofs: type[object]) -> None:
    rule = RULES[proofs]
    told = "identically" if proofs is Sum else rule.says.partition("{")[0].partition("\n")[0]
    outcomes = [outcome_of(f"certificates/examples/{name}") for name in rule.examples]
    pages = [explain(outcome, name, PAPER) for outcome in outcomes for name in nodes(outcome)]
    assert any(told in line for page in pages for line in page)
    cites = any(outcome.statement.cites for outcome in outcomes)
    assert cites or not any("a fact of a cited" in line for page in pages for line in page)


def test_a_row_that_is_left_open_has_no_proof() -> None:
    outcome = outcome_of("certificates/examples/mean")
    (name, *_) = outcome.decisions
    open_row = outcome.decisions[name]._replace(claimed=UNDECIDED, judged=None)
    changed = outcome._replace(
        decisions={**outcome.decisions, name: open_row},
        steps=tuple(s for s in outcome.steps if getattr(s, "name", "") != name),
    )
    first, *_, said, _ = explain(changed, name, PAPER)
    assert (first, said) == (f"undecided: obligation {name}", "  there is no proof")


def test_a_proof_uses_only_what_was_proved_before() -> None:
    for outcome in (pages.decide("step"), pages.decide("all_parameters")):
        seen: set[str] = set()
        for node in nodes(outcome).values():
            unknown = [name for name in node.uses if name not in seen and ":" not in name]
            assert unknown == [] or node.kind == "given", (node.name, unknown)
            seen.add(node.name)


def test_nothing_is_shown_of_a_folder_whose_cited_certificate_is_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """`verify check` refuses such a folder, so no other command calls its rows proved."""
    folder = tmp_path / "mean-applied"
    shutil.copytree("certificates/examples/mean-applied", folder)
    path = folder / "cited/mean.certificate.json"
    proofs = json.loads(path.read_text())
    for proof in (item["proof"] for item in proofs["steps"] if "proof" in item):
        proof["addends"] = ["goal"]
    path.write_text(json.dumps(proofs))
    assert run(capsys, "check", folder)[0] == 1
    code, text, complaint = run(capsys, "explain", folder, "means")
    assert (code, text) == (2, "")
    assert "verify/check.py refuses the certificate" in complaint


@pytest.mark.parametrize("word", ["\udcff", "x\udc80y"])
def test_a_word_that_is_no_text(word: str, capsys: pytest.CaptureFixture[str]) -> None:
    code, out, err = run(capsys, "explain", word)
    assert (code, out, err.count("\n")) == (2, "", 1)
