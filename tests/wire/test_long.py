"""Texts of about 100 kB in which something is repeated are read, or refused, at once."""

from __future__ import annotations

import time
from pathlib import Path

import pytest

from verify.cli import main

DIGITS = "1" * 95_000
FILES = {
    "digits.smt2": f"(assert (< {DIGITS}x 0))",
    "digits.fpcore": f"(FPCore (x) :pre (<= 0 x 1) {DIGITS}x)",
    "index.toml": 'title = "t"\n[constants]\n"x' + "₁" * 30_000 + 'y" = "1"\n[rows]\nr = "1 < 2"',
    "parameters.toml": 'title = "t"\n[let]\n"f(' + "a, " * 30_000 + 'a" = "1"\n[rows]\nr = "1 < 2"',
    "names.smt2": f"(declare-const {'a' * 45_000} Real)(assert (< {'a' * 45_000}b 0))",
    "variables.toml": "title = 't'\n[contexts.c]\nvariables = '" + "x " * 40_000 + "'",
    "letters.toml": "title = 't'\n[contexts.c]\nvariables = 'x: α, x: β'\nrows = { r = '0 < 1' }",
    "listed.toml": "title = 't'\n[contexts.c]\nvariables = ['x', 'x']\nrows = { r = '0 < 1' }",
}


@pytest.mark.parametrize("name", FILES)
def test_a_long_text_is_refused_at_once(
    name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / name
    path.write_text(FILES[name])
    begin = time.process_time()
    assert main(["prove", str(path)]) == 2
    assert time.process_time() - begin < 2
    out, err = capsys.readouterr()
    assert (out, err.count("\n")) == ("", 1)
    assert len(err) < 700
