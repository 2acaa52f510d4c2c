"""The job `elsewhere`: what the paper prints outside the proof of Theorem 1 and the spectrum."""

from __future__ import annotations

from verify.paper.commands.pages import decide
from verify.prover.outcome import Outcome


def decide_elsewhere() -> Outcome:
    """Every line with the proof that its reason describes, every misprint with its point."""
    return decide("sections_1_to_4")
