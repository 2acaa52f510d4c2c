"""The laws and estimates that the proof of Theorem 1 prints and that fail for some allowed state.

Each printed row is false at a state of `printed_states` that satisfies all conditions, and names
the row of the step, or of the theorem, that has the right formula. Where that is a law or follows
from the state alone, it is proved here too, under the same name, for the same states.
"""

from __future__ import annotations

from collections.abc import Iterator

from verify.language.argument import (
    ByEntry,
    Item,
    Line,
    identity,
    plus,
    power,
    proof,
    scaled,
    square,
    times,
)
from verify.language.statement import NEEDED, Obligation
from verify.language.terms import Claim, as_term, equal
from verify.paper.groups import REPAIRED
from verify.paper.parameters import V_0, c, r
from verify.paper.preliminaries import delta_2, h_4, h_5
from verify.paper.rows import BREAKS, HARMLESS, SLIP, misprint
from verify.paper.step.printed_states import (
    CONTEXT,
    A,
    A_next,
    B,
    B_next,
    C,
    D,
    D_C_next,
    D_y_next,
    S,
    W_c,
    W_s,
    d,
    dot,
    eta_s,
    k,
    kappa,
    magnitude,
    omega_c,
    omega_s,
    spin,
    tau,
    x,
    y,
    zeta,
)

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
            yield Obligation(item.name, RIGHT, item.label,
                             NEEDED, item.says, item.claim, context=CONTEXT)  # fmt: skip
