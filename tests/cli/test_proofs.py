"""The commands that show proofs: `theorem1 --all`, `explain`, `graph`."""

from __future__ import annotations

import json
import re
import shutil
from collections import defaultdict
from pathlib import Path
from xml.etree import ElementTree

import pytest

from verify import check
from verify.cli import main, proofs
from verify.cli.proofs import outcome_of
from verify.language.statement import UNDECIDED
from verify.paper.commands import index, pages, step
from verify.paper.source import PAPER
from verify.prover.outcome import CHECKER
from verify.prover.rules import RULES, Sum
from verify.prover.uses import nodes
from verify.views import graph as view
from verify.views.explain import explain
from verify.wire.judge import SHIPPED


@pytest.fixture(autouse=True)
def at_the_root(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(Path(__file__).resolve().parents[2])


def run(capsys: pytest.CaptureFixture[str], *words: object) -> tuple[int, str, str]:
    code = main([str(word) for word in words])
    captured = capsys.readouterr()
    return code, captured.out, captured.err


def test_all_parameters(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    code, out, err = run(capsys, "theorem1", "--all", "--out", tmp_path / "all")
    assert (code, err) == (0, "")
    assert "Theorem 1, given these sentences. Let 0 < r < 1" in out
    last = out.splitlines()[-1]
    assert last.startswith("Verdict: proved: For all 0 < r < 1")
    assert "given 9 assumptions" in last
    whole = " ".join(out.split())
    assert "δ_x = min(δ₁, δ₂, δ₃, δ₄, δ₅, V₀/V₁·(δ₂²·h₅/12))" in whole
    assert "0 < (-η_c), (-η_c) ≤ η̄, 0 < η_s, " in whole
    printed = whole.index("Theorem 1 as printed, misprint < in (4.10): refuted")
    assert printed < whole.index("Its set: ")
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


def test_the_printed_set_for_all_parameters(capsys: pytest.CaptureFixture[str]) -> None:
    code, out, err = run(capsys, "theorem1", "--all", "--constants", "printed")
    assert (code, err) == (1, "")
    breaking = out.partition("false, but harmless here, for all parameters:")[0]
    assert "  breaks the argument, for all parameters:" in breaking
    assert "zeta-x-bound " in breaking
    assert "set-interior " in breaking
    assert "15 refuted, 3 proved, but not by the printed argument, 10 remarks" in " ".join(
        out.split()
    )
    assert "  depends: y-term-3: fails at " in out
    assert "    it fails where φ⁺ ≥ 5/33 and " in out


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
    code, out, err = run(capsys, "theorem1", "--all", *words)
    assert (code, out, err.count("\n")) == (2, "", 1)


def test_explain(capsys: pytest.CaptureFixture[str]) -> None:
    code, out, err = run(capsys, "explain", "tau-positive")
    assert (code, err) == (0, "")
    assert "goal + [d-sum-positive]·[Cnd1]·[S-one] = 0" in out
    assert "  0 < τ" in out
    assert "tau-positive is written in verify/paper/step.toml:" in out
    code, out, err = run(capsys, "explain", "no-such-row")
    assert (code, out) == (2, "")
    assert "'no-such-row'" in err


def test_explain_says_by_which_rule_and_who_has_judged_it(
    capsys: pytest.CaptureFixture[str],
) -> None:
    code, out, err = run(capsys, "explain", "flow", "contact")
    assert (code, err) == (0, "")
    assert out.startswith("in flow: One collision of three inelastic hard spheres")
    assert f"  proved by the rule sum: what is written here is accepted by {SHIPPED}\n" in out
    assert "(2.2), EQUATSS2.1_Loi_de_Newton_: at the time y T" in out
    assert "  eps-is: ε = T·(1 + s)·λ²   (lemma)" in out
    code, out, _ = run(capsys, "explain", "certificates/examples/witness", "wrong")
    assert (
        "  refuted by the rule witness: the proof of the opposite is accepted by the checker" in out
    )
    assert ": x <= x^2" not in out  # a row without a label has none
    code, out, _ = run(capsys, "explain", "sharper", "(4.57)")
    assert re.search(r"proved tau-positive: .* \(by the rule sum\)", " ".join(out.split()))


def test_explain_shows_the_proof_at_the_point_that_is_asked_for(
    capsys: pytest.CaptureFixture[str],
) -> None:
    """The row of a point run, and not the one of the theorem for all parameters."""
    code, out, err = run(capsys, "explain", "--r", "0.03", "zeta-term-2")
    assert (code, err) == (0, "")
    assert " ".join(out.split()).startswith("in theorem1: Rows of THEORSS4.1ExistenCollapse, ")
    assert "at r = 3/100, " in " ".join(out.split())
    assert "left side 3.2663168…, right side 0.027768616…" in out
    assert "by the rule interval" in out
    assert "everywhere" not in out
    code, out, _ = run(capsys, "explain", "zeta-term-2")
    assert "in theorem1-all: " in out
    assert "verify explain --r 3/100 zeta-term-2" in out
    for words in (("--neg-cos", "1", "x"), ("--r", "0.03", "step", "x"), ("--r", "2", "x")):
        code, out, err = run(capsys, "explain", *words)
        assert (code, out, err.count("\n")) == (2, "", 1)


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
    code, out, err = run(capsys, "explain", folder, "means")
    assert (code, out, err.count("\n")) == (2, "", 1)

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
    assert made[0] == "proving flow"
    assert anew == [(code, out.replace(SHIPPED, CHECKER), err) for code, out, err in expected]


def test_a_formula_is_told_with_what_is_false_and_what_is_true(
    capsys: pytest.CaptureFixture[str],
) -> None:
    code, out, err = run(capsys, "explain", "4.47")
    text = " ".join(out.split())
    assert (code, err) == (0, "")
    assert text.startswith("(4.47), EQUATSS4.1Recurrence_Cnd4, at r = 0.03, ")
    assert "printed: 4 of 20 rows refuted; needed: 20 of 20 rows proved" in text
    assert "printed, and refuted (breaks the argument): zeta-term-2: " in text
    assert "3.2663168… ≤ 0.027768616…" in text
    assert "proved in its place: repaired.zeta-term-2: " in text
    assert "used by: " in text
    code, out, _ = run(capsys, "explain", "--r", "1/1000", "4.47")
    assert "at r = 0.001, " in " ".join(out.split())


@pytest.mark.parametrize("word", ["eta_bar", "η̄", "printed.eta_bar"])
def test_a_constant_is_told_as_printed_and_repaired(
    capsys: pytest.CaptureFixture[str], word: str
) -> None:
    code, out, err = run(capsys, "explain", word)
    text = " ".join(out.split())
    assert (code, err) == (0, "")
    assert "as printed: η̄ = 0.00018897450…" in text
    assert "η̄ = min(1, (√2 - 1)/16·(V₀/√V₁), V₀/(33·√V₁)·|Δθ|" in text
    assert ("repaired: η̄ = 5.2·10⁻⁷" in text) == (word != "printed.eta_bar")
    assert "used by the rows: eta_bar-positive, " in text


def test_a_constant_and_a_packaged_row_are_told_without_a_check(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """The judge of a point is FLINT; what comes with the program was checked before."""

    def never(*_: object) -> None:
        raise AssertionError("nothing is to be checked")

    monkeypatch.setattr("verify.check.check", never)
    for word, said in (("delta_1", "δ₁ = 0.19054199…"), ("ratio-falls", "before these files")):
        code, out, err = run(capsys, "explain", word)
        assert (code, err) == (0, "")
        assert said in " ".join(out.split())


def test_rows_are_found_by_the_number_of_their_formula(
    capsys: pytest.CaptureFixture[str],
) -> None:
    code, out, _ = run(capsys, "theorem1", "--r", "0.03", "--rows", "4.47")
    assert code == 0
    assert "[printed.zeta-term-2, (4.47), EQUATSS4.1Recurrence_Cnd4]" in " ".join(out.split())
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
    assert "repaired.CndT is written in verify/paper/recursion.py:" in out
    code, out, err = run(capsys, "explain", "tau-positiv")
    assert (code, out, err.count("\n")) == (2, "", 1)
    assert "is it tau-positive" in err


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
    for command in commands:
        code, text, err = run(capsys, *command.split()[1:])
        assert (code, err) == (0, "")
        assert " contact" in text


@pytest.mark.parametrize(
    ("words", "says"),
    [
        (("flow", "contact"), "at the time y T the spheres o and c are in"),
        (("sharper", "tau-positive"), "0 < τ"),
        (("step", "(4.57)"), "proved    tau-positive: "),
        (("printed", "printed.d-index"), "what is proved is the opposite: "),
        (("certificates/scenes/passing", "end.01"), "obligation end.01"),
        (("certificates/examples/mean", "means"), "obligation means"),
        (("certificates/theorem1-r-3-100", "x-term-1-d"), "obligation repaired.x-term-1-d"),
    ],
)
def test_explain_a_row_of_a_statement(
    words: tuple[str, str], says: str, capsys: pytest.CaptureFixture[str]
) -> None:
    code, out, err = run(capsys, "explain", *words)
    assert (code, err) == (0, "")
    assert says in out


@pytest.mark.parametrize(
    ("words", "says"),
    [
        (("flow", "contac"), "there is no row 'contac' in 'flow'; is it contact"),
        (
            ("flo", "contact"),
            "'flo' is no folder; name one with a certificate, or write one of",
        ),
        (("a", "b", "c"), "'c' is a word too many"),
        (("tests", "contact"), "statement.json"),
    ],
)
def test_unusable_places(
    words: tuple[str, ...], says: str, capsys: pytest.CaptureFixture[str]
) -> None:
    code, out, err = run(capsys, "explain", *words)
    assert (code, out, err.count("\n")) == (2, "", 1)
    assert says in err


#: Statements that are made, or read, in no time.
QUICK = ("flow", "sharper", "step-printed", "certificates/examples/induction-standing",
         "certificates/examples/cuts", "certificates/scenes/passing")  # fmt: skip


@pytest.mark.parametrize("where", QUICK)
def test_every_fact_can_be_explained_and_drawn(where: str) -> None:
    outcome = outcome_of(where)
    for name in [*nodes(outcome)][::5]:
        assert explain(outcome, name, PAPER), name
    assert all(explain(outcome, row.name, PAPER) for row, _ in outcome.rows)
    found = view.graph(outcome)
    names = {vertex.name for vertex in found.vertices}
    assert len(names) == len(found.vertices) > 1
    assert all(name in names for edge in found.edges for name in edge)
    ElementTree.fromstring(view.to_svg(found))


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
    assert "  undecided, so that there is no proof" in explain(changed, name, PAPER)


@pytest.mark.parametrize("ending", ["svg", "dot", "json"])
def test_graph(ending: str, capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    path = tmp_path / f"proof.{ending}"
    code, out, err = run(capsys, "graph", "--out", path)
    assert (code, err, out.startswith("written ")) == (0, "", True)
    text = path.read_text(encoding="utf-8")
    if ending == "svg":
        ElementTree.fromstring(text)
    if ending == "json":
        found = json.loads(text)
        names = {vertex["name"] for vertex in found["vertices"]}
        assert all(name in names for edge in found["edges"] for name in edge)


@pytest.mark.parametrize("words", [("--out", "x.pdf"), ("nowhere", "--out", "x.svg")])
def test_unusable_graphs(
    words: tuple[str, ...],
    capsys: pytest.CaptureFixture[str],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.chdir(tmp_path)
    code, out, err = run(capsys, "graph", *words)
    assert (code, out, err.count("\n")) == (2, "", 1)
    assert not list(tmp_path.iterdir())


def test_a_proof_uses_only_what_was_proved_before() -> None:
    for outcome in (step.decide_step(), pages.decide("all_parameters")):
        seen: set[str] = set()
        for node in nodes(outcome).values():
            unknown = [name for name in node.uses if name not in seen and ":" not in name]
            assert unknown == [] or node.kind == "given", (node.name, unknown)
            seen.add(node.name)
    found = view.graph(step.decide_step())
    assert {vertex.state for vertex in found.vertices} >= {"given", "proved", "assumed"}


@pytest.mark.parametrize("command", [["explain", "FOLDER", "means"], ["graph", "FOLDER"]])
def test_nothing_is_shown_of_a_folder_whose_cited_certificate_is_refused(
    command: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
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
    words = [str(folder) if word == "FOLDER" else word for word in command]
    out = ["--out", str(tmp_path / "graph.json")] if command[0] == "graph" else []
    code, text, complaint = run(capsys, *words, *out)
    assert (code, text) == (2, "")
    assert "verify/check.py refuses the certificate" in complaint
