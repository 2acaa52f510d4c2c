"""`verify prove`: what it prints and writes, its exit codes, and what it says of unusable files."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from verify import check
from verify.cli import files, main
from verify.language.terms import Claim
from verify.paper.source import PAPER
from verify.prover import prove as search
from verify.prover.budget import SpentError, WorkBudget
from verify.prover.rows_in_contexts import RowsInContexts
from verify.wire import questions as job

EXAMPLES = Path(__file__).resolve().parents[2] / "certificates/examples"


def example(name: str) -> dict[str, Any]:
    content = (EXAMPLES / name / "statement.json").read_text(encoding="utf-8")
    found: dict[str, Any] = json.loads(content)
    for row in found["obligations"]:
        row["verdict"] = "undecided"
    return found


def written(tmp_path: Path, document: Any) -> str:
    path = tmp_path / "question.json"
    text = document if isinstance(document, str) else json.dumps(document)
    path.write_text(text, encoding="utf-8")
    return str(path)


def test_a_proved_statement(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = tmp_path / "out"
    assert main(["prove", written(tmp_path, example("instance")), "--out", str(out)]) == 0
    assert check.check_folders(check.read_folders([str(out)]))[0] == 0


def test_a_refuted_statement_has_its_witness(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    document = example("instance")
    document["obligations"][0]["claim"][1] = "3"
    out = tmp_path / "out"
    assert main(["prove", written(tmp_path, document), "--out", str(out)]) == 1
    assert "false at x = " in capsys.readouterr().out
    folders = check.read_folders([str(out)])
    code, lines = check.check_folders(folders)
    assert code == 1
    assert lines[-1].startswith("REFUTED")
    rows = json.loads(folders[0].statement)["obligations"]
    assert [row["verdict"] for row in rows] == ["refuted", "proved"]


def test_what_is_proved_is_written_beside_an_undecided_row(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    document, out = example("instance"), tmp_path / "other"
    document["obligations"][0]["claim"] = ["<=", "0", ["sqrt", ["sub", "x", "1"]]]
    assert main(["prove", written(tmp_path, document), "--out", str(out)]) == 3
    captured = capsys.readouterr()
    assert captured.out.startswith("undecided two")
    assert "the row two stands there as printed and undecided" in captured.err
    code, lines = check.check_folders(check.read_folders([str(out)]))
    assert code == 0
    assert "1 needed proved, 0 printed proved" in lines[-1]
    assert "1 printed undecided" in lines[-1]


def test_nothing_is_written_where_nothing_is_decided(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    document, out = with_rows(["<=", "0", ["sqrt", ["sub", "x", "1"]]]), tmp_path / "other"
    assert main(["prove", written(tmp_path, document), "--out", str(out)]) == 3
    assert "no needed row is decided; no certificate was written" in capsys.readouterr().err
    assert not out.exists()


def test_what_the_checker_refuses_is_not_called_proved(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    search = job.prove

    def too_strict(*arguments: Any, **options: Any) -> Any:
        outcome = search(*arguments, **options)
        claims = [(r, Claim("<", r.claim.rhs, r.claim.rhs)) for r, _ in outcome.rows]
        rows = [row._replace(claim=claim) for row, claim in claims]
        return outcome._replace(statement=outcome.statement._replace(obligations=tuple(rows)))

    monkeypatch.setattr(job, "prove", too_strict)
    assert main(["prove", written(tmp_path, example("instance"))]) == 5
    captured = capsys.readouterr()
    assert captured.out == ""
    assert "row two: REFUSED" in captured.err


def test_time_only_leaves_rows_undecided(tmp_path: Path) -> None:
    path = written(tmp_path, example("instance"))
    assert main(["prove", path, "--time", "1e-9"]) == 3
    assert main(["prove", path, "--time", "60"]) == 0


def test_the_time_to_read_a_file_counts(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    now = [0.0]
    monkeypatch.setattr("verify.prover.budget.monotonic", lambda: now[0])
    read = job.read_page_of

    def slowly(*words: Any) -> Any:
        now[0] += 5
        return read(*words)

    monkeypatch.setattr("verify.cli.prove.read_page_of", slowly)
    path = written(tmp_path, example("instance"))
    assert main(["prove", path, "--time", "4"]) == 3
    assert main(["prove", path, "--time", "60"]) == 0


@pytest.mark.parametrize("name", [b"\xff", "a\n\x1b[2J\u202e".encode()])
def test_a_file_whose_name_cannot_be_printed(
    name: bytes, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    texts = {
        ".smt2": "(declare-fun x () Real)(assert (< (* x x) 0))(check-sat)",
        ".fpcore": "(FPCore (x) :pre (<= 0 x 1) (* x x))",
    }
    for end, text in texts.items():
        path = tmp_path / os.fsdecode(name + end.encode())
        path.write_text(text)
        assert main(["prove", str(path), "--out", str(tmp_path / "out" / end)]) == 0
        last = json.loads((tmp_path / "out" / end / "statement.json").read_bytes())
        assert last["title"].isprintable()


def test_a_row_takes_its_share_of_the_time_only(monkeypatch: pytest.MonkeyPatch) -> None:
    now = [0.0]
    monkeypatch.setattr("verify.prover.budget.monotonic", lambda: now[0])
    budget = WorkBudget(seconds=30)
    for row, (takes, enough) in enumerate([(9, True), (11, False), (9.5, True)]):
        budget.begin("row", 3 - row)
        now[0] += takes
        if enough:
            budget.spend(1)
        else:
            with pytest.raises(SpentError, match="share of the time"):
                budget.spend(1)


def test_some_rows_are_decided_and_written(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    document = with_rows(["<=", "0", "x"], ["<=", "0", ["sqrt", ["sub", "x", "1"]]])
    path, out = written(tmp_path, document), tmp_path / "out"
    assert main(["prove", path, "--rows", "r0", "--out", str(out)]) == 0
    assert "r1" not in capsys.readouterr().out
    assert check.check_folders(check.read_folders([str(out)]))[0] == 0
    assert main(["prove", path, "--rows", "r10"]) == 2
    assert "there is no row 'r10'; did you mean r1?" in capsys.readouterr().err


def test_a_certificate_of_more_rows_is_kept(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path, out = written(tmp_path, with_rows(["<=", "0", "x"], ["<=", "0", "2"])), tmp_path / "out"
    for words in (["--rows", "r0"], ["--rows", "r1"], [], ["--rows", "r0,r1"]):
        assert main(["prove", path, *words, "--out", str(out)]) == 0
    whole = (out / "certificate.json").read_bytes()
    capsys.readouterr()
    assert main(["prove", path, "--rows", "r1", "--out", str(out)]) == 2
    assert "has a certificate of more rows ('r0'); leave --rows out" in capsys.readouterr().err
    assert (out / "certificate.json").read_bytes() == whole
    (out / "statement.json").write_text('{"theorem": "x"}')
    assert main(["prove", path, "--rows", "r1", "--out", str(out)]) == 2
    assert "is no statement; name a new folder" in capsys.readouterr().err


def test_the_rows_of_a_chain_have_its_name(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    page = tmp_path / "page.toml"
    rows = "".join(f'r{i} = "{i} < {i + 1}"\n' for i in range(9))
    page.write_text(f'title = "t"\n[rows]\n{rows}chain = "2 < 3 < 4"\n', encoding="utf-8")
    assert main(["prove", str(page), "--rows", "chain,r2"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert [line.split()[1] for line in lines[:-1]] == ["r2", "chain.1", "chain.2"]
    assert main(["prove", str(page), "--rows", "cha"]) == 2
    assert main(["prove", str(page), "--rows", "xyz"]) == 2
    assert "write one of r0, r1, r2, r3, r4, r5, r6, r7, ...\n" in capsys.readouterr().err


def test_what_is_proved_before_an_interruption_is_kept(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    search = RowsInContexts.decide

    def interrupted(self: Any, row: Any) -> Any:
        if row.name == "r1":
            raise KeyboardInterrupt
        return search(self, row)

    monkeypatch.setattr(RowsInContexts, "decide", interrupted)
    document = with_rows(["<=", "0", "x"], ["<=", "-2", "x"], ["<=", "-1", "x"])
    out = tmp_path / "out"
    assert main(["prove", written(tmp_path, document), "--out", str(out)]) == 130
    out_text, err = capsys.readouterr()
    assert "verify: interrupted\n" in err
    lines = out_text.splitlines()
    assert [line.split()[0] for line in lines[:3]] == ["proved", "undecided", "undecided"]
    assert "because the search was interrupted" in lines[1]
    assert "1 needed proved" in check.check_folders(check.read_folders([str(out)]))[1][-1]


def test_rows_that_begin_are_told_to_who_watches(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    for module in ("steps", "terminal"):
        monkeypatch.setattr(f"verify.cli.{module}.is_watched", lambda: True)
    assert main(["prove", written(tmp_path, example("instance"))]) == 0
    shown = capsys.readouterr().err.split("\r")
    assert shown == ["", "[1/2] two …\x1b[K", "[2/2] at-root …\x1b[K", "\x1b[K"]


def test_the_files_are_the_same_again(tmp_path: Path) -> None:
    path = written(tmp_path, example("instance"))
    for run in ("1", "2"):
        assert main(["prove", path, "--out", str(tmp_path / run)]) == 0
    for name in ("statement.json", "certificate.json"):
        assert (tmp_path / "1" / name).read_bytes() == (tmp_path / "2" / name).read_bytes()


def with_rows(*claims: Any) -> dict[str, Any]:
    """Questions for all x > 0."""
    document = example("instance")
    row = next(row for row in document["obligations"] if row["context"] is not None)
    rows = [row | {"name": f"r{i}", "claim": claim} for i, claim in enumerate(claims)]
    return document | {"obligations": rows}


def test_one_row_does_not_take_down_the_others(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    def fails(*_: Any) -> Any:
        raise ZeroDivisionError("a quotient by 0")

    monkeypatch.setattr("verify.prover.rows_in_contexts.RowsInContexts._apply", fails)
    document = with_rows(["<=", "0", "x"], ["applies", "positive", {"x": "x"}], ["<", "-1", "x"])
    document["obligations"][1]["claim"][1] = document["contexts"][0]["name"]
    assert main(["prove", written(tmp_path, document), "--json"]) == 3
    rows = json.loads(capsys.readouterr().out)["obligations"]
    assert [row["verdict"] for row in rows] == ["proved", "undecided", "proved"]
    assert rows[1]["reason"] == "the search failed: ZeroDivisionError: a quotient by 0"
    assert [rows[0]["reason"], rows[2]["reason"]] == [None, None]


def test_a_proof_that_the_checker_cannot_read_is_not_claimed(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(search, "MAX_REFUSED", 0)  # no other proof is looked for
    power = ["pow", "x", "200"]
    most = ["<=", ["mul", power, ["sub", "1", "x"]], "1/201"]
    document = with_rows(["<=", "0", "x"], most, ["<", "-1", "x"])
    document["contexts"][0]["givens"].append(
        document["contexts"][0]["givens"][0] | {"name": "most", "claim": ["<=", "x", "1"]}
    )
    document["contexts"][0]["point"] = {"x": "1"}
    assert main(["prove", written(tmp_path, document)]) == 3
    lines = capsys.readouterr().out.splitlines()
    assert lines[0].startswith("proved")
    assert lines[1].startswith("undecided r1")
    assert "because the proof that was found is more than the checker reads" in lines[1]
    assert lines[2].startswith("proved")


def test_an_undecided_row_about_a_context_is_left_out(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    document = with_rows(["<=", "0", "x"], ["applies", "", {"x": ["sub", "x", "1"]}])
    document["obligations"][1]["claim"][1] = document["contexts"][0]["name"]
    document["obligations"][1]["role"] = "printed"
    out = tmp_path / "out"
    assert main(["prove", written(tmp_path, document), "--out", str(out)]) == 0
    captured = capsys.readouterr()
    assert captured.out.splitlines()[1].startswith("undecided r1")
    assert "the row r1 is left out of it" in captured.err
    rows = json.loads((out / "statement.json").read_text(encoding="utf-8"))["obligations"]
    assert [row["name"] for row in rows] == ["r0"]


def test_cited_certificates_are_carried_along(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """With them the folder is proved; without them the whole is undecided, here as there."""
    folder, out = tmp_path / "mine", tmp_path / "out"
    shutil.copytree(EXAMPLES / "mean-applied", folder)
    document = example("mean-applied")
    document["obligations"] = [o for o in document["obligations"] if o["name"] == "means"]
    words = ["prove", written(folder, document), "--out", str(out)]
    assert main(words) == 0
    assert main(["check", str(out)]) == 0
    beside = folder / "cited/mean.certificate.json"
    honest = beside.read_bytes()
    beside.unlink()
    shutil.rmtree(out)
    capsys.readouterr()
    assert main(words) == 3
    said = capsys.readouterr().out.splitlines()
    assert said[-2].startswith("undecided: mean, which is cited, is not proved here")
    assert said[-1].startswith("Verdict: undecided: ")
    assert main(["check", str(out)]) == 3
    capsys.readouterr()
    for other in (honest.replace(b"square", b"root"), b"{}"):
        beside.write_bytes(other)
        assert main(words) == 2
        captured = capsys.readouterr()
        assert (captured.out, captured.err.count("\n")) == ("", 1)
        assert "does not accept cited/'mean.certificate.json'" in captured.err


def test_a_folder_as_it_is_written_is_cited(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Also one that cites another one itself; and what the checker does not accept is named."""
    pages = {
        "a": ("", "a", "0 < 1 + 1"),
        "b": ('[cites]\nm = "a"\n', "b", "0 < 1"),
        "c": ('[cites]\nm = "b"\n', "c", "0 < 2"),
    }
    for name, (cites, title, claim) in pages.items():
        (tmp_path / f"{name}.toml").write_text(
            f'title = "{title}"\n{cites}[rows]\nr{name} = "{claim}"\n'
        )
    use = ["prove", str(tmp_path / "b.toml"), "--out", str(tmp_path / "cited/b")]
    assert main(use) == 2
    assert "verify prove ITS_PAGE --out cited/m" in capsys.readouterr().err
    assert main(["prove", str(tmp_path / "a.toml"), "--out", str(tmp_path / "cited/a")]) == 0
    assert main(use) == 0
    assert main(["prove", str(tmp_path / "c.toml"), "--out", str(tmp_path / "out")]) == 0
    assert main(["check", str(tmp_path / "out")]) == 0
    (tmp_path / "cited/a/certificate.json").write_bytes(b"{}")
    assert main(["prove", str(tmp_path / "c.toml")]) == 2
    assert "does not accept cited/'a.certificate.json'" in capsys.readouterr().err


@pytest.mark.parametrize("kind", ["pipe", "folder", "too much"])
def test_what_lies_in_the_folder_of_citations(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, kind: str
) -> None:
    cited = tmp_path / "cited"
    cited.mkdir()
    if kind == "pipe":
        os.mkfifo(cited / "a.json")
    elif kind == "folder":
        (cited / "a.json").mkdir()
    else:
        monkeypatch.setattr(files, "MAX_CITED", 100)
        for name in "ab":
            (cited / f"{name}.json").write_bytes(b" " * 60)
    assert main(["prove", written(tmp_path, example("instance"))]) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert captured.err.startswith("verify: STATEMENT: ")
    assert captured.err.count("\n") == 1


@pytest.mark.parametrize(
    "text", ['{"format": "verify-statement/2"}', '{"format": "verify-statement/2", "cites": 1}']
)
def test_a_cited_statement_that_cannot_be_read(
    text: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Also beside a page that cites nothing."""
    (tmp_path / "cited").mkdir()
    (tmp_path / "cited/j.json").write_text(text)
    (tmp_path / "p.toml").write_text('title = "t"\n[rows]\nr = "1 < 2"')
    assert main(["prove", str(tmp_path / "p.toml")]) == 2
    assert "cited: a statement there cannot be read" in capsys.readouterr().err


def test_names_like_those_of_lemmas(tmp_path: Path) -> None:
    document = with_rows(["<=", "2", ["add", "x", ["div", "1", "x"]]], ["<=", "0", "x"])
    for i, name in enumerate(("l.1", "u.1")):
        document["obligations"][i]["name"] = name
    document["contexts"][0]["givens"][0]["name"] = "ll.1"
    assert main(["prove", written(tmp_path, document), "--out", str(tmp_path / "out")]) == 0
    assert check.check_folders(check.read_folders([str(tmp_path / "out")]))[0] == 0


def changed(**values: Any) -> dict[str, Any]:
    return example("instance") | values


def without(key: str) -> dict[str, Any]:
    return {name: value for name, value in example("instance").items() if name != key}


def with_claim(claim: Any) -> dict[str, Any]:
    document = example("instance")
    document["obligations"][0]["claim"] = claim
    return document


@pytest.mark.parametrize(
    ("document", "reason"),
    [
        ("", "Expecting value"),
        ("[]", "expected an object"),
        ("{}", "too few keys"),
        ('{"a": 1, "a": 2}', "a key twice"),
        (without("contexts"), "contexts"),
        (changed(format="verify-statement/1"), "verify-statement/2"),
        (changed(obligations=[]), "no row is needed"),
        (with_claim(["<", "x", "q"]), "found q, which is no name"),
        (with_claim(["!=", "x", "1"]), "expected [<, <= or ="),
        (with_claim(["<", "x", 0.5]), "found 0.5"),
        (with_claim(["<", "x", ["pow", "x", "0"]]), "an exponent from 1"),
        (with_claim(["<", "x", "1/0"]), "no number"),
        (with_claim(["<", "x", "0.5"]), "no number"),
        (
            changed(theorem="other", terms={"two": "2"}),
            "the name two twice: one name stands for two",
        ),
    ],
)
def test_an_unusable_statement(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], document: Any, reason: str
) -> None:
    assert main(["prove", written(tmp_path, document)]) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert captured.err.startswith("verify: STATEMENT: ")
    assert captured.err.count("\n") == 1
    assert reason in captured.err


@pytest.mark.parametrize(
    "words",
    [[], ["missing.json"], ["x", "--work", "0"], ["x", "--time", "0"]],
)
def test_unusable_options(words: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["prove", *words]) == 2
    assert capsys.readouterr().err.count("\n") == 1


PAGE = """
title = "A page of somebody else"

[constants]
q = "(3 - sqrt(5))/4"

[contexts.ball]
variables = ["x"]
given = ["-q <= x <= q"]

[rows]
slope = { claim = "2*(q + x) <= 4*q", label = "Lemma 3" }
rounded = { claim = "q <= 0.19", role = "printed", label = "(2.1)" }
"""


def test_a_report_is_about_the_theorem_of_its_author(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    page, out = tmp_path / "page.toml", tmp_path / "out"
    page.write_text(PAGE, encoding="utf-8")
    assert main(["prove", str(page), "--out", str(out)]) == 0
    capsys.readouterr()
    assert main(["check", "--markdown", str(out)]) == 0
    text = capsys.readouterr().out
    assert text == (out / "report.md").read_text(encoding="utf-8")
    assert "| proved | `slope` | Lemma 3 |  | 2·(q + x) ≤ 4·q for all values of `ball` |" in text
    assert "| (2.1) |  | q ≤ 19/100 | 0.19098300… ≤ 0.19 |" in text
    assert "Nothing: what is proved rests on the definitions above alone." in text
    assert PAPER.authors not in text
    assert main(["check", "--latex", "--full", str(out)]) == 0
    text = capsys.readouterr().out
    assert r"\formula{q = \frac{3 - \sqrt{5}}{4}\quad (0.19098300\ldots{})}" in text
    assert r"\begin{row}[{\texttt{slope} Lemma 3}]" in text
    assert main(["check", "--latex", "--markdown", str(out)]) == 2


PIPED = {
    "toml": 'title = "t"\n[constants]\nq = "1/3"\n[rows]\na = "q < 1/2"\nb = "1/2 < q"\n',
    "smt2": "; piped\n(declare-const x Real)\n(assert (< x 0))\n(assert (< 1 x))\n(check-sat)\n",
    "fpcore": "(FPCore (x) :pre (<= 1 x 2) (sqrt x))",
}


def piping(content: bytes, *words: str) -> subprocess.CompletedProcess[bytes]:
    command = [sys.executable, "-m", "verify", "prove", "-", *words]
    return subprocess.run(command, input=content, capture_output=True)


@pytest.mark.parametrize("kind", [*PIPED, "json"])
def test_a_statement_is_piped_in(kind: str, tmp_path: Path) -> None:
    """It is the same as from a file of that kind."""
    text = PIPED.get(kind) or json.dumps(example("instance"))
    path = tmp_path / f"stdin.{kind}"
    path.write_text(text)
    command = [sys.executable, "-m", "verify", "prove", str(path)]
    done = piping(text.encode(), "--out", str(tmp_path / "out"))
    same = subprocess.run(command, capture_output=True)
    assert (done.returncode, done.stdout) == (same.returncode, same.stdout)
    assert done.returncode in (0, 1)
    assert check.check_folders(check.read_folders([str(tmp_path / "out")]))[0] == done.returncode


@pytest.mark.parametrize(
    ("content", "code"),
    [
        (b"\xef\xbb\xbf" + PIPED["smt2"].encode(), 0),
        (b"; no (FPCore\n" + PIPED["smt2"].encode(), 0),
        (b"; a comment\n\n ( FPCore (x) :pre (<= 1 x 2) (sqrt x))", 0),
    ],
)
def test_signs_and_comments_before_what_is_piped_in_do_not_count(content: bytes, code: int) -> None:
    assert piping(content).returncode == code


def test_what_is_piped_in_may_be_unusable() -> None:
    for content in (b"", b"\xff", b"title = 3", b"[rows", b"x" * (files.MAX_BYTES + 1)):
        done = piping(content)
        assert (done.returncode, done.stdout) == (2, b"")
        assert done.stderr.count(b"\n") == 1
    closed = f"{sys.executable} -m verify prove - <&-"
    done = subprocess.run(["sh", "-c", closed], capture_output=True)
    assert done.returncode == 2
    assert b"there is no standard input" in done.stderr
