"""A state just after a collision with some numbers, for the half of the sandwich outside the set.

G bounds the distances 1 + d from particle 0; v_0 and w_0 the relative speed of the particle that
will collide next, from below and from above, at all times, v_1 and w_1 that of the other; v is at
most both v_i. -cos theta never exceeds C_p. Q_0 is at most eta_s/(-eta_c) now, and zeta with v_0 in
the place of the speed is at least U_0 (2-U_0).
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from verify.language.argument import plus, times
from verify.language.record import Record
from verify.language.statement import Context
from verify.language.terms import Claim, Term, symbol
from verify.language.vectors import Frame
from verify.paper.dynamics.carried import Sum, start, starting
from verify.paper.dynamics.state import inequalities, r, root_of, time_of, zeta_of
from verify.paper.sandwich.comparison import Step
from verify.paper.sandwich.comparison import step as step_of

#: The pairs of vectors for which Cauchy-Schwarz is used.
PAIRS = ("cs-s", "cs-c", "cs-a", "cs-impact", "cs-angle")

#: In Unicode, in LaTeX, and at a point that satisfies everything strictly.
_NUMBERS = {
    "r": ("r", "r", "3/100"),
    "G": ("Γ", r"\Gamma", "1001/1000"),
    "v": ("v", "v", "19/20"),
    "v_0": ("v₀", "v_0", "19/20"),
    "v_1": ("v₁", "v_1", "19/20"),
    "w_0": ("w₀", "w_0", "21/20"),
    "w_1": ("w₁", "w_1", "21/20"),
    "C_p": ("C₊", "C_+", "1"),
    "Q_0": ("Q₀", "Q_0", "1/20"),
    "U_0": ("U₀", "U_0", "1/200"),
}
G, v, v_0, v_1, w_0, w_1, C_p, Q_0, U_0 = map(symbol, list(_NUMBERS)[1:])

half = (1 + r) / 2
#: The speeds of approach fall by this factor at least, and the next time is at most `step` y.
ratio = half * G
step = G / v / v

#: The sums over all later collisions, as constants of the context: of what a speed gains or loses,
#: and of the changes of the angle, for each unit of the closing speed now.
gain, turning = map(symbol, ("gain", "turning"))
SUMS: Mapping[str, Sum] = {
    "gain": Sum("G_V", G, 1 - ratio),
    "turning": Sum("G_C", (w_0 + w_1 + 2 * start.y) * step, 1 - ratio),
}
_gain, _turn = (found.term for found in SUMS.values())


def model(Q: Term, U: Term, w_c: Term, v_s: Term) -> Step:
    """One step from (Q, U) of the map that the dynamics stays above."""
    return step_of(half * G * C_p, (v_s / w_c) ** 2, r, Q, U)


class Again(Record):
    """The flight to the next collision and what is then, as terms: a state has two more in turn."""

    closing: Term
    spread: Term
    speed: Term

    @property
    def approaches(self) -> Claim:
        """After the next collision the other particle approaches: 0 < (1+d')(-eta_c')."""
        return 0 < self.closing

    @property
    def meets(self) -> Claim:
        """And it will meet particle 0: zeta' < 1."""
        return self.spread * self.speed < self.closing**2


def again(f: Frame, time: Term, root: Term) -> Again:
    """What is after the next collision of a state, which has this time, and this root in it."""
    hit = (1 + f.d) * f.y * root
    spin = (1 + f.d) * f.b + time * f.w
    turn = (1 + f.d) * f.C - time * f.a - (1 + f.d) * time * f.b - time**2 * f.w
    return Again(
        half * hit * turn - (f.eta_s + time * f.B),
        2 * f.eta_s * time + f.B * time**2,
        f.B + 2 * half * hit * spin + half**2 * hit**2,
    )


#: What is asked of the numbers alone.
ROOM: Mapping[str, Claim] = {
    "r-positive": 0 < r,
    "reach": 1 <= G,
    "decay-positive": 0 < 1 - ratio,
    "v-positive": 0 < v,
    "v_0-least": v <= v_0,
    "v_1-least": v <= v_1,
    "C-room": C_p <= 2,
    "Q_0-least": 0 <= Q_0,
    "U_0-least": 0 <= U_0,
    "U_0-room": 0 < 1 - U_0,
}

#: What is asked of the state.
ENTRY: Mapping[str, Claim] = {
    "start-y": 0 < start.y,
    "start-recedes": 0 < start.eta_s,
    "start-q": Q_0 * start.y <= start.eta_s,
    "start-d": 0 < start.d,
    "start-d-sum": 0 < 1 + start.d,
    "start-u": U_0 * (2 - U_0) * (1 + start.d) ** 2 * start.y**2
    <= start.d * (2 + start.d) * v_0**2,
    "start-reach": start.y**2 * G**2 <= v**2 * (G**2 - 1),
    "start-room-0": 0 < w_0 - _gain * start.y,
    "start-room-1": 0 < w_1 - _gain * start.y,
    "start-A-most": start.A <= (w_0 - _gain * start.y) ** 2,
    "start-B-most": start.B <= (w_1 - _gain * start.y) ** 2,
    "start-A-least": (v_0 + _gain * start.y) ** 2 <= start.A,
    "start-B-least": (v_1 + _gain * start.y) ** 2 <= start.B,
    "start-C": start.C <= C_p - _turn * start.y,
    "start-C-room": 0 <= C_p - _turn * start.y,
    "start-Cnd3": 0 < 1 - zeta_of(start),
    "start-root-sum": 0 < 1 + root_of(start),
}

#: That it is a state of vectors, and that the run has two collisions more, in turn.
_again = again(start, time_of(start), root_of(start))
STATE: Mapping[str, Claim] = {
    **{f"start-{name}": c for name, c in inequalities(start, time_of(start), PAIRS).items()},
    "start-approaches-again": _again.approaches,
    "start-meets-again": _again.meets,
}

#: The state there, its inner products in the order of `NAMES`.
_STATE = "1/100 1/1250 19/20 19/2000 -19/25000 1 1 0 1/1000000"


GIVENS = {**ROOM, **ENTRY, **STATE}


def context() -> Context:
    """The numbers and the state, with the sums over all later collisions."""
    return starting(_NUMBERS, _STATE, GIVENS, SUMS)


HALF = times(Fraction(1, 2), plus(1, "r-positive"))
G_POSITIVE = plus(1, "reach")
