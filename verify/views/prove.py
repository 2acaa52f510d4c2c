"""What people and scripts see of a statement of anybody's, decided."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from verify.language.statement import UNDECIDED, Obligation
from verify.language.terms import Claim, symbol
from verify.language.typeset import Typesetter
from verify.prover.decimals import decimal_text, people, round_decimal, short
from verify.prover.outcome import Decision, Ends, Outcome
from verify.publication import Publication
from verify.views import words
from verify.views.enclosures import exactly

FORMAT = "verify-prove/1"


def decided_lines(outcome: Outcome, paper: Publication, *, numbers: bool = False) -> Iterator[str]:
    """A line for each row, one for each assumption, and the verdict.

    With ``numbers`` there are also enclosures of constants and of both sides of each row.
    """
    typesetter, outcome = words.letters(outcome), exactly(outcome)
    if numbers:
        yield from _constants(outcome, typesetter)
    for row, found in outcome.rows:
        line = (
            f"{found.verdict:<9} {row.name}  {words.sentence(row, typesetter).removeprefix(': ')}"
        )
        if found.verdict != UNDECIDED:
            line += f"   by {found.method}"
        elif found.reason:
            line += f"   because {found.reason}"
        if found.witness:
            line += f", false at {words.values_told(dict(found.witness), typesetter)}"
        yield line
        if numbers:
            yield from _numbers(row, found)
    for assumption in outcome.assumptions:
        yield f"assumed   {assumption.name}  {assumption.sentence}"
    if outcome.spent:
        yield f"undecided: {outcome.spent}"
    yield f"Verdict: {words.summary(outcome, paper)}"


def _constants(outcome: Outcome, typesetter: Typesetter) -> Iterator[str]:
    for name, enclosure in outcome.enclosures.items():
        yield f"{typesetter.term(symbol(name))} = {short(enclosure.ends[0])}"


def _numbers(row: Obligation, found: Decision) -> Iterator[str]:
    """What is known of a row in numbers: for which values it is claimed, and its two sides."""
    sides = words.sides_of(row, found)
    if row.context is not None:
        yield f"  for all values of {row.context}"
    if sides is not None and isinstance(row.claim, Claim):
        left, right = sides
        yield f"  {words.sides_named(left, right)}, at {found.bits or '-'} bits"
        yield f"  {_difference((right[0] - left[1], right[1] - left[0]))}"
    if found.verdict != UNDECIDED:
        yield f"  shown by the rule {found.method}, judged by {found.judge}"
    if row.uses:
        yield f"  given {', '.join(row.uses)}"


def _difference(ends: Ends) -> str:
    """Which side is larger, and by how much, as far as the ends of their difference tell."""
    low, high = ends
    if low > 0:
        return f"the right side is larger by {short(ends)}"
    if high < 0:
        return f"the right side is smaller by {short((-high, -low))}"
    if low == high:
        return "both sides are equal"
    most = decimal_text(*round_decimal(max(-low, high), 3, up=True))
    return f"the sides differ by at most {people(most)}"


def _values(found: Decision, typesetter: Typesetter) -> dict[str, str]:
    """The values of a witness, all of which the givens need."""
    from verify.views.document import value_text  # loaded only where it is used

    return {name: value_text(term, typesetter) for name, term in found.witness.items()}


def decided_document(outcome: Outcome) -> dict[str, Any]:
    """The outcome as one JSON document."""
    from verify.views.document import (  # loaded only where they are used
        assumption_document,
        cite_document,
        row_document,
    )

    typesetter = words.letters(outcome)
    return {
        "format": FORMAT,
        "command": "prove",
        "verdict": outcome.verdict,
        "headline": words.headline(outcome),
        "theorem": outcome.statement.title,
        "assumptions": [assumption_document(a) for a in outcome.assumptions],
        "cites": [cite_document(cite) for cite in outcome.statement.cites],
        "obligations": [
            row_document(outcome, row, found, typesetter)
            | {"reason": found.reason or None}
            | ({"witness": _values(found, typesetter)} if found.witness else {})
            for row, found in outcome.rows
        ],
        "spent": outcome.spent or None,
    }
