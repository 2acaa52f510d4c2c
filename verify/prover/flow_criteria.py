"""Criteria for finitely many collisions, decided in balls."""

from __future__ import annotations

from verify.language.record import Record
from verify.paper.scene.criteria import (
    INELASTIC,
    LATE,
    RECEDING,
    TURNING,
    Whole,
    is_inelastic_enough,
    latest,
    whole,
)
from verify.prover import balls
from verify.prover.flow import FIRST_FRAMES, Flow


class Criterion(Record):
    """A criterion that holds, and the three numbers for which it does."""

    name: str
    numbers: Whole | None = None


def finitely_many(flow: Flow) -> Criterion | None:
    """A criterion that holds at the last moment of a flow, if any."""
    if is_inelastic_enough(flow.r) < 0:
        return Criterion(INELASTIC)
    start = whole(flow.start.state(FIRST_FRAMES[0], flow.keep))
    if flow.now is None:
        return _at(start)
    found = _at(whole(flow.now.state))
    return found or (Criterion(LATE, start) if _is_late(start, flow.now.time) else None)


def _at(now: Whole) -> Criterion | None:
    if now.R2 >= 2 and now.A >= 0:
        return Criterion(RECEDING, now)
    if now.R2 >= 2 and now.A**2 * now.R2 < (now.R2 - 2) * now.L2:
        return Criterion(TURNING, now)
    return None


def _is_late(start: Whole, time: object) -> bool:
    """Whether the time is beyond the last one at which the start allows a collapse."""
    squares = balls.larger(start.R2, 2)
    if not start.L2 > 0 or not start.A**2 + (2 - start.R2) * start.L2 / squares > 0:
        return False
    return bool(latest(start, squares, balls.any_root) < time)
