"""What people and scripts see of the text outside the proof of Theorem 1 and the spectrum."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from verify.language.statement import Publication
from verify.prover.outcome import Outcome
from verify.views.document import claims_document
from verify.views.row_lists import MORE, brief
from verify.views.words import summary

FORMAT = "verify-elsewhere/1"


def screen(outcome: Outcome, paper: Publication) -> Iterator[str]:
    """How many rows each part has, what is false, and what is taken on trust."""
    yield "What the paper prints outside the proof of Theorem 1 and the spectrum"
    yield ""
    yield from brief(outcome, paper)
    yield MORE
    yield ""
    yield f"Verdict: {summary(outcome, paper)}"


def elsewhere_document(outcome: Outcome) -> dict[str, Any]:
    """The outcome as one JSON document."""
    return claims_document(outcome, "elsewhere", FORMAT)
