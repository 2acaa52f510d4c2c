"""The job `step`: one step of the recursion, for every state and all numbers with the rows."""

from __future__ import annotations

from functools import cache

from verify.paper.step.step import step
from verify.prover.arguments import write_down
from verify.prover.outcome import Outcome
from verify.wire.judge import judged


@cache
def decide_step() -> Outcome:
    """The step, each line with the proof that its reason describes."""
    return judged(write_down(step()))
