"""The job `elsewhere`: what the paper prints outside the proof of Theorem 1 and the spectrum."""

from __future__ import annotations

from verify.language.terms import Claim
from verify.paper.commands.pages import decide
from verify.prover.outcome import Outcome
from verify.prover.proof import Premise
from verify.prover.rules import Interval, Sum


def decide_elsewhere() -> Outcome:
    """Every line with the proof that its reason describes, every misprint with its point."""
    return decide("sections_1_to_4")


def premise(claim: Claim, bits: int) -> Premise:
    """Why a given holds at a point: equations identically, between rational numbers."""
    return Sum() if claim.relation == "=" else Interval(bits)
