"""The set `EQUATSS4.1DescrDoIniColla` as printed, but with room for the angle, and d > 0.

It is a statement about all parameters: the sharper theorem applies to each state of the set.
"""

from __future__ import annotations

from collections.abc import Iterator

from verify.language.argument import Item, Line, ToBeFound, plus, proof, row_of, times
from verify.language.statement import NEEDED, Applies, Cite, Context, Obligation, Statement
from verify.language.terms import symbol
from verify.paper.assumptions import STEP_ASSUMPTIONS
from verify.paper.dynamics.carried import START, start
from verify.paper.everywhere import chart
from verify.paper.initial_data import phi_minus
from verify.paper.parameters import PRINTED, THEOREM, V_0, c
from verify.paper.printed_set import numbers
from verify.paper.printed_set.numbers import SLACK, Theta, V, k, of
from verify.paper.sharper import state as sharper
from verify.paper.sharper.sharper import ASSUMPTIONS as CITED
from verify.paper.sharper.sharper import NAME as SHARPER
from verify.paper.step.initial import CONTEXT, DATA, InitialSet

SET = InitialSet(phi_minus, c, V_0, k.V_1, k.eta_bar, k.x_0, k.d_const, k.d_slope, SLACK)
GIVENS, point_frame, point = SET.givens, SET.frame, SET.point
#: What the sharper theorem asks of the state and the set says under another name.
SAME = {"start-Cnd2": "start-eta_bar", "start-d-small": "start-d-slope"}


def context() -> Context:
    """The states of the set, for given parameters."""
    return SET.context(chart.CONTEXT, "the set as printed")


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
    """The set has an interior."""
    yield from SET.inside(of(""), dict.fromkeys(GIVENS, ToBeFound()))
    yield from _vectors()


def _vectors() -> Iterator[Line]:
    """Vectors with this angle, these normal components and these norms exist, in the plane."""
    says = "there are unit vectors and velocities with these numbers"
    p, uses = point_frame, ("cauchy-schwarz",)
    angle = proof(times(chart.hypothesis("angle-real"), plus(1, chart.C)))
    yield Line("at-angle", p.C**2 <= 1, angle, DATA, says, uses)
    yield Line("room-c", p.y**2 < p.A, ToBeFound(), DATA, says, uses)
    yield Line("room-s", p.eta_s**2 < p.B, ToBeFound(), DATA, says, uses)


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


def rows() -> Iterator[Obligation]:
    """What is claimed of the numbers, of a point of the set, and of each state."""
    for line in (*numbers.room(), *numbers.conclusions(), *inside()):
        if line.says:
            yield row_of(line, PRINTED, chart.CONTEXT)
    at = dict(numbers.MEANING) | {name: symbol(name) for name in point}
    uses = tuple(assumption.name for assumption in ASSUMPTIONS)
    yield Obligation(COLLAPSE, PRINTED, THEOREM, NEEDED,
        "the sharper theorem applies to each state of the set: the particles collapse",
        Applies(f"{SHARPER}:{START}", at), uses, context=CONTEXT)  # fmt: skip


def statement(sharper: bytes, certificate: bytes) -> Statement:
    """The statement; it cites the sharper theorem, whose statement and certificate are given."""
    space = chart.context(numbers.k)
    space = space._replace(constants=(*space.constants, *numbers.CONSTANTS, *numbers.TURNED))
    cite = Cite(SHARPER, SHARPER, sharper, (), CITED, certificate)
    return Statement(NAME, TITLE, {}, (), (space, context()), tuple(rows()), ASSUMPTIONS, (cite,))
