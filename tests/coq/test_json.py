"""The extracted program reads JSON as strictly as the checker, and finds the same digests.

It is compiled where there is Coq.
"""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from tests.coq.fuzz import ROOT, anything, broken, compiled, disagreements, pieces, wanted
from verify import check

needs_coq = pytest.mark.skipif(
    not (shutil.which("coqc") and shutil.which("ocamlfind")), reason="there is no Coq here"
)


@pytest.fixture(scope="module")
def directory(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("extracted")


@needs_coq
def test_both_read_the_same_of_broken_documents(directory: Path) -> None:
    found = [*broken(1000)]
    accepted = sum(wanted(data) is not None for data in found)
    assert len(found) / 4 < accepted < len(found) * 3 / 4
    assert disagreements(compiled(directory), found) == []


@needs_coq
def test_both_find_the_same_digests_at_each_length(directory: Path) -> None:
    program = compiled(directory)
    assert disagreements(program, [b"[" + b" " * n + b"]" for n in range(200)]) == []


@needs_coq
@pytest.mark.parametrize(
    ("line", "other"),
    [
        ("if distinct PositiveSet.empty l then Some (JObj l, rest) else None",
         "Some (JObj l, rest)"),
        ("value 100 (skip s)", "value 101 (skip s)"),
        ("between 65 70 b", "between 65 95 b"),
        ("(n <=? 0xdbff)", "(n <=? 0xd7ff)"),
        ("else if 32 <=? Byte.to_N b", "else if 1 <=? Byte.to_N b"),
        ("if utf8 s then", "if utf8 [] then"),
        ("digits 8", "digits 9"),
        ("if Byte.eqb b \"0\"%byte then Some (0, rest)", "if false then Some (0, rest)"),
        ("(0x800 <=? n) && negb", "negb"),
        ("if at_most most_bytes s then", "if at_most (most_bytes + 1) s then"),
    ],
)  # fmt: skip
def test_a_laxer_reader_is_seen(line: str, other: str, directory: Path) -> None:
    texts = [(ROOT / f"verify/coq/{name}.v").read_text() for name in ("Json", "ReadJson")]
    assert sum(text.count(line) for text in texts) == 1
    longest = b"[" + b" " * (check.MAX_BYTES - 1) + b"]"
    found = pieces() + [longest] * ("most_bytes" in line)
    assert disagreements(compiled(directory, line, other), found)


def test_the_checker_refuses_escapes_with_other_signs() -> None:
    with pytest.raises(check.Malformed):
        check.parsed("document", rb'"\u0_41"', anything)
