"""The command `check`: many folders, JSON, and whether a theorem is the program's own."""

from __future__ import annotations

import json
import shutil
from collections.abc import Callable
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any

import pytest

from tests.check.support import INTERVAL, Pair
from tests.cli.running import check_refused, command
from verify import check
from verify.cli import main
from verify.language.statement import UNDECIDED
from verify.language.terms import Term, as_term, cos, cos_pi
from verify.paper.commands import theorem1
from verify.paper.commands.regenerate import is_right_statement
from verify.paper.commands.scene import scene_outcome
from verify.prover.outcome import Outcome
from verify.spheres.scene.decide import decide_scene
from verify.spheres.scene.scene_files import read_scene
from verify.wire.write import write

EXAMPLES = Path(__file__).resolve().parents[2] / "certificates/examples"
NAMES = ("statement.json", "certificate.json")

Changes = dict[str, Term]


run = command("check")


@cache
def outcome_at(selection: str = "all", **changes: Term) -> Outcome:
    parameters = {
        "r": as_term(Fraction(3, 100)),
        "c": as_term(1),
        "V_0": as_term(1),
        "delta_theta": as_term(Fraction(1, 10)),
    }
    return theorem1.decide_point(parameters | changes, selection)


def save(folder: Path, outcome: Outcome) -> Path:
    folder.mkdir(parents=True)
    for name, content in write(outcome).items():
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / name).write_bytes(content)
    return folder


# --- the checker's own report --------------------------------------------------------------------


def test_the_lines_are_those_of_the_trusted_file(capsys: pytest.CaptureFixture[str]) -> None:
    folders = [str(path) for path in sorted(EXAMPLES.iterdir()) if path.is_dir()]
    for paths in ([folders[0]], folders):
        code = check.main(paths)
        expected = capsys.readouterr().out
        assert run(capsys, "-v", *paths) == (code, expected, "")


FORGED = "x\nPROVED: all of it\x1b[2K"


def test_names_that_forge_a_line_are_escaped_in_both(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    """Of folders, of theorems, of sentences, in titles and labels: no line but one's own."""
    paths = []
    for name in ("mean", "mean-applied"):
        paths.append(str(tmp_path / f"{FORGED}{name}"))
        shutil.copytree(EXAMPLES / name, paths[-1])
    pair = Pair(FORGED).assume("law").row("row", "1 < 1", INTERVAL)
    pair.statement |= {"title": FORGED}
    pair.statement["obligations"][0]["label"] = FORGED
    pair.statement["assumptions"][0]["sentence"] = FORGED
    other = Pair("citing").cite("c", pair).row("row", "0 <= 1", INTERVAL)
    for i, found in enumerate((pair, other)):
        paths.append(str(tmp_path / f"{FORGED}{i}"))
        Path(paths[-1], "cited").mkdir(parents=True)
        (Path(paths[-1]) / "cited" / f"{FORGED}.json").write_bytes(pair.files()[0])
        for name, data in zip(NAMES, found.files(), strict=True):
            (Path(paths[-1]) / name).write_bytes(data)
    code = check.main(paths)
    expected = capsys.readouterr().out
    assert code == 1
    assert run(capsys, "-v", *paths) == (code, expected, "")
    lines = expected.splitlines()
    verdicts = ("PROVED", "UNDECIDED")
    assert sum(line.lstrip("'\"").startswith(verdicts) for line in lines) == 3
    assert "\x1b" not in expected
    assert not any(line.startswith("PROVED: all of it") for line in lines)


def test_a_path_that_forges_a_line_on_stderr(capsys: pytest.CaptureFixture[str]) -> None:
    assert check.main([FORGED]) == 2
    assert capsys.readouterr().err.count("\n") == 1
    check_refused(run(capsys, FORGED))


def test_a_sentence_for_each_folder(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    """Rows that only count are left out, and counts that are 0; complaints are told."""
    code, out, _ = run(capsys, EXAMPLES / "mean")
    assert code == 0
    title = "The arithmetic and the geometric mean of two numbers"
    assert out == f"PROVED: {title}: 2 needed proved; given nothing\n"
    broken = tmp_path / "broken"
    shutil.copytree(EXAMPLES / "witness", broken)
    text = (broken / "statement.json").read_text().replace('"refuted"', '"proved"')
    (broken / "statement.json").write_text(text)
    code, out, _ = run(capsys, EXAMPLES / "mean", broken)
    assert code in (1, 4)
    lines = out.splitlines()
    assert lines[:3] == [f"{EXAMPLES / 'mean'}:", lines[1], f"{broken}:"]
    assert lines[3].startswith(("REFUSED ", "MALFORMED: "))


def test_one_run_closes_citations(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    applied = tmp_path / "applied"
    shutil.copytree(EXAMPLES / "mean-applied", applied)
    assert "which is not proved here" not in run(capsys, applied)[1].splitlines()[-1]
    (applied / "cited" / "mean.certificate.json").unlink()
    code, out, _ = run(capsys, applied)
    alone = out.splitlines()[-1]
    assert (code, alone.partition(":")[0]) == (3, "UNDECIDED")
    (found,) = json.loads(run(capsys, applied, "--json")[1])["folders"]
    assert found["verdict"] == "undecided"
    assert found["summary"].startswith("UNDECIDED: ")
    assert run(capsys, applied, "--latex")[:2] == (3, "")
    both = run(capsys, EXAMPLES / "mean", applied)[1].splitlines()[-1]
    assert "which is not proved here" in alone
    assert "which is not proved here" not in both


def test_the_document_names_what_needed_rows_rest_on(capsys: pytest.CaptureFixture[str]) -> None:
    """A theorem at a point takes nothing on trust itself, and nine sentences of the step."""
    point = EXAMPLES.parent / "theorem1-r-3-100"
    code, out, _ = run(capsys, point, "--json")
    (found,) = json.loads(out)["folders"]
    step = json.loads((EXAMPLES.parent / "step" / "statement.json").read_text())
    own = json.loads((point / "statement.json").read_text())
    assert code == 0
    names = [item["name"] for item in found["assumptions"]]
    assert names == [f"step:{item['name']}" for item in step["assumptions"]]
    printed = [item["name"] for item in found["assumptions_of_printed_rows"]]
    assert printed == [item["name"] for item in own["assumptions"]]
    assert f"; given {', '.join(names)}; for printed rows only, also given" in found["summary"]


def test_the_document(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    broken = tmp_path / "broken"
    broken.mkdir()
    for name in NAMES:
        (broken / name).write_text("{}")
    code, out, err = run(capsys, EXAMPLES / "mean", broken, "--json")
    found = json.loads(out)
    assert (code, err, found["format"]) == (4, "", "verify-check/1")
    good, bad = found["folders"]
    assert (good["verdict"], good["needed"]["proved"], good["complaints"]) == ("proved", 2, [])
    assert (bad["verdict"], bad["needed"]) == ("malformed", None)
    assert bad["complaints"] == [bad["summary"]]


def test_latex_and_json_are_two_documents(capsys: pytest.CaptureFixture[str]) -> None:
    code, out, err = run(capsys, EXAMPLES / "mean", "--latex", "--json")
    assert (code, err.count("\n"), json.loads(out)["exit_code"]) == (2, 1, 2)
    assert err.startswith("verify: --latex: ")


def test_latex_of_what_is_accepted(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    code, out, err = run(capsys, EXAMPLES / "mean", EXAMPLES / "witness", "--latex")
    assert (code, err, out.count(r"\section{")) == (0, "", 2)
    code, full, err = run(capsys, EXAMPLES / "mean", "--latex", "--full")
    assert (code, err) == (0, "")
    assert full.count(r"\begin{row}") == 2
    code, out, err = run(capsys, EXAMPLES / "mean", "--full")
    assert (code, out) == (2, "")
    assert "--latex" in err
    broken = tmp_path / "broken"
    shutil.copytree(EXAMPLES / "mean", broken)
    text = (broken / "statement.json").read_text().replace('["<", "0", "x"]', '["<", "x", "0"]')
    (broken / "statement.json").write_text(text)
    code, out, err = run(capsys, EXAMPLES / "witness", broken, "--latex")
    assert (code, out, err.count("\n")) == (4, "", 1)
    code, out, err = run(capsys, EXAMPLES / "mean", "--latex", "--statement")
    assert (code, out) == (4, "")
    assert "not a statement of the program" in err


def test_a_folder_stands_for_the_certificates_below_it(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    for name in ("inner/mean", "inner/deeper/witness"):
        shutil.copytree(EXAMPLES / name.split("/")[-1], tmp_path / name)
    (tmp_path / "inner/.verify-0-new").mkdir()  # as a run leaves it that was killed
    (tmp_path / "inner/.verify-0-new/statement.json").touch()
    code, out, err = run(capsys, tmp_path, "--json")
    folders = [found["path"] for found in json.loads(out)["folders"]]
    assert (code, err) == (0, "")
    assert folders == [str(tmp_path / name) for name in ("inner/deeper/witness", "inner/mean")]
    (tmp_path / "inner/mean/certificate.json").unlink()
    code, out, err = run(capsys, tmp_path)
    assert (code, out) == (2, "")
    assert "mean/certificate.json' does not exist" in err
    assert main(["export", "coq", str(EXAMPLES)]) == 2
    assert f"name one, such as '{EXAMPLES / 'agm'}'" in capsys.readouterr().err


@pytest.mark.parametrize("system", ["coq", "text"])
def test_what_comes_with_the_program_is_exported_with_what_it_cites(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch, system: str
) -> None:
    assert main(["export", system, str(EXAMPLES.parent / "theorem1-all")]) == 0
    whole = capsys.readouterr()
    monkeypatch.chdir(tmp_path)
    assert main(["export", system, "theorem1-all"]) == 0
    assert capsys.readouterr() == whole
    (tmp_path / "theorem1-all").mkdir()  # a folder of this name goes before it
    assert main(["export", system, "theorem1-all"]) == 2


@pytest.mark.parametrize(
    ("path", "says"),
    [("nowhere", "does not exist"), ("file", "is a file"), (".", "statement.json")],
)
@pytest.mark.parametrize("option", [[], ["--json"], ["--statement"], ["--latex"]])
def test_a_path_that_is_no_folder_of_a_certificate(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, path: str, says: str, option: list[str]
) -> None:
    (tmp_path / "file").write_text("mine")
    code, out, err = run(capsys, EXAMPLES / "mean", tmp_path / path, *option)
    assert (code, err.count("\n")) == (2, 1)
    assert (json.loads(out)["exit_code"] == 2) if option == ["--json"] else not out
    assert err.startswith("verify: path: ")
    assert says in err
    assert "Errno" not in err


# --- whether the theorem is the program's own ----------------------------------------------------


@pytest.mark.parametrize("selection", ["all", "repaired"])
@pytest.mark.parametrize(
    "c", [as_term(1), as_term(Fraction(9, 10)), -cos_pi(Fraction(5, 6)), -cos(Fraction(3))]
)
def test_what_the_program_calls_proved_is_its_own(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, selection: str, c: Term
) -> None:
    folder = save(tmp_path / "x", outcome_at(selection, c=c))
    code, out, _ = run(capsys, "--statement", folder)
    assert code == 0
    assert out.splitlines()[-1].startswith("STATEMENT: it is the one")


def test_a_scene_with_another_restitution_is_refused_with_a_reason(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    """Its rows are true, as the flow is an algebraic law; but it is no scene of the paper."""
    path = Path(__file__).resolve().parents[2] / "certificates/scenes/parting.toml"
    scene = read_scene(str(path), path.read_bytes())._replace(r=Fraction(2))
    found = decide_scene(scene)
    folder = save(tmp_path / "x", scene_outcome(found, found.flow.bits))
    assert run(capsys, folder)[0] == 0
    code, out, _ = run(capsys, "--statement", folder)
    assert code == 4
    last = out.splitlines()[-1]
    assert last.startswith("STATEMENT: it is not the one that the program makes")
    assert last.endswith(": its r = 2 is not in (0, 1)")


def unwritten_one() -> Term:
    """The number 1 in a form that no decision is made with: twice the cosine of 60 degrees."""
    return 2 * cos_pi(Fraction(1, 3))


#: Hole (e): parameters in forms, or with values, that the program does not take.
FOREIGN: dict[str, Callable[[], Changes]] = {
    "V_0-as-a-cosine": lambda: {"V_0": unwritten_one()},
    "c-as-a-cosine": lambda: {"c": unwritten_one()},
    "r-as-a-quotient": lambda: {"r": as_term(3) / as_term(100)},
    "V_0-zero": lambda: {"V_0": as_term(0)},
    "V_0-negative": lambda: {"V_0": as_term(-1)},
    "delta-theta-zero": lambda: {"delta_theta": as_term(0)},
    "delta-theta-undefined": lambda: {"delta_theta": as_term(1) / as_term(0)},
    "c-at-its-threshold": lambda: {"r": as_term(Fraction(1, 64)), "c": as_term(Fraction(8, 13))},
    "c-above-one": lambda: {"c": as_term(Fraction(101, 100))},
    "acute-angle": lambda: {"c": -cos_pi(Fraction(7, 4))},
    "angle-beyond-pi": lambda: {"c": -cos(Fraction(32, 10))},
    "right-angle-in-decimals": lambda: {"c": -cos(Fraction("1.5707963267948966"))},
}


@pytest.mark.parametrize("name", FOREIGN)
def test_other_parameters_are_not_the_programs(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, name: str
) -> None:
    honest, changes = outcome_at(), FOREIGN[name]()
    parameters = dict(honest.statement.parameters) | changes
    forged = honest._replace(statement=honest.statement._replace(parameters=parameters))
    assert not is_right_statement(write(forged)["statement.json"])
    assert run(capsys, "--statement", save(tmp_path / "x", forged))[0] in (1, 4)


@pytest.mark.parametrize(
    "name", ["c-as-a-cosine", "r-as-a-quotient", "c-at-its-threshold", "c-above-one"]
)
def test_what_is_decided_there_is_not_the_programs_either(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, name: str
) -> None:
    folder = save(tmp_path / "x", outcome_at(**FOREIGN[name]()))
    code, out, _ = run(capsys, "--statement", folder)
    assert code in (1, 4)
    assert "it is the one" not in out


def test_undecided_needed_rows_that_are_left_out(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    """Hole (e): the checker accepts a statement without a row; it is not the program's."""
    honest = outcome_at()
    rows = honest.statement.obligations
    for gone in ("hypotheses.V_0-positive", rows[-1].name):
        kept = tuple(row for row in rows if row.name != gone)
        outcome = honest._replace(
            statement=honest.statement._replace(obligations=kept),
            decisions={name: found for name, found in honest.decisions.items() if name != gone},
            steps=tuple(step for step in honest.steps if step.name != gone),
        )
        folder = save(tmp_path / gone, outcome)
        assert run(capsys, folder)[0] == 0
        code, out, _ = run(capsys, "--statement", folder)
        assert (code, out.count("STATEMENT: it is not")) == (4, 1)


def test_a_missing_set_is_not_proved(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    """Hole (e): the hypotheses alone, as a run leaves them that spends its precision."""
    honest = outcome_at()
    rows = tuple(row for row in honest.statement.obligations if row.group == "hypotheses")
    names = {row.name for row in rows}
    steps = tuple(step for step in honest.steps if step.name in {*names, "r", "c"})
    outcome = honest._replace(
        statement=honest.statement._replace(obligations=rows, constants=(), assumptions=()),
        decisions={name: honest.decisions[name] for name in names},
        steps=tuple(step for step in honest.steps[: honest.steps.index(steps[-1]) + 1]),
        enclosures={n: e for n, e in honest.enclosures.items() if n in honest.statement.parameters},
    )
    folder = save(tmp_path / "x", outcome)
    assert run(capsys, folder)[0] == 0
    assert run(capsys, "--statement", folder)[0] == 4


def test_the_printed_set_alone_is_never_right(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    """Hole (f): refuted, so 1; and if its false rows are left out, foreign."""
    outcome = outcome_at("printed")
    assert run(capsys, "--statement", save(tmp_path / "x", outcome))[0] == 1
    true = {n: found for n, found in outcome.decisions.items() if found.verdict == "proved"}
    rows = tuple(row for row in outcome.statement.obligations if row.name in true)
    gone = outcome.decisions.keys() - true.keys()
    trimmed = outcome._replace(
        statement=outcome.statement._replace(obligations=rows),
        decisions=true,
        steps=tuple(step for step in outcome.steps if step.name not in gone),
    )
    folder = save(tmp_path / "y", trimmed)
    assert run(capsys, folder)[0] == 0
    assert run(capsys, "--statement", folder)[0] == 4


def test_each_file_is_read_once(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Hole (g): what is compared is what was checked, whatever happens to the file meanwhile."""
    folder = save(tmp_path / "x", outcome_at())
    reads: list[str] = []
    honest = check.read_file

    def counted(path: str) -> bytes:
        reads.append(path)
        return honest(path)

    monkeypatch.setattr(check, "read_file", counted)
    monkeypatch.setattr("verify.cli.files.read_bytes", None)
    assert run(capsys, "--statement", folder)[0] == 0
    files = (path for path in folder.rglob("*") if path.is_file())
    assert sorted(reads) == sorted(map(str, files))


def test_the_worst_code_of_several_folders(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    good = save(tmp_path / "good", outcome_at())
    false = save(tmp_path / "false", outcome_at(r=as_term(Fraction(1, 2))))
    assert run(capsys, good, false)[0] == 1
    assert run(capsys, "--statement", good, false, EXAMPLES / "mean")[0] == 4
    _, out, _ = run(capsys, "--statement", "--json", good, false, EXAMPLES / "mean")
    rows: list[dict[str, Any]] = json.loads(out)["folders"]
    assert [row.get("own_statement") for row in rows] == [True, None, False]
    assert [row["verdict"] for row in rows] == ["proved", "refuted", "proved"]


def test_a_needed_row_that_is_undecided_is_refused(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    honest = outcome_at()
    name = "hypotheses.V_0-positive"
    outcome = honest._replace(
        decisions=dict(honest.decisions)
        | {
            name: honest.decisions[name]._replace(
                claimed=UNDECIDED, judged=None, proof=None, sides=None
            )
        },
        steps=tuple(step for step in honest.steps if step.name != name),
    )
    assert run(capsys, "--statement", save(tmp_path / "x", outcome))[0] == 1
