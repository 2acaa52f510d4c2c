"""Which statements are the program's own."""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path
from typing import Any

import pytest

from tests.check.support import INTERVAL, Pair
from tests.points import parameters
from tests.readme_commands import ROOT
from verify.cli import main
from verify.paper.commands.certificates import THEOREMS
from verify.paper.commands.regenerate import is_right_statement
from verify.paper.commands.theorem1 import decide_point
from verify.wire.write import encode, write


@cache
def statement(selection: str = "repaired", r: str = "3/100") -> bytes:
    return write(decide_point(parameters(r, "1"), selection))["statement.json"]


def test_the_programs_own() -> None:
    assert is_right_statement(statement())
    assert is_right_statement(statement("all"))


def test_what_is_refuted_or_printed_alone_is_not() -> None:
    assert not is_right_statement(statement("printed"))
    assert not is_right_statement(statement("all", "1/2"))


@pytest.mark.parametrize(
    "key",
    ["theorem", "title", "constants", "obligations", "assumptions", "cites", "terms", "parameters"],
)
def test_any_change_is_seen(key: str) -> None:
    document = json.loads(statement("all"))
    assert encode(document) == statement("all")
    value = document[key]
    if isinstance(value, dict):
        document[key] = {name: value[name] for name in list(value)[1:]}
    else:
        document[key] = value[1:]
    assert not is_right_statement(encode(document))


@pytest.mark.parametrize(
    "content",
    [b"", b"{}", b"[]", b'{"parameters": []}', b'{"parameters": {"r": 1}}', b"\xff", b"[" * 5000],
)
def test_no_statement_at_all(content: bytes) -> None:
    assert not is_right_statement(content)


def test_one_byte_more() -> None:
    assert not is_right_statement(statement() + b" ")


CERTIFICATES = Path(__file__).parents[3] / "certificates"
#: What stands for a parameter: terms that are no number, and no terms at all.
FOREIGN: list[Any] = [
    ["sqrt", "0"], ["sqrt", "-1"], ["div", "1", "0"], ["neg", "1"], ["cos_pi", "1/2"],
    ["neg", ["cos", ["sqrt", "2"]]], ["pow", "0", "1"], ["min", "1", "2"], "nope",
    ["add", "1"], [], {}, None, 3, True, "x/0", "1/0",
]  # fmt: skip


@pytest.mark.parametrize("foreign", FOREIGN, ids=lambda value: str(value)[:20])
@pytest.mark.parametrize("folder", ["scenes/passing", "theorem1-r-3-100"])
def test_a_parameter_that_the_program_does_not_take(folder: str, foreign: Any) -> None:
    """The statement is not the program's; this is no error of the program."""
    document = json.loads((CERTIFICATES / folder / "statement.json").read_text())
    for name in list(document["parameters"])[:3]:
        changed = document | {"parameters": document["parameters"] | {name: foreign}}
        assert not is_right_statement(encode(changed)), name


@pytest.mark.parametrize("folder", ["scenes/passing", "theorem1-r-3-100"])
@pytest.mark.parametrize("long", ["7" * 4300, "1/" + "7" * 4300])
def test_a_parameter_so_long_that_what_follows_from_it_cannot_be_written(
    folder: str, long: str
) -> None:
    document = json.loads((CERTIFICATES / folder / "statement.json").read_text())
    for name in list(document["parameters"])[1:3]:
        changed = document | {"parameters": document["parameters"] | {name: long}}
        assert not is_right_statement(encode(changed)), name


def test_check_statement_of_a_scene_with_a_root_among_its_parameters(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """The attack: a statement that is proved, of a form that the program never writes."""
    content = (CERTIFICATES / "scenes/passing/statement.json").read_text()
    statement = json.loads(content)
    names = list(statement["parameters"])
    pair = Pair(statement["theorem"])
    for name in names:
        pair.parameter(name, statement["parameters"][name])
    pair.parameter(names[-1], ["sqrt", "0"], INTERVAL)
    del pair.steps[len(names) - 1]
    pair.row("row", "0 <= 1", INTERVAL)
    for name, data in zip(("statement.json", "certificate.json"), pair.files(), strict=True):
        (tmp_path / name).write_bytes(data)
    assert main(["check", "--statement", str(tmp_path)]) == 4
    assert "STATEMENT: it is not the one that the program makes" in capsys.readouterr().out


def test_a_theorem_has_the_name_in_its_folder() -> None:
    """By its name a statement is compared with what the program makes."""
    for theorem in THEOREMS:
        path = Path(ROOT, "certificates", theorem.folder, "statement.json")
        assert json.loads(path.read_bytes())["theorem"] == theorem.name
