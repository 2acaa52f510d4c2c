"""The jobs `sharper`, `sandwich` and `outside`: from which states the collisions never end."""

from __future__ import annotations

from functools import cache

from verify.paper.outside.outside import outside
from verify.paper.sandwich.sandwich import sandwich
from verify.paper.sharper.sharper import sharper
from verify.prover.arguments import write_down
from verify.prover.outcome import Outcome
from verify.wire.judge import judged


@cache
def decide_sharper() -> Outcome:
    """The theorem, each line with the proof that its reason describes."""
    return judged(write_down(sharper()))


@cache
def decide_sandwich() -> Outcome:
    """The theorem, each line with the proof that its reason describes."""
    return judged(write_down(sandwich()))


@cache
def decide_outside() -> Outcome:
    """The other half: above an orbit of such a map that ends, collisions in turn end."""
    return judged(write_down(outside()))
