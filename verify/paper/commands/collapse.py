"""The jobs `sharper`, `sandwich` and `outside`: from which states the collisions never end."""

from __future__ import annotations

from functools import cache

from verify.paper.commands.pages import decide
from verify.prover.outcome import Outcome


@cache
def decide_sharper() -> Outcome:
    """The theorem, each line with the proof that its reason describes."""
    return decide("sharper")


@cache
def decide_sandwich() -> Outcome:
    """The theorem, each line with the proof that its reason describes."""
    return decide("sandwich_below")


@cache
def decide_outside() -> Outcome:
    """The other half: above an orbit of such a map that ends, collisions in turn end."""
    return decide("sandwich_above")
