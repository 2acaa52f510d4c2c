"""What people and scripts see of a statement of anybody's, decided."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from verify.language.statement import UNDECIDED, Publication
from verify.language.terms import symbol
from verify.prover.outcome import Outcome
from verify.views.document import assumption_document, cite_document, row_document
from verify.views.words import headline, letters, sentence, summary, witness_of

FORMAT = "verify-prove/1"


def decided_lines(outcome: Outcome, paper: Publication) -> Iterator[str]:
    """A line for each row, one for each assumption, and the verdict."""
    typesetter = letters(outcome)
    for row, found in outcome.rows:
        line = f"{found.verdict:<9} {row.name}  {sentence(row, typesetter).removeprefix(': ')}"
        if found.verdict != UNDECIDED:
            line += f"   by {found.method}"
        elif found.reason:
            line += f"   because {found.reason}"
        if found.witness:
            values = witness_of(row, found).items()
            at = (f"{typesetter.term(symbol(n))} = {typesetter.term(t)}" for n, t in values)
            line += f", false at {', '.join(at)}"
        yield line
    for assumption in outcome.assumptions:
        yield f"assumed   {assumption.name}  {assumption.sentence}"
    if outcome.spent:
        yield f"undecided: {outcome.spent}"
    yield f"Verdict: {summary(outcome, paper)}"


def decided_document(outcome: Outcome) -> dict[str, Any]:
    """The outcome as one JSON document."""
    typesetter = letters(outcome)
    return {
        "format": FORMAT,
        "command": "prove",
        "verdict": outcome.verdict,
        "headline": headline(outcome),
        "theorem": outcome.statement.title,
        "assumptions": [assumption_document(a) for a in outcome.assumptions],
        "cites": [cite_document(cite) for cite in outcome.statement.cites],
        "obligations": [
            row_document(outcome, row, found, typesetter) | {"reason": found.reason or None}
            for row, found in outcome.rows
        ],
        "spent": outcome.spent or None,
    }
