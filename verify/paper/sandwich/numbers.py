"""A state just after a collision with some numbers, and what the sandwich theorem asks of them.

G bounds the distances 1 + d from particle 0, w_0 and w_1 the relative speeds of the particle that
will collide next and of the other, at all times; w is at most both of them. zeta with w_i in the
place of the speed is at most U (2-U), with U_0 for U now and never more than U_b; -cos theta stays
within Theta of C_0, and Q_0 bounds eta_s/(-eta_c) now. All but the state may be rational numbers.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from verify.language.argument import plus, times
from verify.language.statement import Context
from verify.language.terms import Claim, symbol
from verify.paper.dynamics.carried import Sum, start, starting
from verify.paper.dynamics.state import r
from verify.paper.sandwich.comparison import Model

#: In Unicode, in LaTeX, and at a point that satisfies everything strictly.
_NUMBERS = {
    "r": ("r", "r", "3/100"),
    "G": ("Γ", r"\Gamma", "1001/1000"),
    "w_b": ("w", "w", "11/10"),
    "w_0": ("w₀", "w_0", "11/10"),
    "w_1": ("w₁", "w_1", "11/10"),
    "U_b": ("U*", "U_*", "1/10"),
    "C_0": ("C₀", "C_0", "19/20"),
    "Theta": ("Θ", r"\Theta", "1/50"),
    "Q_0": ("Q₀", "Q_0", "1/10"),
    "U_0": ("U₀", "U_0", "1/50"),
}
G, w_b, w_0, w_1, U_b, C_0, Theta, Q_0, U_0 = map(symbol, list(_NUMBERS)[1:])

half = (1 + r) / 2
#: The speeds of approach fall by this factor at least.
ratio = half * G
#: The time to the next collision is at most `step` y.
step = G * U_b / w_b / w_b

#: The sums over all later collisions, as constants of the context: of what a speed gains if it is
#: that of s now, of the times, and of the changes of the angle.
gain, duration, turning = map(symbol, ("gain", "duration", "turning"))
SUMS: Mapping[str, Sum] = {
    "gain": Sum("G_V", half * G, 1 - ratio**2),
    "duration": Sum("G_T", step, 1 - ratio),
    "turning": Sum("G_C", (w_0 + w_1 + start.y) * step, 1 - ratio),
}
_gain, _, _turn = (found.term for found in SUMS.values())

#: The map of two numbers that the dynamics stays below, at the start.
model = Model(r, G, U_b, C_0 - Theta)
first = model.step(Q_0, U_0, w_0, w_1)

#: What is asked of the numbers alone.
ROOM: Mapping[str, Claim] = {
    "r-positive": 0 < r,
    "reach": 1 <= G,
    "decay-positive": 0 < 1 - ratio,
    "decay-2-positive": 0 < 1 - ratio**2,
    "w_b-positive": 0 < w_b,
    "w_0-least": w_b <= w_0,
    "w_1-least": w_b <= w_1,
    "w_0-positive": 0 < w_0,
    "w_1-positive": 0 < w_1,
    "U-room": 0 < 1 - U_b,
    "obtuse": Theta < C_0,
    "angle-real": C_0 <= 1,
    "U_0-bound": U_0 <= U_b,
}

#: What is asked of the state, and that the map goes on once.
ENTRY: Mapping[str, Claim] = {
    "start-y": 0 < start.y,
    "start-recedes": 0 < start.eta_s,
    "start-q": start.eta_s <= Q_0 * start.y,
    "start-d": 0 < start.d,
    "start-cs-c": start.y**2 <= start.A,
    "start-cs-s": start.eta_s**2 <= start.B,
    "start-u": start.d * (2 + start.d) * w_0**2
    <= U_0 * (2 - U_0) * (1 + start.d) ** 2 * start.y**2,
    "start-reach": U_b * (2 - U_b) * start.y**2 * G**2 <= w_b**2 * (G**2 - 1),
    "start-room-0": 0 < w_0 - ratio * _gain * start.y,
    "start-room-1": 0 < w_1 - _gain * start.y,
    "start-A-most": start.A <= (w_0 - ratio * _gain * start.y) ** 2,
    "start-B-most": start.B <= (w_1 - _gain * start.y) ** 2,
    "start-C-upper": start.C - C_0 + _turn * start.y <= Theta,
    "start-C-lower": C_0 - start.C + _turn * start.y <= Theta,
    "start-approaches": first.approaches,
    "start-meets": first.meets_below(U_b),
}

GIVENS = {**ROOM, **ENTRY}

#: The state there, its inner products in the order of `NAMES`.
_STATE = "1/100 1/1250 19/20 19/2000 -19/25000 1 1 0 1/1000000"


def context() -> Context:
    """The numbers and the state, with the sums over all later collisions."""
    return starting(_NUMBERS, _STATE, GIVENS, SUMS)


HALF = times(Fraction(1, 2), plus(1, "r-positive"))
G_POSITIVE = plus(1, "reach")
