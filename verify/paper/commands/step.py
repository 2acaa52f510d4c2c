"""The jobs `step` and `step-printed`: one step of the recursion, for every state and all numbers.

`step-printed` is what the recursion prints and is false, each at a state of its own.
"""

from __future__ import annotations

from verify.paper.commands.pages import decide
from verify.prover.outcome import Outcome


def decide_step() -> Outcome:
    """The step, each line with the proof that its reason describes."""
    return decide("step")


def decide_step_printed() -> Outcome:
    """Every row with its proof, or the state that refutes it; the checker decides whether."""
    return decide("step_as_printed")
