"""The initial data `EQUATSS4.1DescrDoIniColla` as repaired, and why they are not empty."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from verify.language.argument import (
    ByEntry,
    ByInstance,
    ByLeast,
    BySum,
    Factor,
    Item,
    Line,
    plus,
    power,
    proof,
    times,
)
from verify.language.statement import Context, Given, Variable
from verify.language.terms import Claim, as_term, minimum, substitute_claim, symbol
from verify.language.vectors import Frame
from verify.paper.dynamics.carried import CAUCHY_SCHWARZ
from verify.paper.dynamics.model import PLANE, aligned
from verify.paper.dynamics.state import inequalities, tau_of
from verify.paper.step import numbers, state
from verify.paper.step.flight import SHIFT
from verify.paper.step.numbers import (
    V_0,
    V_1,
    Delta_theta,
    c,
    d_bar,
    d_const,
    d_slope,
    eta_bar,
    phi_minus,
    third,
    x_0,
)

CONTEXT = "initial"
DATA = "EQUATSS4.1DescrDoIniColla"
HALF = Fraction(1, 2)
NAMES = ("y", "eta_s", "C", "a", "b", "A", "B", "w", "d")

frame = Frame(*(symbol(f"{name}_start") for name in NAMES))
y, eta_s, C, a, b, A, B, w, d = frame
start = frame._asdict() | {"g": y, "clock": as_term(0)}

#: A point of the set, over the numbers of the theorem: inside it, none of the givens is sharp.
_y = eta_bar / 2
_least = minimum(d_const, d_slope * _y**2)
point_frame = aligned(_y, phi_minus * _y, c, (V_0 + V_1) / 2, (V_0 + V_1) / 2, _least / 2)
point = {f"{name}_start": value for name, value in point_frame._asdict().items()}
state_point = point_frame._asdict() | {"g": _y, "clock": as_term(0)}

GIVENS = {
    "start-Cnd1": 0 < y,
    "start-eta_bar": y <= eta_bar,
    "start-recedes": 0 < eta_s,
    "start-x-upper": eta_s - phi_minus * y <= x_0 * y,
    "start-x-lower": -(x_0 * y) <= eta_s - phi_minus * y,
    "start-d-positive": 0 < d,
    "start-d-const": d <= d_const,
    "start-d-slope": d <= d_slope * y**2,
    "start-A-above": V_0 + third <= A,
    "start-A-below": A <= V_1 - third,
    "start-B-above": V_0 + third <= B,
    "start-B-below": B <= V_1 - third,
    "start-C-upper": C - c <= Delta_theta / 4,
    "start-C-lower": c - C <= Delta_theta / 4,
}
#: Conditions of the recursion that are givens of the initial set under another name.
SAME = {"g-bound": "start-eta_bar"}


def context() -> Context:
    """The initial data, with the angle free in an interval and d > 0."""
    letters = {v.name: v for v in state.variables()}
    variables = tuple(
        Variable(f"{n}_start", f"{letters[n].letter} at n = 0", f"({letters[n].tex})_0")
        for n in NAMES
    )
    givens = tuple(Given(name, claim) for name, claim in GIVENS.items())
    return Context(CONTEXT, variables, givens, point, numbers.CONTEXT, "the initial data")


def premise(condition: str) -> str:
    """The fact that a condition of the recursion holds at the start."""
    return SAME.get(condition, f"start-{condition}")


def _at_start(condition: str, *addends: Factor) -> Line:
    claim = substitute_claim(state.carried.conditions[condition], start)
    says = "the condition holds for n = 0"
    return Line(f"start-{condition}", claim, proof(*addends), _LABELS.get(condition, DATA), says)


_LABELS = {
    "Cnd2": "EQUATSS4.1Recurrence_Cnd2",
    "Cnd3": "EQUATSS4.1Recurrence_Cnd3",
    "Cnd4": "EQUATSS4.1Recurrence_Cnd4",
    "A-upper": "EQUATSS4.1Recurrence_Cnd5",
    "A-lower": "EQUATSS4.1Recurrence_Cnd5",
    "B-upper": "EQUATSS4.1Recurrence_Cnd5",
    "B-lower": "EQUATSS4.1Recurrence_Cnd5",
    "Cnd8-upper": "EQUATSS4.1Recurrence_Cnd8",
    "Cnd8-lower": "EQUATSS4.1Recurrence_Cnd8",
    "Cnd9-upper": "EQUATSS4.1Recurrence_Cnd9",
    "Cnd9-lower": "EQUATSS4.1Recurrence_Cnd9",
}


def lines() -> Iterator[Item]:
    """The conditions of the recursion for n = 0."""
    yield from (
        _at_start("Cnd2"),
        _at_start("d-one", "start-d-const", "d_const-one"),
        _at_start("d-sum-positive", 1, "start-d-positive"),
        _at_start("d-share", "start-d-const", "d_const-share"),
        _at_start("d-small", "start-d-const", "d_const-small"),
        Line("start-A-one", A <= V_1,
             proof("start-A-below", times(Fraction(1, 3), "V_1-above-V_0"))),
        _at_start("A-positive", "start-A-above", "V_0-positive",
             times(Fraction(1, 3), "V_1-above-V_0")),
    )  # fmt: skip
    yield from _zeta()
    for name in ("A", "B"):
        shift = times(SHIFT, "start-eta_bar")
        yield _at_start(f"{name}-upper", times("decay-positive", f"start-{name}-below"), shift)
        yield _at_start(f"{name}-lower", times("decay-positive", f"start-{name}-above"), shift)
    yield from _angle()
    spread = times(HALF, "h_4-positive", "delta_x-positive", "start-Cnd1")
    for side in ("upper", "lower"):
        yield _at_start(f"Cnd9-{side}", f"start-x-{side}",
                        times("start-Cnd1", "x_0-entry-1"), spread)  # fmt: skip
    yield _at_start("clock-bound", times(2, "zeta_bar-positive", "start-eta_bar"))


def _zeta() -> Iterator[Item]:
    y2 = power("start-Cnd1", 2)
    d2 = power("start-d-sum-positive", 2)
    yield from (
        _at_start("Cnd4",
             times("start-A-positive", power("start-d-positive", 2),
                   plus(3, times(2, "start-d-positive"))),
             times(2, d2, "start-A-positive", "start-d-slope"),
             times(2, d2, "d_slope-positive", y2, "start-A-one"), times(d2, y2, "init-Cnd4")),
        _at_start("Cnd3", "start-Cnd4", times(d2, y2, "init-Cnd3")),
    )  # fmt: skip


def _angle() -> Iterator[Item]:
    slope = times("d_slope-positive", "start-eta_bar", plus("eta_bar-positive", "start-Cnd1"))
    yield Line("start-d_bar", d <= d_bar,
               ByLeast((proof("start-d-const"), proof("start-d-slope", slope)), "d_bar-least"),
               DATA, "d₀ ≤ d̄")  # fmt: skip
    for side in ("upper", "lower"):
        yield _at_start(f"Cnd8-{side}", times("decay-speed-positive", f"start-C-{side}"),
                        times("decay-speed-positive", "start-d_bar"),
                        times(14, "speed-positive", "start-eta_bar"))  # fmt: skip


# --- the point -----------------------------------------------------------------------------------


def inside_the_set() -> Iterator[Item]:
    """The givens at the point, none of them sharp: the set has an interior."""
    yield from _least_entries()
    for name, reason in _point_reasons().items():
        claim = substitute_claim(GIVENS[name], point)
        if claim.relation == "<=":
            strict = Claim("<", claim.lhs, claim.rhs)
            yield Line(f"inside-{name}", strict, reason, DATA, "inside the set, not at its edge")
        yield Line(f"at-{name}", claim, reason)
    yield from _vectors_exist()


def _least_entries() -> Iterator[Item]:
    slope = times(Fraction(1, 4), "d_slope-positive", power("eta_bar-positive", 2))
    yield Line("at-least", 0 < _least, ByLeast((proof("d_const-positive"), proof(slope))))
    for number, entry in enumerate(_least.children, 1):
        yield Line(f"at-least-{number}", _least <= entry, ByEntry())


def _point_reasons() -> dict[str, BySum]:
    spread = proof(times(HALF, "x_0-positive", "eta_bar-positive"))
    norm = proof(times(Fraction(1, 6), "V_1-above-V_0"))
    angle = proof(times(Fraction(1, 4), "Delta_theta-positive"))
    slope = times(Fraction(1, 8), "d_slope-positive", power("eta_bar-positive", 2))
    return {
        "start-Cnd1": proof(times(HALF, "eta_bar-positive")),
        "start-eta_bar": proof(times(HALF, "eta_bar-positive")),
        "start-recedes": proof(times(HALF, "phi-positive", "eta_bar-positive")),
        "start-x-upper": spread,
        "start-x-lower": spread,
        "start-d-positive": proof(times(HALF, "at-least")),
        "start-d-const": proof(times(HALF, "at-least-1"), times(HALF, "d_const-positive")),
        "start-d-slope": proof(times(HALF, "at-least-2"), slope),
        "start-A-above": norm,
        "start-A-below": norm,
        "start-B-above": norm,
        "start-B-below": norm,
        "start-C-upper": angle,
        "start-C-lower": angle,
    }


def _vectors_exist() -> Iterator[Item]:
    """Vectors with this angle, these normal components and these norms exist, already in the plane.

    The other inner products of the point may need dimension 4.
    """
    says = "there are unit vectors and velocities with these numbers"
    p, eta2 = point_frame, power("eta_bar-positive", 2)
    norm = times(Fraction(1, 6), "V_1-above-V_0")
    more = times(Fraction(3, 16), "alpha-positive", "alpha-positive", eta2)
    less = times(
        Fraction(1, 4), "phi-below-half", plus("phi-below-half", times(2, "phi-positive")), eta2
    )
    reason_c = proof("set-eta_c", times(Fraction(3, 4), eta2), norm)
    reason_s = proof("set-eta_s", less, more, norm)
    angle = proof(times("angle-real", plus(1, "angle-obtuse")))
    yield Line("at-angle", p.C**2 <= 1, angle, DATA, says, (CAUCHY_SCHWARZ,))
    yield Line("room-c", p.y**2 < p.A, reason_c, DATA, says, (CAUCHY_SCHWARZ,))
    yield Line("room-s", p.eta_s**2 < p.B, reason_s, DATA, says, (CAUCHY_SCHWARZ,))
    yield Line("at-room-c", p.y**2 <= p.A, reason_c)
    yield Line("at-room-s", p.eta_s**2 <= p.B, reason_s)


def instances() -> Iterator[Item]:
    """The conditions of the recursion, and Cauchy-Schwarz, at the point."""
    premises = tuple(f"at-{name}" for name in GIVENS)
    for name, claim in state.carried.conditions.items():
        fact = premise(name)
        if fact not in GIVENS:
            at_point = substitute_claim(claim, state_point)
            yield Line(f"at-{fact}", at_point, ByInstance(fact, point, premises))
    time = tau_of(point_frame)
    p = point_frame
    values = {"u_y": p.y, "u_s": p.eta_s, "u_C": p.C, "u_A": p.A, "u_B": p.B, "u_d": p.d}
    values["u_t"] = time
    for name, claim in inequalities(point_frame, time, state.PAIRS).items():
        reason = ByInstance(f"{PLANE}-{name}", values, ("at-angle", "at-room-c", "at-room-s"))
        yield Line(f"at-{name}", claim, reason)


def opening() -> tuple[str, ...]:
    """Why the givens of a state hold at the point."""
    carried = tuple(f"at-{premise(name)}" for name in state.carried.conditions)
    return carried + tuple(f"at-{name}" for name in state.PAIRS)
