"""Which statements are the program's own."""

from __future__ import annotations

import json
from functools import cache

import pytest

from tests.points import parameters
from verify.jobs import spectrum, step
from verify.jobs.regenerate import is_right_statement
from verify.jobs.theorem1 import decide_point
from verify.wire.write import encode, write


@cache
def statement(selection: str = "repaired", r: str = "3/100") -> bytes:
    return write(decide_point(parameters(r, "1"), selection))["statement.json"]


def test_the_programs_own() -> None:
    assert is_right_statement(statement())
    assert is_right_statement(statement("all"))
    assert is_right_statement(write(spectrum.decide_spectrum())["statement.json"])
    assert is_right_statement(write(step.decide_step())["statement.json"])


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
