"""The extracted program reads JSON as strictly as the checker; compiled where there is OCaml."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from tests.coq.fuzz import ROOT, anything, broken, compiled, disagreements, pieces, wanted
from verify import check

SOURCE = ROOT / "verify/coq/json.ml"
needs_ocaml = pytest.mark.skipif(not shutil.which("ocamlfind"), reason="there is no OCaml here")


@needs_ocaml
def test_both_read_the_same_of_broken_documents(tmp_path: Path) -> None:
    found = [*broken(1000)]
    accepted = sum(wanted(data) is not None for data in found)
    assert len(found) / 4 < accepted < len(found) * 3 / 4
    assert disagreements(compiled(tmp_path), found) == []


@needs_ocaml
@pytest.mark.parametrize(
    ("line", "other"),
    [
        ("= List.length keys) \"a key twice\"", "> 0 || keys = []) \"a key twice\""),
        ("when depth = 100", "when depth = 101"),
        ("| 'A' .. 'F' as c -> Char.code c - 55", "| 'A' .. 'F' | '_' as c -> Char.code c - 55"),
        ("code < 0xdc00 &&", "code < 0xd800 &&"),
        ("c >= ' '", "c > '\\000'"),
        ("need (is_utf8 s)", "need (is_utf8 \"\")"),
        ("String.length t <= 9", "String.length t <= 10"),
        ("(t = \"0\" || t.[0] <> '0')", "true"),
    ],
)  # fmt: skip
def test_a_laxer_reader_is_seen(line: str, other: str, tmp_path: Path) -> None:
    text = SOURCE.read_text()
    assert text.count(line) == 1
    program = compiled(tmp_path, text.replace(line, other))
    assert disagreements(program, pieces())


def test_the_checker_refuses_escapes_with_other_signs() -> None:
    with pytest.raises(check.Malformed):
        check.parsed("document", rb'"\u0_41"', anything)
