"""The laws and estimates that the proof of Theorem 1 prints and that fail for some allowed state.

A state is three particles in space just after a collision, by coordinates, with what the next
collision needs: its time, where the particles are then, and how fast they meet. Nothing is assumed
of vectors, and no formula of the paper but the definitions of the collision and of the constants.

Each printed row is false at a state that satisfies all conditions of the recursion as they are
printed, and names the row of the step, or of the theorem, that has the right formula. Where that is
a law or follows from the state alone, it is proved here too, under the same name, for the same
states.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from types import SimpleNamespace

from verify.language.argument import (
    ByEntry,
    Item,
    Line,
    identity,
    plus,
    power,
    proof,
    row_of,
    scaled,
    square,
    times,
)
from verify.language.record import Record
from verify.language.statement import Constant, Context, Given, Obligation, Variable
from verify.language.terms import Claim, Term, as_term, equal, maximum, sqrt, symbol
from verify.paper.parameters import PRINTED, REPAIRED, V_0, c, r
from verify.paper.rows import BREAKS, HARMLESS, SLIP, misprint
from verify.paper.theorem1 import theorem

CONTEXT = "printed-state"
#: Theorem 1 at a point where the fixed points are rational.
PARAMETERS = {"r": "3/100", "c": "95/103", "V_0": "1", "delta_theta": "1/10"}

C_eta, alpha_0, delta_2, h_4, h_5, phi_minus = map(
    symbol, ("C_eta", "alpha_0", "delta_2", "h_4", "h_5", "phi_minus")
)
_own = ("delta_x", "delta_y", "eta_bar", "zeta_bar", "d_slope", "d_const")
k = SimpleNamespace(V_1=symbol("V_1"), **{name: symbol(f"{PRINTED}.{name}") for name in _own})
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


NAME = "step-printed"
TITLE = (
    "The laws and estimates of the recursion that fail as they are printed, each at a state in "
    "space that satisfies all printed conditions, for r = 3/100, -cos θ₀ = 95/103, V₀ = 1, "
    "δ_θ = 1/10; and the right ones beside them"
)
NORMS, ANGLE = "EQUATSS4.1EvoluNormeVitRl", "EQUATSS4.1EvoluCosinAngle"
RIGHT, WRONG = "right", "state"

turn = D_C_next - D * C
sides = magnitude(1 + d - D) * C + magnitude(dot(omega_s, W_c)) * tau
sides = sides + (1 + d) * magnitude(dot(omega_c, W_s)) * tau
last = magnitude(dot(W_s, W_c)) * tau**2


# --- what is right --------------------------------------------------------------------------------


def lines() -> Iterator[Item]:
    """The right formulas, for all states that satisfy the conditions."""
    half = (1 + r) / 2
    yield from (
        Line("law-norm-c", equal(A_next, B - (1 + r) * kappa * spin + half**2 * kappa**2),
             identity("", (("contact", half**2 * kappa**2),)),
             NORMS, "|W_c'|² = |W_s|² - (1+r)(W_c·ω_s')(W_s·ω_s') + ((1+r)²/4)(W_c·ω_s')²"),
        Line("law-norm-s", equal(B_next, A - (1 - r**2) * kappa**2),
             identity("", (("contact", (1 + r) ** 2 * kappa**2),)),
             NORMS, "|W_s'|² = |W_c|² - (1-r²)(W_c·ω_s')²: less than |W_c|²"),
        Line("distance",   D - 1 <= eta_s * tau + B * tau**2 / 2,
             scaled(times(2, "goal"), square(D - 1))
             ._replace(equations=(("D-square", as_term(-1)), ("unit-s", as_term(-1)))),
             "EQUATSS4.1BorneDista_d_1_", "d' ≤ η_sτ + |W_s|²τ²/2"),
    )  # fmt: skip
    yield from _time()
    yield from _turn()


def _time() -> Iterator[Item]:
    room = times(power("d-sum-positive", 2), power("Cnd1", 2))
    yield from (
        Line("d-sum-positive", 0 < 1 + d, proof("d-positive", 1)),
        Line("A-positive",     0 < A, proof("Cnd5-c-lower", "V_0-sign")),
        Line("time",           equal(A * tau, (1 + d) * y * (1 - S)),
             identity("", (("impact", as_term(1)),))),
        Line("S-square",       equal((1 - S**2) * (1 + d) ** 2 * y**2, d * (2 + d) * A),
             identity("",
                      (("impact", kappa - (1 + d) * S * y), ("contact", -A),
                       ("unit-c", (1 + d) ** 2 * A))),
             "EQUATSS4.1Recurrence_Cnd3", "ζ = 1 - S² = d(2+d)|W_c|²/((1+d)²η_c²)"),
        Line("S-one",          0 < 1 - S,
             scaled(times("goal", plus(1, "S-positive"), room),
                    times("d-positive", plus(2, "d-positive"), "A-positive"))
             ._replace(equations=(("S-square", as_term(1)),))),
        Line("time-product",   A * tau <= (1 + d) * y * zeta,
             proof(times("d-sum-positive", "Cnd1", "S-positive", "S-one"),
                   equations=(("time", as_term(-1)),)), "EQUATSS4.1_Controle_Tau_n",
             "τ/(-η_c) ≤ (1+d)ζ/|W_c|², which bounds (τ/η_c)² by 4ζ²/|W_c|⁴ where d ≤ 1"),
    )  # fmt: skip


def _turn() -> Iterator[Item]:
    parts = {
        "near": 1 + d - D,
        "side-s": dot(omega_s, W_c),
        "side-c": dot(omega_c, W_s),
        "both": dot(W_s, W_c),
    }
    for name, term in parts.items():
        yield Line(f"{name}-upper", term <= magnitude(term), ByEntry(side="rhs"))
        yield Line(f"{name}-lower", -term <= magnitude(term), ByEntry(side="rhs"))
    for side, other, claim in (
        ("upper", "lower", turn <= sides + last),
        ("lower", "upper", -turn <= sides + last),
    ):
        yield Line(f"angle-step-{side}", claim,
                   proof(times(f"near-{side}", "obtuse"), times(f"side-s-{other}", "tau-positive"),
                         times("d-sum-positive", f"side-c-{other}", "tau-positive"),
                         times(f"both-{other}", power("tau-positive", 2))),
                   ANGLE, "(1+d')|cos θ' - cos θ| ≤ |d-d'|(-cos θ) + … + |W_s·W_c| τ²")  # fmt: skip


# --- what is printed ------------------------------------------------------------------------------


#: The states at which rows are false that the first one does not refute.
FALSE_AT = {
    "state.norm-lower": "slow",
    "state.term-2-sign": "left",
    "state.angle-sign": "space",
    "state.angle-eighth": "late",
}
FIRST = "right"


def printed() -> Iterator[Obligation]:
    """What is printed, in the paper's order."""
    yield from (
        _wrong("law-norm-c", NORMS,
               "|W_c'|² = |W_s|² - (1+r)(W_c·ω_s')(W_s·ω_s') + ((1+r)²/2)(W_c·ω_s')²: the half ≥ "
               "of it fails, as the last divisor is 4 (harmless: only 2 is used)",
               B - (1 + r) * kappa * spin + (1 + r) ** 2 / 2 * kappa**2 <= A_next, HARMLESS,
               "law-norm-c"),
        _wrong("d-index",    "EQUATSS4.1_Controle_Tau_n",
               "d_n ≤ |η_{s,n}|τ_n + |W_{s,n}|²τ_n²/2: this bounds d_{n+1}",
               d <= magnitude(eta_s) * tau + B * tau**2 / 2, SLIP, "distance"),
        _wrong("norm-lower", "EQUATSS4.1Recurrence_Cnd5",
               "V₀ ≤ |W_{s,n+1}|²: Cnd6 and Cnd7 bound the norms from above only", V_0 <= B_next,
               SLIP, "next-B-lower"),
    )  # fmt: skip
    yield from _zeta()
    yield from _angle()


def _zeta() -> Iterator[Obligation]:
    label = "EQUATSS4.1Recurrence_Cnd4"
    ratio, square = A_next / A, (D_y_next / (D * y)) ** 2
    second = ratio / square * (x / y)
    least = V_0 / k.V_1 * (delta_2**2 * h_5 / 12)
    rest = ratio / square * (eta_s / y + 4 * (B / A)) * zeta
    following = (D**2 - 1) * A_next / D_y_next**2
    yield from (
        _wrong("time-square", label,
               "τ_n/(-η_{c,n}) ≤ 4ζ_n²/|W_{c,n}|⁴: it bounds the square of the left side",
               tau / y <= 4 * zeta**2 / A**2, SLIP, "time-product"),
        _wrong("x-small",     "EQUATSS4.1Recurrence_Cnd9",
               "Cnd9 implies |x_n| ≤ (V₀/V₁) δ₂² h₅/12: only |x₀| is so small",
               magnitude(x) <= least * y, BREAKS, f"{REPAIRED}.zeta-x-bound"),
        _wrong("term-2-sign", label,
               "second term of ζ_{n+1}: |…x_n| ≤ (V₁/V₀) x_n/δ₂²: x_n for |x_n|",
               magnitude(second) <= k.V_1 / V_0 / delta_2**2 * (x / y), SLIP,
               f"{REPAIRED}.zeta-term-2-denominator"),
        _wrong("term-2",      label, "second term of ζ_{n+1}: |…x_n| ≤ h₅/12",
               magnitude(second) <= h_5 / 12, BREAKS, f"{REPAIRED}.zeta-term-2"),
        _wrong("three-terms", label, "the three remainder terms of ζ_{n+1} ≤ h₅/4",
               magnitude(second + rest) <= h_5 / 4, BREAKS, f"{REPAIRED}.zeta-remainders"),
        _wrong("zeta-falls",  label, "ζ_{n+1} ≤ (1 - h₅/4) ζ_n", following <= (1 - h_5 / 4) * zeta,
               BREAKS, f"{REPAIRED}.zeta-total"),
        _wrong("zeta-next",   label,
               "ζ_{n+1} ≤ ζ̄: the conditions at n, with the printed constants, do not give Cnd4 at "
               "n+1", following <= k.zeta_bar, BREAKS, "next-Cnd4"),
    )  # fmt: skip


def _angle() -> Iterator[Obligation]:
    change, display = magnitude(turn), sides - last
    yield from (
        _wrong("angle-equation", ANGLE,
               "|cos θ' - cos θ| = a sum of absolute values: the half ≥ of it fails, ≤ is meant",
               display <= change, SLIP, "angle-step-upper"),
        _wrong("angle-sign",     ANGLE,
               "|cos θ' - cos θ| ≤ … - |W_s·W_c| τ²/(1+d'): + is meant (in dimension 3, where "
               "W_s·W_c < 0 may go with ω_s·W_c < 0 and ω_c·W_s < 0)", change <= display, SLIP,
               "angle-step-upper"),
        _wrong("angle-eighth",   "EQUATSS4.1Recurrence_Cnd10",
               "|(-cos θ_{n+1}) - (-cos θ₀)| ≤ h₄δ_x/8: Cnd8 allows more, as 1/33 in η̄ has no "
               "1-C_η (harmless: in y_n the left side has the factor (1+r)/2)",
               magnitude(D_C_next / D - c) <= h_4 * k.delta_x / 8, HARMLESS, "angle-upper"),
    )  # fmt: skip


def _wrong(
    name: str, label: str, says: str, claim: Claim, severity: str, corrected_by: str
) -> Obligation:
    return misprint(f"{WRONG}.{name}", label, says, claim, group=WRONG, severity=severity,
                    corrected_by=corrected_by, context=CONTEXT)  # fmt: skip


def needed() -> Iterator[Obligation]:
    """The right formulas that are proved here."""
    for item in lines():
        if isinstance(item, Line) and item.says:
            yield row_of(item, RIGHT, CONTEXT)
