"""The numbers to which the sharper theorem is applied, as formulas in the printed constants.

With X = (V_0/V_1) delta_2^2 h_5/12, which the paper uses as a bound of every |x_n| and proves for
none but the first, the ratios eta_{s,n}/(-eta_{c,n}) stay between 0 and phi_minus + X, and the
ratios eta_{c,n+1}/eta_{c,n} between phi_plus - 3X/2 and alpha_0 + X.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction

from verify.language.argument import (
    Line,
    Reason,
    ToBeFound,
    identity,
    plus,
    power,
    proof,
    scaled,
    times,
)
from verify.language.statement import Constant, Context
from verify.language.terms import Claim, Term, as_term, equal, substitute, substitute_claim, symbol
from verify.paper.everywhere.chart import HALF, PLUS_R, hypothesis, v
from verify.paper.initial_data import X_0, ConstantSet, alpha_0, delta_2, h_5, phi_minus, phi_plus
from verify.paper.parameters import PRINTED, THEOREM, V_0, c, delta_theta, r

k = ConstantSet(PRINTED)
X, ratio, least, T, Theta = map(symbol, ("x_most", "ratio", "least_ratio", "T", "Theta"))

#: After the constants of the paper.
CONSTANTS = (
    Constant("x_most", "X", "X", X_0, V_0 / k.V_1 * (delta_2**2 * h_5 / 12)),
    Constant("ratio", "Λ", r"\Lambda", THEOREM, alpha_0 + X),
    Constant("least_ratio", "λ", r"\lambda", THEOREM, phi_plus - Fraction(3, 2) * X),
    Constant("T", "T", "T", THEOREM, k.d_slope * (1 + k.zeta_bar)),
    Constant("Theta", "Θ", r"\Theta", THEOREM, 3 * k.zeta_bar * k.eta_bar / v),
)

#: How far -cos theta may be from -cos theta_0 at the start: the print fixes it.
SLACK = Theta / 6
#: The bound of the speeds in the set, whose square is above V_1 - (V_1 - V_0)/3.
SPEED = v - (k.V_1 - V_0) / (6 * v)

_middle = (phi_minus + X) / 2
#: What each number of the sharper theorem is here; its state is the state of the set.
MEANING: Mapping[str, Term] = {
    "r": r,
    "m": _middle,
    "p": (ratio + least) / 2,
    "X": _middle,
    "Y": (ratio - least) / 2,
    "k": k.d_slope,
    "V": v,
    "T": T,
    "V_0": SPEED,
    "eta_0": k.eta_bar,
    "C_0": c,
    "Theta": Theta,
}


TURNS = ("turn_1", "turn_2", "turn_3")
turn_1, turn_2, turn_3 = map(symbol, TURNS)


def turned(start: Context) -> tuple[Constant, ...]:
    """What the angle turns for each power of -eta_c; these are known later.

    The start is that of the sharper theorem.
    """
    terms = {constant.name: constant.term for constant in start.constants}
    return tuple(
        Constant(name, f"G{sign}", f"G_{i}", THEOREM, substitute(terms[name], MEANING))
        for i, (name, sign) in enumerate(zip(TURNS, "₁₂₃", strict=True), 1)
    )


#: How far -cos theta can turn while -eta_c falls from eta_bar to 0.
ALL_TURNS = turn_1 * k.eta_bar + turn_2 * k.eta_bar**2 + turn_3 * k.eta_bar**3


def of(name: str) -> str:
    """The full name of a fact about a constant of the set."""
    return f"{PRINTED}.{name}"


ZETA, ETA, V = of("zeta_bar-positive"), of("eta_bar-positive"), "v-positive"


def asked(start: Context) -> tuple[dict[str, Claim], dict[str, Claim]]:
    """What the sharper theorem asks of the numbers, and what it asks of the state."""
    claims = {name: substitute_claim(claim, MEANING) for name, claim in start.claims.items()}
    state = {name: claim for name, claim in claims.items() if name.startswith("start-")}
    return {name: claims[name] for name in claims if name not in state}, state


def room(start: Context) -> Iterator[Line]:
    """What the sharper theorem asks of the numbers."""
    yield from _sizes()
    for name, claim in asked(start)[0].items():
        yield Line(f"room-{name}", claim, _ROOM.get(name, ToBeFound()))


def conclusions() -> Iterator[Line]:
    """What follows for angle and time."""
    yield from _turning()
    yield from (
        Line("x-bound", k.x_0 <= X, ToBeFound(), X_0,
            "|x₀| ≤ X, and |x_n| ≤ X for every n, by the sharper theorem"),
        Line("final-angle", Theta <= delta_theta, ToBeFound(), THEOREM,
            "|(-cos θ̄) - (-cos θ₀)| ≤ Θ ≤ δ_θ for the final angle"),
        Line("collapse-time", T * k.eta_bar / (1 - ratio) <= k.T_star, ToBeFound(), THEOREM,
            "the collapse time is at most 2η̄ζ̄/(V₀(1-C_η))"),
    )  # fmt: skip


def _sizes() -> Iterator[Line]:
    """How large the numbers can be."""
    r_most = Fraction(1, 8)
    yield from (
        Line("r-small",     r <= r_most, ToBeFound()),
        Line("alpha-small", alpha_0 <= Fraction(9, 16),
            proof("alpha-angle", times(HALF, "r-small"))),
        Line("zeta-most",   k.zeta_bar * (alpha_0 + 8) <= 4 * X, ToBeFound()),
        Line("zeta-small",  k.zeta_bar <= Fraction(1, 50), ToBeFound()),
        Line("eta-small",   k.eta_bar <= v / 30, ToBeFound()),
        Line("T-most",      T * v**2 <= Fraction(51, 100) * k.zeta_bar, ToBeFound()),
        Line("T-positive",  0 < T, ToBeFound()),
        Line("Theta-most",  Theta <= k.zeta_bar / 10, ToBeFound()),
        Line("x-small",     X <= Fraction(1, 384), ToBeFound()),
        Line("ratio-sign",  0 < ratio, ToBeFound()),
        Line("ratio-most",  ratio <= RATIO_MOST, proof("alpha-small", "x-small", using="ratio")),
        Line("V_1-room",    0 < k.V_1 - V_0, ToBeFound()),
        Line(of("d_slope-positive"), 0 < k.d_slope, ToBeFound()),
        Line("root-room",   0 < 1 - T * v**2, ToBeFound()),
    )  # fmt: skip


#: A bound of alpha_0 + X.
RATIO_MOST = Fraction(9, 16) + Fraction(1, 384)
#: In alpha_0 = (1+r) c/2 instead of c: what is left of X/2 after all that the ratio loses.
_LEFT = plus(
    times(Fraction(77, 200), "alpha-small"),
    times(Fraction(1, 20), "r-small"),
    Fraction(139, 640),
    times(Fraction(1, 20), PLUS_R, "T-positive", V, V),
)
_ROOM: Mapping[str, Reason] = {
    "angle-real": proof(hypothesis("angle-real")),
    "y-lower-room": proof(
        times(Fraction(1, 8), "zeta-most"),
        times(plus(1, "alpha-sign"), "T-most"),
        times(HALF, PLUS_R, "root-room", "Theta-most"),
        times(ZETA, _LEFT),
        using="alpha_0 ratio least_ratio",
        equations=(("alpha-of-m", as_term(1)),),
    ),
}


def _turning() -> Iterator[Line]:
    """How much the angle turns while -eta_c falls from eta_bar to 0."""
    zeta, part, first = k.zeta_bar, Fraction(51, 100), Fraction(12, 5)
    left_1 = first * (1 - RATIO_MOST) - 2 * part
    left_2 = HALF - part**2 / 50 - RATIO_MOST**2
    yield from (
        Line("slope",       equal(2 * v**2 * k.d_slope, zeta),
            identity(f"{k.d_slope.name} V_1.chart")),
        Line("turn_1-room", 2 * T * v**2 <= first * zeta * (1 - ratio),
            proof(times(2, "T-most"), times(ZETA, plus(times(first, "ratio-most"), left_1)))),
        Line("turn_2-room", k.d_slope * v**2 + T**2 * v**4 <= zeta * (1 - ratio**2),
            proof(times("T-most", plus(times("T-positive", V, V), times(part, ZETA))),
                  times(part**2, ZETA, "zeta-small"), times(left_2, ZETA),
                  times(ZETA, "ratio-most", plus("ratio-sign", RATIO_MOST)),
                  equations=(("slope", as_term(-HALF)),))),
        Line("turn_1-most", v * turn_1 <= first * zeta, proof("turn_1-room", using="turn_1")),
        Line("turn_2-most", v**2 * turn_2 <= zeta, proof("turn_2-room", using="turn_2")),
        Line("turn_3-most", v**3 * turn_3 <= zeta, ToBeFound()),
        Line("Theta-is",    equal(v * Theta, 3 * zeta * k.eta_bar), identity("Theta")),
    )  # fmt: skip
    both = Fraction(1, 30)
    turned = times(ETA, V, V, "turn_1-most"), times(ETA, ETA, V, "turn_2-most")
    left = plus(times(V, "eta-small"), times(V, V, Fraction(1, 10) - both - both**2),
                times("eta-small", plus(ETA, times(both, V))))  # fmt: skip
    yield from (
        Line("turned-most", ALL_TURNS <= Theta - SLACK,
            scaled(times(power(V, 3), "goal"), *turned, times(power(ETA, 3), "turn_3-most"),
                   times(ZETA, ETA, left))._replace(
                equations=(("Theta-is", as_term(5) / 6 * v**2),))),
    )  # fmt: skip
