"""What is printed and returned: lines, the last line, exit codes, and streams that are closed."""

from __future__ import annotations

import io
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

import pytest

from tests.check.support import INTERVAL, Pair, answer, box, witness
from verify import check


def proved() -> Pair:
    pair = box(("0", "1")).assume("law").assume("map").row("one", "0 <= 1", INTERVAL)
    pair.row("two", "1 < 2", INTERVAL, role="printed")
    lie = witness({"x": "1"}, [INTERVAL, INTERVAL], INTERVAL)
    pair.row("three", "x < 1", lie, "box", "refuted", "printed")
    return pair.row("four", "x < 1", None, "box", "undecided", "printed")


def refused() -> Pair:
    return Pair().row("row", "2 < 1", INTERVAL).row("next", "1 < 2", INTERVAL)


def refuted() -> Pair:
    return Pair().row("row", "2 < 1", INTERVAL, verdict="refuted")


def malformed() -> Pair:
    return Pair().row("row", "2 < 1", None)


COUNTS = (
    "1 needed proved, 1 printed proved, 0 needed refuted, 1 printed refuted, "
    "0 needed undecided, 1 printed undecided"
)


def test_the_report_of_what_is_proved() -> None:
    assert answer(proved()) == (0, [
        "proved  one [L] lhs <= rhs",
        "proved  two [L] lhs < rhs",
        "proved  three [L] not (lhs < rhs throughout the context box)",
        "assumed law: sentence of law",
        "assumed map: sentence of map",
        f"PROVED: T's title: {COUNTS}; given law, map",
    ])  # fmt: skip


def test_the_report_of_what_is_not() -> None:
    code, lines = answer(refused())
    assert code == 1
    assert lines[0].startswith("REFUSED row [L] lhs < rhs: found [2")
    assert lines[1] == "proved  next [L] lhs < rhs"
    assert lines[2] == "REFUSED: T's title: not shown; refused above: 1"
    code, lines = answer(refuted())
    assert code == 1
    assert lines[-1].startswith(
        "REFUTED: T's title: 0 needed proved, 0 printed proved, 1 needed re"
    )
    code, lines = answer(malformed())
    assert code == 4
    rules = [*check.RULES]
    assert lines == [f"MALFORMED: obligation row: rule: found None, expected one of {rules}"]


def test_a_refusal_beats_a_refutation() -> None:
    pair = refuted().row("next", "1 < 1", INTERVAL)
    assert answer(pair)[1][-1].startswith("REFUSED: ")


def test_a_needed_row_undecided() -> None:
    pair = Pair().row("row", "0 <= 1", INTERVAL).row("next", "1 < 1", None, None, "undecided")
    code, lines = answer(pair)
    assert (code, lines[1]) == (1, "REFUSED next: a needed row is undecided")
    assert lines[-1].startswith("REFUSED: ")


@pytest.mark.parametrize(
    ("pairs", "code"),
    [((proved, proved), 0), ((proved, refused), 1), ((refused, proved), 1), ((refuted, proved), 1),
     ((malformed, refused), 4), ((refused, malformed), 4), ((malformed, proved), 4)],
)  # fmt: skip
def test_of_several_folders_the_worst_code(pairs: Any, code: int) -> None:
    found, lines = answer(*[make() for make in pairs])
    assert found == code
    assert [line for line in lines if line.startswith("folder")] == ["folder 1:", "folder 2:"]


def test_messages_of_enclosures() -> None:
    pair = Pair().constant("c", "sqrt(2)", INTERVAL).row("row", "c < 2", INTERVAL)
    pair.enclosures["constants"] = {"c": {"bits": 64, "ends": ["1.4", "1.41"]}}
    pair.enclosures["rows"] = {"row": {"bits": 64, "lhs": ["1", "2"], "rhs": ["1", "1.5"]}}
    _, lines = answer(pair)
    found = "found the enclosure [140000000000000000000e-20, 141000000000000000000e-20]"
    assert lines[1].startswith(f"REFUSED enclosure of c: {found}, expected one around [14142")
    assert lines[2].startswith("REFUSED enclosure of row: found the enclosure [100000")
    assert "expected one around [200000000000000000000e-20, 2000" in lines[2]


def test_an_enclosure_of_a_constant_without_one() -> None:
    """The root of c - c, which is 0: its enclosure reaches below 0."""
    pair = Pair().constant("c", "cos(1)*1000", INTERVAL)
    pair.constant("d", "sqrt(c - c)", {"rule": "interval", "bits": 64, "bounds": []})
    assert (
        "REFUSED constant d: found a square root of"
        in answer(pair.row("row", "0 <= 1", INTERVAL))[1][0]
    )


def test_texts_are_printed_in_one_line() -> None:
    pair = Pair().row("row", "0 <= 1", INTERVAL)
    pair.statement["title"] = "a\nPROVED: b\x1b[2J \ud800"
    lines = answer(pair)[1]
    folder = subprocess_folder(pair)
    done = run(folder)
    assert done.returncode == 0
    assert len(done.stdout.splitlines()) == len(lines) == 2
    assert "\\nPROVED: b\\x1b[2J \\ud800" in done.stdout


def subprocess_folder(pair: Pair) -> str:
    folder = Path(tempfile.mkdtemp())
    for name, data in zip(("statement.json", "certificate.json"), pair.files(), strict=True):
        (folder / name).write_bytes(data)
    return str(folder)


def run(*arguments: str, flags: tuple[str, ...] = ("-I",), **fields: Any) -> Any:
    command = [sys.executable, *flags, check.__file__, *arguments]
    fields = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE} | fields
    return subprocess.run(command, encoding="utf-8", check=False, **fields)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> str:
    path = tmp_path_factory.mktemp("pair")
    for name, data in zip(("statement.json", "certificate.json"), proved().files(), strict=True):
        (path / name).write_bytes(data)
    return str(path)


@pytest.mark.parametrize("flags", [(), ("-I",), ("-I", "-O"), ("-I", "-OO"), ("-X", "utf8=0")])
def test_it_runs_alone(folder: str, flags: tuple[str, ...]) -> None:
    done = run(folder, flags=flags, cwd="/")
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.splitlines() == answer(proved())[1]


def test_two_files(folder: str) -> None:
    done = run(f"{folder}/statement.json", f"{folder}/certificate.json")
    assert (done.returncode, done.stdout.splitlines()) == answer(proved())
    done = run(f"{folder}/certificate.json", f"{folder}/statement.json")
    assert (done.returncode, done.stdout.startswith("MALFORMED: statement: ")) == (4, True)


def test_a_refused_pair_under_optimisation() -> None:
    folder = subprocess_folder(refused())
    assert run(folder, flags=("-I", "-O")).returncode == 1
    assert run(subprocess_folder(malformed()), flags=("-I", "-O")).returncode == 4


@pytest.mark.parametrize(
    ("arguments", "word"),
    [((), "found no folder; write: check.py FOLDER"), (("/nowhere",), "'/nowhere' is no folder"),
     (("/",), "'/' has no statement"), (("\0",), "is no folder"),
     (("/nowhere", "/nowhere"), "/nowhere"),
     (("",), "found an empty name of a folder"),
     (("/etc/passwd",), "'/etc/passwd' is no folder")],
)  # fmt: skip
def test_what_cannot_be_read(arguments: tuple[str, ...], word: str, capsys: Any) -> None:
    assert check.main(arguments) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert captured.err.startswith("check: ")
    assert word in captured.err
    assert captured.err.count("\n") == 1


def test_which_folders_there_are(folder: str, tmp_path: Path, capsys: Any) -> None:
    """A name that is mistyped is told with the certificates beside it."""
    near = tmp_path / "near"
    shutil.copytree(folder, near / "mean")
    for path in (near / "meanx", near):
        assert check.main([str(path)]) == 2
        err = capsys.readouterr().err
        assert err.count("\n") == 1
        assert f"in {near} there is mean" in err
    assert check.main([str(tmp_path / "x")]) == 2
    assert f"in {tmp_path} there is none" in capsys.readouterr().err


def test_a_folder_for_a_file(tmp_path: Path, capsys: Any) -> None:
    (tmp_path / "statement.json").mkdir()
    assert check.main([str(tmp_path)]) == 2
    assert "statement.json" in capsys.readouterr().err


def test_interrupted(folder: str, monkeypatch: pytest.MonkeyPatch, capsys: Any) -> None:
    def interrupt(_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(check, "check_folders", interrupt)
    assert check.main([folder]) == 130
    assert capsys.readouterr().err == "check: interrupted\n"


def test_a_reader_that_has_left(folder: str) -> None:
    reading, writing = os.pipe()
    os.close(reading)
    done = run(folder, stdout=writing)
    os.close(writing)
    assert (done.returncode, done.stderr) == (141, "")


def test_a_full_disk(folder: str) -> None:
    if not Path("/dev/full").exists():
        pytest.skip("no /dev/full")
    with open("/dev/full", "w") as full:
        done = run(folder, stdout=full)
    assert done.returncode == 2
    assert done.stderr.startswith("check: the report cannot be written (")
    assert done.stderr.count("\n") == 1


def test_closed_streams(folder: str) -> None:
    def shell(redirections: str, path: str) -> Any:
        command = f'"{sys.executable}" -I "{check.__file__}" "{path}" {redirections}'
        return subprocess.run(command, shell=True, capture_output=True, check=False)

    done = shell(">&-", folder)
    assert (done.returncode, done.stdout) == (2, b"")
    assert done.stderr == b"check: the report cannot be written (stdout is closed)\n"
    assert shell(">&- 2>&-", folder).returncode == 2
    assert shell("2>&-", folder).returncode == 0
    for redirections in ("2>&-", "2>/dev/full", ">&- 2>&-", ">/dev/full 2>/dev/full"):
        done = shell(redirections, "/nowhere")
        assert (done.returncode, done.stdout, done.stderr) == (2, b"", b""), redirections
    assert shell(">/dev/full 2>/dev/full", folder).returncode == 2


def test_interrupted_while_it_checks() -> None:
    stored = (Path(check.__file__).parents[1] / "certificates").glob("*/certificate.json")
    folders = [str(path.parent) for path in stored]
    command = [sys.executable, "-I", check.__file__, *folders]
    process = subprocess.Popen(command, stderr=subprocess.PIPE, encoding="utf-8")
    clock = Path(f"/proc/{process.pid}/stat")
    ticks = 0
    while ticks < 0.4 * os.sysconf("SC_CLK_TCK"):  # it has begun to check, however busy the machine
        time.sleep(0.05)
        ticks = int(clock.read_text(encoding="ascii").rpartition(")")[2].split()[11])
    process.send_signal(signal.SIGINT)
    _, errors = process.communicate(timeout=10)
    assert (process.returncode, errors) == (130, "check: interrupted\n")


@pytest.mark.parametrize("name", ["statement.json", "certificate.json"])
def test_nobody_waits_for_a_pipe_in_a_folder(tmp_path: Path, name: str) -> None:
    folder = subprocess_folder(proved())
    Path(folder, name).unlink()
    os.mkfifo(Path(folder, name))
    done = run(folder, timeout=10)
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr == f"check: found {folder}/{name}, which is no file\n"


def test_a_row_without_a_label() -> None:
    pair = Pair().row("row", "0 <= 1", INTERVAL)
    pair.statement["obligations"][0]["label"] = ""
    assert answer(pair)[1][0] == "proved  row lhs <= rhs"


def test_a_letter_that_the_terminal_does_not_have(tmp_path: Path) -> None:
    pair = Pair().row("row", "0 <= 1", INTERVAL)
    pair.statement["title"] = "Δx"
    done = run(subprocess_folder(pair), flags=(), env={"PYTHONIOENCODING": "ascii", "LC_ALL": "C"})
    assert (done.returncode, done.stderr) == (0, "")
    assert "\\u0394x" in done.stdout


def rows(pair: Pair) -> dict[str, str]:
    return dict(check.check(*pair.files(), {}).rows)


def test_the_rows_of_a_report() -> None:
    assert rows(proved()) == {
        "one": "proved", "two": "proved", "three": "refuted", "four": "undecided",
    }  # fmt: skip
    assert rows(refused()) == {"row": "refused", "next": "proved"}
    assert rows(refuted()) == {"row": "refuted"}


def test_a_row_is_proved_only_where_its_own_proof_is_accepted() -> None:
    """A title, another row or an assumption that says proved changes nothing."""
    pair = Pair().assume("proved  row")
    pair.row("row", "1 < 1", INTERVAL).row("proved", "0 < 1", INTERVAL)
    pair.row("wrong", "0 < 1", INTERVAL, verdict="refuted", role="printed")
    pair.statement["title"] = "PROVED: row"
    pair.statement["assumptions"][0]["name"] = "law"
    pair.statement["obligations"][1]["label"] = "\nproved  row"
    assert rows(pair) == {"row": "refused", "proved": "proved", "wrong": "refused"}


def test_a_row_of_a_context_that_is_not_opened_is_refused() -> None:
    pair = box(("1", "0")).row("one", "0 <= 1", INTERVAL, "box")
    assert rows(pair) == {"one": "refused"}


def test_what_is_malformed_has_no_work_and_is_told_first() -> None:
    """Whatever is said of the certificates that lie there to be cited."""
    report = check.examined(b"{}", b"{}", {}, 100)
    assert (report.verdict, report.work) == ("MALFORMED", 0)
    others = [check.examined(*pair.files(), {}, 10**6) for pair in (refused(), proved())]
    assert check.with_cited(report, others) == report


def test_what_is_malformed_ends_a_folder() -> None:
    """Nothing that lies there to be cited is checked any more, nor closes a citation elsewhere."""
    first, second = proved().files()
    folder = check.Folder("f", b"{}", b"{}", [first], [(first, second), (b"{}", b"{}")])
    ((report, cited),) = check.judged([folder])
    assert (report.verdict, cited) == ("MALFORMED", [])
    ((report, cited),) = check.judged([folder._replace(statement=first, certificate=second)])
    assert [other.verdict for other in cited] == ["PROVED", "MALFORMED"]
    assert report.verdict == "MALFORMED"


def test_an_interrupt_is_told(
    folder: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def interrupted(_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(check, "check_folders", interrupted)
    assert check.main([folder]) == 130
    assert capsys.readouterr() == ("", "check: interrupted\n")


@pytest.mark.parametrize("name", ["statement.json", "certificate.json"])
def test_a_folder_in_the_place_of_a_file(tmp_path: Path, name: str) -> None:
    (tmp_path / name).mkdir()
    with pytest.raises(OSError, match=f"{name}, which is no file"):
        check.read_folders([str(tmp_path)])


def test_a_stream_without_an_encoding(monkeypatch: pytest.MonkeyPatch) -> None:
    stream, file = io.StringIO(), io.BytesIO()
    monkeypatch.setattr("sys.stdout", stream)
    assert check.output(["Δ = 1"], 3) == 3
    assert stream.getvalue() == "\\u0394 = 1\n"
    monkeypatch.setattr("sys.stdout", io.TextIOWrapper(file, encoding="utf-8"))
    assert check.output(["Δ = 1"], 3) == 3
    assert file.getvalue() == "Δ = 1\n".encode()
