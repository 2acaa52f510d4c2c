"""A state just after a collision with some numbers, and what the sharper theorem asks of them.

m and p are near the fixed points; X, Y, k bound how far the ratios q = eta_s/(-eta_c) and
-eta_c'/(-eta_c) ever get from them, and d/eta_c^2; T bounds the time to a collision per -eta_c, V
all speeds, Theta how far -cos theta ever gets from C_0; eta_0 and V_0 bound -eta_c and the speeds
now. Each condition compares polynomials or quotients of rational numbers: at numbers, enclosures
decide it.

Then what is carried from state to state: bounds that do not depend on n, and sums so far. The
conditions hold at the start, and for some vectors with the same normal components.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction

from verify.language.argument import Item, Line, Value, plus, power, proof, scaled, square, times
from verify.language.statement import Context
from verify.language.terms import Claim, Term, as_term, symbol
from verify.paper.dynamics.carried import Carried, Ghost, Sum, start, starting, summed
from verify.paper.dynamics.model import aligned, at_the_point
from verify.paper.dynamics.state import (
    A,
    B,
    C,
    collision_map,
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


def start_context() -> Context:
    """The numbers and the state, with the sums over all later collisions."""
    return starting(_NUMBERS, _STATE, GIVENS, SUMS)


# --- what follows from the numbers ----------------------------------------------------------------


#: TV^2: the bound of the root is 1 - loss. With how it is positive, and other products that are.
loss = T * V**2
LOSS = times("T-positive", square(V))
HALF = times(Fraction(1, 2), plus(1, "r-positive"))
EXCESS = times("k-positive", power("eta_0-positive", 2))
REACH = plus(1, EXCESS)


def consequences() -> Iterator[Item]:
    """What follows from the inequalities between the numbers, before any collision.

    Among it that the outer particles stay apart: no inequality has to ask for that.
    """
    yield from _signs()
    yield from _sums()
    yield from _ratios()
    yield from _apart()


def _signs() -> Iterator[Item]:
    y2 = power("start-Cnd1", 2)
    both = ("start-ratio-upper", "start-ratio-lower")
    used = ("least-ratio-positive", "ratio-positive", LOSS)
    yield from (
        Line("eta_0-positive", 0 < eta_0, proof("start-Cnd1", "start-Cnd2")),
        Line("V_0-positive", 0 < V_0, proof("eta_0-positive", "speed-start")),
        Line("k-positive", 0 < k, scaled(times("goal", y2), "start-d-positive", "start-d-small")),
        Line("T-positive", 0 < T,
             scaled(times(2, "goal"), "time-room", square(T * V), times(2, "k-positive"))),
        Line("T-least", k <= T, scaled(times(2, "goal"), "time-room", square(T * V))),
        Line("X-positive", 0 <= X, scaled(times(2, "goal", "start-Cnd1"), *both)),
        Line("ratio-positive", 0 < m + X,
             scaled(times("goal", "start-Cnd1"), "start-ratio-upper", "start-recedes")),
        Line("root-room", 0 < root, scaled(times(HALF, "obtuse", "goal"), "y-lower-room", *used)),
        Line("zeta-room", 0 < 1 - 2 * k * V**2,
             proof(times(square(V), "time-room"), power("root-room", 2))),
    )  # fmt: skip


def _sums() -> Iterator[Item]:
    added = times(HALF, REACH, "eta_0-positive")
    yield Line("V-above", V_0 <= V, scaled(times("decay-positive", "goal"), "speed-room", added))
    yield Line("V-positive", 0 < V, proof("V-above", "V_0-positive"))
    signs = {
        "gain": times(HALF, REACH),
        "turn_1": times(2, "T-positive", "V-positive"),
        "turn_2": plus("k-positive", square(T * V)),
        "turn_3": times("T-positive", "V-positive", "k-positive"),
        "duration": "T-positive",
    }
    for name, sign in signs.items():
        yield from summed(name, SUMS, sign)
    yield Line("speed-least", V_0 <= V - gain * eta_0, proof("speed-room", using="gain"))
    using = "turn_1 turn_2 turn_3"
    for side, change in (("upper", start.C - C_0), ("lower", C_0 - start.C)):
        claim = change <= Theta - total(eta_0)
        yield Line(f"start-angle-{side}", claim, proof(f"start-C-{side}", using=using))
    yield from (
        Line("Theta-room",     0 <= Theta - total(eta_0),
             scaled(times(2, "goal"), "start-angle-upper", "start-angle-lower")),
        Line("Theta-positive", 0 < Theta, proof("Theta-room", TOTAL)),
    )  # fmt: skip


TOTAL = plus(
    times("turn_1-positive", "eta_0-positive"),
    times("turn_2-positive", power("eta_0-positive", 2)),
    times("turn_3-positive", power("eta_0-positive", 3)),
)


def _ratios() -> Iterator[Item]:
    angle = plus(
        times(EXCESS, plus("obtuse", times(2, "Theta-positive"))),
        times(2, "Theta-positive"),
        times(LOSS, "obtuse"),
    )
    below = times("least-ratio-below", plus(1, "least-ratio-positive"))
    yield from (
        Line("ratio-order",       least_ratio + loss <= ratio,
             scaled(times(REACH, "goal"), "y-upper-room", times(REACH, "y-lower-room"),
                    times(2, "X-positive"), times(EXCESS, "ratio-positive"),
                    times(HALF, REACH, angle)), says="p - Y + TV² ≤ p + Y"),
        Line("loss-decay",        loss <= ratio, proof("ratio-order", "least-ratio-positive")),
        Line("growth-positive",   0 < ratio, proof("ratio-order", "least-ratio-positive", LOSS)),
        Line("least-ratio-below", 0 < 1 - least_ratio,
             proof("ratio-order", LOSS, "decay-positive")),
        Line("ratio-below",       0 < 1 - (m + X),
             scaled(times("T-positive", "goal"), "d-room",
                    times("T-least", power("least-ratio-positive", 2)), times("T-positive", below),
                    times(Fraction(1, 2), square(T * V)))),
        Line("r-below-one",       0 < 1 - r,
             proof("x-upper-room", times("r-positive", EXCESS),
                   times("ratio-positive", "least-ratio-below"), "ratio-below"),
             says="the inequalities imply r < 1"),
    )  # fmt: skip


def _apart() -> Iterator[Item]:
    cubic = plus(
        times("root-room", square(1 - Fraction(27, 10) * loss)),
        times(LOSS, square(Fraction(3, 2) * loss - Fraction(3, 5))),
        times(Fraction(1, 25), LOSS),
        times(Fraction(11, 100), power(LOSS, 2)),
        times(Fraction(1, 25), power(LOSS, 3)),
    )
    yield from (
        Line("loss-bound",   loss <= half * root,
             proof("y-lower-room", times(HALF, "root-room", plus("angle-real", "Theta-positive")),
                   "ratio-positive", "least-ratio-positive")),
        Line("apart-least",  0 <= root * (1 - 5 * loss) + half,
             scaled(times("root-room", "goal"), "loss-bound", cubic)),
        Line("apart-most",   0 <= (1 - ratio) * (1 - 5 * loss) + half,
             scaled(times("root-room", "goal"), times("decay-positive", "apart-least"),
                    times(HALF, "loss-decay"))),
        Line("apart-scaled", 5 * loss * eta_0 <= V,
             scaled(times("decay-positive", "goal"), "speed-room",
                    times("decay-positive", "speed-start"), times("eta_0-positive", "apart-most"),
                    times(HALF, EXCESS, "eta_0-positive"))),
        Line("apart-room",   5 * T * V * eta_0 <= 1,
             scaled(times("V-positive", "goal"), "apart-scaled"),
             says="the inequalities imply TVη₀ ≤ 1/5: in one step no particle gets far"),
    )  # fmt: skip


# --- what is carried ------------------------------------------------------------------------------


#: The pairs of vectors for which Cauchy-Schwarz is used.
PAIRS = ("cs-omega", "cs-s", "cs-c", "cs-a", "cs-b", "cs-w", "cs-apart", "cs-impact")

#: g stands for ratio^n eta_0, clock for the time; `speed` bounds the speeds in this state.
g, clock = symbol("g"), symbol("clock")
speed = V - gain * g
speed_next = V - gain * (ratio * g)


#: What is carried from state to state.
CONDITIONS: Mapping[str, Claim] = {
    "Cnd1": 0 < y,
    "Cnd2": y <= g,
    "g-bound": g <= eta_0,
    "d-positive": 0 < d,
    "d-small": d <= k * y**2,
    "d-sum-positive": 0 < 1 + d,
    "recedes": 0 < eta_s,
    "ratio-upper": eta_s <= (m + X) * y,
    "ratio-lower": (m - X) * y <= eta_s,
    "Cnd3": 0 < 1 - zeta_of(frame),
    "root-sum": 0 < 1 + root_of(frame),
    "A-upper": A <= speed**2,
    "B-upper": B <= speed**2,
    "angle-upper": C - C_0 <= Theta - total(g),
    "angle-lower": C_0 - C <= Theta - total(g),
    "clock-bound": clock <= duration * (eta_0 - g),
}
#: What goes along: in Unicode, in LaTeX, at the start, and at the next state.
GHOSTS: Mapping[str, Ghost] = {
    "g": ("(p+Y)ⁿη₀", r"(p+Y)^n\eta_0", eta_0, ratio * g),
    "clock": ("t_n", "t_n", as_term(0), clock + tau),
}
carried = Carried(CONDITIONS, GHOSTS)
#: Where the recursion starts.
beginning = carried.begun()

#: Velocities for which Cauchy-Schwarz is seen to hold: normal but for orthogonal parts.
point_frame = aligned(start.y, start.eta_s, C_0, V_0**2, V_0**2, start.d)
point = carried.begun(point_frame)


def context() -> Context:
    """The states that satisfy the conditions."""
    standing = inequalities(frame, time_of(frame), PAIRS)
    return carried.context(standing, point, collision_map(time_of(frame)))


#: Conditions that the point has under names of its own; of the others it says what the start says.
OWN = ("Cnd3", "root-sum", "A-upper", "B-upper", "angle-upper", "angle-lower")


def zeta_small(prefix: str, bound: str) -> Value:
    """Why zeta <= 2 k V^2, where d <= k y^2 and the bound is |W_c|^2 <= V^2."""
    d, d2 = f"{prefix}d-positive", power(f"{prefix}d-sum-positive", 2)
    return plus(
        times(d, plus(2, d), bound),
        times(2, d2, square(V), f"{prefix}d-small"),
        times(square(V), power(d, 2), plus(3, times(2, d))),
    )


def root_lines(prefix: str, values: Mapping[str, Term], reason: Value) -> Iterator[Item]:
    """Zeta < 1 for these values, and so there is a root; given why zeta <= 2 k V^2."""
    names = "start-" if prefix == "at-" else prefix
    room = times(power(f"{names}d-sum-positive", 2), power(f"{names}Cnd1", 2), "zeta-room")
    claim = carried.at(values)["Cnd3"]
    yield Line(f"{prefix}Cnd3", claim, proof(reason, room), says="ζ < 1")
    yield from carried.root(prefix, values)


def lines() -> Iterator[Item]:
    """First at the start, then at the point."""
    claims = carried.at(beginning)
    faster = times("speed-least", plus("speed-least", times(2, "V_0-positive")))
    more = times("V-above", plus("V-above", times(2, "V_0-positive")))
    says = "the condition holds for n = 0"
    reasons = {
        "g-bound": proof(),
        "d-sum-positive": proof(1, "start-d-positive"),
        "A-upper": proof("start-A-bound", faster),
        "B-upper": proof("start-B-bound", faster),
        "clock-bound": proof(),
    }
    for name, reason in reasons.items():
        yield Line(f"start-{name}", claims[name], reason, says=says)
    yield Line("start-A-below", start.A <= V**2, proof("start-A-bound", more))
    yield from root_lines("start-", beginning, zeta_small("start-", "start-A-below"))
    yield Line("at-A-below", V_0**2 <= V**2, proof(more))
    yield from root_lines("at-", point, zeta_small("start-", "at-A-below"))
    yield from _at_the_point(faster)
    yield from _vectors()


def _at_the_point(faster: Value) -> Iterator[Item]:
    claims = carried.at(point)
    for name in ("A-upper", "B-upper"):
        yield Line(f"at-{name}", claims[name], proof(faster))
    for name in ("angle-upper", "angle-lower"):
        yield Line(f"at-{name}", claims[name], proof("Theta-room"))


def _vectors() -> Iterator[Item]:
    """Cauchy-Schwarz at the point."""
    p = point_frame
    slower = times("speed-start", plus("eta_0-positive", "V_0-positive"))
    smaller = times("start-Cnd2", plus("start-Cnd1", "eta_0-positive"))
    least = times("start-Cnd1", "ratio-below")
    along = times(plus("start-ratio-upper", least), plus("start-Cnd1", "start-recedes"))
    angle = proof(times("angle-real", plus(1, "obtuse", "Theta-positive")))
    yield Line("at-angle", C_0**2 <= 1, angle)
    yield Line("at-room-c", p.y**2 <= p.A, proof(slower, smaller))
    yield Line("at-room-s", p.eta_s**2 <= p.B, proof(slower, smaller, along))
    yield from at_the_point(p, time_of(p), PAIRS, ("at-angle", "at-room-c", "at-room-s"))


def opening() -> tuple[str, ...]:
    """Why the givens of a state hold at the point."""
    conditions = (f"at-{n}" if n in OWN else f"start-{n}" for n in CONDITIONS)
    return (*conditions, *(f"at-{name}" for name in PAIRS))
