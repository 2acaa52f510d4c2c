"""What is carried from state to state: bounds that do not depend on n, and sums so far."""

from __future__ import annotations

from verify.language.statement import Context, Given, Variable
from verify.language.terms import Claim, Term, as_term, substitute_claim, symbol
from verify.paper.dynamics.plane import aligned
from verify.paper.dynamics.state import (
    CONTEXT,
    LETTERS,
    NAMES,
    A,
    B,
    C,
    after_the_collision,
    collision_map,
    d,
    eta_s,
    frame,
    inequalities,
    root_of,
    tau,
    time_of,
    y,
    zeta_of,
)
from verify.paper.sharper import numbers
from verify.paper.sharper.numbers import (
    C_0,
    V_0,
    Theta,
    V,
    X,
    duration,
    eta_0,
    gain,
    k,
    m,
    ratio,
    start,
    total,
)

CAUCHY_SCHWARZ = "cauchy-schwarz"
#: The pairs of vectors for which Cauchy-Schwarz is used.
PAIRS = ("cs-omega", "cs-s", "cs-c", "cs-a", "cs-b", "cs-w", "cs-apart", "cs-impact")

#: g stands for ratio^n eta_0, clock for the time; `speed` bounds the speeds in this state.
g, clock = symbol("g"), symbol("clock")
speed = V - gain * g
speed_next = V - gain * (ratio * g)


def conditions() -> dict[str, Claim]:
    """What is carried from state to state."""
    return {
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


def following() -> dict[str, Term]:
    """The next state."""
    return after_the_collision() | {"g": ratio * g, "clock": clock + tau}


def at_next(claim: Claim) -> Claim:
    """A claim about the state, said of the next one."""
    return substitute_claim(claim, following())


#: Where the recursion starts.
beginning: dict[str, Term] = start._asdict() | {"g": eta_0, "clock": as_term(0)}

#: Velocities for which Cauchy-Schwarz is seen to hold: normal but for orthogonal parts.
point_frame = aligned(start.y, start.eta_s, C_0, V_0**2, V_0**2, start.d)
point: dict[str, Term] = point_frame._asdict() | {"g": eta_0, "clock": as_term(0)}


def context() -> Context:
    """The states that satisfy the conditions."""
    carried = (Given(name, claim, "carried") for name, claim in conditions().items())
    standing = (
        Given(name, claim, "standing", CAUCHY_SCHWARZ)
        for name, claim in inequalities(frame, time_of(frame), PAIRS).items()
    )
    letters = {**LETTERS, "g": ("(p+Y)ⁿη₀", r"(p+Y)^n\eta_0"), "clock": ("t_n", "t_n")}
    return Context(
        CONTEXT,
        tuple(Variable(name, *letters[name]) for name in (*NAMES, "g", "clock")),
        (*carried, *standing),
        point,
        numbers.CONTEXT,
        "a state just after a collision that satisfies the conditions",
        collision_map(time_of(frame)),
    )
