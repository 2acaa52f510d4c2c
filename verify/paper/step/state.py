"""What is assumed of a state just after a collision, and the state after the next one."""

from __future__ import annotations

from collections.abc import Mapping

from verify.language.statement import Context
from verify.language.terms import Claim, Term, as_term, symbol
from verify.paper.dynamics.carried import Carried, start
from verify.paper.dynamics.state import (
    A,
    B,
    C,
    collision_map,
    d,
    eta_s,
    frame,
    inequalities,
    tau,
    tau_of,
    y,
    zeta_of,
)
from verify.paper.step.numbers import (
    V_0,
    V_1,
    C_eta,
    c,
    delta_2,
    delta_x,
    drift,
    eighth,
    eta_bar,
    h_4,
    phi_minus,
    share,
    speed,
    third,
    zeta_bar,
)

g, clock = symbol("g"), symbol("clock")

#: The sum over all later collisions of what one of them changes, per unit of g.
beta = 14 / (1 - C_eta) * (speed / V_0)
norm_sum = 4 * (speed + 2) / (1 - C_eta)
time_sum = 2 / (V_0 * (1 - C_eta)) * zeta_bar


#: The pairs of vectors for which Cauchy-Schwarz is used.
PAIRS = ("cs-omega", "cs-s", "cs-c", "cs-a", "cs-b", "cs-w", "cs-outer", "cs-impact", "cs-angle")


def _conditions() -> dict[str, Claim]:
    """What is carried from state to state; g stands for C_eta^n eta_{c,0}, clock for the time."""
    spread = (1 - h_4 / 2) * delta_x * y
    room = drift - d - beta * g
    used = norm_sum * (eta_bar - g)
    return {
        "Cnd1": 0 < y,
        "Cnd2": y <= g,
        "g-bound": g <= eta_bar,
        "d-positive": 0 < d,
        "d-one": d <= 1,
        "d-sum-positive": 0 < 1 + d,
        "d-share": d <= eighth,
        "d-small": d <= delta_2 * share / 2,
        "recedes": 0 < eta_s,
        "A-positive": 0 < A,
        "Cnd3": 0 < 1 - zeta_of(frame),
        "Cnd4": zeta_of(frame) <= zeta_bar,
        "A-upper": A <= V_1 - third + used,
        "A-lower": V_0 + third - used <= A,
        "B-upper": B <= V_1 - third + used,
        "B-lower": V_0 + third - used <= B,
        "Cnd8-upper": C - c <= room,
        "Cnd8-lower": -room <= C - c,
        "Cnd9-upper": eta_s - phi_minus * y <= spread,
        "Cnd9-lower": -spread <= eta_s - phi_minus * y,
        "clock-bound": clock <= time_sum * (eta_bar - g),
    }


#: What is carried from state to state, and what goes along.
carried = Carried(
    _conditions(),
    {
        "g": ("C_ηⁿ|η_{c,0}|", r"C_\eta^n|\eta_{c,0}|", start.y, C_eta * g),
        "clock": ("t_n", "t_n", as_term(0), clock + tau),
    },
)


def context(parent: str, point: Mapping[str, Term]) -> Context:
    """The states that satisfy the conditions of the recursion."""
    return carried.context(
        inequalities(frame, tau_of(frame), PAIRS),
        point,
        collision_map(tau_of(frame)),
        parent=parent,
        says=" of the recursion",
    )
