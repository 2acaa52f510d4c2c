"""A state just after a collision with some numbers, for the half of the sandwich outside the set.

G bounds the distances 1 + d from particle 0; v_0 and w_0 the relative speed of the particle that
will collide next, from below and from above, at all times, v_1 and w_1 that of the other; v is at
most both v_i. -cos theta never exceeds C_p. Q_0 is at most eta_s/(-eta_c) now, and zeta with v_0 in
the place of the speed is at least U_0 (2-U_0).

Then what is carried from collision to collision, and that it holds at the start: with the numbers
of a state go g = ratio^n y_0, the point (Q, U) of the map that q and u stay above,
and bounds of the speeds of c and s from both sides.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction

from verify.language.argument import Item, Line, identity, plus, proof, times
from verify.language.record import Record
from verify.language.statement import Context, Given
from verify.language.terms import Claim, Term, equal, substitute, symbol
from verify.language.vectors import Frame
from verify.paper.dynamics.carried import Carried, Ghost, Sum, followed, start, starting, summed
from verify.paper.dynamics.state import (
    A,
    B,
    C,
    after_the_collision,
    d,
    eta_s,
    frame,
    inequalities,
    r,
    root_of,
    time_of,
    y,
    zeta_of,
)
from verify.paper.sandwich.comparison import LABEL, Step
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


def start_context() -> Context:
    """The numbers and the state, with the sums over all later collisions."""
    return starting(_NUMBERS, _STATE, GIVENS, SUMS)


HALF = times(Fraction(1, 2), plus(1, "r-positive"))
G_POSITIVE = plus(1, "reach")


# --- what is carried ------------------------------------------------------------------------------


GOES_ON = "goes-on"

time_here, root_here, g, Q, U, v_c, v_s, w_c, w_s = map(
    symbol, ("time_here", "root_here", "g", "Q", "U", "v_c", "v_s", "w_c", "w_s")
)
here = model(Q, U, w_c, v_s)
rho, pace, load, Q_next, U_next = map(symbol, ("rho", "pace", "load", "Q_next", "U_next"))


#: What is carried from state to state.
CONDITIONS: Mapping[str, Claim] = {
    "Cnd1": 0 < y,
    "Cnd2": y <= g,
    "g-bound": g <= start.y,
    "d-positive": 0 < d,
    "d-sum-positive": 0 < 1 + d,
    "recedes": 0 < eta_s,
    "Cnd3": 0 < 1 - zeta_of(frame),
    "root-sum": 0 < 1 + root_of(frame),
    "root-law": equal(root_here, root_of(frame)),
    "time-law": equal(time_here, time_of(frame)),
    "Q-least": 0 <= Q,
    "U-least": 0 <= U,
    "U-one": 0 < 1 - U,
    "q-bound": Q * y <= eta_s,
    "v_c-least": v <= v_c,
    "v_s-least": v <= v_s,
    "w-sum": equal(w_c + w_s, w_0 + w_1),
    "u-bound": U * (2 - U) * (1 + d) ** 2 * y**2 <= d * (2 + d) * v_c**2,
    "high-c": 0 < w_c - gain * g,
    "high-s": 0 < w_s - gain * g,
    "A-upper": A <= (w_c - gain * g) ** 2,
    "B-upper": B <= (w_s - gain * g) ** 2,
    "A-lower": (v_c + gain * g) ** 2 <= A,
    "B-lower": (v_s + gain * g) ** 2 <= B,
    "angle": C <= C_p - turning * g,
}
_after = after_the_collision()
#: What goes along: in Unicode, in LaTeX, at the start, and at the next state.
GHOSTS: Mapping[str, Ghost] = {
    "time_here": ("τ", r"\tau", time_of(start), substitute(time_of(frame), _after)),
    "root_here": ("√(1-ζ)", r"\sqrt{1-\zeta}", root_of(start), substitute(root_of(frame), _after)),
    "g": ("Λⁿη₀", r"\Lambda^n\eta_0", start.y, ratio * g),
    "Q": ("Q", "Q", Q_0, Q_next),
    "U": ("U", "U", U_0, U_next),
    "v_c": ("v_c", "v_c", v_0, v_s),
    "v_s": ("v_s", "v_s", v_1, v_c),
    "w_c": ("w_c", "w_c", w_0, w_s),
    "w_s": ("w_s", "w_s", w_1, w_c),
}
carried = Carried(CONDITIONS, GHOSTS)


def context() -> Context:
    """The states that satisfy the conditions, and have two collisions more in turn."""
    later = again(frame, time_here, root_here)
    goes_on = {"approaches-again": later.approaches, "meets-again": later.meets}
    return carried.context(
        inequalities(frame, time_of(frame), PAIRS),
        carried.begun(),
        followed(LABEL, (v_s / w_c) ** 2, here.P, here.load, r, U),
        says=", with two collisions more",
        goes_on=(Given(name, claim, "standing", GOES_ON) for name, claim in goes_on.items()),
    )


#: Conditions at the start that are givens of the start.
GIVEN = {
    "Cnd1": "start-y",
    "d-positive": "start-d",
    "d-sum-positive": "start-d-sum",
    "recedes": "start-recedes",
    "Q-least": "Q_0-least",
    "U-least": "U_0-least",
    "U-one": "U_0-room",
    "q-bound": "start-q",
    "v_c-least": "v_0-least",
    "v_s-least": "v_1-least",
    **{name: f"start-{name}" for name in ("Cnd3", "root-sum")},
    "u-bound": "start-u",
}


def begins(name: str) -> str:
    """The name of the fact that a condition holds at the start."""
    return GIVEN.get(name, f"start-{name}")


def lines() -> Iterator[Item]:
    """What follows from the numbers, and that the conditions hold at the start."""
    claims = carried.at(carried.begun())
    yield from (
        Line("r-below-one",    0 < 1 - r,
             proof(times(2, "decay-positive"), times(2, HALF, "reach")),
             says="the inequalities imply r < 1"),
        Line("ratio-positive", 0 < ratio, proof(times(HALF, G_POSITIVE))),
    )  # fmt: skip
    yield from summed("gain", SUMS, G_POSITIVE)
    for name, given in {
        "A-upper": "start-A-most",
        "B-upper": "start-B-most",
        "A-lower": "start-A-least",
        "B-lower": "start-B-least",
        "high-c": "start-room-0",
        "high-s": "start-room-1",
    }.items():
        yield Line(f"start-{name}", claims[name], proof(given, using="gain"))
    gone = times("gain-positive", "start-y")
    for i in (0, 1):
        name = ("high-c", "high-s")[i]
        yield Line(f"w_{i}-positive", 0 < (w_0, w_1)[i], proof(f"start-{name}", gone))
    speeds = plus("w_0-positive", "w_1-positive", times(2, "start-y"))
    yield from summed("turning", SUMS, times(speeds, G_POSITIVE))
    yield Line("start-angle", claims["angle"], proof("start-C", using="turning"))
    yield Line("angle-start", 0 <= C_p - turning * start.y, proof("start-C-room", using="turning"))
    for name in ("root-law", "time-law"):
        yield Line(f"start-{name}", claims[name], identity())
    for name in ("Cnd2", "g-bound"):
        yield Line(f"start-{name}", claims[name], proof())
    yield Line("start-w-sum", claims["w-sum"], identity())


def opening() -> tuple[str, ...]:
    """Why the givens of a state hold at the start."""
    standing = (*PAIRS, "approaches-again", "meets-again")
    return (*map(begins, CONDITIONS), *(f"start-{name}" for name in standing))
