"""An outcome as a notebook shows it: a table of its constants and rows, with their formulas."""

from __future__ import annotations

from collections.abc import Iterator
from html import escape

from verify.language.statement import UNDECIDED, Constant, Obligation
from verify.language.terms import Claim, symbol
from verify.prover.decimals import short
from verify.prover.outcome import Decision, Outcome
from verify.views import words
from verify.views.enclosures import exactly
from verify.views.mathml import MathML


def notebook_page(outcome: Outcome) -> str:
    """HTML with MathML, and with no style or script of its own."""
    return "\n".join(_lines(exactly(outcome)))


def _lines(outcome: Outcome) -> Iterator[str]:
    math = MathML(words.letters_and_tex(outcome)[1])
    statement = outcome.statement
    yield f"<p><b>{escape(statement.title)}</b>: {escape(words.headline(outcome))}</p>"
    if statement.constants:
        yield from _table(_constant(one, outcome, math) for one in statement.constants)
    yield from _table(_row(row, found, outcome, math) for row, found in outcome.rows)
    if outcome.spent:
        yield f"<p>undecided: {escape(outcome.spent)}</p>"
    for assumption in outcome.assumptions:
        name, sentence = escape(assumption.name), escape(assumption.sentence)
        yield f"<p>assumed: {name}: {sentence}</p>"


def _table(rows: Iterator[tuple[str, ...]]) -> Iterator[str]:
    yield "<table>"
    for cells in rows:
        yield "<tr>" + "".join(f"<td>{cell}</td>" for cell in cells) + "</tr>"
    yield "</table>"


def _constant(constant: Constant, outcome: Outcome, math: MathML) -> tuple[str, ...]:
    ends = words.ends_of(outcome, constant.name)
    value = "" if ends is None else escape(short(ends))
    return math.term(symbol(constant.name)), math.term(constant.term, "="), value


def _row(row: Obligation, found: Decision, outcome: Outcome, math: MathML) -> tuple[str, ...]:
    typesetter = words.letters(outcome)
    if isinstance(row.claim, Claim):
        claim = math.claim(row.claim)
    else:
        claim = escape(typesetter.claim(row.claim))
    if row.context is not None:
        claim += f" for all values of {escape(row.context)}"
    how = f"by {found.method}" if found.method and found.verdict != UNDECIDED else found.reason
    sides = words.sides_of(row, found)
    if sides is not None:
        how += f"; {words.sides_named(*sides)}"
    if found.witness:
        how += f"; at {words.values_told(words.witness_of(row, found), typesetter)}"
    return escape(row.name), claim, f"<b>{escape(found.verdict)}</b>", escape(how)
