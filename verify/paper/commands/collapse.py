"""The jobs `sharper`, `sandwich`, `outside` and `three-balls`: which collisions never end."""

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


@cache
def decide_three_balls() -> Outcome:
    """The theorem for any masses, radii and two coefficients of restitution."""
    return decide("three_balls")
