"""The job `sharper`: the sharper theorem, for every state that satisfies its inequalities."""

from __future__ import annotations

from functools import cache

from verify.jobs.acceptance import judged
from verify.jobs.arguments import write_down
from verify.paper.sharper.theorem import sharper
from verify.prover.outcome import Outcome


@cache
def decide_sharper() -> Outcome:
    """The theorem, each line with the proof that its reason describes."""
    return judged(write_down(sharper()))
