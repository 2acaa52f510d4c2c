"""The set `EQUATSS4.1DescrDoIniColla` as printed, but with room for the angle, and d > 0.

It is a statement about all parameters: the sharper theorem, `verify/paper/sharper.toml`, applies to
each state of the set. The set is the one of the step, `verify/paper/step.toml`, with the printed
constants.
"""

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
    row_of,
    times,
)
from verify.language.statement import (
    NEEDED,
    Applies,
    Cite,
    Context,
    Given,
    Obligation,
    Statement,
)
from verify.language.terms import Claim, minimum, substitute, substitute_claim, symbol
from verify.paper.assumptions import STEP_ASSUMPTIONS
from verify.paper.everywhere import chart
from verify.paper.initial_data import X_0, phi_minus
from verify.paper.parameters import PRINTED, THEOREM, V_0, c
from verify.paper.printed_set import numbers
from verify.paper.printed_set.numbers import ALL_TURNS, SLACK, Theta, V, k, of

#: The context of the initial data in the step, and that of the start in the sharper theorem.
CONTEXT, START = "initial", "start"

#: The constants that the step has as variables, here those of the printed set.
MEANING = {
    "phi_minus": phi_minus,
    "c": c,
    "V_0": V_0,
    "V_1": k.V_1,
    "eta_bar": k.eta_bar,
    "x_0": k.x_0,
    "d_const": k.d_const,
    "d_slope": k.d_slope,
}
C = symbol("C_start")
#: What the set says of the angle; only here is it another one than that of the step.
ANGLE = {"start-C-upper": C - c <= SLACK, "start-C-lower": c - C <= SLACK}
#: The bound of d at the point of the set.
LEAST = minimum(k.d_const, k.d_slope * (k.eta_bar / 2) ** 2)
#: What the sharper theorem asks of the state and the set says under another name.
SAME = {"start-Cnd2": "start-eta_bar", "start-d-small": "start-d-slope"}


def printed(initial: Context) -> Context:
    """The states of the set, for given parameters, from the initial data of the step."""
    claims = {n: substitute_claim(claim, MEANING) for n, claim in initial.claims.items()} | ANGLE
    return initial._replace(
        givens=tuple(Given(name, claim) for name, claim in claims.items()),
        point={name: substitute(value, MEANING) for name, value in initial.point.items()},
        parent=chart.CONTEXT,
        says="the set as printed",
    )


def lines(start: Context) -> Iterator[Item]:
    """What the sharper theorem asks of a state at its start, for every state of the set."""
    _, claims = numbers.asked(start)
    more = times("V_1-room", "V_1-room")
    reasons = {
        "start-ratio-upper": proof("start-x-upper", times("x-bound", "start-Cnd1")),
        "start-ratio-lower": proof("start-recedes"),
        "start-A-bound": proof(times(36, V, V, "start-A-below"), more, using="V_1.chart"),
        "start-B-bound": proof(times(36, V, V, "start-B-below"), more, using="V_1.chart"),
        "start-C-upper": proof("angle-upper", using="turn_1 turn_2 turn_3"),
        "start-C-lower": proof("angle-lower", using="turn_1 turn_2 turn_3"),
    }
    for side, off in (("upper", C - c), ("lower", c - C)):
        known = proof(f"start-C-{side}", "turned-most")
        yield Line(f"angle-{side}", off + ALL_TURNS <= Theta, known)
    for name, reason in reasons.items():
        yield Line(f"entry-{name}", claims[name], reason)


def premises(here: Context, start: Context) -> Iterator[str]:
    """The facts that the numbers and a state of the set satisfy what the sharper theorem asks."""
    room, state = numbers.asked(start)
    yield from (f"room-{name}" for name in room)
    known = here.claims
    for name, claim in state.items():
        found = SAME.get(name, name)
        yield found if known.get(found) == claim else f"entry-{name}"


def inside(here: Context) -> Iterator[Line]:
    """The set has an interior: at its point its givens hold, and none of them is sharp."""
    const, eta2 = of("d_const-positive"), power(of("eta_bar-positive"), 2)
    quarter, eighth = (times(Fraction(1, n), of("d_slope-positive"), eta2) for n in (4, 8))
    half = Fraction(1, 2)
    yield Line("at-least", 0 < LEAST, ByLeast((proof(const), proof(quarter))))
    for number, entry in enumerate(LEAST.children, 1):
        yield Line(f"at-least-{number}", LEAST <= entry, ByEntry())
    known: dict[str, Reason] = {
        "start-d-positive": proof(times(half, "at-least")),
        "start-d-const": proof(times(half, "at-least-1"), times(half, const)),
        "start-d-slope": proof(times(half, "at-least-2"), eighth),
    }
    for name, given in here.claims.items():
        reason, claim = known.get(name, ToBeFound()), substitute_claim(given, here.point)
        if claim.relation == "<=":
            strict, says = Claim("<", claim.lhs, claim.rhs), "inside the set, not at its edge"
            yield Line(f"inside-{name}", strict, reason, X_0, says)
        yield Line(f"at-{name}", claim, reason)
    yield from _vectors(here)


def _vectors(here: Context) -> Iterator[Line]:
    """Vectors with this angle, these normal components and these norms exist, in the plane."""
    says = "there are unit vectors and velocities with these numbers"
    p, uses = (
        {name.removesuffix("_start"): x for name, x in here.point.items()},
        ("cauchy-schwarz",),
    )
    angle = proof(times(chart.hypothesis("angle-real"), plus(1, chart.C)))
    yield Line("at-angle", p["C"] ** 2 <= 1, angle, X_0, says, uses)
    yield Line("room-c", p["y"] ** 2 < p["A"], ToBeFound(), X_0, says, uses)
    yield Line("room-s", p["eta_s"] ** 2 < p["B"], ToBeFound(), X_0, says, uses)


NAME = f"{THEOREM}, the set as printed"
TITLE = (
    "For all 0 < r < 1, V_0 > 0, delta_theta > 0 and all theta_0 with 0 < -cos theta_0 <= 1 that "
    "satisfy the stability condition: from every state of the set as printed with d_0 > 0 and "
    "eta_s > 0 the particles collapse, with -cos of the final angle within delta_theta of "
    "-cos theta_0; so also where -cos of the angle at the start is off by at most Theta/6, which "
    "is the room that an interior needs"
)
#: The row that the sharper theorem applies to each state of the set.
COLLAPSE = "collapse"
#: That the set has an interior is the step's glue, from rows of the same names.
ASSUMPTIONS = tuple(
    one
    for one in STEP_ASSUMPTIONS
    if one.name in ("cauchy-schwarz", "open-condition", "glue-interior")
)


def rows(here: Context, sharper: Statement) -> Iterator[Obligation]:
    """What is claimed of the numbers, of a point of the set, and of each state."""
    start = sharper.context(START)
    for line in (*numbers.room(start), *numbers.conclusions(), *inside(here)):
        if line.says:
            yield row_of(line, PRINTED, chart.CONTEXT)
    at = dict(numbers.MEANING) | {name: symbol(name) for name in here.point}
    uses = tuple(assumption.name for assumption in ASSUMPTIONS)
    yield Obligation(COLLAPSE, PRINTED, THEOREM, NEEDED,
        "the sharper theorem applies to each state of the set: the particles collapse",
        Applies(f"{sharper.theorem}:{START}", at), uses, context=CONTEXT)  # fmt: skip


def statement(initial: Context, sharper: Statement, cite: Cite) -> Statement:
    """The statement, from the initial data of the step and the sharper theorem, which it cites."""
    space, here = chart.context(numbers.k), printed(initial)
    turned = numbers.turned(sharper.context(START))
    space = space._replace(constants=(*space.constants, *numbers.CONSTANTS, *turned))
    claims = tuple(rows(here, sharper))
    return Statement(NAME, TITLE, {}, (), (space, here), claims, ASSUMPTIONS, (cite,))
