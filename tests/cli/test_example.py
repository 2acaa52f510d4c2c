"""What comes with the program is found by its name, in any folder."""

from __future__ import annotations

from pathlib import Path

import pytest

from verify.cli import main
from verify.cli.files import EXAMPLES, PAGES, SCENES, command_for, example
from verify.wire.packaged import PACKAGED_FILES

NAMES = [path.stem for path in sorted(Path(EXAMPLES).glob("*.toml"))]


@pytest.fixture(autouse=True)
def another_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


def test_each_is_listed_with_its_command(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["example"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert [line.split()[2] for line in lines if not line.startswith(" ")] == NAMES
    assert {line.split()[1] for line in lines if not line.startswith(" ")} == {"scene", "prove"}


def test_the_help_names_them(capsys: pytest.CaptureFixture[str]) -> None:
    for command, named in (("example", NAMES), ("scene", SCENES), ("prove", PAGES)):
        assert main([command, "--help"]) == 0
        out = capsys.readouterr().out
        assert all(name in out for name in named)
    assert sorted((*SCENES, *PAGES)) == NAMES
    assert {command_for(example(name)) for name in SCENES} == {"scene"}
    assert {command_for(example(name)) for name in PAGES} == {"prove"}


@pytest.mark.parametrize(
    ("words", "meant"),
    [("scene pasing", "passing"), ("scene inspace", "in-space"), ("prove fist", "fista"),
     ("prove bb-84", "bb84"), ("scene passing.toml", "passing"), ("example pasing", "passing"),
     ("scene mine.tml", "mine.toml"), ("prove ./mine.tomll", "./mine.toml")],
)  # fmt: skip
def test_what_a_mistyped_name_means(
    words: str, meant: str, capsys: pytest.CaptureFixture[str]
) -> None:
    Path("mine.toml").write_text("")
    assert main(words.split()) == 2
    assert f"did you mean {meant}?" in capsys.readouterr().err


@pytest.mark.parametrize(("name", "command"), [("bead", "scene"), ("fista", "prove")])
def test_one_is_copied_and_decided(
    name: str, command: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main([command, name]) == 0
    by_name = capsys.readouterr().out
    assert main(["example", name]) == 0
    assert Path(f"{name}.toml").read_bytes() == Path(EXAMPLES, f"{name}.toml").read_bytes()
    assert capsys.readouterr().out.endswith(f"try: verify {command} {name}.toml\n")
    assert main([command, f"{name}.toml"]) == 0
    assert capsys.readouterr().out == by_name


def test_what_lies_there_is_neither_replaced_nor_passed_over(
    capsys: pytest.CaptureFixture[str],
) -> None:
    Path("bead.toml").write_text("mine")
    assert main(["example", "bead"]) == 2
    assert Path("bead.toml").read_text() == "mine"
    Path("bead").write_text("mine")
    Path("step").mkdir()
    for words in (["scene", "bead"], ["check", "step"]):
        assert main(words) == 2
    assert "write at least" not in capsys.readouterr().err


@pytest.mark.parametrize("name", ["nothing", "../examples/bead", "", "examples/bead", "bead.toml"])
def test_other_names_are_no_examples(name: str) -> None:
    for command in ("example", "scene", "prove", "check"):
        assert main([command, name]) == 2


def test_what_a_certificate_cites_is_checked_with_it(capsys: pytest.CaptureFixture[str]) -> None:
    assert "theorem1-all" in PACKAGED_FILES
    assert main(["check", "theorem1-all"]) == 0
    assert capsys.readouterr().out.count("PROVED: ") == 2
    assert main(["check", "theorem1-all", "step"]) == 0
    assert capsys.readouterr().out.count("PROVED: ") == 2
