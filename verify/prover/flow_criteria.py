"""Criteria for finitely many collisions, decided in balls."""

from __future__ import annotations

from fractions import Fraction

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
    """A criterion that holds; squares is max(R², 2) at the start, rounded up."""

    name: str
    squares: Fraction = Fraction(2)


def finitely_many(flow: Flow) -> Criterion | None:
    """A criterion that holds at the last moment of a flow, if any."""
    if is_inelastic_enough(flow.r) < 0:
        return Criterion(INELASTIC)
    start = whole(flow.start.state(FIRST_FRAMES[0], flow.keep))
    if flow.now is None:
        return _at(start)
    found = _at(whole(flow.now.state))
    return found or _late(start, flow.now.time)


def _at(now: Whole) -> Criterion | None:
    if now.R2 >= 2 and now.A >= 0:
        return Criterion(RECEDING)
    if now.R2 >= 2 and now.A**2 * now.R2 < (now.R2 - 2) * now.L2:
        return Criterion(TURNING)
    return None


def _late(start: Whole, time: object) -> Criterion | None:
    """Whether the time is beyond the last one at which the start allows a collapse."""
    squares = max(balls.rational_above(start.R2, 30), Fraction(2))
    most = balls.exact(squares)
    if not start.L2 > 0 or not start.A**2 + (2 - start.R2) * start.L2 / most > 0:
        return None
    return Criterion(LATE, squares) if latest(start, most, balls.any_root) < time else None
