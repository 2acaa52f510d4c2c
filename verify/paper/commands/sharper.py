"""The job `sharper`: the sharper theorem, for every state that satisfies its inequalities."""

from __future__ import annotations

from functools import cache

from verify.paper.sharper.sharper import sharper
from verify.prover.arguments import write_down
from verify.prover.outcome import Outcome
from verify.wire.judge import judged


@cache
def decide_sharper() -> Outcome:
    """The theorem, each line with the proof that its reason describes."""
    return judged(write_down(sharper()))
