"""What is carried from collision to collision, and that it holds at the start.

With the numbers of a state go g = ratio^n y_0, the clock, the point (Q, U) of the map that bounds
q and u, and bounds of the speeds of c and s. They hold for some vectors with the same normal
components.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from verify.language.argument import (
    ByInstance,
    ByRoot,
    Item,
    Line,
    identity,
    plus,
    power,
    proof,
    scaled,
    times,
)
from verify.language.statement import Context, Given, Variable
from verify.language.terms import Claim, Term, as_term, equal, substitute_claim, symbol
from verify.paper.dynamics.carried import START, Carried, followed, start, summed
from verify.paper.dynamics.model import PLANE, aligned
from verify.paper.dynamics.state import (
    CONTEXT,
    LETTERS,
    NAMES,
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
    tau,
    time_of,
    y,
    zeta_of,
)
from verify.paper.sandwich.comparison import LABEL as COMPARISON
from verify.paper.sandwich.numbers import (
    C_0,
    G_POSITIVE,
    HALF,
    Q_0,
    SUMS,
    U_0,
    Theta,
    U_b,
    duration,
    gain,
    model,
    ratio,
    turning,
    w_0,
    w_1,
    w_b,
)

GOES_ON = "comparison"
#: The pairs of vectors for which Cauchy-Schwarz is used.
PAIRS = ("cs-omega", "cs-s", "cs-c", "cs-a", "cs-b", "cs-w", "cs-impact", "cs-angle")

_GHOSTS = {
    "g": ("Λⁿη₀", r"\Lambda^n\eta_0"),
    "clock": ("t_n", "t_n"),
    "Q": ("Q", "Q"),
    "U": ("U", "U"),
    "w_c": ("w_c", "w_c"),
    "w_s": ("w_s", "w_s"),
}
g, clock, Q, U, w_c, w_s = map(symbol, _GHOSTS)
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
#: The next state.
FOLLOWING: Mapping[str, Term] = after_the_collision() | {
    "g": ratio * g,
    "clock": clock + tau,
    "Q": Q_next,
    "U": U_next,
    "w_c": w_s,
    "w_s": w_c,
}
carried = Carried(CONDITIONS, FOLLOWING)

_ghosts: dict[str, Term] = {
    "g": start.y,
    "clock": as_term(0),
    "Q": Q_0,
    "U": U_0,
    "w_c": w_0,
    "w_s": w_1,
}
#: Where the recursion starts.
beginning: dict[str, Term] = start._asdict() | _ghosts

#: Velocities for which Cauchy-Schwarz is seen to hold: normal but for orthogonal parts.
point_frame = aligned(start.y, start.eta_s, C_0, start.A, start.B, start.d)
point: dict[str, Term] = point_frame._asdict() | _ghosts


def context() -> Context:
    """The states that satisfy the conditions."""
    standing = inequalities(frame, time_of(frame), PAIRS)
    goes_on = {"approaches": here.approaches, "meets": here.meets}
    more = (Given(name, claim, "standing", GOES_ON) for name, claim in goes_on.items())
    letters = LETTERS | _GHOSTS
    return Context(
        CONTEXT,
        tuple(Variable(name, *letters[name]) for name in (*NAMES, *_GHOSTS)),
        (*carried.givens(standing), *more),
        point,
        START,
        "a state just after a collision that satisfies the conditions",
        followed(COMPARISON, model.rho(w_c, w_s), here.P, here.load, model.share, U),
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
    yield from _root(claims)
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


def _root(claims: dict[str, Claim]) -> Iterator[Item]:
    root = substitute_claim(0 < root_of(frame), beginning)
    yield from (
        Line("start-Cnd3",    claims["Cnd3"],
             proof("start-u", times("start-d", plus(2, "start-d"), "start-A-below"),
                   times(power(plus("U_0-bound", "U-room"), 2),
                         power("start-d-sum-positive", 2), power("start-y", 2)))),
        Line("start-root",     root, ByRoot()),
        Line("start-root-sum", claims["root-sum"], proof(1, "start-root")),
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
    yield from _vectors()


def _vectors() -> Iterator[Item]:
    """Cauchy-Schwarz at the point."""
    p, time = point_frame, time_of(point_frame)
    values = {"u_y": p.y, "u_s": p.eta_s, "u_C": p.C, "u_A": p.A, "u_B": p.B, "u_d": p.d}
    values["u_t"] = time
    givens = ("at-angle", "start-cs-c", "start-cs-s")
    for name, claim in inequalities(p, time, PAIRS).items():
        yield Line(f"at-{name}", claim, ByInstance(f"{PLANE}-{name}", values, givens))


def opening() -> tuple[str, ...]:
    """Why the givens of a state hold at the point."""
    vectors = (f"at-{name}" for name in PAIRS)
    return (*map(at_point, CONDITIONS), *vectors, "start-approaches", "start-meets")
