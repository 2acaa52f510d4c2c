"""How the words after a command are read."""

from __future__ import annotations

import pytest

from verify.cli import COMMANDS, main
from verify.cli.options import Options, Parser, Usage
from verify.wire.inputs import InputError


def parser() -> Parser:
    meanings = {
        "--r R": "a number",
        "--delta-theta D": "a deviation",
        "-v, --verbose": "more",
        "[folder]": "a folder",
    }
    return Parser("verify x", "About x.", Usage(meanings, {"delta_theta": "1/10"}))


DEFAULTS = {"r": None, "delta_theta": "1/10", "verbose": False, "folder": None}


@pytest.mark.parametrize(
    ("words", "changed"),
    [
        ([], {}),
        (["--r", "3"], {"r": "3"}),
        (["--r=3", "-v"], {"r": "3", "verbose": True}),
        (["--r", "-1"], {"r": "-1"}),
        (["--r", "-pi"], {"r": "-pi"}),
        (["--r=-v"], {"r": "-v"}),
        (["--r="], {"r": ""}),
        (["a", "--delta-theta", "b=c"], {"folder": "a", "delta_theta": "b=c"}),
        (["--verbose", "-"], {"verbose": True, "folder": "-"}),
    ],
)
def test_what_is_chosen(words: list[str], changed: dict[str, object]) -> None:
    assert parser().read(words) == Options(**(DEFAULTS | changed))


@pytest.mark.parametrize(
    ("words", "named"),
    [
        (["--r"], "--r"),
        (["--r", "--verbose"], "--r"),
        (["--q", "1"], "'--q'"),
        (["--ver"], "'--ver'"),
        (["--"], "'--'"),
        (["-r", "1"], "'-r'"),
        (["--verbose=1"], "--verbose"),
        (["-v", "--verbose"], "--verbose"),
        (["--r", "1", "--r=2"], "--r"),
        (["a", "b\nc"], r"b\nc"),
        (["--folder", "a"], "--folder"),
    ],
)
def test_what_is_refused(words: list[str], named: str) -> None:
    with pytest.raises(InputError) as error:
        parser().read(words)
    assert named in str(error.value)
    assert "\n" not in str(error.value)


def test_what_is_required() -> None:
    meanings = {"path [path ...]": "folders", "--out FILE": "a file"}
    made = Parser("verify x", "About x.", Usage(meanings, required=("--out",)))
    assert made.read(["a", "--out", "f", "b"]) == Options(path=["a", "b"], out="f")
    for words, named in ((["a"], "--out"), (["--out", "f"], "path"), ([], "path, --out")):
        with pytest.raises(InputError, match=named):
            made.read(words)


@pytest.mark.parametrize("words", [["-h"], ["--help"], ["--r", "1", "--help", "--unknown"]])
def test_help_lists_every_option_and_place(words: list[str]) -> None:
    made = parser()
    assert made.read(words) is None
    text = made.help(80)
    assert "usage: verify x [options] [folder]" in text
    for part in ("About x.", "--r R ", "--delta-theta D", "-v, --verbose", "[folder]", "--help"):
        assert part in text


def test_help_of_a_command_is_asked_for_in_two_ways(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["scene", "--help"]) == 0
    text = capsys.readouterr().out
    assert main(["help", "scene"]) == 0
    assert capsys.readouterr().out == text
    assert main(["help", "scen"]) == 2
    assert "'scen' is not a command" in capsys.readouterr().err
    assert main(["page.toml", "-v"]) == 2
    assert "is not a command; write one before it: prove page.toml" in capsys.readouterr().err


def test_help_is_as_wide_as_the_terminal(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    for columns in (60, 80):
        monkeypatch.setenv("COLUMNS", str(columns))
        for words in (["--help"], *([name, "--help"] for name in COMMANDS)):
            assert main(words) == 0
            lines = capsys.readouterr().out.splitlines()
            assert max(map(len, lines)) <= columns
            assert len(lines) > 5
