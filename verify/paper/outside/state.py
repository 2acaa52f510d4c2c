"""What is carried from collision to collision, and that it holds at the start.

With the numbers of a state go g = ratio^n y_0, the point (Q, U) of the map that q and u stay above,
and bounds of the speeds of c and s from both sides.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from verify.language.argument import Item, Line, identity, plus, proof, times
from verify.language.statement import Context, Given
from verify.language.terms import Claim, equal, substitute, symbol
from verify.paper.dynamics.carried import Carried, Ghost, followed, start, summed
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
from verify.paper.outside.numbers import (
    G_POSITIVE,
    HALF,
    PAIRS,
    Q_0,
    SUMS,
    U_0,
    C_p,
    again,
    gain,
    model,
    ratio,
    turning,
    v,
    v_0,
    v_1,
    w_0,
    w_1,
)
from verify.paper.sandwich.comparison import LABEL

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
