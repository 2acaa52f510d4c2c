"""A state just after a collision with some numbers, and what the sandwich theorem asks of them.

G bounds the distances 1 + d from particle 0, w_0 and w_1 the relative speeds of the particle that
will collide next and of the other, at all times; w is at most both of them. zeta with w_i in the
place of the speed is at most U (2-U), with U_0 for U now and never more than U_b; -cos theta stays
within Theta of C_0, and Q_0 bounds eta_s/(-eta_c) now. All but the state may be rational numbers.

Then what is carried from collision to collision, and that it holds at the start: with the numbers
of a state go g = ratio^n y_0, the clock, the point (Q, U) of the map that bounds
q and u, and bounds of the speeds of c and s. They hold for some vectors with the same normal
components.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction

from verify.language.argument import Item, Line, identity, plus, power, proof, scaled, times
from verify.language.statement import Context, Given
from verify.language.terms import Claim, as_term, equal, symbol
from verify.paper.dynamics.carried import Carried, Ghost, Sum, followed, start, starting, summed
from verify.paper.dynamics.model import aligned, at_the_point
from verify.paper.dynamics.state import (
    A,
    B,
    C,
    d,
    eta_s,
    frame,
    inequalities,
    r,
    root_of,
    tau,
    time_of,
    y,
    zeta_of,
)
from verify.paper.sandwich.comparison import LABEL as COMPARISON
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


def start_context() -> Context:
    """The numbers and the state, with the sums over all later collisions."""
    return starting(_NUMBERS, _STATE, GIVENS, SUMS)


HALF = times(Fraction(1, 2), plus(1, "r-positive"))
G_POSITIVE = plus(1, "reach")


# --- what is carried ------------------------------------------------------------------------------


GOES_ON = "comparison"
#: The pairs of vectors for which Cauchy-Schwarz is used.
PAIRS = ("cs-omega", "cs-s", "cs-c", "cs-a", "cs-b", "cs-w", "cs-impact", "cs-angle")

g, clock, Q, U, w_c, w_s = map(symbol, ("g", "clock", "Q", "U", "w_c", "w_s"))
here = model.step(Q, U, w_c, w_s)
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
    "q-bound": eta_s <= Q * y,
    "w_c-positive": 0 < w_c,
    "w_s-positive": 0 < w_s,
    "w_c-least": w_b <= w_c,
    "w_s-least": w_b <= w_s,
    "w-sum": equal(w_c + w_s, w_0 + w_1),
    "u-bound": d * (2 + d) * w_c**2 <= U * (2 - U) * (1 + d) ** 2 * y**2,
    "U-bound": U <= U_b,
    "high-c": 0 < w_c - ratio * gain * g,
    "high-s": 0 < w_s - gain * g,
    "A-upper": A <= (w_c - ratio * gain * g) ** 2,
    "B-upper": B <= (w_s - gain * g) ** 2,
    "angle-upper": C - C_0 <= Theta - turning * g,
    "angle-lower": C_0 - C <= Theta - turning * g,
    "clock-bound": clock <= duration * (start.y - g),
}
#: What goes along: in Unicode, in LaTeX, at the start, and at the next state.
GHOSTS: Mapping[str, Ghost] = {
    "g": ("Λⁿη₀", r"\Lambda^n\eta_0", start.y, ratio * g),
    "clock": ("t_n", "t_n", as_term(0), clock + tau),
    "Q": ("Q", "Q", Q_0, Q_next),
    "U": ("U", "U", U_0, U_next),
    "w_c": ("w_c", "w_c", w_0, w_s),
    "w_s": ("w_s", "w_s", w_1, w_c),
}
carried = Carried(CONDITIONS, GHOSTS)
#: Where the recursion starts.
beginning = carried.begun()

#: Velocities for which Cauchy-Schwarz is seen to hold: normal but for orthogonal parts.
point_frame = aligned(start.y, start.eta_s, C_0, start.A, start.B, start.d)
point = carried.begun(point_frame)


def context() -> Context:
    """The states that satisfy the conditions, and from which the map goes on."""
    goes_on = {"approaches": here.approaches, "meets": here.meets_below(U_b)}
    return carried.context(
        inequalities(frame, time_of(frame), PAIRS),
        point,
        followed(COMPARISON, model.rho(w_c, w_s), here.P, here.load, model.share, U),
        goes_on=(Given(name, claim, "standing", GOES_ON) for name, claim in goes_on.items()),
    )


#: Conditions at the start that are givens of the start.
GIVEN = {
    "Cnd1": "start-y",
    "d-positive": "start-d",
    "recedes": "start-recedes",
    "q-bound": "start-q",
    "U-bound": "U_0-bound",
    "u-bound": "start-u",
    "w_c-positive": "w_0-positive",
    "w_s-positive": "w_1-positive",
    "w_c-least": "w_0-least",
    "w_s-least": "w_1-least",
}


def begins(name: str) -> str:
    """The name of the fact that a condition holds at the start."""
    return GIVEN.get(name, f"start-{name}")


def at_point(name: str) -> str:
    """The name of the fact that it holds at the point."""
    return f"at-{name}" if name.startswith("angle") else begins(name)


def lines() -> Iterator[Item]:
    """What follows from the numbers, and that the conditions hold at the start."""
    claims = carried.at(beginning)
    yield from (
        Line("r-below-one",    0 < 1 - r,
             proof(times(2, "decay-positive"), times(2, HALF, "reach")),
             says="the inequalities imply r < 1"),
        Line("ratio-positive", 0 < ratio, proof(times(HALF, G_POSITIVE))),
        Line("start-d-sum-positive", 0 < 1 + start.d, proof(1, "start-d")),
    )  # fmt: skip
    yield from summed("gain", SUMS, times(HALF, G_POSITIVE))
    for name, given in {
        "A-upper": "start-A-most",
        "B-upper": "start-B-most",
        "high-c": "start-room-0",
        "high-s": "start-room-1",
    }.items():
        yield Line(f"start-{name}", claims[name], proof(given, using="gain"))
    yield from _signs()
    yield from summed("duration", SUMS, times(G_POSITIVE, "U_b-positive"))
    speeds = plus("w_0-positive", "w_1-positive", "start-y")
    yield from summed("turning", SUMS, times(speeds, G_POSITIVE, "U_b-positive"))
    for side in ("upper", "lower"):
        yield Line(f"start-angle-{side}", claims[f"angle-{side}"],
                   proof(f"start-C-{side}", using="turning"))  # fmt: skip
    for name in ("Cnd2", "g-bound", "clock-bound"):
        yield Line(f"start-{name}", claims[name], proof())
    yield Line("start-w-sum", claims["w-sum"], identity())
    yield Line("start-Cnd3", claims["Cnd3"],
               proof("start-u", times("start-d", plus(2, "start-d"), "start-A-below"),
                     times(power(plus("U_0-bound", "U-room"), 2),
                           power("start-d-sum-positive", 2), power("start-y", 2))))  # fmt: skip
    yield from carried.root("start-", beginning)
    yield from _at_the_point()


def _signs() -> Iterator[Item]:
    bent = times(power("start-d-sum-positive", 2), power("start-y", 2))
    gone = times("ratio-positive", "gain-positive", "start-y")
    yield from (
        Line("U_0-positive",     0 < U_0,
             scaled(times("goal", plus(1, "U_0-bound", "U-room"), bent), "start-u",
                    times("start-d", plus(2, "start-d"), power("w_0-positive", 2)))),
        Line("U_b-positive",     0 < U_b, proof("U_0-positive", "U_0-bound")),
        Line("start-A-below",    start.A <= w_0**2,
             proof("start-A-upper", times(gone, plus("start-high-c", "w_0-positive")))),
    )  # fmt: skip


def _at_the_point() -> Iterator[Item]:
    """The angle and the speeds leave room for vectors."""
    claims = carried.at(point)
    yield Line("Theta-room", 0 <= Theta - turning * start.y,
               scaled(times(2, "goal"), "start-angle-upper", "start-angle-lower"))  # fmt: skip
    for side in ("upper", "lower"):
        yield Line(f"at-angle-{side}", claims[f"angle-{side}"], proof("Theta-room"))
    theta = proof("Theta-room", times("turning-positive", "start-y"))
    yield Line("Theta-positive", 0 < Theta, theta)
    angle = proof(times("angle-real", plus(1, "obtuse", "Theta-positive")))
    yield Line("at-angle", C_0**2 <= 1, angle)
    givens = ("at-angle", "start-cs-c", "start-cs-s")
    yield from at_the_point(point_frame, time_of(point_frame), PAIRS, givens)


def opening() -> tuple[str, ...]:
    """Why the givens of a state hold at the point."""
    vectors = (f"at-{name}" for name in PAIRS)
    return (*map(at_point, CONDITIONS), *vectors, "start-approaches", "start-meets")
