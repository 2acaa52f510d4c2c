"""Until the collision, and at its instant, no other pair of particles is in contact."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from verify.language.argument import BySum, Chapter, Line, plus, scaled, square, times
from verify.language.vectors import Combination, add, omega_c, omega_s, scale
from verify.paper.dynamics.apart import colliding, contexts, opened, spectator, t
from verify.paper.dynamics.state import b, d, difference, frame, y

dot = frame.dot


def chapters() -> Iterator[Chapter]:
    """The three pairs."""
    before, meanwhile = contexts()
    yield opened()
    yield Chapter(before.name, tuple(colliding()))
    yield Chapter(meanwhile.name, (spectator(), _outer_pair()))


def _outer_pair() -> Line:
    outer: Combination = add(add(scale(1 + d, omega_c), scale(-1, omega_s)), scale(t, difference))
    return Line("outer-pair-apart", 1 < dot(outer, outer), _outer_reason(),
                "EQUATSS4.1Recurrence_CndT",
                "the outer pair s-c is apart for all times from 0 to τ, both included")  # fmt: skip


def _outer_reason() -> BySum:
    v0, speed = "V_0-positive", "speed-positive"
    together = plus(
        times(2, "C-positive", "d-sum-positive"),
        times(2, "d-positive"),
        square(d - t * (y + b)),
        times(square(t), "cs-outer"),
        times(2, "t-lower", plus("y-upper", "a-upper", "b-upper", "recedes")),
        times(6, "t-upper", speed),
    )
    return scaled(
        times(v0, "goal"),
        times(v0, together),
        times(6, speed, "time-crude"),
        times(12, speed, "y-bound"),
        times(Fraction(12, 7), "time-short"),
        times(Fraction(12, 7), v0, "root-two-upper"),
    )
