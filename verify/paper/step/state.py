"""A state just after a collision, what is assumed of it, and the state after the next one.

The particle that just collided is s, the one that will collide next is c; both are seen from the
central one. W are relative velocities, omega unit vectors to the particles, 1 + d the distance of
particle c, y = -eta_c its speed of approach. `EQUATSS4.1SysteDynamColSp` gives the next state.
"""

from __future__ import annotations

from collections.abc import Mapping

from verify.language.statement import Constant, Context, Given, Variable
from verify.language.terms import Claim, Term, sqrt, substitute_claim, symbol
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
    r,
    share,
    speed,
    third,
    zeta_bar,
)
from verify.paper.step.vectors import Combination, Frame, W_c, W_s, add, omega_c, omega_s, scale

CONTEXT = "state"
CAUCHY_SCHWARZ = "cauchy-schwarz"
DYNAMICS = "EQUATSS4.1SysteDynamColSp"

y, eta_s, C, a, b, A, B, w, d, g, clock = map(
    symbol, ("y", "eta_s", "C", "a", "b", "A", "B", "w", "d", "g", "clock")
)
frame = Frame(y, eta_s, C, a, b, A, B, w, d)

#: The sum over all later collisions of what one of them changes, per unit of g.
beta = 14 / (1 - C_eta) * (speed / V_0)
norm_sum = 4 * (speed + 2) / (1 - C_eta)
time_sum = 2 / (V_0 * (1 - C_eta)) * zeta_bar


def zeta_of(f: Frame) -> Term:
    """The parameter of Zhou and Kadanoff."""
    return f.d * (2 + f.d) / (1 + f.d) / (1 + f.d) * (f.A / f.y / f.y)


def tau_of(f: Frame) -> Term:
    """The time to the next collision."""
    return (1 + f.d) / f.A * f.y * (1 - sqrt(1 - zeta_of(f)))


def contact(f: Frame, time: Term) -> Combination:
    """Where particle c is after some time: omega_s of the next state, at the contact."""
    return add(scale(1 + f.d, omega_c), scale(time, W_c))


def away(time: Term) -> Combination:
    """Where particle s is after some time."""
    return add(omega_s, scale(time, W_s))


difference = add(W_c, scale(-1, W_s))


def inequalities(f: Frame, time: Term) -> dict[str, Claim]:
    """The Cauchy-Schwarz inequalities that are used, for a state and the time to its collision."""
    omega, end = contact(f, time), away(time)
    pairs = {
        "cs-omega": (omega_s, omega_c),
        "cs-s": (omega_s, W_s),
        "cs-c": (omega_c, W_c),
        "cs-a": (omega_s, W_c),
        "cs-b": (omega_c, W_s),
        "cs-w": (W_s, W_c),
        "cs-outer": (omega_c, difference),
        "cs-impact": (W_s, omega),
        "cs-angle": (omega, end),
    }
    return {name: f.cauchy_schwarz(*pair) for name, pair in pairs.items()}


def conditions() -> dict[str, Claim]:
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


# --- the next state ------------------------------------------------------------------------------

zeta, S, tau, kappa, D = map(symbol, ("zeta", "S", "tau", "kappa", "D"))
d_next, C_next, y_next, eta_s_next = map(symbol, ("d_next", "C_next", "y_next", "eta_s_next"))
a_next, b_next, A_next, B_next, w_next = map(
    symbol, ("a_next", "b_next", "A_next", "B_next", "w_next")
)
#: The two parts of the normal component of W_s after the flight.
kept, gained = symbol("kept"), symbol("gained")
omega_next = contact(frame, tau)
end = away(tau)
turned = {name: value / D for name, value in end.items()}
W_c_next = add(W_s, scale(-((1 + r) / 2 * kappa), omega_next))
W_s_next = add(W_c, scale(-((1 + r) * kappa), omega_next))


def collision_map() -> tuple[Constant, ...]:
    """The collision map, written out in inner products."""
    dot = frame.dot
    terms = {
        "zeta": ("ζ", r"\zeta", zeta_of(frame)),
        "S": ("√(1-ζ)", r"\sqrt{1-\zeta}", sqrt(1 - zeta_of(frame))),
        "tau": ("τ", r"\tau", tau_of(frame)),
        "kappa": ("W_c·ω_s'", r"W_c\cdot\omega_s'", dot(W_c, omega_next)),
        "D": ("1+d'", "1+d'", sqrt(dot(end, end))),
        "d_next": ("d'", "d'", D - 1),
        "C_next": ("-cos θ'", r"-\cos\theta'", -dot(omega_next, turned)),
        "y_next": ("-η_c'", r"-\eta_c'", -dot(W_c_next, turned)),
        "eta_s_next": ("η_s'", r"\eta_s'", dot(W_s_next, omega_next)),
        "A_next": ("|W_c'|²", r"|W_c'|^2", dot(W_c_next, W_c_next)),
        "B_next": ("|W_s'|²", r"|W_s'|^2", dot(W_s_next, W_s_next)),
        "kept": ("η_s/(1+d')", r"\eta_s/(1+d')", eta_s / D),
        "gained": ("τ|W_s|²/(1+d')", r"\tau|W_s|^2/(1+d')", tau * B / D),
        "a_next": ("ω_s'·W_c'", r"\omega_s'\cdot W_c'", dot(omega_next, W_c_next)),
        "b_next": ("ω_c'·W_s'", r"\omega_c'\cdot W_s'", dot(turned, W_s_next)),
        "w_next": ("W_s'·W_c'", r"W_s'\cdot W_c'", dot(W_s_next, W_c_next)),
    }
    return tuple(
        Constant(name, letter, tex, DYNAMICS, term) for name, (letter, tex, term) in terms.items()
    )


def following() -> dict[str, Term]:
    """The next state: the particles have exchanged their roles."""
    names = ("y", "eta_s", "C", "a", "b", "A", "B", "w", "d")
    values = {name: symbol(f"{name}_next") for name in names}
    return values | {"g": C_eta * g, "clock": clock + tau}


def at_next(claim: Claim) -> Claim:
    """A claim about the state, said of the next one."""
    return substitute_claim(claim, following())


_LETTERS = {
    "y": ("-η_c", r"-\eta_c"),
    "eta_s": ("η_s", r"\eta_s"),
    "C": ("-cos θ", r"-\cos\theta"),
    "a": ("ω_s·W_c", r"\omega_s\cdot W_c"),
    "b": ("ω_c·W_s", r"\omega_c\cdot W_s"),
    "A": ("|W_c|²", "|W_c|^2"),
    "B": ("|W_s|²", "|W_s|^2"),
    "w": ("W_s·W_c", r"W_s\cdot W_c"),
    "d": ("d", "d"),
    "g": ("C_ηⁿ|η_{c,0}|", r"C_\eta^n|\eta_{c,0}|"),
    "clock": ("t_n", "t_n"),
}


def variables() -> tuple[Variable, ...]:
    """The numbers of a state."""
    return tuple(Variable(name, *letters) for name, letters in _LETTERS.items())


def context(parent: str, point: Mapping[str, Term]) -> Context:
    """The states that satisfy the conditions of the recursion."""
    carried = (Given(name, claim, "carried") for name, claim in conditions().items())
    standing = (
        Given(name, claim, "standing", CAUCHY_SCHWARZ)
        for name, claim in inequalities(frame, tau_of(frame)).items()
    )
    return Context(
        CONTEXT,
        variables(),
        (*carried, *standing),
        point,
        parent,
        "a state just after a collision that satisfies the conditions of the recursion",
        collision_map(),
    )
