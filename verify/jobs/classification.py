"""The job `classification`: the four theorems, and what they say at one r."""

from __future__ import annotations

from functools import cache

from verify.jobs.arguments import write_down
from verify.paper.classification.theorem import classification
from verify.prover.outcome import Outcome


@cache
def decide() -> Outcome:
    """The theorems, each line with the proof that its reason describes."""
    return write_down(classification())
