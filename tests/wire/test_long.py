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


SUM = " + ".join(["x"] * 600)
CONTEXT = '[contexts.c]\nvariables = "x"\ngiven = ["0 < x", "x < 1"'
LONG = {
    "given": f'{CONTEXT}, "{SUM} < 1000"]\n[rows]\nr = "x < 2"',
    "row": f'{CONTEXT}]\n[rows]\nr = "{SUM} < 600"',
    "signs": f'{CONTEXT}]\n[rows]\nr = "{SUM.replace("+", "-")} = -598*x"',
    "root": f'[contexts.c]\nvariables = "x"\nroot = "{SUM} - 1"\nbetween = ["0", "1"]'
    '\n[rows]\nr = "x < 2"',
    "product": f'[constants]\na = "{"*".join(f"(1 + 1/{k}^2)" for k in range(1, 300))}"\n'
    '[rows]\nr = "3.66 < a"\ns = "a < 3.67"',
    "with quotients": f'[constants]\na = "{"/".join(["*".join(["2"] * 200)] * 2)}"\n'
    '[rows]\nr = "a = 2^398"',
    "constant": f'[constants]\na = "{SUM.replace("x", "sqrt(2)")}"\n[rows]\nr = "a < 849"',
}


@pytest.mark.parametrize("text", LONG.values(), ids=LONG)
def test_a_long_sum_or_product_is_a_tree_of_small_height(text: str, tmp_path: Path) -> None:
    path = tmp_path / "p.toml"
    path.write_text(f'title = "t"\n{text}')
    assert main(["prove", str(path)]) == 0


def test_a_long_sum_of_quotients_in_smtlib(tmp_path: Path) -> None:
    parts = " ".join(f"(/ x {n})" for n in range(1, 2001))
    for sign, code in (("<", 0), (">", 1)):
        path = tmp_path / "p.smt2"
        path.write_text(f"(declare-const x Real)(assert (> x 0))(assert ({sign} (+ {parts}) 0))")
        path.write_text(path.read_text() + "(check-sat)")
        assert main(["prove", str(path)]) == code


@pytest.mark.parametrize("product", ["*".join(["x"] * 600), "sqrt(1 + " * 90 + "x" + ")" * 90])
def test_what_nests_too_deeply_in_a_given_is_refused(
    product: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "p.toml"
    path.write_text(f'title = "t"\n{CONTEXT}, "{product} + {product} < 9"]\n[rows]\nr = "x < 2"')
    assert main(["prove", str(path)]) in (0, 2)
    assert "our own" not in capsys.readouterr().err


def test_contexts_nest_as_deeply_as_the_checker_reads(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    text = 'title = "t"\n'
    for n in range(101):
        around = f'in = "c{n - 1}"\n' if n else ""
        text += f'[contexts.c{n}]\nvariables = "x{n}"\ngiven = "0 < x{n} < 1"\n{around}'
        if n > 98:
            path = tmp_path / f"{n}.toml"
            path.write_text(f'{text}[rows]\nr = "x{n} < 2"')
            assert main(["prove", str(path)]) == (0 if n < 100 else 2)
    assert "contexts.c100: it is inside of 100 contexts" in capsys.readouterr().err
