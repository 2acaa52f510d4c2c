"""The displays of the paper, copied as LaTeX, are the terms of the program."""

from __future__ import annotations

import operator
import re
from collections.abc import Iterator
from pathlib import Path

import pytest
import sympy

from tests.paper.spectrum.test_rows import to_sympy
from verify.language.terms import Term
from verify.paper.commands.spectrum import state_spectrum
from verify.paper.spectrum import characteristic, collision_matrices, cone, printed, real_root

SYMBOLS = {name: sympy.Symbol(name, real=True) for name in ("r", "x", "y", "t", "lambda")}
TOKEN = re.compile(r"\\[a-z]+|[0-9]+|[a-z]|\S")

ROWS = {row.name: row for row in state_spectrum().obligations}
X = cone.bound_x(cone.x, cone.y - cone.t)
Z = cone.bound_z(cone.x, cone.y - cone.t)


def side(name: str) -> tuple[tuple[Term, ...], ...]:
    return ((ROWS[name].claim.rhs,),)


TRANSCRIBED = {
    "matrix": printed.MATRIX,
    "A_a": collision_matrices.A_A,
    "A_b": collision_matrices.A_B,
    "A_c": collision_matrices.A_C,
    "matrix in the appendix": printed.MATRIX,
    **{f"determinant {k}": m for k, m in enumerate(characteristic.DETERMINANTS, 1)},
    "Q": ((printed.Printed().q(characteristic.lam),),),
    "lambda_c": ((real_root.lambda_c,),),
    "minimum, expanded": side("Q-prime-expanded"),
    "minimum, factored": side("Q-prime-factored"),
    "bound of x, first": ((X[0],),),
    "bound of x, second": ((X[1],),),
    "bound of z, first": ((Z[0],),),
    "bound of z, second": ((Z[1],),),
    "Q(-r)": side("Q-minus-r"),
    "Q(-r), factored": side("Q-minus-r-factored"),
    "Q(-r^3)": side("Q-minus-r3"),
    "Q(-r^3), factored": side("Q-minus-r3-factored"),
}


def displays() -> Iterator[tuple[str, str]]:
    text = (Path(__file__).parent / "displays.tex").read_text()
    for part in text.split("%% ")[1:]:
        name, _, body = part.partition("\n")
        yield name, body


class Reader:
    """A reader of the few LaTeX constructions that the displays use."""

    def __init__(self, text: str) -> None:
        skipped = (r"\left", r"\right", r"\cdotp")
        self.tokens = [token for token in TOKEN.findall(text) if token not in skipped]

    def take(self) -> str:
        return self.tokens.pop(0)

    def sum(self) -> sympy.Expr:
        total = sympy.Integer(0)
        sign = 1
        while self.tokens and self.tokens[0] not in "])}":
            if self.tokens[0] in "+-":
                sign = 1 if self.take() == "+" else -1
            total += sign * self.product()
        return total

    def product(self) -> sympy.Expr:
        value = self.power()
        while self.tokens and self.tokens[0] not in "+-)]}":
            if self.tokens[0] == r"\cdot":
                self.take()
            value *= self.power()
        return value

    def power(self) -> sympy.Expr:
        base = self.atom()
        if self.tokens and self.tokens[0] == "^":
            self.take()
            return base ** int(self.take())
        return base

    def atom(self) -> sympy.Expr:
        token = self.take()
        if token in "([{":
            value = self.sum()
            self.take()
            return value
        if token == r"\frac":
            return operator.truediv(self.atom(), self.atom())
        if token == r"\sqrt":
            return sympy.sqrt(self.atom())
        if token.isdigit():
            return sympy.Integer(token)
        return SYMBOLS[token.removeprefix("\\")]


@pytest.mark.parametrize(("name", "text"), list(displays()), ids=lambda x: x[:24])
def test_a_display_is_its_term(name: str, text: str) -> None:
    lines = [line.split("&") for line in text.strip().split("\\\\\n")]
    terms = TRANSCRIBED[name]
    assert [len(line) for line in lines] == [len(row) for row in terms]
    for line, row in zip(lines, terms, strict=True):
        for entry, term in zip(line, row, strict=True):
            assert sympy.expand(Reader(entry).sum() - to_sympy(term, SYMBOLS)) == 0


def test_every_transcribed_object_is_compared() -> None:
    assert {name for name, _ in displays()} == set(TRANSCRIBED)
