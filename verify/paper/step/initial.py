"""The initial data `EQUATSS4.1DescrDoIniColla` as repaired, and why they are not empty."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction

from verify.language.argument import (
    ByEntry,
    ByInstance,
    ByLeast,
    BySum,
    Factor,
    Item,
    Line,
    Reason,
    plus,
    power,
    proof,
    times,
)
from verify.language.record import Record
from verify.language.statement import Context, Given, Variable
from verify.language.terms import Claim, Term, minimum, substitute_claim
from verify.language.vectors import Frame
from verify.paper.dynamics.carried import CAUCHY_SCHWARZ, start
from verify.paper.dynamics.model import aligned, at_the_point
from verify.paper.dynamics.state import LETTERS, tau_of
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
    x_0,
)

CONTEXT = "initial"
DATA = "EQUATSS4.1DescrDoIniColla"
HALF = Fraction(1, 2)


class InitialSet(Record):
    """The set for some constants, with the angle free in an interval and d > 0."""

    phi_minus: Term
    c: Term
    V_0: Term
    V_1: Term
    eta_bar: Term
    x_0: Term
    d_const: Term
    d_slope: Term
    slack: Term

    @property
    def givens(self) -> dict[str, Claim]:
        """The inequalities of the set."""
        s, third = start, (self.V_1 - self.V_0) / 3
        return {
            "start-Cnd1": 0 < s.y,
            "start-eta_bar": s.y <= self.eta_bar,
            "start-recedes": 0 < s.eta_s,
            "start-x-upper": s.eta_s - self.phi_minus * s.y <= self.x_0 * s.y,
            "start-x-lower": -(self.x_0 * s.y) <= s.eta_s - self.phi_minus * s.y,
            "start-d-positive": 0 < s.d,
            "start-d-const": s.d <= self.d_const,
            "start-d-slope": s.d <= self.d_slope * s.y**2,
            "start-A-above": self.V_0 + third <= s.A,
            "start-A-below": s.A <= self.V_1 - third,
            "start-B-above": self.V_0 + third <= s.B,
            "start-B-below": s.B <= self.V_1 - third,
            "start-C-upper": s.C - self.c <= self.slack,
            "start-C-lower": self.c - s.C <= self.slack,
        }

    @property
    def least(self) -> Term:
        """The bound of d at the point."""
        return minimum(self.d_const, self.d_slope * (self.eta_bar / 2) ** 2)

    @property
    def frame(self) -> Frame:
        """A point inside the set, at which none of the givens is sharp."""
        y, speed = self.eta_bar / 2, (self.V_0 + self.V_1) / 2
        return aligned(y, self.phi_minus * y, self.c, speed, speed, self.least / 2)

    @property
    def point(self) -> dict[str, Term]:
        """The same, by the names of the set's variables."""
        return {f"{name}_start": value for name, value in self.frame._asdict().items()}

    def context(self, parent: str, says: str) -> Context:
        """The set, for given parameters."""
        variables = tuple(
            Variable(f"{name}_start", f"{letter} at n = 0", f"({tex})_0")
            for name, (letter, tex) in LETTERS.items()
        )
        givens = tuple(Given(name, claim) for name, claim in self.givens.items())
        return Context(CONTEXT, variables, givens, self.point, parent, says)

    def inside(self, prefix: str, reasons: Mapping[str, Reason]) -> Iterator[Line]:
        """The givens at the point, none of them sharp: the set has an interior.

        The names of the facts about its constants begin with ``prefix``.
        """
        const, eta2 = f"{prefix}d_const-positive", power(f"{prefix}eta_bar-positive", 2)
        quarter, eighth = (times(Fraction(1, n), f"{prefix}d_slope-positive", eta2) for n in (4, 8))
        branches = proof(const), proof(quarter)
        yield Line("at-least", 0 < self.least, ByLeast(branches))
        for number, entry in enumerate(self.least.children, 1):
            yield Line(f"at-least-{number}", self.least <= entry, ByEntry())
        known = {
            "start-d-positive": proof(times(HALF, "at-least")),
            "start-d-const": proof(times(HALF, "at-least-1"), times(HALF, const)),
            "start-d-slope": proof(times(HALF, "at-least-2"), eighth),
        }
        for name, given in self.givens.items():
            reason, claim = {**reasons, **known}[name], substitute_claim(given, self.point)
            if claim.relation == "<=":
                strict, says = Claim("<", claim.lhs, claim.rhs), "inside the set, not at its edge"
                yield Line(f"inside-{name}", strict, reason, DATA, says)
            yield Line(f"at-{name}", claim, reason)


SET = InitialSet(phi_minus, c, V_0, V_1, eta_bar, x_0, d_const, d_slope, Delta_theta / 4)
GIVENS = SET.givens
point_frame, point = SET.frame, SET.point
state_point = state.carried.begun(point_frame) | {"g": point_frame.y}
#: Conditions of the recursion that are givens of the initial set under another name.
SAME = {"g-bound": "start-eta_bar"}


def context() -> Context:
    """The initial data of the step."""
    return SET.context(numbers.CONTEXT, "the initial data")


def premise(condition: str) -> str:
    """The fact that a condition of the recursion holds at the start."""
    return SAME.get(condition, f"start-{condition}")


def _at_start(condition: str, *addends: Factor) -> Line:
    claim = state.carried.at(state.carried.begun())[condition]
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
        Line("start-A-one", start.A <= V_1,
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
    yield Line("start-d_bar", start.d <= d_bar,
               ByLeast((proof("start-d-const"), proof("start-d-slope", slope)), "d_bar-least"),
               DATA, "d₀ ≤ d̄")  # fmt: skip
    for side in ("upper", "lower"):
        yield _at_start(f"Cnd8-{side}", times("decay-speed-positive", f"start-C-{side}"),
                        times("decay-speed-positive", "start-d_bar"),
                        times(14, "speed-positive", "start-eta_bar"))  # fmt: skip


# --- the point -----------------------------------------------------------------------------------


def inside_the_set() -> Iterator[Item]:
    """The set has an interior, and there are vectors with the numbers of its point."""
    yield from SET.inside("", _point_reasons())
    yield from _vectors_exist()


def _point_reasons() -> dict[str, BySum]:
    spread = proof(times(HALF, "x_0-positive", "eta_bar-positive"))
    norm = proof(times(Fraction(1, 6), "V_1-above-V_0"))
    angle = proof(times(Fraction(1, 4), "Delta_theta-positive"))
    return {
        "start-Cnd1": proof(times(HALF, "eta_bar-positive")),
        "start-eta_bar": proof(times(HALF, "eta_bar-positive")),
        "start-recedes": proof(times(HALF, "phi-positive", "eta_bar-positive")),
        "start-x-upper": spread,
        "start-x-lower": spread,
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
    givens = ("at-angle", "at-room-c", "at-room-s")
    yield from at_the_point(point_frame, tau_of(point_frame), state.PAIRS, givens)


def opening() -> tuple[str, ...]:
    """Why the givens of a state hold at the point."""
    carried = tuple(f"at-{premise(name)}" for name in state.carried.conditions)
    return carried + tuple(f"at-{name}" for name in state.PAIRS)
