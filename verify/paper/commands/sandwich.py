"""The job `sandwich`: collapse below an endless orbit of a map of two numbers, for every state."""

from __future__ import annotations

from functools import cache

from verify.paper.outside.outside import outside
from verify.paper.sandwich.sandwich import sandwich
from verify.prover.arguments import write_down
from verify.prover.outcome import Outcome
from verify.wire.judge import judged


@cache
def decide_sandwich() -> Outcome:
    """The theorem, each line with the proof that its reason describes."""
    return judged(write_down(sandwich()))


@cache
def decide_outside() -> Outcome:
    """The other half: above an orbit of such a map that ends, collisions in turn end."""
    return judged(write_down(outside()))
