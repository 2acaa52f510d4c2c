"""States in space that satisfy the conditions of the recursion as they are printed.

A state is three particles just after a collision, by coordinates, with what the next collision
needs: its time, where the particles are then, and how fast they meet. Nothing is assumed of
vectors, and no formula of the paper but the definitions of the collision and of the constants.
"""

from __future__ import annotations

from collections.abc import Mapping

from verify.language.record import Record
from verify.language.statement import Constant, Context, Given, Variable
from verify.language.terms import Claim, Term, as_term, equal, maximum, sqrt, symbol
from verify.paper.groups import PRINTED
from verify.paper.initial_data import ConstantSet
from verify.paper.parameters import V_0, c, r
from verify.paper.preliminaries import C_eta, alpha_0, h_4, phi_minus
from verify.paper.theorem1 import theorem

CONTEXT = "printed-state"
#: Theorem 1 at a point where the fixed points are rational.
PARAMETERS = {"r": "3/100", "c": "95/103", "V_0": "1", "delta_theta": "1/10"}

k = ConstantSet(PRINTED)
AXES = ("1", "2", "3")
VECTORS = ("omega_s", "W_s", "omega_c", "W_c")
NUMBERS = ("d", "S", "tau", "D", "g", "d_0", "decay")
Vector = tuple[Term, ...]

omega_s, W_s, omega_c, W_c = (tuple(symbol(f"{name}_{i}") for i in AXES) for name in VECTORS)
d, S, tau, D, g, d_0, decay = map(symbol, NUMBERS)


def dot(x: Vector, z: Vector) -> Term:
    """The inner product."""
    first, *others = (p * q for p, q in zip(x, z, strict=True))
    return sum(others, start=first)


def along(x: Vector, t: Term, z: Vector) -> Vector:
    """The vector x + t z."""
    return tuple(p + t * q for p, q in zip(x, z, strict=True))


def magnitude(term: Term) -> Term:
    """The absolute value."""
    return maximum(term, -term)


y, eta_s, C = -dot(W_c, omega_c), dot(W_s, omega_s), -dot(omega_s, omega_c)
A, B, zeta = dot(W_c, W_c), dot(W_s, W_s), 1 - S**2
far = tuple((1 + d) * x for x in omega_c)

# At the next collision and after it. What has D in front is not divided by 1 + d'.
contact, end = along(far, tau, W_c), along(omega_s, tau, W_s)
kappa, spin = dot(W_c, contact), dot(W_s, contact)
W_c_next = along(W_s, -((1 + r) / 2 * kappa), contact)
W_s_next = along(W_c, -((1 + r) * kappa), contact)
A_next, B_next = dot(W_c_next, W_c_next), dot(W_s_next, W_s_next)
D_C_next, D_y_next = -dot(contact, end), -dot(W_c_next, end)
x = eta_s - phi_minus * y


# --- the states -----------------------------------------------------------------------------------


def signs() -> Mapping[str, Claim]:
    """What shows that the conditions are defined."""
    return {
        "V_0-sign": 0 < V_0,
        "V_1-sign": 0 < k.V_1,
        "C_eta-sign": 0 < C_eta,
        "decay-sign": 0 < 1 - C_eta,
    }


def conditions() -> Mapping[str, Claim]:
    """Cnd1 to Cnd10 and CndT at n, as printed; decay is C_η^n with n ≥ 1, g is -η_{c,0}.

    At the time tau particle c is in contact for the first time, as it then approaches, with the
    normal velocity -(1+d) S (-η_c); D is the distance of the other one. CndT is in a form that
    implies it, Cnd9 in the improved form of `EQUATSS4.1Cntrlx_n+1Ameli`. That the angle is obtuse
    is what the paper deduces from Cnd8.
    """
    return _collision() | _start() | _recursion()


def _collision() -> dict[str, Claim]:
    return {
        "unit-s": equal(dot(omega_s, omega_s), 1),
        "unit-c": equal(dot(omega_c, omega_c), 1),
        "d-positive": 0 < d,
        "recedes": 0 < eta_s,
        "Cnd1": 0 < y,
        "obtuse": 0 < C,
        "tau-positive": 0 < tau,
        "contact": equal(dot(contact, contact), 1),
        "S-positive": 0 < S,
        "impact": equal(kappa, -((1 + d) * S * y)),
        "D-positive": 0 < D,
        "D-square": equal(D**2, dot(end, end)),
    }


def _start() -> dict[str, Claim]:
    return {
        "later": 0 < decay,
        "not-first": decay <= C_eta,
        "start-eta": g <= k.eta_bar,
        "start-d-positive": 0 < d_0,
        "start-d-const": d_0 <= k.d_const,
        "start-d-slope": d_0 <= k.d_slope * g**2,
    }


def _recursion() -> dict[str, Claim]:
    apart, drift = along(far, as_term(-1), omega_s), along(W_c, as_term(-1), W_s)
    left, right = d * (2 + d) * A, (1 + d) ** 2 * y**2
    speed, third = sqrt(k.V_1), (k.V_1 - V_0) / 3
    norms = k.V_1 - third + 4 * (speed + 2) / (1 - C_eta) * (1 - decay) * g
    angle = speed / V_0 * g * (3 + 11 * C_eta) / (1 - C_eta)
    first = d_0 + 11 * (speed / V_0) * g
    before, after = first + angle * (1 - decay / C_eta), first + angle * (1 - decay)
    spread, gap = (1 - h_4 / 2) * k.delta_x * y, (alpha_0 - phi_minus) * y
    return {
        "Cnd2": y <= decay * g,
        "Cnd3": left < right,
        "Cnd4": left <= k.zeta_bar * right,
        "CndT": 1 < dot(apart, apart) - 2 * tau * magnitude(dot(apart, drift)),
        "Cnd5-c-lower": V_0 <= A,
        "Cnd5-c-upper": A <= k.V_1,
        "Cnd5-s-lower": V_0 <= B,
        "Cnd5-s-upper": B <= k.V_1,
        "Cnd6-c": A <= norms,
        "Cnd6-s": B <= norms,
        "Cnd8-before": magnitude(C - c) <= before,
        "Cnd8": magnitude(D_C_next - c * D) <= D * after,
        "Cnd9": magnitude(x) <= spread,
        "Cnd10": magnitude(D_y_next - D * gap) <= D * k.delta_y * y,
    }


def context(point: Mapping[str, Term]) -> Context:
    """The states that satisfy the conditions."""
    letters = {name: (name, name) for name in (*VECTORS, *NUMBERS)}
    letters |= {
        "omega_s": ("ω_s", r"\omega_s"),
        "omega_c": ("ω_c", r"\omega_c"),
        "S": ("√(1-ζ)", r"\sqrt{1-\zeta}"),
        "tau": ("τ", r"\tau"),
        "D": ("(1+d')", "(1+d')"),
        "g": ("|η_{c,0}|", r"|\eta_{c,0}|"),
        "d_0": ("d₀", "d_0"),
        "decay": ("C_ηⁿ", r"C_\eta^n"),
    }
    coordinates = [
        Variable(f"{name}_{i}", f"({letters[name][0]})_{i}", f"({letters[name][1]})_{i}")
        for name in VECTORS
        for i in AXES
    ]
    numbers = [Variable(name, *letters[name]) for name in NUMBERS]
    givens = tuple(Given(name, claim) for name, claim in conditions().items())
    says = "three particles just after a collision, which satisfy the printed conditions"
    return Context(CONTEXT, (*coordinates, *numbers), givens, point, None, says)


def constants() -> tuple[Constant, ...]:
    """The printed constants."""
    return (*theorem().common, *theorem().parts[PRINTED].bounds)


# --- the witnesses --------------------------------------------------------------------------------


class Witnessed(Record):
    """A state by few rational numbers; all else is computed from them without a root.

    ``half`` is tan(θ'/2) for the angle θ' of ω_c against -ω_s. ``turn_c`` has the stereographic
    coordinates of ω_s' seen from ω_c, in the plane of ω_s and ω_c and across it; ``turn_s`` those
    of ω_c' from ω_s. ``n`` is the number of collisions before.
    """

    half: str
    y: str
    ratio: str
    tau: str
    turn_c: tuple[str, str]
    turn_s: tuple[str, str]
    n: int = 2


_SHORT = "13/2000000000"
WITNESSES = {
    "right": Witnessed(
        "1/5", "1/20000", "139/1000", _SHORT, ("273/80000000000", "0"), ("273/80000000000", "0")
    ),
    "left": Witnessed(
        "1/5", "1/20000", "11/1000", _SHORT, ("273/80000000000", "0"), ("273/80000000000", "0")
    ),
    "slow": Witnessed(
        "1/5", "1/20000", "75/1000", _SHORT,
        ("20799999987/6400000000000000000", "0"), ("273/80000000000", "0"),
    ),
    "space": Witnessed(
        "1/5", "1/20000", "75/1000", _SHORT,
        ("-39/80000000000000", "273/80000000000"), ("0", "-273/80000000000"),
    ),
    "late": Witnessed(
        "8/41", "1/60000", "75/1000", "13/6000000000",
        ("91/80000000000", "0"), ("91/80000000000", "0"), 5,
    ),
}  # fmt: skip
#: C_η there.
DECAY = "7/10"
#: What stands for -η_{c,0} and d₀ in the conditions. No orbit is shown that reaches the states.
START = ("11/100000", "1/1000000000000")
