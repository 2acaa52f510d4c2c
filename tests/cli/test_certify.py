"""The commands that make committed files: paths are tested before the work."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.cli.running import check_refused, command, validator
from tests.cli.test_documents import document
from verify.paper.commands import certificates
from verify.prover.outcome import Outcome

run = command()


@pytest.fixture
def one_folder(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(certificates, "POINTS", certificates.POINTS[:1])


@pytest.mark.usefixtures("one_folder")
def test_what_is_written_compares_equal(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    code, out, err = run(capsys, "certify", "--directory", tmp_path / "new")
    written = out.count("written ")
    assert (code, err, written > 4) == (0, "", True)
    folder = tmp_path / "new/theorem1-r-3-100"
    assert {file.name for file in folder.iterdir()} == {
        "statement.json", "certificate.json", "cited", "report.md",
    }  # fmt: skip
    code, out, _ = run(capsys, "certify", "--compare", "--directory", tmp_path / "new")
    files = [path for path in (tmp_path / "new").rglob("*") if path.is_file()]
    assert (code, out.count("same ")) == (0, len(files))
    (folder / "report.md").write_text("other")
    (folder / "certificate.json").unlink()
    code, out, _ = run(capsys, "certify", "--compare", "--directory", tmp_path / "new")
    assert (code, out.count("DIFFERS ")) == (1, 2)
    words = ["certify", "--compare", "--directory", str(tmp_path / "new")]
    found = document(capsys, words)
    validator("files").validate(found)
    assert (found["exit_code"], found["compared"]) == (1, True)
    states = {one["path"]: one["state"] for one in found["files"]}
    assert states.keys() == {str(path) for path in files}
    assert {path for path, state in states.items() if state != "same"} == {
        str(folder / "report.md"), str(folder / "certificate.json"),
    }  # fmt: skip
    found = document(capsys, [*words[:1], *words[2:]])
    validator("files").validate(found)
    assert {one["state"] for one in found["files"]} == {"written"}
    assert str(folder) in {one["path"] for one in found["files"]}
    assert run(capsys, "check", "--statement", tmp_path / "new/spectrum")[0] == 0


@pytest.mark.parametrize(
    "words",
    [
        ["certify", "--compare", "--directory", "missing"],
        ["certify", "--directory", "file"],
        ["report", "--compare", "--directory", "missing"],
        ["report", "--directory", "missing"],
        ["stress", "--quick", "--out", "file"],
        ["bench", "--quick", "--out", "file"],
        ["spectrum", "--out", "file"],
        ["theorem1", "--r", "0.03", "--out", "file/deeper"],
    ],
)
def test_a_path_that_cannot_be_used_is_found_before_the_work(
    capsys: pytest.CaptureFixture[str],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    words: list[str],
) -> None:
    def never(*_: object, **__: object) -> Iterator[Outcome]:
        raise AssertionError("the work was done first")

    for work in (
        "verify.paper.commands.certificates.all_folders",
        "verify.cli.spectrum.cite_spectrum",
        "verify.cli.theorem1.decide_point",
        "verify.measure.stress.run_case",
        "verify.measure.bench.run_benchmarks",
    ):
        monkeypatch.setattr(work, never)
    monkeypatch.chdir(tmp_path)
    (tmp_path / "file").write_text("mine")
    check_refused(run(capsys, *words), words[-1])
    assert [path.name for path in tmp_path.iterdir()] == ["file"]
