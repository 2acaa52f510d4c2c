"""Criteria for finitely many collisions, decided in balls.

What the last moment does not show the start may. A criterion about the time of a collapse would add
nothing: once that time has passed, R² >= 2 and A >= 0.
"""

from __future__ import annotations

from verify.language.record import Record
from verify.spheres.flow.follow import Flow
from verify.spheres.flow.law import State
from verify.spheres.scene.criteria import INELASTIC, RECEDING, TURNING, inelastic, turning, whole
from verify.spheres.scene.scene import FIRST_FRAMES


class Criterion(Record):
    """A criterion that holds, of the last moment or already at the start."""

    name: str
    at_start: bool


def finitely_many(flow: Flow) -> Criterion | None:
    """A criterion that holds, if any."""
    if inelastic(flow.r) < 0:
        return Criterion(INELASTIC, at_start=True)
    name = _at(flow.start.state(FIRST_FRAMES[0], flow.keep))
    if name is not None:
        return Criterion(name, at_start=True)
    name = None if flow.now is None else _at(flow.now.state)
    return None if name is None else Criterion(name, at_start=False)


def _at(state: State) -> str | None:
    now = whole(state)
    if not now.R2 >= 2:
        return None
    if now.A >= 0:
        return RECEDING
    return TURNING if turning(now) > 0 else None
