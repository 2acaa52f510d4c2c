"""The displays of the paper, copied as LaTeX, are the terms of the page."""

from __future__ import annotations

import operator
import re
from collections.abc import Iterator
from pathlib import Path

import pytest
import sympy

from tests.paper.spectrum.page import table, terms
from tests.paper.spectrum.test_rows import to_sympy
from verify.language.terms import Term
from verify.paper.commands.spectrum import state_spectrum

SYMBOLS = {name: sympy.Symbol(name, real=True) for name in ("r", "x", "y", "t", "lambda")}
TOKEN = re.compile(r"\\[a-z]+|[0-9]+|[a-z]|\S")

ROWS = {row.name: row for row in state_spectrum().obligations}


def side(name: str) -> tuple[tuple[Term, ...], ...]:
    return ((ROWS[name].claim.rhs,),)


def one(formula: str) -> tuple[tuple[Term, ...], ...]:
    return (terms(formula),)


TRANSCRIBED = {
    "matrix": table("A(r)"),
    "A_a": table("A_a(r)"),
    "A_b": table("A_b(r)"),
    "A_c": table("A_c(r)"),
    "matrix in the appendix": table("A(r)"),
    **{f"determinant {k}": table(f"D_{k}") for k in range(1, 5)},
    "Q": one("Q(lambda, r)"),
    "lambda_c": one("lambda_c(r)"),
    "minimum, expanded": side("Q-prime-expanded"),
    "minimum, factored": side("Q-prime-factored"),
    "bound of x, first": one("bound_x_1(x, y - t, r)"),
    "bound of x, second": one("bound_x_2(x, y - t, r)"),
    "bound of z, first": one("bound_z_1(x, y - t, r)"),
    "bound of z, second": one("bound_z_2(x, y - t, r)"),
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
