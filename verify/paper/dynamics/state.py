"""A state just after a collision, in inner products, and the state after the next one.

The particle that just collided is s, the one that will collide next is c; both are seen from the
central one. W are relative velocities, omega unit vectors to the particles, 1 + d the distance of
particle c, y = -eta_c its speed of approach. `EQUATSS4.1SysteDynamColSp` gives the next state.
"""

from __future__ import annotations

from collections.abc import Iterable

from verify.language.statement import Constant
from verify.language.terms import Claim, Term, sqrt, symbol
from verify.language.vectors import Combination, Frame, W_c, W_s, add, omega_c, omega_s, scale

CONTEXT = "state"
DYNAMICS = "EQUATSS4.1SysteDynamColSp"

#: The numbers of a state, as people write them.
LETTERS = {
    "y": ("-η_c", r"-\eta_c"),
    "eta_s": ("η_s", r"\eta_s"),
    "C": ("-cos θ", r"-\cos\theta"),
    "a": ("ω_s·W_c", r"\omega_s\cdot W_c"),
    "b": ("ω_c·W_s", r"\omega_c\cdot W_s"),
    "A": ("|W_c|²", "|W_c|^2"),
    "B": ("|W_s|²", "|W_s|^2"),
    "w": ("W_s·W_c", r"W_s\cdot W_c"),
    "d": ("d", "d"),
}
NAMES = tuple(LETTERS)
r = symbol("r")
y, eta_s, C, a, b, A, B, w, d = map(symbol, NAMES)
frame = Frame(y, eta_s, C, a, b, A, B, w, d)


def zeta_of(f: Frame) -> Term:
    """The parameter of Zhou and Kadanoff."""
    return f.d * (2 + f.d) / (1 + f.d) / (1 + f.d) * (f.A / f.y / f.y)


def root_of(f: Frame) -> Term:
    """The root in the time to the next collision."""
    return sqrt(1 - zeta_of(f))


def tau_of(f: Frame) -> Term:
    """The time to the next collision."""
    return (1 + f.d) / f.A * f.y * (1 - root_of(f))


def time_of(f: Frame) -> Term:
    """The same time without a quotient by |W_c|^2."""
    return f.d * (2 + f.d) / (1 + f.d) / f.y / (1 + root_of(f))


def contact(f: Frame, time: Term) -> Combination:
    """Where particle c is after some time: omega_s of the next state, at the contact."""
    return add(scale(1 + f.d, omega_c), scale(time, W_c))


def away(time: Term) -> Combination:
    """Where particle s is after some time."""
    return add(omega_s, scale(time, W_s))


difference = add(W_c, scale(-1, W_s))


def inequalities(f: Frame, time: Term, names: Iterable[str]) -> dict[str, Claim]:
    """The Cauchy-Schwarz inequalities of these names, for a state and the time to its collision."""
    pairs = _pairs(f, time)
    return {name: f.cauchy_schwarz(*pairs[name]) for name in names}


def _pairs(f: Frame, time: Term) -> dict[str, tuple[Combination, Combination]]:
    omega, end = contact(f, time), away(time)
    outer = add(scale(1 + f.d, omega_c), scale(-1, omega_s))
    return {
        "cs-omega": (omega_s, omega_c),
        "cs-s": (omega_s, W_s),
        "cs-c": (omega_c, W_c),
        "cs-a": (omega_s, W_c),
        "cs-b": (omega_c, W_s),
        "cs-w": (W_s, W_c),
        "cs-outer": (omega_c, difference),
        "cs-apart": (outer, difference),
        "cs-impact": (W_s, omega),
        "cs-angle": (omega, end),
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


def collision_map(time: Term) -> tuple[Constant, ...]:
    """The collision map, written out in inner products."""
    dot = frame.dot
    terms = {
        "zeta": ("ζ", r"\zeta", zeta_of(frame)),
        "S": ("√(1-ζ)", r"\sqrt{1-\zeta}", root_of(frame)),
        "tau": ("τ", r"\tau", time),
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


def after_the_collision() -> dict[str, Term]:
    """The next state: the particles have exchanged their roles."""
    return {name: symbol(f"{name}_next") for name in NAMES}
