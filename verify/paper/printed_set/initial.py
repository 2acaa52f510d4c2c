"""The set `EQUATSS4.1DescrDoIniColla` as printed, but with room for the angle, and d > 0."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from verify.language.argument import (
    ByEntry,
    ByLeast,
    Item,
    Line,
    Reason,
    ToBeFound,
    plus,
    power,
    proof,
    times,
)
from verify.language.statement import Context, Given, Variable
from verify.language.terms import Claim, minimum, substitute_claim
from verify.paper.dynamics.carried import start
from verify.paper.dynamics.model import aligned
from verify.paper.dynamics.state import LETTERS
from verify.paper.everywhere import chart
from verify.paper.parameters import V_0, c
from verify.paper.preliminaries import phi_minus
from verify.paper.printed_set import numbers
from verify.paper.printed_set.numbers import ETA, SLACK, Theta, V, k, of
from verify.paper.sharper import numbers as sharper
from verify.paper.step.initial import DATA

CONTEXT = "initial"
HALF = Fraction(1, 2)
third = (k.V_1 - V_0) / 3

GIVENS = {
    "start-Cnd1": 0 < start.y,
    "start-eta_bar": start.y <= k.eta_bar,
    "start-recedes": 0 < start.eta_s,
    "start-x-upper": start.eta_s - phi_minus * start.y <= k.x_0 * start.y,
    "start-x-lower": -(k.x_0 * start.y) <= start.eta_s - phi_minus * start.y,
    "start-d-positive": 0 < start.d,
    "start-d-const": start.d <= k.d_const,
    "start-d-slope": start.d <= k.d_slope * start.y**2,
    "start-A-above": V_0 + third <= start.A,
    "start-A-below": start.A <= k.V_1 - third,
    "start-B-above": V_0 + third <= start.B,
    "start-B-below": start.B <= k.V_1 - third,
    "start-C-upper": start.C - c <= SLACK,
    "start-C-lower": c - start.C <= SLACK,
}
#: What the sharper theorem asks of the state and the set says under another name.
SAME = {"start-Cnd2": "start-eta_bar", "start-d-small": "start-d-slope"}
#: A point inside the set.
_y = k.eta_bar / 2
_least = minimum(k.d_const, k.d_slope * _y**2)
point_frame = aligned(_y, phi_minus * _y, c, (V_0 + k.V_1) / 2, (V_0 + k.V_1) / 2, _least / 2)
point = {f"{name}_start": value for name, value in point_frame._asdict().items()}


def context() -> Context:
    """The states of the set, for given parameters."""
    variables = tuple(
        Variable(f"{name}_start", f"{letter} at n = 0", f"({tex})_0")
        for name, (letter, tex) in LETTERS.items()
        if f"{name}_start" in point
    )
    givens = tuple(Given(name, claim) for name, claim in GIVENS.items())
    return Context(CONTEXT, variables, givens, point, chart.CONTEXT, "the set as printed")


def lines() -> Iterator[Item]:
    """What the sharper theorem asks of a state, for every state of the set."""
    claims = numbers.entry()
    more = times("V_1-room", "V_1-room")
    reasons = {
        "start-ratio-upper": proof("start-x-upper", times("x-bound", "start-Cnd1")),
        "start-ratio-lower": proof("start-recedes"),
        "start-A-bound": proof(times(36, V, V, "start-A-below"), more, using="V_1.chart"),
        "start-B-bound": proof(times(36, V, V, "start-B-below"), more, using="V_1.chart"),
        "start-C-upper": proof("angle-upper", using="turn_1 turn_2 turn_3"),
        "start-C-lower": proof("angle-lower", using="turn_1 turn_2 turn_3"),
    }
    turned = sharper.total(k.eta_bar)
    for side, off in (("upper", start.C - c), ("lower", c - start.C)):
        known = proof(f"start-C-{side}", "turned-most")
        yield Line(f"angle-{side}", off + turned <= Theta, known)
    for name, reason in reasons.items():
        yield Line(f"entry-{name}", claims[name], reason)


def premise(name: str) -> str:
    """The fact that the state satisfies what the sharper theorem asks of it."""
    found = SAME.get(name, name)
    return found if GIVENS.get(found) == numbers.entry()[name] else f"entry-{name}"


def inside() -> Iterator[Line]:
    """The givens at the point, none of them sharp: the set has an interior."""
    slope = times(Fraction(1, 4), of("d_slope-positive"), power(ETA, 2))
    yield Line("at-least", 0 < _least, ByLeast((proof(of("d_const-positive")), proof(slope))))
    for number, entry in enumerate(_least.children, 1):
        yield Line(f"at-least-{number}", _least <= entry, ByEntry())
    for name, reason in _reasons().items():
        claim = substitute_claim(GIVENS[name], point)
        if claim.relation == "<=":
            strict = Claim("<", claim.lhs, claim.rhs)
            yield Line(f"inside-{name}", strict, reason, DATA, "inside the set, not at its edge")
        yield Line(f"at-{name}", claim, reason)
    yield from _vectors()


def _reasons() -> dict[str, Reason]:
    slope = times(Fraction(1, 8), of("d_slope-positive"), power(ETA, 2))
    found: dict[str, Reason] = dict.fromkeys(GIVENS, ToBeFound())
    return found | {
        "start-d-positive": proof(times(HALF, "at-least")),
        "start-d-const": proof(times(HALF, "at-least-1"), times(HALF, of("d_const-positive"))),
        "start-d-slope": proof(times(HALF, "at-least-2"), slope),
    }


def _vectors() -> Iterator[Line]:
    """Vectors with this angle, these normal components and these norms exist, in the plane."""
    says = "there are unit vectors and velocities with these numbers"
    p, uses = point_frame, ("cauchy-schwarz",)
    angle = proof(times(chart.hypothesis("angle-real"), plus(1, chart.C)))
    yield Line("at-angle", p.C**2 <= 1, angle, DATA, says, uses)
    yield Line("room-c", p.y**2 < p.A, ToBeFound(), DATA, says, uses)
    yield Line("room-s", p.eta_s**2 < p.B, ToBeFound(), DATA, says, uses)
