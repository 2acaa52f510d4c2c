"""Criteria for finitely many collisions, decided in balls.

What the last moment does not show the start may. A criterion about the time of a collapse would add
nothing: once that time has passed, R² >= 2 and A >= 0.
"""

from __future__ import annotations

from verify.language.record import Record
from verify.prover import balls
from verify.spheres.flow.follow import Flow
from verify.spheres.flow.law import Number, State
from verify.spheres.scene.criteria import (
    INELASTIC,
    RECEDING,
    TURNING,
    Spread,
    Whole,
    inelastic,
    spread,
    turning,
    whole,
)
from verify.spheres.scene.scene import FIRST_FRAMES, Frame


class Criterion(Record):
    """A criterion that holds, of the last moment or already at the start."""

    name: str
    at_start: bool


def finitely_many(flow: Flow) -> Criterion | None:
    """A criterion that holds, if any."""
    if flow.scene.has_one_mass and inelastic(flow.r) < 0:
        return Criterion(INELASTIC, at_start=True)
    name = _at(flow, FIRST_FRAMES[0], flow.start.state(FIRST_FRAMES[0], flow.keep))
    if name is not None:
        return Criterion(name, at_start=True)
    name = None if flow.now is None else _at(flow, flow.now.frame, flow.now.state)
    return None if name is None else Criterion(name, at_start=False)


def _at(flow: Flow, frame: Frame, state: State) -> str | None:
    bodies = flow.scene.bodies
    if bodies is None:
        now: Whole | Spread = whole(state)
        most: Number = 2
    else:
        now = spread(state, frame, bodies, balls.exact)
        most = now.touching
    if not now.R2 >= most:
        return None
    if now.A >= 0:
        return RECEDING
    return TURNING if turning(now) > 0 else None
