"""What people and scripts see of the text outside the proof of Theorem 1 and the spectrum."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from verify.language.statement import NEEDED, PROVED, REFUTED, Obligation
from verify.language.terms import symbol
from verify.language.typeset import Typesetter
from verify.paper.numbering import cited
from verify.prover.outcome import Decision, Outcome
from verify.views.document import claims_document
from verify.views.words import groups, letters, summary, taken_on_trust, witness_of

FORMAT = "verify-elsewhere/1"


def screen(outcome: Outcome) -> Iterator[str]:
    """How many rows each part has, what is false and where, and what is taken on trust."""
    typesetter = letters(outcome)
    yield "What the paper prints outside the proof of Theorem 1 and the spectrum"
    for group in groups(outcome):
        yield ""
        rows = outcome.of_group(group)
        found = [decision for row, decision in rows if row.role == NEEDED]
        proved = sum(decision.verdict == PROVED for decision in found)
        heading = group[0].upper() + group[1:]
        yield f"{heading:<36} {proved} of {len(found)} rows proved"
        for row, decision in rows:
            if decision.verdict == REFUTED:
                yield from _false(row, decision, typesetter)
    yield ""
    yield "Every row: -v; one with its proof: explain NAME"
    yield ""
    yield from taken_on_trust(outcome)
    yield ""
    yield f"Verdict: {summary(outcome)}"


def _false(row: Obligation, decision: Decision, typesetter: Typesetter) -> Iterator[str]:
    at = witness_of(row, decision).items()
    values = (f"{typesetter.term(symbol(name))} = {typesetter.term(term)}" for name, term in at)
    yield f"  refuted   {row.name}, {cited(row.label)}"
    yield f"            {row.says}"
    if decision.witness:
        yield f"            false at {', '.join(values)}"
    yield f"            {row.severity}; corrected by {row.corrected_by}"


def elsewhere_document(outcome: Outcome) -> dict[str, Any]:
    """The outcome as one JSON document."""
    return claims_document(outcome, "elsewhere", FORMAT)
