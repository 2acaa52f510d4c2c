"""A state just after a collision with some numbers, and what the sharper theorem asks of them.

m and p are near the fixed points; X, Y, k bound how far the ratios q = eta_s/(-eta_c) and
-eta_c'/(-eta_c) ever get from them, and d/eta_c^2; T bounds the time to a collision per -eta_c, V
all speeds, Theta how far -cos theta ever gets from C_0; eta_0 and V_0 bound -eta_c and the speeds
now. Each condition compares polynomials or quotients of rational numbers: at numbers, enclosures
decide it.
"""

from __future__ import annotations

from collections.abc import Mapping

from verify.language.statement import Context
from verify.language.terms import Claim, Term, symbol
from verify.paper.dynamics.carried import Sum, start, starting
from verify.paper.dynamics.state import r

#: In Unicode, in LaTeX, and at a point that satisfies everything strictly.
_NUMBERS = {
    "r": ("r", "r", "3/100"),
    "m": ("m", "m", "79/1000"),
    "p": ("p", "p", "49/125"),
    "X": ("X", "X", "13/1000"),
    "Y": ("Y", "Y", "21/500"),
    "k": ("κ", r"\kappa", "1/50"),
    "V": ("V", "V", "11/10"),
    "T": ("T", "T", "51/2500"),
    "V_0": ("V₀", "V_0", "1"),
    "eta_0": ("η₀", r"\eta_0", "1/10"),
    "C_0": ("C₀", "C_0", "19/20"),
    "Theta": ("Θ", r"\Theta", "1/100"),
}
m, p, X, Y, k, V, T, V_0, eta_0, C_0, Theta = map(symbol, list(_NUMBERS)[1:])

half = (1 + r) / 2
#: Bounds of -eta_c'/(-eta_c): the speeds of approach fall by the factor `ratio` at least.
ratio = p + Y
least_ratio = p - Y
#: Bounds of the root, of 1 + d, and of what one collision adds to a speed, per -eta_c.
root = 1 - T * V**2
reach = 1 + k * eta_0**2
jump = half * reach

#: The sums over all later collisions, as constants of the context: of the changes of a speed, of
#: the three parts of the changes of the angle, and of the times.
gain, turn_1, turn_2, turn_3, duration = map(
    symbol, ("gain", "turn_1", "turn_2", "turn_3", "duration")
)
SUMS: Mapping[str, Sum] = {
    "gain": Sum("G_V", jump, 1 - ratio),
    "turn_1": Sum("G_1", 2 * T * V, 1 - ratio),
    "turn_2": Sum("G_2", k + T**2 * V**2, 1 - ratio**2),
    "turn_3": Sum("G_3", T * V * k, 1 - ratio**3),
    "duration": Sum("G_T", T, 1 - ratio),
}


def total(size: Term, *factors: Term) -> Term:
    """How far -cos theta can turn while -eta_c falls from some size to 0."""
    first, second, third = factors or (turn_1, turn_2, turn_3)
    return first * size + second * size**2 + third * size**3


_all = total(eta_0, *(SUMS[name].term for name in ("turn_1", "turn_2", "turn_3")))

#: What is asked of the numbers alone.
ROOM: Mapping[str, Claim] = {
    "r-positive": 0 < r,
    "ratio-room": X <= m,
    "decay-positive": 0 < 1 - ratio,
    "decay-2-positive": 0 < 1 - ratio**2,
    "decay-3-positive": 0 < 1 - ratio**3,
    "least-ratio-positive": 0 < least_ratio,
    "obtuse": Theta < C_0,
    "angle-real": C_0 <= 1,
    "speed-start": eta_0 <= V_0,
    "speed-room": jump * eta_0 <= (V - V_0) * (1 - ratio),
    "time-room": 2 * k <= T * (2 - T * V**2),
    "y-upper-room": half * reach**2 * (C_0 + Theta) <= ratio * reach + (m - X),
    "y-lower-room": least_ratio <= half * root * (C_0 - Theta) - (m + X) - T * V**2,
    "x-upper-room": r * reach <= (m + X) * least_ratio,
    "x-lower-room": (m - X) * ratio <= r * root,
    "d-room": (m + X) * T + V**2 * T**2 / 2 <= k * least_ratio**2,
}

#: What is asked of the state.
ENTRY: Mapping[str, Claim] = {
    "start-Cnd1": 0 < start.y,
    "start-Cnd2": start.y <= eta_0,
    "start-recedes": 0 < start.eta_s,
    "start-ratio-upper": start.eta_s <= (m + X) * start.y,
    "start-ratio-lower": (m - X) * start.y <= start.eta_s,
    "start-d-positive": 0 < start.d,
    "start-d-small": start.d <= k * start.y**2,
    "start-A-bound": start.A <= V_0**2,
    "start-B-bound": start.B <= V_0**2,
    "start-C-upper": start.C - C_0 + _all <= Theta,
    "start-C-lower": C_0 - start.C + _all <= Theta,
}

GIVENS = {**ROOM, **ENTRY}

#: The state there, its inner products in the order of `NAMES`.
_STATE = "99/1000 99/12500 19/20 1881/20000 -1881/250000 1/2 1/2 186219/250000000 1/10000"


def context() -> Context:
    """The numbers and the state, with the sums over all later collisions."""
    return starting(_NUMBERS, _STATE, GIVENS, SUMS)
