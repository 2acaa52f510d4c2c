"""From one collision to the next: sizes, the time between them, and the next distance.

Until the collision, and at its instant, no other pair of particles is in contact.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from verify.language.argument import (
    ByRoot,
    Chapter,
    Item,
    Line,
    Value,
    plus,
    power,
    proof,
    scaled,
    square,
    times,
)
from verify.language.terms import as_term, sqrt
from verify.language.vectors import add, omega_c, omega_s, scale
from verify.paper.dynamics import laws
from verify.paper.dynamics.apart import colliding, contexts, opened, spectator, t
from verify.paper.dynamics.laws import DISTANCE, TIME
from verify.paper.dynamics.state import CONTEXT, A, B, D, S, d, difference, frame, tau, y, zeta
from verify.paper.parameters import THEOREM
from verify.paper.sharper.state import (
    V_0,
    T,
    V,
    eta_0,
    g,
    k,
    least_ratio,
    reach,
    root,
    speed,
    zeta_small,
)

SLOWER = times("gain-positive", "g-positive")


def lines() -> Iterator[Item]:
    """Everything about the time tau between the two collisions, and d_next."""
    yield from _sizes()
    bound = (V, "V-positive")
    yield from laws.components(bound, bound, power("V-positive", 2))
    yield from laws.root()
    yield from laws.between_zero_and_one()
    yield from _root()
    yield from laws.time(times("d-positive", plus(2, "d-positive")))
    yield from _time()
    yield from laws.distance()
    yield from _distance()


def _sizes() -> Iterator[Item]:
    yield Line("g-positive", 0 < g, proof("Cnd2", "Cnd1"))
    yield Line("y-bound", y <= eta_0, proof("Cnd2", "g-bound"))
    yield Line("speed-above", V_0 <= speed, proof("speed-least", times("gain-positive", "g-bound")))
    yield Line("speed-positive", 0 < speed, proof("speed-above", "V_0-positive"))
    slower = times(SLOWER, plus(SLOWER, times(2, "speed-positive")))
    for name, letter, size in (("A", "c", A), ("B", "s", B)):
        yield Line(f"{name}-below", size <= V**2,
                   proof(f"{name}-upper", slower), says=f"|W_{letter}| ≤ V")  # fmt: skip
    yield Line("A-positive", 0 < A, proof("cs-c", power("Cnd1", 2)))
    yield Line("B-positive", 0 < B, proof("cs-s", power("recedes", 2)))
    yield Line("d-crude", 1 + d <= reach, proof("d-small", _crude()))


def _crude() -> Value:
    """K eta_0^2 - k y^2."""
    return times("k-positive", "y-bound", plus("eta_0-positive", "Cnd1"))


def _root() -> Iterator[Item]:
    yield from (
        Line("zeta-bound", zeta <= 2 * k * V**2,
             proof(zeta_small("", "A-below"), using="zeta"), says="ζ ≤ 2κV²"),
        Line("S-least",    root <= S,
             scaled(times("goal", plus("goal", times(2, "S-positive"))), "zeta-bound",
                    times(square(V), "time-room"), using="S-square"), says="√(1-ζ) ≥ 1 - TV²"),
    )  # fmt: skip


def _time() -> Iterator[Item]:
    d_sum, y2 = "d-sum-positive", power("Cnd1", 2)
    yield from (
        laws.TIME_ROOT,
        Line("time",       tau <= T * y,
             scaled(times("goal", d_sum, "Cnd1", plus(1, "S-positive")),
                    times("T-positive", y2, d_sum, "S-least"), times(y2, d_sum, "time-room"),
                    times(2, d_sum, "d-small"), power("d-positive", 2))
             ._replace(equations=(("time-root", as_term(-1)),)), TIME, "τ ≤ T(-η_c)"),
        Line("time-short", 5 * V * tau <= 1,
             proof(times(5, "V-positive", "time"), times(5, "T-positive", "V-positive", "y-bound"),
                   "apart-room"), TIME, "Vτ ≤ 1/5"),
    )  # fmt: skip


def _distance() -> Iterator[Item]:
    y2 = power("Cnd1", 2)
    further = times("T-positive", "Cnd1")
    below = times("least-ratio-below", plus(1, "least-ratio-positive"))
    yield from (
        Line("distance-slope", D - 1 <= k * least_ratio**2 * y**2,
             proof("distance", times("recedes", "time"), times(further, "ratio-upper"),
                   times(Fraction(1, 2), power("tau-positive", 2), "B-below"),
                   times(Fraction(1, 2), square(V), "time", plus("tau-positive", further)),
                   times(y2, "d-room")), DISTANCE, "d' ≤ κ(p-Y)²η_c²"),
        Line("distance-here", D - 1 <= k * y**2,
             proof("distance-slope", times("k-positive", y2, below)), DISTANCE, "d' ≤ κη_c²"),
        Line("distance-crude", reach >= D, proof("distance-here", _crude())),
        laws.NEXT_D_POSITIVE,
        laws.NEXT_D_SUM_POSITIVE,
    )  # fmt: skip


dot = frame.dot
#: From particle s to particle c at the start, and its length.
outer = add(scale(1 + d, omega_c), scale(-1, omega_s))
length = sqrt(dot(outer, outer))
close = dot(outer, difference)


def apart() -> Iterator[Chapter]:
    """The three pairs."""
    before, meanwhile = contexts()
    yield Chapter(CONTEXT, tuple(_outer()))
    yield opened()
    yield Chapter(before.name, tuple(colliding()))
    yield Chapter(meanwhile.name, (spectator(), *_outer_pair()))


def _outer() -> Iterator[Item]:
    positive = plus(times(2, "C-positive", "d-sum-positive"), times(2, "d-positive"), square(d))
    yield from (
        Line("outer-least",    2 <= dot(outer, outer), proof(positive)),
        Line("outer-positive", 0 < dot(outer, outer), proof("outer-least", 2)),
        Line("outer-root",     0 < length, ByRoot()),
        Line("outer-length",   Fraction(7, 5) < length,
             scaled(times("goal", plus(Fraction(7, 5), "outer-root")), "outer-least",
                    Fraction(1, 25)),
             says="√2 > 7/5: how far the outer particles are from one another, as θ is obtuse"),
        Line("outer-speed",    dot(difference, difference) <= 4 * V**2,
             proof("A-below", "B-below", times(2, "w-lower"))),
        Line("outer-closing",  -close <= 2 * V * length,
             scaled(times("goal", plus("goal", times(4, "V-positive", "outer-root"))), "cs-apart",
                    times("outer-positive", "outer-speed")),
             says="by Cauchy-Schwarz: they approach one another with 2V at most"),
    )  # fmt: skip


def _outer_pair() -> Iterator[Item]:
    path = add(outer, scale(t, difference))
    more = plus("outer-turn", times(2, "outer-root"))
    yield from (
        Line("outer-turn",       length < dot(outer, outer) + t * close,
             proof(times("outer-root", "outer-length"), times("t-lower", "outer-closing"),
                   times(2, "V-positive", "outer-root", "t-upper"),
                   times(Fraction(2, 5), "outer-root", "time-short"))),
        Line("outer-pair-apart", 1 < dot(path, path),
             scaled(times("outer-positive", "goal"), times(square(t), "cs-apart"),
                    times("outer-turn", more)),
             THEOREM, "the outer pair s-c is apart for all times from 0 to τ, both included"),
    )  # fmt: skip
